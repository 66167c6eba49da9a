(rule: F 1.2 blanks count nowhere, inside keywords, operators and numbers of variables neither)
(expect: #101=3)
(expect: #102=0.5)
(expect: #103=7)
(expect: #104=2)
(expect: path X1.5)
#1 0 1=3
#1 02=SI N[3 0]
IF[#1 01 E Q 3]TH EN #103=7
WHI LE[#104 L T 2]D O 1
#104=#1 04+1
E ND 1
IF[#102 G T 1]GO TO 2 0
G 0 X1 . 5
GO TO 3 0
N 2 0 X9.
N 3 0 M 3 0
