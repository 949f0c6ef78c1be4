"""
Docking: a chaser with panels and tanks comes from 3 m to hover 7 cm before the port of its target.

Source  An Hao, Qu Zhenshen, Wang Changhong, J. System Simulation 27(6), 2015, pp. 1227-1234.
"""

HERE = 'rvd_missions.docking'
