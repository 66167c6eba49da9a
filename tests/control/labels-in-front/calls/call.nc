%
(rule: a label is found by the word behind its number, also where a call with the same first word stands in front of it)
(expect: #1=2)
(expect: #2=1)
O1 CALL
O2 CALL
O1 CALL
M30
O1 SUB (counts)
#1=[#1+1]
ENDSUB
O2 SUB
#2=[#2+1]
ENDSUB
%
