%
O0001
(rule: F 6.3 F#1 and G#1 vacant)
(expect: to X5)
(expect: to X10)
(expect: to X11)
S1000 M03
G01 X5. F100.
G#1 X10. F#1
G91 X1.
M30
%
