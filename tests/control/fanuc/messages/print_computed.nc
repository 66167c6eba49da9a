%
O0001
(rule: F 6.10 a variable by a computed number)
(expect: print [V  3.5])
#105=3.5
#1=100
POPEN
DPRNT[V#[#1+5][21]]
PCLOS
M30
%
