%
O00001
(rule: Haas macros: #1 to #33 are local, #100 to #199 common, #10000 to #10199 further ones)
(expect: #1=2)
(expect: #150=3)
(expect: #10050=4)
#1=2
#150=3
#10050=4
M30
%
