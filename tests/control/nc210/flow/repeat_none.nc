%
;rule: NC-210 12: a count of 0 makes no pass
;expect: E30=1
;expect: E31 unset
E30=1
(RPT,0)
E31=5
(ERP)
M30
