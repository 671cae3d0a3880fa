rows=[("whole 12","film, all of the gas","6e-3","0.02"),("band 12","film, `gas band;`","6e-3","0.02"),("whole 1.2","film, all of the gas","6e-4","0.02"),("band 1.2","film, `gas band;`","6e-4","0.02"),
("default 12","film, default background pressure","6e-3","0.8"),("default 1.2","film, default background pressure","6e-4","0.8"),("tenth 12","film","6e-3","0.08"),("tenth 1.2","film","6e-4","0.08"),("hundredth 12","film","6e-3","0.01"),("hundredth 1.2","film","6e-4","0.01"),
("plates 12","plates, sound speed 0.5 m/s","6e-3","0"),("plates 1.2","plates, sound speed 0.5 m/s","6e-4","0"),("platesStiff 12","plates, 5 m/s","6e-3","0"),("platesStiff 1.2","plates, 5 m/s","6e-4","0"),("platesPressed 12","plates, 5 m/s","6e-3","0.8"),("platesPressed 1.2","plates, 5 m/s","6e-4","0.8")]
def l(r,f): return '[0](results.csv "%s: %s")'%(r,f)
t="| | wall stress [gamma/dx] | p_b [gamma/dx] | mean velocity over the exact | first, second half of the time | worst row | gas over the film's surface | processor time |\n|---|---|---|---|---|---|---|---|\n"
for r,n,s,p in rows:
    t+="| %s | %s | %s | %s | %s, %s | %s %% | %s | %s s |\n"%(n,s,p,l(r,"mean velocity"),l(r,"first half of the time"),l(r,"second half of the time"),l(r,"worst row"),"" if "plates" in r else l(r,"gas"),l(r,"processor time"))
c="| gas | thickness over the theory's, at 4 ms | at 8 ms | share of the thickness that is left | by the theory | thinning over the theory's | processor time |\n|---|---|---|---|---|---|---|\n"
for r,n in (("cylinder whole","all"),("cylinder band","band")):
    c+="| %s | %s | %s | %s | %s | %s | %s s |\n"%(n,l(r,"thickness at half of the time"),l(r,"thickness at the end"),l(r,"share of the thickness that is left"),l(r,"share by the theory"),l(r,"thinning at the end"),l(r,"processor time"))
open("README.md","w").write(open("README.tmpl").read().replace("@FILM@",t.rstrip()).replace("@CYL@",c.rstrip()))
