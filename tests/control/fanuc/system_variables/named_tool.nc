%
O0001
(rule: F 6.6 [#_OFSHG[n]], [#_OFSHW[n]], [#_OFSDG[n]], [#_OFSDW[n]])
(expect: #1=1)
(expect: #2=2)
(expect: #3=3)
(expect: #4=4)
[#_OFSHG[9]]=1
[#_OFSHW[9]]=2
[#_OFSDG[9]]=3
[#_OFSDW[9]]=4
#1=#11009
#2=#10009
#3=#13009
#4=#12009
M30
%
