%
O0001
(rule: F 6.5 data input that corrects an offset by a touch does it, letter by letter as Kadr writes it or not)
(expect: #1=9)
(expect: #2=14)
(expect: path X10)
G90G94G54
G31X12.F100
G10 L2 P1 X[#[20*1+5201]+#5061-[3]]
#1=#5221
#100=2
G10 L2 P2 X[#[20*2+5201]+[#100+#5061]/2-[3]]
#2=#5241
G00X1.
M30
%
