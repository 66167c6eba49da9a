%
O0001
(rule: F 6.6 an input of the machine of which nobody has told the value: 0, and told)
(expect: warning K5950 at 6:5)
(expect: #1=0)
#1=[#_UI[5]]
M30
%
