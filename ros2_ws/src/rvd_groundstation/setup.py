"""Install rvd_groundstation with its executables where `ros2 run` looks for them."""

from setuptools import find_packages, setup

NAME = 'rvd_groundstation'
NODES = [
    'state_predictor',
    'auto_controller',
    'command_blender',
    'joystick_replay',
    'operator_model',
]

setup(
    name=NAME,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + NAME]),
        ('share/' + NAME, ['package.xml']),
    ],
    package_data={NAME: ['console/static/*', 'console/static/assets/*']},
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},         # by this `colcon test` knows to run pytest
    zip_safe=False,
    maintainer='The RVD ground loop maintainers',
    maintainer_email='maintainers@example.org',
    description='Ground segment: predictor, guidance laws, command sharing and pilots.',
    license='Apache-2.0',
    entry_points={'console_scripts': [
        *(f'{node} = rvd_dynamics.diagram.ros.main:main' for node in NODES),
        f'console = {NAME}.console.main:main',
        f'joystick = {NAME}.joystick.node:main']},
)
