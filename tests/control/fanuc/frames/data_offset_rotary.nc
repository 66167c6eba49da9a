%
O0001
(rule: F 3.4 a rotary axis has its offset too)
(expect: to C15)
(expect: #1=5)
G10L2P1C5.
G54G00C10.
#1=#5224
M30
%
