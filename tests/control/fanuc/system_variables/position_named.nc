%
O0001
(rule: F 6.6 names of system variables)
(expect: #1=7)
(expect: #2=8)
G00X7.
#1=[#_ABSIO[1]]
#2=[#_ABSMT[1]]+1
M30
%
