"""Install rvd_campaign with its executables where `ros2 run` looks for them."""

from setuptools import find_packages, setup

NAME = 'rvd_campaign'
NODES = []

setup(
    name=NAME,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + NAME]),
        ('share/' + NAME, ['package.xml']),
    ],
    package_data={NAME: ['report/templates/*']},
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},         # by this `colcon test` knows to run pytest
    zip_safe=False,
    maintainer='The RVD ground loop maintainers',
    maintainer_email='maintainers@example.org',
    description='The closed loop in one process, the one command, campaigns, figures and reports.',
    license='Apache-2.0',
    entry_points={'console_scripts': [f'{node} = {NAME}.nodes.{node}:main' for node in NODES]},
)
