%
O0001
(rule: F 6.8 argument assignment I)
(expect: #100=1.5)
(expect: #101=2)
(expect: #102=3)
(expect: #103=4)
(expect: #104=5)
(expect: #105=6)
(expect: #106=7)
(expect: #107=8)
(expect: #108=9)
(expect: #109=11)
(expect: #110=13)
(expect: #111=17)
(expect: #112=18)
(expect: #113=19)
(expect: #114=20)
(expect: #115=21)
(expect: #116=22)
(expect: #117=23)
(expect: #118=24)
(expect: #119=25)
(expect: #120=26)
(expect: #121 vacant)
G65P9100A1.5B2.C3.I4.J5.K6.D7E8F9.H11M13Q17.R18.S19T20U21.V22.W23.X24.Y25.Z26.
M30
%
