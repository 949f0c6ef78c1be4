const om="uplot",am="u-hz",lm="u-vt",cm="u-title",um="u-wrap",hm="u-under",fm="u-over",dm="u-axis",As="u-off",pm="u-select",mm="u-cursor-x",gm="u-cursor-y",_m="u-cursor-pt",vm="u-legend",xm="u-live",Mm="u-inline",Sm="u-series",ym="u-marker",Wu="u-label",Em="u-value",Zr="width",Jr="height";const Xu="bottom",Zs="left",qa="right",kc="#000",$u=kc+"0",Ya="mousemove",qu="mousedown",Ka="mouseup",Yu="mouseenter",Ku="mouseleave",ju="dblclick",bm="resize",Tm="scroll",Zu="change",fa="dppxchange",Bc="--",Pr=typeof window<"u",Fl=Pr?document:null,pr=Pr?window:null,wm=Pr?navigator:null;let Se,yo;function Ol(){let i=devicePixelRatio;Se!=i&&(Se=i,yo&&Bl(Zu,yo,Ol),yo=matchMedia(`(min-resolution: ${Se-.001}dppx) and (max-resolution: ${Se+.001}dppx)`),Us(Zu,yo,Ol),pr.dispatchEvent(new CustomEvent(fa)))}function Bn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function kl(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Fe(i,t,e){i.style[t]=e+"px"}function ci(i,t,e,n){let s=Fl.createElement(i);return t!=null&&Bn(s,t),e?.insertBefore(s,n),s}function qn(i,t){return ci("div",i,t)}const Ju=new WeakMap;function Ei(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Ju.get(i);r!=o&&(i.style.transform=r,Ju.set(i,r),t<0||e<0||t>n||e>s?Bn(i,As):kl(i,As))}const Qu=new WeakMap;function th(i,t,e){let n=t+e,s=Qu.get(i);n!=s&&(Qu.set(i,n),i.style.background=t,i.style.borderColor=e)}const eh=new WeakMap;function nh(i,t,e,n){let s=t+""+e,r=eh.get(i);s!=r&&(eh.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}const zc={passive:!0},Am={...zc,capture:!0};function Us(i,t,e,n){t.addEventListener(i,e,n?Am:zc)}function Bl(i,t,e,n){t.removeEventListener(i,e,zc)}Pr&&Ol();function ui(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:Hn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function nd(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}const id=i=>i!=null,sd=i=>i!=null&&i>0,Sa=nd(id),Rm=nd(sd);function Cm(i,t,e,n=0,s=!1){let r=s?Rm:Sa,o=s?sd:id;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Re,l??-Re]}function ya(i,t,e,n){let s=rh(i),r=rh(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Hi:rd,a=s==1?Hn:Yn,l=r==1?Yn:Hn,c=a(o(Ze(i))),h=l(o(Ze(t))),u=xr(e,c),f=xr(e,h);return e==10&&(c<0&&(u=Ce(u,-c)),h<0&&(f=Ce(f,-h))),n||e==2?(i=u*s,t=f*r):(i=cd(i,u),t=Ea(t,f)),[i,t]}function Hc(i,t,e,n){let s=ya(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}const Vc=.1,ih={mode:3,pad:Vc},no={pad:0,soft:null,mode:0},Pm={min:no,max:no};function da(i,t,e,n){return ba(e)?sh(i,t,e):(no.pad=e,no.soft=n?0:null,no.mode=n?3:0,sh(i,t,Pm))}function ve(i,t){return i??t}function Lm(i,t,e){for(t=ve(t,0),e=ve(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function sh(i,t,e){let n=e.min,s=e.max,r=ve(n.pad,0),o=ve(s.pad,0),a=ve(n.hard,-Re),l=ve(s.hard,Re),c=ve(n.soft,Re),h=ve(s.soft,-Re),u=ve(n.mode,0),f=ve(s.mode,0),p=t-i,_=Hi(p),v=bn(Ze(i),Ze(t)),m=Hi(v),d=Ze(m-_);(p<1e-24||d>10)&&(p=0,(i==0||t==0)&&(p=1e-24,u==2&&c!=Re&&(r=0),f==2&&h!=-Re&&(o=0)));let E=p||v||1e3,w=Hi(E),x=xr(10,Hn(w)),I=E*(p==0?i==0?.1:1:r),R=Ce(cd(i-I,x/10),24),D=i>=c&&(u==1||u==3&&R<=c||u==2&&R>=c)?c:Re,U=bn(a,R<D&&i>=D?D:hi(D,R)),T=E*(p==0?t==0?.1:1:o),S=Ce(Ea(t+T,x/10),24),C=t<=h&&(f==1||f==3&&S>=h||f==2&&S<=h)?h:-Re,H=hi(l,S>C&&t<=C?C:bn(C,S));return U==H&&U==0&&(H=100),[U,H]}const Dm=new Intl.NumberFormat(Pr?wm.language:"en-US"),Gc=i=>Dm.format(i),Vn=Math,na=Vn.PI,Ze=Vn.abs,Hn=Vn.floor,je=Vn.round,Yn=Vn.ceil,hi=Vn.min,bn=Vn.max,xr=Vn.pow,rh=Vn.sign,Hi=Vn.log10,rd=Vn.log2,Um=(i,t=1)=>Vn.sinh(i)*t,ja=(i,t=1)=>Vn.asinh(i/t),Re=1/0;function oh(i){return(Hi((i^i>>31)-(i>>31))|0)+1}function zl(i,t,e){return hi(bn(i,t),e)}function od(i){return typeof i=="function"}function ae(i){return od(i)?i:()=>i}const Im=()=>{},ad=i=>i,ld=(i,t)=>t,Nm=i=>null,ah=i=>!0,lh=(i,t)=>i==t,Fm=/\.\d*?(?=9{6,}|0{6,})/gm,Is=i=>{if(hd(i)||as.has(i))return i;const t=`${i}`,e=t.match(Fm);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Is(s)}e${r}`}return Ce(i,n)};function Es(i,t){return Is(Ce(Is(i/t))*t)}function Ea(i,t){return Is(Yn(Is(i/t))*t)}function cd(i,t){return Is(Hn(Is(i/t))*t)}function Ce(i,t=0){if(hd(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return je(n)/e}const as=new Map;function ud(i){return((""+i).split(".")[1]||"").length}function ro(i,t,e,n){let s=[],r=n.map(ud);for(let o=t;o<e;o++){let a=Ze(o),l=Ce(xr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Ce(h,u);s.push(f),as.set(f,u)}}return s}const io={},Wc=[],Mr=[null,null],ns=Array.isArray,hd=Number.isInteger,Om=i=>i===void 0;function ch(i){return typeof i=="string"}function ba(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function km(i){return i!=null&&typeof i=="object"}const Bm=Object.getPrototypeOf(Uint8Array),fd="__proto__";function Sr(i,t=ba){let e;if(ns(i)){let n=i.find(s=>s!=null);if(ns(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Sr(i[s],t)}else e=i.slice()}else if(i instanceof Bm)e=i.slice();else if(t(i)){e={};for(let n in i)n!=fd&&(e[n]=Sr(i[n],t))}else e=i;return e}function qe(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=fd&&(ba(i[s])?qe(i[s],Sr(n[s])):i[s]=Sr(n[s]))}return i}const zm=0,Hm=1,Vm=2;function Gm(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Wm(i,t){if(qm(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Ym(o[0])||(o=$m(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:Hm,p=[];for(let _=0;_<h.length;_++){let v=h[_],m=r.get(l[_]);v===null?f!=zm&&(u[m]=v,f==Vm&&p.push(m)):u[m]=v}Gm(u,p,s),n.push(u)}}return n}const Xm=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function $m(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function qm(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Ym(i,t=100){const e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const r=bn(1,Hn((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){const l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const dd=["January","February","March","April","May","June","July","August","September","October","November","December"],pd=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function md(i){return i.slice(0,3)}const Km=pd.map(md),jm=dd.map(md),Zm={MMMM:dd,MMM:jm,WWWW:pd,WWW:Km};function Gr(i){return(i<10?"0":"")+i}function Jm(i){return(i<10?"00":i<100?"0":"")+i}const Qm={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Gr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Gr(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Gr(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Gr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Gr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Jm(i.getMilliseconds())};function Xc(i,t){t=t||Zm;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Qm[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const tg=new Intl.DateTimeFormat().resolvedOptions().timeZone;function eg(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==tg?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}const gd=i=>i%1==0,pa=[1,2,2.5,5],ng=ro(10,-32,0,pa),_d=ro(10,0,32,pa),ig=_d.filter(gd),bs=ng.concat(_d),$c=`
`,vd="{YYYY}",uh=$c+vd,xd="{M}/{D}",Qr=$c+xd,Eo=Qr+"/{YY}",Md="{aa}",sg="{h}:{mm}",fr=sg+Md,hh=$c+fr,fh=":{ss}",Ee=null;function Sd(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?ro(10,0,3,pa).filter(gd):ro(10,-3,0,pa)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,vd,Ee,Ee,Ee,Ee,Ee,Ee,1],[s*28,"{MMM}",uh,Ee,Ee,Ee,Ee,Ee,1],[s,xd,uh,Ee,Ee,Ee,Ee,Ee,1],[n,"{h}"+Md,Eo,Ee,Qr,Ee,Ee,Ee,1],[e,fr,Eo,Ee,Qr,Ee,Ee,Ee,1],[t,fh,Eo+" "+fr,Ee,Qr+" "+fr,Ee,hh,Ee,1],[i,fh+".{fff}",Eo+" "+fr,Ee,Qr+" "+fr,Ee,hh,Ee,1]];function h(u){return(f,p,_,v,m,d)=>{let E=[],w=m>=o,x=m>=r&&m<o,I=u(_),R=Ce(I*i,3),D=Za(I.getFullYear(),w?0:I.getMonth(),x||w?1:I.getDate()),U=Ce(D*i,3);if(x||w){let T=x?m/r:0,S=w?m/o:0,C=R==U?R:Ce(Za(D.getFullYear()+S,D.getMonth()+T,1)*i,3),H=new Date(je(C/i)),N=H.getFullYear(),V=H.getMonth();for(let j=0;C<=v;j++){let K=Za(N+S*j,V+T*j,1),J=K-u(Ce(K*i,3));C=Ce((+K+J)*i,3),C<=v&&E.push(C)}}else{let T=m>=s?s:m,S=Hn(_)-Hn(R),C=U+S+Ea(R-U,T);E.push(C);let H=u(C),N=H.getHours()+H.getMinutes()/e+H.getSeconds()/n,V=m/n,j=f.axes[p]._space,K=d/j;for(;C=Ce(C+m,i==1?0:3),!(C>v);)if(V>1){let J=Hn(Ce(N+V,6))%24,ct=u(C).getHours()-J;ct>1&&(ct=-1),C-=ct*n,N=(N+V)%24;let mt=E[E.length-1];Ce((C-mt)/m,3)*K>=.7&&E.push(C)}else E.push(C)}return E}}return[l,c,h]}const[rg,og,ag]=Sd(1),[lg,cg,ug]=Sd(.001);ro(2,-53,53,[1]);function dh(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function ph(i,t){return(e,n,s,r,o)=>{let a=t.find(_=>o>=_[0])||t[t.length-1],l,c,h,u,f,p;return n.map(_=>{let v=i(_),m=v.getFullYear(),d=v.getMonth(),E=v.getDate(),w=v.getHours(),x=v.getMinutes(),I=v.getSeconds(),R=m!=l&&a[2]||d!=c&&a[3]||E!=h&&a[4]||w!=u&&a[5]||x!=f&&a[6]||I!=p&&a[7]||a[1];return l=m,c=d,h=E,u=w,f=x,p=I,R(v)})}}function hg(i,t){let e=Xc(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Za(i,t,e){return new Date(i,t,e)}function mh(i,t){return t(i)}const fg="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function gh(i,t){return(e,n,s,r)=>r==null?Bc:t(i(n))}function dg(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function pg(i,t){return i.series[t].fill(i,t)}const mg={show:!0,live:!0,isolate:!1,mount:Im,markers:{show:!0,width:2,stroke:dg,fill:pg,dash:"solid"},idx:null,idxs:null,values:[]};function gg(i,t){let e=i.cursor.points,n=qn(),s=e.size(i,t);Fe(n,Zr,s),Fe(n,Jr,s);let r=s/-2;Fe(n,"marginLeft",r),Fe(n,"marginTop",r);let o=e.width(i,t,s);return o&&Fe(n,"borderWidth",o),n}function _g(i,t){let e=i.series[t].points;return e._fill||e._stroke}function vg(i,t){let e=i.series[t].points;return e._stroke||e._fill}function xg(i,t){return i.series[t].points.size}const Ja=[0,0];function Mg(i,t,e){return Ja[0]=t,Ja[1]=e,Ja}function bo(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Qa(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}const Sg={show:!0,x:!0,y:!0,lock:!1,move:Mg,points:{one:!1,show:gg,size:xg,width:0,stroke:vg,fill:_g},bind:{mousedown:bo,mouseup:bo,click:bo,dblclick:bo,mousemove:Qa,mouseleave:Qa,mouseenter:Qa},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},yd={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},qc=qe({},yd,{filter:ld}),Ed=qe({},qc,{size:10}),bd=qe({},yd,{show:!1}),Yc='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Td="bold "+Yc,wd=1.5,_h={show:!0,scale:"x",stroke:kc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Td,side:2,grid:qc,ticks:Ed,border:bd,font:Yc,lineGap:wd,rotate:0},yg="Value",Eg="Time",vh={show:!0,scale:"x",auto:!1,sorted:1,min:Re,max:-Re,idxs:[]};function bg(i,t,e,n,s){return t.map(r=>r==null?"":Gc(r))}function Tg(i,t,e,n,s,r,o){let a=[],l=as.get(s)||0;e=o?e:Ce(Ea(e,s),l);for(let c=e;c<=n;c=Ce(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Hl(i,t,e,n,s,r,o){const a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Hi:rd,h=Hn(c(e));s=xr(l,h),l==10&&(s=bs[ui(s,bs)]);let u=e,f=s*l;l==10&&(f=bs[ui(f,bs)]);do a.push(u),u=u+s,l==10&&!as.has(u)&&(u=Ce(u,as.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=bs[ui(f,bs)]));while(u<=n);return a}function wg(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Hl(i,t,bn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Hl(i,t,bn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}const Ad=/./,Ag=/[12357]/,Rg=/[125]/,xh=/1/,Vl=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Cg(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Ad:l(7,o)-h>=c?Ag:l(5,o)-h>=c?Rg:xh;if(u==xh){let f=Ze(l(1,o)-h);if(f<c)return Vl(t.slice().reverse(),a.distr,u,Yn(c/f)).reverse()}return Vl(t,a.distr,u,1)}function Pg(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Ze(l(1,o)-l(2,o));return c<a?Vl(t.slice().reverse(),3,Ad,Yn(a/c)).reverse():t}function Lg(i,t,e,n){return n==null?Bc:t==null?"":Gc(t)}const Mh={show:!0,scale:"y",stroke:kc,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Td,side:3,grid:qc,ticks:Ed,border:bd,font:Yc,lineGap:wd,rotate:0};function Dg(i,t){let e=3+(i||1)*2;return Ce(e*t,3)}function Ug(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Ze(o-r),l=i.series[t],c=a/(l.points.space*Se);return n[1]-n[0]<=c}const Sh={scale:null,auto:!0,sorted:0,min:Re,max:-Re},Rd=(i,t,e,n,s)=>s,yh={show:!0,auto:!0,sorted:0,gaps:Rd,alpha:1,facets:[qe({},Sh,{scale:"x"}),qe({},Sh,{scale:"y"})]},Eh={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Rd,alpha:1,points:{show:Ug,filter:null},values:null,min:Re,max:-Re,idxs:[],path:null,clip:null};function Ig(i,t,e,n,s){return e/10}const Cd={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Ng=qe({},Cd,{time:!1,ori:1}),bh={};function Pd(i,t){let e=bh[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(bh[i]=e)),e}const yr=1,Gl=2;function Os(i,t,e){const n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox;let l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,_=a.width,v=a.height,m=i.valToPosH,d=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,d,f,p,_,v,wa,Lr,Ra,Dd,Id):e(s,l,c,h,u,d,m,p,f,v,_,Aa,Dr,Zc,Ud,Nd)}function Kc(i,t){let e=0,n=0,s=ve(i.bands,Wc);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Fg(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Vi(i,t,e,n,s,r){return Os(i,t,(o,a,l,c,h,u,f,p,_,v,m)=>{let d=o.pxRound;const E=c.dir*(c.ori==0?1:-1),w=c.ori==0?Lr:Dr;let x,I;E==1?(x=e,I=n):(x=n,I=e);let R=d(u(a[x],c,v,p)),D=d(f(l[x],h,m,_)),U=d(u(a[I],c,v,p)),T=d(f(r==1?h.max:h.min,h,m,_)),S=new Path2D(s);return w(S,U,T),w(S,R,T),w(S,R,D),S})}function Ta(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;const a=t==0?Ra:Zc;let l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,n,p,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Og(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function jc(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let p=r(i[u]),_=f==u?p:r(i[f]),v=u-s;p=o<=0&&v>=0&&v<l?r(i[v]):p;let d=f+s;_=o>=0&&d>=0&&d<l?r(i[d]):_,_>=p&&a.push([p,_])}return a}function Th(i){return i==0?ad:i==1?je:t=>Es(t,i)}function Ld(i){let t=i==0?wa:Aa,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=hi(c,a/2,l/2),h=hi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}const wa=(i,t,e)=>{i.moveTo(t,e)},Aa=(i,t,e)=>{i.moveTo(e,t)},Lr=(i,t,e)=>{i.lineTo(t,e)},Dr=(i,t,e)=>{i.lineTo(e,t)},Ra=Ld(0),Zc=Ld(1),Dd=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Ud=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Id=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Nd=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function Fd(i){return(t,e,n,s,r)=>Os(t,e,(o,a,l,c,h,u,f,p,_,v,m)=>{let{pxRound:d,points:E}=o,w,x;c.ori==0?(w=wa,x=Dd):(w=Aa,x=Ud);const I=Ce(E.width*Se,3);let R=(E.size-E.width)/2*Se,D=Ce(R*2,3),U=new Path2D,T=new Path2D,{left:S,top:C,width:H,height:N}=t.bbox;Ra(T,S-D,C-D,H+D*2,N+D*2);const V=j=>{if(l[j]!=null){let K=d(u(a[j],c,v,p)),J=d(f(l[j],h,m,_));w(U,K+R,J),x(U,K,J,R,0,na*2)}};if(r)r.forEach(V);else for(let j=n;j<=s;j++)V(j);return{stroke:I>0?U:null,fill:U,clip:T,flags:yr|Gl}})}function Od(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}const kg=Od(Lr),Bg=Od(Dr);function kd(i){const t=ve(i?.alignGaps,0);return(e,n,s,r)=>Os(e,n,(o,a,l,c,h,u,f,p,_,v,m)=>{[s,r]=Sa(l,s,r);let d=o.pxRound,E=N=>d(u(N,c,v,p)),w=N=>d(f(N,h,m,_)),x,I;c.ori==0?(x=Lr,I=kg):(x=Dr,I=Bg);const R=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:yr},U=D.stroke;let T=!1;if(r-s>=v*4){let N=pt=>e.posToVal(pt,c.key,!0),V=null,j=null,K,J,Q,ht=E(a[R==1?s:r]),ct=E(a[s]),mt=E(a[r]),Mt=N(R==1?ct+1:mt-1);for(let pt=R==1?s:r;pt>=s&&pt<=r;pt+=R){let nt=a[pt],gt=(R==1?nt<Mt:nt>Mt)?ht:E(nt),ot=l[pt];gt==ht?ot!=null?(J=ot,V==null?(x(U,gt,w(J)),K=V=j=J):J<V?V=J:J>j&&(j=J)):ot===null&&(T=!0):(V!=null&&I(U,ht,w(V),w(j),w(K),w(J)),ot!=null?(J=ot,x(U,gt,w(J)),V=j=K=J):(V=j=null,ot===null&&(T=!0)),ht=gt,Mt=N(ht+R))}V!=null&&V!=j&&Q!=ht&&I(U,ht,w(V),w(j),w(K),w(J))}else for(let N=R==1?s:r;N>=s&&N<=r;N+=R){let V=l[N];V===null?T=!0:V!=null&&x(U,E(a[N]),w(V))}let[C,H]=Kc(e,n);if(o.fill!=null||C!=0){let N=D.fill=new Path2D(U),V=o.fillTo(e,n,o.min,o.max,C),j=w(V),K=E(a[s]),J=E(a[r]);R==-1&&([J,K]=[K,J]),x(N,J,j),x(N,K,j)}if(!o.spanGaps){let N=[];T&&N.push(...jc(a,l,s,r,R,E,t)),D.gaps=N=o.gaps(e,n,s,r,N),D.clip=Ta(N,c.ori,p,_,v,m)}return H!=0&&(D.band=H==2?[Vi(e,n,s,r,U,-1),Vi(e,n,s,r,U,1)]:Vi(e,n,s,r,U,H)),D})}function zg(i){const t=ve(i.align,1),e=ve(i.ascDesc,!1),n=ve(i.alignGaps,0),s=ve(i.extend,!1);return(r,o,a,l)=>Os(r,o,(c,h,u,f,p,_,v,m,d,E,w)=>{[a,l]=Sa(u,a,l);let x=c.pxRound,{left:I,width:R}=r.bbox,D=ct=>x(_(ct,f,E,m)),U=ct=>x(v(ct,p,w,d)),T=f.ori==0?Lr:Dr;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:yr},C=S.stroke,H=f.dir*(f.ori==0?1:-1);let N=U(u[H==1?a:l]),V=D(h[H==1?a:l]),j=V,K=V;s&&t==-1&&(K=I,T(C,K,N)),T(C,V,N);for(let ct=H==1?a:l;ct>=a&&ct<=l;ct+=H){let mt=u[ct];if(mt==null)continue;let Mt=D(h[ct]),pt=U(mt);t==1?T(C,Mt,N):T(C,j,pt),T(C,Mt,pt),N=pt,j=Mt}let J=j;s&&t==1&&(J=I+R,T(C,J,N));let[Q,ht]=Kc(r,o);if(c.fill!=null||Q!=0){let ct=S.fill=new Path2D(C),mt=c.fillTo(r,o,c.min,c.max,Q),Mt=U(mt);T(ct,J,Mt),T(ct,K,Mt)}if(!c.spanGaps){let ct=[];ct.push(...jc(h,u,a,l,H,D,n));let mt=c.width*Se/2,Mt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(nt=>{nt[0]+=Mt,nt[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=Ta(ct,f.ori,m,d,E,w)}return ht!=0&&(S.band=ht==2?[Vi(r,o,a,l,C,-1),Vi(r,o,a,l,C,1)]:Vi(r,o,a,l,C,ht)),S})}function wh(i,t,e,n,s,r,o=Re){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=Ze(i[l]-i[a]);h<c&&(c=h,o=Ze(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function Hg(i){i=i||io;const t=ve(i.size,[.6,Re,1]),e=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=ae(s),o=1-t[0],a=ve(t[1],Re),l=ve(t[2],1),c=ve(i.disp,io),h=ve(i.each,p=>{}),{fill:u,stroke:f}=c;return(p,_,v,m)=>Os(p,_,(d,E,w,x,I,R,D,U,T,S,C)=>{let H=d.pxRound,N=e,V=n*Se,j=a*Se,K=l*Se,J,Q;x.ori==0?[J,Q]=r(p,_):[Q,J]=r(p,_);const ht=x.dir*(x.ori==0?1:-1);let ct=x.ori==0?Ra:Zc,mt=x.ori==0?h:(W,tt,St,_t,Tt,Kt,ft)=>{h(W,tt,St,Tt,_t,ft,Kt)},Mt=ve(p.bands,Wc).find(W=>W.series[0]==_),pt=Mt!=null?Mt.dir:0,nt=d.fillTo(p,_,d.min,d.max,pt),at=H(D(nt,I,C,T)),gt,ot,Bt,Ht=S,It=H(d.width*Se),ce=!1,jt=null,ue=null,B=null,Ye=null;u!=null&&(It==0||f!=null)&&(ce=!0,jt=u.values(p,_,v,m),ue=new Map,new Set(jt).forEach(W=>{W!=null&&ue.set(W,new Path2D)}),It>0&&(B=f.values(p,_,v,m),Ye=new Map,new Set(B).forEach(W=>{W!=null&&Ye.set(W,new Path2D)})));let{x0:Jt,size:ee}=c;if(Jt!=null&&ee!=null){N=1,E=Jt.values(p,_,v,m),Jt.unit==2&&(E=E.map(St=>p.posToVal(U+St*S,x.key,!0)));let W=ee.values(p,_,v,m);ee.unit==2?ot=W[0]*S:ot=R(W[0],x,S,U)-R(0,x,S,U),Ht=wh(E,w,R,x,S,U,Ht),Bt=Ht-ot+V}else Ht=wh(E,w,R,x,S,U,Ht),Bt=Ht*o+V,ot=Ht-Bt;Bt<1&&(Bt=0),It>=ot/2&&(It=0),Bt<5&&(H=ad);let Vt=Bt>0,de=Ht-Bt-(Vt?It:0);ot=H(zl(de,K,j)),gt=(N==0?ot/2:N==ht?0:ot)-N*ht*((N==0?V/2:0)+(Vt?It/2:0));const Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=ce?null:new Path2D;let y=null;if(Mt!=null)y=p.data[Mt.series[1]];else{let{y0:W,y1:tt}=c;W!=null&&tt!=null&&(w=tt.values(p,_,v,m),y=W.values(p,_,v,m))}let Y=J*ot,Z=Q*ot;for(let W=ht==1?v:m;W>=v&&W<=m;W+=ht){let tt=w[W];if(tt==null)continue;if(y!=null){let Ot=y[W]??0;if(tt-Ot==0)continue;at=D(Ot,I,C,T)}let St=x.distr!=2||c!=null?E[W]:W,_t=R(St,x,S,U),Tt=D(ve(tt,nt),I,C,T),Kt=H(_t-gt),ft=H(bn(Tt,at)),vt=H(hi(Tt,at)),Nt=ft-vt;if(tt!=null){let Ot=tt<0?Z:Y,Et=tt<0?Y:Z;ce?(It>0&&B[W]!=null&&ct(Ye.get(B[W]),Kt,vt+Hn(It/2),ot,bn(0,Nt-It),Ot,Et),jt[W]!=null&&ct(ue.get(jt[W]),Kt,vt+Hn(It/2),ot,bn(0,Nt-It),Ot,Et)):ct(P,Kt,vt+Hn(It/2),ot,bn(0,Nt-It),Ot,Et),mt(p,_,W,Kt-It/2,vt,ot+It,Nt)}}return It>0?Pt.stroke=ce?Ye:P:ce||(Pt._fill=d.width==0?d._fill:d._stroke??d._fill,Pt.width=0),Pt.fill=ce?ue:P,Pt})}function Vg(i,t){const e=ve(t?.alignGaps,0);return(n,s,r,o)=>Os(n,s,(a,l,c,h,u,f,p,_,v,m,d)=>{[r,o]=Sa(c,r,o);let E=a.pxRound,w=J=>E(f(J,h,m,_)),x=J=>E(p(J,u,d,v)),I,R,D;h.ori==0?(I=wa,D=Lr,R=Id):(I=Aa,D=Dr,R=Nd);const U=h.dir*(h.ori==0?1:-1);let T=w(l[U==1?r:o]),S=T,C=[],H=[];for(let J=U==1?r:o;J>=r&&J<=o;J+=U)if(c[J]!=null){let ht=l[J],ct=w(ht);C.push(S=ct),H.push(x(c[J]))}const N={stroke:i(C,H,I,D,R,E),fill:null,clip:null,band:null,gaps:null,flags:yr},V=N.stroke;let[j,K]=Kc(n,s);if(a.fill!=null||j!=0){let J=N.fill=new Path2D(V),Q=a.fillTo(n,s,a.min,a.max,j),ht=x(Q);D(J,S,ht),D(J,T,ht)}if(!a.spanGaps){let J=[];J.push(...jc(l,c,r,o,U,w,e)),N.gaps=J=a.gaps(n,s,r,o,J),N.clip=Ta(J,h.ori,_,v,m,d)}return K!=0&&(N.band=K==2?[Vi(n,s,r,o,V,-1),Vi(n,s,r,o,V,1)]:Vi(n,s,r,o,V,K)),N})}function Gg(i){return Vg(Wg,i)}function Wg(i,t,e,n,s,r){const o=i.length;if(o<2)return null;const a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}const Wl=new Set;function Ah(){for(let i of Wl)i.syncRect(!0)}Pr&&(Us(bm,pr,Ah),Us(Tm,pr,Ah,!0),Us(fa,pr,()=>{_n.pxRatio=Se}));const Xg=kd(),$g=Fd();function Rh(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Xl(r,o,t,e))}function qg(i,t){return i.map((e,n)=>n==0?{}:qe({},t,e))}function Xl(i,t,e,n){return qe({},t==0?e:n,i)}function Bd(i,t,e){return t==null?Mr:[t,e]}const Yg=Bd;function Kg(i,t,e){return t==null?Mr:da(t,e,Vc,!0)}function zd(i,t,e,n){return t==null?Mr:ya(t,e,i.scales[n].log,!1)}const jg=zd;function Hd(i,t,e,n){return t==null?Mr:Hc(t,e,i.scales[n].log,!1)}const Zg=Hd;function Jg(i,t,e,n,s){let r=bn(oh(i),oh(t)),o=t-i,a=ui(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?as.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ch(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=je((e=+s)*Se))+"px"),[i,t,e]}function Qg(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ce(t[2]*Se,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function _n(i,t,e){const n={mode:ve(i.mode,1)},s=n.mode;function r(g,M,A,L){let F=M.valToPct(g);return L+A*(M.dir==-1?1-F:F)}function o(g,M,A,L){let F=M.valToPct(g);return L+A*(M.dir==-1?F:1-F)}function a(g,M,A,L){return M.ori==0?r(g,M,A,L):o(g,M,A,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;const c=n.root=qn(om);if(i.id!=null&&(c.id=i.id),Bn(c,i.class),i.title){let g=qn(cm,c);g.textContent=i.title}const h=ci("canvas"),u=n.ctx=h.getContext("2d"),f=qn(um,c);Us("click",f,g=>{g.target===_&&(De!=$s||Be!=qs)&&hn.click(n,g)},!0);const p=n.under=qn(hm,f);f.appendChild(h);const _=n.over=qn(fm,f);i=Sr(i);const v=+ve(i.pxAlign,1),m=Th(v);(i.plugins||[]).forEach(g=>{g.opts&&(i=g.opts(n,i)||i)});const d=i.ms||.001,E=n.series=s==1?Rh(i.series||[],vh,Eh,!1):qg(i.series||[null],yh),w=n.axes=Rh(i.axes||[],_h,Mh,!0),x=n.scales={},I=n.bands=i.bands||[];I.forEach(g=>{g.fill=ae(g.fill||null),g.dir=ve(g.dir,-1)});const R=s==2?E[1].facets[0].scale:E[0].scale,D={axes:Xp,series:Gn},U=(i.drawOrder||["axes","series"]).map(g=>D[g]);function T(g){const M=g.distr==3?A=>Hi(A>0?A:g.clamp(n,A,g.min,g.max,g.key)):g.distr==4?A=>ja(A,g.asinh):g.distr==100?A=>g.fwd(A):A=>A;return A=>{let L=M(A),{_min:F,_max:q}=g,st=q-F;return(L-F)/st}}function S(g){let M=x[g];if(M==null){let A=(i.scales||io)[g]||io;if(A.from!=null){S(A.from);let L=qe({},x[A.from],A,{key:g});L.valToPct=T(L),x[g]=L}else{M=x[g]=qe({},g==R?Cd:Ng,A),M.key=g;let L=M.time,F=M.range,q=ns(F);if((g!=R||s==2&&!L)&&(q&&(F[0]==null||F[1]==null)&&(F={min:F[0]==null?ih:{mode:1,hard:F[0],soft:F[0]},max:F[1]==null?ih:{mode:1,hard:F[1],soft:F[1]}},q=!1),!q&&ba(F))){let st=F;F=(lt,dt,Rt)=>dt==null?Mr:da(dt,Rt,st)}M.range=ae(F||(L?Yg:g==R?M.distr==3?jg:M.distr==4?Zg:Bd:M.distr==3?zd:M.distr==4?Hd:Kg)),M.auto=ae(q?!1:M.auto),M.clamp=ae(M.clamp||Ig),M._min=M._max=null,M.valToPct=T(M)}}}S("x"),S("y"),s==1&&E.forEach(g=>{S(g.scale)}),w.forEach(g=>{S(g.scale)});for(let g in i.scales)S(g);const C=x[R],H=C.distr;let N,V;C.ori==0?(Bn(c,am),N=r,V=o):(Bn(c,lm),N=o,V=r);const j={};for(let g in x){let M=x[g];(M.min!=null||M.max!=null)&&(j[g]={min:M.min,max:M.max},M.min=M.max=null)}const K=i.tzDate||(g=>new Date(je(g/d))),J=i.fmtDate||Xc,Q=d==1?ag(K):ug(K),ht=ph(K,dh(d==1?og:cg,J)),ct=gh(K,mh(fg,J)),mt=[],Mt=n.legend=qe({},mg,i.legend),pt=n.cursor=qe({},Sg,{drag:{y:s==2}},i.cursor),nt=Mt.show,at=pt.show,gt=Mt.markers;Mt.idxs=mt,gt.width=ae(gt.width),gt.dash=ae(gt.dash),gt.stroke=ae(gt.stroke),gt.fill=ae(gt.fill);let ot,Bt,Ht,It=[],ce=[],jt,ue=!1,B={};if(Mt.live){const g=E[1]?E[1].values:null;ue=g!=null,jt=ue?g(n,1,0):{_:0};for(let M in jt)B[M]=Bc}if(nt)if(ot=ci("table",vm,c),Ht=ci("tbody",null,ot),Mt.mount(n,ot),ue){Bt=ci("thead",null,ot,Ht);let g=ci("tr",null,Bt);ci("th",null,g);for(var Ye in jt)ci("th",Wu,g).textContent=Ye}else Bn(ot,Mm),Mt.live&&Bn(ot,xm);const Jt={show:!0},ee={show:!1};function Vt(g,M){if(M==0&&(ue||!Mt.live||s==2))return Mr;let A=[],L=ci("tr",Sm,Ht,Ht.childNodes[M]);Bn(L,g.class),g.show||Bn(L,As);let F=ci("th",null,L);if(gt.show){let lt=qn(ym,F);if(M>0){let dt=gt.width(n,M);dt&&(lt.style.border=dt+"px "+gt.dash(n,M)+" "+gt.stroke(n,M)),lt.style.background=gt.fill(n,M)}}let q=qn(Wu,F);g.label instanceof HTMLElement?q.appendChild(g.label):q.textContent=g.label,M>0&&(gt.show||(q.style.color=g.width>0?gt.stroke(n,M):gt.fill(n,M)),Pt("click",F,lt=>{if(pt._lock)return;Ke(lt);let dt=E.indexOf(g);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Rt=E.some((Ct,Lt)=>Lt>0&&Lt!=dt&&Ct.show);E.forEach((Ct,Lt)=>{Lt>0&&xi(Lt,Rt?Lt==dt?Jt:ee:Jt,!0,Xe.setSeries)})}else xi(dt,{show:!g.show},!0,Xe.setSeries)},!1),Ai&&Pt(Yu,F,lt=>{pt._lock||(Ke(lt),xi(E.indexOf(g),Ks,!0,Xe.setSeries))},!1));for(var st in jt){let lt=ci("td",Em,L);lt.textContent="--",A.push(lt)}return[L,A]}const de=new Map;function Pt(g,M,A,L=!0){const F=de.get(M)||{},q=pt.bind[g](n,M,A,L);q&&(Us(g,M,F[g]=q),de.set(M,F))}function P(g,M,A){const L=de.get(M)||{};for(let F in L)(g==null||F==g)&&(Bl(F,M,L[F]),delete L[F]);g==null&&de.delete(M)}let y=0,Y=0,Z=0,W=0,tt=0,St=0,_t=tt,Tt=St,Kt=Z,ft=W,vt=0,Nt=0,Ot=0,Et=0;n.bbox={};let ie=!1,qt=!1,pe=!1,k=!1,xt=!1,et=!1;function rt(g,M,A){(A||g!=n.width||M!=n.height)&&wt(g,M),Vs(!1),pe=!0,qt=!0,Gs()}function wt(g,M){n.width=y=Z=g,n.height=Y=W=M,tt=St=0,nn(),xe();let A=n.bbox;vt=A.left=Es(tt*Se,.5),Nt=A.top=Es(St*Se,.5),Ot=A.width=Es(Z*Se,.5),Et=A.height=Es(W*Se,.5)}const At=3;function Zt(){let g=!1,M=0;for(;!g;){M++;let A=Gp(M),L=Wp(M);g=M==At||A&&L,g||(wt(n.width,n.height),qt=!0)}}function Oe({width:g,height:M}){rt(g,M)}n.setSize=Oe;function nn(){let g=!1,M=!1,A=!1,L=!1;w.forEach((F,q)=>{if(F.show&&F._show){let{side:st,_size:lt}=F,dt=st%2,Rt=F.label!=null?F.labelSize:0,Ct=lt+Rt;Ct>0&&(dt?(Z-=Ct,st==3?(tt+=Ct,L=!0):A=!0):(W-=Ct,st==0?(St+=Ct,g=!0):M=!0))}}),gi[0]=g,gi[1]=A,gi[2]=M,gi[3]=L,Z-=b[1]+b[3],tt+=b[3],W-=b[2]+b[0],St+=b[0]}function xe(){let g=tt+Z,M=St+W,A=tt,L=St;function F(q,st){switch(q){case 1:return g+=st,g-st;case 2:return M+=st,M-st;case 3:return A-=st,A+st;case 0:return L-=st,L+st}}w.forEach((q,st)=>{if(q.show&&q._show){let lt=q.side;q._pos=F(lt,q._size),q.label!=null&&(q._lpos=F(lt,q.labelSize))}})}if(pt.dataIdx==null){let g=pt.hover,M=g.skip=new Set(g.skip??[]);M.add(void 0);let A=g.prox=ae(g.prox),L=g.bias??=0;pt.dataIdx=(F,q,st,lt)=>{if(q==0)return st;let dt=st,Rt=A(F,q,st,lt)??Re,Ct=Rt>=0&&Rt<Re,Lt=C.ori==0?Z:W,Yt=pt.left,Me=t[0],_e=t[q];if(M.has(_e[st])){dt=null;let se=null,Wt=null,zt;if(L==0||L==-1)for(zt=st;se==null&&zt-- >0;)M.has(_e[zt])||(se=zt);if(L==0||L==1)for(zt=st;Wt==null&&zt++<_e.length;)M.has(_e[zt])||(Wt=zt);if(se!=null||Wt!=null)if(Ct){let Ie=se==null?-1/0:N(Me[se],C,Lt,0),Ve=Wt==null?1/0:N(Me[Wt],C,Lt,0),ln=Yt-Ie,Te=Ve-Yt;ln<=Te?ln<=Rt&&(dt=se):Te<=Rt&&(dt=Wt)}else dt=Wt==null?se:se==null?Wt:st-se<=Wt-st?se:Wt}else Ct&&Ze(Yt-N(Me[st],C,Lt,0))>Rt&&(dt=null);return dt}}const Ke=g=>{pt.event=g};pt.idxs=mt,pt._lock=!1;let Pe=pt.points;Pe.show=ae(Pe.show),Pe.size=ae(Pe.size),Pe.stroke=ae(Pe.stroke),Pe.width=ae(Pe.width),Pe.fill=ae(Pe.fill);const Un=n.focus=qe({},i.focus||{alpha:.3},pt.focus),Ai=Un.prox>=0,wn=Ai&&Pe.one;let dn=[],Ri=[],Ci=[];function hs(g,M){let A=Pe.show(n,M);if(A instanceof HTMLElement)return Bn(A,_m),Bn(A,g.class),Ei(A,-10,-10,Z,W),_.insertBefore(A,dn[M]),A}function Or(g,M){if(s==1||M>0){let A=s==1&&x[g.scale].time,L=g.value;g.value=A?ch(L)?gh(K,mh(L,J)):L||ct:L||Lg,g.label=g.label||(A?Eg:yg)}if(wn||M>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Xg||Nm,g.fillTo=ae(g.fillTo||Fg),g.pxAlign=+ve(g.pxAlign,v),g.pxRound=Th(g.pxAlign),g.stroke=ae(g.stroke||null),g.fill=ae(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let A=Dg(bn(1,g.width),1),L=g.points=qe({},{size:A,width:bn(1,A*.2),stroke:g.stroke,space:A*2,paths:$g,_stroke:null,_fill:null},g.points);L.show=ae(L.show),L.filter=ae(L.filter),L.fill=ae(L.fill),L.stroke=ae(L.stroke),L.paths=ae(L.paths),L.pxAlign=g.pxAlign}if(nt){let A=Vt(g,M);It.splice(M,0,A[0]),ce.splice(M,0,A[1]),Mt.values.push(null)}if(at){mt.splice(M,0,null);let A=null;wn?M==0&&(A=hs(g,M)):M>0&&(A=hs(g,M)),dn.splice(M,0,A),Ri.splice(M,0,0),Ci.splice(M,0,0)}an("addSeries",M)}function zs(g,M){M=M??E.length,g=s==1?Xl(g,M,vh,Eh):Xl(g,M,{},yh),E.splice(M,0,g),Or(E[M],M)}n.addSeries=zs;function mo(g){if(E.splice(g,1),nt){Mt.values.splice(g,1),ce.splice(g,1);let M=It.splice(g,1)[0];P(null,M.firstChild),M.remove()}at&&(mt.splice(g,1),dn.splice(g,1)[0].remove(),Ri.splice(g,1),Ci.splice(g,1)),an("delSeries",g)}n.delSeries=mo;const gi=[!1,!1,!1,!1];function Na(g,M){if(g._show=g.show,g.show){let A=g.side%2,L=x[g.scale];L==null&&(g.scale=A?E[1].scale:R,L=x[g.scale]);let F=L.time;g.size=ae(g.size),g.space=ae(g.space),g.rotate=ae(g.rotate),ns(g.incrs)&&g.incrs.forEach(st=>{!as.has(st)&&as.set(st,ud(st))}),g.incrs=ae(g.incrs||(L.distr==2?ig:F?d==1?rg:lg:bs)),g.splits=ae(g.splits||(F&&L.distr==1?Q:L.distr==3?Hl:L.distr==4?wg:Tg)),g.stroke=ae(g.stroke),g.grid.stroke=ae(g.grid.stroke),g.ticks.stroke=ae(g.ticks.stroke),g.border.stroke=ae(g.border.stroke);let q=g.values;g.values=ns(q)&&!ns(q[0])?ae(q):F?ns(q)?ph(K,dh(q,J)):ch(q)?hg(K,q):q||ht:q||bg,g.filter=ae(g.filter||(L.distr>=3&&L.log==10?Cg:L.distr==3&&L.log==2?Pg:ld)),g.font=Ch(g.font),g.labelFont=Ch(g.labelFont),g._size=g.size(n,null,M,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(gi[M]=!0,g._el=qn(dm,f))}}function fs(g,M,A,L){let[F,q,st,lt]=A,dt=M%2,Rt=0;return dt==0&&(lt||q)&&(Rt=M==0&&!F||M==2&&!st?je(_h.size/3):0),dt==1&&(F||st)&&(Rt=M==1&&!q||M==3&&!lt?je(Mh.size/2):0),Rt}const go=n.padding=(i.padding||[fs,fs,fs,fs]).map(g=>ae(ve(g,fs))),b=n._padding=go.map((g,M)=>g(n,M,gi,0));let O,X=null,$=null;const z=s==1?E[0].idxs:null;let ut=null,yt=!1;function Ft(g,M){if(t=g??[],n.data=n._data=t,s==2){O=0;for(let A=1;A<E.length;A++)O+=t[A][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ut=t[0],O=ut.length;let A=t;if(H==2){A=t.slice();let L=A[0]=Array(O);for(let F=0;F<O;F++)L[F]=F}n._data=t=A}if(Vs(!0),an("setData"),H==2&&(pe=!0),M!==!1){let A=C;A.auto(n,yt)?Dt():qi(R,A.min,A.max),k=k||pt.left>=0,et=!0,Gs()}}n.setData=Ft;function Dt(){yt=!0;let g,M;s==1&&(O>0?(X=z[0]=0,$=z[1]=O-1,g=t[0][X],M=t[0][$],H==2?(g=X,M=$):g==M&&(H==3?[g,M]=ya(g,g,C.log,!1):H==4?[g,M]=Hc(g,g,C.log,!1):C.time?M=g+je(86400/d):[g,M]=da(g,M,Vc,!0))):(X=z[0]=g=null,$=z[1]=M=null)),qi(R,g,M)}let Gt,Xt,Ut,oe,ye,be,sn,he,kt,ke;function me(g,M,A,L,F,q){g??=$u,A??=Wc,L??="butt",F??=$u,q??="round",g!=Gt&&(u.strokeStyle=Gt=g),F!=Xt&&(u.fillStyle=Xt=F),M!=Ut&&(u.lineWidth=Ut=M),q!=ye&&(u.lineJoin=ye=q),L!=be&&(u.lineCap=be=L),A!=oe&&u.setLineDash(oe=A)}function An(g,M,A,L){M!=Xt&&(u.fillStyle=Xt=M),g!=sn&&(u.font=sn=g),A!=he&&(u.textAlign=he=A),L!=kt&&(u.textBaseline=kt=L)}function _i(g,M,A,L,F=0){if(L.length>0&&g.auto(n,yt)&&(M==null||M.min==null)){let q=ve(X,0),st=ve($,L.length-1),lt=A.min==null?Cm(L,q,st,F,g.distr==3):[A.min,A.max];g.min=hi(g.min,A.min=lt[0]),g.max=bn(g.max,A.max=lt[1])}}const pn={min:null,max:null};function ds(){for(let L in x){let F=x[L];j[L]==null&&(F.min==null||j[R]!=null&&F.auto(n,yt))&&(j[L]=pn)}for(let L in x){let F=x[L];j[L]==null&&F.from!=null&&j[F.from]!=null&&(j[L]=pn)}j[R]!=null&&Vs(!0);let g={};for(let L in j){let F=j[L];if(F!=null){let q=g[L]=Sr(x[L],km);if(F.min!=null)qe(q,F);else if(L!=R||s==2)if(O==0&&q.from==null){let st=q.range(n,null,null,L);q.min=st[0],q.max=st[1]}else q.min=Re,q.max=-Re}}if(O>0){E.forEach((L,F)=>{if(s==1){let q=L.scale,st=j[q];if(st==null)return;let lt=g[q];if(F==0){let dt=lt.range(n,lt.min,lt.max,q);lt.min=dt[0],lt.max=dt[1],X=ui(lt.min,t[0]),$=ui(lt.max,t[0]),$-X>1&&(t[0][X]<lt.min&&X++,t[0][$]>lt.max&&$--),L.min=ut[X],L.max=ut[$]}else L.show&&L.auto&&_i(lt,st,L,t[F],L.sorted);L.idxs[0]=X,L.idxs[1]=$}else if(F>0&&L.show&&L.auto){let[q,st]=L.facets,lt=q.scale,dt=st.scale,[Rt,Ct]=t[F],Lt=g[lt],Yt=g[dt];Lt!=null&&_i(Lt,j[lt],q,Rt,q.sorted),Yt!=null&&_i(Yt,j[dt],st,Ct,st.sorted),L.min=st.min,L.max=st.max}});for(let L in g){let F=g[L],q=j[L];if(F.from==null&&(q==null||q.min==null)){let st=F.range(n,F.min==Re?null:F.min,F.max==-Re?null:F.max,L);F.min=st[0],F.max=st[1]}}}for(let L in g){let F=g[L];if(F.from!=null){let q=g[F.from];if(q.min==null)F.min=F.max=null;else{let st=F.range(n,q.min,q.max,L);F.min=st[0],F.max=st[1]}}}let M={},A=!1;for(let L in g){let F=g[L],q=x[L];if(q.min!=F.min||q.max!=F.max){q.min=F.min,q.max=F.max;let st=q.distr;q._min=st==3?Hi(q.min):st==4?ja(q.min,q.asinh):st==100?q.fwd(q.min):q.min,q._max=st==3?Hi(q.max):st==4?ja(q.max,q.asinh):st==100?q.fwd(q.max):q.max,M[L]=A=!0}}if(A){E.forEach((L,F)=>{s==2?F>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)pe=!0,an("setScale",L);at&&pt.left>=0&&(k=et=!0)}for(let L in j)j[L]=null}function Ae(g){let M=zl(X-1,0,O-1),A=zl($+1,0,O-1);for(;g[M]==null&&M>0;)M--;for(;g[A]==null&&A<O-1;)A++;return[M,A]}function Gn(){if(O>0){let g=E.some(M=>M._focus)&&ke!=Un.alpha;g&&(u.globalAlpha=ke=Un.alpha),E.forEach((M,A)=>{if(A>0&&M.show&&(Xi(A,!1),Xi(A,!0),M._paths==null)){let L=ke;ke!=M.alpha&&(u.globalAlpha=ke=M.alpha);let F=s==2?[0,t[A][0].length-1]:Ae(t[A]);M._paths=M.paths(n,A,F[0],F[1]),ke!=L&&(u.globalAlpha=ke=L)}}),E.forEach((M,A)=>{if(A>0&&M.show){let L=ke;ke!=M.alpha&&(u.globalAlpha=ke=M.alpha),M._paths!=null&&vn(A,!1);{let F=M._paths!=null?M._paths.gaps:null,q=M.points.show(n,A,X,$,F),st=M.points.filter(n,A,q,F);(q||st)&&(M.points._paths=M.points.paths(n,A,X,$,st),vn(A,!0))}ke!=L&&(u.globalAlpha=ke=L),an("drawSeries",A)}}),g&&(u.globalAlpha=ke=1)}}function Xi(g,M){let A=M?E[g].points:E[g];A._stroke=A.stroke(n,g),A._fill=A.fill(n,g)}function vn(g,M){let A=M?E[g].points:E[g],{stroke:L,fill:F,clip:q,flags:st,_stroke:lt=A._stroke,_fill:dt=A._fill,_width:Rt=A.width}=A._paths;Rt=Ce(Rt*Se,3);let Ct=null,Lt=Rt%2/2;M&&dt==null&&(dt=Rt>0?"#fff":lt);let Yt=A.pxAlign==1&&Lt>0;if(Yt&&u.translate(Lt,Lt),!M){let Me=vt-Rt/2,_e=Nt-Rt/2,se=Ot+Rt,Wt=Et+Rt;Ct=new Path2D,Ct.rect(Me,_e,se,Wt)}M?Hs(lt,Rt,A.dash,A.cap,dt,L,F,st,q):vi(g,lt,Rt,A.dash,A.cap,dt,L,F,st,Ct,q),Yt&&u.translate(-Lt,-Lt)}function vi(g,M,A,L,F,q,st,lt,dt,Rt,Ct){let Lt=!1;dt!=0&&I.forEach((Yt,Me)=>{if(Yt.series[0]==g){let _e=E[Yt.series[1]],se=t[Yt.series[1]],Wt=(_e._paths||io).band;ns(Wt)&&(Wt=Yt.dir==1?Wt[0]:Wt[1]);let zt,Ie=null;_e.show&&Wt&&Lm(se,X,$)?(Ie=Yt.fill(n,Me)||q,zt=_e._paths.clip):Wt=null,Hs(M,A,L,F,Ie,st,lt,dt,Rt,Ct,zt,Wt),Lt=!0}}),Lt||Hs(M,A,L,F,q,st,lt,dt,Rt,Ct)}const ni=yr|Gl;function Hs(g,M,A,L,F,q,st,lt,dt,Rt,Ct,Lt){me(g,M,A,L,F),(dt||Rt||Lt)&&(u.save(),dt&&u.clip(dt),Rt&&u.clip(Rt)),Lt?(lt&ni)==ni?(u.clip(Lt),Ct&&u.clip(Ct),vo(F,st),_o(g,q,M)):lt&Gl?(vo(F,st),u.clip(Lt),_o(g,q,M)):lt&yr&&(u.save(),u.clip(Lt),Ct&&u.clip(Ct),vo(F,st),u.restore(),_o(g,q,M)):(vo(F,st),_o(g,q,M)),(dt||Rt||Lt)&&u.restore()}function _o(g,M,A){A>0&&(M instanceof Map?M.forEach((L,F)=>{u.strokeStyle=Gt=F,u.stroke(L)}):M!=null&&g&&u.stroke(M))}function vo(g,M){M instanceof Map?M.forEach((A,L)=>{u.fillStyle=Xt=L,u.fill(A)}):M!=null&&g&&u.fill(M)}function Vp(g,M,A,L){let F=w[g],q;if(L<=0)q=[0,0];else{let st=F._space=F.space(n,g,M,A,L),lt=F._incrs=F.incrs(n,g,M,A,L,st);q=Jg(M,A,lt,L,st)}return F._found=q}function Fa(g,M,A,L,F,q,st,lt,dt,Rt){let Ct=st%2/2;v==1&&u.translate(Ct,Ct),me(lt,st,dt,Rt,lt),u.beginPath();let Lt,Yt,Me,_e,se=F+(L==0||L==3?-q:q);A==0?(Yt=F,_e=se):(Lt=F,Me=se);for(let Wt=0;Wt<g.length;Wt++)M[Wt]!=null&&(A==0?Lt=Me=g[Wt]:Yt=_e=g[Wt],u.moveTo(Lt,Yt),u.lineTo(Me,_e));u.stroke(),v==1&&u.translate(-Ct,-Ct)}function Gp(g){let M=!0;return w.forEach((A,L)=>{if(!A.show)return;let F=x[A.scale];if(F.min==null){A._show&&(M=!1,A._show=!1,Vs(!1));return}else A._show||(M=!1,A._show=!0,Vs(!1));let q=A.side,st=q%2,{min:lt,max:dt}=F,[Rt,Ct]=Vp(L,lt,dt,st==0?Z:W);if(Ct==0)return;let Lt=F.distr==2,Yt=A._splits=A.splits(n,L,lt,dt,Rt,Ct,Lt),Me=F.distr==2?Yt.map(zt=>ut[zt]):Yt,_e=F.distr==2?ut[Yt[1]]-ut[Yt[0]]:Rt,se=A._values=A.values(n,A.filter(n,Me,L,Ct,_e),L,Ct,_e);A._rotate=q==2?A.rotate(n,se,L,Ct):0;let Wt=A._size;A._size=Yn(A.size(n,se,L,g)),Wt!=null&&A._size!=Wt&&(M=!1)}),M}function Wp(g){let M=!0;return go.forEach((A,L)=>{let F=A(n,L,gi,g);F!=b[L]&&(M=!1),b[L]=F}),M}function Xp(){for(let g=0;g<w.length;g++){let M=w[g];if(!M.show||!M._show)continue;let A=M.side,L=A%2,F,q,st=M.stroke(n,g),lt=A==0||A==3?-1:1,[dt,Rt]=M._found;if(M.label!=null){let Mn=M.labelGap*lt,Fn=je((M._lpos+Mn)*Se);An(M.labelFont[0],st,"center",A==2?"top":Xu),u.save(),L==1?(F=q=0,u.translate(Fn,je(Nt+Et/2)),u.rotate((A==3?-na:na)/2)):(F=je(vt+Ot/2),q=Fn);let gs=od(M.label)?M.label(n,g,dt,Rt):M.label;u.fillText(gs,F,q),u.restore()}if(Rt==0)continue;let Ct=x[M.scale],Lt=L==0?Ot:Et,Yt=L==0?vt:Nt,Me=M._splits,_e=Ct.distr==2?Me.map(Mn=>ut[Mn]):Me,se=Ct.distr==2?ut[Me[1]]-ut[Me[0]]:dt,Wt=M.ticks,zt=M.border,Ie=Wt.show?Wt.size:0,Ve=je(Ie*Se),ln=je((M.alignTo==2?M._size-Ie-M.gap:M.gap)*Se),Te=M._rotate*-na/180,Ge=m(M._pos*Se),In=(Ve+ln)*lt,xn=Ge+In;q=L==0?xn:0,F=L==1?xn:0;let Wn=M.font[0],ii=M.align==1?Zs:M.align==2?qa:Te>0?Zs:Te<0?qa:L==0?"center":A==3?qa:Zs,Si=Te||L==1?"middle":A==2?"top":Xu;An(Wn,st,ii,Si);let Nn=M.font[1]*M.lineGap,Xn=Me.map(Mn=>m(a(Mn,Ct,Lt,Yt))),si=M._values;for(let Mn=0;Mn<si.length;Mn++){let Fn=si[Mn];if(Fn!=null){L==0?F=Xn[Mn]:q=Xn[Mn],Fn=""+Fn;let gs=Fn.indexOf(`
`)==-1?[Fn]:Fn.split(/\n/gm);for(let Sn=0;Sn<gs.length;Sn++){let Gu=gs[Sn];Te?(u.save(),u.translate(F,q+Sn*Nn),u.rotate(Te),u.fillText(Gu,0,0),u.restore()):u.fillText(Gu,F,q+Sn*Nn)}}}Wt.show&&Fa(Xn,Wt.filter(n,_e,g,Rt,se),L,A,Ge,Ve,Ce(Wt.width*Se,3),Wt.stroke(n,g),Wt.dash,Wt.cap);let yi=M.grid;yi.show&&Fa(Xn,yi.filter(n,_e,g,Rt,se),L,L==0?2:1,L==0?Nt:vt,L==0?Et:Ot,Ce(yi.width*Se,3),yi.stroke(n,g),yi.dash,yi.cap),zt.show&&Fa([Ge],[1],L==0?1:0,L==0?1:2,L==1?Nt:vt,L==1?Et:Ot,Ce(zt.width*Se,3),zt.stroke(n,g),zt.dash,zt.cap)}an("drawAxes")}function Vs(g){E.forEach((M,A)=>{A>0&&(M._paths=null,g&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let xo=!1,Oa=!1,kr=[];function $p(){Oa=!1;for(let g=0;g<kr.length;g++)an(...kr[g]);kr.length=0}function Gs(){xo||(Xm(Tu),xo=!0)}function qp(g,M=!1){xo=!0,Oa=M,g(n),Tu(),M&&kr.length>0&&queueMicrotask($p)}n.batch=qp;function Tu(){if(ie&&(ds(),ie=!1),pe&&(Zt(),pe=!1),qt){if(Fe(p,Zs,tt),Fe(p,"top",St),Fe(p,Zr,Z),Fe(p,Jr,W),Fe(_,Zs,tt),Fe(_,"top",St),Fe(_,Zr,Z),Fe(_,Jr,W),Fe(f,Zr,y),Fe(f,Jr,Y),h.width=je(y*Se),h.height=je(Y*Se),w.forEach(({_el:g,_show:M,_size:A,_pos:L,side:F})=>{if(g!=null)if(M){let q=F===3||F===0?A:0,st=F%2==1;Fe(g,st?"left":"top",L-q),Fe(g,st?"width":"height",A),Fe(g,st?"top":"left",st?St:tt),Fe(g,st?"height":"width",st?W:Z),kl(g,As)}else Bn(g,As)}),Gt=Xt=Ut=ye=be=sn=he=kt=oe=null,ke=1,Hr(!0),tt!=_t||St!=Tt||Z!=Kt||W!=ft){Vs(!1);let g=Z/Kt,M=W/ft;if(at&&!k&&pt.left>=0){pt.left*=g,pt.top*=M,Ws&&Ei(Ws,je(pt.left),0,Z,W),Xs&&Ei(Xs,0,je(pt.top),Z,W);for(let A=0;A<dn.length;A++){let L=dn[A];L!=null&&(Ri[A]*=g,Ci[A]*=M,Ei(L,Yn(Ri[A]),Yn(Ci[A]),Z,W))}}if(Ue.show&&!xt&&Ue.left>=0&&Ue.width>0){Ue.left*=g,Ue.width*=g,Ue.top*=M,Ue.height*=M;for(let A in Ga)Fe(Ys,A,Ue[A])}_t=tt,Tt=St,Kt=Z,ft=W}an("setSize"),qt=!1}y>0&&Y>0&&(u.clearRect(0,0,h.width,h.height),an("drawClear"),U.forEach(g=>g()),an("draw")),Ue.show&&xt&&(Mo(Ue),xt=!1),at&&k&&(ms(null,!0,!1),k=!1),Mt.show&&Mt.live&&et&&(Ha(),et=!1),l||(l=!0,n.status=1,an("ready")),yt=!1,xo=!1}n.redraw=(g,M)=>{pe=M||!1,g!==!1?qi(R,C.min,C.max):Gs()};function ka(g,M){let A=x[g];if(A.from==null){if(O==0){let L=A.range(n,M.min,M.max,g);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(O>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;g==R&&A.distr==2&&O>0&&(M.min=ui(M.min,t[0]),M.max=ui(M.max,t[0]),M.min==M.max&&M.max++),j[g]=M,ie=!0,Gs()}}n.setScale=ka;let Ba,za,Ws,Xs,wu,Au,$s,qs,Ru,Cu,De,Be,$i=!1;const hn=pt.drag;let rn=hn.x,on=hn.y;at&&(pt.x&&(Ba=qn(mm,_)),pt.y&&(za=qn(gm,_)),C.ori==0?(Ws=Ba,Xs=za):(Ws=za,Xs=Ba),De=pt.left,Be=pt.top);const Ue=n.select=qe({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ys=Ue.show?qn(pm,Ue.over?_:p):null;function Mo(g,M){if(Ue.show){for(let A in g)Ue[A]=g[A],A in Ga&&Fe(Ys,A,g[A]);M!==!1&&an("setSelect")}}n.setSelect=Mo;function Yp(g){if(E[g].show)nt&&kl(It[g],As);else if(nt&&Bn(It[g],As),at){let A=wn?dn[0]:dn[g];A!=null&&Ei(A,-10,-10,Z,W)}}function qi(g,M,A){ka(g,{min:M,max:A})}function xi(g,M,A,L){M.focus!=null&&Qp(g),M.show!=null&&E.forEach((F,q)=>{q>0&&(g==q||g==null)&&(F.show=M.show,Yp(q),s==2?(qi(F.facets[0].scale,null,null),qi(F.facets[1].scale,null,null)):qi(F.scale,null,null),Gs())}),A!==!1&&an("setSeries",g,M),L&&Vr("setSeries",n,g,M)}n.setSeries=xi;function Kp(g,M){qe(I[g],M)}function jp(g,M){g.fill=ae(g.fill||null),g.dir=ve(g.dir,-1),M=M??I.length,I.splice(M,0,g)}function Zp(g){g==null?I.length=0:I.splice(g,1)}n.addBand=jp,n.setBand=Kp,n.delBand=Zp;function Jp(g,M){E[g].alpha=M,at&&dn[g]!=null&&(dn[g].style.opacity=M),nt&&It[g]&&(It[g].style.opacity=M)}let Pi,Yi,ps;const Ks={focus:!0};function Qp(g){if(g!=ps){let M=g==null,A=Un.alpha!=1;E.forEach((L,F)=>{if(s==1||F>0){let q=M||F==0||F==g;L._focus=M?null:q,A&&Jp(F,q?1:Un.alpha)}}),ps=g,A&&Gs()}}nt&&Ai&&Pt(Ku,ot,g=>{pt._lock||(Ke(g),ps!=null&&xi(null,Ks,!0,Xe.setSeries))});function Mi(g,M,A){let L=x[M];A&&(g=g/Se-(L.ori==1?St:tt));let F=Z;L.ori==1&&(F=W,g=F-g),L.dir==-1&&(g=F-g);let q=L._min,st=L._max,lt=g/F,dt=q+(st-q)*lt,Rt=L.distr;return Rt==3?xr(10,dt):Rt==4?Um(dt,L.asinh):Rt==100?L.bwd(dt):dt}function tm(g,M){let A=Mi(g,R,M);return ui(A,t[0],X,$)}n.valToIdx=g=>ui(g,t[0]),n.posToIdx=tm,n.posToVal=Mi,n.valToPos=(g,M,A)=>x[M].ori==0?r(g,x[M],A?Ot:Z,A?vt:0):o(g,x[M],A?Et:W,A?Nt:0),n.setCursor=(g,M,A)=>{De=g.left,Be=g.top,ms(null,M,A)};function Pu(g,M){Fe(Ys,Zs,Ue.left=g),Fe(Ys,Zr,Ue.width=M)}function Lu(g,M){Fe(Ys,"top",Ue.top=g),Fe(Ys,Jr,Ue.height=M)}let Br=C.ori==0?Pu:Lu,zr=C.ori==1?Pu:Lu;function em(){if(nt&&Mt.live)for(let g=s==2?1:0;g<E.length;g++){if(g==0&&ue)continue;let M=Mt.values[g],A=0;for(let L in M)ce[g][A++].firstChild.nodeValue=M[L]}}function Ha(g,M){if(g!=null&&(g.idxs?g.idxs.forEach((A,L)=>{mt[L]=A}):Om(g.idx)||mt.fill(g.idx),Mt.idx=mt[0]),nt&&Mt.live){for(let A=0;A<E.length;A++)(A>0||s==1&&!ue)&&nm(A,mt[A]);em()}et=!1,M!==!1&&an("setLegend")}n.setLegend=Ha;function nm(g,M){let A=E[g],L=g==0&&H==2?ut:t[g],F;ue?F=A.values(n,g,M)??B:(F=A.value(n,M==null?null:L[M],g,M),F=F==null?B:{_:F}),Mt.values[g]=F}function ms(g,M,A){Ru=De,Cu=Be,[De,Be]=pt.move(n,De,Be),pt.left=De,pt.top=Be,at&&(Ws&&Ei(Ws,je(De),0,Z,W),Xs&&Ei(Xs,0,je(Be),Z,W));let L,F=X>$;Pi=Re,Yi=null;let q=C.ori==0?Z:W,st=C.ori==1?Z:W;if(De<0||O==0||F){L=pt.idx=null;for(let lt=0;lt<E.length;lt++){let dt=dn[lt];dt!=null&&Ei(dt,-10,-10,Z,W)}Ai&&xi(null,Ks,!0,g==null&&Xe.setSeries),Mt.live&&(mt.fill(L),et=!0)}else{let lt,dt,Rt;s==1&&(lt=C.ori==0?De:Be,dt=Mi(lt,R),L=pt.idx=ui(dt,t[0],X,$),Rt=N(t[0][L],C,q,0));let Ct=-10,Lt=-10,Yt=0,Me=0,_e=!0,se="",Wt="";for(let zt=s==2?1:0;zt<E.length;zt++){let Ie=E[zt],Ve=mt[zt],ln=Ve==null?null:s==1?t[zt][Ve]:t[zt][1][Ve],Te=pt.dataIdx(n,zt,L,dt),Ge=Te==null?null:s==1?t[zt][Te]:t[zt][1][Te];if(et=et||Ge!=ln||Te!=Ve,mt[zt]=Te,zt>0&&Ie.show){let In=Te==null?-10:Te==L?Rt:N(s==1?t[0][Te]:t[zt][0][Te],C,q,0),xn=Ge==null?-10:V(Ge,s==1?x[Ie.scale]:x[Ie.facets[1].scale],st,0);if(Ai&&Ge!=null){let Wn=C.ori==1?De:Be,ii=Ze(Un.dist(n,zt,Te,xn,Wn));if(ii<Pi){let Si=Un.bias;if(Si!=0){let Nn=Mi(Wn,Ie.scale),Xn=Ge>=0?1:-1,si=Nn>=0?1:-1;si==Xn&&(si==1?Si==1?Ge>=Nn:Ge<=Nn:Si==1?Ge<=Nn:Ge>=Nn)&&(Pi=ii,Yi=zt)}else Pi=ii,Yi=zt}}if(et||wn){let Wn,ii;C.ori==0?(Wn=In,ii=xn):(Wn=xn,ii=In);let Si,Nn,Xn,si,yi,Mn,Fn=!0,gs=Pe.bbox;if(gs!=null){Fn=!1;let Sn=gs(n,zt);Xn=Sn.left,si=Sn.top,Si=Sn.width,Nn=Sn.height}else Xn=Wn,si=ii,Si=Nn=Pe.size(n,zt);if(Mn=Pe.fill(n,zt),yi=Pe.stroke(n,zt),wn)zt==Yi&&Pi<=Un.prox&&(Ct=Xn,Lt=si,Yt=Si,Me=Nn,_e=Fn,se=Mn,Wt=yi);else{let Sn=dn[zt];Sn!=null&&(Ri[zt]=Xn,Ci[zt]=si,nh(Sn,Si,Nn,Fn),th(Sn,Mn,yi),Ei(Sn,Yn(Xn),Yn(si),Z,W))}}}}if(wn){let zt=Un.prox,Ie=ps==null?Pi<=zt:Pi>zt||Yi!=ps;if(et||Ie){let Ve=dn[0];Ve!=null&&(Ri[0]=Ct,Ci[0]=Lt,nh(Ve,Yt,Me,_e),th(Ve,se,Wt),Ei(Ve,Yn(Ct),Yn(Lt),Z,W))}}}if(Ue.show&&$i)if(g!=null){let[lt,dt]=Xe.scales,[Rt,Ct]=Xe.match,[Lt,Yt]=g.cursor.sync.scales,Me=g.cursor.drag;if(rn=Me._x,on=Me._y,rn||on){let{left:_e,top:se,width:Wt,height:zt}=g.select,Ie=g.scales[Lt].ori,Ve=g.posToVal,ln,Te,Ge,In,xn,Wn=lt!=null&&Rt(lt,Lt),ii=dt!=null&&Ct(dt,Yt);Wn&&rn?(Ie==0?(ln=_e,Te=Wt):(ln=se,Te=zt),Ge=x[lt],In=N(Ve(ln,Lt),Ge,q,0),xn=N(Ve(ln+Te,Lt),Ge,q,0),Br(hi(In,xn),Ze(xn-In))):Br(0,q),ii&&on?(Ie==1?(ln=_e,Te=Wt):(ln=se,Te=zt),Ge=x[dt],In=V(Ve(ln,Yt),Ge,st,0),xn=V(Ve(ln+Te,Yt),Ge,st,0),zr(hi(In,xn),Ze(xn-In))):zr(0,st)}else Wa()}else{let lt=Ze(Ru-wu),dt=Ze(Cu-Au);if(C.ori==1){let Yt=lt;lt=dt,dt=Yt}rn=hn.x&&lt>=hn.dist,on=hn.y&&dt>=hn.dist;let Rt=hn.uni;Rt!=null?rn&&on&&(rn=lt>=Rt,on=dt>=Rt,!rn&&!on&&(dt>lt?on=!0:rn=!0)):hn.x&&hn.y&&(rn||on)&&(rn=on=!0);let Ct,Lt;rn&&(C.ori==0?(Ct=$s,Lt=De):(Ct=qs,Lt=Be),Br(hi(Ct,Lt),Ze(Lt-Ct)),on||zr(0,st)),on&&(C.ori==1?(Ct=$s,Lt=De):(Ct=qs,Lt=Be),zr(hi(Ct,Lt),Ze(Lt-Ct)),rn||Br(0,q)),!rn&&!on&&(Br(0,0),zr(0,0))}if(hn._x=rn,hn._y=on,g==null){if(A){if(Vu!=null){let[lt,dt]=Xe.scales;Xe.values[0]=lt!=null?Mi(C.ori==0?De:Be,lt):null,Xe.values[1]=dt!=null?Mi(C.ori==1?De:Be,dt):null}Vr(Ya,n,De,Be,Z,W,L)}if(Ai){let lt=A&&Xe.setSeries,dt=Un.prox;ps==null?Pi<=dt&&xi(Yi,Ks,!0,lt):Pi>dt?xi(null,Ks,!0,lt):Yi!=ps&&xi(Yi,Ks,!0,lt)}}et&&(Mt.idx=L,Ha()),M!==!1&&an("setCursor")}let Ki=null;Object.defineProperty(n,"rect",{get(){return Ki==null&&Hr(!1),Ki}});function Hr(g=!1){g?Ki=null:(Ki=_.getBoundingClientRect(),an("syncRect",Ki))}function Du(g,M,A,L,F,q,st){pt._lock||$i&&g!=null&&g.movementX==0&&g.movementY==0||(Va(g,M,A,L,F,q,st,!1,g!=null),g!=null?ms(null,!0,!0):ms(M,!0,!1))}function Va(g,M,A,L,F,q,st,lt,dt){if(Ki==null&&Hr(!1),Ke(g),g!=null)A=g.clientX-Ki.left,L=g.clientY-Ki.top;else{if(A<0||L<0){De=-10,Be=-10;return}let[Rt,Ct]=Xe.scales,Lt=M.cursor.sync,[Yt,Me]=Lt.values,[_e,se]=Lt.scales,[Wt,zt]=Xe.match,Ie=M.axes[0].side%2==1,Ve=C.ori==0?Z:W,ln=C.ori==1?Z:W,Te=Ie?q:F,Ge=Ie?F:q,In=Ie?L:A,xn=Ie?A:L;if(_e!=null?A=Wt(Rt,_e)?a(Yt,x[Rt],Ve,0):-10:A=Ve*(In/Te),se!=null?L=zt(Ct,se)?a(Me,x[Ct],ln,0):-10:L=ln*(xn/Ge),C.ori==1){let Wn=A;A=L,L=Wn}}dt&&(M==null||M.cursor.event.type==Ya)&&((A<=1||A>=Z-1)&&(A=Es(A,Z)),(L<=1||L>=W-1)&&(L=Es(L,W))),lt?(wu=A,Au=L,[$s,qs]=pt.move(n,A,L)):(De=A,Be=L)}const Ga={width:0,height:0,left:0,top:0};function Wa(){Mo(Ga,!1)}let Uu,Iu,Nu,Fu;function Ou(g,M,A,L,F,q,st){$i=!0,rn=on=hn._x=hn._y=!1,Va(g,M,A,L,F,q,st,!0,!1),g!=null&&(Pt(Ka,Fl,ku,!1),Vr(qu,n,$s,qs,Z,W,null));let{left:lt,top:dt,width:Rt,height:Ct}=Ue;Uu=lt,Iu=dt,Nu=Rt,Fu=Ct}function ku(g,M,A,L,F,q,st){$i=hn._x=hn._y=!1,Va(g,M,A,L,F,q,st,!1,!0);let{left:lt,top:dt,width:Rt,height:Ct}=Ue,Lt=Rt>0||Ct>0,Yt=Uu!=lt||Iu!=dt||Nu!=Rt||Fu!=Ct;if(Lt&&Yt&&Mo(Ue),hn.setScale&&Lt&&Yt){let Me=lt,_e=Rt,se=dt,Wt=Ct;if(C.ori==1&&(Me=dt,_e=Ct,se=lt,Wt=Rt),rn&&qi(R,Mi(Me,R),Mi(Me+_e,R)),on)for(let zt in x){let Ie=x[zt];zt!=R&&Ie.from==null&&Ie.min!=Re&&qi(zt,Mi(se+Wt,zt),Mi(se,zt))}Wa()}else pt.lock&&(pt._lock=!pt._lock,ms(M,!0,g!=null));g!=null&&(P(Ka,Fl),Vr(Ka,n,De,Be,Z,W,null))}function im(g,M,A,L,F,q,st){if(pt._lock)return;Ke(g);let lt=$i;if($i){let dt=!0,Rt=!0,Ct=10,Lt,Yt;C.ori==0?(Lt=rn,Yt=on):(Lt=on,Yt=rn),Lt&&Yt&&(dt=De<=Ct||De>=Z-Ct,Rt=Be<=Ct||Be>=W-Ct),Lt&&dt&&(De=De<$s?0:Z),Yt&&Rt&&(Be=Be<qs?0:W),ms(null,!0,!0),$i=!1}De=-10,Be=-10,mt.fill(null),ms(null,!0,!0),lt&&($i=lt)}function Bu(g,M,A,L,F,q,st){pt._lock||(Ke(g),Dt(),Wa(),g!=null&&Vr(ju,n,De,Be,Z,W,null))}function zu(){w.forEach(Qg),rt(n.width,n.height,!0)}Us(fa,pr,zu);const js={};js.mousedown=Ou,js.mousemove=Du,js.mouseup=ku,js.dblclick=Bu,js.setSeries=(g,M,A,L)=>{let F=Xe.match[2];A=F(n,M,A),A!=-1&&xi(A,L,!0,!1)},at&&(Pt(qu,_,Ou),Pt(Ya,_,Du),Pt(Yu,_,g=>{Ke(g),Hr(!1)}),Pt(Ku,_,im),Pt(ju,_,Bu),Wl.add(n),n.syncRect=Hr);const So=n.hooks=i.hooks||{};function an(g,M,A){Oa?kr.push([g,M,A]):g in So&&So[g].forEach(L=>{L.call(null,n,M,A)})}(i.plugins||[]).forEach(g=>{for(let M in g.hooks)So[M]=(So[M]||[]).concat(g.hooks[M])});const Hu=(g,M,A)=>A,Xe=qe({key:null,setSeries:!1,filters:{pub:ah,sub:ah},scales:[R,E[1]?E[1].scale:null],match:[lh,lh,Hu],values:[null,null]},pt.sync);Xe.match.length==2&&Xe.match.push(Hu),pt.sync=Xe;const Vu=Xe.key,Xa=Pd(Vu);function Vr(g,M,A,L,F,q,st){Xe.filters.pub(g,M,A,L,F,q,st)&&Xa.pub(g,M,A,L,F,q,st)}Xa.sub(n);function sm(g,M,A,L,F,q,st){Xe.filters.sub(g,M,A,L,F,q,st)&&js[g](null,M,A,L,F,q,st)}n.pub=sm;function rm(){Xa.unsub(n),Wl.delete(n),de.clear(),Bl(fa,pr,zu),c.remove(),ot?.remove(),an("destroy")}n.destroy=rm;function $a(){an("init",i,t),Ft(t||i.data,!1),j[R]?ka(R,j[R]):Dt(),xt=Ue.show&&(Ue.width>0||Ue.height>0),k=et=!0,rt(i.width,i.height)}return E.forEach(Or),w.forEach(Na),e?e instanceof HTMLElement?(e.appendChild(c),$a()):e(n,$a):$a(),n}_n.assign=qe;_n.fmtNum=Gc;_n.rangeNum=da;_n.rangeLog=ya;_n.rangeAsinh=Hc;_n.orient=Os;_n.pxRatio=Se;_n.join=Wm;_n.fmtDate=Xc,_n.tzDate=eg;_n.sync=Pd;{_n.addGap=Og,_n.clipGaps=Ta;let i=_n.paths={points:Fd};i.linear=kd,i.stepped=zg,i.bars=Hg,i.spline=Gg}const it={title:"RVD console",clocks:"Three clocks",clock_generated:"generated on board",clock_received:"received on the ground",clock_predicted:"predicted for",modes:"Who decides",mode_manual:"Manual",mode_shared:"Shared",mode_auto:"Auto",pause:"Pause",resume:"Resume",abort:"ABORT",abort_hint:"X twice",abort_armed:"again: ABORT",instruments:"Instruments",motion:"Motion",measured:"measured",predicted:"predicted",limit:"limit",truth:"truth",range:"range",closing:"closing rate",offset:"lateral offset",lateral:"lateral rate",margin:"wall margin",section:"Corridor section",section_alt:"Cross-section of the corridor with measured and predicted position",leave:"drifting out in",leave_never:"stays inside",leave_out:"OUTSIDE",thrust:"Thrust levels",pilot:"pilot",auto:"automatic",sent:"sent",weight:"pilot weight",scene:"Scene",views:"Views",view_orbit:"Orbit",view_side:"Side",view_top:"Top",camera_side:"Camera, delay and prediction error",camera:"Docking camera",camera_tag:"docking camera · delayed",camera_tag_review:"docking camera · truth",ladder:"Command ladder",ladder_alt:"Commands on their way to the craft and back",ladder_ground:"ground",ladder_link:"on the link",ladder_craft:"at the craft",ladder_back:"telemetry on its way back",ladder_known:"known",round_trip:"Round trip",dial_alt:"Dial of the round trip",errors:"Prediction error",error_position:"position, cm",error_rate:"rate, mm/s",restart:"New run",review:"Review",settings:"Stick",help:"Help",stop:"Stop run",review_close:"Leave review",play:"Play",stop_play:"Stop",scrub:"Instant of the review",review_title:"Review a run",review_none:"No finished runs here yet.",review_loading:"Reading the bag…",review_open:"Open",take:"Take the stick",drop:"Release the stick",taken:"Another page has the stick",stick_yours:"You have the stick",stick_held:"stick live",stick_open:"DEAD-MAN OPEN: automatic alone flies",stick_watch:"watching",keyboard:"keyboard",gamepad:"gamepad",level:"level",pages_one:"1 page",pages:"{n} pages",of:"of",socket_open:"connected",socket_closed:"NOT CONNECTED",idle:"Ready",idle_text:"Take the stick (T), then start a run (N).",starting:"The graph is coming up…",paused:"PAUSED",stale:"STALE",no_telemetry:"no telemetry yet",first_in:"first telemetry in {s} s",pilot_lost:"PILOT LOST: the automatic half flies alone",stale_frames:"NO DATA FOR {s} s",aborted:"ABORT in force: braking and backing away",abort_sent:"ABORT sent, acting in about {s} s",run_failed:"The run could not be flown: see the terminal",docked:"DOCKED",verdict:{docked:"Docked",left_corridor:"Left the corridor",closing_rate:"Closing rate out of limits",offset:"Lateral offset out of limits",lateral_rate:"Lateral rate out of limits",timeout:"Did not reach the docking plane in time",invalid:"The true state became invalid"},verdict_title:"Verdict",verdict_time:"time",verdict_closing:"closing rate",verdict_offset:"lateral offset",verdict_lateral:"lateral rate",verdict_margin:"least corridor margin",verdict_dv:"delta-v",fly_again:"Fly again (N)",close:"Close",cancel:"Cancel",start:"Start",seed:"seed",mode:"mode",seed_hint:"empty: the next one",new_run:"New run",new_run_text:"A new run in a new folder. A run under way is stopped.",no_fly:"This console belongs to one run; start it with ./rvd fly --operator console to fly again.",no_page_token:"This page needs the token of the address that the console printed.",no_token_title:"No token",section_at:"at x = {x} m",exaggerated:"lateral scale × {n}",lead:"in {s} s",rms:"rms {p} cm · {v} mm/s",legend:{measured:"measured",predicted:"predicted, 2σ tube",drift:"drift from there",wall:"corridor",boundary:"control boundary",truth:"truth"},link:{transit:"transit",p99:"p99",lost:"lost",late:"late",corrupted:"damaged",gap:"last gap"},age:"age {s} s",ago:"{s} s ago",ahead:"in {s} s",now:"now",settings_title:"The stick",settings_dead_zone:"dead zone",settings_axis:"axis",settings_invert:"inverted",settings_button:"dead-man button",settings_space:"keyboard: hold Space as dead-man",settings_none:"No gamepad seen. Press a button on it.",settings_found:"Gamepad: {name}",settings_x:"forward / back",settings_y:"up / down",settings_z:"right / left",help_title:"Keys",review_truth:"Review shows the truth. It never reaches this page while a run is flown.",unknown:"–",desk:{door:"Which volunteer? Enter the number you were given; no name is asked or kept.",volunteer:"volunteer number",begin:"Begin",heading:"{who}, flight {n} of {of}",training:"Training: this flight does not count.",counts:"This flight counts.",condition:"Control: {mode}",hint:"Dock inside the green circle, slower than the limits. The clock starts when the graph is up.",fly:"Start the flight",rest_title:"A break",rest:"Rest your eyes and hands.",go_on:"Go on",done_title:"Finished",done:"Thank you, {who}. All flights are flown and rated.",next:"Next volunteer",yes:"Yes",no:"No",again:"Answer again",pick:"Pick the sentence that fits best.",save:"Save the ratings",tree:{controllable:"Was the craft controllable?",adequate:"Was adequate performance (docking within the limits) attainable with a tolerable pilot workload?",satisfactory:"Was it satisfactory without improvement?"},ratings:["","Excellent, highly desirable: compensation not a factor","Good, negligible deficiencies: compensation not a factor","Fair, some mildly unpleasant deficiencies: minimal compensation","Minor but annoying deficiencies: moderate compensation","Moderately objectionable deficiencies: considerable compensation","Very objectionable but tolerable deficiencies: extensive compensation","Major deficiencies: adequate performance not attainable with maximum tolerable compensation","Major deficiencies: considerable compensation needed for control","Major deficiencies: intense compensation needed to retain control","Major deficiencies: control lost during some part of the flight"],tlx:{mental:["Mental demand","How mentally demanding was the flight?","very low","very high"],physical:["Physical demand","How physically demanding was the flight?","very low","very high"],temporal:["Temporal demand","How hurried or rushed was the pace?","very low","very high"],performance:["Performance","How successful were you in doing what you were asked to do?","perfect","failure"],effort:["Effort","How hard did you have to work for your level of performance?","very low","very high"],frustration:["Frustration","How insecure, discouraged, irritated, stressed and annoyed were you?","very low","very high"]},errors:{VOLUNTEER:"A whole number from 1 to 999, please.",STAGE:"Not now.",RATING:"The rating is incomplete.",TLX:"Please set every scale."}}},t_=[["T","take or release the stick"],["W / S","thrust forward / back (x)"],["↑ / ↓ or R / F","thrust up / down (y, radially outward is up)"],["← / → or A / D","thrust left / right (z)"],["1 2 3","thrust level of the keys"],["Space","dead-man, if so chosen under Stick"],["M","manual, shared, auto in turn"],["P","pause, resume"],["X X","ABORT: brake and back away, past every buffer"],["N","new run"],["V","next view"],["L","review a run"],["G","stick settings"],["?","this list"],["Esc","close"],["","A key that comes up is zero. Without focus, without this page, or with the dead-man open, the pilot is lost and the automatic half flies alone."]],e_=["nobody","pilot","automatic","blend","guard"],Ph=["","nothing due","wrong length","checksum","out of order","too old","out of range","an input was missing","as the mode says","stick invalid: automatic alone","automatic invalid: counts as 0","neither valid: level 0","ABORT in force"],n_=["sent","due","executed","effect seen","refused","missed","unknown"],i_={LEASE:"Take the stick first (T).",TAKEN:"Another page has the stick.",NO_RUN:"No run is under way.",NO_FLY:it.no_fly,DESK:"The session says what is flown.",MODE:"No such mode.",SEED:"The seed must be a whole number."};function fn(i,t){return i.replace(/\{(\w+)\}/g,(e,n)=>t[n])}const s_=["#7cc4ff","#56d6b0","#d59bf6"],r_=60;function o_(i,t,e,n){const s={stroke:"#8fa1b3",grid:{stroke:"#1b2733",width:1},ticks:{stroke:"#1b2733"},font:`${.68*n}px system-ui`,size:2.3*n};return{width:t,height:e,legend:{show:!1},cursor:{show:!1},padding:[n*.3,n*.4,0,0],scales:{x:{time:!1},y:{range:(r,o,a)=>{const l=Math.max(Math.abs(o||0),Math.abs(a||0),1);return[-l*1.1,l*1.1]}}},axes:[{...s,size:1.5*n,gap:1},{...s,gap:1,space:1.5*n,label:i,labelSize:1.1*n,labelFont:`${.7*n}px system-ui`}],series:[{},...["x","y","z"].map((r,o)=>({label:r,stroke:s_[o],width:1.5,points:{show:!1}})),{stroke:"#ffb65290",width:1,dash:[4,4],points:{show:!1}},{stroke:"#ffb65290",width:1,dash:[4,4],points:{show:!1}}]}}class Lh{constructor(t,e,n){this.element=document.getElementById(t),this.title=e,this.offset=n}size(){const t=parseFloat(getComputedStyle(document.documentElement).fontSize),e=this.element.parentElement.clientWidth-1.2*t;return{width:Math.max(e,60),height:6.4*t,rem:t}}show(t,e){const n=this.size();(!this.plot||this.width!==n.width)&&(this.plot&&this.plot.destroy(),this.plot=new _n(o_(this.title,n.width,n.height,n.rem),[[],[],[],[],[],[]],this.element),this.width=n.width);let s=t.t.length;if(e!==void 0)for(;s>0&&t.t[s-1]>e;)s-=1;let r=s;for(;r>0&&t.t[r-1]>(t.t[s-1]??0)-r_;)r-=1;const o=c=>c.slice(r,s),a=this.offset,l=o(t.s[a+1]);this.plot.setData([o(t.t),o(t.e[a]),o(t.e[a+1]),o(t.e[a+2]),l,l.map(c=>c===null?null:-c)])}}class a_{constructor(){this.strips=[new Lh("chart-position",it.error_position,0),new Lh("chart-rate",it.error_rate,3)]}show(t,e){for(const n of this.strips)n.show(t,e)}}const re={measured:"#7cc4ff",predicted:"#ffb652",auto:"#d59bf6",ok:"#56d6b0",alarm:"#ff7a5c",wall:"#8aa4bd",boundary:"#b9c2a0",dim:"#8fa1b3",line:"#263544",text:"#dbe5ee",truth:"#f2f5f8"};function Ca(i){const t=i.getBoundingClientRect(),e=Math.min(devicePixelRatio||1,2),n=Math.max(1,Math.round(t.width*e)),s=Math.max(1,Math.round(t.height*e));(i.width!==n||i.height!==s)&&Object.assign(i,{width:n,height:s});const r=i.getContext("2d");r.setTransform(e,0,0,e,0,0),r.clearRect(0,0,t.width,t.height);const o=parseFloat(getComputedStyle(document.documentElement).fontSize);return r.font=`${.74*o}px system-ui, sans-serif`,r.lineWidth=o/12,{pen:r,w:t.width,h:t.height,rem:o}}function ia(i,t,e,n,s,r){i.strokeStyle=s,i.setLineDash(r||[]),i.beginPath(),i.arc(t,e,Math.max(n,0),0,7),i.stroke(),i.setLineDash([])}function Qn(i,t,e,n,s,r="left",o="middle"){i.fillStyle=s,i.textAlign=r,i.textBaseline=o,i.fillText(t,e,n)}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Jc="170",l_=0,Dh=1,c_=2,Vd=1,u_=2,Fi=3,ls=0,Ln=1,fi=2,rs=0,mr=1,Uh=2,Ih=3,Nh=4,h_=5,Rs=100,f_=101,d_=102,p_=103,m_=104,g_=200,__=201,v_=202,x_=203,$l=204,ql=205,M_=206,S_=207,y_=208,E_=209,b_=210,T_=211,w_=212,A_=213,R_=214,Yl=0,Kl=1,jl=2,Er=3,Zl=4,Jl=5,Ql=6,tc=7,Qc=0,C_=1,P_=2,os=0,L_=1,D_=2,U_=3,I_=4,N_=5,F_=6,O_=7,Gd=300,br=301,Tr=302,ec=303,nc=304,Pa=306,ic=1e3,Ps=1001,sc=1002,mi=1003,k_=1004,To=1005,Ti=1006,tl=1007,Ls=1008,Wi=1009,Wd=1010,Xd=1011,oo=1012,tu=1013,Ns=1014,ki=1015,lo=1016,eu=1017,nu=1018,wr=1020,$d=35902,qd=1021,Yd=1022,di=1023,Kd=1024,jd=1025,gr=1026,Ar=1027,Zd=1028,iu=1029,Jd=1030,su=1031,ru=1033,sa=33776,ra=33777,oa=33778,aa=33779,rc=35840,oc=35841,ac=35842,lc=35843,cc=36196,uc=37492,hc=37496,fc=37808,dc=37809,pc=37810,mc=37811,gc=37812,_c=37813,vc=37814,xc=37815,Mc=37816,Sc=37817,yc=37818,Ec=37819,bc=37820,Tc=37821,la=36492,wc=36494,Ac=36495,Qd=36283,Rc=36284,Cc=36285,Pc=36286,B_=3200,z_=3201,tp=0,H_=1,is="",Kn="srgb",Ur="srgb-linear",La="linear",we="srgb",Js=7680,Fh=519,V_=512,G_=513,W_=514,ep=515,X_=516,$_=517,q_=518,Y_=519,Oh=35044,kh="300 es",Bi=2e3,ma=2001;class Ir{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const n=this._listeners[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const mn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ca=Math.PI/180,Lc=180/Math.PI;function co(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(mn[i&255]+mn[i>>8&255]+mn[i>>16&255]+mn[i>>24&255]+"-"+mn[t&255]+mn[t>>8&255]+"-"+mn[t>>16&15|64]+mn[t>>24&255]+"-"+mn[e&63|128]+mn[e>>8&255]+"-"+mn[e>>16&255]+mn[e>>24&255]+mn[n&255]+mn[n>>8&255]+mn[n>>16&255]+mn[n>>24&255]).toLowerCase()}function En(i,t,e){return Math.max(t,Math.min(e,i))}function K_(i,t){return(i%t+t)%t}function el(i,t,e){return(1-e)*i+e*t}function Wr(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Rn(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class le{constructor(t=0,e=0){le.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(En(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Qt{constructor(t,e,n,s,r,o,a,l,c){Qt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){const h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],p=n[5],_=n[8],v=s[0],m=s[3],d=s[6],E=s[1],w=s[4],x=s[7],I=s[2],R=s[5],D=s[8];return r[0]=o*v+a*E+l*I,r[3]=o*m+a*w+l*R,r[6]=o*d+a*x+l*D,r[1]=c*v+h*E+u*I,r[4]=c*m+h*w+u*R,r[7]=c*d+h*x+u*D,r[2]=f*v+p*E+_*I,r[5]=f*m+p*w+_*R,r[8]=f*d+p*x+_*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,p=c*r-o*l,_=e*u+n*f+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/_;return t[0]=u*v,t[1]=(s*c-h*n)*v,t[2]=(a*n-s*o)*v,t[3]=f*v,t[4]=(h*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=p*v,t[7]=(n*l-c*e)*v,t[8]=(o*e-n*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(nl.makeScale(t,e)),this}rotate(t){return this.premultiply(nl.makeRotation(-t)),this}translate(t,e){return this.premultiply(nl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const nl=new Qt;function np(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function ga(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function j_(){const i=ga("canvas");return i.style.display="block",i}const Bh={};function to(i){i in Bh||(Bh[i]=!0,console.warn(i))}function Z_(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}function J_(i){const t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function Q_(i){const t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const ge={enabled:!0,workingColorSpace:Ur,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===we&&(i.r=Gi(i.r),i.g=Gi(i.g),i.b=Gi(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===we&&(i.r=_r(i.r),i.g=_r(i.g),i.b=_r(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===is?La:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Gi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function _r(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const zh=[.64,.33,.3,.6,.15,.06],Hh=[.2126,.7152,.0722],Vh=[.3127,.329],Gh=new Qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Wh=new Qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ge.define({[Ur]:{primaries:zh,whitePoint:Vh,transfer:La,toXYZ:Gh,fromXYZ:Wh,luminanceCoefficients:Hh,workingColorSpaceConfig:{unpackColorSpace:Kn},outputColorSpaceConfig:{drawingBufferColorSpace:Kn}},[Kn]:{primaries:zh,whitePoint:Vh,transfer:we,toXYZ:Gh,fromXYZ:Wh,luminanceCoefficients:Hh,outputColorSpaceConfig:{drawingBufferColorSpace:Kn}}});let Qs;class t0{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{Qs===void 0&&(Qs=ga("canvas")),Qs.width=t.width,Qs.height=t.height;const n=Qs.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=Qs}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=ga("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Gi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Gi(e[n]/255)*255):e[n]=Gi(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let e0=0;class ip{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:e0++}),this.uuid=co(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(il(s[o].image)):r.push(il(s[o]))}else r=il(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function il(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?t0.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let n0=0;class Dn extends Ir{constructor(t=Dn.DEFAULT_IMAGE,e=Dn.DEFAULT_MAPPING,n=Ps,s=Ps,r=Ti,o=Ls,a=di,l=Wi,c=Dn.DEFAULT_ANISOTROPY,h=is){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:n0++}),this.uuid=co(),this.name="",this.source=new ip(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new le(0,0),this.repeat=new le(1,1),this.center=new le(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Gd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ic:t.x=t.x-Math.floor(t.x);break;case Ps:t.x=t.x<0?0:1;break;case sc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ic:t.y=t.y-Math.floor(t.y);break;case Ps:t.y=t.y<0?0:1;break;case sc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Dn.DEFAULT_IMAGE=null;Dn.DEFAULT_MAPPING=Gd;Dn.DEFAULT_ANISOTROPY=1;class We{constructor(t=0,e=0,n=0,s=1){We.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],p=l[5],_=l[9],v=l[2],m=l[6],d=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-v)<.01&&Math.abs(_-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+v)<.1&&Math.abs(_+m)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const w=(c+1)/2,x=(p+1)/2,I=(d+1)/2,R=(h+f)/4,D=(u+v)/4,U=(_+m)/4;return w>x&&w>I?w<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(w),s=R/n,r=D/n):x>I?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=R/s,r=U/s):I<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),n=D/r,s=U/r),this.set(n,s,r,e),this}let E=Math.sqrt((m-_)*(m-_)+(u-v)*(u-v)+(f-h)*(f-h));return Math.abs(E)<.001&&(E=1),this.x=(m-_)/E,this.y=(u-v)/E,this.z=(f-h)/E,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class i0 extends Ir{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new We(0,0,t,e),this.scissorTest=!1,this.viewport=new We(0,0,t,e);const s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ti,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const r=new Dn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];const o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new ip(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Fs extends i0{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class sp extends Dn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=mi,this.minFilter=mi,this.wrapR=Ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class s0 extends Dn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=mi,this.minFilter=mi,this.wrapR=Ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class uo{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3];const f=r[o+0],p=r[o+1],_=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u;return}if(a===1){t[e+0]=f,t[e+1]=p,t[e+2]=_,t[e+3]=v;return}if(u!==v||l!==f||c!==p||h!==_){let m=1-a;const d=l*f+c*p+h*_+u*v,E=d>=0?1:-1,w=1-d*d;if(w>Number.EPSILON){const I=Math.sqrt(w),R=Math.atan2(I,d*E);m=Math.sin(m*R)/I,a=Math.sin(a*R)/I}const x=a*E;if(l=l*m+f*x,c=c*m+p*x,h=h*m+_*x,u=u*m+v*x,m===1-a){const I=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=I,c*=I,h*=I,u*=I}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],p=r[o+2],_=r[o+3];return t[e]=a*_+h*u+l*p-c*f,t[e+1]=l*_+h*f+c*u-a*p,t[e+2]=c*_+h*p+a*f-l*u,t[e+3]=h*_-a*u-l*f-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),p=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*p*_,this._y=c*p*u-f*h*_,this._z=c*h*_+f*p*u,this._w=c*h*u-f*p*_;break;case"YXZ":this._x=f*h*u+c*p*_,this._y=c*p*u-f*h*_,this._z=c*h*_-f*p*u,this._w=c*h*u+f*p*_;break;case"ZXY":this._x=f*h*u-c*p*_,this._y=c*p*u+f*h*_,this._z=c*h*_+f*p*u,this._w=c*h*u-f*p*_;break;case"ZYX":this._x=f*h*u-c*p*_,this._y=c*p*u+f*h*_,this._z=c*h*_-f*p*u,this._w=c*h*u+f*p*_;break;case"YZX":this._x=f*h*u+c*p*_,this._y=c*p*u+f*h*_,this._z=c*h*_-f*p*u,this._w=c*h*u-f*p*_;break;case"XZY":this._x=f*h*u-c*p*_,this._y=c*p*u-f*h*_,this._z=c*h*_+f*p*u,this._w=c*h*u+f*p*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){const p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>u){const p=2*Math.sqrt(1+n-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>u){const p=2*Math.sqrt(1+a-n-u);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+h)/p}else{const p=2*Math.sqrt(1+u-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(En(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const n=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const p=1-e;return this._w=p*o+e*this._w,this._x=p*n+e*this._x,this._y=p*s+e*this._y,this._z=p*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-e)*h)/c,f=Math.sin(e*h)/c;return this._w=o*u+this._w*f,this._x=n*u+this._x*f,this._y=s*u+this._y*f,this._z=r*u+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class G{constructor(t=0,e=0,n=0){G.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Xh.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Xh.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return sl.copy(this).projectOnVector(t),this.sub(sl)}reflect(t){return this.sub(sl.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(En(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const sl=new G,Xh=new uo;class ho{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(ri.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(ri.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=ri.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ri):ri.fromBufferAttribute(r,o),ri.applyMatrix4(t.matrixWorld),this.expandByPoint(ri);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),wo.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),wo.copy(n.boundingBox)),wo.applyMatrix4(t.matrixWorld),this.union(wo)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ri),ri.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Xr),Ao.subVectors(this.max,Xr),tr.subVectors(t.a,Xr),er.subVectors(t.b,Xr),nr.subVectors(t.c,Xr),ji.subVectors(er,tr),Zi.subVectors(nr,er),_s.subVectors(tr,nr);let e=[0,-ji.z,ji.y,0,-Zi.z,Zi.y,0,-_s.z,_s.y,ji.z,0,-ji.x,Zi.z,0,-Zi.x,_s.z,0,-_s.x,-ji.y,ji.x,0,-Zi.y,Zi.x,0,-_s.y,_s.x,0];return!rl(e,tr,er,nr,Ao)||(e=[1,0,0,0,1,0,0,0,1],!rl(e,tr,er,nr,Ao))?!1:(Ro.crossVectors(ji,Zi),e=[Ro.x,Ro.y,Ro.z],rl(e,tr,er,nr,Ao))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ri).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ri).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Li[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Li[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Li[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Li[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Li[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Li[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Li[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Li[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Li),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Li=[new G,new G,new G,new G,new G,new G,new G,new G],ri=new G,wo=new ho,tr=new G,er=new G,nr=new G,ji=new G,Zi=new G,_s=new G,Xr=new G,Ao=new G,Ro=new G,vs=new G;function rl(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){vs.fromArray(i,r);const a=s.x*Math.abs(vs.x)+s.y*Math.abs(vs.y)+s.z*Math.abs(vs.z),l=t.dot(vs),c=e.dot(vs),h=n.dot(vs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const r0=new ho,$r=new G,ol=new G;class fo{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):r0.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$r.subVectors(t,this.center);const e=$r.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector($r,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ol.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($r.copy(t.center).add(ol)),this.expandByPoint($r.copy(t.center).sub(ol))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Di=new G,al=new G,Co=new G,Ji=new G,ll=new G,Po=new G,cl=new G;class ou{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Di)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Di.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Di.copy(this.origin).addScaledVector(this.direction,e),Di.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){al.copy(t).add(e).multiplyScalar(.5),Co.copy(e).sub(t).normalize(),Ji.copy(this.origin).sub(al);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Co),a=Ji.dot(this.direction),l=-Ji.dot(Co),c=Ji.lengthSq(),h=Math.abs(1-o*o);let u,f,p,_;if(h>0)if(u=o*l-a,f=o*a-l,_=r*h,u>=0)if(f>=-_)if(f<=_){const v=1/h;u*=v,f*=v,p=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f<=-_?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c):f<=_?(u=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(al).addScaledVector(Co,f),p}intersectSphere(t,e){Di.subVectors(t.center,this.origin);const n=Di.dot(this.direction),s=Di.dot(Di)-n*n,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Di)!==null}intersectTriangle(t,e,n,s,r){ll.subVectors(e,t),Po.subVectors(n,t),cl.crossVectors(ll,Po);let o=this.direction.dot(cl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ji.subVectors(this.origin,t);const l=a*this.direction.dot(Po.crossVectors(Ji,Po));if(l<0)return null;const c=a*this.direction.dot(ll.cross(Ji));if(c<0||l+c>o)return null;const h=-a*Ji.dot(cl);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class ze{constructor(t,e,n,s,r,o,a,l,c,h,u,f,p,_,v,m){ze.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,p,_,v,m)}set(t,e,n,s,r,o,a,l,c,h,u,f,p,_,v,m){const d=this.elements;return d[0]=t,d[4]=e,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=h,d[10]=u,d[14]=f,d[3]=p,d[7]=_,d[11]=v,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new ze().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,n=t.elements,s=1/ir.setFromMatrixColumn(t,0).length(),r=1/ir.setFromMatrixColumn(t,1).length(),o=1/ir.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){const f=o*h,p=o*u,_=a*h,v=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=p+_*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=_+p*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*h,p=l*u,_=c*h,v=c*u;e[0]=f+v*a,e[4]=_*a-p,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=p*a-_,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*h,p=l*u,_=c*h,v=c*u;e[0]=f-v*a,e[4]=-o*u,e[8]=_+p*a,e[1]=p+_*a,e[5]=o*h,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*h,p=o*u,_=a*h,v=a*u;e[0]=l*h,e[4]=_*c-p,e[8]=f*c+v,e[1]=l*u,e[5]=v*c+f,e[9]=p*c-_,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,p=o*c,_=a*l,v=a*c;e[0]=l*h,e[4]=v-f*u,e[8]=_*u+p,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=p*u+_,e[10]=f-v*u}else if(t.order==="XZY"){const f=o*l,p=o*c,_=a*l,v=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+v,e[5]=o*h,e[9]=p*u-_,e[2]=_*u-p,e[6]=a*h,e[10]=v*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(o0,t,a0)}lookAt(t,e,n){const s=this.elements;return On.subVectors(t,e),On.lengthSq()===0&&(On.z=1),On.normalize(),Qi.crossVectors(n,On),Qi.lengthSq()===0&&(Math.abs(n.z)===1?On.x+=1e-4:On.z+=1e-4,On.normalize(),Qi.crossVectors(n,On)),Qi.normalize(),Lo.crossVectors(On,Qi),s[0]=Qi.x,s[4]=Lo.x,s[8]=On.x,s[1]=Qi.y,s[5]=Lo.y,s[9]=On.y,s[2]=Qi.z,s[6]=Lo.z,s[10]=On.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],p=n[13],_=n[2],v=n[6],m=n[10],d=n[14],E=n[3],w=n[7],x=n[11],I=n[15],R=s[0],D=s[4],U=s[8],T=s[12],S=s[1],C=s[5],H=s[9],N=s[13],V=s[2],j=s[6],K=s[10],J=s[14],Q=s[3],ht=s[7],ct=s[11],mt=s[15];return r[0]=o*R+a*S+l*V+c*Q,r[4]=o*D+a*C+l*j+c*ht,r[8]=o*U+a*H+l*K+c*ct,r[12]=o*T+a*N+l*J+c*mt,r[1]=h*R+u*S+f*V+p*Q,r[5]=h*D+u*C+f*j+p*ht,r[9]=h*U+u*H+f*K+p*ct,r[13]=h*T+u*N+f*J+p*mt,r[2]=_*R+v*S+m*V+d*Q,r[6]=_*D+v*C+m*j+d*ht,r[10]=_*U+v*H+m*K+d*ct,r[14]=_*T+v*N+m*J+d*mt,r[3]=E*R+w*S+x*V+I*Q,r[7]=E*D+w*C+x*j+I*ht,r[11]=E*U+w*H+x*K+I*ct,r[15]=E*T+w*N+x*J+I*mt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],p=t[14],_=t[3],v=t[7],m=t[11],d=t[15];return _*(+r*l*u-s*c*u-r*a*f+n*c*f+s*a*p-n*l*p)+v*(+e*l*p-e*c*f+r*o*f-s*o*p+s*c*h-r*l*h)+m*(+e*c*u-e*a*p-r*o*u+n*o*p+r*a*h-n*c*h)+d*(-s*a*h-e*l*u+e*a*f+s*o*u-n*o*f+n*l*h)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],p=t[11],_=t[12],v=t[13],m=t[14],d=t[15],E=u*m*c-v*f*c+v*l*p-a*m*p-u*l*d+a*f*d,w=_*f*c-h*m*c-_*l*p+o*m*p+h*l*d-o*f*d,x=h*v*c-_*u*c+_*a*p-o*v*p-h*a*d+o*u*d,I=_*u*l-h*v*l-_*a*f+o*v*f+h*a*m-o*u*m,R=e*E+n*w+s*x+r*I;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/R;return t[0]=E*D,t[1]=(v*f*r-u*m*r-v*s*p+n*m*p+u*s*d-n*f*d)*D,t[2]=(a*m*r-v*l*r+v*s*c-n*m*c-a*s*d+n*l*d)*D,t[3]=(u*l*r-a*f*r-u*s*c+n*f*c+a*s*p-n*l*p)*D,t[4]=w*D,t[5]=(h*m*r-_*f*r+_*s*p-e*m*p-h*s*d+e*f*d)*D,t[6]=(_*l*r-o*m*r-_*s*c+e*m*c+o*s*d-e*l*d)*D,t[7]=(o*f*r-h*l*r+h*s*c-e*f*c-o*s*p+e*l*p)*D,t[8]=x*D,t[9]=(_*u*r-h*v*r-_*n*p+e*v*p+h*n*d-e*u*d)*D,t[10]=(o*v*r-_*a*r+_*n*c-e*v*c-o*n*d+e*a*d)*D,t[11]=(h*a*r-o*u*r-h*n*c+e*u*c+o*n*p-e*a*p)*D,t[12]=I*D,t[13]=(h*v*s-_*u*s+_*n*f-e*v*f-h*n*m+e*u*m)*D,t[14]=(_*a*s-o*v*s-_*n*l+e*v*l+o*n*m-e*a*m)*D,t[15]=(o*u*s-h*a*s+h*n*l-e*u*l-o*n*f+e*a*f)*D,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,p=r*h,_=r*u,v=o*h,m=o*u,d=a*u,E=l*c,w=l*h,x=l*u,I=n.x,R=n.y,D=n.z;return s[0]=(1-(v+d))*I,s[1]=(p+x)*I,s[2]=(_-w)*I,s[3]=0,s[4]=(p-x)*R,s[5]=(1-(f+d))*R,s[6]=(m+E)*R,s[7]=0,s[8]=(_+w)*D,s[9]=(m-E)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;let r=ir.set(s[0],s[1],s[2]).length();const o=ir.set(s[4],s[5],s[6]).length(),a=ir.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],oi.copy(this);const c=1/r,h=1/o,u=1/a;return oi.elements[0]*=c,oi.elements[1]*=c,oi.elements[2]*=c,oi.elements[4]*=h,oi.elements[5]*=h,oi.elements[6]*=h,oi.elements[8]*=u,oi.elements[9]*=u,oi.elements[10]*=u,e.setFromRotationMatrix(oi),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Bi){const l=this.elements,c=2*r/(e-t),h=2*r/(n-s),u=(e+t)/(e-t),f=(n+s)/(n-s);let p,_;if(a===Bi)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ma)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Bi){const l=this.elements,c=1/(e-t),h=1/(n-s),u=1/(o-r),f=(e+t)*c,p=(n+s)*h;let _,v;if(a===Bi)_=(o+r)*u,v=-2*u;else if(a===ma)_=r*u,v=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-p,l[2]=0,l[6]=0,l[10]=v,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const ir=new G,oi=new ze,o0=new G(0,0,0),a0=new G(1,1,1),Qi=new G,Lo=new G,On=new G,$h=new ze,qh=new uo;class wi{constructor(t=0,e=0,n=0,s=wi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(En(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-En(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(En(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-En(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(En(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-En(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return $h.makeRotationFromQuaternion(t),this.setFromRotationMatrix($h,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return qh.setFromEuler(this),this.setFromQuaternion(qh,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}wi.DEFAULT_ORDER="XYZ";class rp{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let l0=0;const Yh=new G,sr=new uo,Ui=new ze,Do=new G,qr=new G,c0=new G,u0=new uo,Kh=new G(1,0,0),jh=new G(0,1,0),Zh=new G(0,0,1),Jh={type:"added"},h0={type:"removed"},rr={type:"childadded",child:null},ul={type:"childremoved",child:null};class Je extends Ir{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:l0++}),this.uuid=co(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Je.DEFAULT_UP.clone();const t=new G,e=new wi,n=new uo,s=new G(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ze},normalMatrix:{value:new Qt}}),this.matrix=new ze,this.matrixWorld=new ze,this.matrixAutoUpdate=Je.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Je.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new rp,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return sr.setFromAxisAngle(t,e),this.quaternion.multiply(sr),this}rotateOnWorldAxis(t,e){return sr.setFromAxisAngle(t,e),this.quaternion.premultiply(sr),this}rotateX(t){return this.rotateOnAxis(Kh,t)}rotateY(t){return this.rotateOnAxis(jh,t)}rotateZ(t){return this.rotateOnAxis(Zh,t)}translateOnAxis(t,e){return Yh.copy(t).applyQuaternion(this.quaternion),this.position.add(Yh.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Kh,t)}translateY(t){return this.translateOnAxis(jh,t)}translateZ(t){return this.translateOnAxis(Zh,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ui.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Do.copy(t):Do.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),qr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ui.lookAt(qr,Do,this.up):Ui.lookAt(Do,qr,this.up),this.quaternion.setFromRotationMatrix(Ui),s&&(Ui.extractRotation(s.matrixWorld),sr.setFromRotationMatrix(Ui),this.quaternion.premultiply(sr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Jh),rr.child=t,this.dispatchEvent(rr),rr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(h0),ul.child=t,this.dispatchEvent(ul),ul.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ui.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ui.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ui),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Jh),rr.child=t,this.dispatchEvent(rr),rr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qr,t,c0),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qr,u0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){const n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),p=o(t.animations),_=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),_.length>0&&(n.nodes=_)}return n.object=s,n;function o(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}}Je.DEFAULT_UP=new G(0,1,0);Je.DEFAULT_MATRIX_AUTO_UPDATE=!0;Je.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const ai=new G,Ii=new G,hl=new G,Ni=new G,or=new G,ar=new G,Qh=new G,fl=new G,dl=new G,pl=new G,ml=new We,gl=new We,_l=new We;class Jn{constructor(t=new G,e=new G,n=new G){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),ai.subVectors(t,e),s.cross(ai);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){ai.subVectors(s,e),Ii.subVectors(n,e),hl.subVectors(t,e);const o=ai.dot(ai),a=ai.dot(Ii),l=ai.dot(hl),c=Ii.dot(Ii),h=Ii.dot(hl),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;const f=1/u,p=(c*l-a*h)*f,_=(o*h-a*l)*f;return r.set(1-p-_,_,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ni)===null?!1:Ni.x>=0&&Ni.y>=0&&Ni.x+Ni.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Ni)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ni.x),l.addScaledVector(o,Ni.y),l.addScaledVector(a,Ni.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return ml.setScalar(0),gl.setScalar(0),_l.setScalar(0),ml.fromBufferAttribute(t,e),gl.fromBufferAttribute(t,n),_l.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ml,r.x),o.addScaledVector(gl,r.y),o.addScaledVector(_l,r.z),o}static isFrontFacing(t,e,n,s){return ai.subVectors(n,e),Ii.subVectors(t,e),ai.cross(Ii).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return ai.subVectors(this.c,this.b),Ii.subVectors(this.a,this.b),ai.cross(Ii).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return Jn.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return Jn.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return Jn.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return Jn.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return Jn.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let o,a;or.subVectors(s,n),ar.subVectors(r,n),fl.subVectors(t,n);const l=or.dot(fl),c=ar.dot(fl);if(l<=0&&c<=0)return e.copy(n);dl.subVectors(t,s);const h=or.dot(dl),u=ar.dot(dl);if(h>=0&&u<=h)return e.copy(s);const f=l*u-h*c;if(f<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(n).addScaledVector(or,o);pl.subVectors(t,r);const p=or.dot(pl),_=ar.dot(pl);if(_>=0&&p<=_)return e.copy(r);const v=p*c-l*_;if(v<=0&&c>=0&&_<=0)return a=c/(c-_),e.copy(n).addScaledVector(ar,a);const m=h*_-p*u;if(m<=0&&u-h>=0&&p-_>=0)return Qh.subVectors(r,s),a=(u-h)/(u-h+(p-_)),e.copy(s).addScaledVector(Qh,a);const d=1/(m+v+f);return o=v*d,a=f*d,e.copy(n).addScaledVector(or,o).addScaledVector(ar,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const op={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ts={h:0,s:0,l:0},Uo={h:0,s:0,l:0};function vl(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class fe{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Kn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ge.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=ge.workingColorSpace){return this.r=t,this.g=e,this.b=n,ge.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=ge.workingColorSpace){if(t=K_(t,1),e=En(e,0,1),n=En(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=vl(o,r,t+1/3),this.g=vl(o,r,t),this.b=vl(o,r,t-1/3)}return ge.toWorkingColorSpace(this,s),this}setStyle(t,e=Kn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Kn){const n=op[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Gi(t.r),this.g=Gi(t.g),this.b=Gi(t.b),this}copyLinearToSRGB(t){return this.r=_r(t.r),this.g=_r(t.g),this.b=_r(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Kn){return ge.fromWorkingColorSpace(gn.copy(this),t),Math.round(En(gn.r*255,0,255))*65536+Math.round(En(gn.g*255,0,255))*256+Math.round(En(gn.b*255,0,255))}getHexString(t=Kn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ge.workingColorSpace){ge.fromWorkingColorSpace(gn.copy(this),e);const n=gn.r,s=gn.g,r=gn.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const h=(a+o)/2;if(a===o)l=0,c=0;else{const u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ge.workingColorSpace){return ge.fromWorkingColorSpace(gn.copy(this),e),t.r=gn.r,t.g=gn.g,t.b=gn.b,t}getStyle(t=Kn){ge.fromWorkingColorSpace(gn.copy(this),t);const e=gn.r,n=gn.g,s=gn.b;return t!==Kn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(ts),this.setHSL(ts.h+t,ts.s+e,ts.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ts),t.getHSL(Uo);const n=el(ts.h,Uo.h,e),s=el(ts.s,Uo.s,e),r=el(ts.l,Uo.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const gn=new fe;fe.NAMES=op;let f0=0;class ks extends Ir{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:f0++}),this.uuid=co(),this.name="",this.blending=mr,this.side=ls,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=$l,this.blendDst=ql,this.blendEquation=Rs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new fe(0,0,0),this.blendAlpha=0,this.depthFunc=Er,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Fh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Js,this.stencilZFail=Js,this.stencilZPass=Js,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==mr&&(n.blending=this.blending),this.side!==ls&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==$l&&(n.blendSrc=this.blendSrc),this.blendDst!==ql&&(n.blendDst=this.blendDst),this.blendEquation!==Rs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Er&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Fh&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Js&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Js&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Js&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class cs extends ks{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=Qc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const $e=new G,Io=new le;class ti{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Oh,this.updateRanges=[],this.gpuType=ki,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Io.fromBufferAttribute(this,e),Io.applyMatrix3(t),this.setXY(e,Io.x,Io.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyMatrix3(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyMatrix4(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyNormalMatrix(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.transformDirection(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Wr(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Rn(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Wr(e,this.array)),e}setX(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Wr(e,this.array)),e}setY(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Wr(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Wr(e,this.array)),e}setW(t,e){return this.normalized&&(e=Rn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Rn(e,this.array),n=Rn(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Rn(e,this.array),n=Rn(n,this.array),s=Rn(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Rn(e,this.array),n=Rn(n,this.array),s=Rn(s,this.array),r=Rn(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Oh&&(t.usage=this.usage),t}}class ap extends ti{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class lp extends ti{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class He extends ti{constructor(t,e,n){super(new Float32Array(t),e,n)}}let d0=0;const $n=new ze,xl=new Je,lr=new G,kn=new ho,Yr=new ho,cn=new G;class en extends Ir{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:d0++}),this.uuid=co(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(np(t)?lp:ap)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new Qt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return $n.makeRotationFromQuaternion(t),this.applyMatrix4($n),this}rotateX(t){return $n.makeRotationX(t),this.applyMatrix4($n),this}rotateY(t){return $n.makeRotationY(t),this.applyMatrix4($n),this}rotateZ(t){return $n.makeRotationZ(t),this.applyMatrix4($n),this}translate(t,e,n){return $n.makeTranslation(t,e,n),this.applyMatrix4($n),this}scale(t,e,n){return $n.makeScale(t,e,n),this.applyMatrix4($n),this}lookAt(t){return xl.lookAt(t),xl.updateMatrix(),this.applyMatrix4(xl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(lr).negate(),this.translate(lr.x,lr.y,lr.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new He(n,3))}else{for(let n=0,s=e.count;n<s;n++){const r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ho);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];kn.setFromBufferAttribute(r),this.morphTargetsRelative?(cn.addVectors(this.boundingBox.min,kn.min),this.boundingBox.expandByPoint(cn),cn.addVectors(this.boundingBox.max,kn.max),this.boundingBox.expandByPoint(cn)):(this.boundingBox.expandByPoint(kn.min),this.boundingBox.expandByPoint(kn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fo);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){const n=this.boundingSphere.center;if(kn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];Yr.setFromBufferAttribute(a),this.morphTargetsRelative?(cn.addVectors(kn.min,Yr.min),kn.expandByPoint(cn),cn.addVectors(kn.max,Yr.max),kn.expandByPoint(cn)):(kn.expandByPoint(Yr.min),kn.expandByPoint(Yr.max))}kn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)cn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(cn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)cn.fromBufferAttribute(a,c),l&&(lr.fromBufferAttribute(t,c),cn.add(lr)),s=Math.max(s,n.distanceToSquared(cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new ti(new Float32Array(4*n.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let U=0;U<n.count;U++)a[U]=new G,l[U]=new G;const c=new G,h=new G,u=new G,f=new le,p=new le,_=new le,v=new G,m=new G;function d(U,T,S){c.fromBufferAttribute(n,U),h.fromBufferAttribute(n,T),u.fromBufferAttribute(n,S),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,T),_.fromBufferAttribute(r,S),h.sub(c),u.sub(c),p.sub(f),_.sub(f);const C=1/(p.x*_.y-_.x*p.y);isFinite(C)&&(v.copy(h).multiplyScalar(_.y).addScaledVector(u,-p.y).multiplyScalar(C),m.copy(u).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(C),a[U].add(v),a[T].add(v),a[S].add(v),l[U].add(m),l[T].add(m),l[S].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let U=0,T=E.length;U<T;++U){const S=E[U],C=S.start,H=S.count;for(let N=C,V=C+H;N<V;N+=3)d(t.getX(N+0),t.getX(N+1),t.getX(N+2))}const w=new G,x=new G,I=new G,R=new G;function D(U){I.fromBufferAttribute(s,U),R.copy(I);const T=a[U];w.copy(T),w.sub(I.multiplyScalar(I.dot(T))).normalize(),x.crossVectors(R,T);const C=x.dot(l[U])<0?-1:1;o.setXYZW(U,w.x,w.y,w.z,C)}for(let U=0,T=E.length;U<T;++U){const S=E[U],C=S.start,H=S.count;for(let N=C,V=C+H;N<V;N+=3)D(t.getX(N+0)),D(t.getX(N+1)),D(t.getX(N+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new ti(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);const s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,h=new G,u=new G;if(t)for(let f=0,p=t.count;f<p;f+=3){const _=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=e.count;f<p;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)cn.fromBufferAttribute(t,e),cn.normalize(),t.setXYZ(e,cn.x,cn.y,cn.z)}toNonIndexed(){function t(a,l){const c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h);let p=0,_=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*h;for(let d=0;d<h;d++)f[_++]=c[p++]}return new ti(f,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new en,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,n);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){const f=c[h],p=t(f,n);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){const p=c[u];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone(e));const s=t.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(e))}const r=t.morphAttributes;for(const c in r){const h=[],u=r[c];for(let f=0,p=u.length;f<p;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,h=o.length;c<h;c++){const u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const tf=new ze,xs=new ou,No=new fo,ef=new G,Fo=new G,Oo=new G,ko=new G,Ml=new G,Bo=new G,nf=new G,zo=new G;class Tn extends Je{constructor(t=new en,e=new cs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){Bo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=a[l],u=r[l];h!==0&&(Ml.fromBufferAttribute(u,t),o?Bo.addScaledVector(Ml,h):Bo.addScaledVector(Ml.sub(e),h))}e.add(Bo)}return e}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),No.copy(n.boundingSphere),No.applyMatrix4(r),xs.copy(t.ray).recast(t.near),!(No.containsPoint(xs.origin)===!1&&(xs.intersectSphere(No,ef)===null||xs.origin.distanceToSquared(ef)>(t.far-t.near)**2))&&(tf.copy(r).invert(),xs.copy(t.ray).applyMatrix4(tf),!(n.boundingBox!==null&&xs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,xs)))}_computeIntersections(t,e,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){const m=f[_],d=o[m.materialIndex],E=Math.max(m.start,p.start),w=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let x=E,I=w;x<I;x+=3){const R=a.getX(x),D=a.getX(x+1),U=a.getX(x+2);s=Ho(this,d,t,n,c,h,u,R,D,U),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),v=Math.min(a.count,p.start+p.count);for(let m=_,d=v;m<d;m+=3){const E=a.getX(m),w=a.getX(m+1),x=a.getX(m+2);s=Ho(this,o,t,n,c,h,u,E,w,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){const m=f[_],d=o[m.materialIndex],E=Math.max(m.start,p.start),w=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let x=E,I=w;x<I;x+=3){const R=x,D=x+1,U=x+2;s=Ho(this,d,t,n,c,h,u,R,D,U),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),v=Math.min(l.count,p.start+p.count);for(let m=_,d=v;m<d;m+=3){const E=m,w=m+1,x=m+2;s=Ho(this,o,t,n,c,h,u,E,w,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function p0(i,t,e,n,s,r,o,a){let l;if(t.side===Ln?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===ls,a),l===null)return null;zo.copy(a),zo.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(zo);return c<e.near||c>e.far?null:{distance:c,point:zo.clone(),object:i}}function Ho(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Fo),i.getVertexPosition(l,Oo),i.getVertexPosition(c,ko);const h=p0(i,t,e,n,Fo,Oo,ko,nf);if(h){const u=new G;Jn.getBarycoord(nf,Fo,Oo,ko,u),s&&(h.uv=Jn.getInterpolatedAttribute(s,a,l,c,u,new le)),r&&(h.uv1=Jn.getInterpolatedAttribute(r,a,l,c,u,new le)),o&&(h.normal=Jn.getInterpolatedAttribute(o,a,l,c,u,new G),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new G,materialIndex:0};Jn.getNormal(Fo,Oo,ko,f.normal),h.face=f,h.barycoord=u}return h}class Nr extends en{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],h=[],u=[];let f=0,p=0;_("z","y","x",-1,-1,n,e,t,o,r,0),_("z","y","x",1,-1,n,e,-t,o,r,1),_("x","z","y",1,1,t,n,e,s,o,2),_("x","z","y",1,-1,t,n,-e,s,o,3),_("x","y","z",1,-1,t,e,n,s,r,4),_("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new He(c,3)),this.setAttribute("normal",new He(h,3)),this.setAttribute("uv",new He(u,2));function _(v,m,d,E,w,x,I,R,D,U,T){const S=x/D,C=I/U,H=x/2,N=I/2,V=R/2,j=D+1,K=U+1;let J=0,Q=0;const ht=new G;for(let ct=0;ct<K;ct++){const mt=ct*C-N;for(let Mt=0;Mt<j;Mt++){const pt=Mt*S-H;ht[v]=pt*E,ht[m]=mt*w,ht[d]=V,c.push(ht.x,ht.y,ht.z),ht[v]=0,ht[m]=0,ht[d]=R>0?1:-1,h.push(ht.x,ht.y,ht.z),u.push(Mt/D),u.push(1-ct/U),J+=1}}for(let ct=0;ct<U;ct++)for(let mt=0;mt<D;mt++){const Mt=f+mt+j*ct,pt=f+mt+j*(ct+1),nt=f+(mt+1)+j*(ct+1),at=f+(mt+1)+j*ct;l.push(Mt,pt,at),l.push(pt,nt,at),Q+=6}a.addGroup(p,Q,T),p+=Q,f+=J}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Nr(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function Rr(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function yn(i){const t={};for(let e=0;e<i.length;e++){const n=Rr(i[e]);for(const s in n)t[s]=n[s]}return t}function m0(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function cp(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ge.workingColorSpace}const g0={clone:Rr,merge:yn};var _0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,v0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class us extends ks{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=_0,this.fragmentShader=v0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Rr(t.uniforms),this.uniformsGroups=m0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}}class up extends Je{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ze,this.projectionMatrix=new ze,this.projectionMatrixInverse=new ze,this.coordinateSystem=Bi}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const es=new G,sf=new le,rf=new le;class zn extends up{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=Lc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(ca*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Lc*2*Math.atan(Math.tan(ca*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){es.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(es.x,es.y).multiplyScalar(-t/es.z),es.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(es.x,es.y).multiplyScalar(-t/es.z)}getViewSize(t,e){return this.getViewBounds(t,sf,rf),e.subVectors(rf,sf)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(ca*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const cr=-90,ur=1;class x0 extends Je{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new zn(cr,ur,t,e);s.layers=this.layers,this.add(s);const r=new zn(cr,ur,t,e);r.layers=this.layers,this.add(r);const o=new zn(cr,ur,t,e);o.layers=this.layers,this.add(o);const a=new zn(cr,ur,t,e);a.layers=this.layers,this.add(a);const l=new zn(cr,ur,t,e);l.layers=this.layers,this.add(l);const c=new zn(cr,ur,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===Bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ma)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;const v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=v,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(u,f,p),t.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class hp extends Dn{constructor(t,e,n,s,r,o,a,l,c,h){t=t!==void 0?t:[],e=e!==void 0?e:br,super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class M0 extends Fs{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new hp(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Ti}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Nr(5,5,5),r=new us({name:"CubemapFromEquirect",uniforms:Rr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ln,blending:rs});r.uniforms.tEquirect.value=e;const o=new Tn(s,r),a=e.minFilter;return e.minFilter===Ls&&(e.minFilter=Ti),new x0(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,n,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}}const Sl=new G,S0=new G,y0=new Qt;class Ts{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Sl.subVectors(n,e).cross(S0.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const n=t.delta(Sl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||y0.getNormalMatrix(t),s=this.coplanarPoint(Sl).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Ms=new fo,Vo=new G;class au{constructor(t=new Ts,e=new Ts,n=new Ts,s=new Ts,r=new Ts,o=new Ts){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Bi){const n=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],h=s[5],u=s[6],f=s[7],p=s[8],_=s[9],v=s[10],m=s[11],d=s[12],E=s[13],w=s[14],x=s[15];if(n[0].setComponents(l-r,f-c,m-p,x-d).normalize(),n[1].setComponents(l+r,f+c,m+p,x+d).normalize(),n[2].setComponents(l+o,f+h,m+_,x+E).normalize(),n[3].setComponents(l-o,f-h,m-_,x-E).normalize(),n[4].setComponents(l-a,f-u,m-v,x-w).normalize(),e===Bi)n[5].setComponents(l+a,f+u,m+v,x+w).normalize();else if(e===ma)n[5].setComponents(a,u,v,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ms.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ms.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ms)}intersectsSprite(t){return Ms.center.set(0,0,0),Ms.radius=.7071067811865476,Ms.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ms)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(Vo.x=s.normal.x>0?t.max.x:t.min.x,Vo.y=s.normal.y>0?t.max.y:t.min.y,Vo.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Vo)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function fp(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function E0(i){const t=new WeakMap;function e(a,l){const c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((p,_)=>p.start-_.start);let f=0;for(let p=1;p<u.length;p++){const _=u[f],v=u[p];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++f,u[f]=v)}u.length=f+1;for(let p=0,_=u.length;p<_;p++){const v=u[p];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class Da extends en{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,p=[],_=[],v=[],m=[];for(let d=0;d<h;d++){const E=d*f-o;for(let w=0;w<c;w++){const x=w*u-r;_.push(x,-E,0),v.push(0,0,1),m.push(w/a),m.push(1-d/l)}}for(let d=0;d<l;d++)for(let E=0;E<a;E++){const w=E+c*d,x=E+c*(d+1),I=E+1+c*(d+1),R=E+1+c*d;p.push(w,x,R),p.push(x,I,R)}this.setIndex(p),this.setAttribute("position",new He(_,3)),this.setAttribute("normal",new He(v,3)),this.setAttribute("uv",new He(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Da(t.width,t.height,t.widthSegments,t.heightSegments)}}var b0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,T0=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,w0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,A0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,R0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,C0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,P0=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,L0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,D0=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,U0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,I0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,N0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,F0=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,O0=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,k0=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,B0=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,z0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,H0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,V0=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,G0=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,W0=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,X0=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,$0=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,q0=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Y0=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,K0=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,j0=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Z0=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,J0=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Q0=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,tv="gl_FragColor = linearToOutputTexel( gl_FragColor );",ev=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,nv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,iv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,sv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,rv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ov=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,av=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,lv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,cv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,uv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,hv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,fv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,dv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,pv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,mv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,gv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,_v=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,vv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,xv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Mv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Sv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,yv=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Ev=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,bv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Tv=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,wv=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Av=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Rv=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Cv=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Pv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Lv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Dv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Uv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Iv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Nv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Fv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ov=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,kv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Bv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,zv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Hv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Vv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Gv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Wv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Xv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,$v=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,qv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Yv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Kv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,jv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Zv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Jv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,Qv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,tx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ex=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,nx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ix=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,sx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,rx=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,ox=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,ax=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,lx=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,cx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ux=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,hx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,fx=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,dx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,px=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,mx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,gx=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,_x=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,vx=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,xx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Mx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Sx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,yx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const Ex=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,bx=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Tx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wx=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ax=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Rx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Cx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Px=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Lx=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Dx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,Ux=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ix=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Nx=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Fx=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ox=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,kx=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Bx=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zx=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hx=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Vx=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Gx=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Wx=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Xx=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$x=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qx=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Yx=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Kx=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jx=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zx=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Jx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Qx=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,tM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,eM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,nM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ne={alphahash_fragment:b0,alphahash_pars_fragment:T0,alphamap_fragment:w0,alphamap_pars_fragment:A0,alphatest_fragment:R0,alphatest_pars_fragment:C0,aomap_fragment:P0,aomap_pars_fragment:L0,batching_pars_vertex:D0,batching_vertex:U0,begin_vertex:I0,beginnormal_vertex:N0,bsdfs:F0,iridescence_fragment:O0,bumpmap_pars_fragment:k0,clipping_planes_fragment:B0,clipping_planes_pars_fragment:z0,clipping_planes_pars_vertex:H0,clipping_planes_vertex:V0,color_fragment:G0,color_pars_fragment:W0,color_pars_vertex:X0,color_vertex:$0,common:q0,cube_uv_reflection_fragment:Y0,defaultnormal_vertex:K0,displacementmap_pars_vertex:j0,displacementmap_vertex:Z0,emissivemap_fragment:J0,emissivemap_pars_fragment:Q0,colorspace_fragment:tv,colorspace_pars_fragment:ev,envmap_fragment:nv,envmap_common_pars_fragment:iv,envmap_pars_fragment:sv,envmap_pars_vertex:rv,envmap_physical_pars_fragment:gv,envmap_vertex:ov,fog_vertex:av,fog_pars_vertex:lv,fog_fragment:cv,fog_pars_fragment:uv,gradientmap_pars_fragment:hv,lightmap_pars_fragment:fv,lights_lambert_fragment:dv,lights_lambert_pars_fragment:pv,lights_pars_begin:mv,lights_toon_fragment:_v,lights_toon_pars_fragment:vv,lights_phong_fragment:xv,lights_phong_pars_fragment:Mv,lights_physical_fragment:Sv,lights_physical_pars_fragment:yv,lights_fragment_begin:Ev,lights_fragment_maps:bv,lights_fragment_end:Tv,logdepthbuf_fragment:wv,logdepthbuf_pars_fragment:Av,logdepthbuf_pars_vertex:Rv,logdepthbuf_vertex:Cv,map_fragment:Pv,map_pars_fragment:Lv,map_particle_fragment:Dv,map_particle_pars_fragment:Uv,metalnessmap_fragment:Iv,metalnessmap_pars_fragment:Nv,morphinstance_vertex:Fv,morphcolor_vertex:Ov,morphnormal_vertex:kv,morphtarget_pars_vertex:Bv,morphtarget_vertex:zv,normal_fragment_begin:Hv,normal_fragment_maps:Vv,normal_pars_fragment:Gv,normal_pars_vertex:Wv,normal_vertex:Xv,normalmap_pars_fragment:$v,clearcoat_normal_fragment_begin:qv,clearcoat_normal_fragment_maps:Yv,clearcoat_pars_fragment:Kv,iridescence_pars_fragment:jv,opaque_fragment:Zv,packing:Jv,premultiplied_alpha_fragment:Qv,project_vertex:tx,dithering_fragment:ex,dithering_pars_fragment:nx,roughnessmap_fragment:ix,roughnessmap_pars_fragment:sx,shadowmap_pars_fragment:rx,shadowmap_pars_vertex:ox,shadowmap_vertex:ax,shadowmask_pars_fragment:lx,skinbase_vertex:cx,skinning_pars_vertex:ux,skinning_vertex:hx,skinnormal_vertex:fx,specularmap_fragment:dx,specularmap_pars_fragment:px,tonemapping_fragment:mx,tonemapping_pars_fragment:gx,transmission_fragment:_x,transmission_pars_fragment:vx,uv_pars_fragment:xx,uv_pars_vertex:Mx,uv_vertex:Sx,worldpos_vertex:yx,background_vert:Ex,background_frag:bx,backgroundCube_vert:Tx,backgroundCube_frag:wx,cube_vert:Ax,cube_frag:Rx,depth_vert:Cx,depth_frag:Px,distanceRGBA_vert:Lx,distanceRGBA_frag:Dx,equirect_vert:Ux,equirect_frag:Ix,linedashed_vert:Nx,linedashed_frag:Fx,meshbasic_vert:Ox,meshbasic_frag:kx,meshlambert_vert:Bx,meshlambert_frag:zx,meshmatcap_vert:Hx,meshmatcap_frag:Vx,meshnormal_vert:Gx,meshnormal_frag:Wx,meshphong_vert:Xx,meshphong_frag:$x,meshphysical_vert:qx,meshphysical_frag:Yx,meshtoon_vert:Kx,meshtoon_frag:jx,points_vert:Zx,points_frag:Jx,shadow_vert:Qx,shadow_frag:tM,sprite_vert:eM,sprite_frag:nM},bt={common:{diffuse:{value:new fe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qt}},envmap:{envMap:{value:null},envMapRotation:{value:new Qt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qt},normalScale:{value:new le(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new fe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new fe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0},uvTransform:{value:new Qt}},sprite:{diffuse:{value:new fe(16777215)},opacity:{value:1},center:{value:new le(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}}},bi={basic:{uniforms:yn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:ne.meshbasic_vert,fragmentShader:ne.meshbasic_frag},lambert:{uniforms:yn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new fe(0)}}]),vertexShader:ne.meshlambert_vert,fragmentShader:ne.meshlambert_frag},phong:{uniforms:yn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new fe(0)},specular:{value:new fe(1118481)},shininess:{value:30}}]),vertexShader:ne.meshphong_vert,fragmentShader:ne.meshphong_frag},standard:{uniforms:yn([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new fe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag},toon:{uniforms:yn([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new fe(0)}}]),vertexShader:ne.meshtoon_vert,fragmentShader:ne.meshtoon_frag},matcap:{uniforms:yn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:ne.meshmatcap_vert,fragmentShader:ne.meshmatcap_frag},points:{uniforms:yn([bt.points,bt.fog]),vertexShader:ne.points_vert,fragmentShader:ne.points_frag},dashed:{uniforms:yn([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ne.linedashed_vert,fragmentShader:ne.linedashed_frag},depth:{uniforms:yn([bt.common,bt.displacementmap]),vertexShader:ne.depth_vert,fragmentShader:ne.depth_frag},normal:{uniforms:yn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:ne.meshnormal_vert,fragmentShader:ne.meshnormal_frag},sprite:{uniforms:yn([bt.sprite,bt.fog]),vertexShader:ne.sprite_vert,fragmentShader:ne.sprite_frag},background:{uniforms:{uvTransform:{value:new Qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ne.background_vert,fragmentShader:ne.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qt}},vertexShader:ne.backgroundCube_vert,fragmentShader:ne.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ne.cube_vert,fragmentShader:ne.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ne.equirect_vert,fragmentShader:ne.equirect_frag},distanceRGBA:{uniforms:yn([bt.common,bt.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ne.distanceRGBA_vert,fragmentShader:ne.distanceRGBA_frag},shadow:{uniforms:yn([bt.lights,bt.fog,{color:{value:new fe(0)},opacity:{value:1}}]),vertexShader:ne.shadow_vert,fragmentShader:ne.shadow_frag}};bi.physical={uniforms:yn([bi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qt},clearcoatNormalScale:{value:new le(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qt},sheen:{value:0},sheenColor:{value:new fe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qt},transmissionSamplerSize:{value:new le},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qt},attenuationDistance:{value:0},attenuationColor:{value:new fe(0)},specularColor:{value:new fe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qt},anisotropyVector:{value:new le},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qt}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag};const Go={r:0,b:0,g:0},Ss=new wi,iM=new ze;function sM(i,t,e,n,s,r,o){const a=new fe(0);let l=r===!0?0:1,c,h,u=null,f=0,p=null;function _(E){let w=E.isScene===!0?E.background:null;return w&&w.isTexture&&(w=(E.backgroundBlurriness>0?e:t).get(w)),w}function v(E){let w=!1;const x=_(E);x===null?d(a,l):x&&x.isColor&&(d(x,1),w=!0);const I=i.xr.getEnvironmentBlendMode();I==="additive"?n.buffers.color.setClear(0,0,0,1,o):I==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||w)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(E,w){const x=_(w);x&&(x.isCubeTexture||x.mapping===Pa)?(h===void 0&&(h=new Tn(new Nr(1,1,1),new us({name:"BackgroundCubeMaterial",uniforms:Rr(bi.backgroundCube.uniforms),vertexShader:bi.backgroundCube.vertexShader,fragmentShader:bi.backgroundCube.fragmentShader,side:Ln,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(I,R,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Ss.copy(w.backgroundRotation),Ss.x*=-1,Ss.y*=-1,Ss.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(Ss.y*=-1,Ss.z*=-1),h.material.uniforms.envMap.value=x,h.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(iM.makeRotationFromEuler(Ss)),h.material.toneMapped=ge.getTransfer(x.colorSpace)!==we,(u!==x||f!==x.version||p!==i.toneMapping)&&(h.material.needsUpdate=!0,u=x,f=x.version,p=i.toneMapping),h.layers.enableAll(),E.unshift(h,h.geometry,h.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new Tn(new Da(2,2),new us({name:"BackgroundMaterial",uniforms:Rr(bi.background.uniforms),vertexShader:bi.background.vertexShader,fragmentShader:bi.background.fragmentShader,side:ls,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.toneMapped=ge.getTransfer(x.colorSpace)!==we,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||f!==x.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,u=x,f=x.version,p=i.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function d(E,w){E.getRGB(Go,cp(i)),n.buffers.color.setClear(Go.r,Go.g,Go.b,w,o)}return{getClearColor:function(){return a},setClearColor:function(E,w=1){a.set(E),l=w,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,d(a,l)},render:v,addToRenderList:m}}function rM(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null);let r=s,o=!1;function a(S,C,H,N,V){let j=!1;const K=u(N,H,C);r!==K&&(r=K,c(r.object)),j=p(S,N,H,V),j&&_(S,N,H,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(j||o)&&(o=!1,x(S,C,H,N),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function h(S){return i.deleteVertexArray(S)}function u(S,C,H){const N=H.wireframe===!0;let V=n[S.id];V===void 0&&(V={},n[S.id]=V);let j=V[C.id];j===void 0&&(j={},V[C.id]=j);let K=j[N];return K===void 0&&(K=f(l()),j[N]=K),K}function f(S){const C=[],H=[],N=[];for(let V=0;V<e;V++)C[V]=0,H[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:H,attributeDivisors:N,object:S,attributes:{},index:null}}function p(S,C,H,N){const V=r.attributes,j=C.attributes;let K=0;const J=H.getAttributes();for(const Q in J)if(J[Q].location>=0){const ct=V[Q];let mt=j[Q];if(mt===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;K++}return r.attributesNum!==K||r.index!==N}function _(S,C,H,N){const V={},j=C.attributes;let K=0;const J=H.getAttributes();for(const Q in J)if(J[Q].location>=0){let ct=j[Q];ct===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),V[Q]=mt,K++}r.attributes=V,r.attributesNum=K,r.index=N}function v(){const S=r.newAttributes;for(let C=0,H=S.length;C<H;C++)S[C]=0}function m(S){d(S,0)}function d(S,C){const H=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;H[S]=1,N[S]===0&&(i.enableVertexAttribArray(S),N[S]=1),V[S]!==C&&(i.vertexAttribDivisor(S,C),V[S]=C)}function E(){const S=r.newAttributes,C=r.enabledAttributes;for(let H=0,N=C.length;H<N;H++)C[H]!==S[H]&&(i.disableVertexAttribArray(H),C[H]=0)}function w(S,C,H,N,V,j,K){K===!0?i.vertexAttribIPointer(S,C,H,V,j):i.vertexAttribPointer(S,C,H,N,V,j)}function x(S,C,H,N){v();const V=N.attributes,j=H.getAttributes(),K=C.defaultAttributeValues;for(const J in j){const Q=j[J];if(Q.location>=0){let ht=V[J];if(ht===void 0&&(J==="instanceMatrix"&&S.instanceMatrix&&(ht=S.instanceMatrix),J==="instanceColor"&&S.instanceColor&&(ht=S.instanceColor)),ht!==void 0){const ct=ht.normalized,mt=ht.itemSize,Mt=t.get(ht);if(Mt===void 0)continue;const pt=Mt.buffer,nt=Mt.type,at=Mt.bytesPerElement,gt=nt===i.INT||nt===i.UNSIGNED_INT||ht.gpuType===tu;if(ht.isInterleavedBufferAttribute){const ot=ht.data,Bt=ot.stride,Ht=ht.offset;if(ot.isInstancedInterleavedBuffer){for(let It=0;It<Q.locationSize;It++)d(Q.location+It,ot.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let It=0;It<Q.locationSize;It++)m(Q.location+It);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let It=0;It<Q.locationSize;It++)w(Q.location+It,mt/Q.locationSize,nt,ct,Bt*at,(Ht+mt/Q.locationSize*It)*at,gt)}else{if(ht.isInstancedBufferAttribute){for(let ot=0;ot<Q.locationSize;ot++)d(Q.location+ot,ht.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ot=0;ot<Q.locationSize;ot++)m(Q.location+ot);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let ot=0;ot<Q.locationSize;ot++)w(Q.location+ot,mt/Q.locationSize,nt,ct,mt*at,mt/Q.locationSize*ot*at,gt)}}else if(K!==void 0){const ct=K[J];if(ct!==void 0)switch(ct.length){case 2:i.vertexAttrib2fv(Q.location,ct);break;case 3:i.vertexAttrib3fv(Q.location,ct);break;case 4:i.vertexAttrib4fv(Q.location,ct);break;default:i.vertexAttrib1fv(Q.location,ct)}}}}E()}function I(){U();for(const S in n){const C=n[S];for(const H in C){const N=C[H];for(const V in N)h(N[V].object),delete N[V];delete C[H]}delete n[S]}}function R(S){if(n[S.id]===void 0)return;const C=n[S.id];for(const H in C){const N=C[H];for(const V in N)h(N[V].object),delete N[V];delete C[H]}delete n[S.id]}function D(S){for(const C in n){const H=n[C];if(H[S.id]===void 0)continue;const N=H[S.id];for(const V in N)h(N[V].object),delete N[V];delete H[S.id]}}function U(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:T,dispose:I,releaseStatesOfGeometry:R,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:E}}function oM(i,t,e){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),e.update(h,n,1)}function o(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),e.update(h,n,u))}function a(c,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let p=0;for(let _=0;_<u;_++)p+=h[_];e.update(p,n,1)}function l(c,h,u,f){if(u===0)return;const p=t.get("WEBGL_multi_draw");if(p===null)for(let _=0;_<c.length;_++)o(c[_],h[_],f[_]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,h,0,f,0,u);let _=0;for(let v=0;v<u;v++)_+=h[v]*f[v];e.update(_,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function aM(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==di&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const U=D===lo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Wi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==ki&&!U)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),E=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),w=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),I=_>0,R=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:f,maxTextures:p,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:E,maxVaryings:w,maxFragmentUniforms:x,vertexTextures:I,maxSamples:R}}function lM(i){const t=this;let e=null,n=0,s=!1,r=!1;const o=new Ts,a=new Qt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){const p=u.length!==0||f||n!==0||s;return s=f,n=u.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,p){const _=u.clippingPlanes,v=u.clipIntersection,m=u.clipShadows,d=i.get(u);if(!s||_===null||_.length===0||r&&!m)r?h(null):c();else{const E=r?0:n,w=E*4;let x=d.clippingState||null;l.value=x,x=h(_,f,w,p);for(let I=0;I!==w;++I)x[I]=e[I];d.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=E}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,p,_){const v=u!==null?u.length:0;let m=null;if(v!==0){if(m=l.value,_!==!0||m===null){const d=p+v*4,E=f.matrixWorldInverse;a.getNormalMatrix(E),(m===null||m.length<d)&&(m=new Float32Array(d));for(let w=0,x=p;w!==v;++w,x+=4)o.copy(u[w]).applyMatrix4(E,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function cM(i){let t=new WeakMap;function e(o,a){return a===ec?o.mapping=br:a===nc&&(o.mapping=Tr),o}function n(o){if(o&&o.isTexture){const a=o.mapping;if(a===ec||a===nc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new M0(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}class lu extends up{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const dr=4,of=[.125,.215,.35,.446,.526,.582],Cs=20,yl=new lu,af=new fe;let El=null,bl=0,Tl=0,wl=!1;const ws=(1+Math.sqrt(5))/2,hr=1/ws,lf=[new G(-ws,hr,0),new G(ws,hr,0),new G(-hr,0,ws),new G(hr,0,ws),new G(0,ws,-hr),new G(0,ws,hr),new G(-1,1,-1),new G(1,1,-1),new G(-1,1,1),new G(1,1,1)];class cf{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){El=this._renderer.getRenderTarget(),bl=this._renderer.getActiveCubeFace(),Tl=this._renderer.getActiveMipmapLevel(),wl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,n,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ff(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=hf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(El,bl,Tl),this._renderer.xr.enabled=wl,t.scissorTest=!1,Wo(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===br||t.mapping===Tr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),El=this._renderer.getRenderTarget(),bl=this._renderer.getActiveCubeFace(),Tl=this._renderer.getActiveMipmapLevel(),wl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:Ti,minFilter:Ti,generateMipmaps:!1,type:lo,format:di,colorSpace:Ur,depthBuffer:!1},s=uf(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=uf(t,e,n);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=uM(r)),this._blurMaterial=hM(r,t,e)}return s}_compileMaterial(t){const e=new Tn(this._lodPlanes[0],t);this._renderer.compile(e,yl)}_sceneToCubeUV(t,e,n,s){const a=new zn(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,f=h.toneMapping;h.getClearColor(af),h.toneMapping=os,h.autoClear=!1;const p=new cs({name:"PMREM.Background",side:Ln,depthWrite:!1,depthTest:!1}),_=new Tn(new Nr,p);let v=!1;const m=t.background;m?m.isColor&&(p.color.copy(m),t.background=null,v=!0):(p.color.copy(af),v=!0);for(let d=0;d<6;d++){const E=d%3;E===0?(a.up.set(0,l[d],0),a.lookAt(c[d],0,0)):E===1?(a.up.set(0,0,l[d]),a.lookAt(0,c[d],0)):(a.up.set(0,l[d],0),a.lookAt(0,0,c[d]));const w=this._cubeSize;Wo(s,E*w,d>2?w:0,w,w),h.setRenderTarget(s),v&&h.render(_,a),h.render(t,a)}_.geometry.dispose(),_.material.dispose(),h.toneMapping=f,h.autoClear=u,t.background=m}_textureToCubeUV(t,e){const n=this._renderer,s=t.mapping===br||t.mapping===Tr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=ff()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=hf());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new Tn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;Wo(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,yl)}_applyPMREM(t){const e=this._renderer,n=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=lf[(s-r-1)%lf.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new Tn(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[n]-1,_=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*Cs-1),v=r/_,m=isFinite(r)?1+Math.floor(h*v):Cs;m>Cs&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Cs}`);const d=[];let E=0;for(let D=0;D<Cs;++D){const U=D/v,T=Math.exp(-U*U/2);d.push(T),D===0?E+=T:D<m&&(E+=2*T)}for(let D=0;D<d.length;D++)d[D]=d[D]/E;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:w}=this;f.dTheta.value=_,f.mipInt.value=w-n;const x=this._sizeLods[s],I=3*x*(s>w-dr?s-w+dr:0),R=4*(this._cubeSize-x);Wo(e,I,R,3*x,2*x),l.setRenderTarget(e),l.render(u,yl)}}function uM(i){const t=[],e=[],n=[];let s=i;const r=i-dr+1+of.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>i-dr?l=of[o-i+dr-1]:o===0&&(l=0),n.push(l);const c=1/(a-2),h=-c,u=1+c,f=[h,h,u,h,u,u,h,h,u,u,h,u],p=6,_=6,v=3,m=2,d=1,E=new Float32Array(v*_*p),w=new Float32Array(m*_*p),x=new Float32Array(d*_*p);for(let R=0;R<p;R++){const D=R%3*2/3-1,U=R>2?0:-1,T=[D,U,0,D+2/3,U,0,D+2/3,U+1,0,D,U,0,D+2/3,U+1,0,D,U+1,0];E.set(T,v*_*R),w.set(f,m*_*R);const S=[R,R,R,R,R,R];x.set(S,d*_*R)}const I=new en;I.setAttribute("position",new ti(E,v)),I.setAttribute("uv",new ti(w,m)),I.setAttribute("faceIndex",new ti(x,d)),t.push(I),s>dr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function uf(i,t,e){const n=new Fs(i,t,e);return n.texture.mapping=Pa,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Wo(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function hM(i,t,e){const n=new Float32Array(Cs),s=new G(0,1,0);return new us({name:"SphericalGaussianBlur",defines:{n:Cs,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:cu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:rs,depthTest:!1,depthWrite:!1})}function hf(){return new us({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:cu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:rs,depthTest:!1,depthWrite:!1})}function ff(){return new us({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:cu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:rs,depthTest:!1,depthWrite:!1})}function cu(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function fM(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===ec||l===nc,h=l===br||l===Tr;if(c||h){let u=t.get(a);const f=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new cf(i)),u=c?e.fromEquirectangular(a,u):e.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),u.texture;if(u!==void 0)return u.texture;{const p=a.image;return c&&p&&p.height>0||h&&p&&s(p)?(e===null&&(e=new cf(i)),u=c?e.fromEquirectangular(a):e.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0;const c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function dM(i){const t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&to("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function pM(i,t,e,n){const s={},r=new WeakMap;function o(u){const f=u.target;f.index!==null&&t.remove(f.index);for(const _ in f.attributes)t.remove(f.attributes[_]);for(const _ in f.morphAttributes){const v=f.morphAttributes[_];for(let m=0,d=v.length;m<d;m++)t.remove(v[m])}f.removeEventListener("dispose",o),delete s[f.id];const p=r.get(f);p&&(t.remove(p),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(u,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(u){const f=u.attributes;for(const _ in f)t.update(f[_],i.ARRAY_BUFFER);const p=u.morphAttributes;for(const _ in p){const v=p[_];for(let m=0,d=v.length;m<d;m++)t.update(v[m],i.ARRAY_BUFFER)}}function c(u){const f=[],p=u.index,_=u.attributes.position;let v=0;if(p!==null){const E=p.array;v=p.version;for(let w=0,x=E.length;w<x;w+=3){const I=E[w+0],R=E[w+1],D=E[w+2];f.push(I,R,R,D,D,I)}}else if(_!==void 0){const E=_.array;v=_.version;for(let w=0,x=E.length/3-1;w<x;w+=3){const I=w+0,R=w+1,D=w+2;f.push(I,R,R,D,D,I)}}else return;const m=new(np(f)?lp:ap)(f,1);m.version=v;const d=r.get(u);d&&t.remove(d),r.set(u,m)}function h(u){const f=r.get(u);if(f){const p=u.index;p!==null&&f.version<p.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function mM(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,p){i.drawElements(n,p,r,f*o),e.update(p,n,1)}function c(f,p,_){_!==0&&(i.drawElementsInstanced(n,p,r,f*o,_),e.update(p,n,_))}function h(f,p,_){if(_===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,r,f,0,_);let m=0;for(let d=0;d<_;d++)m+=p[d];e.update(m,n,1)}function u(f,p,_,v){if(_===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let d=0;d<f.length;d++)c(f[d]/o,p[d],v[d]);else{m.multiDrawElementsInstancedWEBGL(n,p,0,r,f,0,v,0,_);let d=0;for(let E=0;E<_;E++)d+=p[E]*v[E];e.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function gM(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function _M(i,t,e){const n=new WeakMap,s=new We;function r(o,a,l){const c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0;let f=n.get(a);if(f===void 0||f.count!==u){let T=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",T)};f!==void 0&&f.texture.dispose();const p=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],E=a.morphAttributes.color||[];let w=0;p===!0&&(w=1),_===!0&&(w=2),v===!0&&(w=3);let x=a.attributes.position.count*w,I=1;x>t.maxTextureSize&&(I=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);const R=new Float32Array(x*I*4*u),D=new sp(R,x,I,u);D.type=ki,D.needsUpdate=!0;const U=w*4;for(let S=0;S<u;S++){const C=m[S],H=d[S],N=E[S],V=x*I*4*S;for(let j=0;j<C.count;j++){const K=j*U;p===!0&&(s.fromBufferAttribute(C,j),R[V+K+0]=s.x,R[V+K+1]=s.y,R[V+K+2]=s.z,R[V+K+3]=0),_===!0&&(s.fromBufferAttribute(H,j),R[V+K+4]=s.x,R[V+K+5]=s.y,R[V+K+6]=s.z,R[V+K+7]=0),v===!0&&(s.fromBufferAttribute(N,j),R[V+K+8]=s.x,R[V+K+9]=s.y,R[V+K+10]=s.z,R[V+K+11]=N.itemSize===4?s.w:1)}}f={count:u,texture:D,size:new le(x,I)},n.set(a,f),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let p=0;for(let v=0;v<c.length;v++)p+=c[v];const _=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",_),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function vM(i,t,e,n){let s=new WeakMap;function r(l){const c=n.render.frame,h=l.geometry,u=t.get(l,h);if(s.get(u)!==c&&(t.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return u}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class dp extends Dn{constructor(t,e,n,s,r,o,a,l,c,h=gr){if(h!==gr&&h!==Ar)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===gr&&(n=Ns),n===void 0&&h===Ar&&(n=wr),super(null,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:mi,this.minFilter=l!==void 0?l:mi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const pp=new Dn,df=new dp(1,1),mp=new sp,gp=new s0,_p=new hp,pf=[],mf=[],gf=new Float32Array(16),_f=new Float32Array(9),vf=new Float32Array(4);function Fr(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=pf[s];if(r===void 0&&(r=new Float32Array(s),pf[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Qe(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function tn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Ua(i,t){let e=mf[t];e===void 0&&(e=new Int32Array(t),mf[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function xM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function MM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Qe(e,t))return;i.uniform2fv(this.addr,t),tn(e,t)}}function SM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Qe(e,t))return;i.uniform3fv(this.addr,t),tn(e,t)}}function yM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Qe(e,t))return;i.uniform4fv(this.addr,t),tn(e,t)}}function EM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(Qe(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),tn(e,t)}else{if(Qe(e,n))return;vf.set(n),i.uniformMatrix2fv(this.addr,!1,vf),tn(e,n)}}function bM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(Qe(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),tn(e,t)}else{if(Qe(e,n))return;_f.set(n),i.uniformMatrix3fv(this.addr,!1,_f),tn(e,n)}}function TM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(Qe(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),tn(e,t)}else{if(Qe(e,n))return;gf.set(n),i.uniformMatrix4fv(this.addr,!1,gf),tn(e,n)}}function wM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function AM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Qe(e,t))return;i.uniform2iv(this.addr,t),tn(e,t)}}function RM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Qe(e,t))return;i.uniform3iv(this.addr,t),tn(e,t)}}function CM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Qe(e,t))return;i.uniform4iv(this.addr,t),tn(e,t)}}function PM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function LM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Qe(e,t))return;i.uniform2uiv(this.addr,t),tn(e,t)}}function DM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Qe(e,t))return;i.uniform3uiv(this.addr,t),tn(e,t)}}function UM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Qe(e,t))return;i.uniform4uiv(this.addr,t),tn(e,t)}}function IM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(df.compareFunction=ep,r=df):r=pp,e.setTexture2D(t||r,s)}function NM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||gp,s)}function FM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||_p,s)}function OM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||mp,s)}function kM(i){switch(i){case 5126:return xM;case 35664:return MM;case 35665:return SM;case 35666:return yM;case 35674:return EM;case 35675:return bM;case 35676:return TM;case 5124:case 35670:return wM;case 35667:case 35671:return AM;case 35668:case 35672:return RM;case 35669:case 35673:return CM;case 5125:return PM;case 36294:return LM;case 36295:return DM;case 36296:return UM;case 35678:case 36198:case 36298:case 36306:case 35682:return IM;case 35679:case 36299:case 36307:return NM;case 35680:case 36300:case 36308:case 36293:return FM;case 36289:case 36303:case 36311:case 36292:return OM}}function BM(i,t){i.uniform1fv(this.addr,t)}function zM(i,t){const e=Fr(t,this.size,2);i.uniform2fv(this.addr,e)}function HM(i,t){const e=Fr(t,this.size,3);i.uniform3fv(this.addr,e)}function VM(i,t){const e=Fr(t,this.size,4);i.uniform4fv(this.addr,e)}function GM(i,t){const e=Fr(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function WM(i,t){const e=Fr(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function XM(i,t){const e=Fr(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function $M(i,t){i.uniform1iv(this.addr,t)}function qM(i,t){i.uniform2iv(this.addr,t)}function YM(i,t){i.uniform3iv(this.addr,t)}function KM(i,t){i.uniform4iv(this.addr,t)}function jM(i,t){i.uniform1uiv(this.addr,t)}function ZM(i,t){i.uniform2uiv(this.addr,t)}function JM(i,t){i.uniform3uiv(this.addr,t)}function QM(i,t){i.uniform4uiv(this.addr,t)}function tS(i,t,e){const n=this.cache,s=t.length,r=Ua(e,s);Qe(n,r)||(i.uniform1iv(this.addr,r),tn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||pp,r[o])}function eS(i,t,e){const n=this.cache,s=t.length,r=Ua(e,s);Qe(n,r)||(i.uniform1iv(this.addr,r),tn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||gp,r[o])}function nS(i,t,e){const n=this.cache,s=t.length,r=Ua(e,s);Qe(n,r)||(i.uniform1iv(this.addr,r),tn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||_p,r[o])}function iS(i,t,e){const n=this.cache,s=t.length,r=Ua(e,s);Qe(n,r)||(i.uniform1iv(this.addr,r),tn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||mp,r[o])}function sS(i){switch(i){case 5126:return BM;case 35664:return zM;case 35665:return HM;case 35666:return VM;case 35674:return GM;case 35675:return WM;case 35676:return XM;case 5124:case 35670:return $M;case 35667:case 35671:return qM;case 35668:case 35672:return YM;case 35669:case 35673:return KM;case 5125:return jM;case 36294:return ZM;case 36295:return JM;case 36296:return QM;case 35678:case 36198:case 36298:case 36306:case 35682:return tS;case 35679:case 36299:case 36307:return eS;case 35680:case 36300:case 36308:case 36293:return nS;case 36289:case 36303:case 36311:case 36292:return iS}}class rS{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=kM(e.type)}}class oS{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=sS(e.type)}}class aS{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],n)}}}const Al=/(\w+)(\])?(\[|\.)?/g;function xf(i,t){i.seq.push(t),i.map[t.id]=t}function lS(i,t,e){const n=i.name,s=n.length;for(Al.lastIndex=0;;){const r=Al.exec(n),o=Al.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){xf(e,c===void 0?new rS(a,i,t):new oS(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new aS(a),xf(e,u)),e=u}}}class ua{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);lS(r,o,this)}}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&n.push(o)}return n}}function Mf(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const cS=37297;let uS=0;function hS(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}const Sf=new Qt;function fS(i){ge._getMatrix(Sf,ge.workingColorSpace,i);const t=`mat3( ${Sf.elements.map(e=>e.toFixed(4))} )`;switch(ge.getTransfer(i)){case La:return[t,"LinearTransferOETF"];case we:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function yf(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+hS(i.getShaderSource(t),o)}else return s}function dS(i,t){const e=fS(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function pS(i,t){let e;switch(t){case L_:e="Linear";break;case D_:e="Reinhard";break;case U_:e="Cineon";break;case I_:e="ACESFilmic";break;case F_:e="AgX";break;case O_:e="Neutral";break;case N_:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const Xo=new G;function mS(){ge.getLuminanceCoefficients(Xo);const i=Xo.x.toFixed(4),t=Xo.y.toFixed(4),e=Xo.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function gS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(eo).join(`
`)}function _S(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function vS(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function eo(i){return i!==""}function Ef(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function bf(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const xS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Dc(i){return i.replace(xS,SS)}const MS=new Map;function SS(i,t){let e=ne[t];if(e===void 0){const n=MS.get(t);if(n!==void 0)e=ne[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return Dc(e)}const yS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Tf(i){return i.replace(yS,ES)}function ES(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function wf(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function bS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Vd?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===u_?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Fi&&(t="SHADOWMAP_TYPE_VSM"),t}function TS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case br:case Tr:t="ENVMAP_TYPE_CUBE";break;case Pa:t="ENVMAP_TYPE_CUBE_UV";break}return t}function wS(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Tr:t="ENVMAP_MODE_REFRACTION";break}return t}function AS(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Qc:t="ENVMAP_BLENDING_MULTIPLY";break;case C_:t="ENVMAP_BLENDING_MIX";break;case P_:t="ENVMAP_BLENDING_ADD";break}return t}function RS(i){const t=i.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function CS(i,t,e,n){const s=i.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=bS(e),c=TS(e),h=wS(e),u=AS(e),f=RS(e),p=gS(e),_=_S(r),v=s.createProgram();let m,d,E=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(eo).join(`
`),m.length>0&&(m+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(eo).join(`
`),d.length>0&&(d+=`
`)):(m=[wf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(eo).join(`
`),d=[wf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==os?"#define TONE_MAPPING":"",e.toneMapping!==os?ne.tonemapping_pars_fragment:"",e.toneMapping!==os?pS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ne.colorspace_pars_fragment,dS("linearToOutputTexel",e.outputColorSpace),mS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(eo).join(`
`)),o=Dc(o),o=Ef(o,e),o=bf(o,e),a=Dc(a),a=Ef(a,e),a=bf(a,e),o=Tf(o),a=Tf(a),e.isRawShaderMaterial!==!0&&(E=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,d=["#define varying in",e.glslVersion===kh?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===kh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);const w=E+m+o,x=E+d+a,I=Mf(s,s.VERTEX_SHADER,w),R=Mf(s,s.FRAGMENT_SHADER,x);s.attachShader(v,I),s.attachShader(v,R),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(i.debug.checkShaderErrors){const H=s.getProgramInfoLog(v).trim(),N=s.getShaderInfoLog(I).trim(),V=s.getShaderInfoLog(R).trim();let j=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(j=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,I,R);else{const J=yf(s,I,"vertex"),Q=yf(s,R,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+H+`
`+J+`
`+Q)}else H!==""?console.warn("THREE.WebGLProgram: Program Info Log:",H):(N===""||V==="")&&(K=!1);K&&(C.diagnostics={runnable:j,programLog:H,vertexShader:{log:N,prefix:m},fragmentShader:{log:V,prefix:d}})}s.deleteShader(I),s.deleteShader(R),U=new ua(s,v),T=vS(s,v)}let U;this.getUniforms=function(){return U===void 0&&D(this),U};let T;this.getAttributes=function(){return T===void 0&&D(this),T};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,cS)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=uS++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=I,this.fragmentShader=R,this}let PS=0;class LS{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new DS(t),e.set(t,n)),n}}class DS{constructor(t){this.id=PS++,this.code=t,this.usedTimes=0}}function US(i,t,e,n,s,r,o){const a=new rp,l=new LS,c=new Set,h=[],u=s.logarithmicDepthBuffer,f=s.vertexTextures;let p=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,S,C,H,N){const V=H.fog,j=N.geometry,K=T.isMeshStandardMaterial?H.environment:null,J=(T.isMeshStandardMaterial?e:t).get(T.envMap||K),Q=J&&J.mapping===Pa?J.image.height:null,ht=_[T.type];T.precision!==null&&(p=s.getMaxPrecision(T.precision),p!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",p,"instead."));const ct=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mt=ct!==void 0?ct.length:0;let Mt=0;j.morphAttributes.position!==void 0&&(Mt=1),j.morphAttributes.normal!==void 0&&(Mt=2),j.morphAttributes.color!==void 0&&(Mt=3);let pt,nt,at,gt;if(ht){const xe=bi[ht];pt=xe.vertexShader,nt=xe.fragmentShader}else pt=T.vertexShader,nt=T.fragmentShader,l.update(T),at=l.getVertexShaderID(T),gt=l.getFragmentShaderID(T);const ot=i.getRenderTarget(),Bt=i.state.buffers.depth.getReversed(),Ht=N.isInstancedMesh===!0,It=N.isBatchedMesh===!0,ce=!!T.map,jt=!!T.matcap,ue=!!J,B=!!T.aoMap,Ye=!!T.lightMap,Jt=!!T.bumpMap,ee=!!T.normalMap,Vt=!!T.displacementMap,de=!!T.emissiveMap,Pt=!!T.metalnessMap,P=!!T.roughnessMap,y=T.anisotropy>0,Y=T.clearcoat>0,Z=T.dispersion>0,W=T.iridescence>0,tt=T.sheen>0,St=T.transmission>0,_t=y&&!!T.anisotropyMap,Tt=Y&&!!T.clearcoatMap,Kt=Y&&!!T.clearcoatNormalMap,ft=Y&&!!T.clearcoatRoughnessMap,vt=W&&!!T.iridescenceMap,Nt=W&&!!T.iridescenceThicknessMap,Ot=tt&&!!T.sheenColorMap,Et=tt&&!!T.sheenRoughnessMap,ie=!!T.specularMap,qt=!!T.specularColorMap,pe=!!T.specularIntensityMap,k=St&&!!T.transmissionMap,xt=St&&!!T.thicknessMap,et=!!T.gradientMap,rt=!!T.alphaMap,wt=T.alphaTest>0,At=!!T.alphaHash,Zt=!!T.extensions;let Oe=os;T.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Oe=i.toneMapping);const nn={shaderID:ht,shaderType:T.type,shaderName:T.name,vertexShader:pt,fragmentShader:nt,defines:T.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:p,batching:It,batchingColor:It&&N._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&N.instanceColor!==null,instancingMorph:Ht&&N.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ot===null?i.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:Ur,alphaToCoverage:!!T.alphaToCoverage,map:ce,matcap:jt,envMap:ue,envMapMode:ue&&J.mapping,envMapCubeUVHeight:Q,aoMap:B,lightMap:Ye,bumpMap:Jt,normalMap:ee,displacementMap:f&&Vt,emissiveMap:de,normalMapObjectSpace:ee&&T.normalMapType===H_,normalMapTangentSpace:ee&&T.normalMapType===tp,metalnessMap:Pt,roughnessMap:P,anisotropy:y,anisotropyMap:_t,clearcoat:Y,clearcoatMap:Tt,clearcoatNormalMap:Kt,clearcoatRoughnessMap:ft,dispersion:Z,iridescence:W,iridescenceMap:vt,iridescenceThicknessMap:Nt,sheen:tt,sheenColorMap:Ot,sheenRoughnessMap:Et,specularMap:ie,specularColorMap:qt,specularIntensityMap:pe,transmission:St,transmissionMap:k,thicknessMap:xt,gradientMap:et,opaque:T.transparent===!1&&T.blending===mr&&T.alphaToCoverage===!1,alphaMap:rt,alphaTest:wt,alphaHash:At,combine:T.combine,mapUv:ce&&v(T.map.channel),aoMapUv:B&&v(T.aoMap.channel),lightMapUv:Ye&&v(T.lightMap.channel),bumpMapUv:Jt&&v(T.bumpMap.channel),normalMapUv:ee&&v(T.normalMap.channel),displacementMapUv:Vt&&v(T.displacementMap.channel),emissiveMapUv:de&&v(T.emissiveMap.channel),metalnessMapUv:Pt&&v(T.metalnessMap.channel),roughnessMapUv:P&&v(T.roughnessMap.channel),anisotropyMapUv:_t&&v(T.anisotropyMap.channel),clearcoatMapUv:Tt&&v(T.clearcoatMap.channel),clearcoatNormalMapUv:Kt&&v(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&v(T.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&v(T.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&v(T.iridescenceThicknessMap.channel),sheenColorMapUv:Ot&&v(T.sheenColorMap.channel),sheenRoughnessMapUv:Et&&v(T.sheenRoughnessMap.channel),specularMapUv:ie&&v(T.specularMap.channel),specularColorMapUv:qt&&v(T.specularColorMap.channel),specularIntensityMapUv:pe&&v(T.specularIntensityMap.channel),transmissionMapUv:k&&v(T.transmissionMap.channel),thicknessMapUv:xt&&v(T.thicknessMap.channel),alphaMapUv:rt&&v(T.alphaMap.channel),vertexTangents:!!j.attributes.tangent&&(ee||y),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!j.attributes.uv&&(ce||rt),fog:!!V,useFog:T.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:T.flatShading===!0,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:Bt,skinning:N.isSkinnedMesh===!0,morphTargets:j.morphAttributes.position!==void 0,morphNormals:j.morphAttributes.normal!==void 0,morphColors:j.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:Mt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:Oe,decodeVideoTexture:ce&&T.map.isVideoTexture===!0&&ge.getTransfer(T.map.colorSpace)===we,decodeVideoTextureEmissive:de&&T.emissiveMap.isVideoTexture===!0&&ge.getTransfer(T.emissiveMap.colorSpace)===we,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===fi,flipSided:T.side===Ln,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Zt&&T.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&T.extensions.multiDraw===!0||It)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return nn.vertexUv1s=c.has(1),nn.vertexUv2s=c.has(2),nn.vertexUv3s=c.has(3),c.clear(),nn}function d(T){const S=[];if(T.shaderID?S.push(T.shaderID):(S.push(T.customVertexShaderID),S.push(T.customFragmentShaderID)),T.defines!==void 0)for(const C in T.defines)S.push(C),S.push(T.defines[C]);return T.isRawShaderMaterial===!1&&(E(S,T),w(S,T),S.push(i.outputColorSpace)),S.push(T.customProgramCacheKey),S.join()}function E(T,S){T.push(S.precision),T.push(S.outputColorSpace),T.push(S.envMapMode),T.push(S.envMapCubeUVHeight),T.push(S.mapUv),T.push(S.alphaMapUv),T.push(S.lightMapUv),T.push(S.aoMapUv),T.push(S.bumpMapUv),T.push(S.normalMapUv),T.push(S.displacementMapUv),T.push(S.emissiveMapUv),T.push(S.metalnessMapUv),T.push(S.roughnessMapUv),T.push(S.anisotropyMapUv),T.push(S.clearcoatMapUv),T.push(S.clearcoatNormalMapUv),T.push(S.clearcoatRoughnessMapUv),T.push(S.iridescenceMapUv),T.push(S.iridescenceThicknessMapUv),T.push(S.sheenColorMapUv),T.push(S.sheenRoughnessMapUv),T.push(S.specularMapUv),T.push(S.specularColorMapUv),T.push(S.specularIntensityMapUv),T.push(S.transmissionMapUv),T.push(S.thicknessMapUv),T.push(S.combine),T.push(S.fogExp2),T.push(S.sizeAttenuation),T.push(S.morphTargetsCount),T.push(S.morphAttributeCount),T.push(S.numDirLights),T.push(S.numPointLights),T.push(S.numSpotLights),T.push(S.numSpotLightMaps),T.push(S.numHemiLights),T.push(S.numRectAreaLights),T.push(S.numDirLightShadows),T.push(S.numPointLightShadows),T.push(S.numSpotLightShadows),T.push(S.numSpotLightShadowsWithMaps),T.push(S.numLightProbes),T.push(S.shadowMapType),T.push(S.toneMapping),T.push(S.numClippingPlanes),T.push(S.numClipIntersection),T.push(S.depthPacking)}function w(T,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),T.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),T.push(a.mask)}function x(T){const S=_[T.type];let C;if(S){const H=bi[S];C=g0.clone(H.uniforms)}else C=T.uniforms;return C}function I(T,S){let C;for(let H=0,N=h.length;H<N;H++){const V=h[H];if(V.cacheKey===S){C=V,++C.usedTimes;break}}return C===void 0&&(C=new CS(i,S,T,r),h.push(C)),C}function R(T){if(--T.usedTimes===0){const S=h.indexOf(T);h[S]=h[h.length-1],h.pop(),T.destroy()}}function D(T){l.remove(T)}function U(){l.dispose()}return{getParameters:m,getProgramCacheKey:d,getUniforms:x,acquireProgram:I,releaseProgram:R,releaseShaderCache:D,programs:h,dispose:U}}function IS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function NS(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function Af(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Rf(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u,f,p,_,v,m){let d=i[t];return d===void 0?(d={id:u.id,object:u,geometry:f,material:p,groupOrder:_,renderOrder:u.renderOrder,z:v,group:m},i[t]=d):(d.id=u.id,d.object=u,d.geometry=f,d.material=p,d.groupOrder=_,d.renderOrder=u.renderOrder,d.z=v,d.group=m),t++,d}function a(u,f,p,_,v,m){const d=o(u,f,p,_,v,m);p.transmission>0?n.push(d):p.transparent===!0?s.push(d):e.push(d)}function l(u,f,p,_,v,m){const d=o(u,f,p,_,v,m);p.transmission>0?n.unshift(d):p.transparent===!0?s.unshift(d):e.unshift(d)}function c(u,f){e.length>1&&e.sort(u||NS),n.length>1&&n.sort(f||Af),s.length>1&&s.sort(f||Af)}function h(){for(let u=t,f=i.length;u<f;u++){const p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function FS(){let i=new WeakMap;function t(n,s){const r=i.get(n);let o;return r===void 0?(o=new Rf,i.set(n,[o])):s>=r.length?(o=new Rf,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function OS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new G,color:new fe};break;case"SpotLight":e={position:new G,direction:new G,color:new fe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new fe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new fe,groundColor:new fe};break;case"RectAreaLight":e={color:new fe,position:new G,halfWidth:new G,halfHeight:new G};break}return i[t.id]=e,e}}}function kS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let BS=0;function zS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function HS(i){const t=new OS,e=kS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new G);const s=new G,r=new ze,o=new ze;function a(c){let h=0,u=0,f=0;for(let T=0;T<9;T++)n.probe[T].set(0,0,0);let p=0,_=0,v=0,m=0,d=0,E=0,w=0,x=0,I=0,R=0,D=0;c.sort(zS);for(let T=0,S=c.length;T<S;T++){const C=c[T],H=C.color,N=C.intensity,V=C.distance,j=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=H.r*N,u+=H.g*N,f+=H.b*N;else if(C.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(C.sh.coefficients[K],N);D++}else if(C.isDirectionalLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const J=C.shadow,Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,n.directionalShadow[p]=Q,n.directionalShadowMap[p]=j,n.directionalShadowMatrix[p]=C.shadow.matrix,E++}n.directional[p]=K,p++}else if(C.isSpotLight){const K=t.get(C);K.position.setFromMatrixPosition(C.matrixWorld),K.color.copy(H).multiplyScalar(N),K.distance=V,K.coneCos=Math.cos(C.angle),K.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),K.decay=C.decay,n.spot[v]=K;const J=C.shadow;if(C.map&&(n.spotLightMap[I]=C.map,I++,J.updateMatrices(C),C.castShadow&&R++),n.spotLightMatrix[v]=J.matrix,C.castShadow){const Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,n.spotShadow[v]=Q,n.spotShadowMap[v]=j,x++}v++}else if(C.isRectAreaLight){const K=t.get(C);K.color.copy(H).multiplyScalar(N),K.halfWidth.set(C.width*.5,0,0),K.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=K,m++}else if(C.isPointLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),K.distance=C.distance,K.decay=C.decay,C.castShadow){const J=C.shadow,Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,Q.shadowCameraNear=J.camera.near,Q.shadowCameraFar=J.camera.far,n.pointShadow[_]=Q,n.pointShadowMap[_]=j,n.pointShadowMatrix[_]=C.shadow.matrix,w++}n.point[_]=K,_++}else if(C.isHemisphereLight){const K=t.get(C);K.skyColor.copy(C.color).multiplyScalar(N),K.groundColor.copy(C.groundColor).multiplyScalar(N),n.hemi[d]=K,d++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=bt.LTC_FLOAT_1,n.rectAreaLTC2=bt.LTC_FLOAT_2):(n.rectAreaLTC1=bt.LTC_HALF_1,n.rectAreaLTC2=bt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;const U=n.hash;(U.directionalLength!==p||U.pointLength!==_||U.spotLength!==v||U.rectAreaLength!==m||U.hemiLength!==d||U.numDirectionalShadows!==E||U.numPointShadows!==w||U.numSpotShadows!==x||U.numSpotMaps!==I||U.numLightProbes!==D)&&(n.directional.length=p,n.spot.length=v,n.rectArea.length=m,n.point.length=_,n.hemi.length=d,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.pointShadow.length=w,n.pointShadowMap.length=w,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=E,n.pointShadowMatrix.length=w,n.spotLightMatrix.length=x+I-R,n.spotLightMap.length=I,n.numSpotLightShadowsWithMaps=R,n.numLightProbes=D,U.directionalLength=p,U.pointLength=_,U.spotLength=v,U.rectAreaLength=m,U.hemiLength=d,U.numDirectionalShadows=E,U.numPointShadows=w,U.numSpotShadows=x,U.numSpotMaps=I,U.numLightProbes=D,n.version=BS++)}function l(c,h){let u=0,f=0,p=0,_=0,v=0;const m=h.matrixWorldInverse;for(let d=0,E=c.length;d<E;d++){const w=c[d];if(w.isDirectionalLight){const x=n.directional[u];x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),u++}else if(w.isSpotLight){const x=n.spot[p];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),p++}else if(w.isRectAreaLight){const x=n.rectArea[_];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(w.width*.5,0,0),x.halfHeight.set(0,w.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),_++}else if(w.isPointLight){const x=n.point[f];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),f++}else if(w.isHemisphereLight){const x=n.hemi[v];x.direction.setFromMatrixPosition(w.matrixWorld),x.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:n}}function Cf(i){const t=new HS(i),e=[],n=[];function s(h){c.camera=h,e.length=0,n.length=0}function r(h){e.push(h)}function o(h){n.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}const c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function VS(i){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new Cf(i),t.set(s,[a])):r>=o.length?(a=new Cf(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}class GS extends ks{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=B_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class WS extends ks{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const XS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$S=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function qS(i,t,e){let n=new au;const s=new le,r=new le,o=new We,a=new GS({depthPacking:z_}),l=new WS,c={},h=e.maxTextureSize,u={[ls]:Ln,[Ln]:ls,[fi]:fi},f=new us({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new le},radius:{value:4}},vertexShader:XS,fragmentShader:$S}),p=f.clone();p.defines.HORIZONTAL_PASS=1;const _=new en;_.setAttribute("position",new ti(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new Tn(_,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Vd;let d=this.type;this.render=function(R,D,U){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;const T=i.getRenderTarget(),S=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),H=i.state;H.setBlending(rs),H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);const N=d!==Fi&&this.type===Fi,V=d===Fi&&this.type!==Fi;for(let j=0,K=R.length;j<K;j++){const J=R[j],Q=J.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",J,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);const ht=Q.getFrameExtents();if(s.multiply(ht),r.copy(Q.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ht.x),s.x=r.x*ht.x,Q.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ht.y),s.y=r.y*ht.y,Q.mapSize.y=r.y)),Q.map===null||N===!0||V===!0){const mt=this.type!==Fi?{minFilter:mi,magFilter:mi}:{};Q.map!==null&&Q.map.dispose(),Q.map=new Fs(s.x,s.y,mt),Q.map.texture.name=J.name+".shadowMap",Q.camera.updateProjectionMatrix()}i.setRenderTarget(Q.map),i.clear();const ct=Q.getViewportCount();for(let mt=0;mt<ct;mt++){const Mt=Q.getViewport(mt);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),H.viewport(o),Q.updateMatrices(J,mt),n=Q.getFrustum(),x(D,U,Q.camera,J,this.type)}Q.isPointLightShadow!==!0&&this.type===Fi&&E(Q,U),Q.needsUpdate=!1}d=this.type,m.needsUpdate=!1,i.setRenderTarget(T,S,C)};function E(R,D){const U=t.update(v);f.defines.VSM_SAMPLES!==R.blurSamples&&(f.defines.VSM_SAMPLES=R.blurSamples,p.defines.VSM_SAMPLES=R.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new Fs(s.x,s.y)),f.uniforms.shadow_pass.value=R.map.texture,f.uniforms.resolution.value=R.mapSize,f.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(D,null,U,f,v,null),p.uniforms.shadow_pass.value=R.mapPass.texture,p.uniforms.resolution.value=R.mapSize,p.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(D,null,U,p,v,null)}function w(R,D,U,T){let S=null;const C=U.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(C!==void 0)S=C;else if(S=U.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const H=S.uuid,N=D.uuid;let V=c[H];V===void 0&&(V={},c[H]=V);let j=V[N];j===void 0&&(j=S.clone(),V[N]=j,D.addEventListener("dispose",I)),S=j}if(S.visible=D.visible,S.wireframe=D.wireframe,T===Fi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:u[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,U.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const H=i.properties.get(S);H.light=U}return S}function x(R,D,U,T,S){if(R.visible===!1)return;if(R.layers.test(D.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&S===Fi)&&(!R.frustumCulled||n.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(U.matrixWorldInverse,R.matrixWorld);const N=t.update(R),V=R.material;if(Array.isArray(V)){const j=N.groups;for(let K=0,J=j.length;K<J;K++){const Q=j[K],ht=V[Q.materialIndex];if(ht&&ht.visible){const ct=w(R,ht,T,S);R.onBeforeShadow(i,R,D,U,N,ct,Q),i.renderBufferDirect(U,null,N,ct,R,Q),R.onAfterShadow(i,R,D,U,N,ct,Q)}}}else if(V.visible){const j=w(R,V,T,S);R.onBeforeShadow(i,R,D,U,N,j,null),i.renderBufferDirect(U,null,N,j,R,null),R.onAfterShadow(i,R,D,U,N,j,null)}}const H=R.children;for(let N=0,V=H.length;N<V;N++)x(H[N],D,U,T,S)}function I(R){R.target.removeEventListener("dispose",I);for(const U in c){const T=c[U],S=R.target.uuid;S in T&&(T[S].dispose(),delete T[S])}}}const YS={[Yl]:Kl,[jl]:Ql,[Zl]:tc,[Er]:Jl,[Kl]:Yl,[Ql]:jl,[tc]:Zl,[Jl]:Er};function KS(i,t){function e(){let k=!1;const xt=new We;let et=null;const rt=new We(0,0,0,0);return{setMask:function(wt){et!==wt&&!k&&(i.colorMask(wt,wt,wt,wt),et=wt)},setLocked:function(wt){k=wt},setClear:function(wt,At,Zt,Oe,nn){nn===!0&&(wt*=Oe,At*=Oe,Zt*=Oe),xt.set(wt,At,Zt,Oe),rt.equals(xt)===!1&&(i.clearColor(wt,At,Zt,Oe),rt.copy(xt))},reset:function(){k=!1,et=null,rt.set(-1,0,0,0)}}}function n(){let k=!1,xt=!1,et=null,rt=null,wt=null;return{setReversed:function(At){if(xt!==At){const Zt=t.get("EXT_clip_control");xt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT);const Oe=wt;wt=null,this.setClear(Oe)}xt=At},getReversed:function(){return xt},setTest:function(At){At?ot(i.DEPTH_TEST):Bt(i.DEPTH_TEST)},setMask:function(At){et!==At&&!k&&(i.depthMask(At),et=At)},setFunc:function(At){if(xt&&(At=YS[At]),rt!==At){switch(At){case Yl:i.depthFunc(i.NEVER);break;case Kl:i.depthFunc(i.ALWAYS);break;case jl:i.depthFunc(i.LESS);break;case Er:i.depthFunc(i.LEQUAL);break;case Zl:i.depthFunc(i.EQUAL);break;case Jl:i.depthFunc(i.GEQUAL);break;case Ql:i.depthFunc(i.GREATER);break;case tc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}rt=At}},setLocked:function(At){k=At},setClear:function(At){wt!==At&&(xt&&(At=1-At),i.clearDepth(At),wt=At)},reset:function(){k=!1,et=null,rt=null,wt=null,xt=!1}}}function s(){let k=!1,xt=null,et=null,rt=null,wt=null,At=null,Zt=null,Oe=null,nn=null;return{setTest:function(xe){k||(xe?ot(i.STENCIL_TEST):Bt(i.STENCIL_TEST))},setMask:function(xe){xt!==xe&&!k&&(i.stencilMask(xe),xt=xe)},setFunc:function(xe,Ke,Pe){(et!==xe||rt!==Ke||wt!==Pe)&&(i.stencilFunc(xe,Ke,Pe),et=xe,rt=Ke,wt=Pe)},setOp:function(xe,Ke,Pe){(At!==xe||Zt!==Ke||Oe!==Pe)&&(i.stencilOp(xe,Ke,Pe),At=xe,Zt=Ke,Oe=Pe)},setLocked:function(xe){k=xe},setClear:function(xe){nn!==xe&&(i.clearStencil(xe),nn=xe)},reset:function(){k=!1,xt=null,et=null,rt=null,wt=null,At=null,Zt=null,Oe=null,nn=null}}}const r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap;let h={},u={},f=new WeakMap,p=[],_=null,v=!1,m=null,d=null,E=null,w=null,x=null,I=null,R=null,D=new fe(0,0,0),U=0,T=!1,S=null,C=null,H=null,N=null,V=null;const j=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let K=!1,J=0;const Q=i.getParameter(i.VERSION);Q.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(Q)[1]),K=J>=1):Q.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),K=J>=2);let ht=null,ct={};const mt=i.getParameter(i.SCISSOR_BOX),Mt=i.getParameter(i.VIEWPORT),pt=new We().fromArray(mt),nt=new We().fromArray(Mt);function at(k,xt,et,rt){const wt=new Uint8Array(4),At=i.createTexture();i.bindTexture(k,At),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Zt=0;Zt<et;Zt++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(xt,0,i.RGBA,1,1,rt,0,i.RGBA,i.UNSIGNED_BYTE,wt):i.texImage2D(xt+Zt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,wt);return At}const gt={};gt[i.TEXTURE_2D]=at(i.TEXTURE_2D,i.TEXTURE_2D,1),gt[i.TEXTURE_CUBE_MAP]=at(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[i.TEXTURE_2D_ARRAY]=at(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),gt[i.TEXTURE_3D]=at(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(i.DEPTH_TEST),o.setFunc(Er),Jt(!1),ee(Dh),ot(i.CULL_FACE),B(rs);function ot(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function Bt(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function Ht(k,xt){return u[k]!==xt?(i.bindFramebuffer(k,xt),u[k]=xt,k===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=xt),k===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=xt),!0):!1}function It(k,xt){let et=p,rt=!1;if(k){et=f.get(xt),et===void 0&&(et=[],f.set(xt,et));const wt=k.textures;if(et.length!==wt.length||et[0]!==i.COLOR_ATTACHMENT0){for(let At=0,Zt=wt.length;At<Zt;At++)et[At]=i.COLOR_ATTACHMENT0+At;et.length=wt.length,rt=!0}}else et[0]!==i.BACK&&(et[0]=i.BACK,rt=!0);rt&&i.drawBuffers(et)}function ce(k){return _!==k?(i.useProgram(k),_=k,!0):!1}const jt={[Rs]:i.FUNC_ADD,[f_]:i.FUNC_SUBTRACT,[d_]:i.FUNC_REVERSE_SUBTRACT};jt[p_]=i.MIN,jt[m_]=i.MAX;const ue={[g_]:i.ZERO,[__]:i.ONE,[v_]:i.SRC_COLOR,[$l]:i.SRC_ALPHA,[b_]:i.SRC_ALPHA_SATURATE,[y_]:i.DST_COLOR,[M_]:i.DST_ALPHA,[x_]:i.ONE_MINUS_SRC_COLOR,[ql]:i.ONE_MINUS_SRC_ALPHA,[E_]:i.ONE_MINUS_DST_COLOR,[S_]:i.ONE_MINUS_DST_ALPHA,[T_]:i.CONSTANT_COLOR,[w_]:i.ONE_MINUS_CONSTANT_COLOR,[A_]:i.CONSTANT_ALPHA,[R_]:i.ONE_MINUS_CONSTANT_ALPHA};function B(k,xt,et,rt,wt,At,Zt,Oe,nn,xe){if(k===rs){v===!0&&(Bt(i.BLEND),v=!1);return}if(v===!1&&(ot(i.BLEND),v=!0),k!==h_){if(k!==m||xe!==T){if((d!==Rs||x!==Rs)&&(i.blendEquation(i.FUNC_ADD),d=Rs,x=Rs),xe)switch(k){case mr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Uh:i.blendFunc(i.ONE,i.ONE);break;case Ih:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Nh:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}else switch(k){case mr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Uh:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case Ih:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Nh:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}E=null,w=null,I=null,R=null,D.set(0,0,0),U=0,m=k,T=xe}return}wt=wt||xt,At=At||et,Zt=Zt||rt,(xt!==d||wt!==x)&&(i.blendEquationSeparate(jt[xt],jt[wt]),d=xt,x=wt),(et!==E||rt!==w||At!==I||Zt!==R)&&(i.blendFuncSeparate(ue[et],ue[rt],ue[At],ue[Zt]),E=et,w=rt,I=At,R=Zt),(Oe.equals(D)===!1||nn!==U)&&(i.blendColor(Oe.r,Oe.g,Oe.b,nn),D.copy(Oe),U=nn),m=k,T=!1}function Ye(k,xt){k.side===fi?Bt(i.CULL_FACE):ot(i.CULL_FACE);let et=k.side===Ln;xt&&(et=!et),Jt(et),k.blending===mr&&k.transparent===!1?B(rs):B(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);const rt=k.stencilWrite;a.setTest(rt),rt&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),de(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?ot(i.SAMPLE_ALPHA_TO_COVERAGE):Bt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Jt(k){S!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),S=k)}function ee(k){k!==l_?(ot(i.CULL_FACE),k!==C&&(k===Dh?i.cullFace(i.BACK):k===c_?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Bt(i.CULL_FACE),C=k}function Vt(k){k!==H&&(K&&i.lineWidth(k),H=k)}function de(k,xt,et){k?(ot(i.POLYGON_OFFSET_FILL),(N!==xt||V!==et)&&(i.polygonOffset(xt,et),N=xt,V=et)):Bt(i.POLYGON_OFFSET_FILL)}function Pt(k){k?ot(i.SCISSOR_TEST):Bt(i.SCISSOR_TEST)}function P(k){k===void 0&&(k=i.TEXTURE0+j-1),ht!==k&&(i.activeTexture(k),ht=k)}function y(k,xt,et){et===void 0&&(ht===null?et=i.TEXTURE0+j-1:et=ht);let rt=ct[et];rt===void 0&&(rt={type:void 0,texture:void 0},ct[et]=rt),(rt.type!==k||rt.texture!==xt)&&(ht!==et&&(i.activeTexture(et),ht=et),i.bindTexture(k,xt||gt[k]),rt.type=k,rt.texture=xt)}function Y(){const k=ct[ht];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Z(){try{i.compressedTexImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function W(){try{i.compressedTexImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function tt(){try{i.texSubImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function St(){try{i.texSubImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function _t(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Tt(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Kt(){try{i.texStorage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ft(){try{i.texStorage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function vt(){try{i.texImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Nt(){try{i.texImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Ot(k){pt.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),pt.copy(k))}function Et(k){nt.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),nt.copy(k))}function ie(k,xt){let et=c.get(xt);et===void 0&&(et=new WeakMap,c.set(xt,et));let rt=et.get(k);rt===void 0&&(rt=i.getUniformBlockIndex(xt,k.name),et.set(k,rt))}function qt(k,xt){const rt=c.get(xt).get(k);l.get(xt)!==rt&&(i.uniformBlockBinding(xt,rt,k.__bindingPointIndex),l.set(xt,rt))}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ht=null,ct={},u={},f=new WeakMap,p=[],_=null,v=!1,m=null,d=null,E=null,w=null,x=null,I=null,R=null,D=new fe(0,0,0),U=0,T=!1,S=null,C=null,H=null,N=null,V=null,pt.set(0,0,i.canvas.width,i.canvas.height),nt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:Bt,bindFramebuffer:Ht,drawBuffers:It,useProgram:ce,setBlending:B,setMaterial:Ye,setFlipSided:Jt,setCullFace:ee,setLineWidth:Vt,setPolygonOffset:de,setScissorTest:Pt,activeTexture:P,bindTexture:y,unbindTexture:Y,compressedTexImage2D:Z,compressedTexImage3D:W,texImage2D:vt,texImage3D:Nt,updateUBOMapping:ie,uniformBlockBinding:qt,texStorage2D:Kt,texStorage3D:ft,texSubImage2D:tt,texSubImage3D:St,compressedTexSubImage2D:_t,compressedTexSubImage3D:Tt,scissor:Ot,viewport:Et,reset:pe}}function Pf(i,t,e,n){const s=jS(n);switch(e){case qd:return i*t;case Kd:return i*t;case jd:return i*t*2;case Zd:return i*t/s.components*s.byteLength;case iu:return i*t/s.components*s.byteLength;case Jd:return i*t*2/s.components*s.byteLength;case su:return i*t*2/s.components*s.byteLength;case Yd:return i*t*3/s.components*s.byteLength;case di:return i*t*4/s.components*s.byteLength;case ru:return i*t*4/s.components*s.byteLength;case sa:case ra:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case oa:case aa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case oc:case lc:return Math.max(i,16)*Math.max(t,8)/4;case rc:case ac:return Math.max(i,8)*Math.max(t,8)/2;case cc:case uc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case hc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case fc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case dc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case pc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case mc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case gc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case _c:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case vc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case xc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Mc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Sc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case yc:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Ec:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case bc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Tc:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case la:case wc:case Ac:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Qd:case Rc:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Cc:case Pc:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function jS(i){switch(i){case Wi:case Wd:return{byteLength:1,components:1};case oo:case Xd:case lo:return{byteLength:2,components:1};case eu:case nu:return{byteLength:2,components:4};case Ns:case tu:case ki:return{byteLength:4,components:1};case $d:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function ZS(i,t,e,n,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new le,h=new WeakMap;let u;const f=new WeakMap;let p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(P,y){return p?new OffscreenCanvas(P,y):ga("canvas")}function v(P,y,Y){let Z=1;const W=Pt(P);if((W.width>Y||W.height>Y)&&(Z=Y/Math.max(W.width,W.height)),Z<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){const tt=Math.floor(Z*W.width),St=Math.floor(Z*W.height);u===void 0&&(u=_(tt,St));const _t=y?_(tt,St):u;return _t.width=tt,_t.height=St,_t.getContext("2d").drawImage(P,0,0,tt,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+tt+"x"+St+")."),_t}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),P;return P}function m(P){return P.generateMipmaps}function d(P){i.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(P,y,Y,Z,W=!1){if(P!==null){if(i[P]!==void 0)return i[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let tt=y;if(y===i.RED&&(Y===i.FLOAT&&(tt=i.R32F),Y===i.HALF_FLOAT&&(tt=i.R16F),Y===i.UNSIGNED_BYTE&&(tt=i.R8)),y===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.R8UI),Y===i.UNSIGNED_SHORT&&(tt=i.R16UI),Y===i.UNSIGNED_INT&&(tt=i.R32UI),Y===i.BYTE&&(tt=i.R8I),Y===i.SHORT&&(tt=i.R16I),Y===i.INT&&(tt=i.R32I)),y===i.RG&&(Y===i.FLOAT&&(tt=i.RG32F),Y===i.HALF_FLOAT&&(tt=i.RG16F),Y===i.UNSIGNED_BYTE&&(tt=i.RG8)),y===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.RG8UI),Y===i.UNSIGNED_SHORT&&(tt=i.RG16UI),Y===i.UNSIGNED_INT&&(tt=i.RG32UI),Y===i.BYTE&&(tt=i.RG8I),Y===i.SHORT&&(tt=i.RG16I),Y===i.INT&&(tt=i.RG32I)),y===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(tt=i.RGB16UI),Y===i.UNSIGNED_INT&&(tt=i.RGB32UI),Y===i.BYTE&&(tt=i.RGB8I),Y===i.SHORT&&(tt=i.RGB16I),Y===i.INT&&(tt=i.RGB32I)),y===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(tt=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(tt=i.RGBA16UI),Y===i.UNSIGNED_INT&&(tt=i.RGBA32UI),Y===i.BYTE&&(tt=i.RGBA8I),Y===i.SHORT&&(tt=i.RGBA16I),Y===i.INT&&(tt=i.RGBA32I)),y===i.RGB&&Y===i.UNSIGNED_INT_5_9_9_9_REV&&(tt=i.RGB9_E5),y===i.RGBA){const St=W?La:ge.getTransfer(Z);Y===i.FLOAT&&(tt=i.RGBA32F),Y===i.HALF_FLOAT&&(tt=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(tt=St===we?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT_4_4_4_4&&(tt=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(tt=i.RGB5_A1)}return(tt===i.R16F||tt===i.R32F||tt===i.RG16F||tt===i.RG32F||tt===i.RGBA16F||tt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),tt}function x(P,y){let Y;return P?y===null||y===Ns||y===wr?Y=i.DEPTH24_STENCIL8:y===ki?Y=i.DEPTH32F_STENCIL8:y===oo&&(Y=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ns||y===wr?Y=i.DEPTH_COMPONENT24:y===ki?Y=i.DEPTH_COMPONENT32F:y===oo&&(Y=i.DEPTH_COMPONENT16),Y}function I(P,y){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==mi&&P.minFilter!==Ti?Math.log2(Math.max(y.width,y.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?y.mipmaps.length:1}function R(P){const y=P.target;y.removeEventListener("dispose",R),U(y),y.isVideoTexture&&h.delete(y)}function D(P){const y=P.target;y.removeEventListener("dispose",D),S(y)}function U(P){const y=n.get(P);if(y.__webglInit===void 0)return;const Y=P.source,Z=f.get(Y);if(Z){const W=Z[y.__cacheKey];W.usedTimes--,W.usedTimes===0&&T(P),Object.keys(Z).length===0&&f.delete(Y)}n.remove(P)}function T(P){const y=n.get(P);i.deleteTexture(y.__webglTexture);const Y=P.source,Z=f.get(Y);delete Z[y.__cacheKey],o.memory.textures--}function S(P){const y=n.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),n.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(y.__webglFramebuffer[Z]))for(let W=0;W<y.__webglFramebuffer[Z].length;W++)i.deleteFramebuffer(y.__webglFramebuffer[Z][W]);else i.deleteFramebuffer(y.__webglFramebuffer[Z]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[Z])}else{if(Array.isArray(y.__webglFramebuffer))for(let Z=0;Z<y.__webglFramebuffer.length;Z++)i.deleteFramebuffer(y.__webglFramebuffer[Z]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let Z=0;Z<y.__webglColorRenderbuffer.length;Z++)y.__webglColorRenderbuffer[Z]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[Z]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}const Y=P.textures;for(let Z=0,W=Y.length;Z<W;Z++){const tt=n.get(Y[Z]);tt.__webglTexture&&(i.deleteTexture(tt.__webglTexture),o.memory.textures--),n.remove(Y[Z])}n.remove(P)}let C=0;function H(){C=0}function N(){const P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function V(P){const y=[];return y.push(P.wrapS),y.push(P.wrapT),y.push(P.wrapR||0),y.push(P.magFilter),y.push(P.minFilter),y.push(P.anisotropy),y.push(P.internalFormat),y.push(P.format),y.push(P.type),y.push(P.generateMipmaps),y.push(P.premultiplyAlpha),y.push(P.flipY),y.push(P.unpackAlignment),y.push(P.colorSpace),y.join()}function j(P,y){const Y=n.get(P);if(P.isVideoTexture&&Vt(P),P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){const Z=P.image;if(Z===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(Z.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{nt(Y,P,y);return}}e.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+y)}function K(P,y){const Y=n.get(P);if(P.version>0&&Y.__version!==P.version){nt(Y,P,y);return}e.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+y)}function J(P,y){const Y=n.get(P);if(P.version>0&&Y.__version!==P.version){nt(Y,P,y);return}e.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+y)}function Q(P,y){const Y=n.get(P);if(P.version>0&&Y.__version!==P.version){at(Y,P,y);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+y)}const ht={[ic]:i.REPEAT,[Ps]:i.CLAMP_TO_EDGE,[sc]:i.MIRRORED_REPEAT},ct={[mi]:i.NEAREST,[k_]:i.NEAREST_MIPMAP_NEAREST,[To]:i.NEAREST_MIPMAP_LINEAR,[Ti]:i.LINEAR,[tl]:i.LINEAR_MIPMAP_NEAREST,[Ls]:i.LINEAR_MIPMAP_LINEAR},mt={[V_]:i.NEVER,[Y_]:i.ALWAYS,[G_]:i.LESS,[ep]:i.LEQUAL,[W_]:i.EQUAL,[q_]:i.GEQUAL,[X_]:i.GREATER,[$_]:i.NOTEQUAL};function Mt(P,y){if(y.type===ki&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Ti||y.magFilter===tl||y.magFilter===To||y.magFilter===Ls||y.minFilter===Ti||y.minFilter===tl||y.minFilter===To||y.minFilter===Ls)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,ht[y.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,ht[y.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,ht[y.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ct[y.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ct[y.minFilter]),y.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,mt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===mi||y.minFilter!==To&&y.minFilter!==Ls||y.type===ki&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){const Y=t.get("EXT_texture_filter_anisotropic");i.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function pt(P,y){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,y.addEventListener("dispose",R));const Z=y.source;let W=f.get(Z);W===void 0&&(W={},f.set(Z,W));const tt=V(y);if(tt!==P.__cacheKey){W[tt]===void 0&&(W[tt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),W[tt].usedTimes++;const St=W[P.__cacheKey];St!==void 0&&(W[P.__cacheKey].usedTimes--,St.usedTimes===0&&T(y)),P.__cacheKey=tt,P.__webglTexture=W[tt].texture}return Y}function nt(P,y,Y){let Z=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(Z=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(Z=i.TEXTURE_3D);const W=pt(P,y),tt=y.source;e.bindTexture(Z,P.__webglTexture,i.TEXTURE0+Y);const St=n.get(tt);if(tt.version!==St.__version||W===!0){e.activeTexture(i.TEXTURE0+Y);const _t=ge.getPrimaries(ge.workingColorSpace),Tt=y.colorSpace===is?null:ge.getPrimaries(y.colorSpace),Kt=y.colorSpace===is||_t===Tt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt);let ft=v(y.image,!1,s.maxTextureSize);ft=de(y,ft);const vt=r.convert(y.format,y.colorSpace),Nt=r.convert(y.type);let Ot=w(y.internalFormat,vt,Nt,y.colorSpace,y.isVideoTexture);Mt(Z,y);let Et;const ie=y.mipmaps,qt=y.isVideoTexture!==!0,pe=St.__version===void 0||W===!0,k=tt.dataReady,xt=I(y,ft);if(y.isDepthTexture)Ot=x(y.format===Ar,y.type),pe&&(qt?e.texStorage2D(i.TEXTURE_2D,1,Ot,ft.width,ft.height):e.texImage2D(i.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,null));else if(y.isDataTexture)if(ie.length>0){qt&&pe&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ie[0].width,ie[0].height);for(let et=0,rt=ie.length;et<rt;et++)Et=ie[et],qt?k&&e.texSubImage2D(i.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(i.TEXTURE_2D,et,Ot,Et.width,Et.height,0,vt,Nt,Et.data);y.generateMipmaps=!1}else qt?(pe&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ft.width,ft.height),k&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ft.width,ft.height,vt,Nt,ft.data)):e.texImage2D(i.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,ft.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){qt&&pe&&e.texStorage3D(i.TEXTURE_2D_ARRAY,xt,Ot,ie[0].width,ie[0].height,ft.depth);for(let et=0,rt=ie.length;et<rt;et++)if(Et=ie[et],y.format!==di)if(vt!==null)if(qt){if(k)if(y.layerUpdates.size>0){const wt=Pf(Et.width,Et.height,y.format,y.type);for(const At of y.layerUpdates){const Zt=Et.data.subarray(At*wt/Et.data.BYTES_PER_ELEMENT,(At+1)*wt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,et,0,0,At,Et.width,Et.height,1,vt,Zt)}y.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,et,0,0,0,Et.width,Et.height,ft.depth,vt,Et.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,et,Ot,Et.width,Et.height,ft.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else qt?k&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,et,0,0,0,Et.width,Et.height,ft.depth,vt,Nt,Et.data):e.texImage3D(i.TEXTURE_2D_ARRAY,et,Ot,Et.width,Et.height,ft.depth,0,vt,Nt,Et.data)}else{qt&&pe&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ie[0].width,ie[0].height);for(let et=0,rt=ie.length;et<rt;et++)Et=ie[et],y.format!==di?vt!==null?qt?k&&e.compressedTexSubImage2D(i.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Et.data):e.compressedTexImage2D(i.TEXTURE_2D,et,Ot,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):qt?k&&e.texSubImage2D(i.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(i.TEXTURE_2D,et,Ot,Et.width,Et.height,0,vt,Nt,Et.data)}else if(y.isDataArrayTexture)if(qt){if(pe&&e.texStorage3D(i.TEXTURE_2D_ARRAY,xt,Ot,ft.width,ft.height,ft.depth),k)if(y.layerUpdates.size>0){const et=Pf(ft.width,ft.height,y.format,y.type);for(const rt of y.layerUpdates){const wt=ft.data.subarray(rt*et/ft.data.BYTES_PER_ELEMENT,(rt+1)*et/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,vt,Nt,wt)}y.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(y.isData3DTexture)qt?(pe&&e.texStorage3D(i.TEXTURE_3D,xt,Ot,ft.width,ft.height,ft.depth),k&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)):e.texImage3D(i.TEXTURE_3D,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(y.isFramebufferTexture){if(pe)if(qt)e.texStorage2D(i.TEXTURE_2D,xt,Ot,ft.width,ft.height);else{let et=ft.width,rt=ft.height;for(let wt=0;wt<xt;wt++)e.texImage2D(i.TEXTURE_2D,wt,Ot,et,rt,0,vt,Nt,null),et>>=1,rt>>=1}}else if(ie.length>0){if(qt&&pe){const et=Pt(ie[0]);e.texStorage2D(i.TEXTURE_2D,xt,Ot,et.width,et.height)}for(let et=0,rt=ie.length;et<rt;et++)Et=ie[et],qt?k&&e.texSubImage2D(i.TEXTURE_2D,et,0,0,vt,Nt,Et):e.texImage2D(i.TEXTURE_2D,et,Ot,vt,Nt,Et);y.generateMipmaps=!1}else if(qt){if(pe){const et=Pt(ft);e.texStorage2D(i.TEXTURE_2D,xt,Ot,et.width,et.height)}k&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,vt,Nt,ft)}else e.texImage2D(i.TEXTURE_2D,0,Ot,vt,Nt,ft);m(y)&&d(Z),St.__version=tt.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function at(P,y,Y){if(y.image.length!==6)return;const Z=pt(P,y),W=y.source;e.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+Y);const tt=n.get(W);if(W.version!==tt.__version||Z===!0){e.activeTexture(i.TEXTURE0+Y);const St=ge.getPrimaries(ge.workingColorSpace),_t=y.colorSpace===is?null:ge.getPrimaries(y.colorSpace),Tt=y.colorSpace===is||St===_t?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Tt);const Kt=y.isCompressedTexture||y.image[0].isCompressedTexture,ft=y.image[0]&&y.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!Kt&&!ft?vt[rt]=v(y.image[rt],!0,s.maxCubemapSize):vt[rt]=ft?y.image[rt].image:y.image[rt],vt[rt]=de(y,vt[rt]);const Nt=vt[0],Ot=r.convert(y.format,y.colorSpace),Et=r.convert(y.type),ie=w(y.internalFormat,Ot,Et,y.colorSpace),qt=y.isVideoTexture!==!0,pe=tt.__version===void 0||Z===!0,k=W.dataReady;let xt=I(y,Nt);Mt(i.TEXTURE_CUBE_MAP,y);let et;if(Kt){qt&&pe&&e.texStorage2D(i.TEXTURE_CUBE_MAP,xt,ie,Nt.width,Nt.height);for(let rt=0;rt<6;rt++){et=vt[rt].mipmaps;for(let wt=0;wt<et.length;wt++){const At=et[wt];y.format!==di?Ot!==null?qt?k&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,0,0,At.width,At.height,Ot,At.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,ie,At.width,At.height,0,At.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,0,0,At.width,At.height,Ot,Et,At.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt,ie,At.width,At.height,0,Ot,Et,At.data)}}}else{if(et=y.mipmaps,qt&&pe){et.length>0&&xt++;const rt=Pt(vt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,xt,ie,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ot,Et,vt[rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ie,vt[rt].width,vt[rt].height,0,Ot,Et,vt[rt].data);for(let wt=0;wt<et.length;wt++){const Zt=et[wt].image[rt].image;qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,0,0,Zt.width,Zt.height,Ot,Et,Zt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,ie,Zt.width,Zt.height,0,Ot,Et,Zt.data)}}else{qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ot,Et,vt[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ie,Ot,Et,vt[rt]);for(let wt=0;wt<et.length;wt++){const At=et[wt];qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,0,0,Ot,Et,At.image[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt+1,ie,Ot,Et,At.image[rt])}}}m(y)&&d(i.TEXTURE_CUBE_MAP),tt.__version=W.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function gt(P,y,Y,Z,W,tt){const St=r.convert(Y.format,Y.colorSpace),_t=r.convert(Y.type),Tt=w(Y.internalFormat,St,_t,Y.colorSpace),Kt=n.get(y),ft=n.get(Y);if(ft.__renderTarget=y,!Kt.__hasExternalTextures){const vt=Math.max(1,y.width>>tt),Nt=Math.max(1,y.height>>tt);W===i.TEXTURE_3D||W===i.TEXTURE_2D_ARRAY?e.texImage3D(W,tt,Tt,vt,Nt,y.depth,0,St,_t,null):e.texImage2D(W,tt,Tt,vt,Nt,0,St,_t,null)}e.bindFramebuffer(i.FRAMEBUFFER,P),ee(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Z,W,ft.__webglTexture,0,Jt(y)):(W===i.TEXTURE_2D||W>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,Z,W,ft.__webglTexture,tt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ot(P,y,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,P),y.depthBuffer){const Z=y.depthTexture,W=Z&&Z.isDepthTexture?Z.type:null,tt=x(y.stencilBuffer,W),St=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=Jt(y);ee(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_t,tt,y.width,y.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,_t,tt,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,tt,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,P)}else{const Z=y.textures;for(let W=0;W<Z.length;W++){const tt=Z[W],St=r.convert(tt.format,tt.colorSpace),_t=r.convert(tt.type),Tt=w(tt.internalFormat,St,_t,tt.colorSpace),Kt=Jt(y);Y&&ee(y)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Kt,Tt,y.width,y.height):ee(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Kt,Tt,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,Tt,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Bt(P,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,P),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const Z=n.get(y.depthTexture);Z.__renderTarget=y,(!Z.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),j(y.depthTexture,0);const W=Z.__webglTexture,tt=Jt(y);if(y.depthTexture.format===gr)ee(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,W,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,W,0);else if(y.depthTexture.format===Ar)ee(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,W,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,W,0);else throw new Error("Unknown depthTexture format")}function Ht(P){const y=n.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==P.depthTexture){const Z=P.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),Z){const W=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,Z.removeEventListener("dispose",W)};Z.addEventListener("dispose",W),y.__depthDisposeCallback=W}y.__boundDepthTexture=Z}if(P.depthTexture&&!y.__autoAllocateDepthBuffer){if(Y)throw new Error("target.depthTexture not supported in Cube render targets");Bt(y.__webglFramebuffer,P)}else if(Y){y.__webglDepthbuffer=[];for(let Z=0;Z<6;Z++)if(e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[Z]),y.__webglDepthbuffer[Z]===void 0)y.__webglDepthbuffer[Z]=i.createRenderbuffer(),ot(y.__webglDepthbuffer[Z],P,!1);else{const W=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,tt=y.__webglDepthbuffer[Z];i.bindRenderbuffer(i.RENDERBUFFER,tt),i.framebufferRenderbuffer(i.FRAMEBUFFER,W,i.RENDERBUFFER,tt)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),ot(y.__webglDepthbuffer,P,!1);else{const Z=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,W=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,W),i.framebufferRenderbuffer(i.FRAMEBUFFER,Z,i.RENDERBUFFER,W)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function It(P,y,Y){const Z=n.get(P);y!==void 0&&gt(Z.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&Ht(P)}function ce(P){const y=P.texture,Y=n.get(P),Z=n.get(y);P.addEventListener("dispose",D);const W=P.textures,tt=P.isWebGLCubeRenderTarget===!0,St=W.length>1;if(St||(Z.__webglTexture===void 0&&(Z.__webglTexture=i.createTexture()),Z.__version=y.version,o.memory.textures++),tt){Y.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(y.mipmaps&&y.mipmaps.length>0){Y.__webglFramebuffer[_t]=[];for(let Tt=0;Tt<y.mipmaps.length;Tt++)Y.__webglFramebuffer[_t][Tt]=i.createFramebuffer()}else Y.__webglFramebuffer[_t]=i.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){Y.__webglFramebuffer=[];for(let _t=0;_t<y.mipmaps.length;_t++)Y.__webglFramebuffer[_t]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(St)for(let _t=0,Tt=W.length;_t<Tt;_t++){const Kt=n.get(W[_t]);Kt.__webglTexture===void 0&&(Kt.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&ee(P)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let _t=0;_t<W.length;_t++){const Tt=W[_t];Y.__webglColorRenderbuffer[_t]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[_t]);const Kt=r.convert(Tt.format,Tt.colorSpace),ft=r.convert(Tt.type),vt=w(Tt.internalFormat,Kt,ft,Tt.colorSpace,P.isXRRenderTarget===!0),Nt=Jt(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,Nt,vt,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,Y.__webglColorRenderbuffer[_t])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),ot(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(tt){e.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture),Mt(i.TEXTURE_CUBE_MAP,y);for(let _t=0;_t<6;_t++)if(y.mipmaps&&y.mipmaps.length>0)for(let Tt=0;Tt<y.mipmaps.length;Tt++)gt(Y.__webglFramebuffer[_t][Tt],P,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,Tt);else gt(Y.__webglFramebuffer[_t],P,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);m(y)&&d(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let _t=0,Tt=W.length;_t<Tt;_t++){const Kt=W[_t],ft=n.get(Kt);e.bindTexture(i.TEXTURE_2D,ft.__webglTexture),Mt(i.TEXTURE_2D,Kt),gt(Y.__webglFramebuffer,P,Kt,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,0),m(Kt)&&d(i.TEXTURE_2D)}e.unbindTexture()}else{let _t=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(_t,Z.__webglTexture),Mt(_t,y),y.mipmaps&&y.mipmaps.length>0)for(let Tt=0;Tt<y.mipmaps.length;Tt++)gt(Y.__webglFramebuffer[Tt],P,y,i.COLOR_ATTACHMENT0,_t,Tt);else gt(Y.__webglFramebuffer,P,y,i.COLOR_ATTACHMENT0,_t,0);m(y)&&d(_t),e.unbindTexture()}P.depthBuffer&&Ht(P)}function jt(P){const y=P.textures;for(let Y=0,Z=y.length;Y<Z;Y++){const W=y[Y];if(m(W)){const tt=E(P),St=n.get(W).__webglTexture;e.bindTexture(tt,St),d(tt),e.unbindTexture()}}}const ue=[],B=[];function Ye(P){if(P.samples>0){if(ee(P)===!1){const y=P.textures,Y=P.width,Z=P.height;let W=i.COLOR_BUFFER_BIT;const tt=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(P),_t=y.length>1;if(_t)for(let Tt=0;Tt<y.length;Tt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let Tt=0;Tt<y.length;Tt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(W|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(W|=i.STENCIL_BUFFER_BIT)),_t){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const Kt=n.get(y[Tt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Kt,0)}i.blitFramebuffer(0,0,Y,Z,0,0,Y,Z,W,i.NEAREST),l===!0&&(ue.length=0,B.length=0,ue.push(i.COLOR_ATTACHMENT0+Tt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(ue.push(tt),B.push(tt),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,B)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ue))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),_t)for(let Tt=0;Tt<y.length;Tt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const Kt=n.get(y[Tt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Tt,i.TEXTURE_2D,Kt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){const y=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function Jt(P){return Math.min(s.maxSamples,P.samples)}function ee(P){const y=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Vt(P){const y=o.render.frame;h.get(P)!==y&&(h.set(P,y),P.update())}function de(P,y){const Y=P.colorSpace,Z=P.format,W=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==Ur&&Y!==is&&(ge.getTransfer(Y)===we?(Z!==di||W!==Wi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Y)),y}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=N,this.resetTextureUnits=H,this.setTexture2D=j,this.setTexture2DArray=K,this.setTexture3D=J,this.setTextureCube=Q,this.rebindTextures=It,this.setupRenderTarget=ce,this.updateRenderTargetMipmap=jt,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=Ht,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=ee}function JS(i,t){function e(n,s=is){let r;const o=ge.getTransfer(s);if(n===Wi)return i.UNSIGNED_BYTE;if(n===eu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===nu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===$d)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Wd)return i.BYTE;if(n===Xd)return i.SHORT;if(n===oo)return i.UNSIGNED_SHORT;if(n===tu)return i.INT;if(n===Ns)return i.UNSIGNED_INT;if(n===ki)return i.FLOAT;if(n===lo)return i.HALF_FLOAT;if(n===qd)return i.ALPHA;if(n===Yd)return i.RGB;if(n===di)return i.RGBA;if(n===Kd)return i.LUMINANCE;if(n===jd)return i.LUMINANCE_ALPHA;if(n===gr)return i.DEPTH_COMPONENT;if(n===Ar)return i.DEPTH_STENCIL;if(n===Zd)return i.RED;if(n===iu)return i.RED_INTEGER;if(n===Jd)return i.RG;if(n===su)return i.RG_INTEGER;if(n===ru)return i.RGBA_INTEGER;if(n===sa||n===ra||n===oa||n===aa)if(o===we)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===sa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===sa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ra)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===oa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===aa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===rc||n===oc||n===ac||n===lc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===rc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===oc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ac)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===lc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===cc||n===uc||n===hc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===cc||n===uc)return o===we?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===hc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===fc||n===dc||n===pc||n===mc||n===gc||n===_c||n===vc||n===xc||n===Mc||n===Sc||n===yc||n===Ec||n===bc||n===Tc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===fc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===dc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===pc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===mc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===gc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===_c)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===vc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===xc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Mc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Sc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===yc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Ec)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===bc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Tc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===la||n===wc||n===Ac)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===la)return o===we?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===wc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Ac)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Qd||n===Rc||n===Cc||n===Pc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===la)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Rc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Cc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Pc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===wr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}class QS extends zn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class pi extends Je{constructor(){super(),this.isGroup=!0,this.type="Group"}}const ty={type:"move"};class Rl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new pi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new pi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new pi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,n),d=this._getHandJoint(c,v);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),p=.02,_=.005;c.inputState.pinching&&f>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ty)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new pi;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const ey=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,ny=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class iy{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){const s=new Dn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new us({vertexShader:ey,fragmentShader:ny,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Tn(new Da(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class sy extends Ir{constructor(t,e){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,p=null,_=null;const v=new iy,m=e.getContextAttributes();let d=null,E=null;const w=[],x=[],I=new le;let R=null;const D=new zn;D.viewport=new We;const U=new zn;U.viewport=new We;const T=[D,U],S=new QS;let C=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(nt){let at=w[nt];return at===void 0&&(at=new Rl,w[nt]=at),at.getTargetRaySpace()},this.getControllerGrip=function(nt){let at=w[nt];return at===void 0&&(at=new Rl,w[nt]=at),at.getGripSpace()},this.getHand=function(nt){let at=w[nt];return at===void 0&&(at=new Rl,w[nt]=at),at.getHandSpace()};function N(nt){const at=x.indexOf(nt.inputSource);if(at===-1)return;const gt=w[at];gt!==void 0&&(gt.update(nt.inputSource,nt.frame,c||o),gt.dispatchEvent({type:nt.type,data:nt.inputSource}))}function V(){s.removeEventListener("select",N),s.removeEventListener("selectstart",N),s.removeEventListener("selectend",N),s.removeEventListener("squeeze",N),s.removeEventListener("squeezestart",N),s.removeEventListener("squeezeend",N),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",j);for(let nt=0;nt<w.length;nt++){const at=x[nt];at!==null&&(x[nt]=null,w[nt].disconnect(at))}C=null,H=null,v.reset(),t.setRenderTarget(d),p=null,f=null,u=null,s=null,E=null,pt.stop(),n.isPresenting=!1,t.setPixelRatio(R),t.setSize(I.width,I.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(nt){r=nt,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(nt){a=nt,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(nt){c=nt},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(nt){if(s=nt,s!==null){if(d=t.getRenderTarget(),s.addEventListener("select",N),s.addEventListener("selectstart",N),s.addEventListener("selectend",N),s.addEventListener("squeeze",N),s.addEventListener("squeezestart",N),s.addEventListener("squeezeend",N),s.addEventListener("end",V),s.addEventListener("inputsourceschange",j),m.xrCompatible!==!0&&await e.makeXRCompatible(),R=t.getPixelRatio(),t.getSize(I),s.renderState.layers===void 0){const at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),E=new Fs(p.framebufferWidth,p.framebufferHeight,{format:di,type:Wi,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,gt=null,ot=null;m.depth&&(ot=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?Ar:gr,gt=m.stencil?wr:Ns);const Bt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};u=new XRWebGLBinding(s,e),f=u.createProjectionLayer(Bt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),E=new Fs(f.textureWidth,f.textureHeight,{format:di,type:Wi,depthTexture:new dp(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}E.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function j(nt){for(let at=0;at<nt.removed.length;at++){const gt=nt.removed[at],ot=x.indexOf(gt);ot>=0&&(x[ot]=null,w[ot].disconnect(gt))}for(let at=0;at<nt.added.length;at++){const gt=nt.added[at];let ot=x.indexOf(gt);if(ot===-1){for(let Ht=0;Ht<w.length;Ht++)if(Ht>=x.length){x.push(gt),ot=Ht;break}else if(x[Ht]===null){x[Ht]=gt,ot=Ht;break}if(ot===-1)break}const Bt=w[ot];Bt&&Bt.connect(gt)}}const K=new G,J=new G;function Q(nt,at,gt){K.setFromMatrixPosition(at.matrixWorld),J.setFromMatrixPosition(gt.matrixWorld);const ot=K.distanceTo(J),Bt=at.projectionMatrix.elements,Ht=gt.projectionMatrix.elements,It=Bt[14]/(Bt[10]-1),ce=Bt[14]/(Bt[10]+1),jt=(Bt[9]+1)/Bt[5],ue=(Bt[9]-1)/Bt[5],B=(Bt[8]-1)/Bt[0],Ye=(Ht[8]+1)/Ht[0],Jt=It*B,ee=It*Ye,Vt=ot/(-B+Ye),de=Vt*-B;if(at.matrixWorld.decompose(nt.position,nt.quaternion,nt.scale),nt.translateX(de),nt.translateZ(Vt),nt.matrixWorld.compose(nt.position,nt.quaternion,nt.scale),nt.matrixWorldInverse.copy(nt.matrixWorld).invert(),Bt[10]===-1)nt.projectionMatrix.copy(at.projectionMatrix),nt.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Pt=It+Vt,P=ce+Vt,y=Jt-de,Y=ee+(ot-de),Z=jt*ce/P*Pt,W=ue*ce/P*Pt;nt.projectionMatrix.makePerspective(y,Y,Z,W,Pt,P),nt.projectionMatrixInverse.copy(nt.projectionMatrix).invert()}}function ht(nt,at){at===null?nt.matrixWorld.copy(nt.matrix):nt.matrixWorld.multiplyMatrices(at.matrixWorld,nt.matrix),nt.matrixWorldInverse.copy(nt.matrixWorld).invert()}this.updateCamera=function(nt){if(s===null)return;let at=nt.near,gt=nt.far;v.texture!==null&&(v.depthNear>0&&(at=v.depthNear),v.depthFar>0&&(gt=v.depthFar)),S.near=U.near=D.near=at,S.far=U.far=D.far=gt,(C!==S.near||H!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,H=S.far),D.layers.mask=nt.layers.mask|2,U.layers.mask=nt.layers.mask|4,S.layers.mask=D.layers.mask|U.layers.mask;const ot=nt.parent,Bt=S.cameras;ht(S,ot);for(let Ht=0;Ht<Bt.length;Ht++)ht(Bt[Ht],ot);Bt.length===2?Q(S,D,U):S.projectionMatrix.copy(D.projectionMatrix),ct(nt,S,ot)};function ct(nt,at,gt){gt===null?nt.matrix.copy(at.matrixWorld):(nt.matrix.copy(gt.matrixWorld),nt.matrix.invert(),nt.matrix.multiply(at.matrixWorld)),nt.matrix.decompose(nt.position,nt.quaternion,nt.scale),nt.updateMatrixWorld(!0),nt.projectionMatrix.copy(at.projectionMatrix),nt.projectionMatrixInverse.copy(at.projectionMatrixInverse),nt.isPerspectiveCamera&&(nt.fov=Lc*2*Math.atan(1/nt.projectionMatrix.elements[5]),nt.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(nt){l=nt,f!==null&&(f.fixedFoveation=nt),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=nt)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let mt=null;function Mt(nt,at){if(h=at.getViewerPose(c||o),_=at,h!==null){const gt=h.views;p!==null&&(t.setRenderTargetFramebuffer(E,p.framebuffer),t.setRenderTarget(E));let ot=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Ht=0;Ht<gt.length;Ht++){const It=gt[Ht];let ce=null;if(p!==null)ce=p.getViewport(It);else{const ue=u.getViewSubImage(f,It);ce=ue.viewport,Ht===0&&(t.setRenderTargetTextures(E,ue.colorTexture,f.ignoreDepthValues?void 0:ue.depthStencilTexture),t.setRenderTarget(E))}let jt=T[Ht];jt===void 0&&(jt=new zn,jt.layers.enable(Ht),jt.viewport=new We,T[Ht]=jt),jt.matrix.fromArray(It.transform.matrix),jt.matrix.decompose(jt.position,jt.quaternion,jt.scale),jt.projectionMatrix.fromArray(It.projectionMatrix),jt.projectionMatrixInverse.copy(jt.projectionMatrix).invert(),jt.viewport.set(ce.x,ce.y,ce.width,ce.height),Ht===0&&(S.matrix.copy(jt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(jt)}const Bt=s.enabledFeatures;if(Bt&&Bt.includes("depth-sensing")){const Ht=u.getDepthInformation(gt[0]);Ht&&Ht.isValid&&Ht.texture&&v.init(t,Ht,s.renderState)}}for(let gt=0;gt<w.length;gt++){const ot=x[gt],Bt=w[gt];ot!==null&&Bt!==void 0&&Bt.update(ot,at,c||o)}mt&&mt(nt,at),at.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:at}),_=null}const pt=new fp;pt.setAnimationLoop(Mt),this.setAnimationLoop=function(nt){mt=nt},this.dispose=function(){}}}const ys=new wi,ry=new ze;function oy(i,t){function e(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function n(m,d){d.color.getRGB(m.fogColor.value,cp(i)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function s(m,d,E,w,x){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(m,d):d.isMeshToonMaterial?(r(m,d),u(m,d)):d.isMeshPhongMaterial?(r(m,d),h(m,d)):d.isMeshStandardMaterial?(r(m,d),f(m,d),d.isMeshPhysicalMaterial&&p(m,d,x)):d.isMeshMatcapMaterial?(r(m,d),_(m,d)):d.isMeshDepthMaterial?r(m,d):d.isMeshDistanceMaterial?(r(m,d),v(m,d)):d.isMeshNormalMaterial?r(m,d):d.isLineBasicMaterial?(o(m,d),d.isLineDashedMaterial&&a(m,d)):d.isPointsMaterial?l(m,d,E,w):d.isSpriteMaterial?c(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,e(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===Ln&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,e(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===Ln&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,e(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,e(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);const E=t.get(d),w=E.envMap,x=E.envMapRotation;w&&(m.envMap.value=w,ys.copy(x),ys.x*=-1,ys.y*=-1,ys.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(ys.y*=-1,ys.z*=-1),m.envMapRotation.value.setFromMatrix4(ry.makeRotationFromEuler(ys)),m.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,m.aoMapTransform))}function o(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform))}function a(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function l(m,d,E,w){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*E,m.scale.value=w*.5,d.map&&(m.map.value=d.map,e(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function c(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function h(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function u(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function f(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,E){m.ior.value=d.ior,d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Ln&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=E.texture,m.transmissionSamplerSize.value.set(E.width,E.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,d){d.matcap&&(m.matcap.value=d.matcap)}function v(m,d){const E=t.get(d).light;m.referencePosition.value.setFromMatrixPosition(E.matrixWorld),m.nearDistance.value=E.shadow.camera.near,m.farDistance.value=E.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function ay(i,t,e,n){let s={},r={},o=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(E,w){const x=w.program;n.uniformBlockBinding(E,x)}function c(E,w){let x=s[E.id];x===void 0&&(_(E),x=h(E),s[E.id]=x,E.addEventListener("dispose",m));const I=w.program;n.updateUBOMapping(E,I);const R=t.render.frame;r[E.id]!==R&&(f(E),r[E.id]=R)}function h(E){const w=u();E.__bindingPointIndex=w;const x=i.createBuffer(),I=E.__size,R=E.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,I,R),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,w,x),x}function u(){for(let E=0;E<a;E++)if(o.indexOf(E)===-1)return o.push(E),E;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(E){const w=s[E.id],x=E.uniforms,I=E.__cache;i.bindBuffer(i.UNIFORM_BUFFER,w);for(let R=0,D=x.length;R<D;R++){const U=Array.isArray(x[R])?x[R]:[x[R]];for(let T=0,S=U.length;T<S;T++){const C=U[T];if(p(C,R,T,I)===!0){const H=C.__offset,N=Array.isArray(C.value)?C.value:[C.value];let V=0;for(let j=0;j<N.length;j++){const K=N[j],J=v(K);typeof K=="number"||typeof K=="boolean"?(C.__data[0]=K,i.bufferSubData(i.UNIFORM_BUFFER,H+V,C.__data)):K.isMatrix3?(C.__data[0]=K.elements[0],C.__data[1]=K.elements[1],C.__data[2]=K.elements[2],C.__data[3]=0,C.__data[4]=K.elements[3],C.__data[5]=K.elements[4],C.__data[6]=K.elements[5],C.__data[7]=0,C.__data[8]=K.elements[6],C.__data[9]=K.elements[7],C.__data[10]=K.elements[8],C.__data[11]=0):(K.toArray(C.__data,V),V+=J.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,H,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(E,w,x,I){const R=E.value,D=w+"_"+x;if(I[D]===void 0)return typeof R=="number"||typeof R=="boolean"?I[D]=R:I[D]=R.clone(),!0;{const U=I[D];if(typeof R=="number"||typeof R=="boolean"){if(U!==R)return I[D]=R,!0}else if(U.equals(R)===!1)return U.copy(R),!0}return!1}function _(E){const w=E.uniforms;let x=0;const I=16;for(let D=0,U=w.length;D<U;D++){const T=Array.isArray(w[D])?w[D]:[w[D]];for(let S=0,C=T.length;S<C;S++){const H=T[S],N=Array.isArray(H.value)?H.value:[H.value];for(let V=0,j=N.length;V<j;V++){const K=N[V],J=v(K),Q=x%I,ht=Q%J.boundary,ct=Q+ht;x+=ht,ct!==0&&I-ct<J.storage&&(x+=I-ct),H.__data=new Float32Array(J.storage/Float32Array.BYTES_PER_ELEMENT),H.__offset=x,x+=J.storage}}}const R=x%I;return R>0&&(x+=I-R),E.__size=x,E.__cache={},this}function v(E){const w={boundary:0,storage:0};return typeof E=="number"||typeof E=="boolean"?(w.boundary=4,w.storage=4):E.isVector2?(w.boundary=8,w.storage=8):E.isVector3||E.isColor?(w.boundary=16,w.storage=12):E.isVector4?(w.boundary=16,w.storage=16):E.isMatrix3?(w.boundary=48,w.storage=48):E.isMatrix4?(w.boundary=64,w.storage=64):E.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",E),w}function m(E){const w=E.target;w.removeEventListener("dispose",m);const x=o.indexOf(w.__bindingPointIndex);o.splice(x,1),i.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function d(){for(const E in s)i.deleteBuffer(s[E]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}class ly{constructor(t={}){const{canvas:e=j_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;const _=new Uint32Array(4),v=new Int32Array(4);let m=null,d=null;const E=[],w=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=Kn,this.toneMapping=os,this.toneMappingExposure=1;const x=this;let I=!1,R=0,D=0,U=null,T=-1,S=null;const C=new We,H=new We;let N=null;const V=new fe(0);let j=0,K=e.width,J=e.height,Q=1,ht=null,ct=null;const mt=new We(0,0,K,J),Mt=new We(0,0,K,J);let pt=!1;const nt=new au;let at=!1,gt=!1;const ot=new ze,Bt=new ze,Ht=new G,It=new We,ce={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let jt=!1;function ue(){return U===null?Q:1}let B=n;function Ye(b,O){return e.getContext(b,O)}try{const b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Jc}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",wt,!1),e.addEventListener("webglcontextcreationerror",At,!1),B===null){const O="webgl2";if(B=Ye(O,b),B===null)throw Ye(O)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(b){throw console.error("THREE.WebGLRenderer: "+b.message),b}let Jt,ee,Vt,de,Pt,P,y,Y,Z,W,tt,St,_t,Tt,Kt,ft,vt,Nt,Ot,Et,ie,qt,pe,k;function xt(){Jt=new dM(B),Jt.init(),qt=new JS(B,Jt),ee=new aM(B,Jt,t,qt),Vt=new KS(B,Jt),ee.reverseDepthBuffer&&f&&Vt.buffers.depth.setReversed(!0),de=new gM(B),Pt=new IS,P=new ZS(B,Jt,Vt,Pt,ee,qt,de),y=new cM(x),Y=new fM(x),Z=new E0(B),pe=new rM(B,Z),W=new pM(B,Z,de,pe),tt=new vM(B,W,Z,de),Ot=new _M(B,ee,P),ft=new lM(Pt),St=new US(x,y,Y,Jt,ee,pe,ft),_t=new oy(x,Pt),Tt=new FS,Kt=new VS(Jt),Nt=new sM(x,y,Y,Vt,tt,p,l),vt=new qS(x,tt,ee),k=new ay(B,de,ee,Vt),Et=new oM(B,Jt,de),ie=new mM(B,Jt,de),de.programs=St.programs,x.capabilities=ee,x.extensions=Jt,x.properties=Pt,x.renderLists=Tt,x.shadowMap=vt,x.state=Vt,x.info=de}xt();const et=new sy(x,B);this.xr=et,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){const b=Jt.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=Jt.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(b){b!==void 0&&(Q=b,this.setSize(K,J,!1))},this.getSize=function(b){return b.set(K,J)},this.setSize=function(b,O,X=!0){if(et.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=b,J=O,e.width=Math.floor(b*Q),e.height=Math.floor(O*Q),X===!0&&(e.style.width=b+"px",e.style.height=O+"px"),this.setViewport(0,0,b,O)},this.getDrawingBufferSize=function(b){return b.set(K*Q,J*Q).floor()},this.setDrawingBufferSize=function(b,O,X){K=b,J=O,Q=X,e.width=Math.floor(b*X),e.height=Math.floor(O*X),this.setViewport(0,0,b,O)},this.getCurrentViewport=function(b){return b.copy(C)},this.getViewport=function(b){return b.copy(mt)},this.setViewport=function(b,O,X,$){b.isVector4?mt.set(b.x,b.y,b.z,b.w):mt.set(b,O,X,$),Vt.viewport(C.copy(mt).multiplyScalar(Q).round())},this.getScissor=function(b){return b.copy(Mt)},this.setScissor=function(b,O,X,$){b.isVector4?Mt.set(b.x,b.y,b.z,b.w):Mt.set(b,O,X,$),Vt.scissor(H.copy(Mt).multiplyScalar(Q).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(b){Vt.setScissorTest(pt=b)},this.setOpaqueSort=function(b){ht=b},this.setTransparentSort=function(b){ct=b},this.getClearColor=function(b){return b.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(b=!0,O=!0,X=!0){let $=0;if(b){let z=!1;if(U!==null){const ut=U.texture.format;z=ut===ru||ut===su||ut===iu}if(z){const ut=U.texture.type,yt=ut===Wi||ut===Ns||ut===oo||ut===wr||ut===eu||ut===nu,Ft=Nt.getClearColor(),Dt=Nt.getClearAlpha(),Gt=Ft.r,Xt=Ft.g,Ut=Ft.b;yt?(_[0]=Gt,_[1]=Xt,_[2]=Ut,_[3]=Dt,B.clearBufferuiv(B.COLOR,0,_)):(v[0]=Gt,v[1]=Xt,v[2]=Ut,v[3]=Dt,B.clearBufferiv(B.COLOR,0,v))}else $|=B.COLOR_BUFFER_BIT}O&&($|=B.DEPTH_BUFFER_BIT),X&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",wt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),Tt.dispose(),Kt.dispose(),Pt.dispose(),y.dispose(),Y.dispose(),tt.dispose(),pe.dispose(),k.dispose(),St.dispose(),et.dispose(),et.removeEventListener("sessionstart",Un),et.removeEventListener("sessionend",Ai),wn.stop()};function rt(b){b.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function wt(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;const b=de.autoReset,O=vt.enabled,X=vt.autoUpdate,$=vt.needsUpdate,z=vt.type;xt(),de.autoReset=b,vt.enabled=O,vt.autoUpdate=X,vt.needsUpdate=$,vt.type=z}function At(b){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function Zt(b){const O=b.target;O.removeEventListener("dispose",Zt),Oe(O)}function Oe(b){nn(b),Pt.remove(b)}function nn(b){const O=Pt.get(b).programs;O!==void 0&&(O.forEach(function(X){St.releaseProgram(X)}),b.isShaderMaterial&&St.releaseShaderCache(b))}this.renderBufferDirect=function(b,O,X,$,z,ut){O===null&&(O=ce);const yt=z.isMesh&&z.matrixWorld.determinant()<0,Ft=Na(b,O,X,$,z);Vt.setMaterial($,yt);let Dt=X.index,Gt=1;if($.wireframe===!0){if(Dt=W.getWireframeAttribute(X),Dt===void 0)return;Gt=2}const Xt=X.drawRange,Ut=X.attributes.position;let oe=Xt.start*Gt,ye=(Xt.start+Xt.count)*Gt;ut!==null&&(oe=Math.max(oe,ut.start*Gt),ye=Math.min(ye,(ut.start+ut.count)*Gt)),Dt!==null?(oe=Math.max(oe,0),ye=Math.min(ye,Dt.count)):Ut!=null&&(oe=Math.max(oe,0),ye=Math.min(ye,Ut.count));const be=ye-oe;if(be<0||be===1/0)return;pe.setup(z,$,Ft,X,Dt);let sn,he=Et;if(Dt!==null&&(sn=Z.get(Dt),he=ie,he.setIndex(sn)),z.isMesh)$.wireframe===!0?(Vt.setLineWidth($.wireframeLinewidth*ue()),he.setMode(B.LINES)):he.setMode(B.TRIANGLES);else if(z.isLine){let kt=$.linewidth;kt===void 0&&(kt=1),Vt.setLineWidth(kt*ue()),z.isLineSegments?he.setMode(B.LINES):z.isLineLoop?he.setMode(B.LINE_LOOP):he.setMode(B.LINE_STRIP)}else z.isPoints?he.setMode(B.POINTS):z.isSprite&&he.setMode(B.TRIANGLES);if(z.isBatchedMesh)if(z._multiDrawInstances!==null)he.renderMultiDrawInstances(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount,z._multiDrawInstances);else if(Jt.get("WEBGL_multi_draw"))he.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{const kt=z._multiDrawStarts,ke=z._multiDrawCounts,me=z._multiDrawCount,An=Dt?Z.get(Dt).bytesPerElement:1,_i=Pt.get($).currentProgram.getUniforms();for(let pn=0;pn<me;pn++)_i.setValue(B,"_gl_DrawID",pn),he.render(kt[pn]/An,ke[pn])}else if(z.isInstancedMesh)he.renderInstances(oe,be,z.count);else if(X.isInstancedBufferGeometry){const kt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,ke=Math.min(X.instanceCount,kt);he.renderInstances(oe,be,ke)}else he.render(oe,be)};function xe(b,O,X){b.transparent===!0&&b.side===fi&&b.forceSinglePass===!1?(b.side=Ln,b.needsUpdate=!0,zs(b,O,X),b.side=ls,b.needsUpdate=!0,zs(b,O,X),b.side=fi):zs(b,O,X)}this.compile=function(b,O,X=null){X===null&&(X=b),d=Kt.get(X),d.init(O),w.push(d),X.traverseVisible(function(z){z.isLight&&z.layers.test(O.layers)&&(d.pushLight(z),z.castShadow&&d.pushShadow(z))}),b!==X&&b.traverseVisible(function(z){z.isLight&&z.layers.test(O.layers)&&(d.pushLight(z),z.castShadow&&d.pushShadow(z))}),d.setupLights();const $=new Set;return b.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;const ut=z.material;if(ut)if(Array.isArray(ut))for(let yt=0;yt<ut.length;yt++){const Ft=ut[yt];xe(Ft,X,z),$.add(Ft)}else xe(ut,X,z),$.add(ut)}),w.pop(),d=null,$},this.compileAsync=function(b,O,X=null){const $=this.compile(b,O,X);return new Promise(z=>{function ut(){if($.forEach(function(yt){Pt.get(yt).currentProgram.isReady()&&$.delete(yt)}),$.size===0){z(b);return}setTimeout(ut,10)}Jt.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let Ke=null;function Pe(b){Ke&&Ke(b)}function Un(){wn.stop()}function Ai(){wn.start()}const wn=new fp;wn.setAnimationLoop(Pe),typeof self<"u"&&wn.setContext(self),this.setAnimationLoop=function(b){Ke=b,et.setAnimationLoop(b),b===null?wn.stop():wn.start()},et.addEventListener("sessionstart",Un),et.addEventListener("sessionend",Ai),this.render=function(b,O){if(O!==void 0&&O.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),et.enabled===!0&&et.isPresenting===!0&&(et.cameraAutoUpdate===!0&&et.updateCamera(O),O=et.getCamera()),b.isScene===!0&&b.onBeforeRender(x,b,O,U),d=Kt.get(b,w.length),d.init(O),w.push(d),Bt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),nt.setFromProjectionMatrix(Bt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),m=Tt.get(b,E.length),m.init(),E.push(m),et.enabled===!0&&et.isPresenting===!0){const ut=x.xr.getDepthSensingMesh();ut!==null&&dn(ut,O,-1/0,x.sortObjects)}dn(b,O,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(ht,ct),jt=et.enabled===!1||et.isPresenting===!1||et.hasDepthSensing()===!1,jt&&Nt.addToRenderList(m,b),this.info.render.frame++,at===!0&&ft.beginShadows();const X=d.state.shadowsArray;vt.render(X,b,O),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const $=m.opaque,z=m.transmissive;if(d.setupLights(),O.isArrayCamera){const ut=O.cameras;if(z.length>0)for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Ci($,z,b,Dt)}jt&&Nt.render(b);for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Ri(m,b,Dt,Dt.viewport)}}else z.length>0&&Ci($,z,b,O),jt&&Nt.render(b),Ri(m,b,O);U!==null&&(P.updateMultisampleRenderTarget(U),P.updateRenderTargetMipmap(U)),b.isScene===!0&&b.onAfterRender(x,b,O),pe.resetDefaultState(),T=-1,S=null,w.pop(),w.length>0?(d=w[w.length-1],at===!0&&ft.setGlobalState(x.clippingPlanes,d.state.camera)):d=null,E.pop(),E.length>0?m=E[E.length-1]:m=null};function dn(b,O,X,$){if(b.visible===!1)return;if(b.layers.test(O.layers)){if(b.isGroup)X=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(O);else if(b.isLight)d.pushLight(b),b.castShadow&&d.pushShadow(b);else if(b.isSprite){if(!b.frustumCulled||nt.intersectsSprite(b)){$&&It.setFromMatrixPosition(b.matrixWorld).applyMatrix4(Bt);const yt=tt.update(b),Ft=b.material;Ft.visible&&m.push(b,yt,Ft,X,It.z,null)}}else if((b.isMesh||b.isLine||b.isPoints)&&(!b.frustumCulled||nt.intersectsObject(b))){const yt=tt.update(b),Ft=b.material;if($&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),It.copy(b.boundingSphere.center)):(yt.boundingSphere===null&&yt.computeBoundingSphere(),It.copy(yt.boundingSphere.center)),It.applyMatrix4(b.matrixWorld).applyMatrix4(Bt)),Array.isArray(Ft)){const Dt=yt.groups;for(let Gt=0,Xt=Dt.length;Gt<Xt;Gt++){const Ut=Dt[Gt],oe=Ft[Ut.materialIndex];oe&&oe.visible&&m.push(b,yt,oe,X,It.z,Ut)}}else Ft.visible&&m.push(b,yt,Ft,X,It.z,null)}}const ut=b.children;for(let yt=0,Ft=ut.length;yt<Ft;yt++)dn(ut[yt],O,X,$)}function Ri(b,O,X,$){const z=b.opaque,ut=b.transmissive,yt=b.transparent;d.setupLightsView(X),at===!0&&ft.setGlobalState(x.clippingPlanes,X),$&&Vt.viewport(C.copy($)),z.length>0&&hs(z,O,X),ut.length>0&&hs(ut,O,X),yt.length>0&&hs(yt,O,X),Vt.buffers.depth.setTest(!0),Vt.buffers.depth.setMask(!0),Vt.buffers.color.setMask(!0),Vt.setPolygonOffset(!1)}function Ci(b,O,X,$){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[$.id]===void 0&&(d.state.transmissionRenderTarget[$.id]=new Fs(1,1,{generateMipmaps:!0,type:Jt.has("EXT_color_buffer_half_float")||Jt.has("EXT_color_buffer_float")?lo:Wi,minFilter:Ls,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ge.workingColorSpace}));const ut=d.state.transmissionRenderTarget[$.id],yt=$.viewport||C;ut.setSize(yt.z,yt.w);const Ft=x.getRenderTarget();x.setRenderTarget(ut),x.getClearColor(V),j=x.getClearAlpha(),j<1&&x.setClearColor(16777215,.5),x.clear(),jt&&Nt.render(X);const Dt=x.toneMapping;x.toneMapping=os;const Gt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),d.setupLightsView($),at===!0&&ft.setGlobalState(x.clippingPlanes,$),hs(b,X,$),P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut),Jt.has("WEBGL_multisampled_render_to_texture")===!1){let Xt=!1;for(let Ut=0,oe=O.length;Ut<oe;Ut++){const ye=O[Ut],be=ye.object,sn=ye.geometry,he=ye.material,kt=ye.group;if(he.side===fi&&be.layers.test($.layers)){const ke=he.side;he.side=Ln,he.needsUpdate=!0,Or(be,X,$,sn,he,kt),he.side=ke,he.needsUpdate=!0,Xt=!0}}Xt===!0&&(P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut))}x.setRenderTarget(Ft),x.setClearColor(V,j),Gt!==void 0&&($.viewport=Gt),x.toneMapping=Dt}function hs(b,O,X){const $=O.isScene===!0?O.overrideMaterial:null;for(let z=0,ut=b.length;z<ut;z++){const yt=b[z],Ft=yt.object,Dt=yt.geometry,Gt=$===null?yt.material:$,Xt=yt.group;Ft.layers.test(X.layers)&&Or(Ft,O,X,Dt,Gt,Xt)}}function Or(b,O,X,$,z,ut){b.onBeforeRender(x,O,X,$,z,ut),b.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),z.onBeforeRender(x,O,X,$,b,ut),z.transparent===!0&&z.side===fi&&z.forceSinglePass===!1?(z.side=Ln,z.needsUpdate=!0,x.renderBufferDirect(X,O,$,z,b,ut),z.side=ls,z.needsUpdate=!0,x.renderBufferDirect(X,O,$,z,b,ut),z.side=fi):x.renderBufferDirect(X,O,$,z,b,ut),b.onAfterRender(x,O,X,$,z,ut)}function zs(b,O,X){O.isScene!==!0&&(O=ce);const $=Pt.get(b),z=d.state.lights,ut=d.state.shadowsArray,yt=z.state.version,Ft=St.getParameters(b,z.state,ut,O,X),Dt=St.getProgramCacheKey(Ft);let Gt=$.programs;$.environment=b.isMeshStandardMaterial?O.environment:null,$.fog=O.fog,$.envMap=(b.isMeshStandardMaterial?Y:y).get(b.envMap||$.environment),$.envMapRotation=$.environment!==null&&b.envMap===null?O.environmentRotation:b.envMapRotation,Gt===void 0&&(b.addEventListener("dispose",Zt),Gt=new Map,$.programs=Gt);let Xt=Gt.get(Dt);if(Xt!==void 0){if($.currentProgram===Xt&&$.lightsStateVersion===yt)return gi(b,Ft),Xt}else Ft.uniforms=St.getUniforms(b),b.onBeforeCompile(Ft,x),Xt=St.acquireProgram(Ft,Dt),Gt.set(Dt,Xt),$.uniforms=Ft.uniforms;const Ut=$.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(Ut.clippingPlanes=ft.uniform),gi(b,Ft),$.needsLights=go(b),$.lightsStateVersion=yt,$.needsLights&&(Ut.ambientLightColor.value=z.state.ambient,Ut.lightProbe.value=z.state.probe,Ut.directionalLights.value=z.state.directional,Ut.directionalLightShadows.value=z.state.directionalShadow,Ut.spotLights.value=z.state.spot,Ut.spotLightShadows.value=z.state.spotShadow,Ut.rectAreaLights.value=z.state.rectArea,Ut.ltc_1.value=z.state.rectAreaLTC1,Ut.ltc_2.value=z.state.rectAreaLTC2,Ut.pointLights.value=z.state.point,Ut.pointLightShadows.value=z.state.pointShadow,Ut.hemisphereLights.value=z.state.hemi,Ut.directionalShadowMap.value=z.state.directionalShadowMap,Ut.directionalShadowMatrix.value=z.state.directionalShadowMatrix,Ut.spotShadowMap.value=z.state.spotShadowMap,Ut.spotLightMatrix.value=z.state.spotLightMatrix,Ut.spotLightMap.value=z.state.spotLightMap,Ut.pointShadowMap.value=z.state.pointShadowMap,Ut.pointShadowMatrix.value=z.state.pointShadowMatrix),$.currentProgram=Xt,$.uniformsList=null,Xt}function mo(b){if(b.uniformsList===null){const O=b.currentProgram.getUniforms();b.uniformsList=ua.seqWithValue(O.seq,b.uniforms)}return b.uniformsList}function gi(b,O){const X=Pt.get(b);X.outputColorSpace=O.outputColorSpace,X.batching=O.batching,X.batchingColor=O.batchingColor,X.instancing=O.instancing,X.instancingColor=O.instancingColor,X.instancingMorph=O.instancingMorph,X.skinning=O.skinning,X.morphTargets=O.morphTargets,X.morphNormals=O.morphNormals,X.morphColors=O.morphColors,X.morphTargetsCount=O.morphTargetsCount,X.numClippingPlanes=O.numClippingPlanes,X.numIntersection=O.numClipIntersection,X.vertexAlphas=O.vertexAlphas,X.vertexTangents=O.vertexTangents,X.toneMapping=O.toneMapping}function Na(b,O,X,$,z){O.isScene!==!0&&(O=ce),P.resetTextureUnits();const ut=O.fog,yt=$.isMeshStandardMaterial?O.environment:null,Ft=U===null?x.outputColorSpace:U.isXRRenderTarget===!0?U.texture.colorSpace:Ur,Dt=($.isMeshStandardMaterial?Y:y).get($.envMap||yt),Gt=$.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,Xt=!!X.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Ut=!!X.morphAttributes.position,oe=!!X.morphAttributes.normal,ye=!!X.morphAttributes.color;let be=os;$.toneMapped&&(U===null||U.isXRRenderTarget===!0)&&(be=x.toneMapping);const sn=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,he=sn!==void 0?sn.length:0,kt=Pt.get($),ke=d.state.lights;if(at===!0&&(gt===!0||b!==S)){const vn=b===S&&$.id===T;ft.setState($,b,vn)}let me=!1;$.version===kt.__version?(kt.needsLights&&kt.lightsStateVersion!==ke.state.version||kt.outputColorSpace!==Ft||z.isBatchedMesh&&kt.batching===!1||!z.isBatchedMesh&&kt.batching===!0||z.isBatchedMesh&&kt.batchingColor===!0&&z.colorTexture===null||z.isBatchedMesh&&kt.batchingColor===!1&&z.colorTexture!==null||z.isInstancedMesh&&kt.instancing===!1||!z.isInstancedMesh&&kt.instancing===!0||z.isSkinnedMesh&&kt.skinning===!1||!z.isSkinnedMesh&&kt.skinning===!0||z.isInstancedMesh&&kt.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&kt.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&kt.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&kt.instancingMorph===!1&&z.morphTexture!==null||kt.envMap!==Dt||$.fog===!0&&kt.fog!==ut||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==ft.numPlanes||kt.numIntersection!==ft.numIntersection)||kt.vertexAlphas!==Gt||kt.vertexTangents!==Xt||kt.morphTargets!==Ut||kt.morphNormals!==oe||kt.morphColors!==ye||kt.toneMapping!==be||kt.morphTargetsCount!==he)&&(me=!0):(me=!0,kt.__version=$.version);let An=kt.currentProgram;me===!0&&(An=zs($,O,z));let _i=!1,pn=!1,ds=!1;const Ae=An.getUniforms(),Gn=kt.uniforms;if(Vt.useProgram(An.program)&&(_i=!0,pn=!0,ds=!0),$.id!==T&&(T=$.id,pn=!0),_i||S!==b){Vt.buffers.depth.getReversed()?(ot.copy(b.projectionMatrix),J_(ot),Q_(ot),Ae.setValue(B,"projectionMatrix",ot)):Ae.setValue(B,"projectionMatrix",b.projectionMatrix),Ae.setValue(B,"viewMatrix",b.matrixWorldInverse);const vi=Ae.map.cameraPosition;vi!==void 0&&vi.setValue(B,Ht.setFromMatrixPosition(b.matrixWorld)),ee.logarithmicDepthBuffer&&Ae.setValue(B,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Ae.setValue(B,"isOrthographic",b.isOrthographicCamera===!0),S!==b&&(S=b,pn=!0,ds=!0)}if(z.isSkinnedMesh){Ae.setOptional(B,z,"bindMatrix"),Ae.setOptional(B,z,"bindMatrixInverse");const vn=z.skeleton;vn&&(vn.boneTexture===null&&vn.computeBoneTexture(),Ae.setValue(B,"boneTexture",vn.boneTexture,P))}z.isBatchedMesh&&(Ae.setOptional(B,z,"batchingTexture"),Ae.setValue(B,"batchingTexture",z._matricesTexture,P),Ae.setOptional(B,z,"batchingIdTexture"),Ae.setValue(B,"batchingIdTexture",z._indirectTexture,P),Ae.setOptional(B,z,"batchingColorTexture"),z._colorsTexture!==null&&Ae.setValue(B,"batchingColorTexture",z._colorsTexture,P));const Xi=X.morphAttributes;if((Xi.position!==void 0||Xi.normal!==void 0||Xi.color!==void 0)&&Ot.update(z,X,An),(pn||kt.receiveShadow!==z.receiveShadow)&&(kt.receiveShadow=z.receiveShadow,Ae.setValue(B,"receiveShadow",z.receiveShadow)),$.isMeshGouraudMaterial&&$.envMap!==null&&(Gn.envMap.value=Dt,Gn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),$.isMeshStandardMaterial&&$.envMap===null&&O.environment!==null&&(Gn.envMapIntensity.value=O.environmentIntensity),pn&&(Ae.setValue(B,"toneMappingExposure",x.toneMappingExposure),kt.needsLights&&fs(Gn,ds),ut&&$.fog===!0&&_t.refreshFogUniforms(Gn,ut),_t.refreshMaterialUniforms(Gn,$,Q,J,d.state.transmissionRenderTarget[b.id]),ua.upload(B,mo(kt),Gn,P)),$.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(ua.upload(B,mo(kt),Gn,P),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Ae.setValue(B,"center",z.center),Ae.setValue(B,"modelViewMatrix",z.modelViewMatrix),Ae.setValue(B,"normalMatrix",z.normalMatrix),Ae.setValue(B,"modelMatrix",z.matrixWorld),$.isShaderMaterial||$.isRawShaderMaterial){const vn=$.uniformsGroups;for(let vi=0,ni=vn.length;vi<ni;vi++){const Hs=vn[vi];k.update(Hs,An),k.bind(Hs,An)}}return An}function fs(b,O){b.ambientLightColor.needsUpdate=O,b.lightProbe.needsUpdate=O,b.directionalLights.needsUpdate=O,b.directionalLightShadows.needsUpdate=O,b.pointLights.needsUpdate=O,b.pointLightShadows.needsUpdate=O,b.spotLights.needsUpdate=O,b.spotLightShadows.needsUpdate=O,b.rectAreaLights.needsUpdate=O,b.hemisphereLights.needsUpdate=O}function go(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return R},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return U},this.setRenderTargetTextures=function(b,O,X){Pt.get(b.texture).__webglTexture=O,Pt.get(b.depthTexture).__webglTexture=X;const $=Pt.get(b);$.__hasExternalTextures=!0,$.__autoAllocateDepthBuffer=X===void 0,$.__autoAllocateDepthBuffer||Jt.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),$.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(b,O){const X=Pt.get(b);X.__webglFramebuffer=O,X.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(b,O=0,X=0){U=b,R=O,D=X;let $=!0,z=null,ut=!1,yt=!1;if(b){const Dt=Pt.get(b);if(Dt.__useDefaultFramebuffer!==void 0)Vt.bindFramebuffer(B.FRAMEBUFFER,null),$=!1;else if(Dt.__webglFramebuffer===void 0)P.setupRenderTarget(b);else if(Dt.__hasExternalTextures)P.rebindTextures(b,Pt.get(b.texture).__webglTexture,Pt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const Ut=b.depthTexture;if(Dt.__boundDepthTexture!==Ut){if(Ut!==null&&Pt.has(Ut)&&(b.width!==Ut.image.width||b.height!==Ut.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(b)}}const Gt=b.texture;(Gt.isData3DTexture||Gt.isDataArrayTexture||Gt.isCompressedArrayTexture)&&(yt=!0);const Xt=Pt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(Xt[O])?z=Xt[O][X]:z=Xt[O],ut=!0):b.samples>0&&P.useMultisampledRTT(b)===!1?z=Pt.get(b).__webglMultisampledFramebuffer:Array.isArray(Xt)?z=Xt[X]:z=Xt,C.copy(b.viewport),H.copy(b.scissor),N=b.scissorTest}else C.copy(mt).multiplyScalar(Q).floor(),H.copy(Mt).multiplyScalar(Q).floor(),N=pt;if(Vt.bindFramebuffer(B.FRAMEBUFFER,z)&&$&&Vt.drawBuffers(b,z),Vt.viewport(C),Vt.scissor(H),Vt.setScissorTest(N),ut){const Dt=Pt.get(b.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+O,Dt.__webglTexture,X)}else if(yt){const Dt=Pt.get(b.texture),Gt=O||0;B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,Dt.__webglTexture,X||0,Gt)}T=-1},this.readRenderTargetPixels=function(b,O,X,$,z,ut,yt){if(!(b&&b.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){Vt.bindFramebuffer(B.FRAMEBUFFER,Ft);try{const Dt=b.texture,Gt=Dt.format,Xt=Dt.type;if(!ee.textureFormatReadable(Gt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!ee.textureTypeReadable(Xt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=b.width-$&&X>=0&&X<=b.height-z&&B.readPixels(O,X,$,z,qt.convert(Gt),qt.convert(Xt),ut)}finally{const Dt=U!==null?Pt.get(U).__webglFramebuffer:null;Vt.bindFramebuffer(B.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(b,O,X,$,z,ut,yt){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){const Dt=b.texture,Gt=Dt.format,Xt=Dt.type;if(!ee.textureFormatReadable(Gt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!ee.textureTypeReadable(Xt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(O>=0&&O<=b.width-$&&X>=0&&X<=b.height-z){Vt.bindFramebuffer(B.FRAMEBUFFER,Ft);const Ut=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.bufferData(B.PIXEL_PACK_BUFFER,ut.byteLength,B.STREAM_READ),B.readPixels(O,X,$,z,qt.convert(Gt),qt.convert(Xt),0);const oe=U!==null?Pt.get(U).__webglFramebuffer:null;Vt.bindFramebuffer(B.FRAMEBUFFER,oe);const ye=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Z_(B,ye,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,ut),B.deleteBuffer(Ut),B.deleteSync(ye),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(b,O=null,X=0){b.isTexture!==!0&&(to("WebGLRenderer: copyFramebufferToTexture function signature has changed."),O=arguments[0]||null,b=arguments[1]);const $=Math.pow(2,-X),z=Math.floor(b.image.width*$),ut=Math.floor(b.image.height*$),yt=O!==null?O.x:0,Ft=O!==null?O.y:0;P.setTexture2D(b,0),B.copyTexSubImage2D(B.TEXTURE_2D,X,0,0,yt,Ft,z,ut),Vt.unbindTexture()},this.copyTextureToTexture=function(b,O,X=null,$=null,z=0){b.isTexture!==!0&&(to("WebGLRenderer: copyTextureToTexture function signature has changed."),$=arguments[0]||null,b=arguments[1],O=arguments[2],z=arguments[3]||0,X=null);let ut,yt,Ft,Dt,Gt,Xt,Ut,oe,ye;const be=b.isCompressedTexture?b.mipmaps[z]:b.image;X!==null?(ut=X.max.x-X.min.x,yt=X.max.y-X.min.y,Ft=X.isBox3?X.max.z-X.min.z:1,Dt=X.min.x,Gt=X.min.y,Xt=X.isBox3?X.min.z:0):(ut=be.width,yt=be.height,Ft=be.depth||1,Dt=0,Gt=0,Xt=0),$!==null?(Ut=$.x,oe=$.y,ye=$.z):(Ut=0,oe=0,ye=0);const sn=qt.convert(O.format),he=qt.convert(O.type);let kt;O.isData3DTexture?(P.setTexture3D(O,0),kt=B.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(P.setTexture2DArray(O,0),kt=B.TEXTURE_2D_ARRAY):(P.setTexture2D(O,0),kt=B.TEXTURE_2D),B.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,O.flipY),B.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),B.pixelStorei(B.UNPACK_ALIGNMENT,O.unpackAlignment);const ke=B.getParameter(B.UNPACK_ROW_LENGTH),me=B.getParameter(B.UNPACK_IMAGE_HEIGHT),An=B.getParameter(B.UNPACK_SKIP_PIXELS),_i=B.getParameter(B.UNPACK_SKIP_ROWS),pn=B.getParameter(B.UNPACK_SKIP_IMAGES);B.pixelStorei(B.UNPACK_ROW_LENGTH,be.width),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,be.height),B.pixelStorei(B.UNPACK_SKIP_PIXELS,Dt),B.pixelStorei(B.UNPACK_SKIP_ROWS,Gt),B.pixelStorei(B.UNPACK_SKIP_IMAGES,Xt);const ds=b.isDataArrayTexture||b.isData3DTexture,Ae=O.isDataArrayTexture||O.isData3DTexture;if(b.isRenderTargetTexture||b.isDepthTexture){const Gn=Pt.get(b),Xi=Pt.get(O),vn=Pt.get(Gn.__renderTarget),vi=Pt.get(Xi.__renderTarget);Vt.bindFramebuffer(B.READ_FRAMEBUFFER,vn.__webglFramebuffer),Vt.bindFramebuffer(B.DRAW_FRAMEBUFFER,vi.__webglFramebuffer);for(let ni=0;ni<Ft;ni++)ds&&B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(b).__webglTexture,z,Xt+ni),b.isDepthTexture?(Ae&&B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(O).__webglTexture,z,ye+ni),B.blitFramebuffer(Dt,Gt,ut,yt,Ut,oe,ut,yt,B.DEPTH_BUFFER_BIT,B.NEAREST)):Ae?B.copyTexSubImage3D(kt,z,Ut,oe,ye+ni,Dt,Gt,ut,yt):B.copyTexSubImage2D(kt,z,Ut,oe,ye+ni,Dt,Gt,ut,yt);Vt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Vt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Ae?b.isDataTexture||b.isData3DTexture?B.texSubImage3D(kt,z,Ut,oe,ye,ut,yt,Ft,sn,he,be.data):O.isCompressedArrayTexture?B.compressedTexSubImage3D(kt,z,Ut,oe,ye,ut,yt,Ft,sn,be.data):B.texSubImage3D(kt,z,Ut,oe,ye,ut,yt,Ft,sn,he,be):b.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,z,Ut,oe,ut,yt,sn,he,be.data):b.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,z,Ut,oe,be.width,be.height,sn,be.data):B.texSubImage2D(B.TEXTURE_2D,z,Ut,oe,ut,yt,sn,he,be);B.pixelStorei(B.UNPACK_ROW_LENGTH,ke),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,me),B.pixelStorei(B.UNPACK_SKIP_PIXELS,An),B.pixelStorei(B.UNPACK_SKIP_ROWS,_i),B.pixelStorei(B.UNPACK_SKIP_IMAGES,pn),z===0&&O.generateMipmaps&&B.generateMipmap(kt),Vt.unbindTexture()},this.copyTextureToTexture3D=function(b,O,X=null,$=null,z=0){return b.isTexture!==!0&&(to("WebGLRenderer: copyTextureToTexture3D function signature has changed."),X=arguments[0]||null,$=arguments[1]||null,b=arguments[2],O=arguments[3],z=arguments[4]||0),to('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(b,O,X,$,z)},this.initRenderTarget=function(b){Pt.get(b).__webglFramebuffer===void 0&&P.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?P.setTextureCube(b,0):b.isData3DTexture?P.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?P.setTexture2DArray(b,0):P.setTexture2D(b,0),Vt.unbindTexture()},this.resetState=function(){R=0,D=0,U=null,Vt.reset(),pe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=ge._getDrawingBufferColorSpace(t),e.unpackColorSpace=ge._getUnpackColorSpace()}}let Lf=class extends Je{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new wi,this.environmentIntensity=1,this.environmentRotation=new wi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};class Cr extends ks{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new fe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const _a=new G,va=new G,Df=new ze,Kr=new ou,$o=new fo,Cl=new G,Uf=new G;class Ia extends Je{constructor(t=new en,e=new Cr){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)_a.fromBufferAttribute(e,s-1),va.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=_a.distanceTo(va);t.setAttribute("lineDistance",new He(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),$o.copy(n.boundingSphere),$o.applyMatrix4(s),$o.radius+=r,t.ray.intersectsSphere($o)===!1)return;Df.copy(s).invert(),Kr.copy(t.ray).applyMatrix4(Df);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){const p=Math.max(0,o.start),_=Math.min(h.count,o.start+o.count);for(let v=p,m=_-1;v<m;v+=c){const d=h.getX(v),E=h.getX(v+1),w=qo(this,t,Kr,l,d,E);w&&e.push(w)}if(this.isLineLoop){const v=h.getX(_-1),m=h.getX(p),d=qo(this,t,Kr,l,v,m);d&&e.push(d)}}else{const p=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let v=p,m=_-1;v<m;v+=c){const d=qo(this,t,Kr,l,v,v+1);d&&e.push(d)}if(this.isLineLoop){const v=qo(this,t,Kr,l,_-1,p);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function qo(i,t,e,n,s,r){const o=i.geometry.attributes.position;if(_a.fromBufferAttribute(o,s),va.fromBufferAttribute(o,r),e.distanceSqToSegment(_a,va,Cl,Uf)>n)return;Cl.applyMatrix4(i.matrixWorld);const l=t.ray.origin.distanceTo(Cl);if(!(l<t.near||l>t.far))return{distance:l,point:Uf.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}const If=new G,Nf=new G;class cy extends Ia{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)If.fromBufferAttribute(e,s),Nf.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+If.distanceTo(Nf);t.setAttribute("lineDistance",new He(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class vp extends ks{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new fe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const Ff=new ze,Uc=new ou,Yo=new fo,Ko=new G;class uy extends Je{constructor(t=new en,e=new vp){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Yo.copy(n.boundingSphere),Yo.applyMatrix4(s),Yo.radius+=r,t.ray.intersectsSphere(Yo)===!1)return;Ff.copy(s).invert(),Uc.copy(t.ray).applyMatrix4(Ff);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){const f=Math.max(0,o.start),p=Math.min(c.count,o.start+o.count);for(let _=f,v=p;_<v;_++){const m=c.getX(_);Ko.fromBufferAttribute(u,m),Of(Ko,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,v=p;_<v;_++)Ko.fromBufferAttribute(u,_),Of(Ko,_,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Of(i,t,e,n,s,r,o){const a=Uc.distanceSqToPoint(i);if(a<e){const l=new G;Uc.closestPointToPoint(i,l),l.applyMatrix4(n);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class uu extends en{constructor(t=[new le(0,-.5),new le(.5,0),new le(0,.5)],e=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:n,phiLength:s},e=Math.floor(e),s=En(s,0,Math.PI*2);const r=[],o=[],a=[],l=[],c=[],h=1/e,u=new G,f=new le,p=new G,_=new G,v=new G;let m=0,d=0;for(let E=0;E<=t.length-1;E++)switch(E){case 0:m=t[E+1].x-t[E].x,d=t[E+1].y-t[E].y,p.x=d*1,p.y=-m,p.z=d*0,v.copy(p),p.normalize(),l.push(p.x,p.y,p.z);break;case t.length-1:l.push(v.x,v.y,v.z);break;default:m=t[E+1].x-t[E].x,d=t[E+1].y-t[E].y,p.x=d*1,p.y=-m,p.z=d*0,_.copy(p),p.x+=v.x,p.y+=v.y,p.z+=v.z,p.normalize(),l.push(p.x,p.y,p.z),v.copy(_)}for(let E=0;E<=e;E++){const w=n+E*h*s,x=Math.sin(w),I=Math.cos(w);for(let R=0;R<=t.length-1;R++){u.x=t[R].x*x,u.y=t[R].y,u.z=t[R].x*I,o.push(u.x,u.y,u.z),f.x=E/e,f.y=R/(t.length-1),a.push(f.x,f.y);const D=l[3*R+0]*x,U=l[3*R+1],T=l[3*R+0]*I;c.push(D,U,T)}}for(let E=0;E<e;E++)for(let w=0;w<t.length-1;w++){const x=w+E*t.length,I=x,R=x+t.length,D=x+t.length+1,U=x+1;r.push(I,R,U),r.push(D,U,R)}this.setIndex(r),this.setAttribute("position",new He(o,3)),this.setAttribute("uv",new He(a,2)),this.setAttribute("normal",new He(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new uu(t.points,t.segments,t.phiStart,t.phiLength)}}class hu extends en{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const h=[],u=[],f=[],p=[];let _=0;const v=[],m=n/2;let d=0;E(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new He(u,3)),this.setAttribute("normal",new He(f,3)),this.setAttribute("uv",new He(p,2));function E(){const x=new G,I=new G;let R=0;const D=(e-t)/n;for(let U=0;U<=r;U++){const T=[],S=U/r,C=S*(e-t)+t;for(let H=0;H<=s;H++){const N=H/s,V=N*l+a,j=Math.sin(V),K=Math.cos(V);I.x=C*j,I.y=-S*n+m,I.z=C*K,u.push(I.x,I.y,I.z),x.set(j,D,K).normalize(),f.push(x.x,x.y,x.z),p.push(N,1-S),T.push(_++)}v.push(T)}for(let U=0;U<s;U++)for(let T=0;T<r;T++){const S=v[T][U],C=v[T+1][U],H=v[T+1][U+1],N=v[T][U+1];(t>0||T!==0)&&(h.push(S,C,N),R+=3),(e>0||T!==r-1)&&(h.push(C,H,N),R+=3)}c.addGroup(d,R,0),d+=R}function w(x){const I=_,R=new le,D=new G;let U=0;const T=x===!0?t:e,S=x===!0?1:-1;for(let H=1;H<=s;H++)u.push(0,m*S,0),f.push(0,S,0),p.push(.5,.5),_++;const C=_;for(let H=0;H<=s;H++){const V=H/s*l+a,j=Math.cos(V),K=Math.sin(V);D.x=T*K,D.y=m*S,D.z=T*j,u.push(D.x,D.y,D.z),f.push(0,S,0),R.x=j*.5+.5,R.y=K*.5*S+.5,p.push(R.x,R.y),_++}for(let H=0;H<s;H++){const N=I+H,V=C+H;x===!0?h.push(V,V+1,N):h.push(V+1,V,N),U+=3}c.addGroup(d,U,x===!0?1:2),d+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new hu(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}const jo=new G,Zo=new G,Pl=new G,Jo=new Jn;class hy extends en{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){const s=Math.pow(10,4),r=Math.cos(ca*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),f={},p=[];for(let _=0;_<l;_+=3){o?(c[0]=o.getX(_),c[1]=o.getX(_+1),c[2]=o.getX(_+2)):(c[0]=_,c[1]=_+1,c[2]=_+2);const{a:v,b:m,c:d}=Jo;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),Jo.getNormal(Pl),u[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let E=0;E<3;E++){const w=(E+1)%3,x=u[E],I=u[w],R=Jo[h[E]],D=Jo[h[w]],U=`${x}_${I}`,T=`${I}_${x}`;T in f&&f[T]?(Pl.dot(f[T].normal)<=r&&(p.push(R.x,R.y,R.z),p.push(D.x,D.y,D.z)),f[T]=null):U in f||(f[U]={index0:c[E],index1:c[w],normal:Pl.clone()})}}for(const _ in f)if(f[_]){const{index0:v,index1:m}=f[_];jo.fromBufferAttribute(a,v),Zo.fromBufferAttribute(a,m),p.push(jo.x,jo.y,jo.z),p.push(Zo.x,Zo.y,Zo.z)}this.setAttribute("position",new He(p,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}}class fu extends en{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));const l=Math.min(o+a,Math.PI);let c=0;const h=[],u=new G,f=new G,p=[],_=[],v=[],m=[];for(let d=0;d<=n;d++){const E=[],w=d/n;let x=0;d===0&&o===0?x=.5/e:d===n&&l===Math.PI&&(x=-.5/e);for(let I=0;I<=e;I++){const R=I/e;u.x=-t*Math.cos(s+R*r)*Math.sin(o+w*a),u.y=t*Math.cos(o+w*a),u.z=t*Math.sin(s+R*r)*Math.sin(o+w*a),_.push(u.x,u.y,u.z),f.copy(u).normalize(),v.push(f.x,f.y,f.z),m.push(R+x,1-w),E.push(c++)}h.push(E)}for(let d=0;d<n;d++)for(let E=0;E<e;E++){const w=h[d][E+1],x=h[d][E],I=h[d+1][E],R=h[d+1][E+1];(d!==0||o>0)&&p.push(w,x,R),(d!==n-1||l<Math.PI)&&p.push(x,I,R)}this.setIndex(p),this.setAttribute("position",new He(_,3)),this.setAttribute("normal",new He(v,3)),this.setAttribute("uv",new He(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new fu(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}}class du extends en{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);const o=[],a=[],l=[],c=[],h=new G,u=new G,f=new G;for(let p=0;p<=n;p++)for(let _=0;_<=s;_++){const v=_/s*r,m=p/n*Math.PI*2;u.x=(t+e*Math.cos(m))*Math.cos(v),u.y=(t+e*Math.cos(m))*Math.sin(v),u.z=e*Math.sin(m),a.push(u.x,u.y,u.z),h.x=t*Math.cos(v),h.y=t*Math.sin(v),f.subVectors(u,h).normalize(),l.push(f.x,f.y,f.z),c.push(_/s),c.push(p/n)}for(let p=1;p<=n;p++)for(let _=1;_<=s;_++){const v=(s+1)*p+_-1,m=(s+1)*(p-1)+_-1,d=(s+1)*(p-1)+_,E=(s+1)*p+_;o.push(v,m,E),o.push(m,d,E)}this.setIndex(o),this.setAttribute("position",new He(a,3)),this.setAttribute("normal",new He(l,3)),this.setAttribute("uv",new He(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new du(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class fy extends ks{static get type(){return"MeshLambertMaterial"}constructor(t){super(),this.isMeshLambertMaterial=!0,this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=tp,this.normalScale=new le(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=Qc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class xp extends Cr{static get type(){return"LineDashedMaterial"}constructor(t){super(),this.isLineDashedMaterial=!0,this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}}class Mp extends Je{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new fe(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class dy extends Mp{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Je.DEFAULT_UP),this.updateMatrix(),this.groundColor=new fe(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const Ll=new ze,kf=new G,Bf=new G;class py{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new le(512,512),this.map=null,this.mapPass=null,this.matrix=new ze,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new au,this._frameExtents=new le(1,1),this._viewportCount=1,this._viewports=[new We(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,n=this.matrix;kf.setFromMatrixPosition(t.matrixWorld),e.position.copy(kf),Bf.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Bf),e.updateMatrixWorld(),Ll.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Ll),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Ll)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class my extends py{constructor(){super(new lu(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class gy extends Mp{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Je.DEFAULT_UP),this.updateMatrix(),this.target=new Je,this.shadow=new my}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Jc}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Jc);const jn={measured:8176895,predicted:16758354,wall:7309989,boundary:12173984,truth:15922680,ok:5691056};function ss(i,t){return new fy({color:i,...t})}function Oi(i,t,e,n,s){const r=new Tn(new hu(t,e,n,32),i);return r.rotation.z=-Math.PI/2,r.position.x=s,r}function so(i,t,e,n,s,r,o){const a=new Tn(new Nr(s,r,o),i);return a.position.set(t,e,n),a}function Sp(i,t,e,n,s,r){const o=new pi;for(const a of[-1,1]){o.add(so(t,e,0,a*(n+s/2),r,.015,s));for(let l=0;l<4;l+=1){const c=a*(n+s*(l+.5)/4);o.add(so(i,e,.012,c,r*.94,.012,s/4*.9))}o.add(so(t,e,0,a*n/2+a*.1,.04,.03,n))}return o}function yp(){const i=new pi,t=ss(14015458),e=ss(3819090),n=ss(12160844);return i.add(Oi(e,.13,.16,.1,-.05)),i.add(Oi(t,.17,.3,.2,-.2)),i.add(Oi(t,.3,.3,.5,-.55)),i.add(Oi(n,.3,.26,.22,-.91)),i.add(Oi(e,.09,.16,.16,-1.09)),i.add(Sp(ss(2576522),e,-.7,.34,.95,.34)),i}function zf(i){const t=yp(),e=new cs({color:i,transparent:!0,opacity:.16,depthWrite:!1}),n=new Cr({color:i,transparent:!0,opacity:.75}),s=[];t.traverse(r=>{r.isMesh&&s.push(r)});for(const r of s)r.material=e,r.add(new cy(new hy(r.geometry,40),n));return t}function _y(i){const t=new pi,e=ss(12831442),n=ss(3358281);t.add(Oi(n,.24,.2,.14,.08)),t.add(Oi(e,.5,.26,.3,.3)),t.add(Oi(e,.5,.5,1.5,1.2)),t.add(Oi(ss(11450046),.3,.5,.35,2.1)),t.add(Sp(ss(2576522),n,1.25,.55,2.1,.8));const s=new cs({color:15922680});t.add(so(s,0,0,0,.01,.3,.025),so(s,0,0,0,.01,.025,.3));const r=new Tn(new du(i,.012,10,72),new cs({color:jn.ok}));return r.rotation.y=Math.PI/2,t.add(r),t}function Hf(i,t,e){const n=[];for(let s=0;s<=64;s+=1){const r=s/64*2*Math.PI;n.push(new G(i,t*Math.cos(r),t*Math.sin(r)))}return new Ia(new en().setFromPoints(n),e)}function Qo(i,t,e,n){const s=new pi;for(let r=0;r<e;r+=1){const o=r/e*2*Math.PI,a=i.map((c,h)=>new G(c,t[h]*Math.cos(o),t[h]*Math.sin(o))),l=new Ia(new en().setFromPoints(a),n);l.computeLineDistances(),s.add(l)}return s}function vy({x:i,wall:t,boundary:e}){const n=new pi,s=new Cr({color:jn.wall,transparent:!0,opacity:.8}),r=new Cr({color:jn.wall,transparent:!0,opacity:.38}),o=new cs({color:jn.wall,transparent:!0,opacity:.05,side:fi,depthWrite:!1}),a=i.map((u,f)=>new le(t[f],u)),l=new Tn(new uu(a,48),o);l.rotation.z=-Math.PI/2,n.add(l),n.add(Qo([i[0],i[i.length-1]],[t[0],t[t.length-1]],4,s)),n.add(Qo([i[0],i[i.length-1]],[t[0],t[t.length-1]],12,r));for(let u=Math.ceil(i[0]/5)*5;u<=-5;u+=5)n.add(Hf(u,xa(i,t,u),u%10===0?s:r));const c=new xp({color:jn.boundary,dashSize:.35,gapSize:.22,transparent:!0,opacity:.85});n.add(Qo(i,e,4,c));for(const u of[-10,-20,-30])n.add(Hf(u,xa(i,e,u),c).computeLineDistances());const h=Qo([i[0],0],[0,0],1,r);return n.add(h),n}function xa(i,t,e){const n=(e-i[0])/(i[i.length-1]-i[0]),s=Math.max(0,Math.min(i.length-1,n*(i.length-1))),r=Math.min(Math.floor(s),i.length-2);return t[r]+(t[r+1]-t[r])*(s-r)}function xy(){const i=new pi,t=[];let e=7;const n=()=>(e=e*16807%2147483647,e/2147483647);for(let h=0;h<1400;h+=1){const u=2*n()-1,f=2*Math.PI*n(),p=Math.sqrt(1-u*u);t.push(900*p*Math.cos(f),900*u,900*p*Math.sin(f))}const s=new en;s.setAttribute("position",new He(t,3)),i.add(new uy(s,new vp({color:9413562,size:1.3,sizeAttenuation:!1,transparent:!0,opacity:.7})));const r=new fu(500*(1738/1938),96,64),o=r.attributes.position,a=[],l=new G;for(let h=0;h<o.count;h+=1){l.fromBufferAttribute(o,h).normalize();const u=Math.sin(23*l.x+5*Math.sin(17*l.z))*Math.sin(19*l.z+4*Math.sin(13*l.x)),p=Math.max(.15,l.x*-.35+l.y*.75+l.z*.35)*(.115+.022*u);a.push(p*.95,p,p*1.08)}r.setAttribute("color",new He(a,3));const c=new Tn(r,new cs({vertexColors:!0}));return c.position.y=-500,i.add(c),i}class My{constructor(t,e=24,n=10){this.stations=e,this.sides=n,this.places=new Float32Array(e*n*3);const s=[];for(let o=0;o<e-1;o+=1)for(let a=0;a<n;a+=1){const l=o*n+a,c=o*n+(a+1)%n;s.push(l,c,l+n,c,c+n,l+n)}const r=new en;r.setAttribute("position",new ti(this.places,3)),r.setIndex(s),this.mesh=new Tn(r,new cs({color:t,transparent:!0,opacity:.22,side:fi,depthWrite:!1})),this.mesh.frustumCulled=!1}set(t){if(this.mesh.visible=t.length>1,!!this.mesh.visible){for(let e=0;e<this.stations;e+=1){const n=e/(this.stations-1)*(t.length-1),s=Math.min(Math.floor(n),t.length-2),r=n-s,o=l=>t[s][l]+(t[s+1][l]-t[s][l])*r,a=o(3);for(let l=0;l<this.sides;l+=1){const c=l/this.sides*2*Math.PI,h=(e*this.sides+l)*3;this.places[h]=o(0),this.places[h+1]=o(1)+a*Math.cos(c),this.places[h+2]=o(2)+a*Math.sin(c)}}this.mesh.geometry.attributes.position.needsUpdate=!0}}}class ta{constructor(t,e,n){this.most=e,this.places=new Float32Array(e*3);const s=new en;s.setAttribute("position",new ti(this.places,3));const r=n?new xp({color:t,dashSize:.25,gapSize:.2}):new Cr({color:t});this.dashed=n,this.line=new Ia(s,r),this.line.frustumCulled=!1}set(t){const e=Math.max(1,Math.ceil(t.length/this.most));let n=0;for(let s=0;s<t.length&&n<this.most;s+=e,n+=1)this.places.set(t[s].slice(0,3),n*3);this.line.geometry.setDrawRange(0,n),this.line.geometry.attributes.position.needsUpdate=!0,this.dashed&&this.line.computeLineDistances(),this.line.visible=n>1}}const Cn=i=>document.getElementById(i),Dl=["x","y","z"];function un(i,t){return i==null||!Number.isFinite(i)?it.unknown:i.toFixed(t).replace("-","−")}function Vf(i){if(!i)return{};const[t,e,n,s,r,o]=i;return{range:Math.hypot(t,e,n),closing:s,offset:Math.hypot(e,n),lateral:Math.hypot(r,o),x:t,y:e,z:n}}const Gf=[["range",it.range,"m",2],["closing",it.closing,"m/s",3],["offset",it.offset,"m",2],["lateral",it.lateral,"m/s",3],["margin",it.margin,"m",2]];class Sy{constructor(){for(const[t,e,n]of Gf){const s=document.querySelector(`[data-row=${t}]`);s.innerHTML=`<span>${e}</span><b class="measured" id="m-${t}"></b><b class="predicted" id="p-${t}"></b><u class="unit">${n}</u><u id="l-${t}"></u>`}}setRun(t){Cn("l-closing").textContent=`< ${t.limits.closing}`,Cn("l-lateral").textContent=`< ${t.limits.lateral}`}show(t,e,n,s){const r=[Vf(t),Vf(e)];for(const a of r)a.x!==void 0&&(a.wall=n.limits.offset-Math.min(a.x,0)*Math.tan(n.half_angle_deg*Math.PI/180),a.margin=(a.wall-a.offset)*Math.cos(n.half_angle_deg*Math.PI/180));for(const[a,,,l]of Gf)r.forEach((c,h)=>{const u=Cn(`${h?"p":"m"}-${a}`);u.textContent=un(c[a],l),u.classList.toggle("stale-value",s&&h===0),u.classList.toggle("bad",this.bad(a,c,n))});const o=r[1].wall??r[0].wall;return Cn("l-offset").textContent=o===void 0?"":`< ${o.toFixed(2)}`,Cn("l-margin").textContent="> 0",r}bad(t,e,n){return t==="closing"?e.closing>=n.limits.closing||e.closing<=0:t==="lateral"?e.lateral>=n.limits.lateral:t==="offset"?e.offset>=e.wall:t==="margin"&&e.margin<0}}function Ep(i,t,e,n,s,r,o){const{pen:a,w:l,h:c,rem:h}=Ca(i),[u,f]=[l/2,c/2],p=Math.min(l,c)/2-.9*h,_=(n||e||[t.start[0],0,0])[0],v=Math.max(t.geometry.x[0],Math.min(_,0)),m=xa(t.geometry.x,t.geometry.wall,v),d=xa(t.geometry.x,t.geometry.boundary,v),E=p/Math.max(m*1.12,.36);a.strokeStyle=re.line,a.beginPath(),a.moveTo(u-p,f),a.lineTo(u+p,f),a.moveTo(u,f-p),a.lineTo(u,f+p),a.stroke(),ia(a,u,f,m*E,re.wall),ia(a,u,f,d*E,re.boundary,[h*.3,h*.25]),ia(a,u,f,t.limits.offset*E,re.ok),Qn(a,`${m.toFixed(2)} m`,u+m*E*.72,f-m*E*.72-h*.3,re.wall),Qn(a,"y",u+h*.3,f-p,re.dim),Qn(a,"z",u+p,f-h*.6,re.dim,"right");const w=x=>[u+x[2]*E,f-x[1]*E];if(r&&r.hit&&n){const[x,I]=[u+r.hit[1]*E,f-r.hit[0]*E],[R,D]=w(n);a.strokeStyle=re.predicted,a.setLineDash([h*.2,h*.2]),a.beginPath(),a.moveTo(R,D),a.lineTo(x,I),a.stroke(),a.setLineDash([]),Wf(a,x,I,h*.32)}if(e){const[x,I]=w(e);a.fillStyle=re.measured,a.beginPath(),a.arc(x,I,h*.3,0,7),a.fill()}if(n){const[x,I]=w(n);a.strokeStyle=re.predicted;const R=Math.max(h*.3,2*(s?Math.max(s[1],s[2]):0)*E);a.fillStyle="#ffb65230",a.beginPath(),a.arc(x,I,R,0,7),a.fill(),a.stroke();const D=10*E;a.beginPath(),a.moveTo(x,I),a.lineTo(x+n[5]*D,I-n[4]*D),a.stroke()}if(o){const[x,I]=w(o);a.strokeStyle=re.truth,Wf(a,x,I,h*.3)}Cn("section-at").textContent=fn(it.section_at,{x:un(v,1)})}function Wf(i,t,e,n){i.beginPath(),i.moveTo(t-n,e-n),i.lineTo(t+n,e+n),i.moveTo(t-n,e+n),i.lineTo(t+n,e-n),i.stroke()}class yy{constructor(){const t=[["",""],["pilot",it.pilot],["auto",it.auto],["sent",it.sent]];Cn("levels").innerHTML=t.map(([e,n])=>e?`<span class="${e==="auto"?"auto":""}">${n}</span>${Dl.map(s=>`<div class="bar" id="lv-${e}-${s}"><i></i><span></span></div>`).join("")}`:`<span></span>${Dl.map(s=>`<span class="dim">${s}</span>`).join("")}`).join("")}show(t,e,n){this.bars("pilot",t,"#7cc4ff"),this.bars("auto",e,re.auto),this.bars("sent",n&&{lv:n.lv,ok:!0},re.ok);const s=n?[e_[n.by]]:[];n&&n.w!==null&&n.by===3&&s.push(`${it.weight} ${n.w}`),n&&Ph[n.why]&&s.push(Ph[n.why]);const r=s.join(" · ");Cn("why").textContent!==r&&(Cn("why").textContent=r)}bars(t,e,n){Dl.forEach((s,r)=>{const o=Cn(`lv-${t}-${s}`),a=e&&e.ok?e.lv[r]:null,l=o.firstChild;l.style.background=n,l.style.left=`${a<0?50+a/3*48:50}%`,l.style.width=`${Math.abs(a||0)/3*48}%`,o.lastChild.textContent=a===null?it.unknown:a>0?`+${a}`:`${a}`.replace("-","−")})}}function vr(i,t,e,n){const s=Cn(`clock-${i}`);s.textContent=t===null?it.unknown:`${un(t,1)} s`,Cn(`clock-${i}-age`).textContent=e,s.parentElement.classList.toggle("stale",!!n)}function bp(i,t,e,n){const{pen:s,w:r,h:o,rem:a}=Ca(i),[l,c,h]=[r/2,o*.56,Math.min(r/2,o*.56)-a*.5],u=t.forward_s+t.back_s,f=Math.max(u*1.5,1),p=v=>Math.PI*(.8+1.4*Math.max(0,Math.min(1,v/f)));s.lineWidth=a*.45,s.strokeStyle="#1b2733",s.beginPath(),s.arc(l,c,h,p(0),p(f)),s.stroke(),e!==void 0&&(s.strokeStyle=e>u+1?re.alarm:re.measured,s.beginPath(),s.arc(l,c,h,p(0),p(e)),s.stroke()),n&&(s.lineWidth=a*.16,s.strokeStyle=re.boundary,s.beginPath(),s.arc(l,c,h-a*.5,p(0),p(n)),s.stroke()),s.strokeStyle=re.text,s.lineWidth=a*.12;const _=p(u);s.beginPath(),s.moveTo(l+(h-a*.4)*Math.cos(_),c+(h-a*.4)*Math.sin(_)),s.lineTo(l+(h+a*.4)*Math.cos(_),c+(h+a*.4)*Math.sin(_)),s.stroke(),s.font=`600 ${1.35*a}px system-ui, sans-serif`,Qn(s,e===void 0?it.unknown:`${e.toFixed(1)} s`,l,c-a*.05,re.text,"center"),s.font=`${.7*a}px system-ui, sans-serif`,Qn(s,`${t.forward_s} + ${t.back_s} s`,l,c+a*1.05,re.dim,"center")}function Tp(i,t){const{link:e,tm:n,gap:s}=i,r=[[it.link.transit,n?`${un(n.transit,2)} s`:it.unknown]];e&&r.push([it.link.p99,`${un(e.delay_p99,2)} s`],[it.link.lost,e.lost+e.outage],[it.link.late,e.late],[it.link.corrupted,e.corrupted]),r.push([it.link.gap,s?fn(it.ago,{s:un((i.k-s.k)*t,0)}):it.unknown]);const o=r.map(([a,l])=>`<dt>${a}</dt><dd>${l}</dd>`).join("");Cn("link-counts").innerHTML!==o&&(Cn("link-counts").innerHTML=o)}function Ey(i,t,e,n,s){const{pen:r,w:o,h:a,rem:l}=Ca(i),[c,h]=[o/2,a/2];r.strokeStyle="#dbe5ee90",r.beginPath(),r.moveTo(c-o*.3,h),r.lineTo(c-l,h),r.moveTo(c+l,h),r.lineTo(c+o*.3,h),r.moveTo(c,h-a*.36),r.lineTo(c,h-l),r.moveTo(c,h+l),r.lineTo(c,h+a*.36);for(let f=-3;f<=3;f+=1)f&&(r.moveTo(c+f*o*.1,h-l*.25),r.lineTo(c+f*o*.1,h+l*.25));if(r.stroke(),!n)return;const u=t.onCamera([0,0,0]);if(u){const f=c+u[0]*o/2,p=h-u[1]*a/2,_=e.limits.offset/Math.max(-n[0],.05)/t.dockTan*(a/2);ia(r,f,p,Math.min(_,a),re.ok),r.strokeStyle="#56d6b080",r.beginPath(),r.moveTo(c,h),r.lineTo(f,p),r.stroke()}if(s&&n[0]<-.2){const f=t.onCamera([0,n[1]-s[1],n[2]-s[2]]);if(f){r.strokeStyle=re.predicted;const p=c+f[0]*o/2,_=h-f[1]*a/2;r.strokeRect(p-l*.35,_-l*.35,l*.7,l*.7)}}by(r,o,a,l,e,n[3],s?s[3]:null),Qn(r,`${un(Math.hypot(n[0],n[1],n[2]),1)} m`,l*.6,a-l*.9,re.measured)}function by(i,t,e,n,s,r,o){const[a,l,c]=[t-n*2.9,n*1.5,e-n*1.2],h=s.limits.closing*1.34,u=p=>c-Math.max(0,Math.min(h,p))/h*(c-l);i.strokeStyle="#dbe5eea0",i.beginPath(),i.moveTo(a,l),i.lineTo(a,c);for(let p=0;p<=h+1e-9;p+=.05){const _=Math.round(p*100)%10===0;i.moveTo(a,u(p)),i.lineTo(a+n*(_?.5:.25),u(p)),_&&Qn(i,p.toFixed(1),a+n*.65,u(p),re.text)}i.stroke(),i.strokeStyle=re.alarm,i.beginPath(),i.moveTo(a-n*.5,u(s.limits.closing)),i.lineTo(a+n*.5,u(s.limits.closing)),i.stroke();const f=(p,_,v)=>{if(p===null||!Number.isFinite(p))return;const m=u(p);i.beginPath(),i.moveTo(a-n*.1,m),i.lineTo(a-n*.75,m-n*.36),i.lineTo(a-n*.75,m+n*.36),i.closePath(),v?(i.strokeStyle=_,i.stroke()):(i.fillStyle=_,i.fill())};f(r,re.measured,!1),f(o,re.predicted,!0),Qn(i,"m/s",a,l-n*.7,re.dim,"center")}const Ic=()=>document.getElementById("dialog");function Bs(i,t){const e=Ic();e.innerHTML=i,e.open||e.showModal();for(const n of e.querySelectorAll("[data-close]"))n.onclick=()=>e.close();return t&&t(e),e}function pu(){Ic().open&&Ic().close()}const po=`<button data-close>${it.close}</button>`;function zi(i){const t=document.createElement("span");return t.textContent=i,t.innerHTML}function mu(i,t){Bs(`<h3>${zi(i)}</h3><p>${zi(t)}</p><div class="buttons">${po}</div>`)}function wp(){const i=t_.map(([t,e])=>t?`<tr><td><kbd>${t}</kbd></td><td>${e}</td></tr>`:`<tr><td colspan="2">${e}</td></tr>`);Bs(`<h3>${it.help_title}</h3><table>${i.join("")}</table><div class="buttons">${po}</div>`)}function gu(i){return i_[i]||i}function Ty(i,t){if(!i.can.fly){mu(it.new_run,it.no_fly);return}const e=i.frame?.mode||i.run?.mode||"shared",n=["manual","shared","auto"].map(s=>`<option value="${s}" ${s===e?"selected":""}>${it[`mode_${s}`]}</option>`);Bs(`<h3>${it.new_run}</h3><p>${it.new_run_text}</p>
    <p><label>${it.mode} <select id="new-mode">${n.join("")}</select></label>
    &nbsp; <label>${it.seed} <input id="new-seed" size="8" inputmode="numeric" placeholder="${it.seed_hint}"></label></p>
    <p id="new-error" class="alarm"></p>
    <div class="buttons"><button data-close>${it.cancel}</button><button class="primary" id="new-start">${it.start}</button></div>`,s=>{const r=async()=>{const o=s.querySelector("#new-seed").value.trim(),a={do:"fly",mode:s.querySelector("#new-mode").value};o&&(a.seed=Number(o));const l=await t(a);l.ok?s.close():s.querySelector("#new-error").textContent=gu(l.code)};s.querySelector("#new-start").onclick=r,s.querySelector("#new-seed").onkeydown=o=>{o.key==="Enter"&&r()},s.querySelector("#new-start").focus()})}function wy(i,t,e){const n=i.success,s=(r,o,a,l)=>`<tr><th>${r}</th><td>${un(o,a)} ${l}</td></tr>`;Bs(`<h3>${it.verdict_title}</h3>
    <p class="verdict ${n?"ok":"alarm"}" id="verdict-words">${n?"✓":"✗"} ${it.verdict[i.reason]||zi(i.reason)}</p>
    <table>${s(it.verdict_time,i.duration,1,"s")}${s(it.verdict_closing,i.closing,4,"m/s")}
    ${s(it.verdict_offset,i.offset,3,"m")}${s(it.verdict_lateral,i.lateral,4,"m/s")}
    ${s(it.verdict_margin,i.margin,3,"m")}${s(it.verdict_dv,i.delta_v,3,"m/s")}</table>
    <div class="buttons">${po}${t?`<button class="primary" id="again">${it.fly_again}</button>`:""}</div>`,r=>{const o=r.querySelector("#again");o&&(o.onclick=()=>{r.close(),e()})})}function Ap(i){const t=i.settings,e=n=>`<tr><td>${it[`settings_${n}`]}</td>
    <td><label>${it.settings_axis} <input type="number" min="0" max="15" style="width:4em" data-axis="${n}" value="${t[n].axis}"></label></td>
    <td><label><input type="checkbox" data-invert="${n}" ${t[n].sign<0?"checked":""}> ${it.settings_invert}</label></td></tr>`;Bs(`<h3>${it.settings_title}</h3><p id="pad-name">${i.gamepad?zi(fn(it.settings_found,{name:i.gamepad.id})):it.settings_none}</p>
    <table>${e("x")}${e("y")}${e("z")}</table>
    <p><label>${it.settings_button} <input type="number" min="0" max="31" style="width:4em" id="pad-button" value="${t.button}"></label></p>
    <p><label>${it.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${t.deadZone}"></label></p>
    <p><label><input type="checkbox" id="hold-space" ${t.holdSpace?"checked":""}> ${it.settings_space}</label></p>
    <div class="buttons">${po}</div>`,n=>{n.onchange=()=>{const s=r=>({axis:Number(n.querySelector(`[data-axis=${r}]`).value),sign:n.querySelector(`[data-invert=${r}]`).checked?-1:1});i.change({x:s("x"),y:s("y"),z:s("z"),button:Number(n.querySelector("#pad-button").value),deadZone:Number(n.querySelector("#pad-zone").value),holdSpace:n.querySelector("#hold-space").checked})}})}function Ay(i,t){const e=i.map(n=>`<tr><td>${zi(n.name)}</td><td>${zi(n.mode||"")}</td>
    <td class="${n.success?"ok":""}">${n.success?"✓":"✗"} ${zi(it.verdict[n.reason]||n.reason||"")}</td>
    <td><button data-run="${zi(n.name)}">${it.review_open}</button></td></tr>`);Bs(`<h3>${it.review_title}</h3><p class="dim">${it.review_truth}</p>
    ${i.length?`<table>${e.join("")}</table>`:`<p>${it.review_none}</p>`}
    <p id="review-error" class="alarm"></p><div class="buttons">${po}</div>`,n=>{for(const s of n.querySelectorAll("[data-run]"))s.onclick=()=>t(s.dataset.run,n.querySelector("#review-error"))})}const Ne=it.desk,Ry=5;class Cy{constructor(t){this.link=t,this.state=null,this.mine=!1}show(t,e){const n=!this.state||JSON.stringify({...this.state,rest_s:0})!==JSON.stringify({...t,rest_s:0});this.state=t,this.mine=e,n&&this.draw()}lease(t){t!==this.mine&&(this.mine=t,this.state&&this.draw())}draw(){if(clearInterval(this.timer),!this.mine)return;const t=this.state.stage;t==="flying"?pu():this[t]()}async ask(t,e,n){const s=await this.link.ask({do:"desk",act:t,...e}),r=n?.querySelector(".error");return!s.ok&&r&&(r.textContent=Ne.errors[s.code]||gu(s.code)),s.ok}frame(t,e,n,s){const r=Bs(`<h3>${zi(t)}</h3>${e}<p class="error alarm" role="alert"></p><div class="buttons">${n}</div>`,s);return r.oncancel=o=>o.preventDefault(),r}door(){this.frame(this.state.title,`<p>${Ne.door}</p><p><label>${Ne.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,`<button class="primary" id="desk-go">${Ne.begin}</button>`,t=>{const e=()=>this.ask("begin",{volunteer:Number(t.querySelector("#volunteer").value)},t);t.querySelector("#desk-go").onclick=e,t.querySelector("#volunteer").onkeydown=n=>{n.key==="Enter"&&e()},t.querySelector("#volunteer").focus()})}heading(){return fn(Ne.heading,{who:this.state.who,n:this.state.number,of:this.state.of})}ready(){const t=this.state.training?Ne.training:Ne.counts;this.frame(this.heading(),`<p>${t}</p><p>${fn(Ne.condition,{mode:it[`mode_${this.state.mode}`]})}</p><p class="dim">${Ne.hint}</p>`,`<button class="primary" id="desk-go">${Ne.fly}</button>`,e=>{e.querySelector("#desk-go").onclick=()=>this.ask("fly",{},e),e.querySelector("#desk-go").focus()})}rest(){const t=performance.now()+this.state.rest_s*1e3;this.frame(Ne.rest_title,`<p>${Ne.rest}</p><p class="verdict" id="rest-left"></p>`,`<button class="primary" id="desk-go">${Ne.go_on}</button>`,e=>{const n=e.querySelector("#desk-go");n.onclick=()=>this.ask("go_on",{},e);const s=()=>{const r=Math.max(0,(t-performance.now())/1e3);e.querySelector("#rest-left").textContent=`${r.toFixed(0)} s`,n.disabled=r>0};s(),this.timer=setInterval(s,500)})}done(){this.frame(Ne.done_title,`<p>${fn(Ne.done,{who:this.state.who})}</p>`,`<button id="desk-go">${Ne.next}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("leave",{},t)})}rate(){this.answers={},this.question("controllable")}question(t){const e=`<button data-answer="yes">${Ne.yes}</button><button data-answer="no">${Ne.no}</button>`;this.frame(`${this.heading()} · Cooper-Harper`,`<p class="${this.state.reason==="docked"?"ok":""}">${it.verdict[this.state.reason]||""}</p><p>${Ne.tree[t]}</p>`,e,n=>{n.querySelector("[data-answer=yes]").focus();for(const s of n.querySelectorAll("[data-answer]"))s.onclick=()=>this.answered(t,s.dataset.answer==="yes")})}answered(t,e){const n=["controllable","adequate","satisfactory"];if(this.answers[t]=e,!e)for(const r of n.slice(n.indexOf(t)+1))this.answers[r]=!1;const s=n[n.indexOf(t)+1];e&&s?this.question(s):this.pick()}pick(){const{controllable:t,adequate:e,satisfactory:n}=this.answers,r=(t?e?n?[1,2,3]:[4,5,6]:[7,8,9]:[10]).map(o=>`<button data-rating="${o}"><b>${o}</b> ${Ne.ratings[o]}</button>`).join("");this.frame(`${this.heading()} · Cooper-Harper`,`<p>${Ne.pick}</p><div class="choices">${r}</div>`,`<button id="desk-back">${Ne.again}</button>`,o=>{o.querySelector("#desk-back").onclick=()=>this.rate();for(const a of o.querySelectorAll("[data-rating]"))a.onclick=()=>{this.answers.rating=Number(a.dataset.rating),this.tlx()};o.querySelector("[data-rating]").focus()})}tlx(){const t=Object.entries(Ne.tlx).map(([e,[n,s,r,o]])=>`<fieldset><legend>${n}</legend>
      <label for="tlx-${e}">${s}</label><input type="range" id="tlx-${e}" data-tlx="${e}" min="0" max="100" step="${Ry}" value="50">
      <div class="scale-ends"><span>${r}</span><output id="out-${e}">–</output><span>${o}</span></div></fieldset>`).join("");this.frame(`${this.heading()} · NASA-TLX`,t,`<button class="primary" id="desk-go" disabled>${Ne.save}</button>`,e=>{const n=new Set,s=r=>{n.add(r.dataset.tlx),e.querySelector(`#out-${r.dataset.tlx}`).textContent=r.value,e.querySelector("#desk-go").disabled=n.size<Object.keys(Ne.tlx).length};for(const r of e.querySelectorAll("[data-tlx]"))r.oninput=()=>s(r),r.onkeydown=o=>{o.key==="Enter"&&s(r)},r.onpointerup=()=>s(r);e.querySelector("#desk-go").onclick=()=>{const r=Object.fromEntries([...e.querySelectorAll("[data-tlx]")].map(o=>[o.dataset.tlx,Number(o.value)]));this.ask("rate",{cooper_harper:this.answers,tlx:r},e)}})}}const[Rp,Py,_u,Ma,vu,xu,Mu]=[0,1,2,3,4,5,6],Cp=6,Xf={[_u]:"✓",[Ma]:"✓",[vu]:"✗",[xu]:"✗",[Mu]:"?"};function Ly(i,t,e){const n=e.step_s,s=Math.max(i.due-i.sent,1);if(i.told>=0)return .8+.2*Math.min(1,(t-i.told)*n/Cp);if(t<i.due)return .05+.37*((t-i.sent)/s);const r=Math.max(e.back_s/n,1);return .46+.34*Math.min(1,(t-i.due)/r)}function Pp(i,t,e,n){const{pen:s,w:r,h:o,rem:a}=Ca(i),l=n/t.step_s,c=a*1.35,h=[[0,.05,it.ladder_ground],[.05,.42,it.ladder_link],[.42,.5,it.ladder_craft],[.5,.8,it.ladder_back],[.8,1,it.ladder_known]];for(const[p,_,v]of h)s.fillStyle=v===it.ladder_craft?"#17222e":"#0a1018",s.fillRect(p*r+1,c,(_-p)*r-2,o-c),p!==0&&Qn(s,v,(p+_)/2*r,a*.55,re.dim,"center");Qn(s,it.ladder_ground,0,a*.55,re.dim);const u=(o-c)/3;["x","y","z"].forEach((p,_)=>Qn(s,p,a*.35,c+u*(_+.5),re.dim));const f=Math.max(2,.37*r/Math.max(t.forward_s/t.step_s,8)-1);for(const p of e){const _=Ly(p,l,t);_>=1||p.told>=0&&(l-p.told)*t.step_s>Cp||Dy(s,p,_*r,c,u,Math.min(f,a),o,a)}}function Dy(i,t,e,n,s,r,o,a){const l=t.state===vu||t.state===xu,c=t.levels.some(u=>u!==0),h=t.kind===3||l?re.alarm:t.state===Ma||t.state===_u?re.ok:t.state===Mu?re.dim:t.state===Py?re.predicted:re.measured;if(i.fillStyle=h,!c&&!l&&t.kind!==3){i.globalAlpha=t.state===Ma?.25:.5;for(let u=0;u<3;u+=1)i.fillRect(e,n+s*(u+.5)-1,Math.max(r*.5,1),2);i.globalAlpha=1;return}(t.kind===3||l)&&i.fillRect(e,n,Math.max(1.5,r*.4),o-n),t.levels.forEach((u,f)=>{if(!u)return;const p=Math.abs(u)/3*s*.46,_=n+s*(f+.5);t.state===Rp&&(i.globalAlpha=.85),i.fillRect(e,u>0?_-p:_,r,p),i.globalAlpha=1}),Xf[t.state]&&l&&Qn(i,Xf[t.state],e,n+a*.4,h)}function Lp(i){const t={};for(const s of i)t[s.state]=(t[s.state]||0)+1;const n=[`${t[Rp]||0} ${it.ladder_link}`];for(const s of[_u,Ma,vu,xu,Mu])t[s]&&n.push(`${t[s]} ${n_[s]}`);return n.join(" · ")}class Uy{constructor(t,e){this.token=t,this.waiting=new Map,this.number=0,this.worker=new Worker(new URL(""+new URL("link.worker.js",import.meta.url).href,import.meta.url),{type:"module"}),this.worker.onmessage=s=>this.take(s.data,e);const n=location.protocol==="https:"?"wss":"ws";this.worker.postMessage({open:{url:`${n}://${location.host}/ws`,token:t}})}take(t,e){t.type==="reply"&&this.waiting.has(t.id)&&(this.waiting.get(t.id)(t),this.waiting.delete(t.id)),e(t)}stick(t,e){this.worker.postMessage({stick:t,now:e})}ask(t){const e=++this.number;return new Promise(n=>{this.waiting.set(e,n),this.worker.postMessage({ask:{...t,id:e}})})}async get(t){const e=await fetch(t,{headers:{Authorization:`Bearer ${this.token}`}});if(!e.ok)throw new Error((await e.text()).trim());return e.json()}}const Le=i=>document.getElementById(i),Iy=4;class Ny{constructor(t,e,n,s){Object.assign(this,{link:t,scene:e,charts:n,back:s,on:!1,run:null,at:0,playing:!1}),Le("review-close").onclick=()=>this.leave(),Le("review-play").onclick=()=>this.play(!this.playing),Le("review-time").oninput=()=>this.go(Number(Le("review-time").value)),addEventListener("keydown",r=>{this.on&&r.key==="Escape"&&!Le("dialog").open&&this.leave()})}async list(){try{Ay(await this.link.get("api/runs"),(t,e)=>this.open(t,e))}catch(t){mu(it.review_title,t.message)}}async open(t,e){e.textContent=it.review_loading;try{this.run=await this.link.get(`api/runs/${t.split("/").map(encodeURIComponent).join("/")}`)}catch(n){e.textContent=n.message;return}pu(),this.start()}start(){const{run:t}=this;this.on=!0,this.errors=Fy(t.frames),this.trail=t.frames.filter(e=>e.est?.ok&&e.pred?.ok).map(e=>[e.t,...e.est.x.slice(0,3),...e.pred.x.slice(0,3),e.pred.s?Math.max(e.pred.s[1],e.pred.s[2]):.05]),this.truths=t.frames.filter(e=>e.truth).map(e=>[e.t,...e.truth.slice(0,3)]),this.rungs=t.ladder.map(([e,n,s,r,o,a,l,c,h,u])=>({seq:e,sent:n,due:s,levels:[r,o,a],kind:l,state:c,refusal:h,told:u})),Le("scrubber").hidden=!1,Le("bottom").hidden=!0,Le("review-time").max=String(t.frames.length-1),document.querySelector("#camera .tag").textContent=it.camera_tag_review,this.scene.setRun(t),Le("run-name").textContent=`${it.review}: ${t.name}`,this.marks(),this.go(t.frames.length-1),Le("review-time").focus()}leave(){this.on=!1,this.playing=!1,Le("scrubber").hidden=!0,Le("bottom").hidden=!1,document.querySelector("#camera .tag").textContent=it.camera_tag,this.scene.place({trail:[],tube:[]}),this.back()}play(t){this.playing=t,Le("review-play").textContent=t?it.stop_play:it.play,t&&this.at>=this.run.frames.length-1&&this.go(0),this.playedAt=performance.now(),this.playedFrom=this.run.frames[this.at].t}go(t){this.at=Math.max(0,Math.min(this.run.frames.length-1,t)),Le("review-time").value=String(this.at);const e=this.run.frames[this.at].t,n=this.run.events.filter(r=>r.t<=e),s=n[n.length-1];Le("review-now").textContent=`${un(e,1)} s${s&&e-s.t<5?` · ${s.text}`:""}`,Le("review-time").setAttribute("aria-valuetext",Le("review-now").textContent),this.playing&&(this.playedAt=performance.now(),this.playedFrom=e),this.fresh=!0}advance(){if(!this.playing)return;const t=this.playedFrom+Iy*(performance.now()-this.playedAt)/1e3;let e=this.at;for(;e<this.run.frames.length-1&&this.run.frames[e].t<t;)e+=1;if(e!==this.at){const[n,s]=[this.playedAt,this.playedFrom];this.go(e),Object.assign(this,{playedAt:n,playedFrom:s})}e>=this.run.frames.length-1&&this.play(!1)}marks(){const t=Le("review-time").getBoundingClientRect(),e=Le("review-marks"),n=this.run.frames[this.run.frames.length-1].t||1;e.style.left=`${Le("review-time").offsetLeft}px`,e.style.width=`${t.width}px`,e.innerHTML="";for(const s of this.run.events){const r=document.createElement("i");r.style.left=`${s.t/n*100}%`,r.title=`${un(s.t,1)} s ${s.node}: ${s.text}`,e.append(r)}}camera(){const t=this.run.frames[this.at];return{state:t.truth||t.tm?.x,predicted:null}}show({motion:t,thrust:e}){this.advance();const{run:n}=this,s=n.frames[this.at],r=s.tm?.x,o=s.pred?.ok?s.pred.x:null;this.banner(),vr("gen",s.tm?s.tm.gen:null,s.tm?fn(it.age,{s:un(s.t-s.tm.gen,1)}):""),vr("rx",s.tm?s.tm.rx:null,""),vr("pred",o?s.pred.t:null,o?fn(it.ahead,{s:un(s.pred.t-s.t,1)}):""),t.show(r,o,n,!1),Ep(Le("bullseye"),n,r,o,s.pred?.s,s.margin,s.truth),Le("leave-time").textContent=s.margin?.leave==null?it.leave_never:`${s.margin.leave.toFixed(0)} s`,e.show(s.pilot,s.auto,s.cmd),bp(Le("dial"),n,s.rtt,s.tm?.transit),Tp(s,n.step_s);const a=this.rungs.filter(h=>h.sent<=s.k).map(h=>h.told<=s.k&&h.told>=0?h:{...h,state:s.k<h.due?0:1,told:-1});Pp(Le("ladder"),n,a,s.t),Le("ladder-counts").textContent=Lp(a);const l=h=>h.filter(u=>u[0]<=s.t),c=l(this.trail).filter(h=>h[0]>s.t-n.back_s-n.forward_s).map(h=>[...h.slice(4,7),2*h[7]]);this.scene.place({measured:r?.slice(0,3),predicted:o?.slice(0,3),truth:s.truth?.slice(0,3),trail:l(this.trail).map(h=>h.slice(1,4)),tube:c,drift:s.margin?.path,truthTrail:l(this.truths).map(h=>h.slice(1))}),this.fresh&&(this.fresh=!1,this.charts.show(this.errors,s.t))}banner(){const t=Le("banner"),e=this.at===this.run.frames.length-1&&this.run.verdict,n=e?it.verdict[this.run.verdict.reason]||this.run.verdict.reason:"";t.dataset.said!==n&&(t.dataset.said=n,t.textContent=n),t.classList.toggle("alarm",!!e&&!this.run.verdict.success)}}function Fy(i){const t={t:[],e:[[],[],[],[],[],[]],s:[[],[],[],[],[],[]]};for(const{score:e}of i)if(!(!e||e.t<=(t.t[t.t.length-1]??-1))){t.t.push(e.t);for(let n=0;n<6;n+=1){const s=n<3?100:1e3;t.e[n].push(e.e[n]===null?null:e.e[n]*s),t.s[n].push(e.s[n]===null?null:2*e.s[n]*s)}}return t}const Ul=["orbit","side","top"],Nc=4,$f=40,jr=1,Oy=22e5,[ky,By,qf]=[60,38,.35];class zy{constructor(t,e,n,s){this.elements={view:e,camera:n,labels:s},this.renderer=new ly({canvas:t,antialias:!0,alpha:!1,powerPreference:"high-performance"}),this.renderer.setScissorTest(!0),this.renderer.autoClear=!1,this.scene=new Lf,this.scene.add(new dy(14674431,2763306,.9));const r=new gy(16777215,2.3);r.position.set(-6,9,5),this.scene.add(r),this.far=new Lf,this.far.add(xy()),this.static=null,this.measured=yp(),this.ghost=zf(jn.predicted),this.truth=zf(jn.truth);for(const o of[this.measured,this.ghost,this.truth])o.visible=!1;this.measured.traverse(o=>o.layers.set(jr));for(const o of[this.truth,this.ghost])o.traverse(a=>a.layers.set(jr));this.tube=new My(jn.predicted),this.lines={measured:new ta(jn.measured,800),predicted:new ta(jn.predicted,200),drift:new ta(jn.predicted,32,!0),truth:new ta(jn.truth,2500)},this.scene.add(this.measured,this.ghost,this.truth,this.tube.mesh,...Object.values(this.lines).map(o=>o.line));for(const o of Object.values(this.lines))o.line.layers.set(jr);this.tube.mesh.layers.set(jr),this.perspective=new zn(32,1,.1,2e3),this.ortho=new lu(-1,1,1,-1,-100,200),this.dock=new zn(20,1,.02,2e3),this.dock.up.set(0,1,0);for(const o of[this.perspective,this.ortho])o.layers.enable(jr);this.orbit={azimuth:2.35,height:.34,zoom:1,focus:new G(-13,0,0)},this.kind="orbit",Object.assign(this,{enabled:!0,drawn:0,quality:1,adaptive:!0,pace:33,since:0}),this.marks=new Map,this.follow(e),this.resize(),addEventListener("resize",()=>this.resize())}adapt(t){if(!this.adaptive)return;this.pace=this.pace*.8+Math.min(t,400)*.2,this.since+=1;const e=this.pace>ky&&this.quality>qf,n=this.pace<By&&this.quality<1;this.since<(n?150:6)||!(e||n)||(this.quality=Math.max(qf,Math.min(1,this.quality*(e?.7:1.25))),this.since=0,this.resize())}setRun(t){this.static&&this.scene.remove(this.static),this.static=new pi,this.start=t.start,this.station=_y(t.limits.offset),this.static.add(this.station,vy(t.geometry)),this.scene.add(this.static);for(const e of Object.values(this.lines))e.set([]);this.tube.set([])}resize(){const t=Math.min(devicePixelRatio||1,Math.sqrt(Oy/Math.max(innerWidth*innerHeight,1)));this.renderer.setPixelRatio(t*this.quality),this.renderer.setSize(innerWidth,innerHeight,!1)}follow(t){let e=null;t.addEventListener("pointerdown",n=>{n.target.closest("button")||(e=[n.clientX,n.clientY],t.setPointerCapture(n.pointerId))}),t.addEventListener("pointermove",n=>{e&&(this.turn((n.clientX-e[0])*.005,(n.clientY-e[1])*.005),e=[n.clientX,n.clientY])}),t.addEventListener("pointerup",()=>{e=null}),t.addEventListener("wheel",n=>{n.preventDefault(),this.zoom(Math.exp(n.deltaY*.001))},{passive:!1})}turn(t,e){this.orbit.azimuth+=t,this.orbit.height=Math.max(-1.4,Math.min(1.4,this.orbit.height+e))}zoom(t){this.orbit.zoom=Math.max(.15,Math.min(4,this.orbit.zoom*t))}place({measured:t,predicted:e,truth:n,trail:s,tube:r,drift:o,truthTrail:a,stale:l}){Il(this.measured,t),Il(this.ghost,e),Il(this.truth,n),this.measured.traverse(c=>{c.isMesh&&c.material.emissive?.setHex(l?3159354:860723)}),this.lines.measured.set(s),this.lines.predicted.set(r),this.lines.drift.set(o||[]),this.lines.truth.set(a||[]),this.tube.set(r),this.seen={measured:t,predicted:e,truth:n}}draw(){if(!this.enabled)return;this.drawn+=1;const{view:t,camera:e}=this.elements,n=this.kind==="orbit"?1:1/Nc,s=[this.measured,this.ghost,this.truth,this.station].filter(Boolean);for(const c of s)c.scale.set(1,this.kind==="side"?n:1,this.kind==="top"?n:1);const r=t.getBoundingClientRect(),o=this.lens(r);this.into(r,o,this.kind==="orbit"),this.label(o,r);for(const c of s)c.scale.set(1,1,1);const a=this.seen&&(this.seen.truth||this.seen.measured)||this.start||[-30,0,0],l=e.getBoundingClientRect();l.height>20&&(this.aim(a,l),this.into(l,this.dock,!0))}lens(t){const e=t.width/Math.max(t.height,1);if(this.kind==="orbit"){const a=this.seen?.measured||this.seen?.truth,l=this.orbit;l.focus.x+=(.56*Math.min(-1,a?a[0]:-30)-l.focus.x)*.08;const c=l.zoom*(4+2.25*Math.abs(l.focus.x))*Math.max(1,1.45/e),h=Math.cos(l.height);return this.perspective.position.set(l.focus.x+c*h*Math.cos(l.azimuth),l.focus.y+c*Math.sin(l.height),l.focus.z+c*h*Math.sin(l.azimuth)),this.perspective.lookAt(l.focus),this.perspective.aspect=e,this.perspective.updateProjectionMatrix(),this.perspective}const n=this.ortho,s=$f/2,r=s/e/Nc;Object.assign(n,{left:-s,right:s,top:r,bottom:-r});const o=-$f/2+3.5;return this.kind==="side"?(n.position.set(o,0,50),n.up.set(0,1,0)):(n.position.set(o,50,0),n.up.set(0,0,-1)),n.lookAt(o,0,0),n.updateProjectionMatrix(),n}aim(t,e){this.dock.position.set(t[0],t[1],t[2]),this.dock.lookAt(t[0]+10,t[1],t[2]);const n=Math.max(-t[0],.4);this.dockTan=Math.max(.085,Math.min(.9,1.35/n)),this.dock.fov=2*Math.atan(this.dockTan)*180/Math.PI,this.dock.aspect=e.width/Math.max(e.height,1),this.dock.updateProjectionMatrix(),this.dock.updateMatrixWorld()}into(t,e,n){const s=innerHeight-t.bottom;if(this.renderer.setViewport(t.left,s,t.width,t.height),this.renderer.setScissor(t.left,s,t.width,t.height),this.renderer.setClearColor(329740,1),this.renderer.clear(!0,!0),n){const r=e.position.clone();e.position.set(0,0,0),e.updateMatrixWorld(),this.renderer.render(this.far,e),e.position.copy(r),e.updateMatrixWorld(),this.renderer.clearDepth()}this.renderer.render(this.scene,e)}label(t,e){const n=new Map;for(let s=-35;s<0;s+=5)n.set(`−${-s} m`,{at:[s,0,0],drop:1});this.seen?.measured&&n.set(it.measured,{at:this.seen.measured,kind:"measured craft"}),this.seen?.predicted&&n.set(it.predicted,{at:this.seen.predicted,kind:"predicted craft"}),this.seen?.truth&&n.set(it.truth,{at:this.seen.truth,kind:"craft"});for(const[s,r]of this.marks)n.has(s)||(r.remove(),this.marks.delete(s));t.updateMatrixWorld();for(const[s,{at:r,kind:o,drop:a}]of n){let l=this.marks.get(s);l||(l=document.createElement("span"),l.textContent=s,o&&(l.className=o),this.elements.labels.append(l),this.marks.set(s,l));const c=new G(r[0],r[1],r[2]).project(t),h=Math.abs(c.x)<.98&&Math.abs(c.y)<.96&&c.z<1;l.style.display=h?"":"none",l.style.left=`${(c.x+1)/2*e.width}px`,l.style.top=`${(1-c.y)/2*e.height+(a?14:0)}px`}}onCamera(t){const e=new G(t[0],t[1],t[2]).project(this.dock);return e.z>1?null:[e.x,e.y]}covers(t){const e={measured:this.measured,ghost:this.ghost,truth:this.truth,tube:this.tube.mesh,station:this.station,corridor:this.static.children[1]}[t],n=e.visible,s=[n,!1].map(o=>{e.visible=o,this.draw();const a=this.renderer.getContext(),l=new Uint8Array(a.drawingBufferWidth*a.drawingBufferHeight*4);return a.readPixels(0,0,a.drawingBufferWidth,a.drawingBufferHeight,a.RGBA,a.UNSIGNED_BYTE,l),l});e.visible=n;let r=0;for(let o=0;o<s[0].length;o+=4)(s[0][o]!==s[1][o]||s[0][o+1]!==s[1][o+1])&&(r+=1);return r}}function Il(i,t){i.visible=!!t,t&&i.position.set(t[0],t[1],t[2])}function Hy(i){return i==="orbit"?"":fn(it.exaggerated,{n:Nc})}const ea={KeyW:["x",1],KeyS:["x",-1],KeyR:["y",1],ArrowUp:["y",1],KeyF:["y",-1],ArrowDown:["y",-1],KeyD:["z",1],ArrowRight:["z",1],KeyA:["z",-1],ArrowLeft:["z",-1]},Yf={Digit1:1,Digit2:2,Digit3:3,Numpad1:1,Numpad2:2,Numpad3:3},Vy=20,Gy={x:{axis:1,sign:-1},y:{axis:3,sign:-1},z:{axis:2,sign:1},button:4,deadZone:.08,holdSpace:!1};function Wy(i,t){if(!Number.isFinite(i))return 0;const e=Math.min(Math.abs(i),1);return e<=t?0:Math.sign(i)*(e-t)/(1-t)}class Xy{constructor(t){this.onChange=t,this.down=new Set,this.level=1,this.source="keyboard",this.gamepad=null,this.settings={...Gy,...$y()},addEventListener("keydown",n=>this.key(n,!0)),addEventListener("keyup",n=>this.key(n,!1));const e=()=>{this.down.clear(),this.send(!0)};addEventListener("blur",e),document.addEventListener("visibilitychange",e),setInterval(()=>this.poll(),Vy)}change(t){this.settings={...this.settings,...t},localStorage.setItem("rvd.stick",JSON.stringify(this.settings))}key(t,e){if(t.ctrlKey||t.metaKey||t.altKey||Dp(t.target)||e&&t.target instanceof Element&&t.target.closest("input, select, dialog"))return;if(e&&Yf[t.code]){this.level=Yf[t.code],this.send(!0);return}if(!ea[t.code]&&t.code!=="Space"||t.code==="Space"&&!this.settings.holdSpace)return;t.preventDefault();const n=this.down.has(t.code);e?this.down.add(t.code):this.down.delete(t.code),e&&(this.source="keyboard"),n!==e&&this.send(!0)}poll(){const t=navigator.getGamepads?[...navigator.getGamepads()].filter(Boolean):[];this.gamepad=t.find(e=>e.connected!==!1)||null,this.gamepad&&Kf(this.gamepad,this.settings.button)&&(this.source="gamepad"),!this.gamepad&&this.source==="gamepad"&&(this.source="keyboard"),this.send(!1)}state(){const t=document.visibilityState==="visible"&&document.hasFocus();if(this.source==="gamepad"){const n=this.settings,s=r=>r.sign*Wy(this.gamepad.axes[r.axis],n.deadZone);return{held:t&&Kf(this.gamepad,n.button),x:s(n.x),y:s(n.y),z:s(n.z)}}const e={held:t&&(!this.settings.holdSpace||this.down.has("Space")),x:0,y:0,z:0};for(const n of this.down)ea[n]&&(e[ea[n][0]]+=ea[n][1]);for(const n of["x","y","z"])e[n]=Math.max(-1,Math.min(1,e[n]))*this.level/3;return e}send(t){this.onChange(this.state(),t)}}function Kf(i,t){return!!(i.buttons[t]&&i.buttons[t].pressed)}function Dp(i){return i instanceof Element&&!!i.closest("input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]")}function $y(){try{return JSON.parse(localStorage.getItem("rvd.stick"))||{}}catch{return{}}}const qy=6e3;class Yy{constructor(){this.status={phase:"idle",lease:"free",pages:0,note:""},this.can={fly:!1,desk:!1},this.connected=!1,this.reset(null)}reset(t){if(this.run=t,this.frame=null,this.frameAt=0,this.verdict=null,this.trail=[],this.ladder=new Map,this.errors={t:[],e:[[],[],[],[],[],[]],s:[[],[],[],[],[],[]]},this.events=[],this.abortAt=null,t){for(const e of t.trail||[])this.trail.push([...e,.1]);this.rungs(t.ladder||[])}}take(t){switch(t.type){case"hello":this.can=t.can;break;case"run":this.reset(t);break;case"status":this.status=t;break;case"frame":this.takeFrame(t);break;case"ladder":this.rungs(t.ladder);break;case"verdict":this.verdict=t;break;case"event":this.events.push(t);break}!t.type&&t.link&&(this.connected=t.link==="open",t.why&&(this.why=t.why))}takeFrame(t){this.frame=t,this.frameAt=performance.now(),this.rungs(t.ladder);const{est:e,pred:n,score:s}=t;if(e&&n&&n.ok){const o=this.trail[this.trail.length-1];if(!o||t.t>o[0]){const a=n.s?Math.max(n.s[1],n.s[2]):.05;this.trail.push([t.t,...e.x.slice(0,3),...n.x.slice(0,3),a]),this.trail.length>qy&&this.trail.shift()}}const r=this.errors;if(s&&(!r.t.length||s.t>r.t[r.t.length-1])){r.t.push(s.t);for(let o=0;o<6;o+=1){const a=o<3?100:1e3;r.e[o].push(s.e[o]===null?null:s.e[o]*a),r.s[o].push(s.s[o]===null?null:2*s.s[o]*a)}}t.cmd&&t.cmd.kind===3&&this.abortAt===null&&(this.abortAt=t.t)}rungs(t){for(const e of t){const[n,s,r,o,a,l,c,h,u,f]=e;this.ladder.set(n,{seq:n,sent:s,due:r,levels:[o,a,l],kind:c,state:h,refusal:u,told:f})}for(;this.ladder.size>700;)this.ladder.delete(this.ladder.keys().next().value)}now(){if(!this.frame)return 0;if(this.frame.paused||this.verdict||this.status.phase!=="flying")return this.frame.t;const t=(performance.now()-this.frameAt)/1e3*this.run.pace;return this.frame.t+Math.min(t,this.run.step_s)}silence(){return!this.frame||this.verdict||this.frame.paused||this.status.phase!=="flying"?0:(performance.now()-this.frameAt)/1e3}}const te=i=>document.getElementById(i),Ky=1e3/30,Su=1,Fc=2e3,jf=["manual","shared","auto"];for(const i of document.querySelectorAll("[data-s]"))i.textContent=it[i.dataset.s];for(const i of document.querySelectorAll("[data-a]"))i.setAttribute("aria-label",it[i.dataset.a]);const ao=decodeURIComponent(location.hash.slice(1))||sessionStorage.getItem("rvd.token")||"";ao&&(sessionStorage.setItem("rvd.token",ao),history.replaceState(null,"",location.pathname+location.search));const $t=new Yy,yu=new Sy,Up=new yy,Ip=new a_,Pn=new zy(te("gl"),te("view"),te("camera"),te("labels"));Pn.enabled=!new URLSearchParams(location.search).has("plain");let ha=-1/0,Nl=0,Zf=null,Jf=0;const ei=ao?new Uy(ao,jy):null,Ds=new Xy((i,t)=>ei?.stick(i,t)),Qf=new Cy(ei),Zn=new Ny(ei,Pn,Ip,()=>Np());ao||mu(it.no_token_title,it.no_page_token);function jy(i){if(i.type==="desk"){Qf.show(i,$t.status.lease==="you");return}const t=$t.status.phase;$t.take(i),i.type==="run"&&!Zn.on&&Np(),i.type==="status"&&(i.phase==="starting"&&t!=="starting"&&pu(),Oc(),Qf.lease(i.lease==="you")),i.type==="verdict"&&$t.frame&&Zf!==i&&!Zn.on&&!$t.can.desk&&(Zf=i,wy(i,$t.can.fly&&$t.status.lease==="you",()=>Eu())),i.type==="event"&&(te("event").textContent=`${un(i.t,1)} s · ${i.text}`),i.type==="reply"&&!i.ok&&(te("event").textContent=i.code?gu(i.code):i.text),i.type||Oc()}function Np(){$t.run&&(Pn.setRun($t.run),yu.setRun($t.run),te("run-name").textContent=`${$t.run.name} · ${$t.run.forward_s} s + ${$t.run.back_s} s`,te("run-name").title=te("run-name").textContent)}async function Fp(){await ei.ask({do:$t.status.lease==="you"?"drop":"take"})}function Op(i){$t.frame&&ei.ask({do:"mode",mode:i})}function kp(){$t.frame&&ei.ask({do:$t.frame.paused?"resume":"pause"})}function Bp(){const i=performance.now();i-ha<Fc?(ha=-1/0,ei.ask({do:"abort"})):ha=i,td(),setTimeout(td,Fc+50)}function td(){const i=performance.now()-ha<Fc;te("abort").classList.toggle("armed",i),te("abort").querySelector("small").textContent=i?it.abort_armed:it.abort_hint}function Eu(){$t.status.lease!=="you"&&ei.ask({do:"take"}),Ty($t,i=>ei.ask(i))}function Zy(){bu(Ul[(Ul.indexOf(Pn.kind)+1)%Ul.length])}function bu(i){Pn.kind=i;for(const t of document.querySelectorAll("[data-view]"))t.setAttribute("aria-pressed",String(t.dataset.view===i));te("scale").textContent=Hy(i)}const ed={KeyT:Fp,KeyP:kp,KeyX:Bp,KeyN:Eu,KeyV:Zy,KeyL:()=>Zn.list(),KeyG:()=>Ap(Ds),Slash:wp,KeyM:()=>Op(jf[(jf.indexOf($t.frame?.mode)+1)%3]),Equal:()=>Pn.zoom(.85),Minus:()=>Pn.zoom(1.18),BracketLeft:()=>Pn.turn(.15,0),BracketRight:()=>Pn.turn(-.15,0)};addEventListener("keydown",i=>{i.repeat||i.ctrlKey||i.metaKey||i.altKey||Dp(i.target)||te("dialog").open&&i.code!=="KeyX"||ed[i.code]&&ei&&ed[i.code]()});te("lease").onclick=Fp;te("pause").onclick=kp;te("abort").onclick=Bp;te("restart").onclick=Eu;te("open-review").onclick=()=>Zn.list();te("open-settings").onclick=()=>Ap(Ds);te("open-help").onclick=wp;for(const i of document.querySelectorAll("[data-mode]"))i.onclick=()=>Op(i.dataset.mode);for(const i of document.querySelectorAll("[data-view]"))i.onclick=()=>bu(i.dataset.view);te("legend").innerHTML=[["measured","measured",""],["predicted","predicted",""],["drift","predicted","dash"],["wall","",""],["boundary","","dash"]].map(([i,t,e])=>`<span class="${t} ${e}" data-legend="${i}">${it.legend[i]}</span>`).join("");document.querySelector("[data-legend=wall]").style.color="#8aa4bd";document.querySelector("[data-legend=boundary]").style.color="#b9c2a0";bu("orbit");function Oc(){const{status:i}=$t,t=i.lease==="you";te("lease").textContent=t?it.drop:i.lease==="other"?it.taken:it.take,te("lease").disabled=i.lease==="other",te("lease").classList.toggle("primary",i.lease==="free"),te("pages").textContent=i.pages===1?it.pages_one:fn(it.pages,{n:i.pages}),te("socket-state").textContent=$t.connected?`● ${it.socket_open}`:`○ ${it.socket_closed}`,te("socket-state").className=$t.connected?"ok":"alarm";for(const e of["pause","restart"])te(e).disabled=!t;for(const e of document.querySelectorAll("[data-mode]"))e.disabled=!t}function li(i,t,e){const n=te("banner"),s=i?`${i}${t?`<small>${t}</small>`:""}`:"";n.dataset.said!==s&&(n.dataset.said=s,n.innerHTML=s),n.classList.toggle("alarm",!!e)}function Jy(i){const{status:t,frame:e,run:n,verdict:s}=$t;if(!$t.connected&&ei)li(it.socket_closed,"",!0);else if(t.phase==="idle")li(it.idle,it.idle_text);else if(t.phase==="starting")li(it.starting,t.run||"");else if(t.note==="failed")li(it.run_failed,"",!0);else if(i>Su)li(fn(it.stale_frames,{s:i.toFixed(0)}),"",!0);else if($t.abortAt!==null&&!s&&e){const r=[...$t.ladder.values()].some(o=>o.kind===3&&(o.state===2||o.state===3));li(r?it.aborted:fn(it.abort_sent,{s:Math.max(0,n.forward_s-(e.t-$t.abortAt)).toFixed(0)}),"",!0)}else t.pilot_lost?li(it.pilot_lost,"",!0):e?.paused?li(it.paused,""):e&&!e.tm&&t.phase==="flying"?li(it.no_telemetry,fn(it.first_in,{s:Math.max(0,n.back_s-e.t).toFixed(0)})):s?li(it.verdict[s.reason]||s.reason,"",!s.success):li("")}function Qy(){const i=$t.status.lease==="you",t=Ds.state().held,e=i?t?`${it.stick_held} · ${it[Ds.source]}`:it.stick_open:it.stick_watch;te("stick-state").textContent=e,te("stick-state").className=i?t?"ok":"alarm":"dim",te("level").textContent=i&&Ds.source==="keyboard"?`${it.level} ${Ds.level}`:""}function tE(i,t){const{run:e}=$t,n=i.tm?t-i.tm.gen:null,s=n!==null&&n>e.back_s+Su*Math.max(e.pace,1);return vr("gen",i.tm?i.tm.gen:null,n===null?"":fn(it.age,{s:un(n,1)}),s),vr("rx",i.tm?i.tm.rx:null,i.tm?fn(it.ago,{s:un(t-i.tm.rx,1)}):"",s),vr("pred",i.pred?.ok?i.pred.t:null,i.pred?.ok?fn(it.ahead,{s:un(i.pred.t-t,1)}):"",s),s}function eE(i){return i?i.d<0?[it.leave_out,!0]:i.leave===null?[it.leave_never,!1]:[`${i.leave.toFixed(0)} s`,i.leave<$t.run.forward_s+$t.run.back_s]:[it.unknown,!1]}function zp(i){const{run:t,trail:e}=$t;if(!i.est?.ok||!i.pred?.ok)return[];const n=i.est.t-t.forward_s,s=[[...i.est.x.slice(0,3),2*(i.est.s?Math.max(i.est.s[1],i.est.s[2]):.02)]],r=e.filter(l=>l[0]>n),o=Math.max(1,Math.floor(r.length/24));for(let l=0;l<r.length;l+=o)s.push([...r[l].slice(4,7),2*r[l][7]]);const a=i.pred.s?Math.max(i.pred.s[1],i.pred.s[2]):.05;return s.push([...i.pred.x.slice(0,3),2*a]),s}function nE(){const{frame:i,run:t}=$t,e=$t.silence();Jy(e),Qy(),te("pause").textContent=i?.paused?it.resume:it.pause;for(const c of document.querySelectorAll("[data-mode]"))c.setAttribute("aria-pressed",String(c.dataset.mode===(i?.mode||t?.mode)));if(!t||!i)return;const n=$t.now(),s=tE(i,n)||e>Su||!$t.connected;document.body.classList.toggle("stale",s);const r=i.tm?.x,o=i.pred?.ok?i.pred.x:null;yu.show(r,o,t,s),Ep(te("bullseye"),t,r,o,i.pred?.s,i.margin);const[a,l]=eE(i.margin);if(te("leave-time").textContent=a,te("leave-time").className=l?"alarm":"",Up.show(i.pilot,i.auto,i.cmd),bp(te("dial"),t,i.rtt,i.tm?.transit),Tp(i,t.step_s),Pp(te("ladder"),t,$t.ladder.values(),n),te("ladder-counts").textContent=Lp($t.ladder.values()),Pn.place({measured:r?.slice(0,3),predicted:o?.slice(0,3),trail:$t.trail.map(c=>c.slice(1,4)),tube:zp(i),drift:i.margin?.path,stale:s}),performance.now()-Jf>250){Jf=performance.now(),Ip.show($t.errors);const c=i.score?.rms;te("error-rms").textContent=c&&c[0]!==null?fn(it.rms,{p:un(100*Math.hypot(c[0],c[1],c[2]),1),v:un(1e3*Math.hypot(c[3],c[4],c[5]),1)}):""}}function Hp(i){if(requestAnimationFrame(Hp),i-Nl<Ky-2)return;Pn.adapt(i-Nl),Nl=i,Zn.on?Zn.show({motion:yu,thrust:Up,tubeOf:zp}):nE(),Pn.draw();const t=Zn.on?Zn.camera():$t.frame&&{state:$t.frame.tm?.x,predicted:$t.frame.pred?.ok?$t.frame.pred.x:null};t&&($t.run||Zn.run)&&Ey(te("reticle"),Pn,Zn.on?Zn.run:$t.run,t.state,t.predicted)}Oc();requestAnimationFrame(Hp);window.rvd={store:$t,scene:Pn,stick:Ds,review:Zn,link:ei};
