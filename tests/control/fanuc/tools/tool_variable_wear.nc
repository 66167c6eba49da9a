%
O0001
(rule: F 6.5 memory C: 10000+N and 2000+N are the wear of the length)
(expect: #1=0.3)
(expect: #2=40.3)
#2207=40
#2007=.3
#1=#10007
G43H7G00Z0.
#2=#5023
M30
%
