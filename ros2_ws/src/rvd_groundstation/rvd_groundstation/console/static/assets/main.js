import{r as Jm,a as Qm,b as Hd,l as jn}from"./index.js";const Xt={measured:"#7cc4ff",predicted:"#ffb652",truth:"#f2f5f8",target:"#dbe5ee",plain:"#dbe5ee",pilot:"#7cc4ff",automatic:"#d59bf6",sent:"#56d6b0",limit:"#8aa4bd",guide:"#b9c2a0",goal:"#56d6b0",ok:"#56d6b0",alarm:"#ff7a5c",dim:"#8fa1b3",line:"#263544",text:"#dbe5ee"},qa=!new URLSearchParams(location.search).has("fine")&&/swiftshader|llvmpipe|softpipe|software|basic render/i.test(tg());function tg(){const n=document.createElement("canvas").getContext("webgl2");if(!n)return"software";const t=n.getExtension("WEBGL_debug_renderer_info"),e=String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),e}function _n(n,t){n.textContent!==t&&(n.textContent=t)}const fc=new Map;let Ea=12;const eg=new ResizeObserver(n=>n.forEach(({target:t})=>Gd(t)));function Gd(n){const{width:t,height:e}=n.getBoundingClientRect();fc.set(n,{w:t,h:e}),Ea=parseFloat(getComputedStyle(document.documentElement).fontSize)}function Wr(n){fc.has(n)||(Gd(n),eg.observe(n));const{w:t,h:e}=fc.get(n),i=Math.min(devicePixelRatio||1,2),s=Math.max(1,Math.round(t*i)),r=Math.max(1,Math.round(e*i));(n.width!==s||n.height!==r)&&Object.assign(n,{width:s,height:r});const o=n.getContext("2d",{willReadFrequently:qa});return o.setTransform(i,0,0,i,0,0),o.clearRect(0,0,t,e),o.font=`${.74*Ea}px system-ui, sans-serif`,o.lineWidth=Ea/12,{pen:o,w:t,h:e,rem:Ea}}function Lr(n,t,e,i,s,r){n.strokeStyle=s,n.setLineDash(r||[]),n.beginPath(),n.arc(t,e,Math.max(i,0),0,7),n.stroke(),n.setLineDash([])}function Je(n,t,e,i,s,r="left",o="middle"){n.fillStyle=s,n.textAlign=r,n.textBaseline=o,n.fillText(t,e,i)}const Z={title:"RVD console",clocks:"Three clocks",clock_generated:"generated on board",clock_received:"received on the ground",clock_predicted:"predicted for",modes:"Who decides",mode_turn:"{modes} in turn",mode_ground:"ground",mode_board:"on board",pause:"Pause",resume:"Resume",abort:"ABORT",abort_hint:"X twice",abort_armed:"again: ABORT",instruments:"Instruments",columns:{measured:"measured",predicted:"predicted",truth:"truth",plain:""},limit:"limit",weight:"pilot weight",scene:"Scene",views:"Views",camera_side:"Camera, delay and charts",ladder:"Command ladder",ladder_alt:"Commands on their way to the craft and back",ladder_ground:"ground",ladder_link:"on the link",ladder_craft:"at the craft",ladder_back:"telemetry on its way back",ladder_known:"known",round_trip:"Round trip",dial_alt:"Dial of the round trip",restart:"New run",review:"Review",settings:"Stick",help:"Help",stop:"Stop run",review_close:"Leave review",play:"Play",stop_play:"Stop",scrub:"Instant of the review",review_title:"Review a run",review_none:"No finished runs here yet: a run is listed once its bag is closed.",review_loading:"Reading the bag…",review_open:"Open",take:"Take the stick",drop:"Release the stick",taken:"Another page has the stick",stick_yours:"You have the stick",stick_held:"stick live",stick_open:"DEAD-MAN OPEN: automatic alone flies",stick_watch:"watching",stick_none:"you are in charge",keyboard:"keyboard",gamepad:"gamepad",stick_events:{STICK_LOST:"nobody holds the stick, or the dead-man is open",STICK:"the stick counts"},pages_one:"1 page",pages:"{n} pages",of:"of",socket_open:"connected",socket_closed:"NOT CONNECTED",idle:"Ready",idle_text:"Take the stick (T), then start a run (N).",starting:"The graph is coming up…",paused:"PAUSED",stale:"STALE",no_telemetry:"no telemetry yet",first_in:"first telemetry in {s} s",pilot_lost:"PILOT LOST: the automatic controller flies alone",stale_frames:"NO DATA FOR {s} s",aborted:"ABORTED",aborted_so:"ABORTED: {does}",stop_run:"End the flight",stop_hint:"ends the run under way; its folder is kept whole",abort_sent:"ABORT sent, acting in about {s} s",abort_asked:"ABORT: waiting for the answer",abort_unconfirmed:"ABORT NOT CONFIRMED",abort_again:"no answer; asked {n} times, asking again",abort_accepted:"ABORT accepted, goes out with the next frame",abort_untold:"ABORT sent, NOT ACKNOWLEDGED",abort_untold_hint:"sent {s} s ago; telemetry has not told whether it is in force",unconfirmed:"{name} NOT CONFIRMED",unconfirmed_hint:"The run did not answer in 2 s. Try again.",no_webgl:"No WebGL: the scene is drawn in lines",no_storage:"Storage is blocked: settings are not remembered",stick_gone:"GAMEPAD GONE: automatic alone flies",stick_stuck:"NOT AT REST: {axes} counts as 0 until it has been centred",run_failed:"The run could not be flown: see the terminal",run_refused:"No run with these settings",verdict_title:"Verdict",verdict_time:"time",fly_again:"Fly again (N)",close:"Close",cancel:"Cancel",start:"Start",seed:"seed",mode:"mode",seed_hint:"empty: the next one",new_run:"New run",new_run_text:"A new run in a new folder. A run under way is stopped.",no_fly:"This console belongs to one run; start it with ./rvd fly --operator console to fly again.",no_page_token:"This page needs the token of the address that the console printed.",no_token_title:"No token",exaggerated:"{axis} scale × {n}",link:{transit:"transit",p99:"p99",lost:"lost",late:"late",corrupted:"damaged",gap:"last gap"},age:"age {s} s",ago:"{s} s ago",ahead:"in {s} s",now:"now",settings_title:"The stick",settings_dead_zone:"dead zone",settings_axis:"axis",settings_pair:"buttons {plus} / {minus}, or",settings_invert:"inverted",settings_button:"dead-man button",settings_space:"keyboard: hold Space as dead-man",settings_none:"No gamepad seen. Press a button on it.",settings_pads:"Gamepads",settings_now:"now",pad_notes:{"":"",choose:"Several gamepads: choose one under Stick (G)",setup:"The gamepad must be set up under Stick (G) before it flies"},pad_plain:"no standard mapping",pad_live:"axes {axes} · pressed {buttons}",pad_nothing:"none",pad_choose:"Several gamepads are connected: choose one.",pad_setup:"This gamepad has no standard mapping: its axes and buttons may be anything. It does not fly before each axis and the dead-man button have been set.",pad_ready:"This gamepad is set up.",pad_start:"Set it up step by step",pad_next:"Next",pad_skip:"No such axis",pad_stop:"Stop",pad_rest:"Let go of all its sticks, triggers and buttons, then go on.",pad_move:"Push the stick all the way for {what} ({name}).",pad_back:"Let it go.",pad_trigger:"Axis {axis} does not rest at 0, as a trigger does not: take another.",pad_hold:"Press the button that is to be held while flying.",help_title:"Keys",help_step:"{name} of the keys",or:"or",review_truth:"Review shows the truth. It never reaches this page while a run is flown.",unknown:"–",desk:{door:"Which volunteer? Enter the number you were given; no name is asked or kept.",volunteer:"volunteer number",begin:"Begin",heading:"{who}, flight {n} of {of}",training:"Training: this flight does not count.",counts:"This flight counts.",condition:"Control: {mode}",clock:"The clock starts when the graph is up.",fly:"Start the flight",rest_title:"A break",rest:"Rest your eyes and hands.",go_on:"Go on",done_title:"Finished",done:"Thank you, {who}. All flights are flown and rated.",next:"Next volunteer",session:"Session: {title}",is_training:"training",is_counted:"counts",open:"Session",idle:"Take the stick (T) to go on with the session.",broken:"This flight does not count: {why}.",flown_again:"It is flown again, with the same start.",unset:"not set",back:"Back",change:"Change",chosen:"What contributed more to the workload, in each pair:",save_pairs:"Save",yes:"Yes",no:"No",again:"Answer again",pick:"Pick the sentence that fits best.",save:"Save the ratings",weigh:"Which of the two contributed more to the workload of flying in this way?",pair:"pair {n} of {of}",tree:{controllable:"Was the craft controllable?",adequate:"Was adequate performance ({goal}) attainable with a tolerable pilot workload?",satisfactory:"Was it satisfactory without improvement?"},ratings:["","Excellent, highly desirable: compensation not a factor","Good, negligible deficiencies: compensation not a factor","Fair, some mildly unpleasant deficiencies: minimal compensation","Minor but annoying deficiencies: moderate compensation","Moderately objectionable deficiencies: considerable compensation","Very objectionable but tolerable deficiencies: extensive compensation","Major deficiencies: adequate performance not attainable with maximum tolerable compensation","Major deficiencies: considerable compensation needed for control","Major deficiencies: intense compensation needed to retain control","Major deficiencies: control lost during some part of the flight"],tlx:{mental:["Mental demand","How mentally demanding was the flight?","very low","very high"],physical:["Physical demand","How physically demanding was the flight?","very low","very high"],temporal:["Temporal demand","How hurried or rushed was the pace?","very low","very high"],performance:["Performance","How successful were you in doing what you were asked to do?","perfect","failure"],effort:["Effort","How hard did you have to work for your level of performance?","very low","very high"],frustration:["Frustration","How insecure, discouraged, irritated, stressed and annoyed were you?","very low","very high"]},errors:{VOLUNTEER:"A whole number from 1 to 999, please.",STAGE:"Not now.",RATING:"The rating is incomplete.",TLX:"Please set every scale.",WEIGHTS:"Please choose in every pair.",CLOSING:"One moment: the recording of the last flight is being closed."}}},ng=[["T","take or release the stick"],["Space","dead-man, if so chosen under Stick"],["P","pause, resume"],["X X","ABORT, past every buffer{abort}"],["N","new run"],["V","next view"],["+ − [ ]","zoom and turn the scene"],["L","review a run"],["G","stick settings"],["?","this list"],["Esc","close"],["","A key that is released commands zero. Without focus, without this page, or with the dead-man open, there is no pilot: the automatic controller flies alone."]],ig={ArrowUp:"↑",ArrowDown:"↓",ArrowLeft:"←",ArrowRight:"→"},sg=["nobody","pilot","automatic","blend","guard"],Eh=["","nothing due","wrong length","checksum","out of order","too old","out of range","an input was missing","as the mode says","stick invalid: automatic alone","automatic invalid: counts as neutral","neither valid: neutral","ABORT in force"],rg=["sent","due","executed","effect seen","refused","missed","unknown"],og={LEASE:"Take the stick first (T).",TAKEN:"Another page has the stick.",NO_RUN:"No run is under way.",NO_FLY:Z.no_fly,NO_ANSWER:"The run did not answer.",DESK:"The session says what is flown.",SESSION_MODE:"The session says in which mode this flight is flown.",SESSION_PAUSE:"A flight of a session is not paused.",SESSION_STOP:"A flight of a session is flown to its end. Only ABORT ends it before, and it does not count then.",NO_DESK:"This console leads no session.",JSON:"The console did not understand the page: reload it.",REQUEST:"The console did not understand the page: reload it.",ID:"The console did not understand the page: reload it.",LENGTH:"A stick sample was damaged and left out.",KIND:"A stick sample was damaged and left out.",RANGE:"A stick sample was out of range and left out.",MODE:"No such mode.",SETTINGS:"Too many settings, or one that is too long.",SEED:"The seed must be a whole number."};function Te(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}const Ao={"+x":[1,0,0],"-x":[-1,0,0],"+y":[0,1,0],"-y":[0,-1,0],"+z":[0,0,1],"-z":[0,0,-1]};function li(n,t){const e=n?.signals[t];return e?.ok?e:void 0}function Yn(n,t){return t?li(n,t.signal)?.parts[t.part]??void 0:void 0}const dc=(n,t)=>Array.isArray(n)?n[t]:n;function xi(n,{signal:t,part:e,index:i,factor:s,past:r}){const o=li(n,t)?.parts[e];if(o==null)return;const a=i.map(c=>dc(o,c));if(a.some(c=>c==null))return;const l=r!=null&&dc(o,r)>0?-1:1;return s*(a.length===1?a[0]:l*Math.hypot(...a))}function Dr(n,t){return t!==null&&typeof t=="object"?xi(n,t):t??void 0}function Mu(n,t="xyz"){if(n==null)return;const e=[0,0,0];for(let i=0;i<t.length;i+=1){const s=dc(n,i);if(s==null)return;e["xyz".indexOf(t[i])]=s}return e}function Fi(n,t,e){return Array.isArray(t)?t:Mu(Yn(n,t),e)}function Li(n,t){const e=Ao[n];return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}class Vd{constructor(t,e){this.display=t,this.keep=e,this.trails=new Map;for(const i of t?.lines||[])i.kind==="trail"&&this.trails.set(i.name,[]);this.charts=(t?.charts?.strips||[]).map(i=>({t:[],curves:i.curves.map(()=>[]),spread:[]}))}begin(t){for(const e of this.display.lines)for(const i of t?.[e.name]||[]){const s=Mu(i.slice(2,-1),e.axes);s&&this.trails.get(e.name).push([i[0],i[1],...s,i[i.length-1]??0])}}add(t){for(const e of this.display.lines)e.kind==="trail"&&this.extend(e,t);this.display.charts?.strips.forEach((e,i)=>this.plot(e,this.charts[i],t))}extend(t,e){const i=this.trails.get(t.name),s=Fi(e,t.place,t.axes);if(!s||i.length&&e.t<=i[i.length-1][0])return;const r=t.spread?xi(e,t.spread)??0:0;i.push([e.t,e.signals[t.place.signal].t,...s,r]),i.length>this.keep&&i.shift()}plot(t,e,i){const s=[...t.curves,t.spread].filter(Boolean).map(a=>a.signal),r=li(i,s.find(a=>a!=="truth")??"truth");if(!r||r.t<=(e.t[e.t.length-1]??-1/0))return;e.t.push(r.t),t.curves.forEach((a,l)=>e.curves[l].push(xi(i,a)??null));const o=t.spread?xi(i,t.spread):void 0;e.spread.push(o===void 0?null:o*t.spread_factor)}}function ag(n,t,e,i,s){let r=t.length;for(;r>0&&t[r-1][0]>i;)r-=1;if(!n.since)return{rows:t,at:2,n:r};const o=li(e,n.since.signal),a=Fi(e,n.place,n.axes),l=Fi(e,n.since,n.axes);if(!o||!a||!l)return{rows:[],at:0,n:0};const c=n.spread?xi(e,n.spread)??0:0,u=[[...l,n.since_spread?xi(e,n.since_spread)??0:0]],h=Yn(e,n.anew);if(h)for(const f of h)u.push([...Mu(f,n.axes),c]);else{const f=li(e,n.place.signal).t;for(;r>0&&t[r-1][1]>f;)r-=1;let d=r;for(;d>0&&t[d-1][1]>o.t;)d-=1;const g=Math.max(1,Math.floor((r-d)/s));for(let v=d;v<r;v+=g)u.push(t[v].slice(2))}return u.push([...a,c]),{rows:u,at:0,n:u.length}}const Di=n=>document.getElementById(n),bh=.75*Math.PI;function lg(n){Di("attitude").hidden=!n,n&&(Di("attitude-title").textContent=n.title,Di("ball").setAttribute("aria-label",n.alt))}const wh=(n,t)=>{const e=Math.max(0,...t.filter(i=>i!==void 0).map(Math.abs));return n.find(i=>e<=i)??n[n.length-1]},Ho=(n,t)=>Math.max(-1,Math.min(1,n/t)),Th=(n,t)=>n>0?`+${qe(n,t)}`:qe(n,t);function cg(n,t){const{pen:e,w:i,h:s,rem:r}=Wr(Di("ball")),o=Math.min(i*.6,s)/2-.95*r,[a,l]=[o+1.1*r,s/2],c=v=>v?.map(m=>xi(t,m)),u=n.needles[0],[h,f]=[c(u.angles),c(u.rates)],d=wh(n.scales,h),g=f?wh(n.rate_scales,f):1;e.fillStyle="#0a1420",e.beginPath(),e.arc(a,l,o,0,7),e.fill(),Lr(e,a,l,o,Xt.dim),e.strokeStyle=Xt.line,e.beginPath(),e.moveTo(a-o,l),e.lineTo(a+o,l),e.moveTo(a,l-o),e.lineTo(a,l+o);for(const v of[-.5,.5])e.moveTo(a+v*o,l-r*.25),e.lineTo(a+v*o,l+r*.25),e.moveTo(a-r*.25,l+v*o),e.lineTo(a+r*.25,l+v*o);for(const v of[-1,-.5,0,.5,1]){const m=v*bh-Math.PI/2;e.moveTo(a+o*Math.cos(m),l+o*Math.sin(m)),e.lineTo(a+(o-r*.4)*Math.cos(m),l+(o-r*.4)*Math.sin(m))}e.stroke(),n.limit!==null&&n.limit<=d&&Lr(e,a,l,n.limit/d*o,Xt.limit,[r*.3,r*.25]);for(const v of[...n.needles].reverse()){const[m,p,y]=c(v.angles);if(m===void 0)continue;const T=Xt[v.role];e.strokeStyle=T,e.fillStyle=T;const x=o-.15*r,[I,A]=[a+Ho(y,d)*x,l-Ho(p,d)*x],D=S=>Math.sqrt(Math.max(x*x-S*S,0))*.8;e.lineWidth=r*(v===u?.16:.08),e.beginPath(),e.moveTo(a-D(A-l),A),e.lineTo(a+D(A-l),A),e.moveTo(I,l-D(I-a)),e.lineTo(I,l+D(I-a)),e.stroke();const U=Ho(m,d)*bh-Math.PI/2,w=(S,C)=>[a+S*Math.cos(C),l+S*Math.sin(C)];e.beginPath(),e.moveTo(...w(o,U)),e.lineTo(...w(o-r*.8,U-.09)),e.lineTo(...w(o-r*.8,U+.09)),e.closePath(),v===u?e.fill():(e.lineWidth=r/12,e.stroke())}e.lineWidth=r/12,f&&f[0]!==void 0&&ug(e,a,l,o,r,f.map(v=>Ho(v,g)),Xt[u.role]),e.strokeStyle=Xt.text,e.beginPath(),e.moveTo(a-r*.9,l),e.lineTo(a-r*.3,l),e.moveTo(a+r*.3,l),e.lineTo(a+r*.9,l),e.stroke(),hg(e,n,{angles:h,rates:f,scale:d,rateScale:g,w:i,h:s,rem:r})}function ug(n,t,e,i,s,[r,o,a],l){n.fillStyle=l;const c=(h,f,d,g)=>{n.beginPath(),n.moveTo(h,f),n.lineTo(h+d*s*.6-g*s*.3,f+g*s*.6+d*s*.3),n.lineTo(h+d*s*.6+g*s*.3,f+g*s*.6-d*s*.3),n.closePath(),n.fill()},u=i+s*.25;c(t+r*i,e-u,0,-1),c(t+u,e-o*i,1,0),c(t+a*i,e+u,0,1)}function hg(n,t,{angles:e,rates:i,scale:s,rateScale:r,w:o,h:a,rem:l}){const c=o-l*.2,u=o*.6+l*1.3;["roll","pitch","yaw"].forEach((f,d)=>{const g=a/2+(d-1.4)*l*2.3;Je(n,f,u,g,Xt.dim),n.font=`600 ${.95*l}px system-ui, sans-serif`;const v=t.limit!==null&&Math.abs(e[d])>t.limit;Je(n,`${v?"▲ ":""}${Th(e[d],t.digits)}`,c,g,Xt[t.needles[0].role],"right"),n.font=`${.74*l}px system-ui, sans-serif`,i&&Je(n,`${Th(i[d],t.digits+1)} /s`,c,g+l*.95,Xt.dim,"right")}),[`ring ±${s} ${t.unit}`,...i?[`edge ±${r} ${t.unit}/s`]:[]].forEach((f,d)=>Je(n,f,c,a-l*(1.5-d),Xt.dim,"right"))}function fg(n){Di("lamps").hidden=!n,n&&(Di("lamps-title").textContent=n.title,Di("lights").setAttribute("aria-label",n.alt),Di("lights").style.height=`${2*n.groups.length}rem`)}function dg(n,t){const{pen:e,w:i,h:s,rem:r}=Wr(Di("lights")),[o,a,l]=[n.on,n.glow,n.counts].map(g=>Yn(t,g));n.note&&Ia(Yn(t,n.note)??["",!1],Di("lamps-note"),"dim");const c=Math.max(...n.groups.map(g=>g.labels.length+pg(g.labels)*.5)),[u,h]=[11.5*r,i-5.2*r],f=Math.min((h-u)/c,2.6*r);let d=0;n.groups.forEach((g,v)=>{const m=(v+.36)*(s/n.groups.length);Je(e,g.name,0,m,Xt.text),Je(e,g.words,1.8*r,m,Xt.dim);let p=u;g.labels.forEach((y,T)=>{const x=T===0||g.labels[T-1]!==y;x&&T>0&&(p+=f*.5);const I=Math.max(a?.[d]??0,o?.[d]?1:0);Lr(e,p,m,r*.42,o?.[d]?"#ffffff":"#3a4f63"),e.globalAlpha=I,e.fillStyle=Xt[n.role],e.beginPath(),e.arc(p,m,r*.4,0,7),e.fill(),e.globalAlpha=1;let A=T;for(;g.labels[A+1]===y;)A+=1;x&&Je(e,y,p+(A-T)*f/2,m+r*.92,Xt.dim,"center"),p+=f,d+=1}),l&&Je(e,`${l[v]} pulses`,i,m,Xt.text,"right")})}const pg=n=>n.filter((t,e)=>e>0&&n[e-1]!==t).length;function mg(n,{w:t,h:e,rem:i},s,r,o){const a=e/2/o,[l,c]=[t/2,e/2],u=s.half_view*a;n.strokeStyle=Xt.limit,n.strokeRect(l-u,c-u,2*u,2*u);const[h,f]=[Yn(r,s.points),Yn(r,s.used)];if(!h)return;const d=s.width_px;for(let g=0;2*g<h.length;g+=1){if(h[2*g]===null||h[2*g+1]===null)continue;const v=l+(h[2*g]/d-.5)*2*u,m=c+(h[2*g+1]/d-.5)*2*u;n.lineWidth=i/8,Lr(n,v,m,i*.38,f?.[g]?Xt.ok:Xt.dim),n.lineWidth=i/12,f?.[g]&&(n.fillStyle=Xt.ok,n.beginPath(),n.arc(v,m,i*.14,0,7),n.fill())}}const Ze=n=>document.getElementById(n),gg=4,_g=["measured","predicted","truth","plain"];function qe(n,t){if(n==null||!Number.isFinite(n))return Z.unknown;const e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","−")}const Go=(n,t,e)=>typeof n=="number"?String(n).replace("-","−"):qe(t,e);function Wd(n,{low:t,high:e},i){const[s,r]=[Dr(n,t),Dr(n,e)];return s===void 0&&r===void 0?"":r===void 0?`> ${Go(t,s,i)}`:s===void 0?`< ${Go(e,r,i)}`:`${Go(t,s,i)}…${Go(e,r,i)}`}class vg{setDisplay(t){const e=t.instruments;if(Ze("instruments").hidden=!e,this.rows=[],!e)return;Ze("instruments-title").textContent=e.title;const i=_g.filter(r=>e.rows.some(o=>o.readings.some(a=>a.role===r)));Ze("instruments").style.setProperty("--columns",i.length);const s=ii("div","head");s.append(...[["",""],...i.map(r=>[Z.columns[r],r]),["",""],[Z.limit,"dim"]].map(([r,o])=>ii("span",o,r))),Ze("instruments-rows").replaceChildren(s,...e.rows.map(r=>{const o=ii("div","row"),a=new Map(i.map(c=>[c,ii("b",c)])),l=ii("u");return o.append(ii("span","",r.label),...a.values(),ii("u","unit",r.unit),l),this.rows.push({row:r,cells:a,limit:l}),o}))}show(t,e){for(const{row:i,cells:s,limit:r}of this.rows){let o="";for(const a of i.readings){const l=xi(t,a.value),c=s.get(a.role);_n(c,qe(l,i.digits)),c.classList.toggle("stale-value",e&&a.role==="measured"),c.classList.toggle("bad",l<=Dr(t,a.low)||l>=Dr(t,a.high)),o=Wd(t,a,i.digits)||o}_n(r,o)}}}function ii(n,t="",e=""){const i=document.createElement(n);return t&&(i.className=t),i.textContent=e,i}function xg(n){Ze("cut").hidden=!n,n&&(Ze("section-title").textContent=n.title,Ze("section").setAttribute("aria-label",n.alt),Ze("foot").hidden=!n.foot,n.foot&&(Ze("foot-label").textContent=n.foot.label))}const $d={dot(n,t,e,i,s){n.fillStyle=i,n.beginPath(),n.arc(t,e,s*.3,0,7),n.fill()},ring(n,t,e,i,s,r){n.fillStyle=`${i}30`,n.beginPath(),n.arc(t,e,Math.max(s*.3,r),0,7),n.fill(),n.stroke()},cross(n,t,e,i,s){const r=s*.32;n.beginPath(),n.moveTo(t-r,e-r),n.lineTo(t+r,e+r),n.moveTo(t-r,e+r),n.lineTo(t+r,e-r),n.stroke()},square(n,t,e,i,s){n.strokeRect(t-s*.35,e-s*.35,s*.7,s*.7)}};function Mg(n,t){const{pen:e,w:i,h:s,rem:r}=Wr(Ze("section")),[o,a]=[i/2,s/2],l=Math.min(i,s)/2-.9*r;e.strokeStyle=Xt.line,e.beginPath(),e.moveTo(o-l,a),e.lineTo(o+l,a),e.moveTo(o,a-l),e.lineTo(o,a+l),e.stroke(),Ia(n.note?Yn(t,n.note):["",!1],Ze("section-note"),"dim"),n.foot&&Ia(Yn(t,n.foot.words),Ze("foot-words"));const c=Dr(t,n.extent_m);if(!c)return;const u=l/c;for(const f of n.rings){const d=Dr(t,f.radius_m);d!==void 0&&(Lr(e,o,a,d*u,Xt[f.role],f.dashed?[r*.3,r*.25]:null),f.written&&Je(e,`${d.toFixed(2)} m`,o+d*u*.72,a-d*u*.72-r*.3,Xt[f.role]))}Je(e,n.names?.[1]??Ah(n.up),o+r*.3,a-l,Xt.dim),Je(e,n.names?.[0]??Ah(n.right),o+l,a-r*.6,Xt.dim,"right");const h=f=>[o+Li(n.right,f)*u,a-Li(n.up,f)*u];for(const f of n.spots){const d=Fi(t,f.place);if(!d)continue;const g=Xt[f.role],[v,m]=h(d);e.strokeStyle=g;const p=f.origin&&Fi(t,f.origin);p&&(e.setLineDash([r*.2,r*.2]),e.beginPath(),e.moveTo(...h(p)),e.lineTo(v,m),e.stroke(),e.setLineDash([])),$d[f.mark](e,v,m,g,r,f.spread?(xi(t,f.spread)??0)*u:0);const y=f.rate&&Fi(t,f.rate);if(y){const T=f.ahead_s*u;e.beginPath(),e.moveTo(v,m),e.lineTo(v+Li(n.right,y)*T,m-Li(n.up,y)*T),e.stroke()}}}const Ah=n=>n.replace("+","").replace("-","−");function Ia(n,t,e=""){const[i,s]=n||[Z.unknown,!1];_n(t,i),t.className=s?"alarm":e}function pc(n,t){const e=qe(n,t);return Number(n.toFixed(t))>0?`+${e}`:e}function Sg(n){const t=ii("div","bar");return t.append(document.createElement("i"),document.createElement("span")),t.firstChild.style.background=n,t}class yg{setDisplay({commands:t,link:e}){this.commands=t,this.link=e,Ze("commands-title").textContent=t.unit?`${t.title}, ${t.unit}`:t.title;const i=t.axes.map(o=>ii("span","dim",o.name)),s=t.rows.map(o=>ii("span",o.role==="automatic"?"auto":"",o.label));this.rows=t.rows.map(o=>({row:o,bars:t.axes.map(()=>Sg(Xt[o.role]))}));const r=i.length<=gg?[[ii("span"),...i],...this.rows.map(({bars:o},a)=>[s[a],...o])]:[[ii("span"),...s],...i.map((o,a)=>[o,...this.rows.map(({bars:l})=>l[a])])];Ze("bars").style.setProperty("--columns",r[0].length-1),Ze("bars").replaceChildren(...r.flat())}show(t){const e=t.signals[this.commands.sent];for(const{row:s,bars:r}of this.rows){const a=(s.value.signal===this.commands.sent?e:li(t,s.value.signal))?.parts[s.value.part];this.commands.axes.forEach((l,c)=>this.bar(r[c],a?.[c]??null,l.highest))}const i=e&&this.link?[sg[e.parts.by]]:[];e&&e.parts.weight!==null&&e.parts.by===3&&i.push(`${Z.weight} ${e.parts.weight}`),e&&Eh[e.parts.reason]&&i.push(Eh[e.parts.reason]),_n(Ze("why"),i.join(" · "))}bar(t,e,i){const s=Math.min(Math.abs(e||0)/i,1)*48;t.firstChild.style.left=`${e<0?50-s:50}%`,t.firstChild.style.width=`${s}%`,_n(t.lastChild,e===null?Z.unknown:pc(e,this.commands.digits))}}function Ml(n,t,e,i){const s=Ze(`clock-${n}`);_n(s,t===void 0?Z.unknown:`${qe(t,1)} s`),_n(Ze(`clock-${n}-age`),e),s.parentElement.classList.toggle("stale",!!i)}function Eg(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=Wr(n),[l,c,u]=[r/2,o*.56,Math.min(r/2,o*.56)-a*.5],h=t.forward_s+t.back_s,f=Math.max(h*1.5,1),d=v=>Math.PI*(.8+1.4*Math.max(0,Math.min(1,v/f)));s.lineWidth=a*.45,s.strokeStyle="#1b2733",s.beginPath(),s.arc(l,c,u,d(0),d(f)),s.stroke(),e!==void 0&&(s.strokeStyle=e>h+1?Xt.alarm:Xt.measured,s.beginPath(),s.arc(l,c,u,d(0),d(e)),s.stroke()),i&&(s.lineWidth=a*.16,s.strokeStyle=Xt.guide,s.beginPath(),s.arc(l,c,u-a*.5,d(0),d(i)),s.stroke()),s.strokeStyle=Xt.text,s.lineWidth=a*.12;const g=d(h);s.beginPath(),s.moveTo(l+(u-a*.4)*Math.cos(g),c+(u-a*.4)*Math.sin(g)),s.lineTo(l+(u+a*.4)*Math.cos(g),c+(u+a*.4)*Math.sin(g)),s.stroke(),s.font=`600 ${1.35*a}px system-ui, sans-serif`,Je(s,e===void 0?Z.unknown:`${e.toFixed(1)} s`,l,c-a*.05,Xt.text,"center"),s.font=`${.7*a}px system-ui, sans-serif`,Je(s,`${t.forward_s} + ${t.back_s} s`,l,c+a*1.05,Xt.dim,"center")}function bg(n,t,e){const{link:i,gap:s}=n,r=[[Z.link.transit,t?`${qe(t.transit,2)} s`:Z.unknown]];i&&r.push([Z.link.p99,`${qe(i.delay_p99,2)} s`],[Z.link.lost,i.lost+i.outage],[Z.link.late,i.late],[Z.link.corrupted,i.corrupted]),r.push([Z.link.gap,s?Te(Z.ago,{s:qe((n.k-s.k)*e,0)}):Z.unknown]);const o=r.map(([a,l])=>`<dt>${a}</dt><dd>${l}</dd>`).join("");Ze("link-counts").innerHTML!==o&&(Ze("link-counts").innerHTML=o)}function wg(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=Wr(n),[l,c]=[r/2,o/2];s.strokeStyle="#dbe5ee90",s.beginPath(),s.moveTo(l-r*.3,c),s.lineTo(l-a,c),s.moveTo(l+a,c),s.lineTo(l+r*.3,c),s.moveTo(l,c-o*.36),s.lineTo(l,c-a),s.moveTo(l,c+a),s.lineTo(l,c+o*.36);for(let d=-3;d<=3;d+=1)d&&(s.moveTo(l+d*r*.1,c-a*.25),s.lineTo(l+d*r*.1,c+a*.25));s.stroke();const u=t.known(e.carried_by);if(!u)return;const h=u.item.role==="truth";for(const d of e.marks){const g=Fi(i,d.at),v=g&&!(h&&d.role==="predicted")&&t.onCamera(g);if(!v)continue;const m=Xt[d.role],[p,y]=[l+v[0]*r/2,c-v[1]*o/2];if(s.strokeStyle=m,d.radius_m===null){$d.square(s,p,y,m,a);continue}const T=Math.max(Li(e.look,g)-Li(e.look,u.at),.05);Lr(s,p,y,Math.min(d.radius_m/T/t.cameraTan*(o/2),o),m),s.strokeStyle=`${m}80`,s.beginPath(),s.moveTo(l,c),s.lineTo(p,y),s.stroke()}e.pixels&&mg(s,{w:r,h:o,rem:a},e.pixels,i,t.cameraTan),e.gauge&&Tg(s,r,o,a,e.gauge,i,h);const f=e.distance.map(d=>xi(i,d.value)).find(d=>d!==void 0);f!==void 0&&Je(s,`${qe(f,e.digits)} ${e.unit}`,a*.6,o-a*.9,Xt.measured)}function Tg(n,t,e,i,s,r,o){const[a,l,c]=[t-i*2.9,i*1.5,e-i*1.2],{low:u,high:h}=s,f=d=>c-(Math.max(u,Math.min(h,d))-u)/(h-u)*(c-l);n.strokeStyle="#dbe5eea0",n.beginPath(),n.moveTo(a,l),n.lineTo(a,c);for(let d=0;u+d*s.tick<=h+1e-9;d+=1){const g=f(u+d*s.tick),v=d%s.long_ticks===0;n.moveTo(a,g),n.lineTo(a+i*(v?.5:.25),g),v&&Je(n,qe(u+d*s.tick,s.digits),a+i*.65,g,Xt.text)}n.stroke(),s.limit!==null&&(n.strokeStyle=Xt.alarm,n.beginPath(),n.moveTo(a-i*.5,f(s.limit)),n.lineTo(a+i*.5,f(s.limit)),n.stroke());for(const{role:d,value:g}of s.readings){const v=xi(r,g);if(v===void 0||o&&d!=="truth")continue;const m=f(v),p=Xt[d==="truth"?"measured":d];n.beginPath(),n.moveTo(a-i*.1,m),n.lineTo(a-i*.75,m-i*.36),n.lineTo(a-i*.75,m+i*.36),n.closePath(),d==="predicted"?(n.strokeStyle=p,n.stroke()):(n.fillStyle=p,n.fill())}Je(n,s.unit,a,l-i*.7,Xt.dim,"center")}const ba=()=>document.getElementById("modes"),Ag=(n,t)=>(n?.modes||[]).find(e=>e.name===t),Rg=(n,t)=>t?`${n} (${t.replace(/^Key/,"")})`:n,mc=(n,t)=>Ag(n,t)?.label??t,Cg=(n,t)=>(n?.modes||[]).find(e=>e.key&&e.key===t),Xd=n=>(n?.modes||[]).filter(t=>!t.key);function Pg(n,t){ba().hidden=!n.modes.length,ba().classList.toggle("told",n.on_board!==null),ba().replaceChildren(...n.modes.map(e=>{const i=document.createElement("button");return i.dataset.mode=e.name,i.title=e.words,i.textContent=Rg(e.label,e.key),n.on_board&&i.append(document.createElement("small")),i.onclick=()=>t(e.name),i}))}function qd(n,t,e,i){const s=Yn(t,n?.on_board);for(const r of ba().children){const[o,a]=[r.dataset.mode===e,r.dataset.mode===s];r.disabled=!i,r.setAttribute("aria-pressed",String(o));const l=r.querySelector("small");l&&_n(l,[o?Z.mode_ground:"",a?Z.mode_board:""].filter(Boolean).join(" · "))}}function Lg(n){const t=Xd(n).map(i=>i.label.toLowerCase()).join(", "),e=(n?.modes||[]).filter(i=>i.key).map(i=>[i.key.replace(/^Key/,""),i.words||i.label]);return t?[["M",Te(Z.mode_turn,{modes:t})],...e]:e}const yo=()=>document.getElementById("dialog");function Xs(n,t){const e=yo();e.innerHTML=n,e.open||e.showModal();for(const i of e.querySelectorAll("[data-close]"))i.onclick=()=>e.close();return t&&t(e),e}function Na(){yo().open&&yo().close()}const Ro=`<button data-close>${Z.close}</button>`;function pe(n){const t=document.createElement("span");return t.textContent=n,t.innerHTML.replaceAll('"',"&quot;")}function Su(n,t){Xs(`<h3>${pe(n)}</h3><p>${pe(t)}</p><div class="buttons">${Ro}</div>`)}const Rh=n=>ig[n]||n.replace(/^Key/,"");function Dg(n){const t=n?.controller,e=(t?.axes||[]).map(s=>[s.keys.map(r=>r.map(Rh).join(" / ")).join(` ${Z.or} `),`${t.verb} ${s.positive} / ${s.negative} (${s.name})`]);for(const s of t?.buttons||[])e.push([Rh(s.key),s.words]);const i=t?.key_deflections.length||0;return i>1&&e.push([Array.from({length:i},(s,r)=>r+1).join(" "),Te(Z.help_step,{name:t.step_name})]),e}function Yd(n){const t=n?.abort?`: ${n.abort}`:"",[[e,i],...s]=ng.map(([o,a])=>[o,Te(a,{abort:t})]),r=[[e,i],...Dg(n),...Lg(n),...s].map(([o,a])=>o?`<tr><td><kbd>${pe(o)}</kbd></td><td>${pe(a)}</td></tr>`:`<tr><td colspan="2">${pe(a)}</td></tr>`);Xs(`<h3>${Z.help_title}</h3><table>${r.join("")}</table><div class="buttons">${Ro}</div>`)}function yu(n){return og[n]||n}function Ug(n,t){const e=n.fields.map(i=>{const s=`${i.section} ${i.key}`,r=t[s]??i.value,o=`data-setting="${pe(s)}" title="${pe(`${i.key}: ${i.hint}`)}"`,a=i.choices.length?`<select ${o}>${i.choices.map(l=>`<option ${l===r?"selected":""}>${pe(l)}</option>`).join("")}</select>`:`<input ${o} value="${pe(r)}" maxlength="200">`;return`<label>${pe(i.label)} ${a} <span class="dim">${pe(i.unit)}</span></label>`});return`<fieldset><legend>${pe(n.title)}</legend>${e.join("")}</fieldset>`}function Ig(n,t){const e={};for(const i of t)for(const s of i.fields){const r=`${s.section} ${s.key}`,o=[...n.querySelectorAll("[data-setting]")].find(a=>a.dataset.setting===r).value;o.trim()!==s.value&&(e[r]=o)}return e}let Ch={};function Ng(n,t,e="",i=null){if(!n.can.fly){Su(Z.new_run,Z.no_fly);return}const s=n.display?.modes||[],r=n.display?.forms||[],o=n.frame?.mode||n.run?.mode||n.asked,a=s.map(l=>`<option value="${l.name}" ${l.name===o?"selected":""}>${pe(l.label)}</option>`);Xs(`<h3>${Z.new_run}</h3><p>${Z.new_run_text}</p>
    <p>${s.length?`<label>${Z.mode} <select id="new-mode">${a.join("")}</select></label> &nbsp;`:""}
    <label>${Z.seed} <input id="new-seed" size="15" inputmode="numeric" placeholder="${Z.seed_hint}"></label></p>
    <div class="forms">${r.map(l=>Ug(l,Ch)).join("")}</div>
    <p id="new-error" class="alarm" role="alert">${pe(e)}</p>
    <div class="buttons"><button data-close>${Z.cancel}</button>${i?`<button id="new-stop" title="${Z.stop_hint}">${Z.stop_run}</button>`:""}<button class="primary" id="new-start">${Z.start}</button></div>`,l=>{l.classList.toggle("wide",r.length>0),l.onclose=()=>l.classList.remove("wide");const c=async()=>{const u=l.querySelector("#new-seed").value.trim(),h={do:"fly",mode:l.querySelector("#new-mode")?.value??null};u&&(h.seed=Number(u)),r.length&&(h.settings=Ch=Ig(l,r));const f=await t(h);f.ok?l.close():l.querySelector("#new-error").textContent=yu(f.code)};l.querySelector("#new-start").onclick=c,i&&(l.querySelector("#new-stop").onclick=()=>{l.close(),i()}),l.querySelector("#new-seed").onkeydown=u=>{u.key==="Enter"&&c()},l.querySelector("#new-start").focus()})}function Fg(n,t,e){const i=n.success,s=(o,a,l,c)=>`<tr><th>${pe(o)}</th><td class="${c===!1?"alarm":""}">${pe(a)}</td><td class="dim">${pe(l)}</td></tr>`,r=n.measures.filter(o=>o.value!==null).map(o=>s(o.words,`${qe(o.value,o.digits)} ${o.unit}`,Wd(null,o,o.digits),o.ok));Xs(`<h3>${Z.verdict_title}</h3>
    <p class="verdict ${i?"ok":"alarm"}" id="verdict-words">${i?"✓":"✗"} ${pe(Ur(n.words))}</p>
    <table>${s(Z.verdict_time,`${qe(n.duration,1)} s`,"",null)}${r.join("")}</table>
    <div class="buttons">${Ro}${t?`<button class="primary" id="again">${Z.fly_again}</button>`:""}</div>`,o=>{const a=o.querySelector("#again");a&&(a.onclick=()=>{o.close(),e()})})}function Og(){return yo().open&&yo().querySelector("#runs")!==null}const Ur=n=>n.charAt(0).toUpperCase()+n.slice(1);function kg(n,t){const e=n.map(i=>`<tr><td>${pe(i.name)}</td><td>${pe(i.mode||"")}</td>
    <td class="${i.success?"ok":""}">${i.success?"✓":"✗"} ${pe(Ur((i.reason||"").replaceAll("_"," ")))}</td>
    <td><button data-run="${pe(i.name)}">${Z.review_open}</button></td></tr>`);Xs(`<h3 id="runs">${Z.review_title}</h3><p class="dim">${Z.review_truth}</p>
    ${n.length?`<table>${e.join("")}</table>`:`<p>${Z.review_none}</p>`}
    <p id="review-error" class="alarm"></p><div class="buttons">${Ro}</div>`,i=>{for(const s of i.querySelectorAll("[data-run]"))s.onclick=()=>t(s.dataset.run,i.querySelector("#review-error"))})}const jt=Z.desk,Bg=5;class zg{constructor(t){this.link=t,this.task={hint:"",goal:"",display:null},this.state=null,this.mine=!1,this.page=null,document.getElementById("dialog").addEventListener("close",({target:e})=>{e.querySelector("[data-desk]")||setTimeout(()=>{e.open||this.reopen()})})}show(t,e){const i=r=>JSON.stringify({...r,rest_s:0,closing:!1}),s=!this.state||i(this.state)!==i(t);this.state=t,this.mine=e,t.stage==="rest"&&s&&(this.restUntil=performance.now()+t.rest_s*1e3),s?this.draw():this.wait()}lease(t){t!==this.mine&&(this.mine=t,t?this.page?this.page():this.state&&this.draw():this.shut())}draw(){clearInterval(this.timer);const t=this.state.stage;this.page=null,this.mine&&(t==="flying"?Na():this.turn(()=>this[t]()))}turn(t){this.page=t,t()}reopen(){this.mine&&this.page&&this.page()}shut(){document.querySelector("#dialog [data-desk]")&&Na()}title(){if(!this.state)return"";const{title:t,who:e,stage:i,training:s,mode:r}=this.state,o=e?[i==="done"?e:this.heading()]:[];return r&&o.push(mc(this.task.display,r),s?jt.is_training:jt.is_counted),[...o,Te(jt.session,{title:t})].join(" · ")}async ask(t,e,i){const s=await this.link.ask({do:"desk",act:t,...e}),r=i?.querySelector(".error");return!s.ok&&r&&(r.textContent=jt.errors[s.code]||yu(s.code)),s.ok}frame(t,e,i,s){const r=Xs(`<h3 data-desk>${pe(t)}</h3>${e}<p class="error alarm" role="alert"></p><div class="buttons">${i}</div>`,s);return r.onclose=null,this.wait(),r}wait(){const t=document.querySelector("#dialog [data-waits]");t&&(t.disabled=this.state.closing,document.querySelector("#dialog .error").textContent=this.state.closing?jt.errors.CLOSING:"",this.state.closing||t.focus())}door(){this.frame(this.state.title,`<p>${jt.door}</p><p><label>${jt.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,`<button class="primary" id="desk-go">${jt.begin}</button>`,t=>{const e=()=>this.ask("begin",{volunteer:Number(t.querySelector("#volunteer").value)},t);t.querySelector("#desk-go").onclick=e,t.querySelector("#volunteer").onkeydown=i=>{i.key==="Enter"&&e()},t.querySelector("#volunteer").focus()})}heading(){return Te(jt.heading,{who:this.state.who,n:this.state.number,of:this.state.of})}ready(){const t=this.state.training?jt.training:jt.counts,e=this.state.why?`<p class="alarm">${pe(this.state.why)}</p>`:"";this.frame(this.heading(),`${e}<p>${t}</p><p>${Te(jt.condition,{mode:pe(mc(this.task.display,this.state.mode))})}</p><p class="dim">${pe(this.task.hint)} ${jt.clock}</p>`,`<button class="primary" id="desk-go" data-waits>${jt.fly}</button>`,i=>{i.querySelector("#desk-go").onclick=()=>this.ask("fly",{},i)})}broken(){this.frame(this.heading(),`<p class="verdict alarm" id="desk-why">${pe(Te(jt.broken,{why:this.state.why}))}</p><p>${jt.flown_again}</p>`,`<button class="primary" id="desk-go" data-waits>${jt.go_on}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("go_on",{},t)})}closing(){this.frame(this.heading(),`<p>${jt.errors.CLOSING}</p>`,"")}rest(){this.frame(jt.rest_title,`<p>${jt.rest}</p><p class="verdict" id="rest-left"></p>`,`<button class="primary" id="desk-go">${jt.go_on}</button>`,t=>{const e=t.querySelector("#desk-go"),i=t.querySelector("#rest-left");e.onclick=()=>this.ask("go_on",{},t);const s=()=>{const r=Math.max(0,(this.restUntil-performance.now())/1e3);i.textContent=`${r.toFixed(0)} s`,e.disabled=r>0};s(),clearInterval(this.timer),this.timer=setInterval(s,500)})}done(){this.frame(jt.done_title,`<p>${Te(jt.done,{who:this.state.who})}</p>`,`<button id="desk-go">${jt.next}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("leave",{},t)})}rate(){this.answers={},this.scales=new Map,this.turn(()=>this.question("controllable"))}question(t){const{verdict:e}=this.state,i=`<button data-answer="yes">${jt.yes}</button><button data-answer="no">${jt.no}</button>`;this.frame(`${this.heading()} · Cooper-Harper`,`<p class="${e.success?"ok":""}">${pe(Ur(e.words||""))}</p>${this.state.why?`<p class="alarm">${pe(this.state.why)}</p>`:""}<p>${pe(Te(jt.tree[t],{goal:this.task.goal}))}</p>`,i,s=>{s.querySelector("[data-answer=yes]").focus();for(const r of s.querySelectorAll("[data-answer]"))r.onclick=()=>this.answered(t,r.dataset.answer==="yes")})}answered(t,e){const i=["controllable","adequate","satisfactory"];if(this.answers[t]=e,!e)for(const r of i.slice(i.indexOf(t)+1))this.answers[r]=!1;const s=i[i.indexOf(t)+1];this.turn(e&&s?()=>this.question(s):()=>this.pick())}pick(){const{controllable:t,adequate:e,satisfactory:i}=this.answers,r=(t?e?i?[1,2,3]:[4,5,6]:[7,8,9]:[10]).map(o=>`<button data-rating="${o}"><b>${o}</b> ${jt.ratings[o]}</button>`).join("");this.frame(`${this.heading()} · Cooper-Harper`,`<p>${jt.pick}</p><div class="choices">${r}</div>`,`<button id="desk-back">${jt.again}</button>`,o=>{o.querySelector("#desk-back").onclick=()=>this.rate();for(const a of o.querySelectorAll("[data-rating]"))a.onclick=()=>{this.answers.rating=Number(a.dataset.rating),this.turn(()=>this.tlx())};o.querySelector("[data-rating]").focus()})}tlx(){const t=Object.entries(jt.tlx).map(([e,[i,s,r,o]])=>`<fieldset><legend>${i}</legend>
      <label for="tlx-${e}">${s}</label><input type="range" class="unset" aria-valuetext="${jt.unset}" id="tlx-${e}" data-tlx="${e}" min="0" max="100" step="${Bg}" value="50">
      <div class="scale-ends"><span>${r}</span><output id="out-${e}">–</output><span>${o}</span></div></fieldset>`).join("");this.frame(`${this.heading()} · NASA-TLX`,t,`<button id="desk-back">${jt.again}</button><button class="primary" id="desk-go" disabled>${jt.save}</button>`,e=>{const{scales:i}=this,s=r=>{i.set(r.dataset.tlx,Number(r.value)),r.classList.remove("unset"),r.removeAttribute("aria-valuetext"),e.querySelector(`#out-${r.dataset.tlx}`).textContent=r.value,e.querySelector("#desk-go").disabled=i.size<Object.keys(jt.tlx).length};for(const r of e.querySelectorAll("[data-tlx]"))i.has(r.dataset.tlx)&&(r.value=i.get(r.dataset.tlx),s(r)),r.oninput=()=>s(r),r.onkeydown=o=>{o.key==="Enter"&&s(r)},r.onpointerup=()=>s(r);e.querySelector("#desk-back").onclick=()=>this.rate(),e.querySelector("#desk-go").onclick=()=>this.ask("rate",{cooper_harper:this.answers,tlx:Object.fromEntries(i)},e)})}weigh(){this.chosen=[],this.turn(()=>this.pair(0))}pair(t){const{chosen:e}=this,{pairs:i}=this.state,s=i[t].map(o=>`<button data-scale="${o}" aria-pressed="${e[t]===o}"><b>${jt.tlx[o][0]}</b> ${jt.tlx[o][1]}</button>`).join(""),r=`${this.heading()} · NASA-TLX · ${Te(jt.pair,{n:t+1,of:i.length})}`;this.frame(r,`<p>${jt.weigh}</p><div class="choices">${s}</div>`,t>0?`<button id="desk-back">${jt.back}</button>`:"",o=>{t>0&&(o.querySelector("#desk-back").onclick=()=>this.turn(()=>this.pair(t-1)));for(const a of o.querySelectorAll("[data-scale]"))a.onclick=()=>{e[t]=a.dataset.scale;const l=i.findIndex((c,u)=>!e[u]);this.turn(l<0?()=>this.pairs():()=>this.pair(l))};(o.querySelector("[aria-pressed=true]")||o.querySelector("[data-scale]")).focus()})}pairs(){const{chosen:t}=this,e=s=>jt.tlx[s][0],i=this.state.pairs.map((s,r)=>`<tr><td>${s.map(o=>o===t[r]?`<b>${e(o)} ✓</b>`:e(o)).join(` ${Z.or} `)}</td>
      <td><button data-pair="${r}" aria-label="${jt.change} ${s.map(e).join(` ${Z.or} `)}">${jt.change}</button></td></tr>`).join("");this.frame(`${this.heading()} · NASA-TLX`,`<p>${jt.chosen}</p><table>${i}</table>`,`<button class="primary" id="desk-go">${jt.save_pairs}</button>`,s=>{for(const r of s.querySelectorAll("[data-pair]"))r.onclick=()=>this.turn(()=>this.pair(Number(r.dataset.pair)));s.querySelector("#desk-go").onclick=()=>this.ask("weigh",{chosen:t},s),s.querySelector("#desk-go").focus()})}}const[Eu,Kd,Ya,Eo,bu,wu,Tu]=[0,1,2,3,4,5,6],Tr=3,jd=6,Ph={[Ya]:"✓",[Eo]:"✓",[bu]:"✗",[wu]:"✗",[Tu]:"?"};function Zd([n,t,e,i,s,r,o,...a]){return{seq:n,sent:t,due:e,kind:i,state:s,refusal:r,told:o,value:a}}function Hg(n,t){return n.told>=0&&n.told<=t?n:{...n,state:t<n.due?Eu:Kd,told:-1}}const Jd=n=>n.kind===Tr&&(n.state===Ya||n.state===Eo);function Gg(n,t,e){const i=e.step_s,s=Math.max(n.due-n.sent,1);if(n.told>=0)return .8+.2*Math.min(1,(t-n.told)*i/jd);if(t<n.due)return .05+.37*((t-n.sent)/s);const r=Math.max(e.back_s/i,1);return .46+.34*Math.min(1,(t-n.due)/r)}function Vg(n,t,e,i,s){const{pen:r,w:o,h:a,rem:l}=Wr(n),c=s/t.step_s,u=l*1.35,h=[[0,.05,Z.ladder_ground],[.05,.42,Z.ladder_link],[.42,.5,Z.ladder_craft],[.5,.8,Z.ladder_back],[.8,1,Z.ladder_known]];for(const[v,m,p]of h)r.fillStyle=p===Z.ladder_craft?"#17222e":"#0a1018",r.fillRect(v*o+1,u,(m-v)*o-2,a-u),v!==0&&Je(r,p,(v+m)/2*o,l*.55,Xt.dim,"center");Je(r,Z.ladder_ground,0,l*.55,Xt.dim);const f=(a-u)/e.length;e.forEach((v,m)=>Je(r,v.name,l*.35,u+f*(m+.5),Xt.dim));const d=Math.max(2,.37*o/Math.max(t.forward_s/t.step_s,8)-1),g={top:u,lane:f,bottom:a,width:Math.min(d,l),rem:l};for(const v of i){const m=Gg(v,c,t);m>=1||v.told>=0&&(c-v.told)*t.step_s>jd||Wg(r,v,m*o,e,g)}}function Wg(n,t,e,i,{top:s,lane:r,bottom:o,width:a,rem:l}){const c=t.state===bu||t.state===wu,u=t.value.some(f=>f!==0),h=t.kind===Tr||c?Xt.alarm:t.state===Eo||t.state===Ya?Xt.ok:t.state===Tu?Xt.dim:t.state===Kd?Xt.predicted:Xt.measured;if(n.fillStyle=h,!u&&!c&&t.kind!==Tr){n.globalAlpha=t.state===Eo?.25:.5,i.forEach((f,d)=>n.fillRect(e,s+r*(d+.5)-1,Math.max(a*.5,1),2)),n.globalAlpha=1;return}(t.kind===Tr||c)&&n.fillRect(e,s,Math.max(1.5,a*.4),o-s),i.forEach((f,d)=>{const g=t.value[d];if(!g)return;const v=Math.min(Math.abs(g)/f.highest,1)*r*.46,m=s+r*(d+.5);t.state===Eu&&(n.globalAlpha=.85),n.fillRect(e,g>0?m-v:m,a,v),n.globalAlpha=1}),Ph[t.state]&&c&&Je(n,Ph[t.state],e,s+l*.4,h)}function $g(n){const t={};for(const s of n)t[s.state]=(t[s.state]||0)+1;const e=t[Eu]||0,i=[...n.some(Jd)?[Z.aborted]:[],`${e} ${Z.ladder_link}`];for(const s of[Ya,Eo,bu,wu,Tu])t[s]&&i.push(`${t[s]} ${rg[s]}`);return i.join(" · ")}const Lh=2500,Xg=500,qg=800,Yg=8e3,Kg=n=>new Promise(t=>{setTimeout(t,n)});class jg{constructor(t,e){Object.assign(this,{link:t,store:e,wanted:null,unanswered:null})}async steer(t){this.unanswered=null,(await this.link.ask({...t,run:this.store.run?.name},Lh)).code==="NO_ANSWER"&&(this.unanswered={wish:t,at:performance.now()})}async abort(){const t=this.store.run?.name;if(this.wanted&&!this.wanted.accepted&&this.goesOn(this.wanted))return;const e={run:t,times:0,since:performance.now(),accepted:!1};this.wanted=e;do{e.times+=1;const i=await this.link.ask({do:"abort",run:t},Lh);e.accepted=i.ok,i.ok||await Kg(Xg)}while(!e.accepted&&this.goesOn(e))}goesOn({run:t}){const{store:e}=this;return e.run!==null&&e.run.name===t&&!e.verdict&&(e.status.phase==="flying"||!e.connected)}words(){const{store:t,wanted:e,unanswered:i}=this,s=t.connected?"":`${Z.socket_closed}. `;if(e&&!this.goesOn(e))this.wanted=null;else{if(e&&!e.accepted)return performance.now()-e.since<qg?[Z.abort_asked,""]:[Z.abort_unconfirmed,s+Te(Z.abort_again,{n:e.times})];if(e&&t.abortAt===null&&t.connected)return[Z.abort_accepted,t.frame?.paused?Z.paused:""]}if(!i||performance.now()-i.at>Yg||this.done(i.wish))return null;const r=i.wish.do==="mode"?mc(t.display,i.wish.mode):Z[i.wish.do];return[Te(Z.unconfirmed,{name:r.toUpperCase()}),s+Z.unconfirmed_hint]}done(t){const{frame:e,verdict:i,connected:s}=this.store;return i?!0:!e||!s?!1:t.do==="stop"?this.store.status.phase!=="flying":t.do==="mode"?e.mode===t.mode:!!e.paused==(t.do==="pause")}}const Zg=20,Jg=4,Qd="rvd.stick",Fa=-1;function Dh(n,t){if(!Number.isFinite(n))return 0;const e=Math.min(Math.abs(n),1);return e<=t?0:Math.sign(n)*(e-t)/(1-t)}class Qg{constructor(t){this.onChange=t,this.down=new Set,this.step=1,this.source="keyboard",this.pads=[],this.gamepad=null,this.settingUp=!1,this.settings=e_(),this.setController(null),addEventListener("keydown",i=>this.key(i,!0)),addEventListener("keyup",i=>this.key(i,!1));const e=()=>{this.down.clear(),this.send(!0)};addEventListener("blur",e),document.addEventListener("visibilitychange",e),setInterval(()=>this.poll(),Zg)}setController(t){this.axes=t?.axes||[],this.deflections=t?.key_deflections||[1],this.step=Math.min(this.step,this.deflections.length),this.keys=new Map,this.buttons=t?.buttons||[],this.axes.forEach((e,i)=>e.keys.forEach(([s,r])=>this.keys.set(s,[i,1]).set(r,[i,-1]))),this.disarm()}taken(){this.down.clear(),this.disarm()}disarm(){this.armed=this.axes.map(()=>!1)}wiring(t,e){const i=this.settings.pads[t.id]?.axes[e.name];return i?i.axis<t.axes.length?i:null:t.mapping==="standard"&&e.pad_pair?e.pad_pair.every(s=>s<t.buttons.length)?{pair:e.pad_pair,sign:1}:null:t.mapping!=="standard"||e.pad_axis>=t.axes.length?null:{axis:e.pad_axis,sign:e.pad_inverted?-1:1}}button(t){const e=this.settings.pads[t.id]?.button??(t.mapping==="standard"?Jg:null);return e!==null&&e<t.buttons.length?e:null}ready(t){return!this.settingUp&&this.button(t)!==null&&this.axes.every(e=>this.wiring(t,e)!==null)}lacks(){return this.pads.length?this.gamepad?this.ready(this.gamepad)?"":"setup":"choose":""}pick(t){this.change({chosen:{id:t.id,index:t.index??0}})}setUp(t,{axes:e={},button:i}){const s=this.settings.pads[t.id]||{axes:{},button:null},r={axes:{...s.axes,...e},button:i??s.button};this.change({pads:{...this.settings.pads,[t.id]:r}})}change(t){this.settings={...this.settings,...t},this.disarm(),Jm("local",Qd,JSON.stringify(this.settings))}choose(){const{chosen:t}=this.settings,e=this.pads.filter(i=>i.id===t?.id);return e.length===1?e[0]:e.length>1?e.find(i=>i.index===t.index)||null:this.pads.length===1?this.pads[0]:null}deflection(t){return this.axes.map(e=>{const i=this.wiring(t,e);return i?i.pair?Dh(Ih(t,i.pair[0])-Ih(t,i.pair[1]),this.settings.deadZone):i.axis===Fa?0:i.sign*Dh(t.axes[i.axis],this.settings.deadZone):null})}key(t,e){if(t.ctrlKey||t.metaKey||t.altKey||tp(t.target)||e&&t.target instanceof Element&&t.target.closest("input, select, dialog"))return;const i=Number(/^(?:Digit|Numpad)([1-9])$/.exec(t.code)?.[1]);if(e&&i<=this.deflections.length){this.step=i,this.send(!0);return}const s=this.buttons.some(o=>o.key===t.code);if(!this.keys.has(t.code)&&!s&&t.code!=="Space"||t.code==="Space"&&!this.settings.holdSpace||(t.preventDefault(),t.repeat))return;const r=this.down.has(t.code);e?this.down.add(t.code):this.down.delete(t.code),e&&(this.source="keyboard"),r!==e&&this.send(!0)}poll(){this.pads=t_();const t=this.choose();(t?.id!==this.gamepad?.id||t?.index!==this.gamepad?.index)&&this.disarm(),this.gamepad=t,t&&this.ready(t)&&Sl(t,this.button(t))&&(this.source="gamepad"),this.holds()?this.deflection(t).forEach((e,i)=>{e===0&&(this.armed[i]=!0)}):this.disarm(),this.send(!1)}holds(){const t=this.gamepad;return this.source==="gamepad"&&Uh()&&t!==null&&this.ready(t)&&Sl(t,this.button(t))}gone(){return this.source==="gamepad"&&this.gamepad===null}stuck(){return this.holds()?this.axes.filter((t,e)=>!this.armed[e]).map(t=>t.name):[]}pressed(){const t=this.source==="gamepad"?this.gamepad:null;return this.buttons.reduce((e,i,s)=>{const r=t?t.mapping==="standard"&&Sl(t,i.pad_button):this.down.has(i.key);return e|(r?1<<s:0)},0)}withButtons(t){return this.buttons.length?{...t,buttons:this.pressed()}:t}state(){if(this.source==="gamepad"){const i=this.holds();return this.withButtons({held:i,at:i?this.deflection(this.gamepad).map((s,r)=>this.armed[r]?s:0):this.axes.map(()=>0)})}const t=this.axes.map(()=>0);for(const i of this.down)this.keys.has(i)&&(t[this.keys.get(i)[0]]+=this.keys.get(i)[1]);const e=this.deflections[this.step-1];return this.withButtons({held:Uh()&&(!this.settings.holdSpace||this.down.has("Space")),at:t.map(i=>Math.max(-1,Math.min(1,i))*e)})}send(t){this.onChange(this.state(),t)}}const Uh=()=>document.visibilityState==="visible"&&document.hasFocus();function t_(){try{return[...navigator.getGamepads?.()||[]].filter(n=>n&&n.connected!==!1)}catch{return[]}}function Sl(n,t){return!!n.buttons[t]?.pressed}function Ih(n,t){const e=n.buttons[t];return e?Math.max(e.value??0,e.pressed&&!e.value?1:0):0}function tp(n){return n instanceof Element&&!!n.closest("input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]")}function e_(){let n=null;try{n=JSON.parse(Qm("local",Qd))}catch{}const t={};for(const[e,i]of Object.entries(n?.pads??{})){const s=Object.entries(i?.axes??{}).filter(([,r])=>Number.isInteger(r?.axis)&&r.axis>=Fa&&Math.abs(r.sign)===1);t[e]={axes:Object.fromEntries(s),button:Number.isInteger(i?.button)&&i.button>=0?i.button:null}}return{pads:t,chosen:typeof n?.chosen?.id=="string"?n.chosen:null,holdSpace:n?.holdSpace===!0,deadZone:n?.deadZone>=0&&n.deadZone<=.4?Number(n.deadZone):.08}}const n_=60,[i_,Nh]=[.5,.3];function s_(n,t,e){if(t===null)return Z.unknown;const{axes:i,digits:s}=n.commands;return i.length===n.controller.axes.length?pc(t*i[e].highest,s):pc(t,2)}class r_{constructor(t,e){Object.assign(this,{stick:t,display:e,seen:null,lead:null}),this.dialog=Xs(`<h3>${Z.settings_title}</h3><p id="pad-note" role="status"></p>
      <fieldset id="pads"><legend>${Z.settings_pads}</legend></fieldset><p id="pad-lead" role="status"></p><div id="pad-steps" class="buttons"></div>
      <table id="pad-axes"></table>
      <p><label>${Z.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${t.settings.deadZone}"></label></p>
      <p><label><input type="checkbox" id="hold-space" ${t.settings.holdSpace?"checked":""}> ${Z.settings_space}</label></p>
      ${Hd?"":`<p class="alarm">${Z.no_storage}</p>`}<div class="buttons">${Ro}</div>`),this.body=this.$("#pads"),this.dialog.onchange=i=>this.changed(i.target),this.timer=setInterval(()=>this.look(),n_),this.look()}$(t){return this.dialog.querySelector(t)}look(){const{stick:t}=this;if(!this.dialog.open||!this.dialog.contains(this.body)){clearInterval(this.timer),t.settingUp=!1;return}const e=t.gamepad,i=JSON.stringify([t.pads.map(s=>[s.id,s.index]),e?.index,t.settings.pads,t.settings.chosen]);i!==this.seen&&(this.lead&&this.lead.index!==e?.index&&this.stop(),this.seen=i,this.build()),t.pads.forEach((s,r)=>_n(this.$(`[data-live="${r}"]`),Te(Z.pad_live,{axes:s.axes.map(o=>qe(o,2)).join(" "),buttons:s.buttons.flatMap((o,a)=>o.pressed?[a]:[]).join(" ")||Z.pad_nothing}))),e&&(t.deflection(e).forEach((s,r)=>_n(this.$(`[data-now="${t.axes[r].name}"]`),s_(this.display,s,r))),this.lead&&this.follow(e))}build(){const{stick:t}=this,e=t.gamepad;this.$("#pads").hidden=!t.pads.length,this.$("#pads").innerHTML=`<legend>${Z.settings_pads}</legend>${t.pads.map((r,o)=>`<p><label><input type="radio" name="pad" value="${o}" ${r===e?"checked":""}>
      ${pe(r.id)}${r.mapping==="standard"?"":` (${Z.pad_plain})`}</label><br><small class="dim num" data-live="${o}"></small></p>`).join("")}`;const i=e&&t.ready(e),s=t.pads.length?e?i||this.lead?Z.pad_ready:Z.pad_setup:Z.pad_choose:Z.settings_none;_n(this.$("#pad-note"),this.lead?"":s),this.$("#pad-note").className=!e||i?"":"alarm",this.$("#pad-axes").innerHTML=e?this.table(e):"",this.lead||this.buttons(e&&t.axes.length?[["pad-start",Z.pad_start,()=>this.begin(e)]]:[])}table(t){const{stick:e}=this;return`${e.axes.map(s=>{const r=e.wiring(t,s);return`<tr><td>${pe(`${s.positive} / ${s.negative}`)}</td>
        <td>${r?.pair?`${Te(Z.settings_pair,{plus:r.pair[0],minus:r.pair[1]})} `:""}<label>${Z.settings_axis} <input type="number" class="short" min="${Fa}" max="${t.axes.length-1}" data-axis="${s.name}" value="${r?.axis??""}"></label></td>
        <td><label><input type="checkbox" data-invert="${s.name}" ${r?.sign<0?"checked":""}> ${Z.settings_invert}</label></td>
        <td>${Z.settings_now} <b data-now="${s.name}"></b></td></tr>`}).join("")}<tr><td>${Z.settings_button}</td><td colspan="3"><input type="number" class="short" min="0" max="${t.buttons.length-1}"
      id="pad-button" aria-label="${Z.settings_button}" value="${e.button(t)??""}"></td></tr>`}changed(t){const{stick:e}=this,i=e.gamepad;if(t.name==="pad")e.pick(e.pads[Number(t.value)]);else if(t.id==="pad-zone")e.change({deadZone:Number(t.value)});else if(t.id==="hold-space")e.change({holdSpace:t.checked});else if(i&&t.validity.valid&&(t.type==="checkbox"||t.value!=="")){const s=t.dataset.axis||t.dataset.invert;t.id==="pad-button"?e.setUp(i,{button:Number(t.value)}):s&&this.$(`[data-axis="${s}"]`).value!==""&&e.setUp(i,{axes:{[s]:{axis:Number(this.$(`[data-axis="${s}"]`).value),sign:this.$(`[data-invert="${s}"]`).checked?-1:1}}})}}buttons(t){this.$("#pad-steps").replaceChildren(...t.map(([e,i,s])=>{const r=document.createElement("button");return Object.assign(r,{id:e,textContent:i,onclick:s}),r}))}begin(t){this.stick.settingUp=!0,this.lead={index:t.index,at:-1,axes:{},back:null},this.seen=null,this.say(Z.pad_rest),this.buttons([["pad-next",Z.pad_next,()=>{Object.assign(this.lead,{rest:[...this.stick.gamepad.axes],down:this.stick.gamepad.buttons.map(e=>e.pressed)}),this.next()}],["pad-stop",Z.pad_stop,()=>this.stop()]])}say(t){_n(this.$("#pad-lead"),t)}stop(){this.stick.settingUp=!1,this.lead=null,this.seen=null,this.say("")}next(){const{lead:t,stick:e}=this;t.at+=1;const i=e.axes[t.at];if(!i){this.say(Z.pad_hold),this.buttons([["pad-stop",Z.pad_stop,()=>this.stop()]]);return}this.say(Te(Z.pad_move,{what:i.positive,name:i.name})),this.buttons([["pad-skip",Z.pad_skip,()=>{t.axes[i.name]={axis:Fa,sign:1},this.next()}],["pad-stop",Z.pad_stop,()=>this.stop()]])}follow(t){const{lead:e,stick:i}=this;if(e.at<0)return;const s=t.axes.map((c,u)=>c-e.rest[u]);if(e.back!==null){if(Math.abs(s[e.back])>Nh)return;e.back=null,this.next();return}const r=i.axes[e.at];if(!r){const c=t.buttons.findIndex((h,f)=>h.pressed&&!e.down[f]);if(c<0)return;const{axes:u}=e;this.stop(),i.setUp(t,{axes:u,button:c});return}const o=Object.values(e.axes).map(c=>c.axis),a=s.map((c,u)=>o.includes(u)?0:Math.abs(c)),l=a.indexOf(Math.max(...a));if(a[l]>i_){if(Math.abs(e.rest[l])>Nh){this.say(`${Te(Z.pad_trigger,{axis:l})} ${Te(Z.pad_move,{what:r.positive,name:r.name})}`);return}e.axes[r.name]={axis:l,sign:Math.sign(s[l])},e.back=l,this.say(Z.pad_back)}}}function ep(n,t){return new r_(n,t)}const o_=!0,an="u-",a_="uplot",l_=an+"hz",c_=an+"vt",u_=an+"title",h_=an+"wrap",f_=an+"under",d_=an+"over",p_=an+"axis",Fs=an+"off",m_=an+"select",g_=an+"cursor-x",__=an+"cursor-y",v_=an+"cursor-pt",x_=an+"legend",M_=an+"live",S_=an+"inline",y_=an+"series",E_=an+"marker",Fh=an+"label",b_=an+"value",mo="width",go="height",oo="top",Oh="bottom",ar="left",yl="right",Au="#000",kh=Au+"0",El="mousemove",Bh="mousedown",bl="mouseup",zh="mouseenter",Hh="mouseleave",Gh="dblclick",w_="resize",T_="scroll",Vh="change",Oa="dppxchange",Ru="--",$r=typeof window<"u",gc=$r?document:null,Ar=$r?window:null,A_=$r?navigator:null;let Ee,Vo;function _c(){let n=devicePixelRatio;Ee!=n&&(Ee=n,Vo&&xc(Vh,Vo,_c),Vo=matchMedia(`(min-resolution: ${Ee-.001}dppx) and (max-resolution: ${Ee+.001}dppx)`),Hs(Vh,Vo,_c),Ar.dispatchEvent(new CustomEvent(Oa)))}function Xn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function vc(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function ke(n,t,e){n.style[t]=e+"px"}function mi(n,t,e,i){let s=gc.createElement(n);return t!=null&&Xn(s,t),e?.insertBefore(s,i),s}function ni(n,t){return mi("div",n,t)}const Wh=new WeakMap;function Ri(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Wh.get(n);r!=o&&(n.style.transform=r,Wh.set(n,r),t<0||e<0||t>i||e>s?Xn(n,Fs):vc(n,Fs))}const $h=new WeakMap;function Xh(n,t,e){let i=t+e,s=$h.get(n);i!=s&&($h.set(n,i),n.style.background=t,n.style.borderColor=e)}const qh=new WeakMap;function Yh(n,t,e,i){let s=t+""+e,r=qh.get(n);s!=r&&(qh.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}const Cu={passive:!0},R_={...Cu,capture:!0};function Hs(n,t,e,i){t.addEventListener(n,e,i?R_:Cu)}function xc(n,t,e,i){t.removeEventListener(n,e,Cu)}$r&&_c();function gi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Kn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function np(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}const ip=n=>n!=null,sp=n=>n!=null&&n>0,Ka=np(ip),C_=np(sp);function P_(n,t,e,i=0,s=!1){let r=s?C_:Ka,o=s?sp:ip;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Le,l??-Le]}function ja(n,t,e,i){let s=Zh(n),r=Zh(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Zi:rp,a=s==1?Kn:si,l=r==1?si:Kn,c=a(o(nn(n))),u=l(o(nn(t))),h=Ir(e,c),f=Ir(e,u);return e==10&&(c<0&&(h=De(h,-c)),u<0&&(f=De(f,-u))),i||e==2?(n=h*s,t=f*r):(n=cp(n,h),t=Za(t,f)),[n,t]}function Pu(n,t,e,i){let s=ja(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}const Lu=.1,Kh={mode:3,pad:Lu},Mo={pad:0,soft:null,mode:0},L_={min:Mo,max:Mo};function ka(n,t,e,i){return Ja(e)?jh(n,t,e):(Mo.pad=e,Mo.soft=i?0:null,Mo.mode=i?3:0,jh(n,t,L_))}function Me(n,t){return n??t}function D_(n,t,e){for(t=Me(t,0),e=Me(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function jh(n,t,e){let i=e.min,s=e.max,r=Me(i.pad,0),o=Me(s.pad,0),a=Me(i.hard,-Le),l=Me(s.hard,Le),c=Me(i.soft,Le),u=Me(s.soft,-Le),h=Me(i.mode,0),f=Me(s.mode,0),d=t-n,g=Zi(d),v=Un(nn(n),nn(t)),m=Zi(v),p=nn(m-g);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,h==2&&c!=Le&&(r=0),f==2&&u!=-Le&&(o=0)));let y=d||v||1e3,T=Zi(y),x=Ir(10,Kn(T)),I=y*(d==0?n==0?.1:1:r),A=De(cp(n-I,x/10),24),D=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Le,U=Un(a,A<D&&n>=D?D:_i(D,A)),w=y*(d==0?t==0?.1:1:o),S=De(Za(t+w,x/10),24),C=t<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-Le,G=_i(l,S>C&&t<=C?C:Un(C,S));return U==G&&U==0&&(G=100),[U,G]}const U_=new Intl.NumberFormat($r?A_.language:"en-US"),Du=n=>U_.format(n),Zn=Math,wa=Zn.PI,nn=Zn.abs,Kn=Zn.floor,en=Zn.round,si=Zn.ceil,_i=Zn.min,Un=Zn.max,Ir=Zn.pow,Zh=Zn.sign,Zi=Zn.log10,rp=Zn.log2,I_=(n,t=1)=>Zn.sinh(n)*t,wl=(n,t=1)=>Zn.asinh(n/t),Le=1/0;function Jh(n){return(Zi((n^n>>31)-(n>>31))|0)+1}function Mc(n,t,e){return _i(Un(n,t),e)}function op(n){return typeof n=="function"}function le(n){return op(n)?n:()=>n}const N_=()=>{},ap=n=>n,lp=(n,t)=>t,F_=n=>null,Qh=n=>!0,tf=(n,t)=>n==t,O_=/\.\d*?(?=9{6,}|0{6,})/gm,Gs=n=>{if(hp(n)||_s.has(n))return n;const t=`${n}`,e=t.match(O_);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Gs(s)}e${r}`}return De(n,i)};function Ds(n,t){return Gs(De(Gs(n/t))*t)}function Za(n,t){return Gs(si(Gs(n/t))*t)}function cp(n,t){return Gs(Kn(Gs(n/t))*t)}function De(n,t=0){if(hp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return en(i)/e}const _s=new Map;function up(n){return((""+n).split(".")[1]||"").length}function bo(n,t,e,i){let s=[],r=i.map(up);for(let o=t;o<e;o++){let a=nn(o),l=De(Ir(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:De(u,h);s.push(f),_s.set(f,h)}}return s}const So={},Uu=[],Nr=[null,null],ds=Array.isArray,hp=Number.isInteger,k_=n=>n===void 0;function ef(n){return typeof n=="string"}function Ja(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function B_(n){return n!=null&&typeof n=="object"}const z_=Object.getPrototypeOf(Uint8Array),fp="__proto__";function Fr(n,t=Ja){let e;if(ds(n)){let i=n.find(s=>s!=null);if(ds(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Fr(n[s],t)}else e=n.slice()}else if(n instanceof z_)e=n.slice();else if(t(n)){e={};for(let i in n)i!=fp&&(e[i]=Fr(n[i],t))}else e=n;return e}function je(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=fp&&(Ja(n[s])?je(n[s],Fr(i[s])):n[s]=Fr(i[s]))}return n}const H_=0,G_=1,V_=2;function W_(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function $_(n,t){if(Y_(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return K_(o[0])||(o=q_(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:G_,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?f!=H_&&(h[m]=v,f==V_&&d.push(m)):h[m]=v}W_(h,d,s),i.push(h)}}return i}const X_=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function q_(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Y_(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function K_(n,t=100){const e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=Un(1,Kn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const dp=["January","February","March","April","May","June","July","August","September","October","November","December"],pp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function mp(n){return n.slice(0,3)}const j_=pp.map(mp),Z_=dp.map(mp),J_={MMMM:dp,MMM:Z_,WWWW:pp,WWW:j_};function ao(n){return(n<10?"0":"")+n}function Q_(n){return(n<10?"00":n<100?"0":"")+n}const t0={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ao(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ao(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ao(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ao(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ao(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Q_(n.getMilliseconds())};function Iu(n,t){t=t||J_;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?t0[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const e0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function n0(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==e0?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}const gp=n=>n%1==0,Ba=[1,2,2.5,5],i0=bo(10,-32,0,Ba),_p=bo(10,0,32,Ba),s0=_p.filter(gp),Us=i0.concat(_p),Nu=`
`,vp="{YYYY}",nf=Nu+vp,xp="{M}/{D}",_o=Nu+xp,Wo=_o+"/{YY}",Mp="{aa}",r0="{h}:{mm}",yr=r0+Mp,sf=Nu+yr,rf=":{ss}",we=null;function Sp(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?bo(10,0,3,Ba).filter(gp):bo(10,-3,0,Ba)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,vp,we,we,we,we,we,we,1],[s*28,"{MMM}",nf,we,we,we,we,we,1],[s,xp,nf,we,we,we,we,we,1],[i,"{h}"+Mp,Wo,we,_o,we,we,we,1],[e,yr,Wo,we,_o,we,we,we,1],[t,rf,Wo+" "+yr,we,_o+" "+yr,we,sf,we,1],[n,rf+".{fff}",Wo+" "+yr,we,_o+" "+yr,we,sf,we,1]];function u(h){return(f,d,g,v,m,p)=>{let y=[],T=m>=o,x=m>=r&&m<o,I=h(g),A=De(I*n,3),D=Tl(I.getFullYear(),T?0:I.getMonth(),x||T?1:I.getDate()),U=De(D*n,3);if(x||T){let w=x?m/r:0,S=T?m/o:0,C=A==U?A:De(Tl(D.getFullYear()+S,D.getMonth()+w,1)*n,3),G=new Date(en(C/n)),N=G.getFullYear(),V=G.getMonth();for(let j=0;C<=v;j++){let K=Tl(N+S*j,V+w*j,1),Q=K-h(De(K*n,3));C=De((+K+Q)*n,3),C<=v&&y.push(C)}}else{let w=m>=s?s:m,S=Kn(g)-Kn(A),C=U+S+Za(A-U,w);y.push(C);let G=h(C),N=G.getHours()+G.getMinutes()/e+G.getSeconds()/i,V=m/i,j=f.axes[d]._space,K=p/j;for(;C=De(C+m,n==1?0:3),!(C>v);)if(V>1){let Q=Kn(De(N+V,6))%24,ct=h(C).getHours()-Q;ct>1&&(ct=-1),C-=ct*i,N=(N+V)%24;let mt=y[y.length-1];De((C-mt)/m,3)*K>=.7&&y.push(C)}else y.push(C)}return y}}return[l,c,u]}const[o0,a0,l0]=Sp(1),[c0,u0,h0]=Sp(.001);bo(2,-53,53,[1]);function of(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function af(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,f,d;return i.map(g=>{let v=n(g),m=v.getFullYear(),p=v.getMonth(),y=v.getDate(),T=v.getHours(),x=v.getMinutes(),I=v.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||T!=h&&a[5]||x!=f&&a[6]||I!=d&&a[7]||a[1];return l=m,c=p,u=y,h=T,f=x,d=I,A(v)})}}function f0(n,t){let e=Iu(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Tl(n,t,e){return new Date(n,t,e)}function lf(n,t){return t(n)}const d0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function cf(n,t){return(e,i,s,r)=>r==null?Ru:t(n(i))}function p0(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function m0(n,t){return n.series[t].fill(n,t)}const g0={show:!0,live:!0,isolate:!1,mount:N_,markers:{show:!0,width:2,stroke:p0,fill:m0,dash:"solid"},idx:null,idxs:null,values:[]};function _0(n,t){let e=n.cursor.points,i=ni(),s=e.size(n,t);ke(i,mo,s),ke(i,go,s);let r=s/-2;ke(i,"marginLeft",r),ke(i,"marginTop",r);let o=e.width(n,t,s);return o&&ke(i,"borderWidth",o),i}function v0(n,t){let e=n.series[t].points;return e._fill||e._stroke}function x0(n,t){let e=n.series[t].points;return e._stroke||e._fill}function M0(n,t){return n.series[t].points.size}const Al=[0,0];function S0(n,t,e){return Al[0]=t,Al[1]=e,Al}function $o(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Rl(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}const y0={show:!0,x:!0,y:!0,lock:!1,move:S0,points:{one:!1,show:_0,size:M0,width:0,stroke:x0,fill:v0},bind:{mousedown:$o,mouseup:$o,click:$o,dblclick:$o,mousemove:Rl,mouseleave:Rl,mouseenter:Rl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},yp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Fu=je({},yp,{filter:lp}),Ep=je({},Fu,{size:10}),bp=je({},yp,{show:!1}),Ou='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',wp="bold "+Ou,Tp=1.5,uf={show:!0,scale:"x",stroke:Au,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wp,side:2,grid:Fu,ticks:Ep,border:bp,font:Ou,lineGap:Tp,rotate:0},E0="Value",b0="Time",hf={show:!0,scale:"x",auto:!1,sorted:1,min:Le,max:-Le,idxs:[]};function w0(n,t,e,i,s){return t.map(r=>r==null?"":Du(r))}function T0(n,t,e,i,s,r,o){let a=[],l=_s.get(s)||0;e=o?e:De(Za(e,s),l);for(let c=e;c<=i;c=De(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Sc(n,t,e,i,s,r,o){const a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Zi:rp,u=Kn(c(e));s=Ir(l,u),l==10&&(s=Us[gi(s,Us)]);let h=e,f=s*l;l==10&&(f=Us[gi(f,Us)]);do a.push(h),h=h+s,l==10&&!_s.has(h)&&(h=De(h,_s.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Us[gi(f,Us)]));while(h<=i);return a}function A0(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Sc(n,t,Un(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Sc(n,t,Un(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}const Ap=/./,R0=/[12357]/,C0=/[125]/,ff=/1/,yc=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function P0(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Ap:l(7,o)-u>=c?R0:l(5,o)-u>=c?C0:ff;if(h==ff){let f=nn(l(1,o)-u);if(f<c)return yc(t.slice().reverse(),a.distr,h,si(c/f)).reverse()}return yc(t,a.distr,h,1)}function L0(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=nn(l(1,o)-l(2,o));return c<a?yc(t.slice().reverse(),3,Ap,si(a/c)).reverse():t}function D0(n,t,e,i){return i==null?Ru:t==null?"":Du(t)}const df={show:!0,scale:"y",stroke:Au,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wp,side:3,grid:Fu,ticks:Ep,border:bp,font:Ou,lineGap:Tp,rotate:0};function U0(n,t){let e=3+(n||1)*2;return De(e*t,3)}function I0(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=nn(o-r),l=n.series[t],c=a/(l.points.space*Ee);return i[1]-i[0]<=c}const pf={scale:null,auto:!0,sorted:0,min:Le,max:-Le},Rp=(n,t,e,i,s)=>s,mf={show:!0,auto:!0,sorted:0,gaps:Rp,alpha:1,facets:[je({},pf,{scale:"x"}),je({},pf,{scale:"y"})]},gf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Rp,alpha:1,points:{show:I0,filter:null},values:null,min:Le,max:-Le,idxs:[],path:null,clip:null};function N0(n,t,e,i,s){return e/10}const Cp={time:o_,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},F0=je({},Cp,{time:!1,ori:1}),_f={};function Pp(n,t){let e=_f[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(_f[n]=e)),e}const Or=1,Ec=2;function qs(n,t,e){const i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,v,tl,Xr,nl,Dp,Ip):e(s,l,c,u,h,p,m,d,f,v,g,el,qr,zu,Up,Np)}function ku(n,t){let e=0,i=0,s=Me(n.bands,Uu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function O0(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ji(n,t,e,i,s,r){return qs(n,t,(o,a,l,c,u,h,f,d,g,v,m)=>{let p=o.pxRound;const y=c.dir*(c.ori==0?1:-1),T=c.ori==0?Xr:qr;let x,I;y==1?(x=e,I=i):(x=i,I=e);let A=p(h(a[x],c,v,d)),D=p(f(l[x],u,m,g)),U=p(h(a[I],c,v,d)),w=p(f(r==1?u.max:u.min,u,m,g)),S=new Path2D(s);return T(S,U,w),T(S,A,w),T(S,A,D),S})}function Qa(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=t==0?nl:zu;let l=e;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function k0(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Bu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(n[h]),g=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=d&&a.push([d,g])}return a}function vf(n){return n==0?ap:n==1?en:t=>Ds(t,n)}function Lp(n){let t=n==0?tl:el,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=_i(c,a/2,l/2),u=_i(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const tl=(n,t,e)=>{n.moveTo(t,e)},el=(n,t,e)=>{n.moveTo(e,t)},Xr=(n,t,e)=>{n.lineTo(t,e)},qr=(n,t,e)=>{n.lineTo(e,t)},nl=Lp(0),zu=Lp(1),Dp=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Up=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Ip=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Np=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Fp(n){return(t,e,i,s,r)=>qs(t,e,(o,a,l,c,u,h,f,d,g,v,m)=>{let{pxRound:p,points:y}=o,T,x;c.ori==0?(T=tl,x=Dp):(T=el,x=Up);const I=De(y.width*Ee,3);let A=(y.size-y.width)/2*Ee,D=De(A*2,3),U=new Path2D,w=new Path2D,{left:S,top:C,width:G,height:N}=t.bbox;nl(w,S-D,C-D,G+D*2,N+D*2);const V=j=>{if(l[j]!=null){let K=p(h(a[j],c,v,d)),Q=p(f(l[j],u,m,g));T(U,K+A,Q),x(U,K,Q,A,0,wa*2)}};if(r)r.forEach(V);else for(let j=i;j<=s;j++)V(j);return{stroke:I>0?U:null,fill:U,clip:w,flags:Or|Ec}})}function Op(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}const B0=Op(Xr),z0=Op(qr);function kp(n){const t=Me(n?.alignGaps,0);return(e,i,s,r)=>qs(e,i,(o,a,l,c,u,h,f,d,g,v,m)=>{[s,r]=Ka(l,s,r);let p=o.pxRound,y=N=>p(h(N,c,v,d)),T=N=>p(f(N,u,m,g)),x,I;c.ori==0?(x=Xr,I=B0):(x=qr,I=z0);const A=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Or},U=D.stroke;let w=!1;if(r-s>=v*4){let N=pt=>e.posToVal(pt,c.key,!0),V=null,j=null,K,Q,tt,ht=y(a[A==1?s:r]),ct=y(a[s]),mt=y(a[r]),Mt=N(A==1?ct+1:mt-1);for(let pt=A==1?s:r;pt>=s&&pt<=r;pt+=A){let it=a[pt],gt=(A==1?it<Mt:it>Mt)?ht:y(it),ot=l[pt];gt==ht?ot!=null?(Q=ot,V==null?(x(U,gt,T(Q)),K=V=j=Q):Q<V?V=Q:Q>j&&(j=Q)):ot===null&&(w=!0):(V!=null&&I(U,ht,T(V),T(j),T(K),T(Q)),ot!=null?(Q=ot,x(U,gt,T(Q)),V=j=K=Q):(V=j=null,ot===null&&(w=!0)),ht=gt,Mt=N(ht+A))}V!=null&&V!=j&&tt!=ht&&I(U,ht,T(V),T(j),T(K),T(Q))}else for(let N=A==1?s:r;N>=s&&N<=r;N+=A){let V=l[N];V===null?w=!0:V!=null&&x(U,y(a[N]),T(V))}let[C,G]=ku(e,i);if(o.fill!=null||C!=0){let N=D.fill=new Path2D(U),V=o.fillTo(e,i,o.min,o.max,C),j=T(V),K=y(a[s]),Q=y(a[r]);A==-1&&([Q,K]=[K,Q]),x(N,Q,j),x(N,K,j)}if(!o.spanGaps){let N=[];w&&N.push(...Bu(a,l,s,r,A,y,t)),D.gaps=N=o.gaps(e,i,s,r,N),D.clip=Qa(N,c.ori,d,g,v,m)}return G!=0&&(D.band=G==2?[Ji(e,i,s,r,U,-1),Ji(e,i,s,r,U,1)]:Ji(e,i,s,r,U,G)),D})}function H0(n){const t=Me(n.align,1),e=Me(n.ascDesc,!1),i=Me(n.alignGaps,0),s=Me(n.extend,!1);return(r,o,a,l)=>qs(r,o,(c,u,h,f,d,g,v,m,p,y,T)=>{[a,l]=Ka(h,a,l);let x=c.pxRound,{left:I,width:A}=r.bbox,D=ct=>x(g(ct,f,y,m)),U=ct=>x(v(ct,d,T,p)),w=f.ori==0?Xr:qr;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Or},C=S.stroke,G=f.dir*(f.ori==0?1:-1);let N=U(h[G==1?a:l]),V=D(u[G==1?a:l]),j=V,K=V;s&&t==-1&&(K=I,w(C,K,N)),w(C,V,N);for(let ct=G==1?a:l;ct>=a&&ct<=l;ct+=G){let mt=h[ct];if(mt==null)continue;let Mt=D(u[ct]),pt=U(mt);t==1?w(C,Mt,N):w(C,j,pt),w(C,Mt,pt),N=pt,j=Mt}let Q=j;s&&t==1&&(Q=I+A,w(C,Q,N));let[tt,ht]=ku(r,o);if(c.fill!=null||tt!=0){let ct=S.fill=new Path2D(C),mt=c.fillTo(r,o,c.min,c.max,tt),Mt=U(mt);w(ct,Q,Mt),w(ct,K,Mt)}if(!c.spanGaps){let ct=[];ct.push(...Bu(u,h,a,l,G,D,i));let mt=c.width*Ee/2,Mt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(it=>{it[0]+=Mt,it[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=Qa(ct,f.ori,m,p,y,T)}return ht!=0&&(S.band=ht==2?[Ji(r,o,a,l,C,-1),Ji(r,o,a,l,C,1)]:Ji(r,o,a,l,C,ht)),S})}function xf(n,t,e,i,s,r,o=Le){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=nn(n[l]-n[a]);u<c&&(c=u,o=nn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function G0(n){n=n||So;const t=Me(n.size,[.6,Le,1]),e=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=le(s),o=1-t[0],a=Me(t[1],Le),l=Me(t[2],1),c=Me(n.disp,So),u=Me(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,v,m)=>qs(d,g,(p,y,T,x,I,A,D,U,w,S,C)=>{let G=p.pxRound,N=e,V=i*Ee,j=a*Ee,K=l*Ee,Q,tt;x.ori==0?[Q,tt]=r(d,g):[tt,Q]=r(d,g);const ht=x.dir*(x.ori==0?1:-1);let ct=x.ori==0?nl:zu,mt=x.ori==0?u:(W,et,St,_t,wt,Zt,ft)=>{u(W,et,St,wt,_t,ft,Zt)},Mt=Me(d.bands,Uu).find(W=>W.series[0]==g),pt=Mt!=null?Mt.dir:0,it=p.fillTo(d,g,p.min,p.max,pt),at=G(D(it,I,C,w)),gt,ot,Bt,Gt=S,It=G(p.width*Ee),he=!1,Jt=null,fe=null,z=null,Qe=null;h!=null&&(It==0||f!=null)&&(he=!0,Jt=h.values(d,g,v,m),fe=new Map,new Set(Jt).forEach(W=>{W!=null&&fe.set(W,new Path2D)}),It>0&&(z=f.values(d,g,v,m),Qe=new Map,new Set(z).forEach(W=>{W!=null&&Qe.set(W,new Path2D)})));let{x0:te,size:ne}=c;if(te!=null&&ne!=null){N=1,y=te.values(d,g,v,m),te.unit==2&&(y=y.map(St=>d.posToVal(U+St*S,x.key,!0)));let W=ne.values(d,g,v,m);ne.unit==2?ot=W[0]*S:ot=A(W[0],x,S,U)-A(0,x,S,U),Gt=xf(y,T,A,x,S,U,Gt),Bt=Gt-ot+V}else Gt=xf(y,T,A,x,S,U,Gt),Bt=Gt*o+V,ot=Gt-Bt;Bt<1&&(Bt=0),It>=ot/2&&(It=0),Bt<5&&(G=ap);let Vt=Bt>0,me=Gt-Bt-(Vt?It:0);ot=G(Mc(me,K,j)),gt=(N==0?ot/2:N==ht?0:ot)-N*ht*((N==0?V/2:0)+(Vt?It/2:0));const Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=he?null:new Path2D;let E=null;if(Mt!=null)E=d.data[Mt.series[1]];else{let{y0:W,y1:et}=c;W!=null&&et!=null&&(T=et.values(d,g,v,m),E=W.values(d,g,v,m))}let Y=Q*ot,J=tt*ot;for(let W=ht==1?v:m;W>=v&&W<=m;W+=ht){let et=T[W];if(et==null)continue;if(E!=null){let Ot=E[W]??0;if(et-Ot==0)continue;at=D(Ot,I,C,w)}let St=x.distr!=2||c!=null?y[W]:W,_t=A(St,x,S,U),wt=D(Me(et,it),I,C,w),Zt=G(_t-gt),ft=G(Un(wt,at)),vt=G(_i(wt,at)),Nt=ft-vt;if(et!=null){let Ot=et<0?J:Y,Et=et<0?Y:J;he?(It>0&&z[W]!=null&&ct(Qe.get(z[W]),Zt,vt+Kn(It/2),ot,Un(0,Nt-It),Ot,Et),Jt[W]!=null&&ct(fe.get(Jt[W]),Zt,vt+Kn(It/2),ot,Un(0,Nt-It),Ot,Et)):ct(P,Zt,vt+Kn(It/2),ot,Un(0,Nt-It),Ot,Et),mt(d,g,W,Zt-It/2,vt,ot+It,Nt)}}return It>0?Pt.stroke=he?Qe:P:he||(Pt._fill=p.width==0?p._fill:p._stroke??p._fill,Pt.width=0),Pt.fill=he?fe:P,Pt})}function V0(n,t){const e=Me(t?.alignGaps,0);return(i,s,r,o)=>qs(i,s,(a,l,c,u,h,f,d,g,v,m,p)=>{[r,o]=Ka(c,r,o);let y=a.pxRound,T=Q=>y(f(Q,u,m,g)),x=Q=>y(d(Q,h,p,v)),I,A,D;u.ori==0?(I=tl,D=Xr,A=Ip):(I=el,D=qr,A=Np);const U=u.dir*(u.ori==0?1:-1);let w=T(l[U==1?r:o]),S=w,C=[],G=[];for(let Q=U==1?r:o;Q>=r&&Q<=o;Q+=U)if(c[Q]!=null){let ht=l[Q],ct=T(ht);C.push(S=ct),G.push(x(c[Q]))}const N={stroke:n(C,G,I,D,A,y),fill:null,clip:null,band:null,gaps:null,flags:Or},V=N.stroke;let[j,K]=ku(i,s);if(a.fill!=null||j!=0){let Q=N.fill=new Path2D(V),tt=a.fillTo(i,s,a.min,a.max,j),ht=x(tt);D(Q,S,ht),D(Q,w,ht)}if(!a.spanGaps){let Q=[];Q.push(...Bu(l,c,r,o,U,T,e)),N.gaps=Q=a.gaps(i,s,r,o,Q),N.clip=Qa(Q,u.ori,g,v,m,p)}return K!=0&&(N.band=K==2?[Ji(i,s,r,o,V,-1),Ji(i,s,r,o,V,1)]:Ji(i,s,r,o,V,K)),N})}function W0(n){return V0($0,n)}function $0(n,t,e,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,t[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,n[f+1],t[f+1])}return a}const bc=new Set;function Mf(){for(let n of bc)n.syncRect(!0)}$r&&(Hs(w_,Ar,Mf),Hs(T_,Ar,Mf,!0),Hs(Oa,Ar,()=>{bn.pxRatio=Ee}));const X0=kp(),q0=Fp();function Sf(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>wc(r,o,t,e))}function Y0(n,t){return n.map((e,i)=>i==0?{}:je({},t,e))}function wc(n,t,e,i){return je({},t==0?e:i,n)}function Bp(n,t,e){return t==null?Nr:[t,e]}const K0=Bp;function j0(n,t,e){return t==null?Nr:ka(t,e,Lu,!0)}function zp(n,t,e,i){return t==null?Nr:ja(t,e,n.scales[i].log,!1)}const Z0=zp;function Hp(n,t,e,i){return t==null?Nr:Pu(t,e,n.scales[i].log,!1)}const J0=Hp;function Q0(n,t,e,i,s){let r=Un(Jh(n),Jh(t)),o=t-n,a=gi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?_s.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function yf(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=en((e=+s)*Ee))+"px"),[n,t,e]}function tv(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=De(t[2]*Ee,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function bn(n,t,e){const i={mode:Me(n.mode,1)},s=i.mode;function r(_,M,R,L){let F=M.valToPct(_);return L+R*(M.dir==-1?1-F:F)}function o(_,M,R,L){let F=M.valToPct(_);return L+R*(M.dir==-1?F:1-F)}function a(_,M,R,L){return M.ori==0?r(_,M,R,L):o(_,M,R,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=ni(a_);if(n.id!=null&&(c.id=n.id),Xn(c,n.class),n.title){let _=ni(u_,c);_.textContent=n.title}const u=mi("canvas"),h=i.ctx=u.getContext("2d"),f=ni(h_,c);Hs("click",f,_=>{_.target===g&&(Ne!=nr||Ge!=ir)&&gn.click(i,_)},!0);const d=i.under=ni(f_,f);f.appendChild(u);const g=i.over=ni(d_,f);n=Fr(n);const v=+Me(n.pxAlign,1),m=vf(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});const p=n.ms||.001,y=i.series=s==1?Sf(n.series||[],hf,gf,!1):Y0(n.series||[null],mf),T=i.axes=Sf(n.axes||[],uf,df,!0),x=i.scales={},I=i.bands=n.bands||[];I.forEach(_=>{_.fill=le(_.fill||null),_.dir=Me(_.dir,-1)});const A=s==2?y[1].facets[0].scale:y[0].scale,D={axes:Om,series:Jn},U=(n.drawOrder||["axes","series"]).map(_=>D[_]);function w(_){const M=_.distr==3?R=>Zi(R>0?R:_.clamp(i,R,_.min,_.max,_.key)):_.distr==4?R=>wl(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=M(R),{_min:F,_max:q}=_,st=q-F;return(L-F)/st}}function S(_){let M=x[_];if(M==null){let R=(n.scales||So)[_]||So;if(R.from!=null){S(R.from);let L=je({},x[R.from],R,{key:_});L.valToPct=w(L),x[_]=L}else{M=x[_]=je({},_==A?Cp:F0,R),M.key=_;let L=M.time,F=M.range,q=ds(F);if((_!=A||s==2&&!L)&&(q&&(F[0]==null||F[1]==null)&&(F={min:F[0]==null?Kh:{mode:1,hard:F[0],soft:F[0]},max:F[1]==null?Kh:{mode:1,hard:F[1],soft:F[1]}},q=!1),!q&&Ja(F))){let st=F;F=(lt,dt,Rt)=>dt==null?Nr:ka(dt,Rt,st)}M.range=le(F||(L?K0:_==A?M.distr==3?Z0:M.distr==4?J0:Bp:M.distr==3?zp:M.distr==4?Hp:j0)),M.auto=le(q?!1:M.auto),M.clamp=le(M.clamp||N0),M._min=M._max=null,M.valToPct=w(M)}}}S("x"),S("y"),s==1&&y.forEach(_=>{S(_.scale)}),T.forEach(_=>{S(_.scale)});for(let _ in n.scales)S(_);const C=x[A],G=C.distr;let N,V;C.ori==0?(Xn(c,l_),N=r,V=o):(Xn(c,c_),N=o,V=r);const j={};for(let _ in x){let M=x[_];(M.min!=null||M.max!=null)&&(j[_]={min:M.min,max:M.max},M.min=M.max=null)}const K=n.tzDate||(_=>new Date(en(_/p))),Q=n.fmtDate||Iu,tt=p==1?l0(K):h0(K),ht=af(K,of(p==1?a0:u0,Q)),ct=cf(K,lf(d0,Q)),mt=[],Mt=i.legend=je({},g0,n.legend),pt=i.cursor=je({},y0,{drag:{y:s==2}},n.cursor),it=Mt.show,at=pt.show,gt=Mt.markers;Mt.idxs=mt,gt.width=le(gt.width),gt.dash=le(gt.dash),gt.stroke=le(gt.stroke),gt.fill=le(gt.fill);let ot,Bt,Gt,It=[],he=[],Jt,fe=!1,z={};if(Mt.live){const _=y[1]?y[1].values:null;fe=_!=null,Jt=fe?_(i,1,0):{_:0};for(let M in Jt)z[M]=Ru}if(it)if(ot=mi("table",x_,c),Gt=mi("tbody",null,ot),Mt.mount(i,ot),fe){Bt=mi("thead",null,ot,Gt);let _=mi("tr",null,Bt);mi("th",null,_);for(var Qe in Jt)mi("th",Fh,_).textContent=Qe}else Xn(ot,S_),Mt.live&&Xn(ot,M_);const te={show:!0},ne={show:!1};function Vt(_,M){if(M==0&&(fe||!Mt.live||s==2))return Nr;let R=[],L=mi("tr",y_,Gt,Gt.childNodes[M]);Xn(L,_.class),_.show||Xn(L,Fs);let F=mi("th",null,L);if(gt.show){let lt=ni(E_,F);if(M>0){let dt=gt.width(i,M);dt&&(lt.style.border=dt+"px "+gt.dash(i,M)+" "+gt.stroke(i,M)),lt.style.background=gt.fill(i,M)}}let q=ni(Fh,F);_.label instanceof HTMLElement?q.appendChild(_.label):q.textContent=_.label,M>0&&(gt.show||(q.style.color=_.width>0?gt.stroke(i,M):gt.fill(i,M)),Pt("click",F,lt=>{if(pt._lock)return;tn(lt);let dt=y.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Rt=y.some((Ct,Lt)=>Lt>0&&Lt!=dt&&Ct.show);y.forEach((Ct,Lt)=>{Lt>0&&bi(Lt,Rt?Lt==dt?te:ne:te,!0,Ye.setSeries)})}else bi(dt,{show:!_.show},!0,Ye.setSeries)},!1),Bi&&Pt(zh,F,lt=>{pt._lock||(tn(lt),bi(y.indexOf(_),rr,!0,Ye.setSeries))},!1));for(var st in Jt){let lt=mi("td",b_,L);lt.textContent="--",R.push(lt)}return[L,R]}const me=new Map;function Pt(_,M,R,L=!0){const F=me.get(M)||{},q=pt.bind[_](i,M,R,L);q&&(Hs(_,M,F[_]=q),me.set(M,F))}function P(_,M,R){const L=me.get(M)||{};for(let F in L)(_==null||F==_)&&(xc(F,M,L[F]),delete L[F]);_==null&&me.delete(M)}let E=0,Y=0,J=0,W=0,et=0,St=0,_t=et,wt=St,Zt=J,ft=W,vt=0,Nt=0,Ot=0,Et=0;i.bbox={};let se=!1,Yt=!1,ge=!1,k=!1,xt=!1,nt=!1;function rt(_,M,R){(R||_!=i.width||M!=i.height)&&Tt(_,M),Js(!1),ge=!0,Yt=!0,Qs()}function Tt(_,M){i.width=E=J=_,i.height=Y=W=M,et=St=0,cn(),Se();let R=i.bbox;vt=R.left=Ds(et*Ee,.5),Nt=R.top=Ds(St*Ee,.5),Ot=R.width=Ds(J*Ee,.5),Et=R.height=Ds(W*Ee,.5)}const At=3;function Qt(){let _=!1,M=0;for(;!_;){M++;let R=Nm(M),L=Fm(M);_=M==At||R&&L,_||(Tt(i.width,i.height),Yt=!0)}}function ze({width:_,height:M}){rt(_,M)}i.setSize=ze;function cn(){let _=!1,M=!1,R=!1,L=!1;T.forEach((F,q)=>{if(F.show&&F._show){let{side:st,_size:lt}=F,dt=st%2,Rt=F.label!=null?F.labelSize:0,Ct=lt+Rt;Ct>0&&(dt?(J-=Ct,st==3?(et+=Ct,L=!0):R=!0):(W-=Ct,st==0?(St+=Ct,_=!0):M=!0))}}),Si[0]=_,Si[1]=R,Si[2]=M,Si[3]=L,J-=b[1]+b[3],et+=b[3],W-=b[2]+b[0],St+=b[0]}function Se(){let _=et+J,M=St+W,R=et,L=St;function F(q,st){switch(q){case 1:return _+=st,_-st;case 2:return M+=st,M-st;case 3:return R-=st,R+st;case 0:return L-=st,L+st}}T.forEach((q,st)=>{if(q.show&&q._show){let lt=q.side;q._pos=F(lt,q._size),q.label!=null&&(q._lpos=F(lt,q.labelSize))}})}if(pt.dataIdx==null){let _=pt.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let R=_.prox=le(_.prox),L=_.bias??=0;pt.dataIdx=(F,q,st,lt)=>{if(q==0)return st;let dt=st,Rt=R(F,q,st,lt)??Le,Ct=Rt>=0&&Rt<Le,Lt=C.ori==0?J:W,Kt=pt.left,ye=t[0],xe=t[q];if(M.has(xe[st])){dt=null;let oe=null,$t=null,Ht;if(L==0||L==-1)for(Ht=st;oe==null&&Ht-- >0;)M.has(xe[Ht])||(oe=Ht);if(L==0||L==1)for(Ht=st;$t==null&&Ht++<xe.length;)M.has(xe[Ht])||($t=Ht);if(oe!=null||$t!=null)if(Ct){let Oe=oe==null?-1/0:N(ye[oe],C,Lt,0),$e=$t==null?1/0:N(ye[$t],C,Lt,0),pn=Kt-Oe,Re=$e-Kt;pn<=Re?pn<=Rt&&(dt=oe):Re<=Rt&&(dt=$t)}else dt=$t==null?oe:oe==null?$t:st-oe<=$t-st?oe:$t}else Ct&&nn(Kt-N(ye[st],C,Lt,0))>Rt&&(dt=null);return dt}}const tn=_=>{pt.event=_};pt.idxs=mt,pt._lock=!1;let Ue=pt.points;Ue.show=le(Ue.show),Ue.size=le(Ue.size),Ue.stroke=le(Ue.stroke),Ue.width=le(Ue.width),Ue.fill=le(Ue.fill);const zn=i.focus=je({},n.focus||{alpha:.3},pt.focus),Bi=zn.prox>=0,In=Bi&&Ue.one;let vn=[],zi=[],Hi=[];function Ms(_,M){let R=Ue.show(i,M);if(R instanceof HTMLElement)return Xn(R,v_),Xn(R,_.class),Ri(R,-10,-10,J,W),g.insertBefore(R,vn[M]),R}function to(_,M){if(s==1||M>0){let R=s==1&&x[_.scale].time,L=_.value;_.value=R?ef(L)?cf(K,lf(L,Q)):L||ct:L||D0,_.label=_.label||(R?b0:E0)}if(In||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||X0||F_,_.fillTo=le(_.fillTo||O0),_.pxAlign=+Me(_.pxAlign,v),_.pxRound=vf(_.pxAlign),_.stroke=le(_.stroke||null),_.fill=le(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=U0(Un(1,_.width),1),L=_.points=je({},{size:R,width:Un(1,R*.2),stroke:_.stroke,space:R*2,paths:q0,_stroke:null,_fill:null},_.points);L.show=le(L.show),L.filter=le(L.filter),L.fill=le(L.fill),L.stroke=le(L.stroke),L.paths=le(L.paths),L.pxAlign=_.pxAlign}if(it){let R=Vt(_,M);It.splice(M,0,R[0]),he.splice(M,0,R[1]),Mt.values.push(null)}if(at){mt.splice(M,0,null);let R=null;In?M==0&&(R=Ms(_,M)):M>0&&(R=Ms(_,M)),vn.splice(M,0,R),zi.splice(M,0,0),Hi.splice(M,0,0)}dn("addSeries",M)}function js(_,M){M=M??y.length,_=s==1?wc(_,M,hf,gf):wc(_,M,{},mf),y.splice(M,0,_),to(y[M],M)}i.addSeries=js;function Io(_){if(y.splice(_,1),it){Mt.values.splice(_,1),he.splice(_,1);let M=It.splice(_,1)[0];P(null,M.firstChild),M.remove()}at&&(mt.splice(_,1),vn.splice(_,1)[0].remove(),zi.splice(_,1),Hi.splice(_,1)),dn("delSeries",_)}i.delSeries=Io;const Si=[!1,!1,!1,!1];function ll(_,M){if(_._show=_.show,_.show){let R=_.side%2,L=x[_.scale];L==null&&(_.scale=R?y[1].scale:A,L=x[_.scale]);let F=L.time;_.size=le(_.size),_.space=le(_.space),_.rotate=le(_.rotate),ds(_.incrs)&&_.incrs.forEach(st=>{!_s.has(st)&&_s.set(st,up(st))}),_.incrs=le(_.incrs||(L.distr==2?s0:F?p==1?o0:c0:Us)),_.splits=le(_.splits||(F&&L.distr==1?tt:L.distr==3?Sc:L.distr==4?A0:T0)),_.stroke=le(_.stroke),_.grid.stroke=le(_.grid.stroke),_.ticks.stroke=le(_.ticks.stroke),_.border.stroke=le(_.border.stroke);let q=_.values;_.values=ds(q)&&!ds(q[0])?le(q):F?ds(q)?af(K,of(q,Q)):ef(q)?f0(K,q):q||ht:q||w0,_.filter=le(_.filter||(L.distr>=3&&L.log==10?P0:L.distr==3&&L.log==2?L0:lp)),_.font=yf(_.font),_.labelFont=yf(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Si[M]=!0,_._el=ni(p_,f))}}function Ss(_,M,R,L){let[F,q,st,lt]=R,dt=M%2,Rt=0;return dt==0&&(lt||q)&&(Rt=M==0&&!F||M==2&&!st?en(uf.size/3):0),dt==1&&(F||st)&&(Rt=M==1&&!q||M==3&&!lt?en(df.size/2):0),Rt}const No=i.padding=(n.padding||[Ss,Ss,Ss,Ss]).map(_=>le(Me(_,Ss))),b=i._padding=No.map((_,M)=>_(i,M,Si,0));let O,$=null,X=null;const H=s==1?y[0].idxs:null;let ut=null,yt=!1;function Ft(_,M){if(t=_??[],i.data=i._data=t,s==2){O=0;for(let R=1;R<y.length;R++)O+=t[R][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ut=t[0],O=ut.length;let R=t;if(G==2){R=t.slice();let L=R[0]=Array(O);for(let F=0;F<O;F++)L[F]=F}i._data=t=R}if(Js(!0),dn("setData"),G==2&&(ge=!0),M!==!1){let R=C;R.auto(i,yt)?Dt():ss(A,R.min,R.max),k=k||pt.left>=0,nt=!0,Qs()}}i.setData=Ft;function Dt(){yt=!0;let _,M;s==1&&(O>0?($=H[0]=0,X=H[1]=O-1,_=t[0][$],M=t[0][X],G==2?(_=$,M=X):_==M&&(G==3?[_,M]=ja(_,_,C.log,!1):G==4?[_,M]=Pu(_,_,C.log,!1):C.time?M=_+en(86400/p):[_,M]=ka(_,M,Lu,!0))):($=H[0]=_=null,X=H[1]=M=null)),ss(A,_,M)}let Wt,qt,Ut,ae,be,Ae,un,de,kt,He;function _e(_,M,R,L,F,q){_??=kh,R??=Uu,L??="butt",F??=kh,q??="round",_!=Wt&&(h.strokeStyle=Wt=_),F!=qt&&(h.fillStyle=qt=F),M!=Ut&&(h.lineWidth=Ut=M),q!=be&&(h.lineJoin=be=q),L!=Ae&&(h.lineCap=Ae=L),R!=ae&&h.setLineDash(ae=R)}function Nn(_,M,R,L){M!=qt&&(h.fillStyle=qt=M),_!=un&&(h.font=un=_),R!=de&&(h.textAlign=de=R),L!=kt&&(h.textBaseline=kt=L)}function yi(_,M,R,L,F=0){if(L.length>0&&_.auto(i,yt)&&(M==null||M.min==null)){let q=Me($,0),st=Me(X,L.length-1),lt=R.min==null?P_(L,q,st,F,_.distr==3):[R.min,R.max];_.min=_i(_.min,R.min=lt[0]),_.max=Un(_.max,R.max=lt[1])}}const xn={min:null,max:null};function ys(){for(let L in x){let F=x[L];j[L]==null&&(F.min==null||j[A]!=null&&F.auto(i,yt))&&(j[L]=xn)}for(let L in x){let F=x[L];j[L]==null&&F.from!=null&&j[F.from]!=null&&(j[L]=xn)}j[A]!=null&&Js(!0);let _={};for(let L in j){let F=j[L];if(F!=null){let q=_[L]=Fr(x[L],B_);if(F.min!=null)je(q,F);else if(L!=A||s==2)if(O==0&&q.from==null){let st=q.range(i,null,null,L);q.min=st[0],q.max=st[1]}else q.min=Le,q.max=-Le}}if(O>0){y.forEach((L,F)=>{if(s==1){let q=L.scale,st=j[q];if(st==null)return;let lt=_[q];if(F==0){let dt=lt.range(i,lt.min,lt.max,q);lt.min=dt[0],lt.max=dt[1],$=gi(lt.min,t[0]),X=gi(lt.max,t[0]),X-$>1&&(t[0][$]<lt.min&&$++,t[0][X]>lt.max&&X--),L.min=ut[$],L.max=ut[X]}else L.show&&L.auto&&yi(lt,st,L,t[F],L.sorted);L.idxs[0]=$,L.idxs[1]=X}else if(F>0&&L.show&&L.auto){let[q,st]=L.facets,lt=q.scale,dt=st.scale,[Rt,Ct]=t[F],Lt=_[lt],Kt=_[dt];Lt!=null&&yi(Lt,j[lt],q,Rt,q.sorted),Kt!=null&&yi(Kt,j[dt],st,Ct,st.sorted),L.min=st.min,L.max=st.max}});for(let L in _){let F=_[L],q=j[L];if(F.from==null&&(q==null||q.min==null)){let st=F.range(i,F.min==Le?null:F.min,F.max==-Le?null:F.max,L);F.min=st[0],F.max=st[1]}}}for(let L in _){let F=_[L];if(F.from!=null){let q=_[F.from];if(q.min==null)F.min=F.max=null;else{let st=F.range(i,q.min,q.max,L);F.min=st[0],F.max=st[1]}}}let M={},R=!1;for(let L in _){let F=_[L],q=x[L];if(q.min!=F.min||q.max!=F.max){q.min=F.min,q.max=F.max;let st=q.distr;q._min=st==3?Zi(q.min):st==4?wl(q.min,q.asinh):st==100?q.fwd(q.min):q.min,q._max=st==3?Zi(q.max):st==4?wl(q.max,q.asinh):st==100?q.fwd(q.max):q.max,M[L]=R=!0}}if(R){y.forEach((L,F)=>{s==2?F>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)ge=!0,dn("setScale",L);at&&pt.left>=0&&(k=nt=!0)}for(let L in j)j[L]=null}function Pe(_){let M=Mc($-1,0,O-1),R=Mc(X+1,0,O-1);for(;_[M]==null&&M>0;)M--;for(;_[R]==null&&R<O-1;)R++;return[M,R]}function Jn(){if(O>0){let _=y.some(M=>M._focus)&&He!=zn.alpha;_&&(h.globalAlpha=He=zn.alpha),y.forEach((M,R)=>{if(R>0&&M.show&&(ns(R,!1),ns(R,!0),M._paths==null)){let L=He;He!=M.alpha&&(h.globalAlpha=He=M.alpha);let F=s==2?[0,t[R][0].length-1]:Pe(t[R]);M._paths=M.paths(i,R,F[0],F[1]),He!=L&&(h.globalAlpha=He=L)}}),y.forEach((M,R)=>{if(R>0&&M.show){let L=He;He!=M.alpha&&(h.globalAlpha=He=M.alpha),M._paths!=null&&wn(R,!1);{let F=M._paths!=null?M._paths.gaps:null,q=M.points.show(i,R,$,X,F),st=M.points.filter(i,R,q,F);(q||st)&&(M.points._paths=M.points.paths(i,R,$,X,st),wn(R,!0))}He!=L&&(h.globalAlpha=He=L),dn("drawSeries",R)}}),_&&(h.globalAlpha=He=1)}}function ns(_,M){let R=M?y[_].points:y[_];R._stroke=R.stroke(i,_),R._fill=R.fill(i,_)}function wn(_,M){let R=M?y[_].points:y[_],{stroke:L,fill:F,clip:q,flags:st,_stroke:lt=R._stroke,_fill:dt=R._fill,_width:Rt=R.width}=R._paths;Rt=De(Rt*Ee,3);let Ct=null,Lt=Rt%2/2;M&&dt==null&&(dt=Rt>0?"#fff":lt);let Kt=R.pxAlign==1&&Lt>0;if(Kt&&h.translate(Lt,Lt),!M){let ye=vt-Rt/2,xe=Nt-Rt/2,oe=Ot+Rt,$t=Et+Rt;Ct=new Path2D,Ct.rect(ye,xe,oe,$t)}M?Zs(lt,Rt,R.dash,R.cap,dt,L,F,st,q):Ei(_,lt,Rt,R.dash,R.cap,dt,L,F,st,Ct,q),Kt&&h.translate(-Lt,-Lt)}function Ei(_,M,R,L,F,q,st,lt,dt,Rt,Ct){let Lt=!1;dt!=0&&I.forEach((Kt,ye)=>{if(Kt.series[0]==_){let xe=y[Kt.series[1]],oe=t[Kt.series[1]],$t=(xe._paths||So).band;ds($t)&&($t=Kt.dir==1?$t[0]:$t[1]);let Ht,Oe=null;xe.show&&$t&&D_(oe,$,X)?(Oe=Kt.fill(i,ye)||q,Ht=xe._paths.clip):$t=null,Zs(M,R,L,F,Oe,st,lt,dt,Rt,Ct,Ht,$t),Lt=!0}}),Lt||Zs(M,R,L,F,q,st,lt,dt,Rt,Ct)}const ci=Or|Ec;function Zs(_,M,R,L,F,q,st,lt,dt,Rt,Ct,Lt){_e(_,M,R,L,F),(dt||Rt||Lt)&&(h.save(),dt&&h.clip(dt),Rt&&h.clip(Rt)),Lt?(lt&ci)==ci?(h.clip(Lt),Ct&&h.clip(Ct),Oo(F,st),Fo(_,q,M)):lt&Ec?(Oo(F,st),h.clip(Lt),Fo(_,q,M)):lt&Or&&(h.save(),h.clip(Lt),Ct&&h.clip(Ct),Oo(F,st),h.restore(),Fo(_,q,M)):(Oo(F,st),Fo(_,q,M)),(dt||Rt||Lt)&&h.restore()}function Fo(_,M,R){R>0&&(M instanceof Map?M.forEach((L,F)=>{h.strokeStyle=Wt=F,h.stroke(L)}):M!=null&&_&&h.stroke(M))}function Oo(_,M){M instanceof Map?M.forEach((R,L)=>{h.fillStyle=qt=L,h.fill(R)}):M!=null&&_&&h.fill(M)}function Im(_,M,R,L){let F=T[_],q;if(L<=0)q=[0,0];else{let st=F._space=F.space(i,_,M,R,L),lt=F._incrs=F.incrs(i,_,M,R,L,st);q=Q0(M,R,lt,L,st)}return F._found=q}function cl(_,M,R,L,F,q,st,lt,dt,Rt){let Ct=st%2/2;v==1&&h.translate(Ct,Ct),_e(lt,st,dt,Rt,lt),h.beginPath();let Lt,Kt,ye,xe,oe=F+(L==0||L==3?-q:q);R==0?(Kt=F,xe=oe):(Lt=F,ye=oe);for(let $t=0;$t<_.length;$t++)M[$t]!=null&&(R==0?Lt=ye=_[$t]:Kt=xe=_[$t],h.moveTo(Lt,Kt),h.lineTo(ye,xe));h.stroke(),v==1&&h.translate(-Ct,-Ct)}function Nm(_){let M=!0;return T.forEach((R,L)=>{if(!R.show)return;let F=x[R.scale];if(F.min==null){R._show&&(M=!1,R._show=!1,Js(!1));return}else R._show||(M=!1,R._show=!0,Js(!1));let q=R.side,st=q%2,{min:lt,max:dt}=F,[Rt,Ct]=Im(L,lt,dt,st==0?J:W);if(Ct==0)return;let Lt=F.distr==2,Kt=R._splits=R.splits(i,L,lt,dt,Rt,Ct,Lt),ye=F.distr==2?Kt.map(Ht=>ut[Ht]):Kt,xe=F.distr==2?ut[Kt[1]]-ut[Kt[0]]:Rt,oe=R._values=R.values(i,R.filter(i,ye,L,Ct,xe),L,Ct,xe);R._rotate=q==2?R.rotate(i,oe,L,Ct):0;let $t=R._size;R._size=si(R.size(i,oe,L,_)),$t!=null&&R._size!=$t&&(M=!1)}),M}function Fm(_){let M=!0;return No.forEach((R,L)=>{let F=R(i,L,Si,_);F!=b[L]&&(M=!1),b[L]=F}),M}function Om(){for(let _=0;_<T.length;_++){let M=T[_];if(!M.show||!M._show)continue;let R=M.side,L=R%2,F,q,st=M.stroke(i,_),lt=R==0||R==3?-1:1,[dt,Rt]=M._found;if(M.label!=null){let An=M.labelGap*lt,Vn=en((M._lpos+An)*Ee);Nn(M.labelFont[0],st,"center",R==2?oo:Oh),h.save(),L==1?(F=q=0,h.translate(Vn,en(Nt+Et/2)),h.rotate((R==3?-wa:wa)/2)):(F=en(vt+Ot/2),q=Vn);let ws=op(M.label)?M.label(i,_,dt,Rt):M.label;h.fillText(ws,F,q),h.restore()}if(Rt==0)continue;let Ct=x[M.scale],Lt=L==0?Ot:Et,Kt=L==0?vt:Nt,ye=M._splits,xe=Ct.distr==2?ye.map(An=>ut[An]):ye,oe=Ct.distr==2?ut[ye[1]]-ut[ye[0]]:dt,$t=M.ticks,Ht=M.border,Oe=$t.show?$t.size:0,$e=en(Oe*Ee),pn=en((M.alignTo==2?M._size-Oe-M.gap:M.gap)*Ee),Re=M._rotate*-wa/180,Xe=m(M._pos*Ee),Hn=($e+pn)*lt,Tn=Xe+Hn;q=L==0?Tn:0,F=L==1?Tn:0;let Qn=M.font[0],ui=M.align==1?ar:M.align==2?yl:Re>0?ar:Re<0?yl:L==0?"center":R==3?yl:ar,Ti=Re||L==1?"middle":R==2?oo:Oh;Nn(Qn,st,ui,Ti);let Gn=M.font[1]*M.lineGap,ti=ye.map(An=>m(a(An,Ct,Lt,Kt))),hi=M._values;for(let An=0;An<hi.length;An++){let Vn=hi[An];if(Vn!=null){L==0?F=ti[An]:q=ti[An],Vn=""+Vn;let ws=Vn.indexOf(`
`)==-1?[Vn]:Vn.split(/\n/gm);for(let Rn=0;Rn<ws.length;Rn++){let yh=ws[Rn];Re?(h.save(),h.translate(F,q+Rn*Gn),h.rotate(Re),h.fillText(yh,0,0),h.restore()):h.fillText(yh,F,q+Rn*Gn)}}}$t.show&&cl(ti,$t.filter(i,xe,_,Rt,oe),L,R,Xe,$e,De($t.width*Ee,3),$t.stroke(i,_),$t.dash,$t.cap);let Ai=M.grid;Ai.show&&cl(ti,Ai.filter(i,xe,_,Rt,oe),L,L==0?2:1,L==0?Nt:vt,L==0?Et:Ot,De(Ai.width*Ee,3),Ai.stroke(i,_),Ai.dash,Ai.cap),Ht.show&&cl([Xe],[1],L==0?1:0,L==0?1:2,L==1?Nt:vt,L==1?Et:Ot,De(Ht.width*Ee,3),Ht.stroke(i,_),Ht.dash,Ht.cap)}dn("drawAxes")}function Js(_){y.forEach((M,R)=>{R>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let ko=!1,ul=!1,eo=[];function km(){ul=!1;for(let _=0;_<eo.length;_++)dn(...eo[_]);eo.length=0}function Qs(){ko||(X_(sh),ko=!0)}function Bm(_,M=!1){ko=!0,ul=M,_(i),sh(),M&&eo.length>0&&queueMicrotask(km)}i.batch=Bm;function sh(){if(se&&(ys(),se=!1),ge&&(Qt(),ge=!1),Yt){if(ke(d,ar,et),ke(d,oo,St),ke(d,mo,J),ke(d,go,W),ke(g,ar,et),ke(g,oo,St),ke(g,mo,J),ke(g,go,W),ke(f,mo,E),ke(f,go,Y),u.width=en(E*Ee),u.height=en(Y*Ee),T.forEach(({_el:_,_show:M,_size:R,_pos:L,side:F})=>{if(_!=null)if(M){let q=F===3||F===0?R:0,st=F%2==1;ke(_,st?"left":"top",L-q),ke(_,st?"width":"height",R),ke(_,st?"top":"left",st?St:et),ke(_,st?"height":"width",st?W:J),vc(_,Fs)}else Xn(_,Fs)}),Wt=qt=Ut=be=Ae=un=de=kt=ae=null,He=1,so(!0),et!=_t||St!=wt||J!=Zt||W!=ft){Js(!1);let _=J/Zt,M=W/ft;if(at&&!k&&pt.left>=0){pt.left*=_,pt.top*=M,tr&&Ri(tr,en(pt.left),0,J,W),er&&Ri(er,0,en(pt.top),J,W);for(let R=0;R<vn.length;R++){let L=vn[R];L!=null&&(zi[R]*=_,Hi[R]*=M,Ri(L,si(zi[R]),si(Hi[R]),J,W))}}if(Fe.show&&!xt&&Fe.left>=0&&Fe.width>0){Fe.left*=_,Fe.width*=_,Fe.top*=M,Fe.height*=M;for(let R in gl)ke(sr,R,Fe[R])}_t=et,wt=St,Zt=J,ft=W}dn("setSize"),Yt=!1}E>0&&Y>0&&(h.clearRect(0,0,u.width,u.height),dn("drawClear"),U.forEach(_=>_()),dn("draw")),Fe.show&&xt&&(Bo(Fe),xt=!1),at&&k&&(bs(null,!0,!1),k=!1),Mt.show&&Mt.live&&nt&&(pl(),nt=!1),l||(l=!0,i.status=1,dn("ready")),yt=!1,ko=!1}i.redraw=(_,M)=>{ge=M||!1,_!==!1?ss(A,C.min,C.max):Qs()};function hl(_,M){let R=x[_];if(R.from==null){if(O==0){let L=R.range(i,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(O>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&R.distr==2&&O>0&&(M.min=gi(M.min,t[0]),M.max=gi(M.max,t[0]),M.min==M.max&&M.max++),j[_]=M,se=!0,Qs()}}i.setScale=hl;let fl,dl,tr,er,rh,oh,nr,ir,ah,lh,Ne,Ge,is=!1;const gn=pt.drag;let hn=gn.x,fn=gn.y;at&&(pt.x&&(fl=ni(g_,g)),pt.y&&(dl=ni(__,g)),C.ori==0?(tr=fl,er=dl):(tr=dl,er=fl),Ne=pt.left,Ge=pt.top);const Fe=i.select=je({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),sr=Fe.show?ni(m_,Fe.over?g:d):null;function Bo(_,M){if(Fe.show){for(let R in _)Fe[R]=_[R],R in gl&&ke(sr,R,_[R]);M!==!1&&dn("setSelect")}}i.setSelect=Bo;function zm(_){if(y[_].show)it&&vc(It[_],Fs);else if(it&&Xn(It[_],Fs),at){let R=In?vn[0]:vn[_];R!=null&&Ri(R,-10,-10,J,W)}}function ss(_,M,R){hl(_,{min:M,max:R})}function bi(_,M,R,L){M.focus!=null&&$m(_),M.show!=null&&y.forEach((F,q)=>{q>0&&(_==q||_==null)&&(F.show=M.show,zm(q),s==2?(ss(F.facets[0].scale,null,null),ss(F.facets[1].scale,null,null)):ss(F.scale,null,null),Qs())}),R!==!1&&dn("setSeries",_,M),L&&ro("setSeries",i,_,M)}i.setSeries=bi;function Hm(_,M){je(I[_],M)}function Gm(_,M){_.fill=le(_.fill||null),_.dir=Me(_.dir,-1),M=M??I.length,I.splice(M,0,_)}function Vm(_){_==null?I.length=0:I.splice(_,1)}i.addBand=Gm,i.setBand=Hm,i.delBand=Vm;function Wm(_,M){y[_].alpha=M,at&&vn[_]!=null&&(vn[_].style.opacity=M),it&&It[_]&&(It[_].style.opacity=M)}let Gi,rs,Es;const rr={focus:!0};function $m(_){if(_!=Es){let M=_==null,R=zn.alpha!=1;y.forEach((L,F)=>{if(s==1||F>0){let q=M||F==0||F==_;L._focus=M?null:q,R&&Wm(F,q?1:zn.alpha)}}),Es=_,R&&Qs()}}it&&Bi&&Pt(Hh,ot,_=>{pt._lock||(tn(_),Es!=null&&bi(null,rr,!0,Ye.setSeries))});function wi(_,M,R){let L=x[M];R&&(_=_/Ee-(L.ori==1?St:et));let F=J;L.ori==1&&(F=W,_=F-_),L.dir==-1&&(_=F-_);let q=L._min,st=L._max,lt=_/F,dt=q+(st-q)*lt,Rt=L.distr;return Rt==3?Ir(10,dt):Rt==4?I_(dt,L.asinh):Rt==100?L.bwd(dt):dt}function Xm(_,M){let R=wi(_,A,M);return gi(R,t[0],$,X)}i.valToIdx=_=>gi(_,t[0]),i.posToIdx=Xm,i.posToVal=wi,i.valToPos=(_,M,R)=>x[M].ori==0?r(_,x[M],R?Ot:J,R?vt:0):o(_,x[M],R?Et:W,R?Nt:0),i.setCursor=(_,M,R)=>{Ne=_.left,Ge=_.top,bs(null,M,R)};function ch(_,M){ke(sr,ar,Fe.left=_),ke(sr,mo,Fe.width=M)}function uh(_,M){ke(sr,oo,Fe.top=_),ke(sr,go,Fe.height=M)}let no=C.ori==0?ch:uh,io=C.ori==1?ch:uh;function qm(){if(it&&Mt.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&fe)continue;let M=Mt.values[_],R=0;for(let L in M)he[_][R++].firstChild.nodeValue=M[L]}}function pl(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{mt[L]=R}):k_(_.idx)||mt.fill(_.idx),Mt.idx=mt[0]),it&&Mt.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!fe)&&Ym(R,mt[R]);qm()}nt=!1,M!==!1&&dn("setLegend")}i.setLegend=pl;function Ym(_,M){let R=y[_],L=_==0&&G==2?ut:t[_],F;fe?F=R.values(i,_,M)??z:(F=R.value(i,M==null?null:L[M],_,M),F=F==null?z:{_:F}),Mt.values[_]=F}function bs(_,M,R){ah=Ne,lh=Ge,[Ne,Ge]=pt.move(i,Ne,Ge),pt.left=Ne,pt.top=Ge,at&&(tr&&Ri(tr,en(Ne),0,J,W),er&&Ri(er,0,en(Ge),J,W));let L,F=$>X;Gi=Le,rs=null;let q=C.ori==0?J:W,st=C.ori==1?J:W;if(Ne<0||O==0||F){L=pt.idx=null;for(let lt=0;lt<y.length;lt++){let dt=vn[lt];dt!=null&&Ri(dt,-10,-10,J,W)}Bi&&bi(null,rr,!0,_==null&&Ye.setSeries),Mt.live&&(mt.fill(L),nt=!0)}else{let lt,dt,Rt;s==1&&(lt=C.ori==0?Ne:Ge,dt=wi(lt,A),L=pt.idx=gi(dt,t[0],$,X),Rt=N(t[0][L],C,q,0));let Ct=-10,Lt=-10,Kt=0,ye=0,xe=!0,oe="",$t="";for(let Ht=s==2?1:0;Ht<y.length;Ht++){let Oe=y[Ht],$e=mt[Ht],pn=$e==null?null:s==1?t[Ht][$e]:t[Ht][1][$e],Re=pt.dataIdx(i,Ht,L,dt),Xe=Re==null?null:s==1?t[Ht][Re]:t[Ht][1][Re];if(nt=nt||Xe!=pn||Re!=$e,mt[Ht]=Re,Ht>0&&Oe.show){let Hn=Re==null?-10:Re==L?Rt:N(s==1?t[0][Re]:t[Ht][0][Re],C,q,0),Tn=Xe==null?-10:V(Xe,s==1?x[Oe.scale]:x[Oe.facets[1].scale],st,0);if(Bi&&Xe!=null){let Qn=C.ori==1?Ne:Ge,ui=nn(zn.dist(i,Ht,Re,Tn,Qn));if(ui<Gi){let Ti=zn.bias;if(Ti!=0){let Gn=wi(Qn,Oe.scale),ti=Xe>=0?1:-1,hi=Gn>=0?1:-1;hi==ti&&(hi==1?Ti==1?Xe>=Gn:Xe<=Gn:Ti==1?Xe<=Gn:Xe>=Gn)&&(Gi=ui,rs=Ht)}else Gi=ui,rs=Ht}}if(nt||In){let Qn,ui;C.ori==0?(Qn=Hn,ui=Tn):(Qn=Tn,ui=Hn);let Ti,Gn,ti,hi,Ai,An,Vn=!0,ws=Ue.bbox;if(ws!=null){Vn=!1;let Rn=ws(i,Ht);ti=Rn.left,hi=Rn.top,Ti=Rn.width,Gn=Rn.height}else ti=Qn,hi=ui,Ti=Gn=Ue.size(i,Ht);if(An=Ue.fill(i,Ht),Ai=Ue.stroke(i,Ht),In)Ht==rs&&Gi<=zn.prox&&(Ct=ti,Lt=hi,Kt=Ti,ye=Gn,xe=Vn,oe=An,$t=Ai);else{let Rn=vn[Ht];Rn!=null&&(zi[Ht]=ti,Hi[Ht]=hi,Yh(Rn,Ti,Gn,Vn),Xh(Rn,An,Ai),Ri(Rn,si(ti),si(hi),J,W))}}}}if(In){let Ht=zn.prox,Oe=Es==null?Gi<=Ht:Gi>Ht||rs!=Es;if(nt||Oe){let $e=vn[0];$e!=null&&(zi[0]=Ct,Hi[0]=Lt,Yh($e,Kt,ye,xe),Xh($e,oe,$t),Ri($e,si(Ct),si(Lt),J,W))}}}if(Fe.show&&is)if(_!=null){let[lt,dt]=Ye.scales,[Rt,Ct]=Ye.match,[Lt,Kt]=_.cursor.sync.scales,ye=_.cursor.drag;if(hn=ye._x,fn=ye._y,hn||fn){let{left:xe,top:oe,width:$t,height:Ht}=_.select,Oe=_.scales[Lt].ori,$e=_.posToVal,pn,Re,Xe,Hn,Tn,Qn=lt!=null&&Rt(lt,Lt),ui=dt!=null&&Ct(dt,Kt);Qn&&hn?(Oe==0?(pn=xe,Re=$t):(pn=oe,Re=Ht),Xe=x[lt],Hn=N($e(pn,Lt),Xe,q,0),Tn=N($e(pn+Re,Lt),Xe,q,0),no(_i(Hn,Tn),nn(Tn-Hn))):no(0,q),ui&&fn?(Oe==1?(pn=xe,Re=$t):(pn=oe,Re=Ht),Xe=x[dt],Hn=V($e(pn,Kt),Xe,st,0),Tn=V($e(pn+Re,Kt),Xe,st,0),io(_i(Hn,Tn),nn(Tn-Hn))):io(0,st)}else _l()}else{let lt=nn(ah-rh),dt=nn(lh-oh);if(C.ori==1){let Kt=lt;lt=dt,dt=Kt}hn=gn.x&&lt>=gn.dist,fn=gn.y&&dt>=gn.dist;let Rt=gn.uni;Rt!=null?hn&&fn&&(hn=lt>=Rt,fn=dt>=Rt,!hn&&!fn&&(dt>lt?fn=!0:hn=!0)):gn.x&&gn.y&&(hn||fn)&&(hn=fn=!0);let Ct,Lt;hn&&(C.ori==0?(Ct=nr,Lt=Ne):(Ct=ir,Lt=Ge),no(_i(Ct,Lt),nn(Lt-Ct)),fn||io(0,st)),fn&&(C.ori==1?(Ct=nr,Lt=Ne):(Ct=ir,Lt=Ge),io(_i(Ct,Lt),nn(Lt-Ct)),hn||no(0,q)),!hn&&!fn&&(no(0,0),io(0,0))}if(gn._x=hn,gn._y=fn,_==null){if(R){if(Sh!=null){let[lt,dt]=Ye.scales;Ye.values[0]=lt!=null?wi(C.ori==0?Ne:Ge,lt):null,Ye.values[1]=dt!=null?wi(C.ori==1?Ne:Ge,dt):null}ro(El,i,Ne,Ge,J,W,L)}if(Bi){let lt=R&&Ye.setSeries,dt=zn.prox;Es==null?Gi<=dt&&bi(rs,rr,!0,lt):Gi>dt?bi(null,rr,!0,lt):rs!=Es&&bi(rs,rr,!0,lt)}}nt&&(Mt.idx=L,pl()),M!==!1&&dn("setCursor")}let os=null;Object.defineProperty(i,"rect",{get(){return os==null&&so(!1),os}});function so(_=!1){_?os=null:(os=g.getBoundingClientRect(),dn("syncRect",os))}function hh(_,M,R,L,F,q,st){pt._lock||is&&_!=null&&_.movementX==0&&_.movementY==0||(ml(_,M,R,L,F,q,st,!1,_!=null),_!=null?bs(null,!0,!0):bs(M,!0,!1))}function ml(_,M,R,L,F,q,st,lt,dt){if(os==null&&so(!1),tn(_),_!=null)R=_.clientX-os.left,L=_.clientY-os.top;else{if(R<0||L<0){Ne=-10,Ge=-10;return}let[Rt,Ct]=Ye.scales,Lt=M.cursor.sync,[Kt,ye]=Lt.values,[xe,oe]=Lt.scales,[$t,Ht]=Ye.match,Oe=M.axes[0].side%2==1,$e=C.ori==0?J:W,pn=C.ori==1?J:W,Re=Oe?q:F,Xe=Oe?F:q,Hn=Oe?L:R,Tn=Oe?R:L;if(xe!=null?R=$t(Rt,xe)?a(Kt,x[Rt],$e,0):-10:R=$e*(Hn/Re),oe!=null?L=Ht(Ct,oe)?a(ye,x[Ct],pn,0):-10:L=pn*(Tn/Xe),C.ori==1){let Qn=R;R=L,L=Qn}}dt&&(M==null||M.cursor.event.type==El)&&((R<=1||R>=J-1)&&(R=Ds(R,J)),(L<=1||L>=W-1)&&(L=Ds(L,W))),lt?(rh=R,oh=L,[nr,ir]=pt.move(i,R,L)):(Ne=R,Ge=L)}const gl={width:0,height:0,left:0,top:0};function _l(){Bo(gl,!1)}let fh,dh,ph,mh;function gh(_,M,R,L,F,q,st){is=!0,hn=fn=gn._x=gn._y=!1,ml(_,M,R,L,F,q,st,!0,!1),_!=null&&(Pt(bl,gc,_h,!1),ro(Bh,i,nr,ir,J,W,null));let{left:lt,top:dt,width:Rt,height:Ct}=Fe;fh=lt,dh=dt,ph=Rt,mh=Ct}function _h(_,M,R,L,F,q,st){is=gn._x=gn._y=!1,ml(_,M,R,L,F,q,st,!1,!0);let{left:lt,top:dt,width:Rt,height:Ct}=Fe,Lt=Rt>0||Ct>0,Kt=fh!=lt||dh!=dt||ph!=Rt||mh!=Ct;if(Lt&&Kt&&Bo(Fe),gn.setScale&&Lt&&Kt){let ye=lt,xe=Rt,oe=dt,$t=Ct;if(C.ori==1&&(ye=dt,xe=Ct,oe=lt,$t=Rt),hn&&ss(A,wi(ye,A),wi(ye+xe,A)),fn)for(let Ht in x){let Oe=x[Ht];Ht!=A&&Oe.from==null&&Oe.min!=Le&&ss(Ht,wi(oe+$t,Ht),wi(oe,Ht))}_l()}else pt.lock&&(pt._lock=!pt._lock,bs(M,!0,_!=null));_!=null&&(P(bl,gc),ro(bl,i,Ne,Ge,J,W,null))}function Km(_,M,R,L,F,q,st){if(pt._lock)return;tn(_);let lt=is;if(is){let dt=!0,Rt=!0,Ct=10,Lt,Kt;C.ori==0?(Lt=hn,Kt=fn):(Lt=fn,Kt=hn),Lt&&Kt&&(dt=Ne<=Ct||Ne>=J-Ct,Rt=Ge<=Ct||Ge>=W-Ct),Lt&&dt&&(Ne=Ne<nr?0:J),Kt&&Rt&&(Ge=Ge<ir?0:W),bs(null,!0,!0),is=!1}Ne=-10,Ge=-10,mt.fill(null),bs(null,!0,!0),lt&&(is=lt)}function vh(_,M,R,L,F,q,st){pt._lock||(tn(_),Dt(),_l(),_!=null&&ro(Gh,i,Ne,Ge,J,W,null))}function xh(){T.forEach(tv),rt(i.width,i.height,!0)}Hs(Oa,Ar,xh);const or={};or.mousedown=gh,or.mousemove=hh,or.mouseup=_h,or.dblclick=vh,or.setSeries=(_,M,R,L)=>{let F=Ye.match[2];R=F(i,M,R),R!=-1&&bi(R,L,!0,!1)},at&&(Pt(Bh,g,gh),Pt(El,g,hh),Pt(zh,g,_=>{tn(_),so(!1)}),Pt(Hh,g,Km),Pt(Gh,g,vh),bc.add(i),i.syncRect=so);const zo=i.hooks=n.hooks||{};function dn(_,M,R){ul?eo.push([_,M,R]):_ in zo&&zo[_].forEach(L=>{L.call(null,i,M,R)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)zo[M]=(zo[M]||[]).concat(_.hooks[M])});const Mh=(_,M,R)=>R,Ye=je({key:null,setSeries:!1,filters:{pub:Qh,sub:Qh},scales:[A,y[1]?y[1].scale:null],match:[tf,tf,Mh],values:[null,null]},pt.sync);Ye.match.length==2&&Ye.match.push(Mh),pt.sync=Ye;const Sh=Ye.key,vl=Pp(Sh);function ro(_,M,R,L,F,q,st){Ye.filters.pub(_,M,R,L,F,q,st)&&vl.pub(_,M,R,L,F,q,st)}vl.sub(i);function jm(_,M,R,L,F,q,st){Ye.filters.sub(_,M,R,L,F,q,st)&&or[_](null,M,R,L,F,q,st)}i.pub=jm;function Zm(){vl.unsub(i),bc.delete(i),me.clear(),xc(Oa,Ar,xh),c.remove(),ot?.remove(),dn("destroy")}i.destroy=Zm;function xl(){dn("init",n,t),Ft(t||n.data,!1),j[A]?hl(A,j[A]):Dt(),xt=Fe.show&&(Fe.width>0||Fe.height>0),k=nt=!0,rt(n.width,n.height)}return y.forEach(to),T.forEach(ll),e?e instanceof HTMLElement?(e.appendChild(c),xl()):e(i,xl):xl(),i}bn.assign=je;bn.fmtNum=Du;bn.rangeNum=ka;bn.rangeLog=ja;bn.rangeAsinh=Pu;bn.orient=qs;bn.pxRatio=Ee;bn.join=$_;bn.fmtDate=Iu,bn.tzDate=n0;bn.sync=Pp;{bn.addGap=k0,bn.clipGaps=Qa;let n=bn.paths={points:Fp};n.linear=kp,n.stepped=H0,n.bars=G0,n.spline=W0}const Xo=n=>document.getElementById(n),ev=["#7cc4ff","#56d6b0","#d59bf6","#ffb652","#f2f5f8","#ff7a5c"],Gp=({curves:n},t)=>n[t].signal==="truth"&&n.some(e=>e.signal!=="truth")?"#f2f5f8":ev[t];function nv(n,t,e,i){const s={stroke:"#8fa1b3",grid:{stroke:"#1b2733",width:1},ticks:{stroke:"#1b2733"},font:`${.68*i}px system-ui`,size:2.3*i},r={stroke:"#ffb65290",width:1,dash:[4,4],points:{show:!1}};return{width:t,height:e,legend:{show:!1},cursor:{show:!1},padding:[i*(n.names.length?.95:.3),i*.4,0,0],hooks:{draw:[o=>sv(o,n,i)]},scales:{x:{time:!1},y:{range:(o,a,l)=>{if(!n.centred)return iv([a,l,...n.levels],n.least);const c=Math.max(Math.abs(a||0),Math.abs(l||0),n.least);return[-c*1.1,c*1.1]}}},axes:[{...s,size:1.5*i,gap:1},{...s,gap:1,space:1.2*i,label:n.title,labelSize:1.1*i,labelFont:`${.7*i}px system-ui`}],series:[{},...n.curves.map((o,a)=>({stroke:Gp(n,a),width:1.5,points:{show:!1}})),r,r]}}function iv(n,t){const e=n.filter(o=>Number.isFinite(o)),[i,s]=e.length?[Math.min(...e),Math.max(...e)]:[0,t],r=Math.max((s-i)*.06,(t-(s-i))/2);return[i-r,s+r]}function sv(n,t,e){const i=n.ctx,s=devicePixelRatio||1,{left:r,top:o,width:a}=n.bbox;i.save(),i.strokeStyle="#8aa4bd",i.lineWidth=s,i.setLineDash([3*s,3*s]);for(const c of t.levels){const u=n.valToPos(c,"y",!0);i.beginPath(),i.moveTo(r,u),i.lineTo(r+a,u),i.stroke()}i.font=`${.68*e*s}px system-ui`,i.textBaseline="bottom",i.textAlign="right";let l=r+a-.3*e*s;for(let c=t.names.length-1;c>=0;c-=1)i.fillStyle=Gp(t,c),i.fillText(t.names[c],l,o-.1*e*s),l-=i.measureText(t.names[c]).width+.7*e*s;i.restore()}class rv{constructor(t,e){Object.assign(this,{strip:t,window:e,element:document.createElement("div")})}size(){const t=parseFloat(getComputedStyle(document.documentElement).fontSize),e=this.element.parentElement.clientWidth;return{width:Math.max(e,60),height:6.4*t,rem:t}}show({t,curves:e,spread:i},s){const r=this.size();(!this.plot||this.width!==r.width)&&(this.plot&&this.plot.destroy(),this.plot=new bn(nv(this.strip,r.width,r.height,r.rem),[[],...e.map(()=>[]),[],[]],this.element),this.width=r.width);let o=t.length;if(s!==void 0)for(;o>0&&t[o-1]>s;)o-=1;let a=o;for(;a>0&&t[a-1]>(t[o-1]??0)-this.window;)a-=1;const l=u=>u.slice(a,o),c=l(i);this.plot.setData([l(t),...e.map(l),c,c.map(u=>u===null?null:-u)])}}class ov{setDisplay({charts:t}){Xo("strips").hidden=!t,this.note=t?.note,this.strips=(t?.strips||[]).map(e=>new rv(e,t.window_s)),Xo("charts").replaceChildren(...this.strips.map(e=>e.element)),Xo("charts-title").textContent=t?.title||""}show(t,e,i){this.strips.forEach((s,r)=>s.show(t[r],i)),this.note&&Ia(Yn(e,this.note)??["",!1],Xo("charts-note"),"dim")}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Hu="170",av=0,Ef=1,lv=2,Vp=1,cv=2,Yi=3,vs=0,On=1,Pi=2,ms=0,Rr=1,bf=2,wf=3,Tf=4,uv=5,Os=100,hv=101,fv=102,dv=103,pv=104,mv=200,gv=201,_v=202,vv=203,Tc=204,Ac=205,xv=206,Mv=207,Sv=208,yv=209,Ev=210,bv=211,wv=212,Tv=213,Av=214,Rc=0,Cc=1,Pc=2,kr=3,Lc=4,Dc=5,Uc=6,Ic=7,Gu=0,Rv=1,Cv=2,gs=0,Pv=1,Lv=2,Dv=3,Uv=4,Iv=5,Nv=6,Fv=7,Wp=300,Br=301,zr=302,Nc=303,Fc=304,il=306,Oc=1e3,Bs=1001,kc=1002,Mi=1003,Ov=1004,qo=1005,Ui=1006,Cl=1007,zs=1008,ts=1009,$p=1010,Xp=1011,wo=1012,Vu=1013,Vs=1014,Ki=1015,Co=1016,Wu=1017,$u=1018,Hr=1020,qp=35902,Yp=1021,Kp=1022,vi=1023,jp=1024,Zp=1025,Cr=1026,Gr=1027,Jp=1028,Xu=1029,Qp=1030,qu=1031,Yu=1033,Ta=33776,Aa=33777,Ra=33778,Ca=33779,Bc=35840,zc=35841,Hc=35842,Gc=35843,Vc=36196,Wc=37492,$c=37496,Xc=37808,qc=37809,Yc=37810,Kc=37811,jc=37812,Zc=37813,Jc=37814,Qc=37815,tu=37816,eu=37817,nu=37818,iu=37819,su=37820,ru=37821,Pa=36492,ou=36494,au=36495,tm=36283,lu=36284,cu=36285,uu=36286,kv=3200,Bv=3201,em=0,zv=1,ps="",ri="srgb",Ys="srgb-linear",sl="linear",Ce="srgb",lr=7680,Af=519,Hv=512,Gv=513,Vv=514,nm=515,Wv=516,$v=517,Xv=518,qv=519,Rf=35044,Cf="300 es",ji=2e3,za=2001;class Yr{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const i=this._listeners;return i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const i=this._listeners[t.type];if(i!==void 0){t.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const Mn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],La=Math.PI/180,hu=180/Math.PI;function Po(){const n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Mn[n&255]+Mn[n>>8&255]+Mn[n>>16&255]+Mn[n>>24&255]+"-"+Mn[t&255]+Mn[t>>8&255]+"-"+Mn[t>>16&15|64]+Mn[t>>24&255]+"-"+Mn[e&63|128]+Mn[e>>8&255]+"-"+Mn[e>>16&255]+Mn[e>>24&255]+Mn[i&255]+Mn[i>>8&255]+Mn[i>>16&255]+Mn[i>>24&255]).toLowerCase()}function Dn(n,t,e){return Math.max(t,Math.min(e,n))}function Yv(n,t){return(n%t+t)%t}function Pl(n,t,e){return(1-e)*n+e*t}function lo(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Fn(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}class ue{constructor(t=0,e=0){ue.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Dn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class ee{constructor(t,e,i,s,r,o,a,l,c){ee.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],g=i[8],v=s[0],m=s[3],p=s[6],y=s[1],T=s[4],x=s[7],I=s[2],A=s[5],D=s[8];return r[0]=o*v+a*y+l*I,r[3]=o*m+a*T+l*A,r[6]=o*p+a*x+l*D,r[1]=c*v+u*y+h*I,r[4]=c*m+u*T+h*A,r[7]=c*p+u*x+h*D,r[2]=f*v+d*y+g*I,r[5]=f*m+d*T+g*A,r[8]=f*p+d*x+g*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return t[0]=h*v,t[1]=(s*c-u*i)*v,t[2]=(a*i-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Ll.makeScale(t,e)),this}rotate(t){return this.premultiply(Ll.makeRotation(-t)),this}translate(t,e){return this.premultiply(Ll.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const Ll=new ee;function im(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Ha(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Kv(){const n=Ha("canvas");return n.style.display="block",n}const Pf={};function vo(n){n in Pf||(Pf[n]=!0,console.warn(n))}function jv(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}function Zv(n){const t=n.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function Jv(n){const t=n.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const ve={enabled:!0,workingColorSpace:Ys,spaces:{},convert:function(n,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ce&&(n.r=Qi(n.r),n.g=Qi(n.g),n.b=Qi(n.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(n.applyMatrix3(this.spaces[t].toXYZ),n.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ce&&(n.r=Pr(n.r),n.g=Pr(n.g),n.b=Pr(n.b))),n},fromWorkingColorSpace:function(n,t){return this.convert(n,this.workingColorSpace,t)},toWorkingColorSpace:function(n,t){return this.convert(n,t,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===ps?sl:this.spaces[n].transfer},getLuminanceCoefficients:function(n,t=this.workingColorSpace){return n.fromArray(this.spaces[t].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,t,e){return n.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}};function Qi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Pr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}const Lf=[.64,.33,.3,.6,.15,.06],Df=[.2126,.7152,.0722],Uf=[.3127,.329],If=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Nf=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ve.define({[Ys]:{primaries:Lf,whitePoint:Uf,transfer:sl,toXYZ:If,fromXYZ:Nf,luminanceCoefficients:Df,workingColorSpaceConfig:{unpackColorSpace:ri},outputColorSpaceConfig:{drawingBufferColorSpace:ri}},[ri]:{primaries:Lf,whitePoint:Uf,transfer:Ce,toXYZ:If,fromXYZ:Nf,luminanceCoefficients:Df,outputColorSpaceConfig:{drawingBufferColorSpace:ri}}});let cr;class Qv{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{cr===void 0&&(cr=Ha("canvas")),cr.width=t.width,cr.height=t.height;const i=cr.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),e=cr}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Ha("canvas");e.width=t.width,e.height=t.height;const i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);const s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Qi(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Qi(e[i]/255)*255):e[i]=Qi(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let tx=0;class sm{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:tx++}),this.uuid=Po(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Dl(s[o].image)):r.push(Dl(s[o]))}else r=Dl(s);i.url=r}return e||(t.images[this.uuid]=i),i}}function Dl(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Qv.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let ex=0;class kn extends Yr{constructor(t=kn.DEFAULT_IMAGE,e=kn.DEFAULT_MAPPING,i=Bs,s=Bs,r=Ui,o=zs,a=vi,l=ts,c=kn.DEFAULT_ANISOTROPY,u=ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ex++}),this.uuid=Po(),this.name="",this.source=new sm(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ue(0,0),this.repeat=new ue(1,1),this.center=new ue(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const i={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Wp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Oc:t.x=t.x-Math.floor(t.x);break;case Bs:t.x=t.x<0?0:1;break;case kc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Oc:t.y=t.y-Math.floor(t.y);break;case Bs:t.y=t.y<0?0:1;break;case kc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}kn.DEFAULT_IMAGE=null;kn.DEFAULT_MAPPING=Wp;kn.DEFAULT_ANISOTROPY=1;class Ve{constructor(t=0,e=0,i=0,s=1){Ve.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,x=(d+1)/2,I=(p+1)/2,A=(u+f)/4,D=(h+v)/4,U=(g+m)/4;return T>x&&T>I?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=D/i):x>I?x<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),i=A/s,r=U/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=D/r,s=U/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(h-v)/y,this.z=(f-u)/y,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class nx extends Yr{constructor(t=1,e=1,i={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new Ve(0,0,t,e),this.scissorTest=!1,this.viewport=new Ve(0,0,t,e);const s={width:t,height:e,depth:1};i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ui,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},i);const r=new kn(s,i.mapping,i.wrapS,i.wrapT,i.magFilter,i.minFilter,i.format,i.type,i.anisotropy,i.colorSpace);r.flipY=!1,r.generateMipmaps=i.generateMipmaps,r.internalFormat=i.internalFormat,this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.depthTexture=i.depthTexture,this.samples=i.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let i=0,s=t.textures.length;i<s;i++)this.textures[i]=t.textures[i].clone(),this.textures[i].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new sm(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Ws extends nx{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}}class rm extends kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Mi,this.minFilter=Mi,this.wrapR=Bs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class ix extends kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Mi,this.minFilter=Mi,this.wrapR=Bs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class es{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3];const f=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==f||c!==d||u!==g){let m=1-a;const p=l*f+c*d+u*g+h*v,y=p>=0?1:-1,T=1-p*p;if(T>Number.EPSILON){const I=Math.sqrt(T),A=Math.atan2(I,p*y);m=Math.sin(m*A)/I,a=Math.sin(a*A)/I}const x=a*y;if(l=l*m+f*x,c=c*m+d*x,u=u*m+g*x,h=h*m+v*x,m===1-a){const I=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=I,c*=I,u*=I,h*=I}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=i+a+h;if(f>0){const d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){const d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){const d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<Number.EPSILON?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Dn(this.dot(t),-1,1)))}rotateTowards(t,e){const i=this.angleTo(t);if(i===0)return this;const s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const d=1-e;return this._w=d*o+e*this._w,this._x=d*i+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class B{constructor(t=0,e=0,i=0){B.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Ff.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Ff.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ul.copy(this).projectOnVector(t),this.sub(Ul)}reflect(t){return this.sub(Ul.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Dn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){const s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Ul=new B,Ff=new es;class Kr{constructor(t=new B(1/0,1/0,1/0),e=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(fi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(fi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const i=fi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const i=t.geometry;if(i!==void 0){const r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,fi):fi.fromBufferAttribute(r,o),fi.applyMatrix4(t.matrixWorld),this.expandByPoint(fi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Yo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Yo.copy(i.boundingBox)),Yo.applyMatrix4(t.matrixWorld),this.union(Yo)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,fi),fi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(co),Ko.subVectors(this.max,co),ur.subVectors(t.a,co),hr.subVectors(t.b,co),fr.subVectors(t.c,co),as.subVectors(hr,ur),ls.subVectors(fr,hr),Ts.subVectors(ur,fr);let e=[0,-as.z,as.y,0,-ls.z,ls.y,0,-Ts.z,Ts.y,as.z,0,-as.x,ls.z,0,-ls.x,Ts.z,0,-Ts.x,-as.y,as.x,0,-ls.y,ls.x,0,-Ts.y,Ts.x,0];return!Il(e,ur,hr,fr,Ko)||(e=[1,0,0,0,1,0,0,0,1],!Il(e,ur,hr,fr,Ko))?!1:(jo.crossVectors(as,ls),e=[jo.x,jo.y,jo.z],Il(e,ur,hr,fr,Ko))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,fi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(fi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Vi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Vi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Vi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Vi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Vi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Vi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Vi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Vi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Vi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Vi=[new B,new B,new B,new B,new B,new B,new B,new B],fi=new B,Yo=new Kr,ur=new B,hr=new B,fr=new B,as=new B,ls=new B,Ts=new B,co=new B,Ko=new B,jo=new B,As=new B;function Il(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){As.fromArray(n,r);const a=s.x*Math.abs(As.x)+s.y*Math.abs(As.y)+s.z*Math.abs(As.z),l=t.dot(As),c=e.dot(As),u=i.dot(As);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const sx=new Kr,uo=new B,Nl=new B;class Lo{constructor(t=new B,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const i=this.center;e!==void 0?i.copy(e):sx.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;uo.subVectors(t,this.center);const e=uo.lengthSq();if(e>this.radius*this.radius){const i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(uo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Nl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(uo.copy(t.center).add(Nl)),this.expandByPoint(uo.copy(t.center).sub(Nl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Wi=new B,Fl=new B,Zo=new B,cs=new B,Ol=new B,Jo=new B,kl=new B;class Ku{constructor(t=new B,e=new B(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Wi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Wi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Wi.copy(this.origin).addScaledVector(this.direction,e),Wi.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Fl.copy(t).add(e).multiplyScalar(.5),Zo.copy(e).sub(t).normalize(),cs.copy(this.origin).sub(Fl);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Zo),a=cs.dot(this.direction),l=-cs.dot(Zo),c=cs.lengthSq(),u=Math.abs(1-o*o);let h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){const v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Fl).addScaledVector(Zo,f),d}intersectSphere(t,e){Wi.subVectors(t.center,this.origin);const i=Wi.dot(this.direction),s=Wi.dot(Wi)-i*i,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){const i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Wi)!==null}intersectTriangle(t,e,i,s,r){Ol.subVectors(e,t),Jo.subVectors(i,t),kl.crossVectors(Ol,Jo);let o=this.direction.dot(kl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;cs.subVectors(this.origin,t);const l=a*this.direction.dot(Jo.crossVectors(cs,Jo));if(l<0)return null;const c=a*this.direction.dot(Ol.cross(cs));if(c<0||l+c>o)return null;const u=-a*cs.dot(kl);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Ie{constructor(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){Ie.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m)}set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ie().fromArray(this.elements)}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){const e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,i=t.elements,s=1/dr.setFromMatrixColumn(t,0).length(),r=1/dr.setFromMatrixColumn(t,1).length(),o=1/dr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+g,e[10]=f-v*h}else if(t.order==="XZY"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(rx,t,ox)}lookAt(t,e,i){const s=this.elements;return Wn.subVectors(t,e),Wn.lengthSq()===0&&(Wn.z=1),Wn.normalize(),us.crossVectors(i,Wn),us.lengthSq()===0&&(Math.abs(i.z)===1?Wn.x+=1e-4:Wn.z+=1e-4,Wn.normalize(),us.crossVectors(i,Wn)),us.normalize(),Qo.crossVectors(Wn,us),s[0]=us.x,s[4]=Qo.x,s[8]=Wn.x,s[1]=us.y,s[5]=Qo.y,s[9]=Wn.y,s[2]=us.z,s[6]=Qo.z,s[10]=Wn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],g=i[2],v=i[6],m=i[10],p=i[14],y=i[3],T=i[7],x=i[11],I=i[15],A=s[0],D=s[4],U=s[8],w=s[12],S=s[1],C=s[5],G=s[9],N=s[13],V=s[2],j=s[6],K=s[10],Q=s[14],tt=s[3],ht=s[7],ct=s[11],mt=s[15];return r[0]=o*A+a*S+l*V+c*tt,r[4]=o*D+a*C+l*j+c*ht,r[8]=o*U+a*G+l*K+c*ct,r[12]=o*w+a*N+l*Q+c*mt,r[1]=u*A+h*S+f*V+d*tt,r[5]=u*D+h*C+f*j+d*ht,r[9]=u*U+h*G+f*K+d*ct,r[13]=u*w+h*N+f*Q+d*mt,r[2]=g*A+v*S+m*V+p*tt,r[6]=g*D+v*C+m*j+p*ht,r[10]=g*U+v*G+m*K+p*ct,r[14]=g*w+v*N+m*Q+p*mt,r[3]=y*A+T*S+x*V+I*tt,r[7]=y*D+T*C+x*j+I*ht,r[11]=y*U+T*G+x*K+I*ct,r[15]=y*w+T*N+x*Q+I*mt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*f+i*c*f+s*a*d-i*l*d)+v*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+e*c*h-e*a*d-r*o*h+i*o*d+r*a*u-i*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-i*o*f+i*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],y=h*m*c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,T=g*f*c-u*m*c-g*l*d+o*m*d+u*l*p-o*f*p,x=u*v*c-g*h*c+g*a*d-o*v*d-u*a*p+o*h*p,I=g*h*l-u*v*l-g*a*f+o*v*f+u*a*m-o*h*m,A=e*y+i*T+s*x+r*I;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/A;return t[0]=y*D,t[1]=(v*f*r-h*m*r-v*s*d+i*m*d+h*s*p-i*f*p)*D,t[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*p+i*l*p)*D,t[3]=(h*l*r-a*f*r-h*s*c+i*f*c+a*s*d-i*l*d)*D,t[4]=T*D,t[5]=(u*m*r-g*f*r+g*s*d-e*m*d-u*s*p+e*f*p)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*D,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*D,t[8]=x*D,t[9]=(g*h*r-u*v*r-g*i*d+e*v*d+u*i*p-e*h*p)*D,t[10]=(o*v*r-g*a*r+g*i*c-e*v*c-o*i*p+e*a*p)*D,t[11]=(u*a*r-o*h*r-u*i*c+e*h*c+o*i*d-e*a*d)*D,t[12]=I*D,t[13]=(u*v*s-g*h*s+g*i*f-e*v*f-u*i*m+e*h*m)*D,t[14]=(g*a*s-o*v*s-g*i*l+e*v*l+o*i*m-e*a*m)*D,t[15]=(o*h*s-u*a*s+u*i*l-e*h*l-o*i*f+e*a*f)*D,this}scale(t){const e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,v=o*u,m=o*h,p=a*h,y=l*c,T=l*u,x=l*h,I=i.x,A=i.y,D=i.z;return s[0]=(1-(v+p))*I,s[1]=(d+x)*I,s[2]=(g-T)*I,s[3]=0,s[4]=(d-x)*A,s[5]=(1-(f+p))*A,s[6]=(m+y)*A,s[7]=0,s[8]=(g+T)*D,s[9]=(m-y)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){const s=this.elements;let r=dr.set(s[0],s[1],s[2]).length();const o=dr.set(s[4],s[5],s[6]).length(),a=dr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],di.copy(this);const c=1/r,u=1/o,h=1/a;return di.elements[0]*=c,di.elements[1]*=c,di.elements[2]*=c,di.elements[4]*=u,di.elements[5]*=u,di.elements[6]*=u,di.elements[8]*=h,di.elements[9]*=h,di.elements[10]*=h,e.setFromRotationMatrix(di),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=ji){const l=this.elements,c=2*r/(e-t),u=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s);let d,g;if(a===ji)d=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===za)d=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=d,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=ji){const l=this.elements,c=1/(e-t),u=1/(i-s),h=1/(o-r),f=(e+t)*c,d=(i+s)*u;let g,v;if(a===ji)g=(o+r)*h,v=-2*h;else if(a===za)g=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-d,l[2]=0,l[6]=0,l[10]=v,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}}const dr=new B,di=new Ie,rx=new B(0,0,0),ox=new B(1,1,1),us=new B,Qo=new B,Wn=new B,Of=new Ie,kf=new es;class ki{constructor(t=0,e=0,i=0,s=ki.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(Dn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Dn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Dn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Dn(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Dn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-Dn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Of.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Of,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return kf.setFromEuler(this),this.setFromQuaternion(kf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}ki.DEFAULT_ORDER="XYZ";class om{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let ax=0;const Bf=new B,pr=new es,$i=new Ie,ta=new B,ho=new B,lx=new B,cx=new es,zf=new B(1,0,0),Hf=new B(0,1,0),Gf=new B(0,0,1),Vf={type:"added"},ux={type:"removed"},mr={type:"childadded",child:null},Bl={type:"childremoved",child:null};class sn extends Yr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ax++}),this.uuid=Po(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=sn.DEFAULT_UP.clone();const t=new B,e=new ki,i=new es,s=new B(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ie},normalMatrix:{value:new ee}}),this.matrix=new Ie,this.matrixWorld=new Ie,this.matrixAutoUpdate=sn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new om,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return pr.setFromAxisAngle(t,e),this.quaternion.multiply(pr),this}rotateOnWorldAxis(t,e){return pr.setFromAxisAngle(t,e),this.quaternion.premultiply(pr),this}rotateX(t){return this.rotateOnAxis(zf,t)}rotateY(t){return this.rotateOnAxis(Hf,t)}rotateZ(t){return this.rotateOnAxis(Gf,t)}translateOnAxis(t,e){return Bf.copy(t).applyQuaternion(this.quaternion),this.position.add(Bf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(zf,t)}translateY(t){return this.translateOnAxis(Hf,t)}translateZ(t){return this.translateOnAxis(Gf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4($i.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?ta.copy(t):ta.set(t,e,i);const s=this.parent;this.updateWorldMatrix(!0,!1),ho.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?$i.lookAt(ho,ta,this.up):$i.lookAt(ta,ho,this.up),this.quaternion.setFromRotationMatrix($i),s&&($i.extractRotation(s.matrixWorld),pr.setFromRotationMatrix($i),this.quaternion.premultiply(pr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Vf),mr.child=t,this.dispatchEvent(mr),mr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(ux),Bl.child=t,this.dispatchEvent(Bl),Bl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),$i.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),$i.multiply(t.parent.matrixWorld)),t.applyMatrix4($i),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Vf),mr.child=t,this.dispatchEvent(mr),mr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ho,t,lx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ho,cx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){const i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){const s=t.children[i];this.add(s.clone())}return this}}sn.DEFAULT_UP=new B(0,1,0);sn.DEFAULT_MATRIX_AUTO_UPDATE=!0;sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const pi=new B,Xi=new B,zl=new B,qi=new B,gr=new B,_r=new B,Wf=new B,Hl=new B,Gl=new B,Vl=new B,Wl=new Ve,$l=new Ve,Xl=new Ve;class oi{constructor(t=new B,e=new B,i=new B){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),pi.subVectors(t,e),s.cross(pi);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){pi.subVectors(s,e),Xi.subVectors(i,e),zl.subVectors(t,e);const o=pi.dot(pi),a=pi.dot(Xi),l=pi.dot(zl),c=Xi.dot(Xi),u=Xi.dot(zl),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,qi)===null?!1:qi.x>=0&&qi.y>=0&&qi.x+qi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,qi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,qi.x),l.addScaledVector(o,qi.y),l.addScaledVector(a,qi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Wl.setScalar(0),$l.setScalar(0),Xl.setScalar(0),Wl.fromBufferAttribute(t,e),$l.fromBufferAttribute(t,i),Xl.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Wl,r.x),o.addScaledVector($l,r.y),o.addScaledVector(Xl,r.z),o}static isFrontFacing(t,e,i,s){return pi.subVectors(i,e),Xi.subVectors(t,e),pi.cross(Xi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return pi.subVectors(this.c,this.b),Xi.subVectors(this.a,this.b),pi.cross(Xi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return oi.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return oi.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return oi.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return oi.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return oi.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const i=this.a,s=this.b,r=this.c;let o,a;gr.subVectors(s,i),_r.subVectors(r,i),Hl.subVectors(t,i);const l=gr.dot(Hl),c=_r.dot(Hl);if(l<=0&&c<=0)return e.copy(i);Gl.subVectors(t,s);const u=gr.dot(Gl),h=_r.dot(Gl);if(u>=0&&h<=u)return e.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(i).addScaledVector(gr,o);Vl.subVectors(t,r);const d=gr.dot(Vl),g=_r.dot(Vl);if(g>=0&&d<=g)return e.copy(r);const v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(_r,a);const m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return Wf.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(Wf,a);const p=1/(m+v+f);return o=v*p,a=f*p,e.copy(i).addScaledVector(gr,o).addScaledVector(_r,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const am={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},hs={h:0,s:0,l:0},ea={h:0,s:0,l:0};function ql(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}class ce{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ri){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.toWorkingColorSpace(this,e),this}setRGB(t,e,i,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=i,ve.toWorkingColorSpace(this,s),this}setHSL(t,e,i,s=ve.workingColorSpace){if(t=Yv(t,1),e=Dn(e,0,1),i=Dn(i,0,1),e===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=ql(o,r,t+1/3),this.g=ql(o,r,t),this.b=ql(o,r,t-1/3)}return ve.toWorkingColorSpace(this,s),this}setStyle(t,e=ri){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ri){const i=am[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Qi(t.r),this.g=Qi(t.g),this.b=Qi(t.b),this}copyLinearToSRGB(t){return this.r=Pr(t.r),this.g=Pr(t.g),this.b=Pr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ri){return ve.fromWorkingColorSpace(Sn.copy(this),t),Math.round(Dn(Sn.r*255,0,255))*65536+Math.round(Dn(Sn.g*255,0,255))*256+Math.round(Dn(Sn.b*255,0,255))}getHexString(t=ri){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.fromWorkingColorSpace(Sn.copy(this),e);const i=Sn.r,s=Sn.g,r=Sn.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ve.workingColorSpace){return ve.fromWorkingColorSpace(Sn.copy(this),e),t.r=Sn.r,t.g=Sn.g,t.b=Sn.b,t}getStyle(t=ri){ve.fromWorkingColorSpace(Sn.copy(this),t);const e=Sn.r,i=Sn.g,s=Sn.b;return t!==ri?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(hs),this.setHSL(hs.h+t,hs.s+e,hs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(hs),t.getHSL(ea);const i=Pl(hs.h,ea.h,e),s=Pl(hs.s,ea.s,e),r=Pl(hs.l,ea.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Sn=new ce;ce.NAMES=am;let hx=0;class Ks extends Yr{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:hx++}),this.uuid=Po(),this.name="",this.blending=Rr,this.side=vs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Tc,this.blendDst=Ac,this.blendEquation=Os,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ce(0,0,0),this.blendAlpha=0,this.depthFunc=kr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Af,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=lr,this.stencilZFail=lr,this.stencilZPass=lr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const i={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Rr&&(i.blending=this.blending),this.side!==vs&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Tc&&(i.blendSrc=this.blendSrc),this.blendDst!==Ac&&(i.blendDst=this.blendDst),this.blendEquation!==Os&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==kr&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Af&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==lr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==lr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==lr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let i=null;if(e!==null){const s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class jr extends Ks{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ki,this.combine=Gu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const Ke=new B,na=new ue;class Bn{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Rf,this.updateRanges=[],this.gpuType=Ki,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)na.fromBufferAttribute(this,e),na.applyMatrix3(t),this.setXY(e,na.x,na.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.applyMatrix3(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.applyMatrix4(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.applyNormalMatrix(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.transformDirection(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=lo(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Fn(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=lo(e,this.array)),e}setX(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=lo(e,this.array)),e}setY(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=lo(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=lo(e,this.array)),e}setW(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array),s=Fn(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array),s=Fn(s,this.array),r=Fn(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Rf&&(t.usage=this.usage),t}}class lm extends Bn{constructor(t,e,i){super(new Uint16Array(t),e,i)}}class cm extends Bn{constructor(t,e,i){super(new Uint32Array(t),e,i)}}class Be extends Bn{constructor(t,e,i){super(new Float32Array(t),e,i)}}let fx=0;const ei=new Ie,Yl=new sn,vr=new B,$n=new Kr,fo=new Kr,mn=new B;class ln extends Yr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:fx++}),this.uuid=Po(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(im(t)?cm:lm)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new ee().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return ei.makeRotationFromQuaternion(t),this.applyMatrix4(ei),this}rotateX(t){return ei.makeRotationX(t),this.applyMatrix4(ei),this}rotateY(t){return ei.makeRotationY(t),this.applyMatrix4(ei),this}rotateZ(t){return ei.makeRotationZ(t),this.applyMatrix4(ei),this}translate(t,e,i){return ei.makeTranslation(t,e,i),this.applyMatrix4(ei),this}scale(t,e,i){return ei.makeScale(t,e,i),this.applyMatrix4(ei),this}lookAt(t){return Yl.lookAt(t),Yl.updateMatrix(),this.applyMatrix4(Yl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(vr).negate(),this.translate(vr.x,vr.y,vr.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const i=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Be(i,3))}else{for(let i=0,s=e.count;i<s;i++){const r=t[i];e.setXYZ(i,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Kr);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){const r=e[i];$n.setFromBufferAttribute(r),this.morphTargetsRelative?(mn.addVectors(this.boundingBox.min,$n.min),this.boundingBox.expandByPoint(mn),mn.addVectors(this.boundingBox.max,$n.max),this.boundingBox.expandByPoint(mn)):(this.boundingBox.expandByPoint($n.min),this.boundingBox.expandByPoint($n.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Lo);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(t){const i=this.boundingSphere.center;if($n.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];fo.setFromBufferAttribute(a),this.morphTargetsRelative?(mn.addVectors($n.min,fo.min),$n.expandByPoint(mn),mn.addVectors($n.max,fo.max),$n.expandByPoint(mn)):($n.expandByPoint(fo.min),$n.expandByPoint(fo.max))}$n.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)mn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(mn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)mn.fromBufferAttribute(a,c),l&&(vr.fromBufferAttribute(t,c),mn.add(vr)),s=Math.max(s,i.distanceToSquared(mn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Bn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let U=0;U<i.count;U++)a[U]=new B,l[U]=new B;const c=new B,u=new B,h=new B,f=new ue,d=new ue,g=new ue,v=new B,m=new B;function p(U,w,S){c.fromBufferAttribute(i,U),u.fromBufferAttribute(i,w),h.fromBufferAttribute(i,S),f.fromBufferAttribute(r,U),d.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),d.sub(f),g.sub(f);const C=1/(d.x*g.y-g.x*d.y);isFinite(C)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-d.y).multiplyScalar(C),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(C),a[U].add(v),a[w].add(v),a[S].add(v),l[U].add(m),l[w].add(m),l[S].add(m))}let y=this.groups;y.length===0&&(y=[{start:0,count:t.count}]);for(let U=0,w=y.length;U<w;++U){const S=y[U],C=S.start,G=S.count;for(let N=C,V=C+G;N<V;N+=3)p(t.getX(N+0),t.getX(N+1),t.getX(N+2))}const T=new B,x=new B,I=new B,A=new B;function D(U){I.fromBufferAttribute(s,U),A.copy(I);const w=a[U];T.copy(w),T.sub(I.multiplyScalar(I.dot(w))).normalize(),x.crossVectors(A,w);const C=x.dot(l[U])<0?-1:1;o.setXYZW(U,T.x,T.y,T.z,C)}for(let U=0,w=y.length;U<w;++U){const S=y[U],C=S.start,G=S.count;for(let N=C,V=C+G;N<V;N+=3)D(t.getX(N+0)),D(t.getX(N+1)),D(t.getX(N+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Bn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);const s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,h=new B;if(t)for(let f=0,d=t.count;f<d;f+=3){const g=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)mn.fromBufferAttribute(t,e),mn.normalize(),t.setXYZ(e,mn.x,mn.y,mn.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new Bn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new ln,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,i);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],d=t(f,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const i=this.attributes;for(const l in i){const c=i[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const i=t.index;i!==null&&this.setIndex(i.clone(e));const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const $f=new Ie,Rs=new Ku,ia=new Lo,Xf=new B,sa=new B,ra=new B,oa=new B,Kl=new B,aa=new B,qf=new B,la=new B;class En extends sn{constructor(t=new ln,e=new jr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){aa.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(Kl.fromBufferAttribute(h,t),o?aa.addScaledVector(Kl,u):aa.addScaledVector(Kl.sub(e),u))}e.add(aa)}return e}raycast(t,e){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ia.copy(i.boundingSphere),ia.applyMatrix4(r),Rs.copy(t.ray).recast(t.near),!(ia.containsPoint(Rs.origin)===!1&&(Rs.intersectSphere(ia,Xf)===null||Rs.origin.distanceToSquared(Xf)>(t.far-t.near)**2))&&($f.copy(r).invert(),Rs.copy(t.ray).applyMatrix4($f),!(i.boundingBox!==null&&Rs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Rs)))}_computeIntersections(t,e,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),T=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,I=T;x<I;x+=3){const A=a.getX(x),D=a.getX(x+1),U=a.getX(x+2);s=ca(this,p,t,i,c,u,h,A,D,U),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const y=a.getX(m),T=a.getX(m+1),x=a.getX(m+2);s=ca(this,o,t,i,c,u,h,y,T,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),T=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,I=T;x<I;x+=3){const A=x,D=x+1,U=x+2;s=ca(this,p,t,i,c,u,h,A,D,U),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const y=m,T=m+1,x=m+2;s=ca(this,o,t,i,c,u,h,y,T,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function dx(n,t,e,i,s,r,o,a){let l;if(t.side===On?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===vs,a),l===null)return null;la.copy(a),la.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(la);return c<e.near||c>e.far?null:{distance:c,point:la.clone(),object:n}}function ca(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,sa),n.getVertexPosition(l,ra),n.getVertexPosition(c,oa);const u=dx(n,t,e,i,sa,ra,oa,qf);if(u){const h=new B;oi.getBarycoord(qf,sa,ra,oa,h),s&&(u.uv=oi.getInterpolatedAttribute(s,a,l,c,h,new ue)),r&&(u.uv1=oi.getInterpolatedAttribute(r,a,l,c,h,new ue)),o&&(u.normal=oi.getInterpolatedAttribute(o,a,l,c,h,new B),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new B,materialIndex:0};oi.getNormal(sa,ra,oa,f.normal),u.face=f,u.barycoord=h}return u}class Zr extends ln{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Be(c,3)),this.setAttribute("normal",new Be(u,3)),this.setAttribute("uv",new Be(h,2));function g(v,m,p,y,T,x,I,A,D,U,w){const S=x/D,C=I/U,G=x/2,N=I/2,V=A/2,j=D+1,K=U+1;let Q=0,tt=0;const ht=new B;for(let ct=0;ct<K;ct++){const mt=ct*C-N;for(let Mt=0;Mt<j;Mt++){const pt=Mt*S-G;ht[v]=pt*y,ht[m]=mt*T,ht[p]=V,c.push(ht.x,ht.y,ht.z),ht[v]=0,ht[m]=0,ht[p]=A>0?1:-1,u.push(ht.x,ht.y,ht.z),h.push(Mt/D),h.push(1-ct/U),Q+=1}}for(let ct=0;ct<U;ct++)for(let mt=0;mt<D;mt++){const Mt=f+mt+j*ct,pt=f+mt+j*(ct+1),it=f+(mt+1)+j*(ct+1),at=f+(mt+1)+j*ct;l.push(Mt,pt,at),l.push(pt,it,at),tt+=6}a.addGroup(d,tt,w),d+=tt,f+=Q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Zr(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function Vr(n){const t={};for(const e in n){t[e]={};for(const i in n[e]){const s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function Pn(n){const t={};for(let e=0;e<n.length;e++){const i=Vr(n[e]);for(const s in i)t[s]=i[s]}return t}function px(n){const t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function um(n){const t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}const mx={clone:Vr,merge:Pn};var gx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_x=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class xs extends Ks{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=gx,this.fragmentShader=_x,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Vr(t.uniforms),this.uniformsGroups=px(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}}class hm extends sn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ie,this.projectionMatrix=new Ie,this.projectionMatrixInverse=new Ie,this.coordinateSystem=ji}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const fs=new B,Yf=new ue,Kf=new ue;class qn extends hm{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=hu*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(La*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return hu*2*Math.atan(Math.tan(La*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){fs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(fs.x,fs.y).multiplyScalar(-t/fs.z),fs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(fs.x,fs.y).multiplyScalar(-t/fs.z)}getViewSize(t,e){return this.getViewBounds(t,Yf,Kf),e.subVectors(Kf,Yf)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(La*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const xr=-90,Mr=1;class vx extends sn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new qn(xr,Mr,t,e);s.layers=this.layers,this.add(s);const r=new qn(xr,Mr,t,e);r.layers=this.layers,this.add(r);const o=new qn(xr,Mr,t,e);o.layers=this.layers,this.add(o);const a=new qn(xr,Mr,t,e);a.layers=this.layers,this.add(a);const l=new qn(xr,Mr,t,e);l.layers=this.layers,this.add(l);const c=new qn(xr,Mr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===ji)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===za)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;const v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=v,t.setRenderTarget(i,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}}class fm extends kn{constructor(t,e,i,s,r,o,a,l,c,u){t=t!==void 0?t:[],e=e!==void 0?e:Br,super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class xx extends Ws{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new fm(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Ui}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Zr(5,5,5),r=new xs({name:"CubemapFromEquirect",uniforms:Vr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:On,blending:ms});r.uniforms.tEquirect.value=e;const o=new En(s,r),a=e.minFilter;return e.minFilter===zs&&(e.minFilter=Ui),new vx(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,i,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}}const jl=new B,Mx=new B,Sx=new ee;class Is{constructor(t=new B(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){const s=jl.subVectors(i,e).cross(Mx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const i=t.delta(jl),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const i=e||Sx.getNormalMatrix(t),s=this.coplanarPoint(jl).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Cs=new Lo,ua=new B;class ju{constructor(t=new Is,e=new Is,i=new Is,s=new Is,r=new Is,o=new Is){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=ji){const i=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],f=s[7],d=s[8],g=s[9],v=s[10],m=s[11],p=s[12],y=s[13],T=s[14],x=s[15];if(i[0].setComponents(l-r,f-c,m-d,x-p).normalize(),i[1].setComponents(l+r,f+c,m+d,x+p).normalize(),i[2].setComponents(l+o,f+u,m+g,x+y).normalize(),i[3].setComponents(l-o,f-u,m-g,x-y).normalize(),i[4].setComponents(l-a,f-h,m-v,x-T).normalize(),e===ji)i[5].setComponents(l+a,f+h,m+v,x+T).normalize();else if(e===za)i[5].setComponents(a,h,v,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Cs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Cs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Cs)}intersectsSprite(t){return Cs.center.set(0,0,0),Cs.radius=.7071067811865476,Cs.applyMatrix4(t.matrixWorld),this.intersectsSphere(Cs)}intersectsSphere(t){const e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let i=0;i<6;i++){const s=e[i];if(ua.x=s.normal.x>0?t.max.x:t.min.x,ua.y=s.normal.y>0?t.max.y:t.min.y,ua.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ua)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function dm(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function yx(n){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){const u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){const g=h[f],v=h[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){const v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class rl extends ln{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){const y=p*f-o;for(let T=0;T<c;T++){const x=T*h-r;g.push(x,-y,0),v.push(0,0,1),m.push(T/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){const T=y+c*p,x=y+c*(p+1),I=y+1+c*(p+1),A=y+1+c*p;d.push(T,x,A),d.push(x,I,A)}this.setIndex(d),this.setAttribute("position",new Be(g,3)),this.setAttribute("normal",new Be(v,3)),this.setAttribute("uv",new Be(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new rl(t.width,t.height,t.widthSegments,t.heightSegments)}}var Ex=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,bx=`#ifdef USE_ALPHAHASH
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
#endif`,wx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Tx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ax=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Rx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Cx=`#ifdef USE_AOMAP
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
#endif`,Px=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Lx=`#ifdef USE_BATCHING
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
#endif`,Dx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Ux=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ix=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Nx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Fx=`#ifdef USE_IRIDESCENCE
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
#endif`,Ox=`#ifdef USE_BUMPMAP
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
#endif`,kx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Bx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,zx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Hx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Gx=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Vx=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Wx=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,$x=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Xx=`#define PI 3.141592653589793
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
} // validated`,qx=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Yx=`vec3 transformedNormal = objectNormal;
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
#endif`,Kx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,jx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Zx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Jx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Qx="gl_FragColor = linearToOutputTexel( gl_FragColor );",tM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,eM=`#ifdef USE_ENVMAP
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
#endif`,nM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,iM=`#ifdef USE_ENVMAP
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
#endif`,sM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,rM=`#ifdef USE_ENVMAP
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
#endif`,oM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,aM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,lM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,cM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,uM=`#ifdef USE_GRADIENTMAP
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
}`,hM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,fM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,dM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,pM=`uniform bool receiveShadow;
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
#endif`,mM=`#ifdef USE_ENVMAP
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
#endif`,gM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,_M=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,vM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,xM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,MM=`PhysicalMaterial material;
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
#endif`,SM=`struct PhysicalMaterial {
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
}`,yM=`
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
#endif`,EM=`#if defined( RE_IndirectDiffuse )
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
#endif`,bM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,wM=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,TM=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,AM=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,RM=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,CM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,PM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,LM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,DM=`#if defined( USE_POINTS_UV )
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
#endif`,UM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,IM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,NM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,FM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,OM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kM=`#ifdef USE_MORPHTARGETS
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
#endif`,BM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,zM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,HM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,GM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,VM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,WM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,$M=`#ifdef USE_NORMALMAP
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
#endif`,XM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,YM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,KM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,jM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ZM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,JM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,QM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,tS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,eS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,nS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,iS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,sS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,rS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,oS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,aS=`float getShadowMask() {
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
}`,lS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,cS=`#ifdef USE_SKINNING
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
#endif`,uS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hS=`#ifdef USE_SKINNING
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
#endif`,fS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,dS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,pS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,mS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,gS=`#ifdef USE_TRANSMISSION
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
#endif`,_S=`#ifdef USE_TRANSMISSION
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
#endif`,vS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,MS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,SS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const yS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,ES=`uniform sampler2D t2D;
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
}`,bS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wS=`#ifdef ENVMAP_TYPE_CUBE
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
}`,TS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,AS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RS=`#include <common>
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
}`,CS=`#if DEPTH_PACKING == 3200
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
}`,PS=`#define DISTANCE
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
}`,LS=`#define DISTANCE
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
}`,DS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,US=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,IS=`uniform float scale;
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
}`,NS=`uniform vec3 diffuse;
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
}`,FS=`#include <common>
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
}`,OS=`uniform vec3 diffuse;
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
}`,kS=`#define LAMBERT
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
}`,BS=`#define LAMBERT
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
}`,zS=`#define MATCAP
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
}`,HS=`#define MATCAP
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
}`,GS=`#define NORMAL
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
}`,VS=`#define NORMAL
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
}`,WS=`#define PHONG
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
}`,$S=`#define PHONG
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
}`,XS=`#define STANDARD
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
}`,qS=`#define STANDARD
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
}`,YS=`#define TOON
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
}`,KS=`#define TOON
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
}`,jS=`uniform float size;
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
}`,ZS=`uniform vec3 diffuse;
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
}`,JS=`#include <common>
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
}`,QS=`uniform vec3 color;
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
}`,ty=`uniform float rotation;
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
}`,ey=`uniform vec3 diffuse;
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
}`,ie={alphahash_fragment:Ex,alphahash_pars_fragment:bx,alphamap_fragment:wx,alphamap_pars_fragment:Tx,alphatest_fragment:Ax,alphatest_pars_fragment:Rx,aomap_fragment:Cx,aomap_pars_fragment:Px,batching_pars_vertex:Lx,batching_vertex:Dx,begin_vertex:Ux,beginnormal_vertex:Ix,bsdfs:Nx,iridescence_fragment:Fx,bumpmap_pars_fragment:Ox,clipping_planes_fragment:kx,clipping_planes_pars_fragment:Bx,clipping_planes_pars_vertex:zx,clipping_planes_vertex:Hx,color_fragment:Gx,color_pars_fragment:Vx,color_pars_vertex:Wx,color_vertex:$x,common:Xx,cube_uv_reflection_fragment:qx,defaultnormal_vertex:Yx,displacementmap_pars_vertex:Kx,displacementmap_vertex:jx,emissivemap_fragment:Zx,emissivemap_pars_fragment:Jx,colorspace_fragment:Qx,colorspace_pars_fragment:tM,envmap_fragment:eM,envmap_common_pars_fragment:nM,envmap_pars_fragment:iM,envmap_pars_vertex:sM,envmap_physical_pars_fragment:mM,envmap_vertex:rM,fog_vertex:oM,fog_pars_vertex:aM,fog_fragment:lM,fog_pars_fragment:cM,gradientmap_pars_fragment:uM,lightmap_pars_fragment:hM,lights_lambert_fragment:fM,lights_lambert_pars_fragment:dM,lights_pars_begin:pM,lights_toon_fragment:gM,lights_toon_pars_fragment:_M,lights_phong_fragment:vM,lights_phong_pars_fragment:xM,lights_physical_fragment:MM,lights_physical_pars_fragment:SM,lights_fragment_begin:yM,lights_fragment_maps:EM,lights_fragment_end:bM,logdepthbuf_fragment:wM,logdepthbuf_pars_fragment:TM,logdepthbuf_pars_vertex:AM,logdepthbuf_vertex:RM,map_fragment:CM,map_pars_fragment:PM,map_particle_fragment:LM,map_particle_pars_fragment:DM,metalnessmap_fragment:UM,metalnessmap_pars_fragment:IM,morphinstance_vertex:NM,morphcolor_vertex:FM,morphnormal_vertex:OM,morphtarget_pars_vertex:kM,morphtarget_vertex:BM,normal_fragment_begin:zM,normal_fragment_maps:HM,normal_pars_fragment:GM,normal_pars_vertex:VM,normal_vertex:WM,normalmap_pars_fragment:$M,clearcoat_normal_fragment_begin:XM,clearcoat_normal_fragment_maps:qM,clearcoat_pars_fragment:YM,iridescence_pars_fragment:KM,opaque_fragment:jM,packing:ZM,premultiplied_alpha_fragment:JM,project_vertex:QM,dithering_fragment:tS,dithering_pars_fragment:eS,roughnessmap_fragment:nS,roughnessmap_pars_fragment:iS,shadowmap_pars_fragment:sS,shadowmap_pars_vertex:rS,shadowmap_vertex:oS,shadowmask_pars_fragment:aS,skinbase_vertex:lS,skinning_pars_vertex:cS,skinning_vertex:uS,skinnormal_vertex:hS,specularmap_fragment:fS,specularmap_pars_fragment:dS,tonemapping_fragment:pS,tonemapping_pars_fragment:mS,transmission_fragment:gS,transmission_pars_fragment:_S,uv_pars_fragment:vS,uv_pars_vertex:xS,uv_vertex:MS,worldpos_vertex:SS,background_vert:yS,background_frag:ES,backgroundCube_vert:bS,backgroundCube_frag:wS,cube_vert:TS,cube_frag:AS,depth_vert:RS,depth_frag:CS,distanceRGBA_vert:PS,distanceRGBA_frag:LS,equirect_vert:DS,equirect_frag:US,linedashed_vert:IS,linedashed_frag:NS,meshbasic_vert:FS,meshbasic_frag:OS,meshlambert_vert:kS,meshlambert_frag:BS,meshmatcap_vert:zS,meshmatcap_frag:HS,meshnormal_vert:GS,meshnormal_frag:VS,meshphong_vert:WS,meshphong_frag:$S,meshphysical_vert:XS,meshphysical_frag:qS,meshtoon_vert:YS,meshtoon_frag:KS,points_vert:jS,points_frag:ZS,shadow_vert:JS,shadow_frag:QS,sprite_vert:ty,sprite_frag:ey},bt={common:{diffuse:{value:new ce(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new ue(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ce(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ce(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new ce(16777215)},opacity:{value:1},center:{value:new ue(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},Ci={basic:{uniforms:Pn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:ie.meshbasic_vert,fragmentShader:ie.meshbasic_frag},lambert:{uniforms:Pn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new ce(0)}}]),vertexShader:ie.meshlambert_vert,fragmentShader:ie.meshlambert_frag},phong:{uniforms:Pn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new ce(0)},specular:{value:new ce(1118481)},shininess:{value:30}}]),vertexShader:ie.meshphong_vert,fragmentShader:ie.meshphong_frag},standard:{uniforms:Pn([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new ce(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ie.meshphysical_vert,fragmentShader:ie.meshphysical_frag},toon:{uniforms:Pn([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new ce(0)}}]),vertexShader:ie.meshtoon_vert,fragmentShader:ie.meshtoon_frag},matcap:{uniforms:Pn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:ie.meshmatcap_vert,fragmentShader:ie.meshmatcap_frag},points:{uniforms:Pn([bt.points,bt.fog]),vertexShader:ie.points_vert,fragmentShader:ie.points_frag},dashed:{uniforms:Pn([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ie.linedashed_vert,fragmentShader:ie.linedashed_frag},depth:{uniforms:Pn([bt.common,bt.displacementmap]),vertexShader:ie.depth_vert,fragmentShader:ie.depth_frag},normal:{uniforms:Pn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:ie.meshnormal_vert,fragmentShader:ie.meshnormal_frag},sprite:{uniforms:Pn([bt.sprite,bt.fog]),vertexShader:ie.sprite_vert,fragmentShader:ie.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ie.background_vert,fragmentShader:ie.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ie.backgroundCube_vert,fragmentShader:ie.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ie.cube_vert,fragmentShader:ie.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ie.equirect_vert,fragmentShader:ie.equirect_frag},distanceRGBA:{uniforms:Pn([bt.common,bt.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ie.distanceRGBA_vert,fragmentShader:ie.distanceRGBA_frag},shadow:{uniforms:Pn([bt.lights,bt.fog,{color:{value:new ce(0)},opacity:{value:1}}]),vertexShader:ie.shadow_vert,fragmentShader:ie.shadow_frag}};Ci.physical={uniforms:Pn([Ci.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new ue(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new ce(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new ue},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new ce(0)},specularColor:{value:new ce(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new ue},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ie.meshphysical_vert,fragmentShader:ie.meshphysical_frag};const ha={r:0,b:0,g:0},Ps=new ki,ny=new Ie;function iy(n,t,e,i,s,r,o){const a=new ce(0);let l=r===!0?0:1,c,u,h=null,f=0,d=null;function g(y){let T=y.isScene===!0?y.background:null;return T&&T.isTexture&&(T=(y.backgroundBlurriness>0?e:t).get(T)),T}function v(y){let T=!1;const x=g(y);x===null?p(a,l):x&&x.isColor&&(p(x,1),T=!0);const I=n.xr.getEnvironmentBlendMode();I==="additive"?i.buffers.color.setClear(0,0,0,1,o):I==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||T)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(y,T){const x=g(T);x&&(x.isCubeTexture||x.mapping===il)?(u===void 0&&(u=new En(new Zr(1,1,1),new xs({name:"BackgroundCubeMaterial",uniforms:Vr(Ci.backgroundCube.uniforms),vertexShader:Ci.backgroundCube.vertexShader,fragmentShader:Ci.backgroundCube.fragmentShader,side:On,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(I,A,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Ps.copy(T.backgroundRotation),Ps.x*=-1,Ps.y*=-1,Ps.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(Ps.y*=-1,Ps.z*=-1),u.material.uniforms.envMap.value=x,u.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(ny.makeRotationFromEuler(Ps)),u.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,(h!==x||f!==x.version||d!==n.toneMapping)&&(u.material.needsUpdate=!0,h=x,f=x.version,d=n.toneMapping),u.layers.enableAll(),y.unshift(u,u.geometry,u.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new En(new rl(2,2),new xs({name:"BackgroundMaterial",uniforms:Vr(Ci.background.uniforms),vertexShader:Ci.background.vertexShader,fragmentShader:Ci.background.fragmentShader,side:vs,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||f!==x.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=x,f=x.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function p(y,T){y.getRGB(ha,um(n)),i.buffers.color.setClear(ha.r,ha.g,ha.b,T,o)}return{getClearColor:function(){return a},setClearColor:function(y,T=1){a.set(y),l=T,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(y){l=y,p(a,l)},render:v,addToRenderList:m}}function sy(n,t){const e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null);let r=s,o=!1;function a(S,C,G,N,V){let j=!1;const K=h(N,G,C);r!==K&&(r=K,c(r.object)),j=d(S,N,G,V),j&&g(S,N,G,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(j||o)&&(o=!1,x(S,C,G,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(S){return n.bindVertexArray(S)}function u(S){return n.deleteVertexArray(S)}function h(S,C,G){const N=G.wireframe===!0;let V=i[S.id];V===void 0&&(V={},i[S.id]=V);let j=V[C.id];j===void 0&&(j={},V[C.id]=j);let K=j[N];return K===void 0&&(K=f(l()),j[N]=K),K}function f(S){const C=[],G=[],N=[];for(let V=0;V<e;V++)C[V]=0,G[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:G,attributeDivisors:N,object:S,attributes:{},index:null}}function d(S,C,G,N){const V=r.attributes,j=C.attributes;let K=0;const Q=G.getAttributes();for(const tt in Q)if(Q[tt].location>=0){const ct=V[tt];let mt=j[tt];if(mt===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;K++}return r.attributesNum!==K||r.index!==N}function g(S,C,G,N){const V={},j=C.attributes;let K=0;const Q=G.getAttributes();for(const tt in Q)if(Q[tt].location>=0){let ct=j[tt];ct===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),V[tt]=mt,K++}r.attributes=V,r.attributesNum=K,r.index=N}function v(){const S=r.newAttributes;for(let C=0,G=S.length;C<G;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){const G=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;G[S]=1,N[S]===0&&(n.enableVertexAttribArray(S),N[S]=1),V[S]!==C&&(n.vertexAttribDivisor(S,C),V[S]=C)}function y(){const S=r.newAttributes,C=r.enabledAttributes;for(let G=0,N=C.length;G<N;G++)C[G]!==S[G]&&(n.disableVertexAttribArray(G),C[G]=0)}function T(S,C,G,N,V,j,K){K===!0?n.vertexAttribIPointer(S,C,G,V,j):n.vertexAttribPointer(S,C,G,N,V,j)}function x(S,C,G,N){v();const V=N.attributes,j=G.getAttributes(),K=C.defaultAttributeValues;for(const Q in j){const tt=j[Q];if(tt.location>=0){let ht=V[Q];if(ht===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ht=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ht=S.instanceColor)),ht!==void 0){const ct=ht.normalized,mt=ht.itemSize,Mt=t.get(ht);if(Mt===void 0)continue;const pt=Mt.buffer,it=Mt.type,at=Mt.bytesPerElement,gt=it===n.INT||it===n.UNSIGNED_INT||ht.gpuType===Vu;if(ht.isInterleavedBufferAttribute){const ot=ht.data,Bt=ot.stride,Gt=ht.offset;if(ot.isInstancedInterleavedBuffer){for(let It=0;It<tt.locationSize;It++)p(tt.location+It,ot.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let It=0;It<tt.locationSize;It++)m(tt.location+It);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let It=0;It<tt.locationSize;It++)T(tt.location+It,mt/tt.locationSize,it,ct,Bt*at,(Gt+mt/tt.locationSize*It)*at,gt)}else{if(ht.isInstancedBufferAttribute){for(let ot=0;ot<tt.locationSize;ot++)p(tt.location+ot,ht.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ot=0;ot<tt.locationSize;ot++)m(tt.location+ot);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let ot=0;ot<tt.locationSize;ot++)T(tt.location+ot,mt/tt.locationSize,it,ct,mt*at,mt/tt.locationSize*ot*at,gt)}}else if(K!==void 0){const ct=K[Q];if(ct!==void 0)switch(ct.length){case 2:n.vertexAttrib2fv(tt.location,ct);break;case 3:n.vertexAttrib3fv(tt.location,ct);break;case 4:n.vertexAttrib4fv(tt.location,ct);break;default:n.vertexAttrib1fv(tt.location,ct)}}}}y()}function I(){U();for(const S in i){const C=i[S];for(const G in C){const N=C[G];for(const V in N)u(N[V].object),delete N[V];delete C[G]}delete i[S]}}function A(S){if(i[S.id]===void 0)return;const C=i[S.id];for(const G in C){const N=C[G];for(const V in N)u(N[V].object),delete N[V];delete C[G]}delete i[S.id]}function D(S){for(const C in i){const G=i[C];if(G[S.id]===void 0)continue;const N=G[S.id];for(const V in N)u(N[V].object),delete N[V];delete G[S.id]}}function U(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:w,dispose:I,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function ry(n,t,e){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),e.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),e.update(u,i,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let d=0;for(let g=0;g<h;g++)d+=u[g];e.update(d,i,1)}function l(c,u,h,f){if(h===0)return;const d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(i,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];e.update(g,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function oy(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==vi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const U=D===Co&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==ts&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ki&&!U)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=g>0,A=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:T,maxFragmentUniforms:x,vertexTextures:I,maxSamples:A}}function ay(n){const t=this;let e=null,i=0,s=!1,r=!1;const o=new Is,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){const g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{const y=r?0:i,T=y*4;let x=p.clippingState||null;l.value=x,x=u(g,f,T,d);for(let I=0;I!==T;++I)x[I]=e[I];p.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,g){const v=h!==null?h.length:0;let m=null;if(v!==0){if(m=l.value,g!==!0||m===null){const p=d+v*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,x=d;T!==v;++T,x+=4)o.copy(h[T]).applyMatrix4(y,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function ly(n){let t=new WeakMap;function e(o,a){return a===Nc?o.mapping=Br:a===Fc&&(o.mapping=zr),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===Nc||a===Fc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new xx(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}class Zu extends hm{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Er=4,jf=[.125,.215,.35,.446,.526,.582],ks=20,Zl=new Zu,Zf=new ce;let Jl=null,Ql=0,tc=0,ec=!1;const Ns=(1+Math.sqrt(5))/2,Sr=1/Ns,Jf=[new B(-Ns,Sr,0),new B(Ns,Sr,0),new B(-Sr,0,Ns),new B(Sr,0,Ns),new B(0,Ns,-Sr),new B(0,Ns,Sr),new B(-1,1,-1),new B(1,1,-1),new B(-1,1,1),new B(1,1,1)];class Qf{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100){Jl=this._renderer.getRenderTarget(),Ql=this._renderer.getActiveCubeFace(),tc=this._renderer.getActiveMipmapLevel(),ec=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,i,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=nd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ed(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Jl,Ql,tc),this._renderer.xr.enabled=ec,t.scissorTest=!1,fa(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Br||t.mapping===zr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Jl=this._renderer.getRenderTarget(),Ql=this._renderer.getActiveCubeFace(),tc=this._renderer.getActiveMipmapLevel(),ec=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Ui,minFilter:Ui,generateMipmaps:!1,type:Co,format:vi,colorSpace:Ys,depthBuffer:!1},s=td(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=td(t,e,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=cy(r)),this._blurMaterial=uy(r,t,e)}return s}_compileMaterial(t){const e=new En(this._lodPlanes[0],t);this._renderer.compile(e,Zl)}_sceneToCubeUV(t,e,i,s){const a=new qn(90,1,e,i),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,f=u.toneMapping;u.getClearColor(Zf),u.toneMapping=gs,u.autoClear=!1;const d=new jr({name:"PMREM.Background",side:On,depthWrite:!1,depthTest:!1}),g=new En(new Zr,d);let v=!1;const m=t.background;m?m.isColor&&(d.color.copy(m),t.background=null,v=!0):(d.color.copy(Zf),v=!0);for(let p=0;p<6;p++){const y=p%3;y===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):y===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));const T=this._cubeSize;fa(s,y*T,p>2?T:0,T,T),u.setRenderTarget(s),v&&u.render(g,a),u.render(t,a)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=f,u.autoClear=h,t.background=m}_textureToCubeUV(t,e){const i=this._renderer,s=t.mapping===Br||t.mapping===zr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=nd()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=ed());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new En(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;fa(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,Zl)}_applyPMREM(t){const e=this._renderer,i=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Jf[(s-r-1)%Jf.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new En(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[i]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*ks-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):ks;m>ks&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${ks}`);const p=[];let y=0;for(let D=0;D<ks;++D){const U=D/v,w=Math.exp(-U*U/2);p.push(w),D===0?y+=w:D<m&&(y+=2*w)}for(let D=0;D<p.length;D++)p[D]=p[D]/y;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:T}=this;f.dTheta.value=g,f.mipInt.value=T-i;const x=this._sizeLods[s],I=3*x*(s>T-Er?s-T+Er:0),A=4*(this._cubeSize-x);fa(e,I,A,3*x,2*x),l.setRenderTarget(e),l.render(h,Zl)}}function cy(n){const t=[],e=[],i=[];let s=n;const r=n-Er+1+jf.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>n-Er?l=jf[o-n+Er-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,g=6,v=3,m=2,p=1,y=new Float32Array(v*g*d),T=new Float32Array(m*g*d),x=new Float32Array(p*g*d);for(let A=0;A<d;A++){const D=A%3*2/3-1,U=A>2?0:-1,w=[D,U,0,D+2/3,U,0,D+2/3,U+1,0,D,U,0,D+2/3,U+1,0,D,U+1,0];y.set(w,v*g*A),T.set(f,m*g*A);const S=[A,A,A,A,A,A];x.set(S,p*g*A)}const I=new ln;I.setAttribute("position",new Bn(y,v)),I.setAttribute("uv",new Bn(T,m)),I.setAttribute("faceIndex",new Bn(x,p)),t.push(I),s>Er&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function td(n,t,e){const i=new Ws(n,t,e);return i.texture.mapping=il,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function fa(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function uy(n,t,e){const i=new Float32Array(ks),s=new B(0,1,0);return new xs({name:"SphericalGaussianBlur",defines:{n:ks,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Ju(),fragmentShader:`

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
		`,blending:ms,depthTest:!1,depthWrite:!1})}function ed(){return new xs({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Ju(),fragmentShader:`

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
		`,blending:ms,depthTest:!1,depthWrite:!1})}function nd(){return new xs({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Ju(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ms,depthTest:!1,depthWrite:!1})}function Ju(){return`

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
	`}function hy(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===Nc||l===Fc,u=l===Br||l===zr;if(c||u){let h=t.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new Qf(n)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new Qf(n)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function fy(n){const t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){const s=e(i);return s===null&&vo("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function dy(n,t,e,i){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&t.remove(f.index);for(const g in f.attributes)t.remove(f.attributes[g]);for(const g in f.morphAttributes){const v=f.morphAttributes[g];for(let m=0,p=v.length;m<p;m++)t.remove(v[m])}f.removeEventListener("dispose",o),delete s[f.id];const d=r.get(f);d&&(t.remove(d),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){const f=h.attributes;for(const g in f)t.update(f[g],n.ARRAY_BUFFER);const d=h.morphAttributes;for(const g in d){const v=d[g];for(let m=0,p=v.length;m<p;m++)t.update(v[m],n.ARRAY_BUFFER)}}function c(h){const f=[],d=h.index,g=h.attributes.position;let v=0;if(d!==null){const y=d.array;v=d.version;for(let T=0,x=y.length;T<x;T+=3){const I=y[T+0],A=y[T+1],D=y[T+2];f.push(I,A,A,D,D,I)}}else if(g!==void 0){const y=g.array;v=g.version;for(let T=0,x=y.length/3-1;T<x;T+=3){const I=T+0,A=T+1,D=T+2;f.push(I,A,A,D,D,I)}}else return;const m=new(im(f)?cm:lm)(f,1);m.version=v;const p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){const f=r.get(h);if(f){const d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function py(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,r,f*o),e.update(d,i,1)}function c(f,d,g){g!==0&&(n.drawElementsInstanced(i,d,r,f*o,g),e.update(d,i,g))}function u(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,i,1)}function h(f,d,g,v){if(g===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(i,d,0,r,f,0,v,0,g);let p=0;for(let y=0;y<g;y++)p+=d[y]*v[y];e.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function my(n){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function gy(n,t,e){const i=new WeakMap,s=new Ve;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=i.get(a);if(f===void 0||f.count!==h){let w=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();const d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[];let T=0;d===!0&&(T=1),g===!0&&(T=2),v===!0&&(T=3);let x=a.attributes.position.count*T,I=1;x>t.maxTextureSize&&(I=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);const A=new Float32Array(x*I*4*h),D=new rm(A,x,I,h);D.type=Ki,D.needsUpdate=!0;const U=T*4;for(let S=0;S<h;S++){const C=m[S],G=p[S],N=y[S],V=x*I*4*S;for(let j=0;j<C.count;j++){const K=j*U;d===!0&&(s.fromBufferAttribute(C,j),A[V+K+0]=s.x,A[V+K+1]=s.y,A[V+K+2]=s.z,A[V+K+3]=0),g===!0&&(s.fromBufferAttribute(G,j),A[V+K+4]=s.x,A[V+K+5]=s.y,A[V+K+6]=s.z,A[V+K+7]=0),v===!0&&(s.fromBufferAttribute(N,j),A[V+K+8]=s.x,A[V+K+9]=s.y,A[V+K+10]=s.z,A[V+K+11]=N.itemSize===4?s.w:1)}}f={count:h,texture:D,size:new ue(x,I)},i.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];const g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function _y(n,t,e,i){let s=new WeakMap;function r(l){const c=i.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class pm extends kn{constructor(t,e,i,s,r,o,a,l,c,u=Cr){if(u!==Cr&&u!==Gr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");i===void 0&&u===Cr&&(i=Vs),i===void 0&&u===Gr&&(i=Hr),super(null,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:Mi,this.minFilter=l!==void 0?l:Mi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const mm=new kn,id=new pm(1,1),gm=new rm,_m=new ix,vm=new fm,sd=[],rd=[],od=new Float32Array(16),ad=new Float32Array(9),ld=new Float32Array(4);function Jr(n,t,e){const i=n[0];if(i<=0||i>0)return n;const s=t*e;let r=sd[s];if(r===void 0&&(r=new Float32Array(s),sd[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function rn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function on(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function ol(n,t){let e=rd[t];e===void 0&&(e=new Int32Array(t),rd[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function vy(n,t){const e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function xy(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2fv(this.addr,t),on(e,t)}}function My(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(rn(e,t))return;n.uniform3fv(this.addr,t),on(e,t)}}function Sy(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4fv(this.addr,t),on(e,t)}}function yy(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;ld.set(i),n.uniformMatrix2fv(this.addr,!1,ld),on(e,i)}}function Ey(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;ad.set(i),n.uniformMatrix3fv(this.addr,!1,ad),on(e,i)}}function by(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;od.set(i),n.uniformMatrix4fv(this.addr,!1,od),on(e,i)}}function wy(n,t){const e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function Ty(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2iv(this.addr,t),on(e,t)}}function Ay(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(rn(e,t))return;n.uniform3iv(this.addr,t),on(e,t)}}function Ry(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4iv(this.addr,t),on(e,t)}}function Cy(n,t){const e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Py(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2uiv(this.addr,t),on(e,t)}}function Ly(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(rn(e,t))return;n.uniform3uiv(this.addr,t),on(e,t)}}function Dy(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4uiv(this.addr,t),on(e,t)}}function Uy(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(id.compareFunction=nm,r=id):r=mm,e.setTexture2D(t||r,s)}function Iy(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||_m,s)}function Ny(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||vm,s)}function Fy(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||gm,s)}function Oy(n){switch(n){case 5126:return vy;case 35664:return xy;case 35665:return My;case 35666:return Sy;case 35674:return yy;case 35675:return Ey;case 35676:return by;case 5124:case 35670:return wy;case 35667:case 35671:return Ty;case 35668:case 35672:return Ay;case 35669:case 35673:return Ry;case 5125:return Cy;case 36294:return Py;case 36295:return Ly;case 36296:return Dy;case 35678:case 36198:case 36298:case 36306:case 35682:return Uy;case 35679:case 36299:case 36307:return Iy;case 35680:case 36300:case 36308:case 36293:return Ny;case 36289:case 36303:case 36311:case 36292:return Fy}}function ky(n,t){n.uniform1fv(this.addr,t)}function By(n,t){const e=Jr(t,this.size,2);n.uniform2fv(this.addr,e)}function zy(n,t){const e=Jr(t,this.size,3);n.uniform3fv(this.addr,e)}function Hy(n,t){const e=Jr(t,this.size,4);n.uniform4fv(this.addr,e)}function Gy(n,t){const e=Jr(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Vy(n,t){const e=Jr(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Wy(n,t){const e=Jr(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function $y(n,t){n.uniform1iv(this.addr,t)}function Xy(n,t){n.uniform2iv(this.addr,t)}function qy(n,t){n.uniform3iv(this.addr,t)}function Yy(n,t){n.uniform4iv(this.addr,t)}function Ky(n,t){n.uniform1uiv(this.addr,t)}function jy(n,t){n.uniform2uiv(this.addr,t)}function Zy(n,t){n.uniform3uiv(this.addr,t)}function Jy(n,t){n.uniform4uiv(this.addr,t)}function Qy(n,t,e){const i=this.cache,s=t.length,r=ol(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||mm,r[o])}function tE(n,t,e){const i=this.cache,s=t.length,r=ol(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||_m,r[o])}function eE(n,t,e){const i=this.cache,s=t.length,r=ol(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||vm,r[o])}function nE(n,t,e){const i=this.cache,s=t.length,r=ol(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||gm,r[o])}function iE(n){switch(n){case 5126:return ky;case 35664:return By;case 35665:return zy;case 35666:return Hy;case 35674:return Gy;case 35675:return Vy;case 35676:return Wy;case 5124:case 35670:return $y;case 35667:case 35671:return Xy;case 35668:case 35672:return qy;case 35669:case 35673:return Yy;case 5125:return Ky;case 36294:return jy;case 36295:return Zy;case 36296:return Jy;case 35678:case 36198:case 36298:case 36306:case 35682:return Qy;case 35679:case 36299:case 36307:return tE;case 35680:case 36300:case 36308:case 36293:return eE;case 36289:case 36303:case 36311:case 36292:return nE}}class sE{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Oy(e.type)}}class rE{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=iE(e.type)}}class oE{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],i)}}}const nc=/(\w+)(\])?(\[|\.)?/g;function cd(n,t){n.seq.push(t),n.map[t.id]=t}function aE(n,t,e){const i=n.name,s=i.length;for(nc.lastIndex=0;;){const r=nc.exec(i),o=nc.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){cd(e,c===void 0?new sE(a,n,t):new rE(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new oE(a),cd(e,h)),e=h}}}class Da{constructor(t,e){this.seq=[],this.map={};const i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);aE(r,o,this)}}setValue(t,e,i,s){const r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){const s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const i=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&i.push(o)}return i}}function ud(n,t,e){const i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}const lE=37297;let cE=0;function uE(n,t){const e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}const hd=new ee;function hE(n){ve._getMatrix(hd,ve.workingColorSpace,n);const t=`mat3( ${hd.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(n)){case sl:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function fd(n,t,e){const i=n.getShaderParameter(t,n.COMPILE_STATUS),s=n.getShaderInfoLog(t).trim();if(i&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+uE(n.getShaderSource(t),o)}else return s}function fE(n,t){const e=hE(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function dE(n,t){let e;switch(t){case Pv:e="Linear";break;case Lv:e="Reinhard";break;case Dv:e="Cineon";break;case Uv:e="ACESFilmic";break;case Nv:e="AgX";break;case Fv:e="Neutral";break;case Iv:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const da=new B;function pE(){ve.getLuminanceCoefficients(da);const n=da.x.toFixed(4),t=da.y.toFixed(4),e=da.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function mE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(xo).join(`
`)}function gE(n){const t=[];for(const e in n){const i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function _E(n,t){const e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(t,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function xo(n){return n!==""}function dd(n,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function pd(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const vE=/^[ \t]*#include +<([\w\d./]+)>/gm;function fu(n){return n.replace(vE,ME)}const xE=new Map;function ME(n,t){let e=ie[t];if(e===void 0){const i=xE.get(t);if(i!==void 0)e=ie[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return fu(e)}const SE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function md(n){return n.replace(SE,yE)}function yE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function gd(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function EE(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===Vp?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===cv?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===Yi&&(t="SHADOWMAP_TYPE_VSM"),t}function bE(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Br:case zr:t="ENVMAP_TYPE_CUBE";break;case il:t="ENVMAP_TYPE_CUBE_UV";break}return t}function wE(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case zr:t="ENVMAP_MODE_REFRACTION";break}return t}function TE(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case Gu:t="ENVMAP_BLENDING_MULTIPLY";break;case Rv:t="ENVMAP_BLENDING_MIX";break;case Cv:t="ENVMAP_BLENDING_ADD";break}return t}function AE(n){const t=n.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function RE(n,t,e,i){const s=n.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=EE(e),c=bE(e),u=wE(e),h=TE(e),f=AE(e),d=mE(e),g=gE(r),v=s.createProgram();let m,p,y=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(xo).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(xo).join(`
`),p.length>0&&(p+=`
`)):(m=[gd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(xo).join(`
`),p=[gd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==gs?"#define TONE_MAPPING":"",e.toneMapping!==gs?ie.tonemapping_pars_fragment:"",e.toneMapping!==gs?dE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ie.colorspace_pars_fragment,fE("linearToOutputTexel",e.outputColorSpace),pE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(xo).join(`
`)),o=fu(o),o=dd(o,e),o=pd(o,e),a=fu(a),a=dd(a,e),a=pd(a,e),o=md(o),a=md(a),e.isRawShaderMaterial!==!0&&(y=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===Cf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Cf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const T=y+m+o,x=y+p+a,I=ud(s,s.VERTEX_SHADER,T),A=ud(s,s.FRAGMENT_SHADER,x);s.attachShader(v,I),s.attachShader(v,A),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(n.debug.checkShaderErrors){const G=s.getProgramInfoLog(v).trim(),N=s.getShaderInfoLog(I).trim(),V=s.getShaderInfoLog(A).trim();let j=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(j=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,I,A);else{const Q=fd(s,I,"vertex"),tt=fd(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+G+`
`+Q+`
`+tt)}else G!==""?console.warn("THREE.WebGLProgram: Program Info Log:",G):(N===""||V==="")&&(K=!1);K&&(C.diagnostics={runnable:j,programLog:G,vertexShader:{log:N,prefix:m},fragmentShader:{log:V,prefix:p}})}s.deleteShader(I),s.deleteShader(A),U=new Da(s,v),w=_E(s,v)}let U;this.getUniforms=function(){return U===void 0&&D(this),U};let w;this.getAttributes=function(){return w===void 0&&D(this),w};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,lE)),S},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=cE++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=I,this.fragmentShader=A,this}let CE=0;class PE{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){const e=this.shaderCache;let i=e.get(t);return i===void 0&&(i=new LE(t),e.set(t,i)),i}}class LE{constructor(t){this.id=CE++,this.code=t,this.usedTimes=0}}function DE(n,t,e,i,s,r,o){const a=new om,l=new PE,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let d=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function m(w,S,C,G,N){const V=G.fog,j=N.geometry,K=w.isMeshStandardMaterial?G.environment:null,Q=(w.isMeshStandardMaterial?e:t).get(w.envMap||K),tt=Q&&Q.mapping===il?Q.image.height:null,ht=g[w.type];w.precision!==null&&(d=s.getMaxPrecision(w.precision),d!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",d,"instead."));const ct=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mt=ct!==void 0?ct.length:0;let Mt=0;j.morphAttributes.position!==void 0&&(Mt=1),j.morphAttributes.normal!==void 0&&(Mt=2),j.morphAttributes.color!==void 0&&(Mt=3);let pt,it,at,gt;if(ht){const Se=Ci[ht];pt=Se.vertexShader,it=Se.fragmentShader}else pt=w.vertexShader,it=w.fragmentShader,l.update(w),at=l.getVertexShaderID(w),gt=l.getFragmentShaderID(w);const ot=n.getRenderTarget(),Bt=n.state.buffers.depth.getReversed(),Gt=N.isInstancedMesh===!0,It=N.isBatchedMesh===!0,he=!!w.map,Jt=!!w.matcap,fe=!!Q,z=!!w.aoMap,Qe=!!w.lightMap,te=!!w.bumpMap,ne=!!w.normalMap,Vt=!!w.displacementMap,me=!!w.emissiveMap,Pt=!!w.metalnessMap,P=!!w.roughnessMap,E=w.anisotropy>0,Y=w.clearcoat>0,J=w.dispersion>0,W=w.iridescence>0,et=w.sheen>0,St=w.transmission>0,_t=E&&!!w.anisotropyMap,wt=Y&&!!w.clearcoatMap,Zt=Y&&!!w.clearcoatNormalMap,ft=Y&&!!w.clearcoatRoughnessMap,vt=W&&!!w.iridescenceMap,Nt=W&&!!w.iridescenceThicknessMap,Ot=et&&!!w.sheenColorMap,Et=et&&!!w.sheenRoughnessMap,se=!!w.specularMap,Yt=!!w.specularColorMap,ge=!!w.specularIntensityMap,k=St&&!!w.transmissionMap,xt=St&&!!w.thicknessMap,nt=!!w.gradientMap,rt=!!w.alphaMap,Tt=w.alphaTest>0,At=!!w.alphaHash,Qt=!!w.extensions;let ze=gs;w.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(ze=n.toneMapping);const cn={shaderID:ht,shaderType:w.type,shaderName:w.name,vertexShader:pt,fragmentShader:it,defines:w.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:d,batching:It,batchingColor:It&&N._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&N.instanceColor!==null,instancingMorph:Gt&&N.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ot===null?n.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:Ys,alphaToCoverage:!!w.alphaToCoverage,map:he,matcap:Jt,envMap:fe,envMapMode:fe&&Q.mapping,envMapCubeUVHeight:tt,aoMap:z,lightMap:Qe,bumpMap:te,normalMap:ne,displacementMap:f&&Vt,emissiveMap:me,normalMapObjectSpace:ne&&w.normalMapType===zv,normalMapTangentSpace:ne&&w.normalMapType===em,metalnessMap:Pt,roughnessMap:P,anisotropy:E,anisotropyMap:_t,clearcoat:Y,clearcoatMap:wt,clearcoatNormalMap:Zt,clearcoatRoughnessMap:ft,dispersion:J,iridescence:W,iridescenceMap:vt,iridescenceThicknessMap:Nt,sheen:et,sheenColorMap:Ot,sheenRoughnessMap:Et,specularMap:se,specularColorMap:Yt,specularIntensityMap:ge,transmission:St,transmissionMap:k,thicknessMap:xt,gradientMap:nt,opaque:w.transparent===!1&&w.blending===Rr&&w.alphaToCoverage===!1,alphaMap:rt,alphaTest:Tt,alphaHash:At,combine:w.combine,mapUv:he&&v(w.map.channel),aoMapUv:z&&v(w.aoMap.channel),lightMapUv:Qe&&v(w.lightMap.channel),bumpMapUv:te&&v(w.bumpMap.channel),normalMapUv:ne&&v(w.normalMap.channel),displacementMapUv:Vt&&v(w.displacementMap.channel),emissiveMapUv:me&&v(w.emissiveMap.channel),metalnessMapUv:Pt&&v(w.metalnessMap.channel),roughnessMapUv:P&&v(w.roughnessMap.channel),anisotropyMapUv:_t&&v(w.anisotropyMap.channel),clearcoatMapUv:wt&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:Zt&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:Ot&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:Et&&v(w.sheenRoughnessMap.channel),specularMapUv:se&&v(w.specularMap.channel),specularColorMapUv:Yt&&v(w.specularColorMap.channel),specularIntensityMapUv:ge&&v(w.specularIntensityMap.channel),transmissionMapUv:k&&v(w.transmissionMap.channel),thicknessMapUv:xt&&v(w.thicknessMap.channel),alphaMapUv:rt&&v(w.alphaMap.channel),vertexTangents:!!j.attributes.tangent&&(ne||E),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!j.attributes.uv&&(he||rt),fog:!!V,useFog:w.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:w.flatShading===!0,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:Bt,skinning:N.isSkinnedMesh===!0,morphTargets:j.morphAttributes.position!==void 0,morphNormals:j.morphAttributes.normal!==void 0,morphColors:j.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:Mt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:ze,decodeVideoTexture:he&&w.map.isVideoTexture===!0&&ve.getTransfer(w.map.colorSpace)===Ce,decodeVideoTextureEmissive:me&&w.emissiveMap.isVideoTexture===!0&&ve.getTransfer(w.emissiveMap.colorSpace)===Ce,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Pi,flipSided:w.side===On,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Qt&&w.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&w.extensions.multiDraw===!0||It)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return cn.vertexUv1s=c.has(1),cn.vertexUv2s=c.has(2),cn.vertexUv3s=c.has(3),c.clear(),cn}function p(w){const S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(w.customFragmentShaderID)),w.defines!==void 0)for(const C in w.defines)S.push(C),S.push(w.defines[C]);return w.isRawShaderMaterial===!1&&(y(S,w),T(S,w),S.push(n.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function y(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function T(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}function x(w){const S=g[w.type];let C;if(S){const G=Ci[S];C=mx.clone(G.uniforms)}else C=w.uniforms;return C}function I(w,S){let C;for(let G=0,N=u.length;G<N;G++){const V=u[G];if(V.cacheKey===S){C=V,++C.usedTimes;break}}return C===void 0&&(C=new RE(n,S,w,r),u.push(C)),C}function A(w){if(--w.usedTimes===0){const S=u.indexOf(w);u[S]=u[u.length-1],u.pop(),w.destroy()}}function D(w){l.remove(w)}function U(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:x,acquireProgram:I,releaseProgram:A,releaseShaderCache:D,programs:u,dispose:U}}function UE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function IE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function _d(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function vd(){const n=[];let t=0;const e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h,f,d,g,v,m){let p=n[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},n[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.push(p):d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||IE),i.length>1&&i.sort(f||_d),s.length>1&&s.sort(f||_d)}function u(){for(let h=t,f=n.length;h<f;h++){const d=n[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function NE(){let n=new WeakMap;function t(i,s){const r=n.get(i);let o;return r===void 0?(o=new vd,n.set(i,[o])):s>=r.length?(o=new vd,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function FE(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new B,color:new ce};break;case"SpotLight":e={position:new B,direction:new B,color:new ce,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new B,color:new ce,distance:0,decay:0};break;case"HemisphereLight":e={direction:new B,skyColor:new ce,groundColor:new ce};break;case"RectAreaLight":e={color:new ce,position:new B,halfWidth:new B,halfHeight:new B};break}return n[t.id]=e,e}}}function OE(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ue};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ue};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ue,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}let kE=0;function BE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function zE(n){const t=new FE,e=OE(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);const s=new B,r=new Ie,o=new Ie;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)i.probe[w].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,y=0,T=0,x=0,I=0,A=0,D=0;c.sort(BE);for(let w=0,S=c.length;w<S;w++){const C=c[w],G=C.color,N=C.intensity,V=C.distance,j=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=G.r*N,h+=G.g*N,f+=G.b*N;else if(C.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(C.sh.coefficients[K],N);D++}else if(C.isDirectionalLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.directionalShadow[d]=tt,i.directionalShadowMap[d]=j,i.directionalShadowMatrix[d]=C.shadow.matrix,y++}i.directional[d]=K,d++}else if(C.isSpotLight){const K=t.get(C);K.position.setFromMatrixPosition(C.matrixWorld),K.color.copy(G).multiplyScalar(N),K.distance=V,K.coneCos=Math.cos(C.angle),K.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),K.decay=C.decay,i.spot[v]=K;const Q=C.shadow;if(C.map&&(i.spotLightMap[I]=C.map,I++,Q.updateMatrices(C),C.castShadow&&A++),i.spotLightMatrix[v]=Q.matrix,C.castShadow){const tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.spotShadow[v]=tt,i.spotShadowMap[v]=j,x++}v++}else if(C.isRectAreaLight){const K=t.get(C);K.color.copy(G).multiplyScalar(N),K.halfWidth.set(C.width*.5,0,0),K.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=K,m++}else if(C.isPointLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),K.distance=C.distance,K.decay=C.decay,C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,i.pointShadow[g]=tt,i.pointShadowMap[g]=j,i.pointShadowMatrix[g]=C.shadow.matrix,T++}i.point[g]=K,g++}else if(C.isHemisphereLight){const K=t.get(C);K.skyColor.copy(C.color).multiplyScalar(N),K.groundColor.copy(C.groundColor).multiplyScalar(N),i.hemi[p]=K,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=bt.LTC_FLOAT_1,i.rectAreaLTC2=bt.LTC_FLOAT_2):(i.rectAreaLTC1=bt.LTC_HALF_1,i.rectAreaLTC2=bt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;const U=i.hash;(U.directionalLength!==d||U.pointLength!==g||U.spotLength!==v||U.rectAreaLength!==m||U.hemiLength!==p||U.numDirectionalShadows!==y||U.numPointShadows!==T||U.numSpotShadows!==x||U.numSpotMaps!==I||U.numLightProbes!==D)&&(i.directional.length=d,i.spot.length=v,i.rectArea.length=m,i.point.length=g,i.hemi.length=p,i.directionalShadow.length=y,i.directionalShadowMap.length=y,i.pointShadow.length=T,i.pointShadowMap.length=T,i.spotShadow.length=x,i.spotShadowMap.length=x,i.directionalShadowMatrix.length=y,i.pointShadowMatrix.length=T,i.spotLightMatrix.length=x+I-A,i.spotLightMap.length=I,i.numSpotLightShadowsWithMaps=A,i.numLightProbes=D,U.directionalLength=d,U.pointLength=g,U.spotLength=v,U.rectAreaLength=m,U.hemiLength=p,U.numDirectionalShadows=y,U.numPointShadows=T,U.numSpotShadows=x,U.numSpotMaps=I,U.numLightProbes=D,i.version=kE++)}function l(c,u){let h=0,f=0,d=0,g=0,v=0;const m=u.matrixWorldInverse;for(let p=0,y=c.length;p<y;p++){const T=c[p];if(T.isDirectionalLight){const x=i.directional[h];x.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),h++}else if(T.isSpotLight){const x=i.spot[d];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),d++}else if(T.isRectAreaLight){const x=i.rectArea[g];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(T.width*.5,0,0),x.halfHeight.set(0,T.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),g++}else if(T.isPointLight){const x=i.point[f];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){const x=i.hemi[v];x.direction.setFromMatrixPosition(T.matrixWorld),x.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function xd(n){const t=new zE(n),e=[],i=[];function s(u){c.camera=u,e.length=0,i.length=0}function r(u){e.push(u)}function o(u){i.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function HE(n){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new xd(n),t.set(s,[a])):r>=o.length?(a=new xd(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}class GE extends Ks{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=kv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class VE extends Ks{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const WE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$E=`uniform sampler2D shadow_pass;
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
}`;function XE(n,t,e){let i=new ju;const s=new ue,r=new ue,o=new Ve,a=new GE({depthPacking:Bv}),l=new VE,c={},u=e.maxTextureSize,h={[vs]:On,[On]:vs,[Pi]:Pi},f=new xs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ue},radius:{value:4}},vertexShader:WE,fragmentShader:$E}),d=f.clone();d.defines.HORIZONTAL_PASS=1;const g=new ln;g.setAttribute("position",new Bn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new En(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Vp;let p=this.type;this.render=function(A,D,U){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;const w=n.getRenderTarget(),S=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),G=n.state;G.setBlending(ms),G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);const N=p!==Yi&&this.type===Yi,V=p===Yi&&this.type!==Yi;for(let j=0,K=A.length;j<K;j++){const Q=A[j],tt=Q.shadow;if(tt===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(tt.autoUpdate===!1&&tt.needsUpdate===!1)continue;s.copy(tt.mapSize);const ht=tt.getFrameExtents();if(s.multiply(ht),r.copy(tt.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,tt.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,tt.mapSize.y=r.y)),tt.map===null||N===!0||V===!0){const mt=this.type!==Yi?{minFilter:Mi,magFilter:Mi}:{};tt.map!==null&&tt.map.dispose(),tt.map=new Ws(s.x,s.y,mt),tt.map.texture.name=Q.name+".shadowMap",tt.camera.updateProjectionMatrix()}n.setRenderTarget(tt.map),n.clear();const ct=tt.getViewportCount();for(let mt=0;mt<ct;mt++){const Mt=tt.getViewport(mt);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),G.viewport(o),tt.updateMatrices(Q,mt),i=tt.getFrustum(),x(D,U,tt.camera,Q,this.type)}tt.isPointLightShadow!==!0&&this.type===Yi&&y(tt,U),tt.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(w,S,C)};function y(A,D){const U=t.update(v);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new Ws(s.x,s.y)),f.uniforms.shadow_pass.value=A.map.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(D,null,U,f,v,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(D,null,U,d,v,null)}function T(A,D,U,w){let S=null;const C=U.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)S=C;else if(S=U.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const G=S.uuid,N=D.uuid;let V=c[G];V===void 0&&(V={},c[G]=V);let j=V[N];j===void 0&&(j=S.clone(),V[N]=j,D.addEventListener("dispose",I)),S=j}if(S.visible=D.visible,S.wireframe=D.wireframe,w===Yi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:h[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,U.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const G=n.properties.get(S);G.light=U}return S}function x(A,D,U,w,S){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&S===Yi)&&(!A.frustumCulled||i.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(U.matrixWorldInverse,A.matrixWorld);const N=t.update(A),V=A.material;if(Array.isArray(V)){const j=N.groups;for(let K=0,Q=j.length;K<Q;K++){const tt=j[K],ht=V[tt.materialIndex];if(ht&&ht.visible){const ct=T(A,ht,w,S);A.onBeforeShadow(n,A,D,U,N,ct,tt),n.renderBufferDirect(U,null,N,ct,A,tt),A.onAfterShadow(n,A,D,U,N,ct,tt)}}}else if(V.visible){const j=T(A,V,w,S);A.onBeforeShadow(n,A,D,U,N,j,null),n.renderBufferDirect(U,null,N,j,A,null),A.onAfterShadow(n,A,D,U,N,j,null)}}const G=A.children;for(let N=0,V=G.length;N<V;N++)x(G[N],D,U,w,S)}function I(A){A.target.removeEventListener("dispose",I);for(const U in c){const w=c[U],S=A.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}const qE={[Rc]:Cc,[Pc]:Uc,[Lc]:Ic,[kr]:Dc,[Cc]:Rc,[Uc]:Pc,[Ic]:Lc,[Dc]:kr};function YE(n,t){function e(){let k=!1;const xt=new Ve;let nt=null;const rt=new Ve(0,0,0,0);return{setMask:function(Tt){nt!==Tt&&!k&&(n.colorMask(Tt,Tt,Tt,Tt),nt=Tt)},setLocked:function(Tt){k=Tt},setClear:function(Tt,At,Qt,ze,cn){cn===!0&&(Tt*=ze,At*=ze,Qt*=ze),xt.set(Tt,At,Qt,ze),rt.equals(xt)===!1&&(n.clearColor(Tt,At,Qt,ze),rt.copy(xt))},reset:function(){k=!1,nt=null,rt.set(-1,0,0,0)}}}function i(){let k=!1,xt=!1,nt=null,rt=null,Tt=null;return{setReversed:function(At){if(xt!==At){const Qt=t.get("EXT_clip_control");xt?Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.ZERO_TO_ONE_EXT):Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.NEGATIVE_ONE_TO_ONE_EXT);const ze=Tt;Tt=null,this.setClear(ze)}xt=At},getReversed:function(){return xt},setTest:function(At){At?ot(n.DEPTH_TEST):Bt(n.DEPTH_TEST)},setMask:function(At){nt!==At&&!k&&(n.depthMask(At),nt=At)},setFunc:function(At){if(xt&&(At=qE[At]),rt!==At){switch(At){case Rc:n.depthFunc(n.NEVER);break;case Cc:n.depthFunc(n.ALWAYS);break;case Pc:n.depthFunc(n.LESS);break;case kr:n.depthFunc(n.LEQUAL);break;case Lc:n.depthFunc(n.EQUAL);break;case Dc:n.depthFunc(n.GEQUAL);break;case Uc:n.depthFunc(n.GREATER);break;case Ic:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}rt=At}},setLocked:function(At){k=At},setClear:function(At){Tt!==At&&(xt&&(At=1-At),n.clearDepth(At),Tt=At)},reset:function(){k=!1,nt=null,rt=null,Tt=null,xt=!1}}}function s(){let k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Qt=null,ze=null,cn=null;return{setTest:function(Se){k||(Se?ot(n.STENCIL_TEST):Bt(n.STENCIL_TEST))},setMask:function(Se){xt!==Se&&!k&&(n.stencilMask(Se),xt=Se)},setFunc:function(Se,tn,Ue){(nt!==Se||rt!==tn||Tt!==Ue)&&(n.stencilFunc(Se,tn,Ue),nt=Se,rt=tn,Tt=Ue)},setOp:function(Se,tn,Ue){(At!==Se||Qt!==tn||ze!==Ue)&&(n.stencilOp(Se,tn,Ue),At=Se,Qt=tn,ze=Ue)},setLocked:function(Se){k=Se},setClear:function(Se){cn!==Se&&(n.clearStencil(Se),cn=Se)},reset:function(){k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Qt=null,ze=null,cn=null}}}const r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,y=null,T=null,x=null,I=null,A=null,D=new ce(0,0,0),U=0,w=!1,S=null,C=null,G=null,N=null,V=null;const j=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let K=!1,Q=0;const tt=n.getParameter(n.VERSION);tt.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(tt)[1]),K=Q>=1):tt.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(tt)[1]),K=Q>=2);let ht=null,ct={};const mt=n.getParameter(n.SCISSOR_BOX),Mt=n.getParameter(n.VIEWPORT),pt=new Ve().fromArray(mt),it=new Ve().fromArray(Mt);function at(k,xt,nt,rt){const Tt=new Uint8Array(4),At=n.createTexture();n.bindTexture(k,At),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Qt=0;Qt<nt;Qt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(xt,0,n.RGBA,1,1,rt,0,n.RGBA,n.UNSIGNED_BYTE,Tt):n.texImage2D(xt+Qt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Tt);return At}const gt={};gt[n.TEXTURE_2D]=at(n.TEXTURE_2D,n.TEXTURE_2D,1),gt[n.TEXTURE_CUBE_MAP]=at(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[n.TEXTURE_2D_ARRAY]=at(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),gt[n.TEXTURE_3D]=at(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(n.DEPTH_TEST),o.setFunc(kr),te(!1),ne(Ef),ot(n.CULL_FACE),z(ms);function ot(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Bt(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function Gt(k,xt){return h[k]!==xt?(n.bindFramebuffer(k,xt),h[k]=xt,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=xt),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=xt),!0):!1}function It(k,xt){let nt=d,rt=!1;if(k){nt=f.get(xt),nt===void 0&&(nt=[],f.set(xt,nt));const Tt=k.textures;if(nt.length!==Tt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let At=0,Qt=Tt.length;At<Qt;At++)nt[At]=n.COLOR_ATTACHMENT0+At;nt.length=Tt.length,rt=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,rt=!0);rt&&n.drawBuffers(nt)}function he(k){return g!==k?(n.useProgram(k),g=k,!0):!1}const Jt={[Os]:n.FUNC_ADD,[hv]:n.FUNC_SUBTRACT,[fv]:n.FUNC_REVERSE_SUBTRACT};Jt[dv]=n.MIN,Jt[pv]=n.MAX;const fe={[mv]:n.ZERO,[gv]:n.ONE,[_v]:n.SRC_COLOR,[Tc]:n.SRC_ALPHA,[Ev]:n.SRC_ALPHA_SATURATE,[Sv]:n.DST_COLOR,[xv]:n.DST_ALPHA,[vv]:n.ONE_MINUS_SRC_COLOR,[Ac]:n.ONE_MINUS_SRC_ALPHA,[yv]:n.ONE_MINUS_DST_COLOR,[Mv]:n.ONE_MINUS_DST_ALPHA,[bv]:n.CONSTANT_COLOR,[wv]:n.ONE_MINUS_CONSTANT_COLOR,[Tv]:n.CONSTANT_ALPHA,[Av]:n.ONE_MINUS_CONSTANT_ALPHA};function z(k,xt,nt,rt,Tt,At,Qt,ze,cn,Se){if(k===ms){v===!0&&(Bt(n.BLEND),v=!1);return}if(v===!1&&(ot(n.BLEND),v=!0),k!==uv){if(k!==m||Se!==w){if((p!==Os||x!==Os)&&(n.blendEquation(n.FUNC_ADD),p=Os,x=Os),Se)switch(k){case Rr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bf:n.blendFunc(n.ONE,n.ONE);break;case wf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Tf:n.blendFuncSeparate(n.ZERO,n.SRC_COLOR,n.ZERO,n.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}else switch(k){case Rr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bf:n.blendFunc(n.SRC_ALPHA,n.ONE);break;case wf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Tf:n.blendFunc(n.ZERO,n.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}y=null,T=null,I=null,A=null,D.set(0,0,0),U=0,m=k,w=Se}return}Tt=Tt||xt,At=At||nt,Qt=Qt||rt,(xt!==p||Tt!==x)&&(n.blendEquationSeparate(Jt[xt],Jt[Tt]),p=xt,x=Tt),(nt!==y||rt!==T||At!==I||Qt!==A)&&(n.blendFuncSeparate(fe[nt],fe[rt],fe[At],fe[Qt]),y=nt,T=rt,I=At,A=Qt),(ze.equals(D)===!1||cn!==U)&&(n.blendColor(ze.r,ze.g,ze.b,cn),D.copy(ze),U=cn),m=k,w=!1}function Qe(k,xt){k.side===Pi?Bt(n.CULL_FACE):ot(n.CULL_FACE);let nt=k.side===On;xt&&(nt=!nt),te(nt),k.blending===Rr&&k.transparent===!1?z(ms):z(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);const rt=k.stencilWrite;a.setTest(rt),rt&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),me(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?ot(n.SAMPLE_ALPHA_TO_COVERAGE):Bt(n.SAMPLE_ALPHA_TO_COVERAGE)}function te(k){S!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),S=k)}function ne(k){k!==av?(ot(n.CULL_FACE),k!==C&&(k===Ef?n.cullFace(n.BACK):k===lv?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Bt(n.CULL_FACE),C=k}function Vt(k){k!==G&&(K&&n.lineWidth(k),G=k)}function me(k,xt,nt){k?(ot(n.POLYGON_OFFSET_FILL),(N!==xt||V!==nt)&&(n.polygonOffset(xt,nt),N=xt,V=nt)):Bt(n.POLYGON_OFFSET_FILL)}function Pt(k){k?ot(n.SCISSOR_TEST):Bt(n.SCISSOR_TEST)}function P(k){k===void 0&&(k=n.TEXTURE0+j-1),ht!==k&&(n.activeTexture(k),ht=k)}function E(k,xt,nt){nt===void 0&&(ht===null?nt=n.TEXTURE0+j-1:nt=ht);let rt=ct[nt];rt===void 0&&(rt={type:void 0,texture:void 0},ct[nt]=rt),(rt.type!==k||rt.texture!==xt)&&(ht!==nt&&(n.activeTexture(nt),ht=nt),n.bindTexture(k,xt||gt[k]),rt.type=k,rt.texture=xt)}function Y(){const k=ct[ht];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function J(){try{n.compressedTexImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function W(){try{n.compressedTexImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function et(){try{n.texSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function St(){try{n.texSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function _t(){try{n.compressedTexSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function wt(){try{n.compressedTexSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Zt(){try{n.texStorage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ft(){try{n.texStorage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function vt(){try{n.texImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Nt(){try{n.texImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Ot(k){pt.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),pt.copy(k))}function Et(k){it.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),it.copy(k))}function se(k,xt){let nt=c.get(xt);nt===void 0&&(nt=new WeakMap,c.set(xt,nt));let rt=nt.get(k);rt===void 0&&(rt=n.getUniformBlockIndex(xt,k.name),nt.set(k,rt))}function Yt(k,xt){const rt=c.get(xt).get(k);l.get(xt)!==rt&&(n.uniformBlockBinding(xt,rt,k.__bindingPointIndex),l.set(xt,rt))}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},ht=null,ct={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,y=null,T=null,x=null,I=null,A=null,D=new ce(0,0,0),U=0,w=!1,S=null,C=null,G=null,N=null,V=null,pt.set(0,0,n.canvas.width,n.canvas.height),it.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:Bt,bindFramebuffer:Gt,drawBuffers:It,useProgram:he,setBlending:z,setMaterial:Qe,setFlipSided:te,setCullFace:ne,setLineWidth:Vt,setPolygonOffset:me,setScissorTest:Pt,activeTexture:P,bindTexture:E,unbindTexture:Y,compressedTexImage2D:J,compressedTexImage3D:W,texImage2D:vt,texImage3D:Nt,updateUBOMapping:se,uniformBlockBinding:Yt,texStorage2D:Zt,texStorage3D:ft,texSubImage2D:et,texSubImage3D:St,compressedTexSubImage2D:_t,compressedTexSubImage3D:wt,scissor:Ot,viewport:Et,reset:ge}}function Md(n,t,e,i){const s=KE(i);switch(e){case Yp:return n*t;case jp:return n*t;case Zp:return n*t*2;case Jp:return n*t/s.components*s.byteLength;case Xu:return n*t/s.components*s.byteLength;case Qp:return n*t*2/s.components*s.byteLength;case qu:return n*t*2/s.components*s.byteLength;case Kp:return n*t*3/s.components*s.byteLength;case vi:return n*t*4/s.components*s.byteLength;case Yu:return n*t*4/s.components*s.byteLength;case Ta:case Aa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ra:case Ca:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case zc:case Gc:return Math.max(n,16)*Math.max(t,8)/4;case Bc:case Hc:return Math.max(n,8)*Math.max(t,8)/2;case Vc:case Wc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case $c:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Xc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case qc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Yc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Kc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case jc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Zc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Qc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case tu:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case eu:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case nu:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case iu:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case su:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case ru:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Pa:case ou:case au:return Math.ceil(n/4)*Math.ceil(t/4)*16;case tm:case lu:return Math.ceil(n/4)*Math.ceil(t/4)*8;case cu:case uu:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function KE(n){switch(n){case ts:case $p:return{byteLength:1,components:1};case wo:case Xp:case Co:return{byteLength:2,components:1};case Wu:case $u:return{byteLength:2,components:4};case Vs:case Vu:case Ki:return{byteLength:4,components:1};case qp:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}function jE(n,t,e,i,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ue,u=new WeakMap;let h;const f=new WeakMap;let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,E){return d?new OffscreenCanvas(P,E):Ha("canvas")}function v(P,E,Y){let J=1;const W=Pt(P);if((W.width>Y||W.height>Y)&&(J=Y/Math.max(W.width,W.height)),J<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){const et=Math.floor(J*W.width),St=Math.floor(J*W.height);h===void 0&&(h=g(et,St));const _t=E?g(et,St):h;return _t.width=et,_t.height=St,_t.getContext("2d").drawImage(P,0,0,et,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+et+"x"+St+")."),_t}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){n.generateMipmap(P)}function y(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(P,E,Y,J,W=!1){if(P!==null){if(n[P]!==void 0)return n[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=E;if(E===n.RED&&(Y===n.FLOAT&&(et=n.R32F),Y===n.HALF_FLOAT&&(et=n.R16F),Y===n.UNSIGNED_BYTE&&(et=n.R8)),E===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.R8UI),Y===n.UNSIGNED_SHORT&&(et=n.R16UI),Y===n.UNSIGNED_INT&&(et=n.R32UI),Y===n.BYTE&&(et=n.R8I),Y===n.SHORT&&(et=n.R16I),Y===n.INT&&(et=n.R32I)),E===n.RG&&(Y===n.FLOAT&&(et=n.RG32F),Y===n.HALF_FLOAT&&(et=n.RG16F),Y===n.UNSIGNED_BYTE&&(et=n.RG8)),E===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.RG8UI),Y===n.UNSIGNED_SHORT&&(et=n.RG16UI),Y===n.UNSIGNED_INT&&(et=n.RG32UI),Y===n.BYTE&&(et=n.RG8I),Y===n.SHORT&&(et=n.RG16I),Y===n.INT&&(et=n.RG32I)),E===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(et=n.RGB16UI),Y===n.UNSIGNED_INT&&(et=n.RGB32UI),Y===n.BYTE&&(et=n.RGB8I),Y===n.SHORT&&(et=n.RGB16I),Y===n.INT&&(et=n.RGB32I)),E===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),Y===n.UNSIGNED_INT&&(et=n.RGBA32UI),Y===n.BYTE&&(et=n.RGBA8I),Y===n.SHORT&&(et=n.RGBA16I),Y===n.INT&&(et=n.RGBA32I)),E===n.RGB&&Y===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),E===n.RGBA){const St=W?sl:ve.getTransfer(J);Y===n.FLOAT&&(et=n.RGBA32F),Y===n.HALF_FLOAT&&(et=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(et=St===Ce?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(P,E){let Y;return P?E===null||E===Vs||E===Hr?Y=n.DEPTH24_STENCIL8:E===Ki?Y=n.DEPTH32F_STENCIL8:E===wo&&(Y=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Vs||E===Hr?Y=n.DEPTH_COMPONENT24:E===Ki?Y=n.DEPTH_COMPONENT32F:E===wo&&(Y=n.DEPTH_COMPONENT16),Y}function I(P,E){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==Mi&&P.minFilter!==Ui?Math.log2(Math.max(E.width,E.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?E.mipmaps.length:1}function A(P){const E=P.target;E.removeEventListener("dispose",A),U(E),E.isVideoTexture&&u.delete(E)}function D(P){const E=P.target;E.removeEventListener("dispose",D),S(E)}function U(P){const E=i.get(P);if(E.__webglInit===void 0)return;const Y=P.source,J=f.get(Y);if(J){const W=J[E.__cacheKey];W.usedTimes--,W.usedTimes===0&&w(P),Object.keys(J).length===0&&f.delete(Y)}i.remove(P)}function w(P){const E=i.get(P);n.deleteTexture(E.__webglTexture);const Y=P.source,J=f.get(Y);delete J[E.__cacheKey],o.memory.textures--}function S(P){const E=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(E.__webglFramebuffer[J]))for(let W=0;W<E.__webglFramebuffer[J].length;W++)n.deleteFramebuffer(E.__webglFramebuffer[J][W]);else n.deleteFramebuffer(E.__webglFramebuffer[J]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[J])}else{if(Array.isArray(E.__webglFramebuffer))for(let J=0;J<E.__webglFramebuffer.length;J++)n.deleteFramebuffer(E.__webglFramebuffer[J]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let J=0;J<E.__webglColorRenderbuffer.length;J++)E.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[J]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}const Y=P.textures;for(let J=0,W=Y.length;J<W;J++){const et=i.get(Y[J]);et.__webglTexture&&(n.deleteTexture(et.__webglTexture),o.memory.textures--),i.remove(Y[J])}i.remove(P)}let C=0;function G(){C=0}function N(){const P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function V(P){const E=[];return E.push(P.wrapS),E.push(P.wrapT),E.push(P.wrapR||0),E.push(P.magFilter),E.push(P.minFilter),E.push(P.anisotropy),E.push(P.internalFormat),E.push(P.format),E.push(P.type),E.push(P.generateMipmaps),E.push(P.premultiplyAlpha),E.push(P.flipY),E.push(P.unpackAlignment),E.push(P.colorSpace),E.join()}function j(P,E){const Y=i.get(P);if(P.isVideoTexture&&Vt(P),P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){const J=P.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{it(Y,P,E);return}}e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+E)}function K(P,E){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){it(Y,P,E);return}e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+E)}function Q(P,E){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){it(Y,P,E);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+E)}function tt(P,E){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){at(Y,P,E);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+E)}const ht={[Oc]:n.REPEAT,[Bs]:n.CLAMP_TO_EDGE,[kc]:n.MIRRORED_REPEAT},ct={[Mi]:n.NEAREST,[Ov]:n.NEAREST_MIPMAP_NEAREST,[qo]:n.NEAREST_MIPMAP_LINEAR,[Ui]:n.LINEAR,[Cl]:n.LINEAR_MIPMAP_NEAREST,[zs]:n.LINEAR_MIPMAP_LINEAR},mt={[Hv]:n.NEVER,[qv]:n.ALWAYS,[Gv]:n.LESS,[nm]:n.LEQUAL,[Vv]:n.EQUAL,[Xv]:n.GEQUAL,[Wv]:n.GREATER,[$v]:n.NOTEQUAL};function Mt(P,E){if(E.type===Ki&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===Ui||E.magFilter===Cl||E.magFilter===qo||E.magFilter===zs||E.minFilter===Ui||E.minFilter===Cl||E.minFilter===qo||E.minFilter===zs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ht[E.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ht[E.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ht[E.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ct[E.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ct[E.minFilter]),E.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,mt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Mi||E.minFilter!==qo&&E.minFilter!==zs||E.type===Ki&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){const Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function pt(P,E){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,E.addEventListener("dispose",A));const J=E.source;let W=f.get(J);W===void 0&&(W={},f.set(J,W));const et=V(E);if(et!==P.__cacheKey){W[et]===void 0&&(W[et]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),W[et].usedTimes++;const St=W[P.__cacheKey];St!==void 0&&(W[P.__cacheKey].usedTimes--,St.usedTimes===0&&w(E)),P.__cacheKey=et,P.__webglTexture=W[et].texture}return Y}function it(P,E,Y){let J=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(J=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(J=n.TEXTURE_3D);const W=pt(P,E),et=E.source;e.bindTexture(J,P.__webglTexture,n.TEXTURE0+Y);const St=i.get(et);if(et.version!==St.__version||W===!0){e.activeTexture(n.TEXTURE0+Y);const _t=ve.getPrimaries(ve.workingColorSpace),wt=E.colorSpace===ps?null:ve.getPrimaries(E.colorSpace),Zt=E.colorSpace===ps||_t===wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Zt);let ft=v(E.image,!1,s.maxTextureSize);ft=me(E,ft);const vt=r.convert(E.format,E.colorSpace),Nt=r.convert(E.type);let Ot=T(E.internalFormat,vt,Nt,E.colorSpace,E.isVideoTexture);Mt(J,E);let Et;const se=E.mipmaps,Yt=E.isVideoTexture!==!0,ge=St.__version===void 0||W===!0,k=et.dataReady,xt=I(E,ft);if(E.isDepthTexture)Ot=x(E.format===Gr,E.type),ge&&(Yt?e.texStorage2D(n.TEXTURE_2D,1,Ot,ft.width,ft.height):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,null));else if(E.isDataTexture)if(se.length>0){Yt&&ge&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,se[0].width,se[0].height);for(let nt=0,rt=se.length;nt<rt;nt++)Et=se[nt],Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(n.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,vt,Nt,Et.data);E.generateMipmaps=!1}else Yt?(ge&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height),k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ft.width,ft.height,vt,Nt,ft.data)):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,ft.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){Yt&&ge&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,se[0].width,se[0].height,ft.depth);for(let nt=0,rt=se.length;nt<rt;nt++)if(Et=se[nt],E.format!==vi)if(vt!==null)if(Yt){if(k)if(E.layerUpdates.size>0){const Tt=Md(Et.width,Et.height,E.format,E.type);for(const At of E.layerUpdates){const Qt=Et.data.subarray(At*Tt/Et.data.BYTES_PER_ELEMENT,(At+1)*Tt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,At,Et.width,Et.height,1,vt,Qt)}E.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,Et.width,Et.height,ft.depth,vt,Et.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,nt,Ot,Et.width,Et.height,ft.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?k&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,Et.width,Et.height,ft.depth,vt,Nt,Et.data):e.texImage3D(n.TEXTURE_2D_ARRAY,nt,Ot,Et.width,Et.height,ft.depth,0,vt,Nt,Et.data)}else{Yt&&ge&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,se[0].width,se[0].height);for(let nt=0,rt=se.length;nt<rt;nt++)Et=se[nt],E.format!==vi?vt!==null?Yt?k&&e.compressedTexSubImage2D(n.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Et.data):e.compressedTexImage2D(n.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(n.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,vt,Nt,Et.data)}else if(E.isDataArrayTexture)if(Yt){if(ge&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,ft.width,ft.height,ft.depth),k)if(E.layerUpdates.size>0){const nt=Md(ft.width,ft.height,E.format,E.type);for(const rt of E.layerUpdates){const Tt=ft.data.subarray(rt*nt/ft.data.BYTES_PER_ELEMENT,(rt+1)*nt/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,vt,Nt,Tt)}E.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(E.isData3DTexture)Yt?(ge&&e.texStorage3D(n.TEXTURE_3D,xt,Ot,ft.width,ft.height,ft.depth),k&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)):e.texImage3D(n.TEXTURE_3D,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(E.isFramebufferTexture){if(ge)if(Yt)e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height);else{let nt=ft.width,rt=ft.height;for(let Tt=0;Tt<xt;Tt++)e.texImage2D(n.TEXTURE_2D,Tt,Ot,nt,rt,0,vt,Nt,null),nt>>=1,rt>>=1}}else if(se.length>0){if(Yt&&ge){const nt=Pt(se[0]);e.texStorage2D(n.TEXTURE_2D,xt,Ot,nt.width,nt.height)}for(let nt=0,rt=se.length;nt<rt;nt++)Et=se[nt],Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,vt,Nt,Et):e.texImage2D(n.TEXTURE_2D,nt,Ot,vt,Nt,Et);E.generateMipmaps=!1}else if(Yt){if(ge){const nt=Pt(ft);e.texStorage2D(n.TEXTURE_2D,xt,Ot,nt.width,nt.height)}k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,Nt,ft)}else e.texImage2D(n.TEXTURE_2D,0,Ot,vt,Nt,ft);m(E)&&p(J),St.__version=et.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function at(P,E,Y){if(E.image.length!==6)return;const J=pt(P,E),W=E.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+Y);const et=i.get(W);if(W.version!==et.__version||J===!0){e.activeTexture(n.TEXTURE0+Y);const St=ve.getPrimaries(ve.workingColorSpace),_t=E.colorSpace===ps?null:ve.getPrimaries(E.colorSpace),wt=E.colorSpace===ps||St===_t?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,wt);const Zt=E.isCompressedTexture||E.image[0].isCompressedTexture,ft=E.image[0]&&E.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!Zt&&!ft?vt[rt]=v(E.image[rt],!0,s.maxCubemapSize):vt[rt]=ft?E.image[rt].image:E.image[rt],vt[rt]=me(E,vt[rt]);const Nt=vt[0],Ot=r.convert(E.format,E.colorSpace),Et=r.convert(E.type),se=T(E.internalFormat,Ot,Et,E.colorSpace),Yt=E.isVideoTexture!==!0,ge=et.__version===void 0||J===!0,k=W.dataReady;let xt=I(E,Nt);Mt(n.TEXTURE_CUBE_MAP,E);let nt;if(Zt){Yt&&ge&&e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,se,Nt.width,Nt.height);for(let rt=0;rt<6;rt++){nt=vt[rt].mipmaps;for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];E.format!==vi?Ot!==null?Yt?k&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,At.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,se,At.width,At.height,0,At.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,Et,At.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,se,At.width,At.height,0,Ot,Et,At.data)}}}else{if(nt=E.mipmaps,Yt&&ge){nt.length>0&&xt++;const rt=Pt(vt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,se,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ot,Et,vt[rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,se,vt[rt].width,vt[rt].height,0,Ot,Et,vt[rt].data);for(let Tt=0;Tt<nt.length;Tt++){const Qt=nt[Tt].image[rt].image;Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Qt.width,Qt.height,Ot,Et,Qt.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,se,Qt.width,Qt.height,0,Ot,Et,Qt.data)}}else{Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ot,Et,vt[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,se,Ot,Et,vt[rt]);for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Ot,Et,At.image[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,se,Ot,Et,At.image[rt])}}}m(E)&&p(n.TEXTURE_CUBE_MAP),et.__version=W.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function gt(P,E,Y,J,W,et){const St=r.convert(Y.format,Y.colorSpace),_t=r.convert(Y.type),wt=T(Y.internalFormat,St,_t,Y.colorSpace),Zt=i.get(E),ft=i.get(Y);if(ft.__renderTarget=E,!Zt.__hasExternalTextures){const vt=Math.max(1,E.width>>et),Nt=Math.max(1,E.height>>et);W===n.TEXTURE_3D||W===n.TEXTURE_2D_ARRAY?e.texImage3D(W,et,wt,vt,Nt,E.depth,0,St,_t,null):e.texImage2D(W,et,wt,vt,Nt,0,St,_t,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),ne(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,J,W,ft.__webglTexture,0,te(E)):(W===n.TEXTURE_2D||W>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,J,W,ft.__webglTexture,et),e.bindFramebuffer(n.FRAMEBUFFER,null)}function ot(P,E,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,P),E.depthBuffer){const J=E.depthTexture,W=J&&J.isDepthTexture?J.type:null,et=x(E.stencilBuffer,W),St=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=te(E);ne(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_t,et,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,_t,et,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,et,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,P)}else{const J=E.textures;for(let W=0;W<J.length;W++){const et=J[W],St=r.convert(et.format,et.colorSpace),_t=r.convert(et.type),wt=T(et.internalFormat,St,_t,et.colorSpace),Zt=te(E);Y&&ne(E)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Zt,wt,E.width,E.height):ne(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Zt,wt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,wt,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Bt(P,E){if(E&&E.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const J=i.get(E.depthTexture);J.__renderTarget=E,(!J.__webglTexture||E.depthTexture.image.width!==E.width||E.depthTexture.image.height!==E.height)&&(E.depthTexture.image.width=E.width,E.depthTexture.image.height=E.height,E.depthTexture.needsUpdate=!0),j(E.depthTexture,0);const W=J.__webglTexture,et=te(E);if(E.depthTexture.format===Cr)ne(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0);else if(E.depthTexture.format===Gr)ne(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0);else throw new Error("Unknown depthTexture format")}function Gt(P){const E=i.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==P.depthTexture){const J=P.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),J){const W=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,J.removeEventListener("dispose",W)};J.addEventListener("dispose",W),E.__depthDisposeCallback=W}E.__boundDepthTexture=J}if(P.depthTexture&&!E.__autoAllocateDepthBuffer){if(Y)throw new Error("target.depthTexture not supported in Cube render targets");Bt(E.__webglFramebuffer,P)}else if(Y){E.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[J]),E.__webglDepthbuffer[J]===void 0)E.__webglDepthbuffer[J]=n.createRenderbuffer(),ot(E.__webglDepthbuffer[J],P,!1);else{const W=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,et=E.__webglDepthbuffer[J];n.bindRenderbuffer(n.RENDERBUFFER,et),n.framebufferRenderbuffer(n.FRAMEBUFFER,W,n.RENDERBUFFER,et)}}else if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),ot(E.__webglDepthbuffer,P,!1);else{const J=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,J,n.RENDERBUFFER,W)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function It(P,E,Y){const J=i.get(P);E!==void 0&&gt(J.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&Gt(P)}function he(P){const E=P.texture,Y=i.get(P),J=i.get(E);P.addEventListener("dispose",D);const W=P.textures,et=P.isWebGLCubeRenderTarget===!0,St=W.length>1;if(St||(J.__webglTexture===void 0&&(J.__webglTexture=n.createTexture()),J.__version=E.version,o.memory.textures++),et){Y.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(E.mipmaps&&E.mipmaps.length>0){Y.__webglFramebuffer[_t]=[];for(let wt=0;wt<E.mipmaps.length;wt++)Y.__webglFramebuffer[_t][wt]=n.createFramebuffer()}else Y.__webglFramebuffer[_t]=n.createFramebuffer()}else{if(E.mipmaps&&E.mipmaps.length>0){Y.__webglFramebuffer=[];for(let _t=0;_t<E.mipmaps.length;_t++)Y.__webglFramebuffer[_t]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(St)for(let _t=0,wt=W.length;_t<wt;_t++){const Zt=i.get(W[_t]);Zt.__webglTexture===void 0&&(Zt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&ne(P)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let _t=0;_t<W.length;_t++){const wt=W[_t];Y.__webglColorRenderbuffer[_t]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[_t]);const Zt=r.convert(wt.format,wt.colorSpace),ft=r.convert(wt.type),vt=T(wt.internalFormat,Zt,ft,wt.colorSpace,P.isXRRenderTarget===!0),Nt=te(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,Nt,vt,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,Y.__webglColorRenderbuffer[_t])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),ot(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(et){e.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture),Mt(n.TEXTURE_CUBE_MAP,E);for(let _t=0;_t<6;_t++)if(E.mipmaps&&E.mipmaps.length>0)for(let wt=0;wt<E.mipmaps.length;wt++)gt(Y.__webglFramebuffer[_t][wt],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,wt);else gt(Y.__webglFramebuffer[_t],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);m(E)&&p(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let _t=0,wt=W.length;_t<wt;_t++){const Zt=W[_t],ft=i.get(Zt);e.bindTexture(n.TEXTURE_2D,ft.__webglTexture),Mt(n.TEXTURE_2D,Zt),gt(Y.__webglFramebuffer,P,Zt,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,0),m(Zt)&&p(n.TEXTURE_2D)}e.unbindTexture()}else{let _t=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(_t,J.__webglTexture),Mt(_t,E),E.mipmaps&&E.mipmaps.length>0)for(let wt=0;wt<E.mipmaps.length;wt++)gt(Y.__webglFramebuffer[wt],P,E,n.COLOR_ATTACHMENT0,_t,wt);else gt(Y.__webglFramebuffer,P,E,n.COLOR_ATTACHMENT0,_t,0);m(E)&&p(_t),e.unbindTexture()}P.depthBuffer&&Gt(P)}function Jt(P){const E=P.textures;for(let Y=0,J=E.length;Y<J;Y++){const W=E[Y];if(m(W)){const et=y(P),St=i.get(W).__webglTexture;e.bindTexture(et,St),p(et),e.unbindTexture()}}}const fe=[],z=[];function Qe(P){if(P.samples>0){if(ne(P)===!1){const E=P.textures,Y=P.width,J=P.height;let W=n.COLOR_BUFFER_BIT;const et=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(P),_t=E.length>1;if(_t)for(let wt=0;wt<E.length;wt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let wt=0;wt<E.length;wt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(W|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(W|=n.STENCIL_BUFFER_BIT)),_t){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const Zt=i.get(E[wt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,Zt,0)}n.blitFramebuffer(0,0,Y,J,0,0,Y,J,W,n.NEAREST),l===!0&&(fe.length=0,z.length=0,fe.push(n.COLOR_ATTACHMENT0+wt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(fe.push(et),z.push(et),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,z)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,fe))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),_t)for(let wt=0;wt<E.length;wt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const Zt=i.get(E[wt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.TEXTURE_2D,Zt,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){const E=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function te(P){return Math.min(s.maxSamples,P.samples)}function ne(P){const E=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Vt(P){const E=o.render.frame;u.get(P)!==E&&(u.set(P,E),P.update())}function me(P,E){const Y=P.colorSpace,J=P.format,W=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==Ys&&Y!==ps&&(ve.getTransfer(Y)===Ce?(J!==vi||W!==ts)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Y)),E}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=N,this.resetTextureUnits=G,this.setTexture2D=j,this.setTexture2DArray=K,this.setTexture3D=Q,this.setTextureCube=tt,this.rebindTextures=It,this.setupRenderTarget=he,this.updateRenderTargetMipmap=Jt,this.updateMultisampleRenderTarget=Qe,this.setupDepthRenderbuffer=Gt,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=ne}function ZE(n,t){function e(i,s=ps){let r;const o=ve.getTransfer(s);if(i===ts)return n.UNSIGNED_BYTE;if(i===Wu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===$u)return n.UNSIGNED_SHORT_5_5_5_1;if(i===qp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===$p)return n.BYTE;if(i===Xp)return n.SHORT;if(i===wo)return n.UNSIGNED_SHORT;if(i===Vu)return n.INT;if(i===Vs)return n.UNSIGNED_INT;if(i===Ki)return n.FLOAT;if(i===Co)return n.HALF_FLOAT;if(i===Yp)return n.ALPHA;if(i===Kp)return n.RGB;if(i===vi)return n.RGBA;if(i===jp)return n.LUMINANCE;if(i===Zp)return n.LUMINANCE_ALPHA;if(i===Cr)return n.DEPTH_COMPONENT;if(i===Gr)return n.DEPTH_STENCIL;if(i===Jp)return n.RED;if(i===Xu)return n.RED_INTEGER;if(i===Qp)return n.RG;if(i===qu)return n.RG_INTEGER;if(i===Yu)return n.RGBA_INTEGER;if(i===Ta||i===Aa||i===Ra||i===Ca)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ta)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ta)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ca)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Bc||i===zc||i===Hc||i===Gc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Bc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===zc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Hc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Gc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Vc||i===Wc||i===$c)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Vc||i===Wc)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===$c)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Xc||i===qc||i===Yc||i===Kc||i===jc||i===Zc||i===Jc||i===Qc||i===tu||i===eu||i===nu||i===iu||i===su||i===ru)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Xc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===qc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Yc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Kc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===jc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Zc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Jc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Qc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===tu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===eu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===nu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===iu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===su)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===ru)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Pa||i===ou||i===au)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Pa)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===ou)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===au)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===tm||i===lu||i===cu||i===uu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Pa)return r.COMPRESSED_RED_RGTC1_EXT;if(i===lu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===cu)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===uu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Hr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}class JE extends qn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class Ii extends sn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const QE={type:"move"};class ic{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ii,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ii,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ii,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(QE)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const i=new Ii;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}}const tb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,eb=`
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

}`;class nb{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,i){if(this.texture===null){const s=new kn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=i.depthNear||e.depthFar!=i.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,i=new xs({vertexShader:tb,fragmentShader:eb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new En(new rl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class ib extends Yr{constructor(t,e){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null;const v=new nb,m=e.getContextAttributes();let p=null,y=null;const T=[],x=[],I=new ue;let A=null;const D=new qn;D.viewport=new Ve;const U=new qn;U.viewport=new Ve;const w=[D,U],S=new JE;let C=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let at=T[it];return at===void 0&&(at=new ic,T[it]=at),at.getTargetRaySpace()},this.getControllerGrip=function(it){let at=T[it];return at===void 0&&(at=new ic,T[it]=at),at.getGripSpace()},this.getHand=function(it){let at=T[it];return at===void 0&&(at=new ic,T[it]=at),at.getHandSpace()};function N(it){const at=x.indexOf(it.inputSource);if(at===-1)return;const gt=T[at];gt!==void 0&&(gt.update(it.inputSource,it.frame,c||o),gt.dispatchEvent({type:it.type,data:it.inputSource}))}function V(){s.removeEventListener("select",N),s.removeEventListener("selectstart",N),s.removeEventListener("selectend",N),s.removeEventListener("squeeze",N),s.removeEventListener("squeezestart",N),s.removeEventListener("squeezeend",N),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",j);for(let it=0;it<T.length;it++){const at=x[it];at!==null&&(x[it]=null,T[it].disconnect(at))}C=null,G=null,v.reset(),t.setRenderTarget(p),d=null,f=null,h=null,s=null,y=null,pt.stop(),i.isPresenting=!1,t.setPixelRatio(A),t.setSize(I.width,I.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",N),s.addEventListener("selectstart",N),s.addEventListener("selectend",N),s.addEventListener("squeeze",N),s.addEventListener("squeezestart",N),s.addEventListener("squeezeend",N),s.addEventListener("end",V),s.addEventListener("inputsourceschange",j),m.xrCompatible!==!0&&await e.makeXRCompatible(),A=t.getPixelRatio(),t.getSize(I),s.renderState.layers===void 0){const at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),y=new Ws(d.framebufferWidth,d.framebufferHeight,{format:vi,type:ts,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,gt=null,ot=null;m.depth&&(ot=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?Gr:Cr,gt=m.stencil?Hr:Vs);const Bt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};h=new XRWebGLBinding(s,e),f=h.createProjectionLayer(Bt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),y=new Ws(f.textureWidth,f.textureHeight,{format:vi,type:ts,depthTexture:new pm(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function j(it){for(let at=0;at<it.removed.length;at++){const gt=it.removed[at],ot=x.indexOf(gt);ot>=0&&(x[ot]=null,T[ot].disconnect(gt))}for(let at=0;at<it.added.length;at++){const gt=it.added[at];let ot=x.indexOf(gt);if(ot===-1){for(let Gt=0;Gt<T.length;Gt++)if(Gt>=x.length){x.push(gt),ot=Gt;break}else if(x[Gt]===null){x[Gt]=gt,ot=Gt;break}if(ot===-1)break}const Bt=T[ot];Bt&&Bt.connect(gt)}}const K=new B,Q=new B;function tt(it,at,gt){K.setFromMatrixPosition(at.matrixWorld),Q.setFromMatrixPosition(gt.matrixWorld);const ot=K.distanceTo(Q),Bt=at.projectionMatrix.elements,Gt=gt.projectionMatrix.elements,It=Bt[14]/(Bt[10]-1),he=Bt[14]/(Bt[10]+1),Jt=(Bt[9]+1)/Bt[5],fe=(Bt[9]-1)/Bt[5],z=(Bt[8]-1)/Bt[0],Qe=(Gt[8]+1)/Gt[0],te=It*z,ne=It*Qe,Vt=ot/(-z+Qe),me=Vt*-z;if(at.matrixWorld.decompose(it.position,it.quaternion,it.scale),it.translateX(me),it.translateZ(Vt),it.matrixWorld.compose(it.position,it.quaternion,it.scale),it.matrixWorldInverse.copy(it.matrixWorld).invert(),Bt[10]===-1)it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Pt=It+Vt,P=he+Vt,E=te-me,Y=ne+(ot-me),J=Jt*he/P*Pt,W=fe*he/P*Pt;it.projectionMatrix.makePerspective(E,Y,J,W,Pt,P),it.projectionMatrixInverse.copy(it.projectionMatrix).invert()}}function ht(it,at){at===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(at.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let at=it.near,gt=it.far;v.texture!==null&&(v.depthNear>0&&(at=v.depthNear),v.depthFar>0&&(gt=v.depthFar)),S.near=U.near=D.near=at,S.far=U.far=D.far=gt,(C!==S.near||G!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,G=S.far),D.layers.mask=it.layers.mask|2,U.layers.mask=it.layers.mask|4,S.layers.mask=D.layers.mask|U.layers.mask;const ot=it.parent,Bt=S.cameras;ht(S,ot);for(let Gt=0;Gt<Bt.length;Gt++)ht(Bt[Gt],ot);Bt.length===2?tt(S,D,U):S.projectionMatrix.copy(D.projectionMatrix),ct(it,S,ot)};function ct(it,at,gt){gt===null?it.matrix.copy(at.matrixWorld):(it.matrix.copy(gt.matrixWorld),it.matrix.invert(),it.matrix.multiply(at.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=hu*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(it){l=it,f!==null&&(f.fixedFoveation=it),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=it)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let mt=null;function Mt(it,at){if(u=at.getViewerPose(c||o),g=at,u!==null){const gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(y,d.framebuffer),t.setRenderTarget(y));let ot=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Gt=0;Gt<gt.length;Gt++){const It=gt[Gt];let he=null;if(d!==null)he=d.getViewport(It);else{const fe=h.getViewSubImage(f,It);he=fe.viewport,Gt===0&&(t.setRenderTargetTextures(y,fe.colorTexture,f.ignoreDepthValues?void 0:fe.depthStencilTexture),t.setRenderTarget(y))}let Jt=w[Gt];Jt===void 0&&(Jt=new qn,Jt.layers.enable(Gt),Jt.viewport=new Ve,w[Gt]=Jt),Jt.matrix.fromArray(It.transform.matrix),Jt.matrix.decompose(Jt.position,Jt.quaternion,Jt.scale),Jt.projectionMatrix.fromArray(It.projectionMatrix),Jt.projectionMatrixInverse.copy(Jt.projectionMatrix).invert(),Jt.viewport.set(he.x,he.y,he.width,he.height),Gt===0&&(S.matrix.copy(Jt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(Jt)}const Bt=s.enabledFeatures;if(Bt&&Bt.includes("depth-sensing")){const Gt=h.getDepthInformation(gt[0]);Gt&&Gt.isValid&&Gt.texture&&v.init(t,Gt,s.renderState)}}for(let gt=0;gt<T.length;gt++){const ot=x[gt],Bt=T[gt];ot!==null&&Bt!==void 0&&Bt.update(ot,at,c||o)}mt&&mt(it,at),at.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:at}),g=null}const pt=new dm;pt.setAnimationLoop(Mt),this.setAnimationLoop=function(it){mt=it},this.dispose=function(){}}}const Ls=new ki,sb=new Ie;function rb(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,um(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,T,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,x)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===On&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===On&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const y=t.get(p),T=y.envMap,x=y.envMapRotation;T&&(m.envMap.value=T,Ls.copy(x),Ls.x*=-1,Ls.y*=-1,Ls.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(Ls.y*=-1,Ls.z*=-1),m.envMapRotation.value.setFromMatrix4(sb.makeRotationFromEuler(Ls)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=T*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,y){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===On&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const y=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function ob(n,t,e,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(y,T){const x=T.program;i.uniformBlockBinding(y,x)}function c(y,T){let x=s[y.id];x===void 0&&(g(y),x=u(y),s[y.id]=x,y.addEventListener("dispose",m));const I=T.program;i.updateUBOMapping(y,I);const A=t.render.frame;r[y.id]!==A&&(f(y),r[y.id]=A)}function u(y){const T=h();y.__bindingPointIndex=T;const x=n.createBuffer(),I=y.__size,A=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,x),n.bufferData(n.UNIFORM_BUFFER,I,A),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,T,x),x}function h(){for(let y=0;y<a;y++)if(o.indexOf(y)===-1)return o.push(y),y;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(y){const T=s[y.id],x=y.uniforms,I=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,D=x.length;A<D;A++){const U=Array.isArray(x[A])?x[A]:[x[A]];for(let w=0,S=U.length;w<S;w++){const C=U[w];if(d(C,A,w,I)===!0){const G=C.__offset,N=Array.isArray(C.value)?C.value:[C.value];let V=0;for(let j=0;j<N.length;j++){const K=N[j],Q=v(K);typeof K=="number"||typeof K=="boolean"?(C.__data[0]=K,n.bufferSubData(n.UNIFORM_BUFFER,G+V,C.__data)):K.isMatrix3?(C.__data[0]=K.elements[0],C.__data[1]=K.elements[1],C.__data[2]=K.elements[2],C.__data[3]=0,C.__data[4]=K.elements[3],C.__data[5]=K.elements[4],C.__data[6]=K.elements[5],C.__data[7]=0,C.__data[8]=K.elements[6],C.__data[9]=K.elements[7],C.__data[10]=K.elements[8],C.__data[11]=0):(K.toArray(C.__data,V),V+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,G,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(y,T,x,I){const A=y.value,D=T+"_"+x;if(I[D]===void 0)return typeof A=="number"||typeof A=="boolean"?I[D]=A:I[D]=A.clone(),!0;{const U=I[D];if(typeof A=="number"||typeof A=="boolean"){if(U!==A)return I[D]=A,!0}else if(U.equals(A)===!1)return U.copy(A),!0}return!1}function g(y){const T=y.uniforms;let x=0;const I=16;for(let D=0,U=T.length;D<U;D++){const w=Array.isArray(T[D])?T[D]:[T[D]];for(let S=0,C=w.length;S<C;S++){const G=w[S],N=Array.isArray(G.value)?G.value:[G.value];for(let V=0,j=N.length;V<j;V++){const K=N[V],Q=v(K),tt=x%I,ht=tt%Q.boundary,ct=tt+ht;x+=ht,ct!==0&&I-ct<Q.storage&&(x+=I-ct),G.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),G.__offset=x,x+=Q.storage}}}const A=x%I;return A>0&&(x+=I-A),y.__size=x,y.__cache={},this}function v(y){const T={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(T.boundary=4,T.storage=4):y.isVector2?(T.boundary=8,T.storage=8):y.isVector3||y.isColor?(T.boundary=16,T.storage=12):y.isVector4?(T.boundary=16,T.storage=16):y.isMatrix3?(T.boundary=48,T.storage=48):y.isMatrix4?(T.boundary=64,T.storage=64):y.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",y),T}function m(y){const T=y.target;T.removeEventListener("dispose",m);const x=o.indexOf(T.__bindingPointIndex);o.splice(x,1),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(const y in s)n.deleteBuffer(s[y]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class ab{constructor(t={}){const{canvas:e=Kv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=i.getContextAttributes().alpha}else d=o;const g=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const y=[],T=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=ri,this.toneMapping=gs,this.toneMappingExposure=1;const x=this;let I=!1,A=0,D=0,U=null,w=-1,S=null;const C=new Ve,G=new Ve;let N=null;const V=new ce(0);let j=0,K=e.width,Q=e.height,tt=1,ht=null,ct=null;const mt=new Ve(0,0,K,Q),Mt=new Ve(0,0,K,Q);let pt=!1;const it=new ju;let at=!1,gt=!1;const ot=new Ie,Bt=new Ie,Gt=new B,It=new Ve,he={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Jt=!1;function fe(){return U===null?tt:1}let z=i;function Qe(b,O){return e.getContext(b,O)}try{const b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Hu}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",Tt,!1),e.addEventListener("webglcontextcreationerror",At,!1),z===null){const O="webgl2";if(z=Qe(O,b),z===null)throw Qe(O)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(b){throw console.error("THREE.WebGLRenderer: "+b.message),b}let te,ne,Vt,me,Pt,P,E,Y,J,W,et,St,_t,wt,Zt,ft,vt,Nt,Ot,Et,se,Yt,ge,k;function xt(){te=new fy(z),te.init(),Yt=new ZE(z,te),ne=new oy(z,te,t,Yt),Vt=new YE(z,te),ne.reverseDepthBuffer&&f&&Vt.buffers.depth.setReversed(!0),me=new my(z),Pt=new UE,P=new jE(z,te,Vt,Pt,ne,Yt,me),E=new ly(x),Y=new hy(x),J=new yx(z),ge=new sy(z,J),W=new dy(z,J,me,ge),et=new _y(z,W,J,me),Ot=new gy(z,ne,P),ft=new ay(Pt),St=new DE(x,E,Y,te,ne,ge,ft),_t=new rb(x,Pt),wt=new NE,Zt=new HE(te),Nt=new iy(x,E,Y,Vt,et,d,l),vt=new XE(x,et,ne),k=new ob(z,me,ne,Vt),Et=new ry(z,te,me),se=new py(z,te,me),me.programs=St.programs,x.capabilities=ne,x.extensions=te,x.properties=Pt,x.renderLists=wt,x.shadowMap=vt,x.state=Vt,x.info=me}xt();const nt=new ib(x,z);this.xr=nt,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){const b=te.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=te.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return tt},this.setPixelRatio=function(b){b!==void 0&&(tt=b,this.setSize(K,Q,!1))},this.getSize=function(b){return b.set(K,Q)},this.setSize=function(b,O,$=!0){if(nt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=b,Q=O,e.width=Math.floor(b*tt),e.height=Math.floor(O*tt),$===!0&&(e.style.width=b+"px",e.style.height=O+"px"),this.setViewport(0,0,b,O)},this.getDrawingBufferSize=function(b){return b.set(K*tt,Q*tt).floor()},this.setDrawingBufferSize=function(b,O,$){K=b,Q=O,tt=$,e.width=Math.floor(b*$),e.height=Math.floor(O*$),this.setViewport(0,0,b,O)},this.getCurrentViewport=function(b){return b.copy(C)},this.getViewport=function(b){return b.copy(mt)},this.setViewport=function(b,O,$,X){b.isVector4?mt.set(b.x,b.y,b.z,b.w):mt.set(b,O,$,X),Vt.viewport(C.copy(mt).multiplyScalar(tt).round())},this.getScissor=function(b){return b.copy(Mt)},this.setScissor=function(b,O,$,X){b.isVector4?Mt.set(b.x,b.y,b.z,b.w):Mt.set(b,O,$,X),Vt.scissor(G.copy(Mt).multiplyScalar(tt).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(b){Vt.setScissorTest(pt=b)},this.setOpaqueSort=function(b){ht=b},this.setTransparentSort=function(b){ct=b},this.getClearColor=function(b){return b.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(b=!0,O=!0,$=!0){let X=0;if(b){let H=!1;if(U!==null){const ut=U.texture.format;H=ut===Yu||ut===qu||ut===Xu}if(H){const ut=U.texture.type,yt=ut===ts||ut===Vs||ut===wo||ut===Hr||ut===Wu||ut===$u,Ft=Nt.getClearColor(),Dt=Nt.getClearAlpha(),Wt=Ft.r,qt=Ft.g,Ut=Ft.b;yt?(g[0]=Wt,g[1]=qt,g[2]=Ut,g[3]=Dt,z.clearBufferuiv(z.COLOR,0,g)):(v[0]=Wt,v[1]=qt,v[2]=Ut,v[3]=Dt,z.clearBufferiv(z.COLOR,0,v))}else X|=z.COLOR_BUFFER_BIT}O&&(X|=z.DEPTH_BUFFER_BIT),$&&(X|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),z.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",Tt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),wt.dispose(),Zt.dispose(),Pt.dispose(),E.dispose(),Y.dispose(),et.dispose(),ge.dispose(),k.dispose(),St.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",zn),nt.removeEventListener("sessionend",Bi),In.stop()};function rt(b){b.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function Tt(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;const b=me.autoReset,O=vt.enabled,$=vt.autoUpdate,X=vt.needsUpdate,H=vt.type;xt(),me.autoReset=b,vt.enabled=O,vt.autoUpdate=$,vt.needsUpdate=X,vt.type=H}function At(b){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function Qt(b){const O=b.target;O.removeEventListener("dispose",Qt),ze(O)}function ze(b){cn(b),Pt.remove(b)}function cn(b){const O=Pt.get(b).programs;O!==void 0&&(O.forEach(function($){St.releaseProgram($)}),b.isShaderMaterial&&St.releaseShaderCache(b))}this.renderBufferDirect=function(b,O,$,X,H,ut){O===null&&(O=he);const yt=H.isMesh&&H.matrixWorld.determinant()<0,Ft=ll(b,O,$,X,H);Vt.setMaterial(X,yt);let Dt=$.index,Wt=1;if(X.wireframe===!0){if(Dt=W.getWireframeAttribute($),Dt===void 0)return;Wt=2}const qt=$.drawRange,Ut=$.attributes.position;let ae=qt.start*Wt,be=(qt.start+qt.count)*Wt;ut!==null&&(ae=Math.max(ae,ut.start*Wt),be=Math.min(be,(ut.start+ut.count)*Wt)),Dt!==null?(ae=Math.max(ae,0),be=Math.min(be,Dt.count)):Ut!=null&&(ae=Math.max(ae,0),be=Math.min(be,Ut.count));const Ae=be-ae;if(Ae<0||Ae===1/0)return;ge.setup(H,X,Ft,$,Dt);let un,de=Et;if(Dt!==null&&(un=J.get(Dt),de=se,de.setIndex(un)),H.isMesh)X.wireframe===!0?(Vt.setLineWidth(X.wireframeLinewidth*fe()),de.setMode(z.LINES)):de.setMode(z.TRIANGLES);else if(H.isLine){let kt=X.linewidth;kt===void 0&&(kt=1),Vt.setLineWidth(kt*fe()),H.isLineSegments?de.setMode(z.LINES):H.isLineLoop?de.setMode(z.LINE_LOOP):de.setMode(z.LINE_STRIP)}else H.isPoints?de.setMode(z.POINTS):H.isSprite&&de.setMode(z.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)de.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(te.get("WEBGL_multi_draw"))de.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const kt=H._multiDrawStarts,He=H._multiDrawCounts,_e=H._multiDrawCount,Nn=Dt?J.get(Dt).bytesPerElement:1,yi=Pt.get(X).currentProgram.getUniforms();for(let xn=0;xn<_e;xn++)yi.setValue(z,"_gl_DrawID",xn),de.render(kt[xn]/Nn,He[xn])}else if(H.isInstancedMesh)de.renderInstances(ae,Ae,H.count);else if($.isInstancedBufferGeometry){const kt=$._maxInstanceCount!==void 0?$._maxInstanceCount:1/0,He=Math.min($.instanceCount,kt);de.renderInstances(ae,Ae,He)}else de.render(ae,Ae)};function Se(b,O,$){b.transparent===!0&&b.side===Pi&&b.forceSinglePass===!1?(b.side=On,b.needsUpdate=!0,js(b,O,$),b.side=vs,b.needsUpdate=!0,js(b,O,$),b.side=Pi):js(b,O,$)}this.compile=function(b,O,$=null){$===null&&($=b),p=Zt.get($),p.init(O),T.push(p),$.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),b!==$&&b.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),p.setupLights();const X=new Set;return b.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const ut=H.material;if(ut)if(Array.isArray(ut))for(let yt=0;yt<ut.length;yt++){const Ft=ut[yt];Se(Ft,$,H),X.add(Ft)}else Se(ut,$,H),X.add(ut)}),T.pop(),p=null,X},this.compileAsync=function(b,O,$=null){const X=this.compile(b,O,$);return new Promise(H=>{function ut(){if(X.forEach(function(yt){Pt.get(yt).currentProgram.isReady()&&X.delete(yt)}),X.size===0){H(b);return}setTimeout(ut,10)}te.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let tn=null;function Ue(b){tn&&tn(b)}function zn(){In.stop()}function Bi(){In.start()}const In=new dm;In.setAnimationLoop(Ue),typeof self<"u"&&In.setContext(self),this.setAnimationLoop=function(b){tn=b,nt.setAnimationLoop(b),b===null?In.stop():In.start()},nt.addEventListener("sessionstart",zn),nt.addEventListener("sessionend",Bi),this.render=function(b,O){if(O!==void 0&&O.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(O),O=nt.getCamera()),b.isScene===!0&&b.onBeforeRender(x,b,O,U),p=Zt.get(b,T.length),p.init(O),T.push(p),Bt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),it.setFromProjectionMatrix(Bt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),m=wt.get(b,y.length),m.init(),y.push(m),nt.enabled===!0&&nt.isPresenting===!0){const ut=x.xr.getDepthSensingMesh();ut!==null&&vn(ut,O,-1/0,x.sortObjects)}vn(b,O,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(ht,ct),Jt=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Jt&&Nt.addToRenderList(m,b),this.info.render.frame++,at===!0&&ft.beginShadows();const $=p.state.shadowsArray;vt.render($,b,O),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const X=m.opaque,H=m.transmissive;if(p.setupLights(),O.isArrayCamera){const ut=O.cameras;if(H.length>0)for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Hi(X,H,b,Dt)}Jt&&Nt.render(b);for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];zi(m,b,Dt,Dt.viewport)}}else H.length>0&&Hi(X,H,b,O),Jt&&Nt.render(b),zi(m,b,O);U!==null&&(P.updateMultisampleRenderTarget(U),P.updateRenderTargetMipmap(U)),b.isScene===!0&&b.onAfterRender(x,b,O),ge.resetDefaultState(),w=-1,S=null,T.pop(),T.length>0?(p=T[T.length-1],at===!0&&ft.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,y.pop(),y.length>0?m=y[y.length-1]:m=null};function vn(b,O,$,X){if(b.visible===!1)return;if(b.layers.test(O.layers)){if(b.isGroup)$=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(O);else if(b.isLight)p.pushLight(b),b.castShadow&&p.pushShadow(b);else if(b.isSprite){if(!b.frustumCulled||it.intersectsSprite(b)){X&&It.setFromMatrixPosition(b.matrixWorld).applyMatrix4(Bt);const yt=et.update(b),Ft=b.material;Ft.visible&&m.push(b,yt,Ft,$,It.z,null)}}else if((b.isMesh||b.isLine||b.isPoints)&&(!b.frustumCulled||it.intersectsObject(b))){const yt=et.update(b),Ft=b.material;if(X&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),It.copy(b.boundingSphere.center)):(yt.boundingSphere===null&&yt.computeBoundingSphere(),It.copy(yt.boundingSphere.center)),It.applyMatrix4(b.matrixWorld).applyMatrix4(Bt)),Array.isArray(Ft)){const Dt=yt.groups;for(let Wt=0,qt=Dt.length;Wt<qt;Wt++){const Ut=Dt[Wt],ae=Ft[Ut.materialIndex];ae&&ae.visible&&m.push(b,yt,ae,$,It.z,Ut)}}else Ft.visible&&m.push(b,yt,Ft,$,It.z,null)}}const ut=b.children;for(let yt=0,Ft=ut.length;yt<Ft;yt++)vn(ut[yt],O,$,X)}function zi(b,O,$,X){const H=b.opaque,ut=b.transmissive,yt=b.transparent;p.setupLightsView($),at===!0&&ft.setGlobalState(x.clippingPlanes,$),X&&Vt.viewport(C.copy(X)),H.length>0&&Ms(H,O,$),ut.length>0&&Ms(ut,O,$),yt.length>0&&Ms(yt,O,$),Vt.buffers.depth.setTest(!0),Vt.buffers.depth.setMask(!0),Vt.buffers.color.setMask(!0),Vt.setPolygonOffset(!1)}function Hi(b,O,$,X){if(($.isScene===!0?$.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[X.id]===void 0&&(p.state.transmissionRenderTarget[X.id]=new Ws(1,1,{generateMipmaps:!0,type:te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float")?Co:ts,minFilter:zs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ve.workingColorSpace}));const ut=p.state.transmissionRenderTarget[X.id],yt=X.viewport||C;ut.setSize(yt.z,yt.w);const Ft=x.getRenderTarget();x.setRenderTarget(ut),x.getClearColor(V),j=x.getClearAlpha(),j<1&&x.setClearColor(16777215,.5),x.clear(),Jt&&Nt.render($);const Dt=x.toneMapping;x.toneMapping=gs;const Wt=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),p.setupLightsView(X),at===!0&&ft.setGlobalState(x.clippingPlanes,X),Ms(b,$,X),P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut),te.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ut=0,ae=O.length;Ut<ae;Ut++){const be=O[Ut],Ae=be.object,un=be.geometry,de=be.material,kt=be.group;if(de.side===Pi&&Ae.layers.test(X.layers)){const He=de.side;de.side=On,de.needsUpdate=!0,to(Ae,$,X,un,de,kt),de.side=He,de.needsUpdate=!0,qt=!0}}qt===!0&&(P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut))}x.setRenderTarget(Ft),x.setClearColor(V,j),Wt!==void 0&&(X.viewport=Wt),x.toneMapping=Dt}function Ms(b,O,$){const X=O.isScene===!0?O.overrideMaterial:null;for(let H=0,ut=b.length;H<ut;H++){const yt=b[H],Ft=yt.object,Dt=yt.geometry,Wt=X===null?yt.material:X,qt=yt.group;Ft.layers.test($.layers)&&to(Ft,O,$,Dt,Wt,qt)}}function to(b,O,$,X,H,ut){b.onBeforeRender(x,O,$,X,H,ut),b.modelViewMatrix.multiplyMatrices($.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),H.onBeforeRender(x,O,$,X,b,ut),H.transparent===!0&&H.side===Pi&&H.forceSinglePass===!1?(H.side=On,H.needsUpdate=!0,x.renderBufferDirect($,O,X,H,b,ut),H.side=vs,H.needsUpdate=!0,x.renderBufferDirect($,O,X,H,b,ut),H.side=Pi):x.renderBufferDirect($,O,X,H,b,ut),b.onAfterRender(x,O,$,X,H,ut)}function js(b,O,$){O.isScene!==!0&&(O=he);const X=Pt.get(b),H=p.state.lights,ut=p.state.shadowsArray,yt=H.state.version,Ft=St.getParameters(b,H.state,ut,O,$),Dt=St.getProgramCacheKey(Ft);let Wt=X.programs;X.environment=b.isMeshStandardMaterial?O.environment:null,X.fog=O.fog,X.envMap=(b.isMeshStandardMaterial?Y:E).get(b.envMap||X.environment),X.envMapRotation=X.environment!==null&&b.envMap===null?O.environmentRotation:b.envMapRotation,Wt===void 0&&(b.addEventListener("dispose",Qt),Wt=new Map,X.programs=Wt);let qt=Wt.get(Dt);if(qt!==void 0){if(X.currentProgram===qt&&X.lightsStateVersion===yt)return Si(b,Ft),qt}else Ft.uniforms=St.getUniforms(b),b.onBeforeCompile(Ft,x),qt=St.acquireProgram(Ft,Dt),Wt.set(Dt,qt),X.uniforms=Ft.uniforms;const Ut=X.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(Ut.clippingPlanes=ft.uniform),Si(b,Ft),X.needsLights=No(b),X.lightsStateVersion=yt,X.needsLights&&(Ut.ambientLightColor.value=H.state.ambient,Ut.lightProbe.value=H.state.probe,Ut.directionalLights.value=H.state.directional,Ut.directionalLightShadows.value=H.state.directionalShadow,Ut.spotLights.value=H.state.spot,Ut.spotLightShadows.value=H.state.spotShadow,Ut.rectAreaLights.value=H.state.rectArea,Ut.ltc_1.value=H.state.rectAreaLTC1,Ut.ltc_2.value=H.state.rectAreaLTC2,Ut.pointLights.value=H.state.point,Ut.pointLightShadows.value=H.state.pointShadow,Ut.hemisphereLights.value=H.state.hemi,Ut.directionalShadowMap.value=H.state.directionalShadowMap,Ut.directionalShadowMatrix.value=H.state.directionalShadowMatrix,Ut.spotShadowMap.value=H.state.spotShadowMap,Ut.spotLightMatrix.value=H.state.spotLightMatrix,Ut.spotLightMap.value=H.state.spotLightMap,Ut.pointShadowMap.value=H.state.pointShadowMap,Ut.pointShadowMatrix.value=H.state.pointShadowMatrix),X.currentProgram=qt,X.uniformsList=null,qt}function Io(b){if(b.uniformsList===null){const O=b.currentProgram.getUniforms();b.uniformsList=Da.seqWithValue(O.seq,b.uniforms)}return b.uniformsList}function Si(b,O){const $=Pt.get(b);$.outputColorSpace=O.outputColorSpace,$.batching=O.batching,$.batchingColor=O.batchingColor,$.instancing=O.instancing,$.instancingColor=O.instancingColor,$.instancingMorph=O.instancingMorph,$.skinning=O.skinning,$.morphTargets=O.morphTargets,$.morphNormals=O.morphNormals,$.morphColors=O.morphColors,$.morphTargetsCount=O.morphTargetsCount,$.numClippingPlanes=O.numClippingPlanes,$.numIntersection=O.numClipIntersection,$.vertexAlphas=O.vertexAlphas,$.vertexTangents=O.vertexTangents,$.toneMapping=O.toneMapping}function ll(b,O,$,X,H){O.isScene!==!0&&(O=he),P.resetTextureUnits();const ut=O.fog,yt=X.isMeshStandardMaterial?O.environment:null,Ft=U===null?x.outputColorSpace:U.isXRRenderTarget===!0?U.texture.colorSpace:Ys,Dt=(X.isMeshStandardMaterial?Y:E).get(X.envMap||yt),Wt=X.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,qt=!!$.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Ut=!!$.morphAttributes.position,ae=!!$.morphAttributes.normal,be=!!$.morphAttributes.color;let Ae=gs;X.toneMapped&&(U===null||U.isXRRenderTarget===!0)&&(Ae=x.toneMapping);const un=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,de=un!==void 0?un.length:0,kt=Pt.get(X),He=p.state.lights;if(at===!0&&(gt===!0||b!==S)){const wn=b===S&&X.id===w;ft.setState(X,b,wn)}let _e=!1;X.version===kt.__version?(kt.needsLights&&kt.lightsStateVersion!==He.state.version||kt.outputColorSpace!==Ft||H.isBatchedMesh&&kt.batching===!1||!H.isBatchedMesh&&kt.batching===!0||H.isBatchedMesh&&kt.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&kt.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&kt.instancing===!1||!H.isInstancedMesh&&kt.instancing===!0||H.isSkinnedMesh&&kt.skinning===!1||!H.isSkinnedMesh&&kt.skinning===!0||H.isInstancedMesh&&kt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&kt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&kt.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&kt.instancingMorph===!1&&H.morphTexture!==null||kt.envMap!==Dt||X.fog===!0&&kt.fog!==ut||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==ft.numPlanes||kt.numIntersection!==ft.numIntersection)||kt.vertexAlphas!==Wt||kt.vertexTangents!==qt||kt.morphTargets!==Ut||kt.morphNormals!==ae||kt.morphColors!==be||kt.toneMapping!==Ae||kt.morphTargetsCount!==de)&&(_e=!0):(_e=!0,kt.__version=X.version);let Nn=kt.currentProgram;_e===!0&&(Nn=js(X,O,H));let yi=!1,xn=!1,ys=!1;const Pe=Nn.getUniforms(),Jn=kt.uniforms;if(Vt.useProgram(Nn.program)&&(yi=!0,xn=!0,ys=!0),X.id!==w&&(w=X.id,xn=!0),yi||S!==b){Vt.buffers.depth.getReversed()?(ot.copy(b.projectionMatrix),Zv(ot),Jv(ot),Pe.setValue(z,"projectionMatrix",ot)):Pe.setValue(z,"projectionMatrix",b.projectionMatrix),Pe.setValue(z,"viewMatrix",b.matrixWorldInverse);const Ei=Pe.map.cameraPosition;Ei!==void 0&&Ei.setValue(z,Gt.setFromMatrixPosition(b.matrixWorld)),ne.logarithmicDepthBuffer&&Pe.setValue(z,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&Pe.setValue(z,"isOrthographic",b.isOrthographicCamera===!0),S!==b&&(S=b,xn=!0,ys=!0)}if(H.isSkinnedMesh){Pe.setOptional(z,H,"bindMatrix"),Pe.setOptional(z,H,"bindMatrixInverse");const wn=H.skeleton;wn&&(wn.boneTexture===null&&wn.computeBoneTexture(),Pe.setValue(z,"boneTexture",wn.boneTexture,P))}H.isBatchedMesh&&(Pe.setOptional(z,H,"batchingTexture"),Pe.setValue(z,"batchingTexture",H._matricesTexture,P),Pe.setOptional(z,H,"batchingIdTexture"),Pe.setValue(z,"batchingIdTexture",H._indirectTexture,P),Pe.setOptional(z,H,"batchingColorTexture"),H._colorsTexture!==null&&Pe.setValue(z,"batchingColorTexture",H._colorsTexture,P));const ns=$.morphAttributes;if((ns.position!==void 0||ns.normal!==void 0||ns.color!==void 0)&&Ot.update(H,$,Nn),(xn||kt.receiveShadow!==H.receiveShadow)&&(kt.receiveShadow=H.receiveShadow,Pe.setValue(z,"receiveShadow",H.receiveShadow)),X.isMeshGouraudMaterial&&X.envMap!==null&&(Jn.envMap.value=Dt,Jn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),X.isMeshStandardMaterial&&X.envMap===null&&O.environment!==null&&(Jn.envMapIntensity.value=O.environmentIntensity),xn&&(Pe.setValue(z,"toneMappingExposure",x.toneMappingExposure),kt.needsLights&&Ss(Jn,ys),ut&&X.fog===!0&&_t.refreshFogUniforms(Jn,ut),_t.refreshMaterialUniforms(Jn,X,tt,Q,p.state.transmissionRenderTarget[b.id]),Da.upload(z,Io(kt),Jn,P)),X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(Da.upload(z,Io(kt),Jn,P),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&Pe.setValue(z,"center",H.center),Pe.setValue(z,"modelViewMatrix",H.modelViewMatrix),Pe.setValue(z,"normalMatrix",H.normalMatrix),Pe.setValue(z,"modelMatrix",H.matrixWorld),X.isShaderMaterial||X.isRawShaderMaterial){const wn=X.uniformsGroups;for(let Ei=0,ci=wn.length;Ei<ci;Ei++){const Zs=wn[Ei];k.update(Zs,Nn),k.bind(Zs,Nn)}}return Nn}function Ss(b,O){b.ambientLightColor.needsUpdate=O,b.lightProbe.needsUpdate=O,b.directionalLights.needsUpdate=O,b.directionalLightShadows.needsUpdate=O,b.pointLights.needsUpdate=O,b.pointLightShadows.needsUpdate=O,b.spotLights.needsUpdate=O,b.spotLightShadows.needsUpdate=O,b.rectAreaLights.needsUpdate=O,b.hemisphereLights.needsUpdate=O}function No(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return U},this.setRenderTargetTextures=function(b,O,$){Pt.get(b.texture).__webglTexture=O,Pt.get(b.depthTexture).__webglTexture=$;const X=Pt.get(b);X.__hasExternalTextures=!0,X.__autoAllocateDepthBuffer=$===void 0,X.__autoAllocateDepthBuffer||te.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),X.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(b,O){const $=Pt.get(b);$.__webglFramebuffer=O,$.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(b,O=0,$=0){U=b,A=O,D=$;let X=!0,H=null,ut=!1,yt=!1;if(b){const Dt=Pt.get(b);if(Dt.__useDefaultFramebuffer!==void 0)Vt.bindFramebuffer(z.FRAMEBUFFER,null),X=!1;else if(Dt.__webglFramebuffer===void 0)P.setupRenderTarget(b);else if(Dt.__hasExternalTextures)P.rebindTextures(b,Pt.get(b.texture).__webglTexture,Pt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const Ut=b.depthTexture;if(Dt.__boundDepthTexture!==Ut){if(Ut!==null&&Pt.has(Ut)&&(b.width!==Ut.image.width||b.height!==Ut.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(b)}}const Wt=b.texture;(Wt.isData3DTexture||Wt.isDataArrayTexture||Wt.isCompressedArrayTexture)&&(yt=!0);const qt=Pt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(qt[O])?H=qt[O][$]:H=qt[O],ut=!0):b.samples>0&&P.useMultisampledRTT(b)===!1?H=Pt.get(b).__webglMultisampledFramebuffer:Array.isArray(qt)?H=qt[$]:H=qt,C.copy(b.viewport),G.copy(b.scissor),N=b.scissorTest}else C.copy(mt).multiplyScalar(tt).floor(),G.copy(Mt).multiplyScalar(tt).floor(),N=pt;if(Vt.bindFramebuffer(z.FRAMEBUFFER,H)&&X&&Vt.drawBuffers(b,H),Vt.viewport(C),Vt.scissor(G),Vt.setScissorTest(N),ut){const Dt=Pt.get(b.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+O,Dt.__webglTexture,$)}else if(yt){const Dt=Pt.get(b.texture),Wt=O||0;z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,Dt.__webglTexture,$||0,Wt)}w=-1},this.readRenderTargetPixels=function(b,O,$,X,H,ut,yt){if(!(b&&b.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){Vt.bindFramebuffer(z.FRAMEBUFFER,Ft);try{const Dt=b.texture,Wt=Dt.format,qt=Dt.type;if(!ne.textureFormatReadable(Wt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!ne.textureTypeReadable(qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=b.width-X&&$>=0&&$<=b.height-H&&z.readPixels(O,$,X,H,Yt.convert(Wt),Yt.convert(qt),ut)}finally{const Dt=U!==null?Pt.get(U).__webglFramebuffer:null;Vt.bindFramebuffer(z.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(b,O,$,X,H,ut,yt){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){const Dt=b.texture,Wt=Dt.format,qt=Dt.type;if(!ne.textureFormatReadable(Wt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!ne.textureTypeReadable(qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(O>=0&&O<=b.width-X&&$>=0&&$<=b.height-H){Vt.bindFramebuffer(z.FRAMEBUFFER,Ft);const Ut=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,Ut),z.bufferData(z.PIXEL_PACK_BUFFER,ut.byteLength,z.STREAM_READ),z.readPixels(O,$,X,H,Yt.convert(Wt),Yt.convert(qt),0);const ae=U!==null?Pt.get(U).__webglFramebuffer:null;Vt.bindFramebuffer(z.FRAMEBUFFER,ae);const be=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await jv(z,be,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,Ut),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,ut),z.deleteBuffer(Ut),z.deleteSync(be),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(b,O=null,$=0){b.isTexture!==!0&&(vo("WebGLRenderer: copyFramebufferToTexture function signature has changed."),O=arguments[0]||null,b=arguments[1]);const X=Math.pow(2,-$),H=Math.floor(b.image.width*X),ut=Math.floor(b.image.height*X),yt=O!==null?O.x:0,Ft=O!==null?O.y:0;P.setTexture2D(b,0),z.copyTexSubImage2D(z.TEXTURE_2D,$,0,0,yt,Ft,H,ut),Vt.unbindTexture()},this.copyTextureToTexture=function(b,O,$=null,X=null,H=0){b.isTexture!==!0&&(vo("WebGLRenderer: copyTextureToTexture function signature has changed."),X=arguments[0]||null,b=arguments[1],O=arguments[2],H=arguments[3]||0,$=null);let ut,yt,Ft,Dt,Wt,qt,Ut,ae,be;const Ae=b.isCompressedTexture?b.mipmaps[H]:b.image;$!==null?(ut=$.max.x-$.min.x,yt=$.max.y-$.min.y,Ft=$.isBox3?$.max.z-$.min.z:1,Dt=$.min.x,Wt=$.min.y,qt=$.isBox3?$.min.z:0):(ut=Ae.width,yt=Ae.height,Ft=Ae.depth||1,Dt=0,Wt=0,qt=0),X!==null?(Ut=X.x,ae=X.y,be=X.z):(Ut=0,ae=0,be=0);const un=Yt.convert(O.format),de=Yt.convert(O.type);let kt;O.isData3DTexture?(P.setTexture3D(O,0),kt=z.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(P.setTexture2DArray(O,0),kt=z.TEXTURE_2D_ARRAY):(P.setTexture2D(O,0),kt=z.TEXTURE_2D),z.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,O.flipY),z.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),z.pixelStorei(z.UNPACK_ALIGNMENT,O.unpackAlignment);const He=z.getParameter(z.UNPACK_ROW_LENGTH),_e=z.getParameter(z.UNPACK_IMAGE_HEIGHT),Nn=z.getParameter(z.UNPACK_SKIP_PIXELS),yi=z.getParameter(z.UNPACK_SKIP_ROWS),xn=z.getParameter(z.UNPACK_SKIP_IMAGES);z.pixelStorei(z.UNPACK_ROW_LENGTH,Ae.width),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Ae.height),z.pixelStorei(z.UNPACK_SKIP_PIXELS,Dt),z.pixelStorei(z.UNPACK_SKIP_ROWS,Wt),z.pixelStorei(z.UNPACK_SKIP_IMAGES,qt);const ys=b.isDataArrayTexture||b.isData3DTexture,Pe=O.isDataArrayTexture||O.isData3DTexture;if(b.isRenderTargetTexture||b.isDepthTexture){const Jn=Pt.get(b),ns=Pt.get(O),wn=Pt.get(Jn.__renderTarget),Ei=Pt.get(ns.__renderTarget);Vt.bindFramebuffer(z.READ_FRAMEBUFFER,wn.__webglFramebuffer),Vt.bindFramebuffer(z.DRAW_FRAMEBUFFER,Ei.__webglFramebuffer);for(let ci=0;ci<Ft;ci++)ys&&z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Pt.get(b).__webglTexture,H,qt+ci),b.isDepthTexture?(Pe&&z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Pt.get(O).__webglTexture,H,be+ci),z.blitFramebuffer(Dt,Wt,ut,yt,Ut,ae,ut,yt,z.DEPTH_BUFFER_BIT,z.NEAREST)):Pe?z.copyTexSubImage3D(kt,H,Ut,ae,be+ci,Dt,Wt,ut,yt):z.copyTexSubImage2D(kt,H,Ut,ae,be+ci,Dt,Wt,ut,yt);Vt.bindFramebuffer(z.READ_FRAMEBUFFER,null),Vt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else Pe?b.isDataTexture||b.isData3DTexture?z.texSubImage3D(kt,H,Ut,ae,be,ut,yt,Ft,un,de,Ae.data):O.isCompressedArrayTexture?z.compressedTexSubImage3D(kt,H,Ut,ae,be,ut,yt,Ft,un,Ae.data):z.texSubImage3D(kt,H,Ut,ae,be,ut,yt,Ft,un,de,Ae):b.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,H,Ut,ae,ut,yt,un,de,Ae.data):b.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,H,Ut,ae,Ae.width,Ae.height,un,Ae.data):z.texSubImage2D(z.TEXTURE_2D,H,Ut,ae,ut,yt,un,de,Ae);z.pixelStorei(z.UNPACK_ROW_LENGTH,He),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,_e),z.pixelStorei(z.UNPACK_SKIP_PIXELS,Nn),z.pixelStorei(z.UNPACK_SKIP_ROWS,yi),z.pixelStorei(z.UNPACK_SKIP_IMAGES,xn),H===0&&O.generateMipmaps&&z.generateMipmap(kt),Vt.unbindTexture()},this.copyTextureToTexture3D=function(b,O,$=null,X=null,H=0){return b.isTexture!==!0&&(vo("WebGLRenderer: copyTextureToTexture3D function signature has changed."),$=arguments[0]||null,X=arguments[1]||null,b=arguments[2],O=arguments[3],H=arguments[4]||0),vo('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(b,O,$,X,H)},this.initRenderTarget=function(b){Pt.get(b).__webglFramebuffer===void 0&&P.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?P.setTextureCube(b,0):b.isData3DTexture?P.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?P.setTexture2DArray(b,0):P.setTexture2D(b,0),Vt.unbindTexture()},this.resetState=function(){A=0,D=0,U=null,Vt.reset(),ge.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ji}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}}let Sd=class extends sn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ki,this.environmentIntensity=1,this.environmentRotation=new ki,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};class Do extends Ks{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new ce(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const Ga=new B,Va=new B,yd=new Ie,po=new Ku,pa=new Lo,sc=new B,Ed=new B;class xm extends sn{constructor(t=new ln,e=new Do){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ga.fromBufferAttribute(e,s-1),Va.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ga.distanceTo(Va);t.setAttribute("lineDistance",new Be(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),pa.copy(i.boundingSphere),pa.applyMatrix4(s),pa.radius+=r,t.ray.intersectsSphere(pa)===!1)return;yd.copy(s).invert(),po.copy(t.ray).applyMatrix4(yd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){const d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=u.getX(v),y=u.getX(v+1),T=ma(this,t,po,l,p,y);T&&e.push(T)}if(this.isLineLoop){const v=u.getX(g-1),m=u.getX(d),p=ma(this,t,po,l,v,m);p&&e.push(p)}}else{const d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=ma(this,t,po,l,v,v+1);p&&e.push(p)}if(this.isLineLoop){const v=ma(this,t,po,l,g-1,d);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function ma(n,t,e,i,s,r){const o=n.geometry.attributes.position;if(Ga.fromBufferAttribute(o,s),Va.fromBufferAttribute(o,r),e.distanceSqToSegment(Ga,Va,sc,Ed)>i)return;sc.applyMatrix4(n.matrixWorld);const l=t.ray.origin.distanceTo(sc);if(!(l<t.near||l>t.far))return{distance:l,point:Ed.clone().applyMatrix4(n.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:n}}const bd=new B,wd=new B;class Mm extends xm{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)bd.fromBufferAttribute(e,s),wd.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+bd.distanceTo(wd);t.setAttribute("lineDistance",new Be(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class Sm extends Ks{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new ce(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const Td=new Ie,du=new Ku,ga=new Lo,_a=new B;class lb extends sn{constructor(t=new ln,e=new Sm){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ga.copy(i.boundingSphere),ga.applyMatrix4(s),ga.radius+=r,t.ray.intersectsSphere(ga)===!1)return;Td.copy(s).invert(),du.copy(t.ray).applyMatrix4(Td);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){const f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,v=d;g<v;g++){const m=c.getX(g);_a.fromBufferAttribute(h,m),Ad(_a,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let g=f,v=d;g<v;g++)_a.fromBufferAttribute(h,g),Ad(_a,g,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Ad(n,t,e,i,s,r,o){const a=du.distanceSqToPoint(n);if(a<e){const l=new B;du.closestPointToPoint(n,l),l.applyMatrix4(i);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class Qu extends ln{constructor(t=[new ue(0,-.5),new ue(.5,0),new ue(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Dn(s,0,Math.PI*2);const r=[],o=[],a=[],l=[],c=[],u=1/e,h=new B,f=new ue,d=new B,g=new B,v=new B;let m=0,p=0;for(let y=0;y<=t.length-1;y++)switch(y){case 0:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,v.copy(d),d.normalize(),l.push(d.x,d.y,d.z);break;case t.length-1:l.push(v.x,v.y,v.z);break;default:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,g.copy(d),d.x+=v.x,d.y+=v.y,d.z+=v.z,d.normalize(),l.push(d.x,d.y,d.z),v.copy(g)}for(let y=0;y<=e;y++){const T=i+y*u*s,x=Math.sin(T),I=Math.cos(T);for(let A=0;A<=t.length-1;A++){h.x=t[A].x*x,h.y=t[A].y,h.z=t[A].x*I,o.push(h.x,h.y,h.z),f.x=y/e,f.y=A/(t.length-1),a.push(f.x,f.y);const D=l[3*A+0]*x,U=l[3*A+1],w=l[3*A+0]*I;c.push(D,U,w)}}for(let y=0;y<e;y++)for(let T=0;T<t.length-1;T++){const x=T+y*t.length,I=x,A=x+t.length,D=x+t.length+1,U=x+1;r.push(I,A,U),r.push(D,U,A)}this.setIndex(r),this.setAttribute("position",new Be(o,3)),this.setAttribute("uv",new Be(a,2)),this.setAttribute("normal",new Be(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Qu(t.points,t.segments,t.phiStart,t.phiLength)}}class th extends ln{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],f=[],d=[];let g=0;const v=[],m=i/2;let p=0;y(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Be(h,3)),this.setAttribute("normal",new Be(f,3)),this.setAttribute("uv",new Be(d,2));function y(){const x=new B,I=new B;let A=0;const D=(e-t)/i;for(let U=0;U<=r;U++){const w=[],S=U/r,C=S*(e-t)+t;for(let G=0;G<=s;G++){const N=G/s,V=N*l+a,j=Math.sin(V),K=Math.cos(V);I.x=C*j,I.y=-S*i+m,I.z=C*K,h.push(I.x,I.y,I.z),x.set(j,D,K).normalize(),f.push(x.x,x.y,x.z),d.push(N,1-S),w.push(g++)}v.push(w)}for(let U=0;U<s;U++)for(let w=0;w<r;w++){const S=v[w][U],C=v[w+1][U],G=v[w+1][U+1],N=v[w][U+1];(t>0||w!==0)&&(u.push(S,C,N),A+=3),(e>0||w!==r-1)&&(u.push(C,G,N),A+=3)}c.addGroup(p,A,0),p+=A}function T(x){const I=g,A=new ue,D=new B;let U=0;const w=x===!0?t:e,S=x===!0?1:-1;for(let G=1;G<=s;G++)h.push(0,m*S,0),f.push(0,S,0),d.push(.5,.5),g++;const C=g;for(let G=0;G<=s;G++){const V=G/s*l+a,j=Math.cos(V),K=Math.sin(V);D.x=w*K,D.y=m*S,D.z=w*j,h.push(D.x,D.y,D.z),f.push(0,S,0),A.x=j*.5+.5,A.y=K*.5*S+.5,d.push(A.x,A.y),g++}for(let G=0;G<s;G++){const N=I+G,V=C+G;x===!0?u.push(V,V+1,N):u.push(V+1,V,N),U+=3}c.addGroup(p,U,x===!0?1:2),p+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new th(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}const va=new B,xa=new B,rc=new B,Ma=new oi;class ym extends ln{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){const s=Math.pow(10,4),r=Math.cos(La*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);const{a:v,b:m,c:p}=Ma;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),Ma.getNormal(rc),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){const T=(y+1)%3,x=h[y],I=h[T],A=Ma[u[y]],D=Ma[u[T]],U=`${x}_${I}`,w=`${I}_${x}`;w in f&&f[w]?(rc.dot(f[w].normal)<=r&&(d.push(A.x,A.y,A.z),d.push(D.x,D.y,D.z)),f[w]=null):U in f||(f[U]={index0:c[y],index1:c[T],normal:rc.clone()})}}for(const g in f)if(f[g]){const{index0:v,index1:m}=f[g];va.fromBufferAttribute(a,v),xa.fromBufferAttribute(a,m),d.push(va.x,va.y,va.z),d.push(xa.x,xa.y,xa.z)}this.setAttribute("position",new Be(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}}class al extends ln{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const u=[],h=new B,f=new B,d=[],g=[],v=[],m=[];for(let p=0;p<=i;p++){const y=[],T=p/i;let x=0;p===0&&o===0?x=.5/e:p===i&&l===Math.PI&&(x=-.5/e);for(let I=0;I<=e;I++){const A=I/e;h.x=-t*Math.cos(s+A*r)*Math.sin(o+T*a),h.y=t*Math.cos(o+T*a),h.z=t*Math.sin(s+A*r)*Math.sin(o+T*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),m.push(A+x,1-T),y.push(c++)}u.push(y)}for(let p=0;p<i;p++)for(let y=0;y<e;y++){const T=u[p][y+1],x=u[p][y],I=u[p+1][y],A=u[p+1][y+1];(p!==0||o>0)&&d.push(T,x,A),(p!==i-1||l<Math.PI)&&d.push(x,I,A)}this.setIndex(d),this.setAttribute("position",new Be(g,3)),this.setAttribute("normal",new Be(v,3)),this.setAttribute("uv",new Be(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new al(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}}class eh extends ln{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new B,h=new B,f=new B;for(let d=0;d<=i;d++)for(let g=0;g<=s;g++){const v=g/s*r,m=d/i*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(d/i)}for(let d=1;d<=i;d++)for(let g=1;g<=s;g++){const v=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,y=(s+1)*d+g;o.push(v,m,y),o.push(m,p,y)}this.setIndex(o),this.setAttribute("position",new Be(a,3)),this.setAttribute("normal",new Be(l,3)),this.setAttribute("uv",new Be(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new eh(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class cb extends Ks{static get type(){return"MeshLambertMaterial"}constructor(t){super(),this.isMeshLambertMaterial=!0,this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=em,this.normalScale=new ue(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ki,this.combine=Gu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class Em extends Do{static get type(){return"LineDashedMaterial"}constructor(t){super(),this.isLineDashedMaterial=!0,this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}}class bm extends sn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ce(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class ub extends bm{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(sn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ce(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const oc=new Ie,Rd=new B,Cd=new B;class hb{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ue(512,512),this.map=null,this.mapPass=null,this.matrix=new Ie,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ju,this._frameExtents=new ue(1,1),this._viewportCount=1,this._viewports=[new Ve(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,i=this.matrix;Rd.setFromMatrixPosition(t.matrixWorld),e.position.copy(Rd),Cd.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Cd),e.updateMatrixWorld(),oc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(oc),i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(oc)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class fb extends hb{constructor(){super(new Zu(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class db extends bm{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(sn.DEFAULT_UP),this.updateMatrix(),this.target=new sn,this.shadow=new fb}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Hu}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Hu);function Wa(n,t=!1){const e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new ln;let c=0;for(let u=0;u<n.length;++u){const h=n[u];let f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(const d in h.attributes){if(!i.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+d+'" attribute exists among all geometries, or in none of them.'),null;r[d]===void 0&&(r[d]=[]),r[d].push(h.attributes[d]),f++}if(f!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(const d in h.morphAttributes){if(!s.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;o[d]===void 0&&(o[d]=[]),o[d].push(h.morphAttributes[d])}if(t){let d;if(e)d=h.index.count;else if(h.attributes.position!==void 0)d=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,d,u),c+=d}}if(e){let u=0;const h=[];for(let f=0;f<n.length;++f){const d=n[f].index;for(let g=0;g<d.count;++g)h.push(d.getX(g)+u);u+=n[f].attributes.position.count}l.setIndex(h)}for(const u in r){const h=Pd(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(const u in o){const h=o[u][0].length;if(h===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let f=0;f<h;++f){const d=[];for(let v=0;v<o[u].length;++v)d.push(o[u][v][f]);const g=Pd(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(g)}}return l}function Pd(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){const u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}const o=new t(r),a=new Bn(o,e,i);let l=0;for(let c=0;c<n.length;++c){const u=n[c];if(u.isInterleavedBufferAttribute){const h=l/e;for(let f=0,d=u.count;f<d;f++)for(let g=0;g<e;g++){const v=u.getComponent(f,g);a.setComponent(f+h,g,v)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}const pb={...Xt,limit:"#6f8aa5"},$s=n=>pb[n],wm={x:new B(1,0,0),y:new B(0,1,0),z:new B(0,0,1)},Oi=n=>qa?Math.ceil(n/2):n,mb=n=>new B(...Ao[n]),Tm=(n,t)=>new es().setFromUnitVectors(wm[n],mb(t));function ac(n,{colour:t,centre_m:e,along:i},s){n.deleteAttribute("uv");const r=new ce(t),o=new Float32Array(n.attributes.position.count*3);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return n.setAttribute("color",new Bn(o,3)),i&&n.applyQuaternion(Tm(s,i)),n.translate(...e)}const gb={box:n=>ac(new Zr(...n.size_m),n),cylinder:n=>ac(new th(n.radius_m,n.other_radius_m??n.radius_m,n.length_m,Oi(32)),n,"y"),torus:n=>ac(new eh(n.radius_m,n.thickness_m,Oi(8),Oi(72)),n,"z")},pu=n=>n.map(t=>gb[t.kind](t));function _b(n){const t=new Ii,e=n.role==="predicted"||n.role==="truth";t.inner=e?xb(n):vb(n),t.add(t.inner);const{min:i,max:s}=new Kr().setFromObject(t.inner);return t.reach="xyz".split("").map(r=>Math.max(-i[r],s[r])),t}function vb({shape:n}){const t=new Ii,e=n.filter(s=>s.lit),i=n.filter(s=>!s.lit);return e.length&&(t.lit=new cb({vertexColors:!0}),t.add(new En(Wa(pu(e)),t.lit))),i.length&&t.add(new En(Wa(pu(i)),new jr({vertexColors:!0}))),t}function xb({role:n,shape:t}){const e=pu(t),i=$s(n),s=new En(Wa(e),new jr({color:i,transparent:!0,opacity:.16,depthWrite:!1}));return s.add(new Mm(Wa(e.map(r=>new ym(r,40))),new Do({color:i,transparent:!0,opacity:.75}))),s}function mu(n,t){const e=Oi(64);return Array.from({length:e+1},(i,s)=>{const r=s/e*2*Math.PI;return new B(n,t*Math.cos(r),t*Math.sin(r))})}function Ld(n,t,e){return Array.from({length:e},(i,s)=>{const r=s/e*2*Math.PI;return n.map((o,a)=>new B(o,t[a]*Math.cos(r),t[a]*Math.sin(r)))})}function gu(n,t){const[e,i]=[[],[]];for(const r of n){let o=0;for(let a=1;a<r.length;a+=1)e.push(r[a-1],r[a]),i.push(o,o+=r[a].distanceTo(r[a-1]))}const s=new ln().setFromPoints(e);return s.setAttribute("lineDistance",new Be(i,1)),new Mm(s,t)}const nh=(n,t)=>new jr({color:$s(n),transparent:!0,opacity:t,side:Pi,forceSinglePass:!0,depthWrite:!1}),_u=(n,t)=>new Do({color:$s(n),transparent:!0,opacity:t});function Mb(n){const{stations_m:t,radii_m:e}=n,i=new Ii;if(n.skin){const a=new En(new Qu(t.map((l,c)=>new ue(e[c],l)),Oi(48)),nh(n.role,.05));a.rotation.z=-Math.PI/2,i.add(a)}const s=[...Ld(t,e,n.meridians),...n.rings.map(([a,l])=>mu(a,l))],r=[...Ld(t,e,n.faint_meridians),...n.faint_rings.map(([a,l])=>mu(a,l))];n.axis&&r.push([t[0],t[t.length-1]].map(a=>new B(a,0,0)));const o=()=>new Em({color:$s(n.role),dashSize:.35,gapSize:.22,transparent:!0,opacity:.85});return s.length&&i.add(gu(s,n.dashed?o():_u(n.role,.8))),r.length&&i.add(gu(r,_u(n.role,.38))),i.quaternion.copy(Tm("x",n.along)),i.position.set(...n.origin_m),i}function Sb({role:n,radius_m:t}){const e=new Ii,i=([r,o,a])=>[new B(r,o,a),new B(o,r,a),new B(a,o,r)],s=mu(0,t).map(r=>i(r.toArray()));return e.add(new En(new al(t,Oi(32),Oi(20)),nh(n,.1)),gu([0,1,2].map(r=>s.map(o=>o[r])),_u(n,.7))),e}const yb=n=>n.kind==="sphere"?Sb(n):Mb(n);function Eb(){const n=[];let t=7;const e=()=>(t=t*16807%2147483647,t/2147483647);for(let s=0;s<Oi(1400);s+=1){const r=2*e()-1,o=2*Math.PI*e(),a=Math.sqrt(1-r*r);n.push(900*a*Math.cos(o),900*r,900*a*Math.sin(o))}const i=new ln;return i.setAttribute("position",new Be(n,3)),new lb(i,new Sm({color:9413562,size:1.3,sizeAttenuation:!1,transparent:!0,opacity:.7}))}function bb({direction:n,half_angle_rad:t,colour:e}){const i=new B(...n).normalize(),s=Math.PI/2-t,r=new al(500*Math.sin(t),Oi(96),Oi(16),0,2*Math.PI,0,1.05*s);r.applyQuaternion(new es().setFromUnitVectors(wm.y,i.clone().negate()));const o=r.attributes.position,a=new ce().setStyle(e,Ys),l=[],c=new B;for(let h=0;h<o.count;h+=1){c.fromBufferAttribute(o,h).normalize();const f=Math.sin(23*c.x+5*Math.sin(17*c.z))*Math.sin(19*c.z+4*Math.sin(13*c.x)),g=Math.max(.15,c.x*-.35+c.y*.75+c.z*.35)*(.124+.024*f);l.push(g*a.r,g*a.g,g*a.b)}r.setAttribute("color",new Be(l,3));const u=new En(r,new jr({vertexColors:!0}));return u.position.copy(i).multiplyScalar(500),u}function wb(n){const t=new Ii;n.stars&&t.add(Eb());for(const e of n.sky)t.add(bb(e));return t}class Tb{constructor(t,e=24,i=10){this.stations=e,this.sides=i,this.places=new Float32Array(e*i*3);const s=[];for(let o=0;o<e-1;o+=1)for(let a=0;a<i;a+=1){const l=o*i+a,c=o*i+(a+1)%i;s.push(l,c,l+i,c,c+i,l+i)}const r=new ln;r.setAttribute("position",new Bn(this.places,3)),r.setIndex(s),this.mesh=new En(r,nh(t,.22)),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set({rows:t,at:e,n:i}){if(this.mesh.visible=i>1,!!this.mesh.visible){for(let s=0;s<this.stations;s+=1){const r=s/(this.stations-1)*(i-1),o=Math.min(Math.floor(r),i-2),a=r-o,l=u=>t[o][e+u]+(t[o+1][e+u]-t[o][e+u])*a,c=l(3);for(let u=0;u<this.sides;u+=1){const h=u/this.sides*2*Math.PI,f=(s*this.sides+u)*3;this.places[f]=l(0),this.places[f+1]=l(1)+c*Math.cos(h),this.places[f+2]=l(2)+c*Math.sin(h)}}this.mesh.geometry.attributes.position.needsUpdate=!0}}}class Ab{constructor(t,e,i){this.most=e,this.places=new Float32Array(e*3);const s=new ln;s.setAttribute("position",new Bn(this.places,3));const r=i?new Em({color:$s(t),dashSize:.25,gapSize:.2}):new Do({color:$s(t)});this.dashed=i,this.line=new xm(s,r),this.line.frustumCulled=!1,this.line.visible=!1}set({rows:t,at:e,n:i}){const s=i>0?t[i-1]:null;if(t===this.rows&&i===this.count&&s===this.last)return;Object.assign(this,{rows:t,count:i,last:s});const r=Math.max(1,Math.ceil(i/this.most));let o=0;for(let a=0;a<i&&o<this.most;a+=r,o+=1){const l=t[a];this.places[o*3]=l[e],this.places[o*3+1]=l[e+1],this.places[o*3+2]=l[e+2]}this.line.geometry.setDrawRange(0,o),this.line.geometry.attributes.position.needsUpdate=!0,this.dashed&&this.line.computeLineDistances(),this.line.visible=o>1}}const Rb=.5,Cb=25,Pb=[5,4],lc=new WeakMap,[cc,br,wr]=[new Ie,new Ve,new Ve];function Lb(n){return lc.has(n)||lc.set(n,new ym(n,Cb)),lc.get(n)}class Dd{constructor(t){Object.assign(this,{canvas:t,pen:t.getContext("2d",{willReadFrequently:!0}),ratio:1,cut:!1,colour:"#000"}),this.at={left:0,top:0,width:0,height:0}}setPixelRatio(t){this.ratio=t}setSize(t,e){this.size={width:t,height:e},this.canvas.width=Math.max(1,Math.round(t*this.ratio)),this.canvas.height=Math.max(1,Math.round(e*this.ratio))}setScissorTest(t){this.cut=t}setScissor(){}setViewport(t,e,i,s){this.at={left:t,top:this.size.height-e-s,width:i,height:s}}setClearColor(t){this.colour=`#${t.toString(16).padStart(6,"0")}`}clear(){const{left:t,top:e,width:i,height:s}=this.cut?this.at:{left:0,top:0,...this.size};this.pen.setTransform(this.ratio,0,0,this.ratio,0,0),this.pen.fillStyle=this.colour,this.pen.fillRect(t,e,i,s)}clearDepth(){}dispose(){}render(t,e){const{pen:i,at:s}=this;t.updateMatrixWorld(),e.updateMatrixWorld(),i.save(),i.beginPath(),i.rect(s.left,s.top,s.width,s.height),i.clip();const r=new Ie().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);t.traverseVisible(o=>{o.layers.test(e.layers)&&(o.isLine?this.lines(o,o.geometry,o.isLineSegments?2:1,r,`#${o.material.color.getHexString()}`):o.isMesh&&o.material.opacity>Rb&&this.lines(o,Lb(o.geometry),2,r,Xt.plain))}),i.restore()}lines({matrixWorld:t,material:e},i,s,r,o){const{pen:a}=this,{position:l}=i.attributes,c=Math.min(l.count,i.drawRange.count);cc.multiplyMatrices(r,t),a.strokeStyle=o,a.globalAlpha=e.transparent?e.opacity:1,a.lineWidth=1,a.setLineDash(e.isLineDashedMaterial?Pb:[]),a.beginPath();for(let u=0;u+1<c;u+=s)br.fromBufferAttribute(l,u).setW(1).applyMatrix4(cc),wr.fromBufferAttribute(l,u+1).setW(1).applyMatrix4(cc),Db()&&(a.moveTo(...this.place(br)),a.lineTo(...this.place(wr)));a.stroke(),a.globalAlpha=1}place(t){const{left:e,top:i,width:s,height:r}=this.at;return[e+(t.x/t.w+1)/2*s,i+(1-t.y/t.w)/2*r]}pixels(){return this.pen.getImageData(0,0,this.canvas.width,this.canvas.height).data}}function Db(){const[n,t]=[br.z+br.w,wr.z+wr.w];return n<=0&&t<=0?!1:(n<=0?br.lerp(wr,(1e-6-n)/(t-n)):t<=0&&wr.lerp(br,(1e-6-t)/(n-t)),!0)}const Sa=1,Ub=22e5,[Ib,Nb,Ud]=[60,38,.35],uc=qa?.5:1,Fb=1e3,Id=24,Ob=64,[kb,Bb]=[860723,3159354],ya=n=>new B(...Ao[n]);class zb{constructor(t,e,i,s){this.elements={view:e,camera:i,labels:s},this.canvas=t;const r={antialias:!qa,alpha:!1,powerPreference:"high-performance",preserveDrawingBuffer:!0},o=t.getContext("webgl2",r);this.webgl=o!==null,this.webgl?(this.renderer=new ab({canvas:t,context:o,...r}),this.renderer.autoClear=!1,t.addEventListener("webglcontextlost",()=>this.outline())):this.renderer=new Dd(t),this.scene=new Sd,this.scene.add(new ub(14674431,2763306,.9));const a=new db(16777215,2.3);a.position.set(-6,9,5),this.scene.add(a),this.far=new Sd,this.perspective=new qn(32,1,.1,2e3),this.ortho=new Zu(-1,1,1,-1,-100,200),this.onboard=new qn(20,1,.02,2e3);for(const c of[this.perspective,this.ortho])c.layers.enable(Sa);Object.assign(this,{display:null,world:null,items:new Map,bodies:[],eyes:[],chosen:0}),Object.assign(this,{enabled:!0,drawn:0,quality:uc,adaptive:!0,pace:33,since:0}),this.marks=new Map,this.follow(e),this.resize();const l=new ResizeObserver(()=>this.resize());for(const c of[e,i])l.observe(c);addEventListener("resize",()=>this.resize())}outline(){const t=this.canvas.cloneNode(!1);this.canvas.replaceWith(t),this.renderer.dispose(),Object.assign(this,{canvas:t,webgl:!1,renderer:new Dd(t)}),this.resize()}adapt(t){if(!this.adaptive)return;this.pace=this.pace*.8+Math.min(t,400)*.2,this.since+=1;const e=this.pace>Ib&&this.quality>Ud,i=this.pace<Nb&&this.quality<uc;this.since<(i?150:6)||!(e||i)||(this.quality=Math.max(Ud,Math.min(uc,this.quality*(e?.7:1.25))),this.since=0,this.resize())}setDisplay(t){for(const e of[this.world,...this.far.children])Gb(e);this.far.clear(),this.far.add(wb(t)),this.world=new Ii,this.scene.add(this.world),this.items.clear(),this.bodies=t.bodies.map(e=>this.add(e,_b(e),!Array.isArray(e.place))),this.moving=this.bodies.filter(({moves:e})=>e);for(const e of t.surfaces){const i=this.add(e,yb(e),e.kind==="sphere"&&!Array.isArray(e.place));i.moves?this.moving.push(i):e.kind==="sphere"&&i.object.position.set(...e.place)}this.lines=t.lines.map(e=>this.addLine(e)),this.eyes=t.views.map(e=>({azimuth:e.azimuth_rad,height:e.height_rad,zoom:1,focus:e.kind==="perspective"?new B(...Nd(e,null)):null})),(this.display===null||this.chosen>=t.views.length)&&(this.chosen=0),this.display=t,this.frame=null,this.shot=[]}add(t,e,i){const s={item:t,object:e,moves:i};return i?(e.visible=!1,e.traverse(r=>r.layers.set(Sa))):t.kind==="body"&&e.position.set(...t.place),this.items.set(t.name,e),this.world.add(e),s}addLine(t){const e=Array.isArray(t.points),i=e?t.points.length:t.kind==="line"?Ob:t.since?Id+3:Fb,s=new Ab(t.role,i,t.dashed);e?s.set({rows:t.points,at:0,n:i}):s.line.layers.set(Sa),this.items.set(t.name,s.line),this.world.add(s.line);const r=t.spread?new Tb(t.role):null;return r&&(r.mesh.layers.set(Sa),this.world.add(r.mesh)),{line:t,path:s,tube:r,stands:e}}place(t,e,i,s){this.frame=t;for(const{item:r,object:o}of this.moving){const a=Fi(t,r.place,r.axes);o.visible=!!a,a&&o.position.set(...a);const l=a&&r.attitude?Yn(t,r.attitude):void 0;l&&o.inner.quaternion.set(...l),r.role==="measured"&&o.inner?.lit&&o.inner.lit.emissive.setHex(s?Bb:kb)}for(const{line:r,path:o,tube:a,stands:l}of this.lines)if(!l)if(r.kind==="line"){const c=Yn(t,r.points)||[];o.set({rows:c,at:0,n:c.length})}else{const c=ag(r,e?.trails.get(r.name)||[],t,i,Id);o.set(c),a?.set(c)}}known(t){for(const e of t){const{item:i}=this.bodies.find(r=>r.item.name===e),s=Fi(this.frame,i.place,i.axes);if(s)return{item:i,at:s,turn:i.attitude?Yn(this.frame,i.attitude):void 0}}return null}resize(){const t=[this.elements.view,this.elements.camera].map(u=>u.getBoundingClientRect()),e=t.filter(u=>u.width>0),i=Math.min(...e.map(u=>u.left)),s=Math.min(...e.map(u=>u.top)),r=Math.max(...e.map(u=>u.right))-i,o=Math.max(...e.map(u=>u.bottom))-s,a=u=>({left:u.left-i,bottom:s+o-u.bottom,width:u.width,height:u.height});this.places={view:a(t[0]),camera:a(t[1])};const{canvas:l}=this;Object.assign(l.style,{left:`${i}px`,top:`${s}px`,width:`${r}px`,height:`${o}px`});const c=Math.min(devicePixelRatio||1,Math.sqrt(Ub/Math.max(r*o,1)));this.renderer.setPixelRatio(c*this.quality),this.renderer.setSize(r,o,!1),this.renderer.setScissorTest(!1),this.renderer.setClearColor(527378,1),this.renderer.clear(),this.renderer.setScissorTest(!0),this.shot=[],this.tall=parseFloat(getComputedStyle(this.elements.labels).fontSize)}follow(t){let e=null;t.addEventListener("pointerdown",i=>{i.target.closest("button")||(e=[i.clientX,i.clientY],t.setPointerCapture(i.pointerId))}),t.addEventListener("pointermove",i=>{e&&(this.turn((i.clientX-e[0])*.005,(i.clientY-e[1])*.005),e=[i.clientX,i.clientY])}),t.addEventListener("pointerup",()=>{e=null}),t.addEventListener("wheel",i=>{i.preventDefault(),this.zoom(Math.exp(i.deltaY*.001))},{passive:!1})}turn(t,e){const i=this.eyes[this.chosen];i?.focus&&(i.azimuth+=t,i.height=Math.max(-1.4,Math.min(1.4,i.height+e)))}zoom(t){const e=this.eyes[this.chosen];e&&(e.zoom=Math.max(.15,Math.min(4,e.zoom*t)))}draw(){if(!this.enabled||!this.display)return;this.drawn+=1;const{view:t,camera:e}=this.places,i=this.display.views[this.chosen],s=i.kind==="flat";if(s)for(const{object:c}of this.bodies)c.scale.setComponent("xyz".indexOf(i.up[1]),1/i.stretch);const r=s?this.flat(i,t):this.orbit(i,t);if(this.into(t,r,!s),this.label(r,t,s?i:null),s)for(const{object:c}of this.bodies)c.scale.set(1,1,1);if(!this.display.camera||e.height<=20)return;const{at:o,turn:a}=Hb(this.display.camera,this.known(this.display.camera.carried_by)),l=[...o,...a];l.some((c,u)=>c!==this.shot[u])&&(this.shot=l,this.aim(this.display.camera,o,a,e),this.into(e,this.onboard,!0))}orbit(t,e){const i=this.perspective,s=e.width/Math.max(e.height,1),r=this.eyes[this.chosen],{focus:o}=r;o.lerp(new B(...Nd(t,this.known(t.follow)?.at)),.08);const a=o.distanceTo(new B(...t.centre_m)),l=r.zoom*(t.distance_m+t.growth*a)*Math.max(1,1.45/s),c=Math.cos(r.height);return i.position.set(o.x+l*c*Math.cos(r.azimuth),o.y+l*Math.sin(r.height),o.z+l*c*Math.sin(r.azimuth)),i.lookAt(o),i.aspect=s,i.updateProjectionMatrix(),i}flat(t,e){const i=this.ortho,s=t.span_m/2*this.eyes[this.chosen].zoom,r=s/(e.width/Math.max(e.height,1))/t.stretch;Object.assign(i,{left:-s,right:s,top:r,bottom:-r});const o=new B(...t.centre_m);return i.up.copy(ya(t.up)),i.position.copy(ya(t.right)).cross(i.up).multiplyScalar(50).add(o),i.lookAt(o),i.updateProjectionMatrix(),i}aim(t,e,i,s){const r=this.onboard,o=new es(...i);r.up.copy(ya(t.up).applyQuaternion(o)),r.position.set(...e),r.lookAt(r.position.clone().add(ya(t.look).applyQuaternion(o)));const a=Math.max(Li(t.look,t.aim_m)-Li(t.look,e),.4),[l,c]=t.half_field;this.cameraTan=Math.max(l,Math.min(c,t.half_height_m/a)),r.fov=2*Math.atan(this.cameraTan)*180/Math.PI,r.aspect=s.width/Math.max(s.height,1),r.updateProjectionMatrix(),r.updateMatrixWorld()}into(t,e,i){if(this.renderer.setViewport(t.left,t.bottom,t.width,t.height),this.renderer.setScissor(t.left,t.bottom,t.width,t.height),this.renderer.setClearColor(329740,1),this.renderer.clear(!0,!0),i){const s=e.position.clone();e.position.set(0,0,0),e.updateMatrixWorld(),this.renderer.render(this.far,e),e.position.copy(s),e.updateMatrixWorld(),this.renderer.clearDepth()}this.renderer.render(this.scene,e)}label(t,e,i){const s=i?i.up:"+y",r=i?i.stretch:1,o=new Map;for(const{text:l,at_m:c}of this.display.labels)o.set(l,{text:l,at:c,drop:1});for(const{item:l,object:c}of this.bodies){const u=l.label?Fi(this.frame,l.place,l.axes):void 0;if(!u)continue;const h=u.map((f,d)=>f+Ao[s][d]*c.reach[d]/r);o.set(`body ${l.name}`,{text:l.label,at:h,role:l.role})}for(const[l,c]of this.marks)o.has(l)||(c.remove(),this.marks.delete(l));t.updateMatrixWorld();const a=[];for(const[l,{text:c,at:u,role:h,drop:f}]of o){let d=this.marks.get(l);d||(d=document.createElement("span"),d.textContent=c,h&&(d.className="body",d.style.color=$s(h)),this.elements.labels.append(d),this.marks.set(l,d));const g=new B(u[0],u[1],u[2]).project(t),v=Math.abs(g.x)<.98&&Math.abs(g.y)<.96&&g.z<1;d.style.display=v?"":"none";const m=Math.round((g.x+1)/2*e.width);let p=Math.round((1-g.y)/2*e.height)+(f?14:0);if(h){const y=([T,x])=>Math.abs(T-m)<5*this.tall&&Math.abs(x-p)<this.tall;for(;a.some(y);)p-=2;a.push([m,p])}d.style.left=`${m}px`,d.style.top=`${p}px`}}onCamera(t){const e=new B(...t).project(this.onboard);return e.z>1?null:[e.x,e.y]}covers(t){const e=this.items.get(t),i=e.visible,s=[i,!1].map(o=>{if(e.visible=o,this.draw(),!this.webgl)return this.renderer.pixels();const a=this.renderer.getContext(),l=new Uint8Array(a.drawingBufferWidth*a.drawingBufferHeight*4);return a.readPixels(0,0,a.drawingBufferWidth,a.drawingBufferHeight,a.RGBA,a.UNSIGNED_BYTE,l),l});e.visible=i;let r=0;for(let o=0;o<s[0].length;o+=4)(s[0][o]!==s[1][o]||s[0][o+1]!==s[1][o+1])&&(r+=1);return r}}function Hb(n,t){if(!t)return{at:n.start_m,turn:[0,0,0,1]};const e=n.turns&&t.turn||[0,0,0,1],i=new B(...n.at_m).applyQuaternion(new es(...e));return{at:[t.at[0]+i.x,t.at[1]+i.y,t.at[2]+i.z],turn:e}}function Gb(n){n?.traverse(t=>{t.geometry?.dispose(),t.material?.dispose()}),n?.removeFromParent()}function Nd(n,t){if(!n.follow.length)return n.centre_m;const e=t?Li(n.along,t)-Li(n.along,n.centre_m):n.start_m,i=n.share*Math.sign(n.start_m)*Math.max(n.least_m,e*Math.sign(n.start_m));return n.centre_m.map((s,r)=>s+i*Ao[n.along][r])}function Vb(n){return n.kind==="flat"&&n.stretch!==1?Te(Z.exaggerated,{axis:n.up[1],n:n.stretch}):""}const Cn=n=>document.getElementById(n),Wb=250;class $b{constructor(t,e){Object.assign(this,{scene:t,choose:e}),this.instruments=new vg,this.commands=new yg,this.charts=new ov,this.chartsAt=0,this.text=""}setDisplay(t){const e=JSON.stringify(t);if(e===this.text){this.scene.place(null,null,0,!1);return}this.text=e,this.display=t,this.instruments.setDisplay(t),this.commands.setDisplay(t),this.charts.setDisplay(t),xg(t.section),lg(t.attitude),fg(t.lamps);for(const i of["trip","ladder-panel"])Cn(i).hidden=!t.link;Cn("clock-rx").parentElement.hidden=!t.link,Cn("camera").hidden=!t.camera,Cn("clock-pred").parentElement.hidden=!t.predicted,t.camera&&(Cn("camera").setAttribute("aria-label",t.camera.title),Cn("camera-tag").textContent=t.camera.title),Pg(t,this.choose),Cn("legend").replaceChildren(...t.legend.map(({role:i,words:s,dashed:r})=>{const o=document.createElement("span");return o.className=r?"dash":"",o.style.color=Xt[i],o.textContent=s,o})),this.scene.setDisplay(t),Cn("views").replaceChildren(...t.views.map((i,s)=>{const r=document.createElement("button");return r.textContent=i.label,r.dataset.view=i.label.toLowerCase(),r.onclick=()=>this.setView(s),r})),Cn("views").hidden=t.views.length<2,this.setView(this.scene.chosen)}setView(t){this.scene.chosen=t,[...Cn("views").children].forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),Cn("scale").textContent=Vb(this.display.views[t])}nextView(){this.display&&this.setView((this.scene.chosen+1)%this.display.views.length)}clocks(t,e,i,s,r){const o=li(t,this.display.measured),a=li(t,this.display.predicted);Ml("gen",o?.t,i,r),Ml("rx",o?.received,s,r),Ml("pred",a?.t,a?Te(Z.ahead,{s:qe(a.t-e,1)}):"",r)}show({run:t,frame:e,rungs:i,history:s,now:r,stale:o,until:a}){const{display:l}=this,c=li(e,l.measured);this.instruments.show(e,o),l.section&&Mg(l.section,e),l.attitude&&cg(l.attitude,e),l.lamps&&dg(l.lamps,e),this.commands.show(e),l.link&&this.showLink(t,e,c,i,r),this.scene.place(e,s,r,o),performance.now()-this.chartsAt>Wb&&(this.chartsAt=performance.now(),this.charts.show(s.charts,e,a))}showLink(t,e,i,s,r){Eg(Cn("dial"),t,e.round_trip,i?.transit),bg(e,i,t.step_s),Vg(Cn("ladder"),t,this.display.commands.axes,s,r),_n(Cn("ladder-counts"),$g(s))}showReticle(t){this.display?.camera&&t&&wg(Cn("reticle"),this.scene,this.display.camera,t)}}const We=n=>document.getElementById(n),Xb=4;class qb{constructor(t,e,i){Object.assign(this,{link:t,panels:e,back:i,on:!1,run:null,at:0,playing:!1}),We("review-close").onclick=()=>this.leave(),We("review-play").onclick=()=>this.play(!this.playing),We("review-time").oninput=()=>this.go(Number(We("review-time").value)),addEventListener("keydown",s=>{this.on&&s.key==="Escape"&&!We("dialog").open&&this.leave()})}async list(){try{const t=await this.link.get("api/runs");kg(t,(e,i)=>this.open(e,i))}catch(t){Su(Z.review_title,t.message)}}async open(t,e){e.textContent=Z.review_loading;try{this.run=await this.link.get(`api/runs/${t.split("/").map(encodeURIComponent).join("/")}`)}catch(i){e.textContent=i.message;return}Na(),this.start()}start(){const{run:t}=this;this.on=!0,this.history=new Vd(t.display,1/0);for(const e of t.frames)this.history.add(e);this.rungs=t.ladder.map(Zd),We("scrubber").hidden=!1,We("bottom").hidden=!0,We("review-time").max=String(t.frames.length-1),this.panels.setDisplay(t.display),t.display.camera&&(We("camera-tag").textContent=t.display.camera.review_title),We("run-name").textContent=`${Z.review}: ${t.name}`,this.marks(),this.go(t.frames.length-1),We("review-time").focus()}leave(){this.on=!1,this.playing=!1,We("scrubber").hidden=!0,We("bottom").hidden=!1,We("camera-tag").textContent=this.run.display.camera?.title||"",this.back()}play(t){this.playing=t,We("review-play").textContent=t?Z.stop_play:Z.play,t&&this.at>=this.run.frames.length-1&&this.go(0),this.playedAt=performance.now(),this.playedFrom=this.run.frames[this.at].t}go(t){this.at=Math.max(0,Math.min(this.run.frames.length-1,t)),We("review-time").value=String(this.at);const e=this.run.frames[this.at].t,i=this.run.events.filter(r=>r.t<=e),s=i[i.length-1];We("review-now").textContent=`${qe(e,1)} s${s&&e-s.t<5?` · ${s.text}`:""}`,We("review-time").setAttribute("aria-valuetext",We("review-now").textContent),this.playing&&(this.playedAt=performance.now(),this.playedFrom=e)}advance(){if(!this.playing)return;const t=this.playedFrom+Xb*(performance.now()-this.playedAt)/1e3;let e=this.at;for(;e<this.run.frames.length-1&&this.run.frames[e].t<t;)e+=1;if(e!==this.at){const[i,s]=[this.playedAt,this.playedFrom];this.go(e),Object.assign(this,{playedAt:i,playedFrom:s})}e>=this.run.frames.length-1&&this.play(!1)}marks(){const t=We("review-time").getBoundingClientRect(),e=We("review-marks"),i=this.run.frames[this.run.frames.length-1].t||1;e.style.left=`${We("review-time").offsetLeft}px`,e.style.width=`${t.width}px`,e.innerHTML="";for(const s of this.run.events){const r=document.createElement("i");r.style.left=`${s.t/i*100}%`,r.title=`${qe(s.t,1)} s ${s.node}: ${s.text}`,e.append(r)}}frame(){return this.run.frames[this.at]}show(){this.advance();const{run:t}=this,e=this.frame(),i=li(e,t.display.measured);this.banner(),qd(t.display,e,e.mode,!1),this.panels.clocks(e,e.t,i?Te(Z.age,{s:qe(e.t-i.t,1)}):"","",!1),this.panels.show({run:t,frame:e,history:this.history,now:e.t,stale:!1,until:e.t,rungs:this.rungs.filter(s=>s.sent<=e.k).map(s=>Hg(s,e.k))})}banner(){const t=We("banner"),e=this.at===this.run.frames.length-1&&this.run.verdict,i=e?Ur(this.run.verdict.words):"";t.dataset.said!==i&&(t.dataset.said=i,t.textContent=i),t.classList.toggle("alarm",!!e&&!this.run.verdict.success)}}const Yb=6e3;class Kb{constructor(){this.status={phase:"idle",lease:"free",pages:0,note:""},this.can={fly:!1,desk:!1},this.connected=!1,this.display=null,this.asked="",this.reset(null)}reset(t){this.run=t,this.frame=null,this.frameAt=0,this.verdict=null,this.ladder=new Map,this.events=[],this.abortAt=null,t&&(this.display=t.display,this.history=new Vd(t.display,Yb),this.history.begin(t.trails),this.rungs(t.ladder||[]))}take(t){switch(t.type){case"hello":this.can=t.can,this.asked=t.mode||"",t.display&&!this.display&&(this.display=t.display);break;case"run":this.reset(t);break;case"status":this.status=t;break;case"frame":this.takeFrame(t);break;case"ladder":this.rungs(t.ladder);break;case"verdict":this.verdict=t;break;case"event":this.events.push(t);break}!t.type&&t.link&&(this.connected=t.link==="open",t.why&&(this.why=t.why))}takeFrame(t){if(this.frame=t,this.frameAt=performance.now(),this.rungs(t.ladder),this.history.add(t),this.sent?.parts.kind===Tr&&this.abortAt===null){const e=[...this.ladder.values()].find(i=>i.kind===Tr);this.abortAt=(e?.sent??t.k)*this.run.step_s}}get measured(){return li(this.frame,this.display?.measured)}get predicted(){return li(this.frame,this.display?.predicted)}get sent(){return this.frame?.signals[this.display.commands.sent]}rungs(t){for(const e of t)this.ladder.set(e[0],Zd(e));for(;this.ladder.size>700;)this.ladder.delete(this.ladder.keys().next().value)}now(){if(!this.frame)return 0;if(this.frame.paused||this.verdict||this.status.phase!=="flying")return this.frame.t;const t=(performance.now()-this.frameAt)/1e3*this.run.pace;return this.frame.t+Math.min(t,this.run.step_s)}silence(){return!this.frame||this.verdict||this.frame.paused||this.status.phase!=="flying"?0:(performance.now()-this.frameAt)/1e3}}const re=n=>document.getElementById(n),jb=1e3/30,[Zb,Jb]=[60,120],$a=1,vu=2e3;for(const n of document.querySelectorAll("[data-s]"))n.textContent=Z[n.dataset.s];for(const n of document.querySelectorAll("[data-a]"))n.setAttribute("aria-label",Z[n.dataset.a]);const zt=new Kb,Ni=new zb(re("gl"),re("view"),re("camera"),re("labels")),Qr=new $b(Ni,n=>ih(n));Ni.enabled=!new URLSearchParams(location.search).has("plain");let Ua=-1/0,hc=0,Fd=0,Od=null,kd=null;const Ln=new Qg((n,t)=>jn?.stick(n,t)),To=new zg(jn),Uo=new jg(jn,zt),ai=new qb(jn,Qr,()=>Am());function Qb(n){if(n.type==="desk"){To.show(n,zt.status.lease==="you"),Rm();return}const{phase:t,lease:e}=zt.status;zt.take(n),(n.type==="run"||n.type==="hello")&&!ai.on&&Am(),n.type==="status"&&(n.phase==="starting"&&t!=="starting"&&Na(),n.phase==="refused"&&t!=="refused"&&n.lease==="you"&&Xa(n.note),n.phase==="ended"&&t==="closing"&&Og()&&ai.list(),n.lease==="you"&&e!=="you"&&Ln.taken(),xu(),To.lease(n.lease==="you")),n.type==="verdict"&&zt.frame&&kd!==n&&!ai.on&&!zt.can.desk&&(kd=n,Fg(n,zt.can.fly&&zt.status.lease==="you",()=>Xa())),n.type==="event"&&(re("event").textContent=`${qe(n.t,1)} s · ${tw(n)}`),n.type==="reply"&&!n.ok&&(re("event").textContent=n.code?yu(n.code):n.text),n.type||xu()}function tw({code:n,text:t}){return zt.run?.operator==="console"&&Z.stick_events[n]||t}function Am(){const{display:n}=zt;n&&(Qr.setDisplay(n),Ln.setController(n.controller),To.task={hint:n.hint,goal:n.goal,display:n},Rm())}function Rm(){const{run:n,display:t}=zt,e=zt.can.desk?To.title():n?.name||"";re("run-name").textContent=n&&t.link?`${e} · ${n.forward_s} s + ${n.back_s} s`:e,re("run-name").title=re("run-name").textContent}async function Cm(){await jn.ask({do:zt.status.lease==="you"?"drop":"take"})}function ih(n){zt.frame&&Uo.steer({do:"mode",mode:n})}function Pm(){zt.frame&&Uo.steer({do:zt.frame.paused?"resume":"pause"})}function Lm(){const n=performance.now();n-Ua<vu?(Ua=-1/0,Uo.abort()):Ua=n,Bd(),setTimeout(Bd,vu+50)}function Bd(){const n=performance.now()-Ua<vu;re("abort").classList.toggle("armed",n),re("abort").querySelector("small").textContent=n?Z.abort_armed:Z.abort_hint}const Dm=()=>Uo.steer({do:"stop"});function Xa(n=""){if(zt.can.desk){To.reopen();return}zt.status.lease!=="you"&&jn.ask({do:"take"}),Ng(zt,t=>jn.ask(t),n,zt.status.phase==="flying"?Dm:null)}function ew(){const n=Xd(zt.display).map(t=>t.name);n.length&&ih(n[(n.indexOf(zt.frame?.mode)+1)%n.length])}const zd={KeyT:Cm,KeyP:Pm,KeyX:Lm,KeyN:()=>Xa(),KeyV:()=>Qr.nextView(),KeyL:()=>ai.list(),KeyG:()=>ep(Ln,zt.display),Slash:()=>Yd(zt.display),KeyM:ew,Equal:()=>Ni.zoom(.85),Minus:()=>Ni.zoom(1.18),BracketLeft:()=>Ni.turn(.15,0),BracketRight:()=>Ni.turn(-.15,0)};addEventListener("keydown",n=>{if(n.repeat||n.ctrlKey||n.metaKey||n.altKey||tp(n.target)||re("dialog").open&&n.code!=="KeyX")return;const t=Cg(zt.display,n.code);zd[n.code]&&jn?zd[n.code]():t&&jn&&!ai.on&&ih(t.name)});re("lease").onclick=Cm;re("pause").onclick=Pm;re("abort").onclick=Lm;re("end-run").onclick=Dm;re("restart").onclick=()=>Xa();re("open-review").onclick=()=>ai.list();re("open-settings").onclick=()=>ep(Ln,zt.display);re("open-help").onclick=()=>Yd(zt.display);function xu(){const{status:n}=zt,t=n.lease==="you";re("lease").textContent=t?Z.drop:n.lease==="other"?Z.taken:Z.take,re("lease").disabled=n.lease==="other",re("lease").classList.toggle("primary",n.lease==="free"),re("pages").textContent=n.pages===1?Z.pages_one:Te(Z.pages,{n:n.pages}),re("socket-state").textContent=zt.connected?`● ${Z.socket_open}`:`○ ${Z.socket_closed}`,re("socket-state").className=zt.connected?"ok":"alarm";for(const e of["pause","restart"])re(e).disabled=!t;zt.can.desk&&(re("pause").disabled=!0,re("restart").textContent=Z.desk.open)}function yn(n,t,e){const i=re("banner"),s=n?`${pe(n)}${t?`<small>${pe(t)}</small>`:""}`:"";i.dataset.said!==s&&(i.dataset.said=s,i.innerHTML=s),i.classList.toggle("alarm",!!e)}function nw(n){const{status:t,frame:e,run:i,verdict:s}=zt,r=Uo.words();if(r)yn(...r,!0);else if(!zt.connected&&jn)yn(Z.socket_closed,"",!0);else if(t.phase==="idle")yn(Z.idle,zt.can.desk?Z.desk.idle:Z.idle_text);else if(t.phase==="starting")yn(Z.starting,t.run||"");else if(t.phase==="refused")yn(Z.run_refused,t.note,!0);else if(t.note?.startsWith("failed"))yn(Z.run_failed,t.note.slice(7),!0);else if(t.phase==="ended"&&!s&&t.note)yn(Ur(t.note),"");else if(n>$a)yn(Te(Z.stale_frames,{s:n.toFixed(0)}),"",!0);else if(zt.abortAt!==null&&!s&&e){const o=!zt.display.link||[...zt.ladder.values()].some(Jd),a=zt.display.abort,l=e.t-zt.abortAt,c=l>i.forward_s+i.back_s+2*i.step_s+$a;o?yn(a?Te(Z.aborted_so,{does:a}):Z.aborted,"",!0):c?yn(Z.abort_untold,Te(Z.abort_untold_hint,{s:l.toFixed(0)}),!0):yn(Te(Z.abort_sent,{s:Math.max(0,i.forward_s-l).toFixed(0)}),"",!0)}else t.pilot_lost?yn(Z.pilot_lost,"",!0):e?.paused?yn(Z.paused,""):e&&!zt.measured&&t.phase==="flying"?yn(Z.no_telemetry,Te(Z.first_in,{s:Math.max(0,i.back_s-e.t).toFixed(0)})):s?yn(Ur(s.words),"",!s.success):yn("")}function iw(){const n=zt.status.lease==="you",t=Ln.state().held,e=Ln.stuck(),i=n?Ln.axes.length?Ln.gone()?Z.stick_gone:e.length?Te(Z.stick_stuck,{axes:e.join(", ")}):t?`${Z.stick_held} · ${Z[Ln.source]}`:Z.stick_open:Z.stick_none:Z.stick_watch;_n(re("stick-state"),i),re("stick-state").className=n?t&&!e.length?"ok":"alarm":"dim";const s=zt.display?.controller?.step_name;_n(re("step"),n&&Ln.source==="keyboard"&&Ln.deflections.length>1?`${s} ${Ln.step}`:"")}function sw(){const n=[Ni.webgl?"":Z.no_webgl,Hd?"":Z.no_storage,Ln.axes.length?Z.pad_notes[Ln.lacks()]:""];_n(re("notes"),n.filter(Boolean).join(" · ")),re("notes").title=re("notes").textContent}function rw(n,t){const{run:e,measured:i}=zt,s=i?t-i.t:null,r=s!==null&&s>e.back_s+$a*Math.max(e.pace,1);return Qr.clocks(n,t,s===null?"":Te(Z.age,{s:qe(s,1)}),i?Te(Z.ago,{s:qe(Math.max(t-i.received,0),1)}):"",r),r}function ow(){const{frame:n,run:t,history:e}=zt,i=zt.silence();if(nw(i),iw(),sw(),re("end-run").hidden=!(zt.abortAt!==null&&zt.status.phase==="flying"&&zt.status.lease==="you"&&!zt.verdict),_n(re("pause"),n?.paused?Z.resume:Z.pause),qd(zt.display,n,n?.mode||t?.mode,zt.status.lease==="you"&&!zt.can.desk),!t||!n)return;const s=zt.now(),r=rw(n,s)||i>$a||!zt.connected;document.body.classList.toggle("stale",r),Qr.show({run:t,frame:n,history:e,rungs:[...zt.ladder.values()],now:s,stale:r})}function Um(n){if(requestAnimationFrame(Um),n-hc<jb-2)return;Ni.adapt(n-hc),hc=n;const t=n-Fd>(zt.frame===Od&&!ai.on?Jb:Zb);t&&(Fd=n,Od=zt.frame,ai.on?ai.show():ow()),Ni.draw(),t&&Qr.showReticle(ai.on?ai.frame():zt.frame)}xu();jn?jn.listen(Qb):Su(Z.no_token_title,Z.no_page_token);requestAnimationFrame(Um);window.rvd={store:zt,scene:Ni,stick:Ln,review:ai,link:jn};
