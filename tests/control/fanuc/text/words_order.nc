%
O0001
(rule: F 1.3 words in any order, zeros and signs as they come)
(expect: to X10 Y-0.5 line F300)
(expect: to X-0.5 Y10 line F300)
F0300.M03Y-.5X+010.G1S0100
X-.50Y10.
M30
%
