(rule: F 1.3 an address without a number behind it is PS0005, directly in front of the next word as well)
(expect: path X1)
(expect: alarm PS0005 K5003 at 6:4)
G0X1.;(a comment behind the end of the block)
(here X has none)
G0 XY1.
M30
