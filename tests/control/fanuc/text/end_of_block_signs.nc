%
O0001;
(rule: F 2.1 EOB: the sign may stand behind every statement, END and GOTO among them)
(expect: #1=3)
(expect: #2=7)
(expect: #3=1)
(expect: #4=2)
(expect: print [ 1])
#1=0;
WHILE[#1LT3]DO1;
#1=#1+1;
END1;
DO2;
#3=1;
IF[#3EQ1]GOTO5;
(LOOP)END2;
N5;
IF[#3EQ1]THEN#2=7;
GOTO6;
#2=9;
N6(ON);
POPEN;
DPRNT[#3[10]];
PCLOS;
SETVN 500[WIDTH];
G65P2A2.;
M98P3;
M30;
O0002;
#100=#1;
M99;
O0003;
#4=#100;
M99;
%
