%
O0001
(rule: F 6.4 ROUND in a word rounds to its increment)
(expect: to X-1.235)
(expect: to X-3.581)
(expect: to X0)
#1=1.2345
#2=2.3456
S1000 M03
G91G01X-#1F100.
X-#2
X[ROUND[#1]+ROUND[#2]]
M30
%
