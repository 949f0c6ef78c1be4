"""Install rvd_dynamics with its executables where `ros2 run` looks for them."""

from setuptools import find_packages, setup

NAME = 'rvd_dynamics'
NODES = [
    'spacecraft_dynamics',
    'relative_sensor',
    'link_emulator',
    'onboard_guard',
    'mission_monitor',
    'bag_recorder',
    'markers',
    'block_group',
]

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
    description='World, link and shared mathematics of the teleoperated docking ground loop.',
    license='Apache-2.0',
    entry_points={'console_scripts': [f'{node} = {NAME}.diagram.ros.main:main' for node in NODES]},
)
