"""Draws the contact at the top of the README: pressure, tractions, stick and slip, frictional power.

    draw_contact.py PICTURE.png
"""
import sys

import wrc

contact = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK").contact()
contact.planar_step(wrc.PlanarInput(pose={"lateral": 2e-3}, load={"normal_force": 80e3}, friction={"coefficient": 0.35},
                                   creepage={"longitudinal": 0.6e-3, "lateral": 0.4e-3, "spin": 0.3, "speed": 40.0}))
wrc.plot.contact(contact, sys.argv[1])
