%
;rule: NC-210 15: G21 begins a contour in the geometric language, which Kadr refuses by name
;expect: alarm  K5018 at 4:1
G21
M30
