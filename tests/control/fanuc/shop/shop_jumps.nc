%
O0116
(rule: F 6.4, 6.7: computed jumps, vacant in conditions, roundings, indirect variables)
(expect: #100=2)
(expect: #101=5)
(expect: #102=1)
(expect: #103=1)
(expect: #105=1)
(expect: #106=2)
(expect: #107=-1)
(expect: #108=10)
(expect: #109=11)
(expect: #110=4)
(expect: #111=1)
(expect: #112=77)
(expect: #113=2)
(expect: #104 vacant)
#1=2
GOTO[#1*10]
N10#100=1
GOTO90
N20#100=2
#2=90
IF[#1GT1]GOTO#2
#100=3
N90
IF[#1EQ2]THEN#101=5
#3=#0
IF[#3EQ#0]THEN#102=1
IF[#3LT1]THEN#103=1
#104=#3
#105=ROUND[1.4999]
#106=FUP[1.0001]
#107=FIX[-1.9]
#108=[[[[1+1]*2]+1]*2]
#109=1AND3XOR2OR8
#110=-#1+#1*3
IF[[#1EQ2]XOR[#1EQ3]]THEN#111=1
#[110+#1]=77
#113=#[#[111]+99]
M30
%
