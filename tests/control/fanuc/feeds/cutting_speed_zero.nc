%
O0001
(rule: F 3.2 G96 without S: PS1541)
(expect: alarm PS1541 K5215 at 5:1)
G96M03
M30
%
