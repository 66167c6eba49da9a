%
O0001
(rule: F 11 PS0114, PS1125: nothing behind =)
(expect: alarm PS0114 K5401 at 5:4)
#1=
M30
%
