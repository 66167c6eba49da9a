%
O0001
(rule: F 6.8 modal codes stay as the subprogram left them)
(expect: #100=91)
M98P2
#100=#4003
M30
O0002
G91
M99
%
