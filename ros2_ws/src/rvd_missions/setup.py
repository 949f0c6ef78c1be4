"""Install rvd_missions, whose entry points are the missions that can be flown."""

from setuptools import find_packages, setup

NAME = 'rvd_missions'
MISSIONS = ['lunar_approach', 'attitude_hold', 'obstacle_field', 'elliptic_rendezvous',
            'docking', 'tether', 'tether_delay']
BLOCKS = ['attitude_dynamics', 'attitude_sensors', 'attitude_controller', 'docking_dynamics',
          'inertial_unit', 'camera', 'vision', 'docking_navigation', 'docking_controller',
          'gripper_dynamics', 'gripper_sensors', 'gripper_tracker', 'mission_control',
          'docking_telemetry', 'hand_predictor', 'hand_pilot', 'hand_uplink',
          'closing_planner', 'standard_messages', 'flight_director']

setup(
    name=NAME,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + NAME]),
        ('share/' + NAME, ['package.xml']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},         # by this `colcon test` knows to run pytest
    zip_safe=False,
    maintainer='The RVD ground loop maintainers',
    maintainer_email='maintainers@example.org',
    description='The missions: diagrams, judges, figures and displays.',
    license='Apache-2.0',
    entry_points={
        'rvd.missions': [f'{name} = {NAME}.{name}:MISSION' for name in MISSIONS],
        'console_scripts': [f'{block} = rvd_dynamics.diagram.ros.main:main' for block in BLOCKS]},
)
