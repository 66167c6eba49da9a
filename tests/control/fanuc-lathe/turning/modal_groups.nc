%
O0001
(rule: F 2.3, 6.5: on a lathe single cycles are of group 01, drilling cycles of group 10, the stroke check of 09)
(expect: #100=0)
(expect: #101=22)
(expect: #102=90)
(expect: #103=22)
(expect: #104=80)
(expect: #105=92)
(expect: #106=1)
(expect: #107=83)
(expect: #108=22)
(expect: #109=80)
(expect: #110=23)
(expect: path X60Z2 X50 z-10f0.2 x60 Z2 X49 t1:z-9 t1.4142:x51z-10 X60 Z2 f1 X0Z5 Z3 z-2f0.1 Z3 Z-1 z-7 Z3 Z-6 z-12 Z3 Z-11 z-17 Z3 Z-16 z-20 Z5)
M3S500
G00X60.Z2.
#100=#4001
#101=#4009
G90X50.Z-10.F.2
#102=#4001
#103=#4009
#104=#4010
G92X49.Z-10.F1.
#105=#4001
G01X60.Z2.
#106=#4001
G00X0Z5.
G83Z-20.R-2.Q5000F.1
#107=#4010
#108=#4009
G80
#109=#4010
G23
#110=#4009
M30
%
