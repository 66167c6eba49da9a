%
(rule: a call inside of a section is no label of the search either)
(expect: #1=1)
(expect: #2=2)
O1 CALL
O2 CALL
M30
O1 SUB
#1=[#1+1]
O2 CALL
ENDSUB
O2 SUB
#2=[#2+1]
ENDSUB
%
