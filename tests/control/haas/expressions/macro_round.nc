%
O00001
(rule: Haas ROUND: whole numbers in expressions, the increment inside a word)
(expect: #100=2)
(expect: to X1.235)
#100=ROUND[1.5]
G00 X[ROUND[1.2346]]
M30
%
