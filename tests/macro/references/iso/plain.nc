( The core has no language: nothing is declared, nothing leads anywhere)
N10 G1 X10 F100
(^ is: )
N20 X20
M30
