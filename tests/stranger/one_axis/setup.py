"""Install one_axis: its mission as an entry point, its blocks as executables."""

from setuptools import setup

NAME = 'one_axis'
BLOCKS = ['plant', 'sensor', 'controller']

setup(
    name=NAME,
    version='0.1.0',
    packages=[NAME],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + NAME]),
        ('share/' + NAME, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=False,
    entry_points={
        'rvd.missions': [f'one_axis = {NAME}:MISSION'],
        'console_scripts': [f'{block} = rvd_dynamics.diagram.ros.main:main' for block in BLOCKS],
    },
)
