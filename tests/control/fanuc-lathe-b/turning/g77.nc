%
O0001
(rule: F 2.3, 5.5 T-B: G77 is the single cycle along, G90 and G91 say what X and Z are)
(expect: path X50Z2 X46 z-18f0.2 x50 Z2 X42 z-18 x50 Z2 X40 z-15 x50 Z2)
G90 G95 G97 S500 M03
G00 X50. Z2.
G91
G77 X-4. Z-20. F0.2
X-8.
G90 X40. Z-15.
M30
%
