import{r as Tg,a as Ag,b as up,l as Zn}from"./index.js";const Wt={measured:"#7cc4ff",predicted:"#ffb652",truth:"#f2f5f8",target:"#dbe5ee",plain:"#dbe5ee",pilot:"#7cc4ff",automatic:"#d59bf6",sent:"#56d6b0",limit:"#8aa4bd",guide:"#b9c2a0",goal:"#56d6b0",ok:"#56d6b0",alarm:"#ff7a5c",dim:"#8fa1b3",line:"#263544",text:"#dbe5ee"},Qa=!new URLSearchParams(location.search).has("fine")&&/swiftshader|llvmpipe|softpipe|software|basic render/i.test(Rg());function Rg(){const n=document.createElement("canvas").getContext("webgl2");if(!n)return"software";const t=n.getExtension("WEBGL_debug_renderer_info"),e=String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),e}function vn(n,t){n.textContent!==t&&(n.textContent=t)}const Tc=new Map;let Pa=12;const Cg=new ResizeObserver(n=>n.forEach(({target:t})=>hp(t)));function hp(n){const{width:t,height:e}=n.getBoundingClientRect();Tc.set(n,{w:t,h:e}),Pa=parseFloat(getComputedStyle(document.documentElement).fontSize)}let La=()=>Math.min(devicePixelRatio||1,2);function Pg(n,t){const e=La;La=()=>n;try{t()}finally{La=e}}function js(n){Tc.has(n)||(hp(n),Cg.observe(n));const{w:t,h:e}=Tc.get(n),i=La(),s=Math.max(1,Math.round(t*i)),r=Math.max(1,Math.round(e*i));(n.width!==s||n.height!==r)&&Object.assign(n,{width:s,height:r});const o=n.getContext("2d",{willReadFrequently:Qa});return o.setTransform(i,0,0,i,0,0),o.clearRect(0,0,t,e),o.font=`${.74*Pa}px system-ui, sans-serif`,o.lineWidth=Pa/12,{pen:o,w:t,h:e,rem:Pa}}function Fr(n,t,e,i,s,r){n.strokeStyle=s,n.setLineDash(r||[]),n.beginPath(),n.arc(t,e,Math.max(i,0),0,7),n.stroke(),n.setLineDash([])}function ze(n,t,e,i,s,r="left",o="middle"){n.fillStyle=s,n.textAlign=r,n.textBaseline=o,n.fillText(t,e,i)}const Lg={review_bar:"Review",review_event_back:"«",review_step_back:"‹",review_step_on:"›",review_event_on:"»",review_event_back_alt:"to the event before",review_step_back_alt:"one picture back",review_step_on_alt:"one picture on",review_event_on_alt:"to the next event",review_speed:"Speed of the review",review_times:"{n} ×",review_events:"Events of the run",review_events_some:"Events ({n})",review_events_none:"No events",review_report:"Report",review_png:"PNG",review_csv:"CSV",review_webm:"WebM",review_webm_stop:"Stop the video",review_report_hint:"Open the report of this run in a tab of its own",review_png_hint:"Save what is shown now as a picture",review_csv_hint:"Save the numbers of all instants as a table",review_webm_hint:"Play on from here, to the end or until it is stopped, and save it as a video",review_no_tab:"The browser did not allow a new tab.",review_webm_none:"This browser records no WebM video",review_failed:"not saved: {why}",review_of:"Review: {name}",review_flown:"{mode} at the start",review_seed:"seed {n}",runs_loading:"Reading the list…",runs_columns:["ended","run","scenario","mode","operator","seed","time","verdict"],runs_flying:"under way",runs_closing:"its bag is being closed…",runs_no_report:"This run has no report: ./rvd report makes one.",runs_report:"Report of {name}",runs_open:"Review {name}"},Dg=[["","In a review:"],["Space","play, stop"],["← →","one picture back, on"],["Shift ← →","to the event before, to the next one"],["↑ ↓","faster, slower"],["Home End","to the beginning, to the end"],["Esc","leave the review"]],Ig=["t [s]","step","mode"],Ug="no picture was recorded",$={...Lg,title:"RVD console",clocks:"Three clocks",clock_generated:"generated on board",clock_received:"received on the ground",clock_predicted:"predicted for",modes:"Who decides",mode_turn:"{modes} in turn",mode_ground:"ground",mode_board:"on board",pause:"Pause",resume:"Resume",abort:"ABORT",abort_hint:"X twice",abort_armed:"again: ABORT",instruments:"Instruments",columns:{measured:"measured",predicted:"predicted",truth:"truth",plain:""},limit:"limit",weight:"pilot weight",scene:"Scene",views:"Views",camera_side:"Camera, delay and charts",ladder:"Command ladder",ladder_alt:"Commands on their way to the craft and back",ladder_ground:"ground",ladder_link:"on the link",ladder_craft:"at the craft",ladder_back:"telemetry on its way back",ladder_known:"known",round_trip:"Round trip",dial_alt:"Dial of the round trip",restart:"New run",review:"Review",settings:"Stick",help:"Help",stop:"Stop run",review_close:"Leave review",play:"Play",stop_play:"Stop",scrub:"Instant of the review",review_title:"Review a run",review_none:"No finished runs here yet: a run is listed once its bag is closed.",review_loading:"Reading the bag…",review_open:"Open",take:"Take the stick",drop:"Release the stick",taken:"Another page has the stick",stick_yours:"You have the stick",stick_held:"stick live",stick_open:"DEAD-MAN OPEN: automatic alone flies",stick_watch:"watching",stick_none:"you are in charge",keyboard:"keyboard",gamepad:"gamepad",stick_events:{STICK_LOST:"nobody holds the stick, or the dead-man is open",STICK:"the stick counts"},pages_one:"1 page",pages:"{n} pages",of:"of",socket_open:"connected",socket_closed:"NOT CONNECTED",idle:"Ready",idle_text:"Take the stick (T), then start a run (N).",starting:"The graph is coming up…",paused:"PAUSED",stale:"STALE",no_telemetry:"no telemetry yet",first_in:"first telemetry in {s} s",pilot_lost:"PILOT LOST: the automatic controller flies alone",stale_frames:"NO DATA FOR {s} s",aborted:"ABORT in force",aborted_so:"ABORT in force: {does}",abort_sent:"ABORT sent, acting in about {s} s",abort_asked:"ABORT: waiting for the answer",abort_unconfirmed:"ABORT NOT CONFIRMED",abort_again:"no answer; asked {n} times, asking again",abort_accepted:"ABORT accepted, goes out with the next frame",abort_untold:"ABORT sent, NOT ACKNOWLEDGED",abort_untold_hint:"sent {s} s ago; telemetry has not told whether it is in force",unconfirmed:"{name} NOT CONFIRMED",unconfirmed_hint:"The run did not answer in 2 s. Try again.",no_webgl:"No WebGL: the scene is drawn in lines",no_storage:"Storage is blocked: settings are not remembered",stick_gone:"GAMEPAD GONE: automatic alone flies",stick_stuck:"NOT AT REST: {axes} counts as 0 until it has been centred",run_failed:"The run could not be flown: see the terminal",run_refused:"No run with these settings",verdict_title:"Verdict",verdict_time:"time",fly_again:"Fly again (N)",close:"Close",cancel:"Cancel",start:"Start",seed:"seed",mode:"mode",seed_hint:"empty: the next one",new_run:"New run",new_run_text:"A new run in a new folder. A run under way is stopped.",no_fly:"This console belongs to one run; start it with ./rvd fly --operator console to fly again.",no_page_token:"This page needs the token of the address that the console printed.",no_token_title:"No token",exaggerated:"{axis} scale × {n}",link:{transit:"transit",p99:"p99",lost:"lost",late:"late",corrupted:"damaged",gap:"last gap"},age:"age {s} s",ago:"{s} s ago",ahead:"in {s} s",now:"now",settings_title:"The stick",settings_dead_zone:"dead zone",settings_axis:"axis",settings_pair:"buttons {plus} / {minus}, or",settings_invert:"inverted",settings_button:"dead-man button",settings_space:"keyboard: hold Space as dead-man",settings_none:"No gamepad seen. Press a button on it.",settings_pads:"Gamepads",settings_now:"now",pad_notes:{"":"",choose:"Several gamepads: choose one under Stick (G)",setup:"The gamepad must be set up under Stick (G) before it flies"},pad_plain:"no standard mapping",pad_live:"axes {axes} · pressed {buttons}",pad_nothing:"none",pad_choose:"Several gamepads are connected: choose one.",pad_setup:"This gamepad has no standard mapping: its axes and buttons may be anything. It does not fly before each axis and the dead-man button have been set.",pad_ready:"This gamepad is set up.",pad_start:"Set it up step by step",pad_next:"Next",pad_skip:"No such axis",pad_stop:"Stop",pad_rest:"Let go of all its sticks, triggers and buttons, then go on.",pad_move:"Push the stick all the way for {what} ({name}).",pad_back:"Let it go.",pad_trigger:"Axis {axis} does not rest at 0, as a trigger does not: take another.",pad_hold:"Press the button that is to be held while flying.",help_title:"Keys",help_step:"{name} of the keys",or:"or",review_truth:"Review shows the truth. It never reaches this page while a run is flown.",unknown:"–",desk:{door:"Which volunteer? Enter the number you were given; no name is asked or kept.",volunteer:"volunteer number",begin:"Begin",heading:"{who}, flight {n} of {of}",training:"Training: this flight does not count.",counts:"This flight counts.",condition:"Control: {mode}",clock:"The clock starts when the graph is up.",fly:"Start the flight",rest_title:"A break",rest:"Rest your eyes and hands.",go_on:"Go on",done_title:"Finished",done:"Thank you, {who}. All flights are flown and rated.",next:"Next volunteer",yes:"Yes",no:"No",again:"Answer again",pick:"Pick the sentence that fits best.",save:"Save the ratings",weigh:"Which of the two contributed more to the workload of flying in this way?",pair:"pair {n} of {of}",tree:{controllable:"Was the craft controllable?",adequate:"Was adequate performance ({goal}) attainable with a tolerable pilot workload?",satisfactory:"Was it satisfactory without improvement?"},ratings:["","Excellent, highly desirable: compensation not a factor","Good, negligible deficiencies: compensation not a factor","Fair, some mildly unpleasant deficiencies: minimal compensation","Minor but annoying deficiencies: moderate compensation","Moderately objectionable deficiencies: considerable compensation","Very objectionable but tolerable deficiencies: extensive compensation","Major deficiencies: adequate performance not attainable with maximum tolerable compensation","Major deficiencies: considerable compensation needed for control","Major deficiencies: intense compensation needed to retain control","Major deficiencies: control lost during some part of the flight"],tlx:{mental:["Mental demand","How mentally demanding was the flight?","very low","very high"],physical:["Physical demand","How physically demanding was the flight?","very low","very high"],temporal:["Temporal demand","How hurried or rushed was the pace?","very low","very high"],performance:["Performance","How successful were you in doing what you were asked to do?","perfect","failure"],effort:["Effort","How hard did you have to work for your level of performance?","very low","very high"],frustration:["Frustration","How insecure, discouraged, irritated, stressed and annoyed were you?","very low","very high"]},errors:{VOLUNTEER:"A whole number from 1 to 999, please.",STAGE:"Not now.",RATING:"The rating is incomplete.",TLX:"Please set every scale.",WEIGHTS:"Please choose in every pair."}}},Ng=[["T","take or release the stick"],["Space","dead-man, if so chosen under Stick"],["P","pause, resume"],["X X","ABORT, past every buffer{abort}"],["N","new run"],["V","next view"],["+ − [ ]","zoom and turn the scene"],["L","review a run"],["G","stick settings"],["?","this list"],["Esc","close"],["","A key that is released commands zero. Without focus, without this page, or with the dead-man open, there is no pilot: the automatic controller flies alone."]],Fg={ArrowUp:"↑",ArrowDown:"↓",ArrowLeft:"←",ArrowRight:"→"},Og=["nobody","pilot","automatic","blend","guard"],kh=["","nothing due","wrong length","checksum","out of order","too old","out of range","an input was missing","as the mode says","stick invalid: automatic alone","automatic invalid: counts as neutral","neither valid: neutral","ABORT in force"],kg=["sent","due","executed","effect seen","refused","missed","unknown"],Bg={LEASE:"Take the stick first (T).",TAKEN:"Another page has the stick.",NO_RUN:"No run is under way.",NO_FLY:$.no_fly,NO_ANSWER:"The run did not answer.",DESK:"The session says what is flown.",MODE:"No such mode.",SETTINGS:"Too many settings, or one that is too long.",SEED:"The seed must be a whole number."};function oe(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}const Do={"+x":[1,0,0],"-x":[-1,0,0],"+y":[0,1,0],"-y":[0,-1,0],"+z":[0,0,1],"-z":[0,0,-1]};function jn(n,t){const e=n?.signals[t];return e?.ok?e:void 0}function li(n,t){return t?jn(n,t.signal)?.parts[t.part]??void 0:void 0}const fp=(n,t)=>Array.isArray(n)?n[t]:n;function ci(n,{signal:t,part:e,index:i,factor:s}){const r=jn(n,t)?.parts[e];if(r==null)return;const o=i.map(a=>fp(r,a));if(!o.some(a=>a==null))return s*(o.length===1?o[0]:Math.hypot(...o))}function Or(n,t){return t!==null&&typeof t=="object"?ci(n,t):t??void 0}function dp(n,t="xyz"){if(n==null)return;const e=[0,0,0];for(let i=0;i<t.length;i+=1){const s=fp(n,i);if(s==null)return;e["xyz".indexOf(t[i])]=s}return e}function Fi(n,t,e){return Array.isArray(t)?t:dp(li(n,t),e)}function Li(n,t){const e=Do[n];return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}class pp{constructor(t,e){this.display=t,this.keep=e,this.trails=new Map;for(const i of t?.lines||[])i.kind==="trail"&&this.trails.set(i.name,[]);this.charts=(t?.charts?.strips||[]).map(i=>({t:[],curves:i.curves.map(()=>[]),spread:[]}))}begin(t){for(const e of this.display.lines)for(const i of t?.[e.name]||[]){const s=dp(i.slice(2,-1),e.axes);s&&this.trails.get(e.name).push([i[0],i[1],...s,i[i.length-1]??0])}}add(t){for(const e of this.display.lines)e.kind==="trail"&&this.extend(e,t);this.display.charts?.strips.forEach((e,i)=>this.plot(e,this.charts[i],t))}extend(t,e){const i=this.trails.get(t.name),s=Fi(e,t.place,t.axes);if(!s||i.length&&e.t<=i[i.length-1][0])return;const r=t.spread?ci(e,t.spread)??0:0;i.push([e.t,e.signals[t.place.signal].t,...s,r]),i.length>this.keep&&i.shift()}plot(t,e,i){const s=[...t.curves,t.spread].filter(Boolean).map(a=>a.signal),r=jn(i,s.find(a=>a!=="truth")??"truth");if(!r||r.t<=(e.t[e.t.length-1]??-1/0))return;e.t.push(r.t),t.curves.forEach((a,l)=>e.curves[l].push(ci(i,a)??null));const o=t.spread?ci(i,t.spread):void 0;e.spread.push(o===void 0?null:o*t.spread_factor)}}function zg(n,t,e,i,s){let r=t.length;for(;r>0&&t[r-1][0]>i;)r-=1;if(!n.since)return{rows:t,at:2,n:r};const o=jn(e,n.since.signal),a=Fi(e,n.place,n.axes),l=Fi(e,n.since,n.axes);if(!o||!a||!l)return{rows:[],at:0,n:0};let c=r;for(;c>0&&t[c-1][1]>o.t;)c-=1;const u=[[...l,n.since_spread?ci(e,n.since_spread)??0:0]],h=Math.max(1,Math.floor((r-c)/s));for(let f=c;f<r;f+=h)u.push(t[f].slice(2));return u.push([...a,n.spread?ci(e,n.spread)??0:0]),{rows:u,at:0,n:u.length}}const Di=n=>document.getElementById(n),Bh=.75*Math.PI;function Hg(n){Di("attitude").hidden=!n,n&&(Di("attitude-title").textContent=n.title,Di("ball").setAttribute("aria-label",n.alt))}const zh=(n,t)=>{const e=Math.max(0,...t.filter(i=>i!==void 0).map(Math.abs));return n.find(i=>e<=i)??n[n.length-1]},Wo=(n,t)=>Math.max(-1,Math.min(1,n/t)),Hh=(n,t)=>n>0?`+${Xe(n,t)}`:Xe(n,t);function Vg(n,t){const{pen:e,w:i,h:s,rem:r}=js(Di("ball")),o=Math.min(i*.6,s)/2-.95*r,[a,l]=[o+1.1*r,s/2],c=v=>v?.map(m=>ci(t,m)),u=n.needles[0],[h,f]=[c(u.angles),c(u.rates)],d=zh(n.scales,h),g=f?zh(n.rate_scales,f):1;e.fillStyle="#0a1420",e.beginPath(),e.arc(a,l,o,0,7),e.fill(),Fr(e,a,l,o,Wt.dim),e.strokeStyle=Wt.line,e.beginPath(),e.moveTo(a-o,l),e.lineTo(a+o,l),e.moveTo(a,l-o),e.lineTo(a,l+o);for(const v of[-.5,.5])e.moveTo(a+v*o,l-r*.25),e.lineTo(a+v*o,l+r*.25),e.moveTo(a-r*.25,l+v*o),e.lineTo(a+r*.25,l+v*o);for(const v of[-1,-.5,0,.5,1]){const m=v*Bh-Math.PI/2;e.moveTo(a+o*Math.cos(m),l+o*Math.sin(m)),e.lineTo(a+(o-r*.4)*Math.cos(m),l+(o-r*.4)*Math.sin(m))}e.stroke(),n.limit!==null&&n.limit<=d&&Fr(e,a,l,n.limit/d*o,Wt.limit,[r*.3,r*.25]);for(const v of[...n.needles].reverse()){const[m,p,y]=c(v.angles);if(m===void 0)continue;const T=Wt[v.role];e.strokeStyle=T,e.fillStyle=T;const x=o-.15*r,[U,A]=[a+Wo(y,d)*x,l-Wo(p,d)*x],D=S=>Math.sqrt(Math.max(x*x-S*S,0))*.8;e.lineWidth=r*(v===u?.16:.08),e.beginPath(),e.moveTo(a-D(A-l),A),e.lineTo(a+D(A-l),A),e.moveTo(U,l-D(U-a)),e.lineTo(U,l+D(U-a)),e.stroke();const I=Wo(m,d)*Bh-Math.PI/2,w=(S,C)=>[a+S*Math.cos(C),l+S*Math.sin(C)];e.beginPath(),e.moveTo(...w(o,I)),e.lineTo(...w(o-r*.8,I-.09)),e.lineTo(...w(o-r*.8,I+.09)),e.closePath(),v===u?e.fill():(e.lineWidth=r/12,e.stroke())}e.lineWidth=r/12,f&&f[0]!==void 0&&Gg(e,a,l,o,r,f.map(v=>Wo(v,g)),Wt[u.role]),e.strokeStyle=Wt.text,e.beginPath(),e.moveTo(a-r*.9,l),e.lineTo(a-r*.3,l),e.moveTo(a+r*.3,l),e.lineTo(a+r*.9,l),e.stroke(),Wg(e,n,{angles:h,rates:f,scale:d,rateScale:g,w:i,h:s,rem:r})}function Gg(n,t,e,i,s,[r,o,a],l){n.fillStyle=l;const c=(h,f,d,g)=>{n.beginPath(),n.moveTo(h,f),n.lineTo(h+d*s*.6-g*s*.3,f+g*s*.6+d*s*.3),n.lineTo(h+d*s*.6+g*s*.3,f+g*s*.6-d*s*.3),n.closePath(),n.fill()},u=i+s*.25;c(t+r*i,e-u,0,-1),c(t+u,e-o*i,1,0),c(t+a*i,e+u,0,1)}function Wg(n,t,{angles:e,rates:i,scale:s,rateScale:r,w:o,h:a,rem:l}){const c=o-l*.2,u=o*.6+l*1.3;["roll","pitch","yaw"].forEach((f,d)=>{const g=a/2+(d-1.4)*l*2.3;ze(n,f,u,g,Wt.dim),n.font=`600 ${.95*l}px system-ui, sans-serif`;const v=t.limit!==null&&Math.abs(e[d])>t.limit;ze(n,`${v?"▲ ":""}${Hh(e[d],t.digits)}`,c,g,Wt[t.needles[0].role],"right"),n.font=`${.74*l}px system-ui, sans-serif`,i&&ze(n,`${Hh(i[d],t.digits+1)} /s`,c,g+l*.95,Wt.dim,"right")}),[`ring ±${s} ${t.unit}`,...i?[`edge ±${r} ${t.unit}/s`]:[]].forEach((f,d)=>ze(n,f,c,a-l*(1.5-d),Wt.dim,"right"))}function $g(n){Di("lamps").hidden=!n,n&&(Di("lamps-title").textContent=n.title,Di("lights").setAttribute("aria-label",n.alt),Di("lights").style.height=`${2*n.groups.length}rem`)}function Xg(n,t){const{pen:e,w:i,h:s,rem:r}=js(Di("lights")),[o,a,l]=[n.on,n.glow,n.counts].map(g=>li(t,g));n.note&&Ao(li(t,n.note)??["",!1],Di("lamps-note"),"dim");const c=Math.max(...n.groups.map(g=>g.labels.length+qg(g.labels)*.5)),[u,h]=[11.5*r,i-5.2*r],f=Math.min((h-u)/c,2.6*r);let d=0;n.groups.forEach((g,v)=>{const m=(v+.36)*(s/n.groups.length);ze(e,g.name,0,m,Wt.text),ze(e,g.words,1.8*r,m,Wt.dim);let p=u;g.labels.forEach((y,T)=>{const x=T===0||g.labels[T-1]!==y;x&&T>0&&(p+=f*.5);const U=Math.max(a?.[d]??0,o?.[d]?1:0);Fr(e,p,m,r*.42,o?.[d]?"#ffffff":"#3a4f63"),e.globalAlpha=U,e.fillStyle=Wt[n.role],e.beginPath(),e.arc(p,m,r*.4,0,7),e.fill(),e.globalAlpha=1;let A=T;for(;g.labels[A+1]===y;)A+=1;x&&ze(e,y,p+(A-T)*f/2,m+r*.92,Wt.dim,"center"),p+=f,d+=1}),l&&ze(e,`${l[v]} pulses`,i,m,Wt.text,"right")})}const qg=n=>n.filter((t,e)=>e>0&&n[e-1]!==t).length;function Yg(n,{w:t,h:e,rem:i},s,r,o){const a=e/2/o,[l,c]=[t/2,e/2],u=s.half_view*a;n.strokeStyle=Wt.limit,n.strokeRect(l-u,c-u,2*u,2*u);const[h,f]=[li(r,s.points),li(r,s.used)];if(!h)return;const d=s.width_px;for(let g=0;2*g<h.length;g+=1){if(h[2*g]===null||h[2*g+1]===null)continue;const v=l+(h[2*g]/d-.5)*2*u,m=c+(h[2*g+1]/d-.5)*2*u;n.lineWidth=i/8,Fr(n,v,m,i*.38,f?.[g]?Wt.ok:Wt.dim),n.lineWidth=i/12,f?.[g]&&(n.fillStyle=Wt.ok,n.beginPath(),n.arc(v,m,i*.14,0,7),n.fill())}}const Je=n=>document.getElementById(n),jg=4,Kg=["measured","predicted","truth","plain"];function Xe(n,t){if(n==null||!Number.isFinite(n))return $.unknown;const e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","−")}const $o=(n,t,e)=>typeof n=="number"?String(n).replace("-","−"):Xe(t,e);function mp(n,{low:t,high:e},i){const[s,r]=[Or(n,t),Or(n,e)];return s===void 0&&r===void 0?"":r===void 0?`> ${$o(t,s,i)}`:s===void 0?`< ${$o(e,r,i)}`:`${$o(t,s,i)}…${$o(e,r,i)}`}class Zg{setDisplay(t){const e=t.instruments;if(Je("instruments").hidden=!e,this.rows=[],!e)return;Je("instruments-title").textContent=e.title;const i=Kg.filter(r=>e.rows.some(o=>o.readings.some(a=>a.role===r)));Je("instruments").style.setProperty("--columns",i.length);const s=si("div","head");s.append(...[["",""],...i.map(r=>[$.columns[r],r]),["",""],[$.limit,"dim"]].map(([r,o])=>si("span",o,r))),Je("instruments-rows").replaceChildren(s,...e.rows.map(r=>{const o=si("div","row"),a=new Map(i.map(c=>[c,si("b",c)])),l=si("u");return o.append(si("span","",r.label),...a.values(),si("u","unit",r.unit),l),this.rows.push({row:r,cells:a,limit:l}),o}))}show(t,e){for(const{row:i,cells:s,limit:r}of this.rows){let o="";for(const a of i.readings){const l=ci(t,a.value),c=s.get(a.role);vn(c,Xe(l,i.digits)),c.classList.toggle("stale-value",e&&a.role==="measured"),c.classList.toggle("bad",l<=Or(t,a.low)||l>=Or(t,a.high)),o=mp(t,a,i.digits)||o}vn(r,o)}}}function si(n,t="",e=""){const i=document.createElement(n);return t&&(i.className=t),i.textContent=e,i}function Jg(n){Je("cut").hidden=!n,n&&(Je("section-title").textContent=n.title,Je("section").setAttribute("aria-label",n.alt),Je("foot").hidden=!n.foot,n.foot&&(Je("foot-label").textContent=n.foot.label))}const gp={dot(n,t,e,i,s){n.fillStyle=i,n.beginPath(),n.arc(t,e,s*.3,0,7),n.fill()},ring(n,t,e,i,s,r){n.fillStyle=`${i}30`,n.beginPath(),n.arc(t,e,Math.max(s*.3,r),0,7),n.fill(),n.stroke()},cross(n,t,e,i,s){const r=s*.32;n.beginPath(),n.moveTo(t-r,e-r),n.lineTo(t+r,e+r),n.moveTo(t-r,e+r),n.lineTo(t+r,e-r),n.stroke()},square(n,t,e,i,s){n.strokeRect(t-s*.35,e-s*.35,s*.7,s*.7)}};function Qg(n,t){const{pen:e,w:i,h:s,rem:r}=js(Je("section")),[o,a]=[i/2,s/2],l=Math.min(i,s)/2-.9*r;e.strokeStyle=Wt.line,e.beginPath(),e.moveTo(o-l,a),e.lineTo(o+l,a),e.moveTo(o,a-l),e.lineTo(o,a+l),e.stroke(),Ao(n.note?li(t,n.note):["",!1],Je("section-note"),"dim"),n.foot&&Ao(li(t,n.foot.words),Je("foot-words"));const c=Or(t,n.extent_m);if(!c)return;const u=l/c;for(const f of n.rings){const d=Or(t,f.radius_m);d!==void 0&&(Fr(e,o,a,d*u,Wt[f.role],f.dashed?[r*.3,r*.25]:null),f.written&&ze(e,`${d.toFixed(2)} m`,o+d*u*.72,a-d*u*.72-r*.3,Wt[f.role]))}ze(e,n.names?.[1]??Vh(n.up),o+r*.3,a-l,Wt.dim),ze(e,n.names?.[0]??Vh(n.right),o+l,a-r*.6,Wt.dim,"right");const h=f=>[o+Li(n.right,f)*u,a-Li(n.up,f)*u];for(const f of n.spots){const d=Fi(t,f.place);if(!d)continue;const g=Wt[f.role],[v,m]=h(d);e.strokeStyle=g;const p=f.origin&&Fi(t,f.origin);p&&(e.setLineDash([r*.2,r*.2]),e.beginPath(),e.moveTo(...h(p)),e.lineTo(v,m),e.stroke(),e.setLineDash([])),gp[f.mark](e,v,m,g,r,f.spread?(ci(t,f.spread)??0)*u:0);const y=f.rate&&Fi(t,f.rate);if(y){const T=f.ahead_s*u;e.beginPath(),e.moveTo(v,m),e.lineTo(v+Li(n.right,y)*T,m-Li(n.up,y)*T),e.stroke()}}}const Vh=n=>n.replace("+","").replace("-","−");function Ao(n,t,e=""){const[i,s]=n||[$.unknown,!1];vn(t,i),t.className=s?"alarm":e}function Ac(n,t){const e=Xe(n,t);return Number(n.toFixed(t))>0?`+${e}`:e}function t_(n){const t=si("div","bar");return t.append(document.createElement("i"),document.createElement("span")),t.firstChild.style.background=n,t}class e_{setDisplay({commands:t,link:e}){this.commands=t,this.link=e,Je("commands-title").textContent=t.unit?`${t.title}, ${t.unit}`:t.title;const i=t.axes.map(o=>si("span","dim",o.name)),s=t.rows.map(o=>si("span",o.role==="automatic"?"auto":"",o.label));this.rows=t.rows.map(o=>({row:o,bars:t.axes.map(()=>t_(Wt[o.role]))}));const r=i.length<=jg?[[si("span"),...i],...this.rows.map(({bars:o},a)=>[s[a],...o])]:[[si("span"),...s],...i.map((o,a)=>[o,...this.rows.map(({bars:l})=>l[a])])];Je("bars").style.setProperty("--columns",r[0].length-1),Je("bars").replaceChildren(...r.flat())}show(t){const e=t.signals[this.commands.sent];for(const{row:s,bars:r}of this.rows){const a=(s.value.signal===this.commands.sent?e:jn(t,s.value.signal))?.parts[s.value.part];this.commands.axes.forEach((l,c)=>this.bar(r[c],a?.[c]??null,l.highest))}const i=e&&this.link?[Og[e.parts.by]]:[];e&&e.parts.weight!==null&&e.parts.by===3&&i.push(`${$.weight} ${e.parts.weight}`),e&&kh[e.parts.reason]&&i.push(kh[e.parts.reason]),vn(Je("why"),i.join(" · "))}bar(t,e,i){const s=Math.min(Math.abs(e||0)/i,1)*48;t.firstChild.style.left=`${e<0?50-s:50}%`,t.firstChild.style.width=`${s}%`,vn(t.lastChild,e===null?$.unknown:Ac(e,this.commands.digits))}}function Xo(n,t,e,i){const s=Je(`clock-${n}`);vn(s,t===void 0?$.unknown:`${Xe(t,1)} s`),vn(Je(`clock-${n}-age`),e),s.parentElement.classList.toggle("stale",!!i)}function n_(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=js(n),[l,c,u]=[r/2,o*.56,Math.min(r/2,o*.56)-a*.5],h=t.forward_s+t.back_s,f=Math.max(h*1.5,1),d=v=>Math.PI*(.8+1.4*Math.max(0,Math.min(1,v/f)));s.lineWidth=a*.45,s.strokeStyle="#1b2733",s.beginPath(),s.arc(l,c,u,d(0),d(f)),s.stroke(),e!==void 0&&(s.strokeStyle=e>h+1?Wt.alarm:Wt.measured,s.beginPath(),s.arc(l,c,u,d(0),d(e)),s.stroke()),i&&(s.lineWidth=a*.16,s.strokeStyle=Wt.guide,s.beginPath(),s.arc(l,c,u-a*.5,d(0),d(i)),s.stroke()),s.strokeStyle=Wt.text,s.lineWidth=a*.12;const g=d(h);s.beginPath(),s.moveTo(l+(u-a*.4)*Math.cos(g),c+(u-a*.4)*Math.sin(g)),s.lineTo(l+(u+a*.4)*Math.cos(g),c+(u+a*.4)*Math.sin(g)),s.stroke(),s.font=`600 ${1.35*a}px system-ui, sans-serif`,ze(s,e===void 0?$.unknown:`${e.toFixed(1)} s`,l,c-a*.05,Wt.text,"center"),s.font=`${.7*a}px system-ui, sans-serif`,ze(s,`${t.forward_s} + ${t.back_s} s`,l,c+a*1.05,Wt.dim,"center")}function i_(n,t,e){const{link:i,gap:s}=n,r=[[$.link.transit,t?`${Xe(t.transit,2)} s`:$.unknown]];i&&r.push([$.link.p99,`${Xe(i.delay_p99,2)} s`],[$.link.lost,i.lost+i.outage],[$.link.late,i.late],[$.link.corrupted,i.corrupted]),r.push([$.link.gap,s?oe($.ago,{s:Xe((n.k-s.k)*e,0)}):$.unknown]);const o=r.map(([a,l])=>`<dt>${a}</dt><dd>${l}</dd>`).join("");Je("link-counts").innerHTML!==o&&(Je("link-counts").innerHTML=o)}function s_(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=js(n),[l,c]=[r/2,o/2];s.strokeStyle="#dbe5ee90",s.beginPath(),s.moveTo(l-r*.3,c),s.lineTo(l-a,c),s.moveTo(l+a,c),s.lineTo(l+r*.3,c),s.moveTo(l,c-o*.36),s.lineTo(l,c-a),s.moveTo(l,c+a),s.lineTo(l,c+o*.36);for(let d=-3;d<=3;d+=1)d&&(s.moveTo(l+d*r*.1,c-a*.25),s.lineTo(l+d*r*.1,c+a*.25));s.stroke();const u=t.known(e.carried_by);if(!u)return;const h=u.item.role==="truth";for(const d of e.marks){const g=Fi(i,d.at),v=g&&!(h&&d.role==="predicted")&&t.onCamera(g);if(!v)continue;const m=Wt[d.role],[p,y]=[l+v[0]*r/2,c-v[1]*o/2];if(s.strokeStyle=m,d.radius_m===null){gp.square(s,p,y,m,a);continue}const T=Math.max(Li(e.look,g)-Li(e.look,u.at),.05);Fr(s,p,y,Math.min(d.radius_m/T/t.cameraTan*(o/2),o),m),s.strokeStyle=`${m}80`,s.beginPath(),s.moveTo(l,c),s.lineTo(p,y),s.stroke()}e.pixels&&Yg(s,{w:r,h:o,rem:a},e.pixels,i,t.cameraTan),e.gauge&&r_(s,r,o,a,e.gauge,i,h);const f=e.distance.map(d=>ci(i,d.value)).find(d=>d!==void 0);f!==void 0&&ze(s,`${Xe(f,e.digits)} ${e.unit}`,a*.6,o-a*.9,Wt.measured)}function r_(n,t,e,i,s,r,o){const[a,l,c]=[t-i*2.9,i*1.5,e-i*1.2],{low:u,high:h}=s,f=d=>c-(Math.max(u,Math.min(h,d))-u)/(h-u)*(c-l);n.strokeStyle="#dbe5eea0",n.beginPath(),n.moveTo(a,l),n.lineTo(a,c);for(let d=0;u+d*s.tick<=h+1e-9;d+=1){const g=f(u+d*s.tick),v=d%s.long_ticks===0;n.moveTo(a,g),n.lineTo(a+i*(v?.5:.25),g),v&&ze(n,Xe(u+d*s.tick,s.digits),a+i*.65,g,Wt.text)}n.stroke(),s.limit!==null&&(n.strokeStyle=Wt.alarm,n.beginPath(),n.moveTo(a-i*.5,f(s.limit)),n.lineTo(a+i*.5,f(s.limit)),n.stroke());for(const{role:d,value:g}of s.readings){const v=ci(r,g);if(v===void 0||o&&d!=="truth")continue;const m=f(v),p=Wt[d==="truth"?"measured":d];n.beginPath(),n.moveTo(a-i*.1,m),n.lineTo(a-i*.75,m-i*.36),n.lineTo(a-i*.75,m+i*.36),n.closePath(),d==="predicted"?(n.strokeStyle=p,n.stroke()):(n.fillStyle=p,n.fill())}ze(n,s.unit,a,l-i*.7,Wt.dim,"center")}const Da=()=>document.getElementById("modes"),o_=(n,t)=>(n?.modes||[]).find(e=>e.name===t),a_=(n,t)=>t?`${n} (${t.replace(/^Key/,"")})`:n,tl=(n,t)=>o_(n,t)?.label??t,l_=(n,t)=>(n?.modes||[]).find(e=>e.key&&e.key===t),_p=n=>(n?.modes||[]).filter(t=>!t.key);function Gh(n,t){Da().hidden=!n.modes.length,Da().classList.toggle("told",n.on_board!==null),Da().replaceChildren(...n.modes.map(e=>{const i=document.createElement("button");return i.dataset.mode=e.name,i.title=e.words,i.textContent=a_(e.label,e.key),n.on_board&&i.append(document.createElement("small")),i.onclick=()=>t(e.name),i}))}function vp(n,t,e,i){const s=li(t,n?.on_board);for(const r of Da().children){const[o,a]=[r.dataset.mode===e,r.dataset.mode===s];r.disabled=!i,r.setAttribute("aria-pressed",String(o));const l=r.querySelector("small");l&&vn(l,[o?$.mode_ground:"",a?$.mode_board:""].filter(Boolean).join(" · "))}}function c_(n){const t=_p(n).map(i=>i.label.toLowerCase()).join(", "),e=(n?.modes||[]).filter(i=>i.key).map(i=>[i.key.replace(/^Key/,""),i.words||i.label]);return t?[["M",oe($.mode_turn,{modes:t})],...e]:e}const Ro=()=>document.getElementById("dialog");function ys(n,t){const e=Ro();e.innerHTML=n,e.open||e.showModal();for(const i of e.querySelectorAll("[data-close]"))i.onclick=()=>e.close();return t&&t(e),e}function el(){Ro().open&&Ro().close()}const Yr=`<button data-close>${$.close}</button>`;function Pe(n){const t=document.createElement("span");return t.textContent=n,t.innerHTML.replaceAll('"',"&quot;")}function Nu(n,t){ys(`<h3>${Pe(n)}</h3><p>${Pe(t)}</p><div class="buttons">${Yr}</div>`)}const Wh=n=>Fg[n]||n.replace(/^Key/,"");function u_(n){const t=n?.controller,e=(t?.axes||[]).map(s=>[s.keys.map(r=>r.map(Wh).join(" / ")).join(` ${$.or} `),`${t.verb} ${s.positive} / ${s.negative} (${s.name})`]);for(const s of t?.buttons||[])e.push([Wh(s.key),s.words]);const i=t?.key_deflections.length||0;return i>1&&e.push([Array.from({length:i},(s,r)=>r+1).join(" "),oe($.help_step,{name:t.step_name})]),e}function Fu(n){const t=n?.abort?`: ${n.abort}`:"",[[e,i],...s]=Ng.map(([o,a])=>[o,oe(a,{abort:t})]),r=[[e,i],...u_(n),...c_(n),...s,...Dg].map(([o,a])=>o?`<tr><td><kbd>${Pe(o)}</kbd></td><td>${Pe(a)}</td></tr>`:`<tr><td colspan="2">${Pe(a)}</td></tr>`);ys(`<h3>${$.help_title}</h3><table>${r.join("")}</table><div class="buttons">${Yr}</div>`)}function nl(n){return Bg[n]||n}function h_(n,t){const e=n.fields.map(i=>{const s=`${i.section} ${i.key}`,r=t[s]??i.value,o=`data-setting="${Pe(s)}" title="${Pe(`${i.key}: ${i.hint}`)}"`,a=i.choices.length?`<select ${o}>${i.choices.map(l=>`<option ${l===r?"selected":""}>${Pe(l)}</option>`).join("")}</select>`:`<input ${o} value="${Pe(r)}" maxlength="200">`;return`<label>${Pe(i.label)} ${a} <span class="dim">${Pe(i.unit)}</span></label>`});return`<fieldset><legend>${Pe(n.title)}</legend>${e.join("")}</fieldset>`}function f_(n,t){const e={};for(const i of t)for(const s of i.fields){const r=`${s.section} ${s.key}`,o=[...n.querySelectorAll("[data-setting]")].find(a=>a.dataset.setting===r).value;o.trim()!==s.value&&(e[r]=o)}return e}let $h={};function xp(n,t,e=""){if(!n.can.fly){Nu($.new_run,$.no_fly);return}const i=n.display?.modes||[],s=n.display?.forms||[],r=n.frame?.mode||n.run?.mode||n.asked,o=i.map(a=>`<option value="${a.name}" ${a.name===r?"selected":""}>${Pe(a.label)}</option>`);ys(`<h3>${$.new_run}</h3><p>${$.new_run_text}</p>
    <p>${i.length?`<label>${$.mode} <select id="new-mode">${o.join("")}</select></label> &nbsp;`:""}
    <label>${$.seed} <input id="new-seed" size="15" inputmode="numeric" placeholder="${$.seed_hint}"></label></p>
    <div class="forms">${s.map(a=>h_(a,$h)).join("")}</div>
    <p id="new-error" class="alarm" role="alert">${Pe(e)}</p>
    <div class="buttons"><button data-close>${$.cancel}</button><button class="primary" id="new-start">${$.start}</button></div>`,a=>{a.classList.toggle("wide",s.length>0),a.onclose=()=>a.classList.remove("wide");const l=async()=>{const c=a.querySelector("#new-seed").value.trim(),u={do:"fly",mode:a.querySelector("#new-mode")?.value??null};c&&(u.seed=Number(c)),s.length&&(u.settings=$h=f_(a,s));const h=await t(u);h.ok?a.close():a.querySelector("#new-error").textContent=nl(h.code)};a.querySelector("#new-start").onclick=l,a.querySelector("#new-seed").onkeydown=c=>{c.key==="Enter"&&l()},a.querySelector("#new-start").focus()})}function Mp(n,t,e){const i=n.success,s=(o,a,l,c)=>`<tr><th>${Pe(o)}</th><td class="${c===!1?"alarm":""}">${Pe(a)}</td><td class="dim">${Pe(l)}</td></tr>`,r=n.measures.filter(o=>o.value!==null).map(o=>s(o.words,`${Xe(o.value,o.digits)} ${o.unit}`,mp(null,o,o.digits),o.ok));ys(`<h3>${$.verdict_title}</h3>
    <p class="verdict ${i?"ok":"alarm"}" id="verdict-words">${i?"✓":"✗"} ${Pe(jr(n.words))}</p>
    <table>${s($.verdict_time,`${Xe(n.duration,1)} s`,"",null)}${r.join("")}</table>
    <div class="buttons">${Yr}${t?`<button class="primary" id="again">${$.fly_again}</button>`:""}</div>`,o=>{const a=o.querySelector("#again");a&&(a.onclick=()=>{o.close(),e()})})}function il(){return Ro().open&&Ro().querySelector("#runs")!==null}const jr=n=>n.charAt(0).toUpperCase()+n.slice(1),d_=Object.freeze(Object.defineProperty({__proto__:null,close:el,closeButton:Yr,escape:Pe,help:Fu,message:Nu,newRun:xp,open:ys,refused:nl,runsShown:il,sentence:jr,verdict:Mp},Symbol.toStringTag,{value:"Module"})),we=$.desk,p_=5;class m_{constructor(t){this.link=t,this.task={hint:"",goal:"",display:null},this.state=null,this.mine=!1}show(t,e){const i=!this.state||JSON.stringify({...this.state,rest_s:0})!==JSON.stringify({...t,rest_s:0});this.state=t,this.mine=e,i&&this.draw()}lease(t){t!==this.mine&&(this.mine=t,this.state&&this.draw())}draw(){if(clearInterval(this.timer),!this.mine)return;const t=this.state.stage;t==="flying"?el():this[t]()}async ask(t,e,i){const s=await this.link.ask({do:"desk",act:t,...e}),r=i?.querySelector(".error");return!s.ok&&r&&(r.textContent=we.errors[s.code]||nl(s.code)),s.ok}frame(t,e,i,s){const r=ys(`<h3>${Pe(t)}</h3>${e}<p class="error alarm" role="alert"></p><div class="buttons">${i}</div>`,s);return r.oncancel=o=>o.preventDefault(),r}door(){this.frame(this.state.title,`<p>${we.door}</p><p><label>${we.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,`<button class="primary" id="desk-go">${we.begin}</button>`,t=>{const e=()=>this.ask("begin",{volunteer:Number(t.querySelector("#volunteer").value)},t);t.querySelector("#desk-go").onclick=e,t.querySelector("#volunteer").onkeydown=i=>{i.key==="Enter"&&e()},t.querySelector("#volunteer").focus()})}heading(){return oe(we.heading,{who:this.state.who,n:this.state.number,of:this.state.of})}ready(){const t=this.state.training?we.training:we.counts;this.frame(this.heading(),`<p>${t}</p><p>${oe(we.condition,{mode:Pe(tl(this.task.display,this.state.mode))})}</p><p class="dim">${Pe(this.task.hint)} ${we.clock}</p>`,`<button class="primary" id="desk-go">${we.fly}</button>`,e=>{e.querySelector("#desk-go").onclick=()=>this.ask("fly",{},e),e.querySelector("#desk-go").focus()})}rest(){const t=performance.now()+this.state.rest_s*1e3;this.frame(we.rest_title,`<p>${we.rest}</p><p class="verdict" id="rest-left"></p>`,`<button class="primary" id="desk-go">${we.go_on}</button>`,e=>{const i=e.querySelector("#desk-go");i.onclick=()=>this.ask("go_on",{},e);const s=()=>{const r=Math.max(0,(t-performance.now())/1e3);e.querySelector("#rest-left").textContent=`${r.toFixed(0)} s`,i.disabled=r>0};s(),this.timer=setInterval(s,500)})}done(){this.frame(we.done_title,`<p>${oe(we.done,{who:this.state.who})}</p>`,`<button id="desk-go">${we.next}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("leave",{},t)})}rate(){this.answers={},this.question("controllable")}question(t){const{verdict:e}=this.state,i=`<button data-answer="yes">${we.yes}</button><button data-answer="no">${we.no}</button>`;this.frame(`${this.heading()} · Cooper-Harper`,`<p class="${e.success?"ok":""}">${Pe(jr(e.words||""))}</p><p>${Pe(oe(we.tree[t],{goal:this.task.goal}))}</p>`,i,s=>{s.querySelector("[data-answer=yes]").focus();for(const r of s.querySelectorAll("[data-answer]"))r.onclick=()=>this.answered(t,r.dataset.answer==="yes")})}answered(t,e){const i=["controllable","adequate","satisfactory"];if(this.answers[t]=e,!e)for(const r of i.slice(i.indexOf(t)+1))this.answers[r]=!1;const s=i[i.indexOf(t)+1];e&&s?this.question(s):this.pick()}pick(){const{controllable:t,adequate:e,satisfactory:i}=this.answers,r=(t?e?i?[1,2,3]:[4,5,6]:[7,8,9]:[10]).map(o=>`<button data-rating="${o}"><b>${o}</b> ${we.ratings[o]}</button>`).join("");this.frame(`${this.heading()} · Cooper-Harper`,`<p>${we.pick}</p><div class="choices">${r}</div>`,`<button id="desk-back">${we.again}</button>`,o=>{o.querySelector("#desk-back").onclick=()=>this.rate();for(const a of o.querySelectorAll("[data-rating]"))a.onclick=()=>{this.answers.rating=Number(a.dataset.rating),this.tlx()};o.querySelector("[data-rating]").focus()})}tlx(){const t=Object.entries(we.tlx).map(([e,[i,s,r,o]])=>`<fieldset><legend>${i}</legend>
      <label for="tlx-${e}">${s}</label><input type="range" id="tlx-${e}" data-tlx="${e}" min="0" max="100" step="${p_}" value="50">
      <div class="scale-ends"><span>${r}</span><output id="out-${e}">–</output><span>${o}</span></div></fieldset>`).join("");this.frame(`${this.heading()} · NASA-TLX`,t,`<button class="primary" id="desk-go" disabled>${we.save}</button>`,e=>{const i=new Set,s=r=>{i.add(r.dataset.tlx),e.querySelector(`#out-${r.dataset.tlx}`).textContent=r.value,e.querySelector("#desk-go").disabled=i.size<Object.keys(we.tlx).length};for(const r of e.querySelectorAll("[data-tlx]"))r.oninput=()=>s(r),r.onkeydown=o=>{o.key==="Enter"&&s(r)},r.onpointerup=()=>s(r);e.querySelector("#desk-go").onclick=()=>{const r=Object.fromEntries([...e.querySelectorAll("[data-tlx]")].map(o=>[o.dataset.tlx,Number(o.value)]));this.ask("rate",{cooper_harper:this.answers,tlx:r},e)}})}weigh(t=[]){const{pairs:e}=this.state,i=e[t.length].map(r=>`<button data-scale="${r}"><b>${we.tlx[r][0]}</b> ${we.tlx[r][1]}</button>`).join(""),s=`${this.heading()} · NASA-TLX · ${oe(we.pair,{n:t.length+1,of:e.length})}`;this.frame(s,`<p>${we.weigh}</p><div class="choices">${i}</div>`,`<button id="desk-back">${we.again}</button>`,r=>{r.querySelector("#desk-back").onclick=()=>this.weigh();for(const o of r.querySelectorAll("[data-scale]"))o.onclick=()=>{const a=[...t,o.dataset.scale];a.length<e.length?this.weigh(a):this.ask("weigh",{chosen:a},r)};r.querySelector("[data-scale]").focus()})}}const[Ou,Sp,sl,Co,ku,Bu,zu]=[0,1,2,3,4,5,6],Cr=3,yp=6,Xh={[sl]:"✓",[Co]:"✓",[ku]:"✗",[Bu]:"✗",[zu]:"?"};function bp([n,t,e,i,s,r,o,...a]){return{seq:n,sent:t,due:e,kind:i,state:s,refusal:r,told:o,value:a}}function g_(n,t){return n.told>=0&&n.told<=t?n:{...n,state:t<n.due?Ou:Sp,told:-1}}const Ep=n=>n.kind===Cr&&(n.state===sl||n.state===Co);function __(n,t,e){const i=e.step_s,s=Math.max(n.due-n.sent,1);if(n.told>=0)return .8+.2*Math.min(1,(t-n.told)*i/yp);if(t<n.due)return .05+.37*((t-n.sent)/s);const r=Math.max(e.back_s/i,1);return .46+.34*Math.min(1,(t-n.due)/r)}function v_(n,t,e,i,s){const{pen:r,w:o,h:a,rem:l}=js(n),c=s/t.step_s,u=l*1.35,h=[[0,.05,$.ladder_ground],[.05,.42,$.ladder_link],[.42,.5,$.ladder_craft],[.5,.8,$.ladder_back],[.8,1,$.ladder_known]];for(const[v,m,p]of h)r.fillStyle=p===$.ladder_craft?"#17222e":"#0a1018",r.fillRect(v*o+1,u,(m-v)*o-2,a-u),v!==0&&ze(r,p,(v+m)/2*o,l*.55,Wt.dim,"center");ze(r,$.ladder_ground,0,l*.55,Wt.dim);const f=(a-u)/e.length;e.forEach((v,m)=>ze(r,v.name,l*.35,u+f*(m+.5),Wt.dim));const d=Math.max(2,.37*o/Math.max(t.forward_s/t.step_s,8)-1),g={top:u,lane:f,bottom:a,width:Math.min(d,l),rem:l};for(const v of i){const m=__(v,c,t);m>=1||v.told>=0&&(c-v.told)*t.step_s>yp||x_(r,v,m*o,e,g)}}function x_(n,t,e,i,{top:s,lane:r,bottom:o,width:a,rem:l}){const c=t.state===ku||t.state===Bu,u=t.value.some(f=>f!==0),h=t.kind===Cr||c?Wt.alarm:t.state===Co||t.state===sl?Wt.ok:t.state===zu?Wt.dim:t.state===Sp?Wt.predicted:Wt.measured;if(n.fillStyle=h,!u&&!c&&t.kind!==Cr){n.globalAlpha=t.state===Co?.25:.5,i.forEach((f,d)=>n.fillRect(e,s+r*(d+.5)-1,Math.max(a*.5,1),2)),n.globalAlpha=1;return}(t.kind===Cr||c)&&n.fillRect(e,s,Math.max(1.5,a*.4),o-s),i.forEach((f,d)=>{const g=t.value[d];if(!g)return;const v=Math.min(Math.abs(g)/f.highest,1)*r*.46,m=s+r*(d+.5);t.state===Ou&&(n.globalAlpha=.85),n.fillRect(e,g>0?m-v:m,a,v),n.globalAlpha=1}),Xh[t.state]&&c&&ze(n,Xh[t.state],e,s+l*.4,h)}function M_(n){const t={};for(const s of n)t[s.state]=(t[s.state]||0)+1;const i=[`${t[Ou]||0} ${$.ladder_link}`];for(const s of[sl,Co,ku,Bu,zu])t[s]&&i.push(`${t[s]} ${kg[s]}`);return i.join(" · ")}const qh=2500,S_=500,y_=800,b_=8e3,E_=n=>new Promise(t=>{setTimeout(t,n)});class w_{constructor(t,e){Object.assign(this,{link:t,store:e,wanted:null,unanswered:null})}async steer(t){this.unanswered=null,(await this.link.ask({...t,run:this.store.run?.name},qh)).code==="NO_ANSWER"&&(this.unanswered={wish:t,at:performance.now()})}async abort(){const t=this.store.run?.name;if(this.wanted&&!this.wanted.accepted&&this.goesOn(this.wanted))return;const e={run:t,times:0,since:performance.now(),accepted:!1};this.wanted=e;do{e.times+=1;const i=await this.link.ask({do:"abort",run:t},qh);e.accepted=i.ok,i.ok||await E_(S_)}while(!e.accepted&&this.goesOn(e))}goesOn({run:t}){const{store:e}=this;return e.run!==null&&e.run.name===t&&!e.verdict&&(e.status.phase==="flying"||!e.connected)}words(){const{store:t,wanted:e,unanswered:i}=this,s=t.connected?"":`${$.socket_closed}. `;if(e&&!this.goesOn(e))this.wanted=null;else{if(e&&!e.accepted)return performance.now()-e.since<y_?[$.abort_asked,""]:[$.abort_unconfirmed,s+oe($.abort_again,{n:e.times})];if(e&&t.abortAt===null&&t.connected)return[$.abort_accepted,t.frame?.paused?$.paused:""]}if(!i||performance.now()-i.at>b_||this.done(i.wish))return null;const r=i.wish.do==="mode"?tl(t.display,i.wish.mode):$[i.wish.do];return[oe($.unconfirmed,{name:r.toUpperCase()}),s+$.unconfirmed_hint]}done(t){const{frame:e,verdict:i,connected:s}=this.store;return i?!0:!e||!s?!1:t.do==="mode"?e.mode===t.mode:!!e.paused==(t.do==="pause")}}const T_=20,A_=4,wp="rvd.stick",Va=-1;function Yh(n,t){if(!Number.isFinite(n))return 0;const e=Math.min(Math.abs(n),1);return e<=t?0:Math.sign(n)*(e-t)/(1-t)}class R_{constructor(t){this.onChange=t,this.down=new Set,this.step=1,this.source="keyboard",this.pads=[],this.gamepad=null,this.settingUp=!1,this.settings=P_(),this.setController(null),addEventListener("keydown",i=>this.key(i,!0)),addEventListener("keyup",i=>this.key(i,!1));const e=()=>{this.down.clear(),this.send(!0)};addEventListener("blur",e),document.addEventListener("visibilitychange",e),setInterval(()=>this.poll(),T_)}setController(t){this.axes=t?.axes||[],this.deflections=t?.key_deflections||[1],this.step=Math.min(this.step,this.deflections.length),this.keys=new Map,this.buttons=t?.buttons||[],this.axes.forEach((e,i)=>e.keys.forEach(([s,r])=>this.keys.set(s,[i,1]).set(r,[i,-1]))),this.disarm()}taken(){this.down.clear(),this.disarm()}disarm(){this.armed=this.axes.map(()=>!1)}wiring(t,e){const i=this.settings.pads[t.id]?.axes[e.name];return i?i.axis<t.axes.length?i:null:t.mapping==="standard"&&e.pad_pair?e.pad_pair.every(s=>s<t.buttons.length)?{pair:e.pad_pair,sign:1}:null:t.mapping!=="standard"||e.pad_axis>=t.axes.length?null:{axis:e.pad_axis,sign:e.pad_inverted?-1:1}}button(t){const e=this.settings.pads[t.id]?.button??(t.mapping==="standard"?A_:null);return e!==null&&e<t.buttons.length?e:null}ready(t){return!this.settingUp&&this.button(t)!==null&&this.axes.every(e=>this.wiring(t,e)!==null)}lacks(){return this.pads.length?this.gamepad?this.ready(this.gamepad)?"":"setup":"choose":""}pick(t){this.change({chosen:{id:t.id,index:t.index??0}})}setUp(t,{axes:e={},button:i}){const s=this.settings.pads[t.id]||{axes:{},button:null},r={axes:{...s.axes,...e},button:i??s.button};this.change({pads:{...this.settings.pads,[t.id]:r}})}change(t){this.settings={...this.settings,...t},this.disarm(),Tg("local",wp,JSON.stringify(this.settings))}choose(){const{chosen:t}=this.settings,e=this.pads.filter(i=>i.id===t?.id);return e.length===1?e[0]:e.length>1?e.find(i=>i.index===t.index)||null:this.pads.length===1?this.pads[0]:null}deflection(t){return this.axes.map(e=>{const i=this.wiring(t,e);return i?i.pair?Yh(Kh(t,i.pair[0])-Kh(t,i.pair[1]),this.settings.deadZone):i.axis===Va?0:i.sign*Yh(t.axes[i.axis],this.settings.deadZone):null})}key(t,e){if(t.ctrlKey||t.metaKey||t.altKey||Hu(t.target)||e&&t.target instanceof Element&&t.target.closest("input, select, dialog"))return;const i=Number(/^(?:Digit|Numpad)([1-9])$/.exec(t.code)?.[1]);if(e&&i<=this.deflections.length){this.step=i,this.send(!0);return}const s=this.buttons.some(o=>o.key===t.code);if(!this.keys.has(t.code)&&!s&&t.code!=="Space"||t.code==="Space"&&!this.settings.holdSpace||(t.preventDefault(),t.repeat))return;const r=this.down.has(t.code);e?this.down.add(t.code):this.down.delete(t.code),e&&(this.source="keyboard"),r!==e&&this.send(!0)}poll(){this.pads=C_();const t=this.choose();(t?.id!==this.gamepad?.id||t?.index!==this.gamepad?.index)&&this.disarm(),this.gamepad=t,t&&this.ready(t)&&Ll(t,this.button(t))&&(this.source="gamepad"),this.holds()?this.deflection(t).forEach((e,i)=>{e===0&&(this.armed[i]=!0)}):this.disarm(),this.send(!1)}holds(){const t=this.gamepad;return this.source==="gamepad"&&jh()&&t!==null&&this.ready(t)&&Ll(t,this.button(t))}gone(){return this.source==="gamepad"&&this.gamepad===null}stuck(){return this.holds()?this.axes.filter((t,e)=>!this.armed[e]).map(t=>t.name):[]}pressed(){const t=this.source==="gamepad"?this.gamepad:null;return this.buttons.reduce((e,i,s)=>{const r=t?t.mapping==="standard"&&Ll(t,i.pad_button):this.down.has(i.key);return e|(r?1<<s:0)},0)}withButtons(t){return this.buttons.length?{...t,buttons:this.pressed()}:t}state(){if(this.source==="gamepad"){const i=this.holds();return this.withButtons({held:i,at:i?this.deflection(this.gamepad).map((s,r)=>this.armed[r]?s:0):this.axes.map(()=>0)})}const t=this.axes.map(()=>0);for(const i of this.down)this.keys.has(i)&&(t[this.keys.get(i)[0]]+=this.keys.get(i)[1]);const e=this.deflections[this.step-1];return this.withButtons({held:jh()&&(!this.settings.holdSpace||this.down.has("Space")),at:t.map(i=>Math.max(-1,Math.min(1,i))*e)})}send(t){this.onChange(this.state(),t)}}const jh=()=>document.visibilityState==="visible"&&document.hasFocus();function C_(){try{return[...navigator.getGamepads?.()||[]].filter(n=>n&&n.connected!==!1)}catch{return[]}}function Ll(n,t){return!!n.buttons[t]?.pressed}function Kh(n,t){const e=n.buttons[t];return e?Math.max(e.value??0,e.pressed&&!e.value?1:0):0}function Hu(n){return n instanceof Element&&!!n.closest("input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]")}function P_(){let n=null;try{n=JSON.parse(Ag("local",wp))}catch{}const t={};for(const[e,i]of Object.entries(n?.pads??{})){const s=Object.entries(i?.axes??{}).filter(([,r])=>Number.isInteger(r?.axis)&&r.axis>=Va&&Math.abs(r.sign)===1);t[e]={axes:Object.fromEntries(s),button:Number.isInteger(i?.button)&&i.button>=0?i.button:null}}return{pads:t,chosen:typeof n?.chosen?.id=="string"?n.chosen:null,holdSpace:n?.holdSpace===!0,deadZone:n?.deadZone>=0&&n.deadZone<=.4?Number(n.deadZone):.08}}const L_=60,[D_,Zh]=[.5,.3];function I_(n,t,e){if(t===null)return $.unknown;const{axes:i,digits:s}=n.commands;return i.length===n.controller.axes.length?Ac(t*i[e].highest,s):Ac(t,2)}class U_{constructor(t,e){Object.assign(this,{stick:t,display:e,seen:null,lead:null}),this.dialog=ys(`<h3>${$.settings_title}</h3><p id="pad-note" role="status"></p>
      <fieldset id="pads"><legend>${$.settings_pads}</legend></fieldset><p id="pad-lead" role="status"></p><div id="pad-steps" class="buttons"></div>
      <table id="pad-axes"></table>
      <p><label>${$.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${t.settings.deadZone}"></label></p>
      <p><label><input type="checkbox" id="hold-space" ${t.settings.holdSpace?"checked":""}> ${$.settings_space}</label></p>
      ${up?"":`<p class="alarm">${$.no_storage}</p>`}<div class="buttons">${Yr}</div>`),this.body=this.$("#pads"),this.dialog.onchange=i=>this.changed(i.target),this.timer=setInterval(()=>this.look(),L_),this.look()}$(t){return this.dialog.querySelector(t)}look(){const{stick:t}=this;if(!this.dialog.open||!this.dialog.contains(this.body)){clearInterval(this.timer),t.settingUp=!1;return}const e=t.gamepad,i=JSON.stringify([t.pads.map(s=>[s.id,s.index]),e?.index,t.settings.pads,t.settings.chosen]);i!==this.seen&&(this.lead&&this.lead.index!==e?.index&&this.stop(),this.seen=i,this.build()),t.pads.forEach((s,r)=>vn(this.$(`[data-live="${r}"]`),oe($.pad_live,{axes:s.axes.map(o=>Xe(o,2)).join(" "),buttons:s.buttons.flatMap((o,a)=>o.pressed?[a]:[]).join(" ")||$.pad_nothing}))),e&&(t.deflection(e).forEach((s,r)=>vn(this.$(`[data-now="${t.axes[r].name}"]`),I_(this.display,s,r))),this.lead&&this.follow(e))}build(){const{stick:t}=this,e=t.gamepad;this.$("#pads").hidden=!t.pads.length,this.$("#pads").innerHTML=`<legend>${$.settings_pads}</legend>${t.pads.map((r,o)=>`<p><label><input type="radio" name="pad" value="${o}" ${r===e?"checked":""}>
      ${Pe(r.id)}${r.mapping==="standard"?"":` (${$.pad_plain})`}</label><br><small class="dim num" data-live="${o}"></small></p>`).join("")}`;const i=e&&t.ready(e),s=t.pads.length?e?i||this.lead?$.pad_ready:$.pad_setup:$.pad_choose:$.settings_none;vn(this.$("#pad-note"),this.lead?"":s),this.$("#pad-note").className=!e||i?"":"alarm",this.$("#pad-axes").innerHTML=e?this.table(e):"",this.lead||this.buttons(e&&t.axes.length?[["pad-start",$.pad_start,()=>this.begin(e)]]:[])}table(t){const{stick:e}=this;return`${e.axes.map(s=>{const r=e.wiring(t,s);return`<tr><td>${Pe(`${s.positive} / ${s.negative}`)}</td>
        <td>${r?.pair?`${oe($.settings_pair,{plus:r.pair[0],minus:r.pair[1]})} `:""}<label>${$.settings_axis} <input type="number" class="short" min="${Va}" max="${t.axes.length-1}" data-axis="${s.name}" value="${r?.axis??""}"></label></td>
        <td><label><input type="checkbox" data-invert="${s.name}" ${r?.sign<0?"checked":""}> ${$.settings_invert}</label></td>
        <td>${$.settings_now} <b data-now="${s.name}"></b></td></tr>`}).join("")}<tr><td>${$.settings_button}</td><td colspan="3"><input type="number" class="short" min="0" max="${t.buttons.length-1}"
      id="pad-button" aria-label="${$.settings_button}" value="${e.button(t)??""}"></td></tr>`}changed(t){const{stick:e}=this,i=e.gamepad;if(t.name==="pad")e.pick(e.pads[Number(t.value)]);else if(t.id==="pad-zone")e.change({deadZone:Number(t.value)});else if(t.id==="hold-space")e.change({holdSpace:t.checked});else if(i&&t.validity.valid&&(t.type==="checkbox"||t.value!=="")){const s=t.dataset.axis||t.dataset.invert;t.id==="pad-button"?e.setUp(i,{button:Number(t.value)}):s&&this.$(`[data-axis="${s}"]`).value!==""&&e.setUp(i,{axes:{[s]:{axis:Number(this.$(`[data-axis="${s}"]`).value),sign:this.$(`[data-invert="${s}"]`).checked?-1:1}}})}}buttons(t){this.$("#pad-steps").replaceChildren(...t.map(([e,i,s])=>{const r=document.createElement("button");return Object.assign(r,{id:e,textContent:i,onclick:s}),r}))}begin(t){this.stick.settingUp=!0,this.lead={index:t.index,at:-1,axes:{},back:null},this.seen=null,this.say($.pad_rest),this.buttons([["pad-next",$.pad_next,()=>{Object.assign(this.lead,{rest:[...this.stick.gamepad.axes],down:this.stick.gamepad.buttons.map(e=>e.pressed)}),this.next()}],["pad-stop",$.pad_stop,()=>this.stop()]])}say(t){vn(this.$("#pad-lead"),t)}stop(){this.stick.settingUp=!1,this.lead=null,this.seen=null,this.say("")}next(){const{lead:t,stick:e}=this;t.at+=1;const i=e.axes[t.at];if(!i){this.say($.pad_hold),this.buttons([["pad-stop",$.pad_stop,()=>this.stop()]]);return}this.say(oe($.pad_move,{what:i.positive,name:i.name})),this.buttons([["pad-skip",$.pad_skip,()=>{t.axes[i.name]={axis:Va,sign:1},this.next()}],["pad-stop",$.pad_stop,()=>this.stop()]])}follow(t){const{lead:e,stick:i}=this;if(e.at<0)return;const s=t.axes.map((c,u)=>c-e.rest[u]);if(e.back!==null){if(Math.abs(s[e.back])>Zh)return;e.back=null,this.next();return}const r=i.axes[e.at];if(!r){const c=t.buttons.findIndex((h,f)=>h.pressed&&!e.down[f]);if(c<0)return;const{axes:u}=e;this.stop(),i.setUp(t,{axes:u,button:c});return}const o=Object.values(e.axes).map(c=>c.axis),a=s.map((c,u)=>o.includes(u)?0:Math.abs(c)),l=a.indexOf(Math.max(...a));if(a[l]>D_){if(Math.abs(e.rest[l])>Zh){this.say(`${oe($.pad_trigger,{axis:l})} ${oe($.pad_move,{what:r.positive,name:r.name})}`);return}e.axes[r.name]={axis:l,sign:Math.sign(s[l])},e.back=l,this.say($.pad_back)}}}function Tp(n,t){return new U_(n,t)}const N_=!0,an="u-",F_="uplot",O_=an+"hz",k_=an+"vt",B_=an+"title",z_=an+"wrap",H_=an+"under",V_=an+"over",G_=an+"axis",Bs=an+"off",W_=an+"select",$_=an+"cursor-x",X_=an+"cursor-y",q_=an+"cursor-pt",Y_=an+"legend",j_=an+"live",K_=an+"inline",Z_=an+"series",J_=an+"marker",Jh=an+"label",Q_=an+"value",Mo="width",So="height",ho="top",Qh="bottom",ur="left",Dl="right",Vu="#000",tf=Vu+"0",Il="mousemove",ef="mousedown",Ul="mouseup",nf="mouseenter",sf="mouseleave",rf="dblclick",t0="resize",e0="scroll",of="change",Ga="dppxchange",Gu="--",Kr=typeof window<"u",Rc=Kr?document:null,Pr=Kr?window:null,n0=Kr?navigator:null;let be,qo;function Cc(){let n=devicePixelRatio;be!=n&&(be=n,qo&&Lc(of,qo,Cc),qo=matchMedia(`(min-resolution: ${be-.001}dppx) and (max-resolution: ${be+.001}dppx)`),Ws(of,qo,Cc),Pr.dispatchEvent(new CustomEvent(Ga)))}function qn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Pc(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Be(n,t,e){n.style[t]=e+"px"}function gi(n,t,e,i){let s=Rc.createElement(n);return t!=null&&qn(s,t),e?.insertBefore(s,i),s}function ii(n,t){return gi("div",n,t)}const af=new WeakMap;function Ri(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=af.get(n);r!=o&&(n.style.transform=r,af.set(n,r),t<0||e<0||t>i||e>s?qn(n,Bs):Pc(n,Bs))}const lf=new WeakMap;function cf(n,t,e){let i=t+e,s=lf.get(n);i!=s&&(lf.set(n,i),n.style.background=t,n.style.borderColor=e)}const uf=new WeakMap;function hf(n,t,e,i){let s=t+""+e,r=uf.get(n);s!=r&&(uf.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}const Wu={passive:!0},i0={...Wu,capture:!0};function Ws(n,t,e,i){t.addEventListener(n,e,i?i0:Wu)}function Lc(n,t,e,i){t.removeEventListener(n,e,Wu)}Kr&&Cc();function _i(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Kn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Ap(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}const Rp=n=>n!=null,Cp=n=>n!=null&&n>0,rl=Ap(Rp),s0=Ap(Cp);function r0(n,t,e,i=0,s=!1){let r=s?s0:rl,o=s?Cp:Rp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??De,l??-De]}function ol(n,t,e,i){let s=pf(n),r=pf(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ji:Pp,a=s==1?Kn:ri,l=r==1?ri:Kn,c=a(o(nn(n))),u=l(o(nn(t))),h=kr(e,c),f=kr(e,u);return e==10&&(c<0&&(h=Ie(h,-c)),u<0&&(f=Ie(f,-u))),i||e==2?(n=h*s,t=f*r):(n=Up(n,h),t=al(t,f)),[n,t]}function $u(n,t,e,i){let s=ol(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}const Xu=.1,ff={mode:3,pad:Xu},wo={pad:0,soft:null,mode:0},o0={min:wo,max:wo};function Wa(n,t,e,i){return ll(e)?df(n,t,e):(wo.pad=e,wo.soft=i?0:null,wo.mode=i?3:0,df(n,t,o0))}function Me(n,t){return n??t}function a0(n,t,e){for(t=Me(t,0),e=Me(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function df(n,t,e){let i=e.min,s=e.max,r=Me(i.pad,0),o=Me(s.pad,0),a=Me(i.hard,-De),l=Me(s.hard,De),c=Me(i.soft,De),u=Me(s.soft,-De),h=Me(i.mode,0),f=Me(s.mode,0),d=t-n,g=Ji(d),v=In(nn(n),nn(t)),m=Ji(v),p=nn(m-g);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,h==2&&c!=De&&(r=0),f==2&&u!=-De&&(o=0)));let y=d||v||1e3,T=Ji(y),x=kr(10,Kn(T)),U=y*(d==0?n==0?.1:1:r),A=Ie(Up(n-U,x/10),24),D=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:De,I=In(a,A<D&&n>=D?D:vi(D,A)),w=y*(d==0?t==0?.1:1:o),S=Ie(al(t+w,x/10),24),C=t<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-De,V=vi(l,S>C&&t<=C?C:In(C,S));return I==V&&I==0&&(V=100),[I,V]}const l0=new Intl.NumberFormat(Kr?n0.language:"en-US"),qu=n=>l0.format(n),Jn=Math,Ia=Jn.PI,nn=Jn.abs,Kn=Jn.floor,en=Jn.round,ri=Jn.ceil,vi=Jn.min,In=Jn.max,kr=Jn.pow,pf=Jn.sign,Ji=Jn.log10,Pp=Jn.log2,c0=(n,t=1)=>Jn.sinh(n)*t,Nl=(n,t=1)=>Jn.asinh(n/t),De=1/0;function mf(n){return(Ji((n^n>>31)-(n>>31))|0)+1}function Dc(n,t,e){return vi(In(n,t),e)}function Lp(n){return typeof n=="function"}function le(n){return Lp(n)?n:()=>n}const u0=()=>{},Dp=n=>n,Ip=(n,t)=>t,h0=n=>null,gf=n=>!0,_f=(n,t)=>n==t,f0=/\.\d*?(?=9{6,}|0{6,})/gm,$s=n=>{if(Fp(n)||xs.has(n))return n;const t=`${n}`,e=t.match(f0);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${$s(s)}e${r}`}return Ie(n,i)};function Ns(n,t){return $s(Ie($s(n/t))*t)}function al(n,t){return $s(ri($s(n/t))*t)}function Up(n,t){return $s(Kn($s(n/t))*t)}function Ie(n,t=0){if(Fp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return en(i)/e}const xs=new Map;function Np(n){return((""+n).split(".")[1]||"").length}function Po(n,t,e,i){let s=[],r=i.map(Np);for(let o=t;o<e;o++){let a=nn(o),l=Ie(kr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Ie(u,h);s.push(f),xs.set(f,h)}}return s}const To={},Yu=[],Br=[null,null],ps=Array.isArray,Fp=Number.isInteger,d0=n=>n===void 0;function vf(n){return typeof n=="string"}function ll(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function p0(n){return n!=null&&typeof n=="object"}const m0=Object.getPrototypeOf(Uint8Array),Op="__proto__";function zr(n,t=ll){let e;if(ps(n)){let i=n.find(s=>s!=null);if(ps(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=zr(n[s],t)}else e=n.slice()}else if(n instanceof m0)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Op&&(e[i]=zr(n[i],t))}else e=n;return e}function Ze(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Op&&(ll(n[s])?Ze(n[s],zr(i[s])):n[s]=zr(i[s]))}return n}const g0=0,_0=1,v0=2;function x0(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function M0(n,t){if(b0(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return E0(o[0])||(o=y0(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:_0,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?f!=g0&&(h[m]=v,f==v0&&d.push(m)):h[m]=v}x0(h,d,s),i.push(h)}}return i}const S0=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function y0(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function b0(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function E0(n,t=100){const e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=In(1,Kn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const kp=["January","February","March","April","May","June","July","August","September","October","November","December"],Bp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function zp(n){return n.slice(0,3)}const w0=Bp.map(zp),T0=kp.map(zp),A0={MMMM:kp,MMM:T0,WWWW:Bp,WWW:w0};function fo(n){return(n<10?"0":"")+n}function R0(n){return(n<10?"00":n<100?"0":"")+n}const C0={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>fo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>fo(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>fo(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>fo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>fo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>R0(n.getMilliseconds())};function ju(n,t){t=t||A0;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?C0[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const P0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function L0(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==P0?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}const Hp=n=>n%1==0,$a=[1,2,2.5,5],D0=Po(10,-32,0,$a),Vp=Po(10,0,32,$a),I0=Vp.filter(Hp),Fs=D0.concat(Vp),Ku=`
`,Gp="{YYYY}",xf=Ku+Gp,Wp="{M}/{D}",yo=Ku+Wp,Yo=yo+"/{YY}",$p="{aa}",U0="{h}:{mm}",wr=U0+$p,Mf=Ku+wr,Sf=":{ss}",Te=null;function Xp(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Po(10,0,3,$a).filter(Hp):Po(10,-3,0,$a)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Gp,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",xf,Te,Te,Te,Te,Te,1],[s,Wp,xf,Te,Te,Te,Te,Te,1],[i,"{h}"+$p,Yo,Te,yo,Te,Te,Te,1],[e,wr,Yo,Te,yo,Te,Te,Te,1],[t,Sf,Yo+" "+wr,Te,yo+" "+wr,Te,Mf,Te,1],[n,Sf+".{fff}",Yo+" "+wr,Te,yo+" "+wr,Te,Mf,Te,1]];function u(h){return(f,d,g,v,m,p)=>{let y=[],T=m>=o,x=m>=r&&m<o,U=h(g),A=Ie(U*n,3),D=Fl(U.getFullYear(),T?0:U.getMonth(),x||T?1:U.getDate()),I=Ie(D*n,3);if(x||T){let w=x?m/r:0,S=T?m/o:0,C=A==I?A:Ie(Fl(D.getFullYear()+S,D.getMonth()+w,1)*n,3),V=new Date(en(C/n)),N=V.getFullYear(),G=V.getMonth();for(let Z=0;C<=v;Z++){let K=Fl(N+S*Z,G+w*Z,1),Q=K-h(Ie(K*n,3));C=Ie((+K+Q)*n,3),C<=v&&y.push(C)}}else{let w=m>=s?s:m,S=Kn(g)-Kn(A),C=I+S+al(A-I,w);y.push(C);let V=h(C),N=V.getHours()+V.getMinutes()/e+V.getSeconds()/i,G=m/i,Z=f.axes[d]._space,K=p/Z;for(;C=Ie(C+m,n==1?0:3),!(C>v);)if(G>1){let Q=Kn(Ie(N+G,6))%24,ct=h(C).getHours()-Q;ct>1&&(ct=-1),C-=ct*i,N=(N+G)%24;let mt=y[y.length-1];Ie((C-mt)/m,3)*K>=.7&&y.push(C)}else y.push(C)}return y}}return[l,c,u]}const[N0,F0,O0]=Xp(1),[k0,B0,z0]=Xp(.001);Po(2,-53,53,[1]);function yf(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function bf(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,f,d;return i.map(g=>{let v=n(g),m=v.getFullYear(),p=v.getMonth(),y=v.getDate(),T=v.getHours(),x=v.getMinutes(),U=v.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||T!=h&&a[5]||x!=f&&a[6]||U!=d&&a[7]||a[1];return l=m,c=p,u=y,h=T,f=x,d=U,A(v)})}}function H0(n,t){let e=ju(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Fl(n,t,e){return new Date(n,t,e)}function Ef(n,t){return t(n)}const V0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function wf(n,t){return(e,i,s,r)=>r==null?Gu:t(n(i))}function G0(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function W0(n,t){return n.series[t].fill(n,t)}const $0={show:!0,live:!0,isolate:!1,mount:u0,markers:{show:!0,width:2,stroke:G0,fill:W0,dash:"solid"},idx:null,idxs:null,values:[]};function X0(n,t){let e=n.cursor.points,i=ii(),s=e.size(n,t);Be(i,Mo,s),Be(i,So,s);let r=s/-2;Be(i,"marginLeft",r),Be(i,"marginTop",r);let o=e.width(n,t,s);return o&&Be(i,"borderWidth",o),i}function q0(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Y0(n,t){let e=n.series[t].points;return e._stroke||e._fill}function j0(n,t){return n.series[t].points.size}const Ol=[0,0];function K0(n,t,e){return Ol[0]=t,Ol[1]=e,Ol}function jo(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function kl(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}const Z0={show:!0,x:!0,y:!0,lock:!1,move:K0,points:{one:!1,show:X0,size:j0,width:0,stroke:Y0,fill:q0},bind:{mousedown:jo,mouseup:jo,click:jo,dblclick:jo,mousemove:kl,mouseleave:kl,mouseenter:kl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},qp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Zu=Ze({},qp,{filter:Ip}),Yp=Ze({},Zu,{size:10}),jp=Ze({},qp,{show:!1}),Ju='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Kp="bold "+Ju,Zp=1.5,Tf={show:!0,scale:"x",stroke:Vu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Kp,side:2,grid:Zu,ticks:Yp,border:jp,font:Ju,lineGap:Zp,rotate:0},J0="Value",Q0="Time",Af={show:!0,scale:"x",auto:!1,sorted:1,min:De,max:-De,idxs:[]};function tv(n,t,e,i,s){return t.map(r=>r==null?"":qu(r))}function ev(n,t,e,i,s,r,o){let a=[],l=xs.get(s)||0;e=o?e:Ie(al(e,s),l);for(let c=e;c<=i;c=Ie(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Ic(n,t,e,i,s,r,o){const a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ji:Pp,u=Kn(c(e));s=kr(l,u),l==10&&(s=Fs[_i(s,Fs)]);let h=e,f=s*l;l==10&&(f=Fs[_i(f,Fs)]);do a.push(h),h=h+s,l==10&&!xs.has(h)&&(h=Ie(h,xs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Fs[_i(f,Fs)]));while(h<=i);return a}function nv(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Ic(n,t,In(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Ic(n,t,In(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}const Jp=/./,iv=/[12357]/,sv=/[125]/,Rf=/1/,Uc=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function rv(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Jp:l(7,o)-u>=c?iv:l(5,o)-u>=c?sv:Rf;if(h==Rf){let f=nn(l(1,o)-u);if(f<c)return Uc(t.slice().reverse(),a.distr,h,ri(c/f)).reverse()}return Uc(t,a.distr,h,1)}function ov(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=nn(l(1,o)-l(2,o));return c<a?Uc(t.slice().reverse(),3,Jp,ri(a/c)).reverse():t}function av(n,t,e,i){return i==null?Gu:t==null?"":qu(t)}const Cf={show:!0,scale:"y",stroke:Vu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Kp,side:3,grid:Zu,ticks:Yp,border:jp,font:Ju,lineGap:Zp,rotate:0};function lv(n,t){let e=3+(n||1)*2;return Ie(e*t,3)}function cv(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=nn(o-r),l=n.series[t],c=a/(l.points.space*be);return i[1]-i[0]<=c}const Pf={scale:null,auto:!0,sorted:0,min:De,max:-De},Qp=(n,t,e,i,s)=>s,Lf={show:!0,auto:!0,sorted:0,gaps:Qp,alpha:1,facets:[Ze({},Pf,{scale:"x"}),Ze({},Pf,{scale:"y"})]},Df={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Qp,alpha:1,points:{show:cv,filter:null},values:null,min:De,max:-De,idxs:[],path:null,clip:null};function uv(n,t,e,i,s){return e/10}const tm={time:N_,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},hv=Ze({},tm,{time:!1,ori:1}),If={};function em(n,t){let e=If[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(If[n]=e)),e}const Hr=1,Nc=2;function Ks(n,t,e){const i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,v,ul,Zr,fl,im,rm):e(s,l,c,u,h,p,m,d,f,v,g,hl,Jr,eh,sm,om)}function Qu(n,t){let e=0,i=0,s=Me(n.bands,Yu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function fv(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Qi(n,t,e,i,s,r){return Ks(n,t,(o,a,l,c,u,h,f,d,g,v,m)=>{let p=o.pxRound;const y=c.dir*(c.ori==0?1:-1),T=c.ori==0?Zr:Jr;let x,U;y==1?(x=e,U=i):(x=i,U=e);let A=p(h(a[x],c,v,d)),D=p(f(l[x],u,m,g)),I=p(h(a[U],c,v,d)),w=p(f(r==1?u.max:u.min,u,m,g)),S=new Path2D(s);return T(S,I,w),T(S,A,w),T(S,A,D),S})}function cl(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=t==0?fl:eh;let l=e;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function dv(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function th(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(n[h]),g=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=d&&a.push([d,g])}return a}function Uf(n){return n==0?Dp:n==1?en:t=>Ns(t,n)}function nm(n){let t=n==0?ul:hl,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=vi(c,a/2,l/2),u=vi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const ul=(n,t,e)=>{n.moveTo(t,e)},hl=(n,t,e)=>{n.moveTo(e,t)},Zr=(n,t,e)=>{n.lineTo(t,e)},Jr=(n,t,e)=>{n.lineTo(e,t)},fl=nm(0),eh=nm(1),im=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},sm=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},rm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},om=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function am(n){return(t,e,i,s,r)=>Ks(t,e,(o,a,l,c,u,h,f,d,g,v,m)=>{let{pxRound:p,points:y}=o,T,x;c.ori==0?(T=ul,x=im):(T=hl,x=sm);const U=Ie(y.width*be,3);let A=(y.size-y.width)/2*be,D=Ie(A*2,3),I=new Path2D,w=new Path2D,{left:S,top:C,width:V,height:N}=t.bbox;fl(w,S-D,C-D,V+D*2,N+D*2);const G=Z=>{if(l[Z]!=null){let K=p(h(a[Z],c,v,d)),Q=p(f(l[Z],u,m,g));T(I,K+A,Q),x(I,K,Q,A,0,Ia*2)}};if(r)r.forEach(G);else for(let Z=i;Z<=s;Z++)G(Z);return{stroke:U>0?I:null,fill:I,clip:w,flags:Hr|Nc}})}function lm(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}const pv=lm(Zr),mv=lm(Jr);function cm(n){const t=Me(n?.alignGaps,0);return(e,i,s,r)=>Ks(e,i,(o,a,l,c,u,h,f,d,g,v,m)=>{[s,r]=rl(l,s,r);let p=o.pxRound,y=N=>p(h(N,c,v,d)),T=N=>p(f(N,u,m,g)),x,U;c.ori==0?(x=Zr,U=pv):(x=Jr,U=mv);const A=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},I=D.stroke;let w=!1;if(r-s>=v*4){let N=pt=>e.posToVal(pt,c.key,!0),G=null,Z=null,K,Q,tt,ht=y(a[A==1?s:r]),ct=y(a[s]),mt=y(a[r]),Mt=N(A==1?ct+1:mt-1);for(let pt=A==1?s:r;pt>=s&&pt<=r;pt+=A){let it=a[pt],gt=(A==1?it<Mt:it>Mt)?ht:y(it),ot=l[pt];gt==ht?ot!=null?(Q=ot,G==null?(x(I,gt,T(Q)),K=G=Z=Q):Q<G?G=Q:Q>Z&&(Z=Q)):ot===null&&(w=!0):(G!=null&&U(I,ht,T(G),T(Z),T(K),T(Q)),ot!=null?(Q=ot,x(I,gt,T(Q)),G=Z=K=Q):(G=Z=null,ot===null&&(w=!0)),ht=gt,Mt=N(ht+A))}G!=null&&G!=Z&&tt!=ht&&U(I,ht,T(G),T(Z),T(K),T(Q))}else for(let N=A==1?s:r;N>=s&&N<=r;N+=A){let G=l[N];G===null?w=!0:G!=null&&x(I,y(a[N]),T(G))}let[C,V]=Qu(e,i);if(o.fill!=null||C!=0){let N=D.fill=new Path2D(I),G=o.fillTo(e,i,o.min,o.max,C),Z=T(G),K=y(a[s]),Q=y(a[r]);A==-1&&([Q,K]=[K,Q]),x(N,Q,Z),x(N,K,Z)}if(!o.spanGaps){let N=[];w&&N.push(...th(a,l,s,r,A,y,t)),D.gaps=N=o.gaps(e,i,s,r,N),D.clip=cl(N,c.ori,d,g,v,m)}return V!=0&&(D.band=V==2?[Qi(e,i,s,r,I,-1),Qi(e,i,s,r,I,1)]:Qi(e,i,s,r,I,V)),D})}function gv(n){const t=Me(n.align,1),e=Me(n.ascDesc,!1),i=Me(n.alignGaps,0),s=Me(n.extend,!1);return(r,o,a,l)=>Ks(r,o,(c,u,h,f,d,g,v,m,p,y,T)=>{[a,l]=rl(h,a,l);let x=c.pxRound,{left:U,width:A}=r.bbox,D=ct=>x(g(ct,f,y,m)),I=ct=>x(v(ct,d,T,p)),w=f.ori==0?Zr:Jr;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},C=S.stroke,V=f.dir*(f.ori==0?1:-1);let N=I(h[V==1?a:l]),G=D(u[V==1?a:l]),Z=G,K=G;s&&t==-1&&(K=U,w(C,K,N)),w(C,G,N);for(let ct=V==1?a:l;ct>=a&&ct<=l;ct+=V){let mt=h[ct];if(mt==null)continue;let Mt=D(u[ct]),pt=I(mt);t==1?w(C,Mt,N):w(C,Z,pt),w(C,Mt,pt),N=pt,Z=Mt}let Q=Z;s&&t==1&&(Q=U+A,w(C,Q,N));let[tt,ht]=Qu(r,o);if(c.fill!=null||tt!=0){let ct=S.fill=new Path2D(C),mt=c.fillTo(r,o,c.min,c.max,tt),Mt=I(mt);w(ct,Q,Mt),w(ct,K,Mt)}if(!c.spanGaps){let ct=[];ct.push(...th(u,h,a,l,V,D,i));let mt=c.width*be/2,Mt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(it=>{it[0]+=Mt,it[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=cl(ct,f.ori,m,p,y,T)}return ht!=0&&(S.band=ht==2?[Qi(r,o,a,l,C,-1),Qi(r,o,a,l,C,1)]:Qi(r,o,a,l,C,ht)),S})}function Nf(n,t,e,i,s,r,o=De){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=nn(n[l]-n[a]);u<c&&(c=u,o=nn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function _v(n){n=n||To;const t=Me(n.size,[.6,De,1]),e=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=le(s),o=1-t[0],a=Me(t[1],De),l=Me(t[2],1),c=Me(n.disp,To),u=Me(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,v,m)=>Ks(d,g,(p,y,T,x,U,A,D,I,w,S,C)=>{let V=p.pxRound,N=e,G=i*be,Z=a*be,K=l*be,Q,tt;x.ori==0?[Q,tt]=r(d,g):[tt,Q]=r(d,g);const ht=x.dir*(x.ori==0?1:-1);let ct=x.ori==0?fl:eh,mt=x.ori==0?u:(W,et,St,_t,wt,Zt,ft)=>{u(W,et,St,wt,_t,ft,Zt)},Mt=Me(d.bands,Yu).find(W=>W.series[0]==g),pt=Mt!=null?Mt.dir:0,it=p.fillTo(d,g,p.min,p.max,pt),at=V(D(it,U,C,w)),gt,ot,Bt,Ht=S,Ut=V(p.width*be),fe=!1,Jt=null,de=null,z=null,Qe=null;h!=null&&(Ut==0||f!=null)&&(fe=!0,Jt=h.values(d,g,v,m),de=new Map,new Set(Jt).forEach(W=>{W!=null&&de.set(W,new Path2D)}),Ut>0&&(z=f.values(d,g,v,m),Qe=new Map,new Set(z).forEach(W=>{W!=null&&Qe.set(W,new Path2D)})));let{x0:te,size:ne}=c;if(te!=null&&ne!=null){N=1,y=te.values(d,g,v,m),te.unit==2&&(y=y.map(St=>d.posToVal(I+St*S,x.key,!0)));let W=ne.values(d,g,v,m);ne.unit==2?ot=W[0]*S:ot=A(W[0],x,S,I)-A(0,x,S,I),Ht=Nf(y,T,A,x,S,I,Ht),Bt=Ht-ot+G}else Ht=Nf(y,T,A,x,S,I,Ht),Bt=Ht*o+G,ot=Ht-Bt;Bt<1&&(Bt=0),Ut>=ot/2&&(Ut=0),Bt<5&&(V=Dp);let Vt=Bt>0,me=Ht-Bt-(Vt?Ut:0);ot=V(Dc(me,K,Z)),gt=(N==0?ot/2:N==ht?0:ot)-N*ht*((N==0?G/2:0)+(Vt?Ut/2:0));const Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=fe?null:new Path2D;let b=null;if(Mt!=null)b=d.data[Mt.series[1]];else{let{y0:W,y1:et}=c;W!=null&&et!=null&&(T=et.values(d,g,v,m),b=W.values(d,g,v,m))}let j=Q*ot,J=tt*ot;for(let W=ht==1?v:m;W>=v&&W<=m;W+=ht){let et=T[W];if(et==null)continue;if(b!=null){let Ot=b[W]??0;if(et-Ot==0)continue;at=D(Ot,U,C,w)}let St=x.distr!=2||c!=null?y[W]:W,_t=A(St,x,S,I),wt=D(Me(et,it),U,C,w),Zt=V(_t-gt),ft=V(In(wt,at)),vt=V(vi(wt,at)),Nt=ft-vt;if(et!=null){let Ot=et<0?J:j,bt=et<0?j:J;fe?(Ut>0&&z[W]!=null&&ct(Qe.get(z[W]),Zt,vt+Kn(Ut/2),ot,In(0,Nt-Ut),Ot,bt),Jt[W]!=null&&ct(de.get(Jt[W]),Zt,vt+Kn(Ut/2),ot,In(0,Nt-Ut),Ot,bt)):ct(P,Zt,vt+Kn(Ut/2),ot,In(0,Nt-Ut),Ot,bt),mt(d,g,W,Zt-Ut/2,vt,ot+Ut,Nt)}}return Ut>0?Pt.stroke=fe?Qe:P:fe||(Pt._fill=p.width==0?p._fill:p._stroke??p._fill,Pt.width=0),Pt.fill=fe?de:P,Pt})}function vv(n,t){const e=Me(t?.alignGaps,0);return(i,s,r,o)=>Ks(i,s,(a,l,c,u,h,f,d,g,v,m,p)=>{[r,o]=rl(c,r,o);let y=a.pxRound,T=Q=>y(f(Q,u,m,g)),x=Q=>y(d(Q,h,p,v)),U,A,D;u.ori==0?(U=ul,D=Zr,A=rm):(U=hl,D=Jr,A=om);const I=u.dir*(u.ori==0?1:-1);let w=T(l[I==1?r:o]),S=w,C=[],V=[];for(let Q=I==1?r:o;Q>=r&&Q<=o;Q+=I)if(c[Q]!=null){let ht=l[Q],ct=T(ht);C.push(S=ct),V.push(x(c[Q]))}const N={stroke:n(C,V,U,D,A,y),fill:null,clip:null,band:null,gaps:null,flags:Hr},G=N.stroke;let[Z,K]=Qu(i,s);if(a.fill!=null||Z!=0){let Q=N.fill=new Path2D(G),tt=a.fillTo(i,s,a.min,a.max,Z),ht=x(tt);D(Q,S,ht),D(Q,w,ht)}if(!a.spanGaps){let Q=[];Q.push(...th(l,c,r,o,I,T,e)),N.gaps=Q=a.gaps(i,s,r,o,Q),N.clip=cl(Q,u.ori,g,v,m,p)}return K!=0&&(N.band=K==2?[Qi(i,s,r,o,G,-1),Qi(i,s,r,o,G,1)]:Qi(i,s,r,o,G,K)),N})}function xv(n){return vv(Mv,n)}function Mv(n,t,e,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,t[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,n[f+1],t[f+1])}return a}const Fc=new Set;function Ff(){for(let n of Fc)n.syncRect(!0)}Kr&&(Ws(t0,Pr,Ff),Ws(e0,Pr,Ff,!0),Ws(Ga,Pr,()=>{En.pxRatio=be}));const Sv=cm(),yv=am();function Of(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Oc(r,o,t,e))}function bv(n,t){return n.map((e,i)=>i==0?{}:Ze({},t,e))}function Oc(n,t,e,i){return Ze({},t==0?e:i,n)}function um(n,t,e){return t==null?Br:[t,e]}const Ev=um;function wv(n,t,e){return t==null?Br:Wa(t,e,Xu,!0)}function hm(n,t,e,i){return t==null?Br:ol(t,e,n.scales[i].log,!1)}const Tv=hm;function fm(n,t,e,i){return t==null?Br:$u(t,e,n.scales[i].log,!1)}const Av=fm;function Rv(n,t,e,i,s){let r=In(mf(n),mf(t)),o=t-n,a=_i(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?xs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function kf(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=en((e=+s)*be))+"px"),[n,t,e]}function Cv(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ie(t[2]*be,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function En(n,t,e){const i={mode:Me(n.mode,1)},s=i.mode;function r(_,M,R,L){let F=M.valToPct(_);return L+R*(M.dir==-1?1-F:F)}function o(_,M,R,L){let F=M.valToPct(_);return L+R*(M.dir==-1?F:1-F)}function a(_,M,R,L){return M.ori==0?r(_,M,R,L):o(_,M,R,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=ii(F_);if(n.id!=null&&(c.id=n.id),qn(c,n.class),n.title){let _=ii(B_,c);_.textContent=n.title}const u=gi("canvas"),h=i.ctx=u.getContext("2d"),f=ii(z_,c);Ws("click",f,_=>{_.target===g&&(Fe!=rr||We!=or)&&_n.click(i,_)},!0);const d=i.under=ii(H_,f);f.appendChild(u);const g=i.over=ii(V_,f);n=zr(n);const v=+Me(n.pxAlign,1),m=Uf(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});const p=n.ms||.001,y=i.series=s==1?Of(n.series||[],Af,Df,!1):bv(n.series||[null],Lf),T=i.axes=Of(n.axes||[],Tf,Cf,!0),x=i.scales={},U=i.bands=n.bands||[];U.forEach(_=>{_.fill=le(_.fill||null),_.dir=Me(_.dir,-1)});const A=s==2?y[1].facets[0].scale:y[0].scale,D={axes:hg,series:Qn},I=(n.drawOrder||["axes","series"]).map(_=>D[_]);function w(_){const M=_.distr==3?R=>Ji(R>0?R:_.clamp(i,R,_.min,_.max,_.key)):_.distr==4?R=>Nl(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=M(R),{_min:F,_max:Y}=_,st=Y-F;return(L-F)/st}}function S(_){let M=x[_];if(M==null){let R=(n.scales||To)[_]||To;if(R.from!=null){S(R.from);let L=Ze({},x[R.from],R,{key:_});L.valToPct=w(L),x[_]=L}else{M=x[_]=Ze({},_==A?tm:hv,R),M.key=_;let L=M.time,F=M.range,Y=ps(F);if((_!=A||s==2&&!L)&&(Y&&(F[0]==null||F[1]==null)&&(F={min:F[0]==null?ff:{mode:1,hard:F[0],soft:F[0]},max:F[1]==null?ff:{mode:1,hard:F[1],soft:F[1]}},Y=!1),!Y&&ll(F))){let st=F;F=(lt,dt,Rt)=>dt==null?Br:Wa(dt,Rt,st)}M.range=le(F||(L?Ev:_==A?M.distr==3?Tv:M.distr==4?Av:um:M.distr==3?hm:M.distr==4?fm:wv)),M.auto=le(Y?!1:M.auto),M.clamp=le(M.clamp||uv),M._min=M._max=null,M.valToPct=w(M)}}}S("x"),S("y"),s==1&&y.forEach(_=>{S(_.scale)}),T.forEach(_=>{S(_.scale)});for(let _ in n.scales)S(_);const C=x[A],V=C.distr;let N,G;C.ori==0?(qn(c,O_),N=r,G=o):(qn(c,k_),N=o,G=r);const Z={};for(let _ in x){let M=x[_];(M.min!=null||M.max!=null)&&(Z[_]={min:M.min,max:M.max},M.min=M.max=null)}const K=n.tzDate||(_=>new Date(en(_/p))),Q=n.fmtDate||ju,tt=p==1?O0(K):z0(K),ht=bf(K,yf(p==1?F0:B0,Q)),ct=wf(K,Ef(V0,Q)),mt=[],Mt=i.legend=Ze({},$0,n.legend),pt=i.cursor=Ze({},Z0,{drag:{y:s==2}},n.cursor),it=Mt.show,at=pt.show,gt=Mt.markers;Mt.idxs=mt,gt.width=le(gt.width),gt.dash=le(gt.dash),gt.stroke=le(gt.stroke),gt.fill=le(gt.fill);let ot,Bt,Ht,Ut=[],fe=[],Jt,de=!1,z={};if(Mt.live){const _=y[1]?y[1].values:null;de=_!=null,Jt=de?_(i,1,0):{_:0};for(let M in Jt)z[M]=Gu}if(it)if(ot=gi("table",Y_,c),Ht=gi("tbody",null,ot),Mt.mount(i,ot),de){Bt=gi("thead",null,ot,Ht);let _=gi("tr",null,Bt);gi("th",null,_);for(var Qe in Jt)gi("th",Jh,_).textContent=Qe}else qn(ot,K_),Mt.live&&qn(ot,j_);const te={show:!0},ne={show:!1};function Vt(_,M){if(M==0&&(de||!Mt.live||s==2))return Br;let R=[],L=gi("tr",Z_,Ht,Ht.childNodes[M]);qn(L,_.class),_.show||qn(L,Bs);let F=gi("th",null,L);if(gt.show){let lt=ii(J_,F);if(M>0){let dt=gt.width(i,M);dt&&(lt.style.border=dt+"px "+gt.dash(i,M)+" "+gt.stroke(i,M)),lt.style.background=gt.fill(i,M)}}let Y=ii(Jh,F);_.label instanceof HTMLElement?Y.appendChild(_.label):Y.textContent=_.label,M>0&&(gt.show||(Y.style.color=_.width>0?gt.stroke(i,M):gt.fill(i,M)),Pt("click",F,lt=>{if(pt._lock)return;tn(lt);let dt=y.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Rt=y.some((Ct,Lt)=>Lt>0&&Lt!=dt&&Ct.show);y.forEach((Ct,Lt)=>{Lt>0&&Ei(Lt,Rt?Lt==dt?te:ne:te,!0,je.setSeries)})}else Ei(dt,{show:!_.show},!0,je.setSeries)},!1),zi&&Pt(nf,F,lt=>{pt._lock||(tn(lt),Ei(y.indexOf(_),lr,!0,je.setSeries))},!1));for(var st in Jt){let lt=gi("td",Q_,L);lt.textContent="--",R.push(lt)}return[L,R]}const me=new Map;function Pt(_,M,R,L=!0){const F=me.get(M)||{},Y=pt.bind[_](i,M,R,L);Y&&(Ws(_,M,F[_]=Y),me.set(M,F))}function P(_,M,R){const L=me.get(M)||{};for(let F in L)(_==null||F==_)&&(Lc(F,M,L[F]),delete L[F]);_==null&&me.delete(M)}let b=0,j=0,J=0,W=0,et=0,St=0,_t=et,wt=St,Zt=J,ft=W,vt=0,Nt=0,Ot=0,bt=0;i.bbox={};let se=!1,Yt=!1,ge=!1,k=!1,xt=!1,nt=!1;function rt(_,M,R){(R||_!=i.width||M!=i.height)&&Tt(_,M),er(!1),ge=!0,Yt=!0,nr()}function Tt(_,M){i.width=b=J=_,i.height=j=W=M,et=St=0,cn(),Se();let R=i.bbox;vt=R.left=Ns(et*be,.5),Nt=R.top=Ns(St*be,.5),Ot=R.width=Ns(J*be,.5),bt=R.height=Ns(W*be,.5)}const At=3;function Qt(){let _=!1,M=0;for(;!_;){M++;let R=cg(M),L=ug(M);_=M==At||R&&L,_||(Tt(i.width,i.height),Yt=!0)}}function Ve({width:_,height:M}){rt(_,M)}i.setSize=Ve;function cn(){let _=!1,M=!1,R=!1,L=!1;T.forEach((F,Y)=>{if(F.show&&F._show){let{side:st,_size:lt}=F,dt=st%2,Rt=F.label!=null?F.labelSize:0,Ct=lt+Rt;Ct>0&&(dt?(J-=Ct,st==3?(et+=Ct,L=!0):R=!0):(W-=Ct,st==0?(St+=Ct,_=!0):M=!0))}}),Si[0]=_,Si[1]=R,Si[2]=M,Si[3]=L,J-=E[1]+E[3],et+=E[3],W-=E[2]+E[0],St+=E[0]}function Se(){let _=et+J,M=St+W,R=et,L=St;function F(Y,st){switch(Y){case 1:return _+=st,_-st;case 2:return M+=st,M-st;case 3:return R-=st,R+st;case 0:return L-=st,L+st}}T.forEach((Y,st)=>{if(Y.show&&Y._show){let lt=Y.side;Y._pos=F(lt,Y._size),Y.label!=null&&(Y._lpos=F(lt,Y.labelSize))}})}if(pt.dataIdx==null){let _=pt.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let R=_.prox=le(_.prox),L=_.bias??=0;pt.dataIdx=(F,Y,st,lt)=>{if(Y==0)return st;let dt=st,Rt=R(F,Y,st,lt)??De,Ct=Rt>=0&&Rt<De,Lt=C.ori==0?J:W,jt=pt.left,ye=t[0],xe=t[Y];if(M.has(xe[st])){dt=null;let re=null,Xt=null,zt;if(L==0||L==-1)for(zt=st;re==null&&zt-- >0;)M.has(xe[zt])||(re=zt);if(L==0||L==1)for(zt=st;Xt==null&&zt++<xe.length;)M.has(xe[zt])||(Xt=zt);if(re!=null||Xt!=null)if(Ct){let ke=re==null?-1/0:N(ye[re],C,Lt,0),qe=Xt==null?1/0:N(ye[Xt],C,Lt,0),pn=jt-ke,Re=qe-jt;pn<=Re?pn<=Rt&&(dt=re):Re<=Rt&&(dt=Xt)}else dt=Xt==null?re:re==null?Xt:st-re<=Xt-st?re:Xt}else Ct&&nn(jt-N(ye[st],C,Lt,0))>Rt&&(dt=null);return dt}}const tn=_=>{pt.event=_};pt.idxs=mt,pt._lock=!1;let Ue=pt.points;Ue.show=le(Ue.show),Ue.size=le(Ue.size),Ue.stroke=le(Ue.stroke),Ue.width=le(Ue.width),Ue.fill=le(Ue.fill);const Hn=i.focus=Ze({},n.focus||{alpha:.3},pt.focus),zi=Hn.prox>=0,Un=zi&&Ue.one;let xn=[],Hi=[],Vi=[];function bs(_,M){let R=Ue.show(i,M);if(R instanceof HTMLElement)return qn(R,q_),qn(R,_.class),Ri(R,-10,-10,J,W),g.insertBefore(R,xn[M]),R}function ro(_,M){if(s==1||M>0){let R=s==1&&x[_.scale].time,L=_.value;_.value=R?vf(L)?wf(K,Ef(L,Q)):L||ct:L||av,_.label=_.label||(R?Q0:J0)}if(Un||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Sv||h0,_.fillTo=le(_.fillTo||fv),_.pxAlign=+Me(_.pxAlign,v),_.pxRound=Uf(_.pxAlign),_.stroke=le(_.stroke||null),_.fill=le(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=lv(In(1,_.width),1),L=_.points=Ze({},{size:R,width:In(1,R*.2),stroke:_.stroke,space:R*2,paths:yv,_stroke:null,_fill:null},_.points);L.show=le(L.show),L.filter=le(L.filter),L.fill=le(L.fill),L.stroke=le(L.stroke),L.paths=le(L.paths),L.pxAlign=_.pxAlign}if(it){let R=Vt(_,M);Ut.splice(M,0,R[0]),fe.splice(M,0,R[1]),Mt.values.push(null)}if(at){mt.splice(M,0,null);let R=null;Un?M==0&&(R=bs(_,M)):M>0&&(R=bs(_,M)),xn.splice(M,0,R),Hi.splice(M,0,0),Vi.splice(M,0,0)}dn("addSeries",M)}function Qs(_,M){M=M??y.length,_=s==1?Oc(_,M,Af,Df):Oc(_,M,{},Lf),y.splice(M,0,_),ro(y[M],M)}i.addSeries=Qs;function Oo(_){if(y.splice(_,1),it){Mt.values.splice(_,1),fe.splice(_,1);let M=Ut.splice(_,1)[0];P(null,M.firstChild),M.remove()}at&&(mt.splice(_,1),xn.splice(_,1)[0].remove(),Hi.splice(_,1),Vi.splice(_,1)),dn("delSeries",_)}i.delSeries=Oo;const Si=[!1,!1,!1,!1];function xl(_,M){if(_._show=_.show,_.show){let R=_.side%2,L=x[_.scale];L==null&&(_.scale=R?y[1].scale:A,L=x[_.scale]);let F=L.time;_.size=le(_.size),_.space=le(_.space),_.rotate=le(_.rotate),ps(_.incrs)&&_.incrs.forEach(st=>{!xs.has(st)&&xs.set(st,Np(st))}),_.incrs=le(_.incrs||(L.distr==2?I0:F?p==1?N0:k0:Fs)),_.splits=le(_.splits||(F&&L.distr==1?tt:L.distr==3?Ic:L.distr==4?nv:ev)),_.stroke=le(_.stroke),_.grid.stroke=le(_.grid.stroke),_.ticks.stroke=le(_.ticks.stroke),_.border.stroke=le(_.border.stroke);let Y=_.values;_.values=ps(Y)&&!ps(Y[0])?le(Y):F?ps(Y)?bf(K,yf(Y,Q)):vf(Y)?H0(K,Y):Y||ht:Y||tv,_.filter=le(_.filter||(L.distr>=3&&L.log==10?rv:L.distr==3&&L.log==2?ov:Ip)),_.font=kf(_.font),_.labelFont=kf(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Si[M]=!0,_._el=ii(G_,f))}}function Es(_,M,R,L){let[F,Y,st,lt]=R,dt=M%2,Rt=0;return dt==0&&(lt||Y)&&(Rt=M==0&&!F||M==2&&!st?en(Tf.size/3):0),dt==1&&(F||st)&&(Rt=M==1&&!Y||M==3&&!lt?en(Cf.size/2):0),Rt}const ko=i.padding=(n.padding||[Es,Es,Es,Es]).map(_=>le(Me(_,Es))),E=i._padding=ko.map((_,M)=>_(i,M,Si,0));let O,X=null,q=null;const H=s==1?y[0].idxs:null;let ut=null,yt=!1;function Ft(_,M){if(t=_??[],i.data=i._data=t,s==2){O=0;for(let R=1;R<y.length;R++)O+=t[R][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ut=t[0],O=ut.length;let R=t;if(V==2){R=t.slice();let L=R[0]=Array(O);for(let F=0;F<O;F++)L[F]=F}i._data=t=R}if(er(!0),dn("setData"),V==2&&(ge=!0),M!==!1){let R=C;R.auto(i,yt)?Dt():rs(A,R.min,R.max),k=k||pt.left>=0,nt=!0,nr()}}i.setData=Ft;function Dt(){yt=!0;let _,M;s==1&&(O>0?(X=H[0]=0,q=H[1]=O-1,_=t[0][X],M=t[0][q],V==2?(_=X,M=q):_==M&&(V==3?[_,M]=ol(_,_,C.log,!1):V==4?[_,M]=$u(_,_,C.log,!1):C.time?M=_+en(86400/p):[_,M]=Wa(_,M,Xu,!0))):(X=H[0]=_=null,q=H[1]=M=null)),rs(A,_,M)}let $t,qt,It,ae,Ee,Ae,un,pe,kt,Ge;function _e(_,M,R,L,F,Y){_??=tf,R??=Yu,L??="butt",F??=tf,Y??="round",_!=$t&&(h.strokeStyle=$t=_),F!=qt&&(h.fillStyle=qt=F),M!=It&&(h.lineWidth=It=M),Y!=Ee&&(h.lineJoin=Ee=Y),L!=Ae&&(h.lineCap=Ae=L),R!=ae&&h.setLineDash(ae=R)}function Nn(_,M,R,L){M!=qt&&(h.fillStyle=qt=M),_!=un&&(h.font=un=_),R!=pe&&(h.textAlign=pe=R),L!=kt&&(h.textBaseline=kt=L)}function yi(_,M,R,L,F=0){if(L.length>0&&_.auto(i,yt)&&(M==null||M.min==null)){let Y=Me(X,0),st=Me(q,L.length-1),lt=R.min==null?r0(L,Y,st,F,_.distr==3):[R.min,R.max];_.min=vi(_.min,R.min=lt[0]),_.max=In(_.max,R.max=lt[1])}}const Mn={min:null,max:null};function ws(){for(let L in x){let F=x[L];Z[L]==null&&(F.min==null||Z[A]!=null&&F.auto(i,yt))&&(Z[L]=Mn)}for(let L in x){let F=x[L];Z[L]==null&&F.from!=null&&Z[F.from]!=null&&(Z[L]=Mn)}Z[A]!=null&&er(!0);let _={};for(let L in Z){let F=Z[L];if(F!=null){let Y=_[L]=zr(x[L],p0);if(F.min!=null)Ze(Y,F);else if(L!=A||s==2)if(O==0&&Y.from==null){let st=Y.range(i,null,null,L);Y.min=st[0],Y.max=st[1]}else Y.min=De,Y.max=-De}}if(O>0){y.forEach((L,F)=>{if(s==1){let Y=L.scale,st=Z[Y];if(st==null)return;let lt=_[Y];if(F==0){let dt=lt.range(i,lt.min,lt.max,Y);lt.min=dt[0],lt.max=dt[1],X=_i(lt.min,t[0]),q=_i(lt.max,t[0]),q-X>1&&(t[0][X]<lt.min&&X++,t[0][q]>lt.max&&q--),L.min=ut[X],L.max=ut[q]}else L.show&&L.auto&&yi(lt,st,L,t[F],L.sorted);L.idxs[0]=X,L.idxs[1]=q}else if(F>0&&L.show&&L.auto){let[Y,st]=L.facets,lt=Y.scale,dt=st.scale,[Rt,Ct]=t[F],Lt=_[lt],jt=_[dt];Lt!=null&&yi(Lt,Z[lt],Y,Rt,Y.sorted),jt!=null&&yi(jt,Z[dt],st,Ct,st.sorted),L.min=st.min,L.max=st.max}});for(let L in _){let F=_[L],Y=Z[L];if(F.from==null&&(Y==null||Y.min==null)){let st=F.range(i,F.min==De?null:F.min,F.max==-De?null:F.max,L);F.min=st[0],F.max=st[1]}}}for(let L in _){let F=_[L];if(F.from!=null){let Y=_[F.from];if(Y.min==null)F.min=F.max=null;else{let st=F.range(i,Y.min,Y.max,L);F.min=st[0],F.max=st[1]}}}let M={},R=!1;for(let L in _){let F=_[L],Y=x[L];if(Y.min!=F.min||Y.max!=F.max){Y.min=F.min,Y.max=F.max;let st=Y.distr;Y._min=st==3?Ji(Y.min):st==4?Nl(Y.min,Y.asinh):st==100?Y.fwd(Y.min):Y.min,Y._max=st==3?Ji(Y.max):st==4?Nl(Y.max,Y.asinh):st==100?Y.fwd(Y.max):Y.max,M[L]=R=!0}}if(R){y.forEach((L,F)=>{s==2?F>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)ge=!0,dn("setScale",L);at&&pt.left>=0&&(k=nt=!0)}for(let L in Z)Z[L]=null}function Le(_){let M=Dc(X-1,0,O-1),R=Dc(q+1,0,O-1);for(;_[M]==null&&M>0;)M--;for(;_[R]==null&&R<O-1;)R++;return[M,R]}function Qn(){if(O>0){let _=y.some(M=>M._focus)&&Ge!=Hn.alpha;_&&(h.globalAlpha=Ge=Hn.alpha),y.forEach((M,R)=>{if(R>0&&M.show&&(is(R,!1),is(R,!0),M._paths==null)){let L=Ge;Ge!=M.alpha&&(h.globalAlpha=Ge=M.alpha);let F=s==2?[0,t[R][0].length-1]:Le(t[R]);M._paths=M.paths(i,R,F[0],F[1]),Ge!=L&&(h.globalAlpha=Ge=L)}}),y.forEach((M,R)=>{if(R>0&&M.show){let L=Ge;Ge!=M.alpha&&(h.globalAlpha=Ge=M.alpha),M._paths!=null&&wn(R,!1);{let F=M._paths!=null?M._paths.gaps:null,Y=M.points.show(i,R,X,q,F),st=M.points.filter(i,R,Y,F);(Y||st)&&(M.points._paths=M.points.paths(i,R,X,q,st),wn(R,!0))}Ge!=L&&(h.globalAlpha=Ge=L),dn("drawSeries",R)}}),_&&(h.globalAlpha=Ge=1)}}function is(_,M){let R=M?y[_].points:y[_];R._stroke=R.stroke(i,_),R._fill=R.fill(i,_)}function wn(_,M){let R=M?y[_].points:y[_],{stroke:L,fill:F,clip:Y,flags:st,_stroke:lt=R._stroke,_fill:dt=R._fill,_width:Rt=R.width}=R._paths;Rt=Ie(Rt*be,3);let Ct=null,Lt=Rt%2/2;M&&dt==null&&(dt=Rt>0?"#fff":lt);let jt=R.pxAlign==1&&Lt>0;if(jt&&h.translate(Lt,Lt),!M){let ye=vt-Rt/2,xe=Nt-Rt/2,re=Ot+Rt,Xt=bt+Rt;Ct=new Path2D,Ct.rect(ye,xe,re,Xt)}M?tr(lt,Rt,R.dash,R.cap,dt,L,F,st,Y):bi(_,lt,Rt,R.dash,R.cap,dt,L,F,st,Ct,Y),jt&&h.translate(-Lt,-Lt)}function bi(_,M,R,L,F,Y,st,lt,dt,Rt,Ct){let Lt=!1;dt!=0&&U.forEach((jt,ye)=>{if(jt.series[0]==_){let xe=y[jt.series[1]],re=t[jt.series[1]],Xt=(xe._paths||To).band;ps(Xt)&&(Xt=jt.dir==1?Xt[0]:Xt[1]);let zt,ke=null;xe.show&&Xt&&a0(re,X,q)?(ke=jt.fill(i,ye)||Y,zt=xe._paths.clip):Xt=null,tr(M,R,L,F,ke,st,lt,dt,Rt,Ct,zt,Xt),Lt=!0}}),Lt||tr(M,R,L,F,Y,st,lt,dt,Rt,Ct)}const ui=Hr|Nc;function tr(_,M,R,L,F,Y,st,lt,dt,Rt,Ct,Lt){_e(_,M,R,L,F),(dt||Rt||Lt)&&(h.save(),dt&&h.clip(dt),Rt&&h.clip(Rt)),Lt?(lt&ui)==ui?(h.clip(Lt),Ct&&h.clip(Ct),zo(F,st),Bo(_,Y,M)):lt&Nc?(zo(F,st),h.clip(Lt),Bo(_,Y,M)):lt&Hr&&(h.save(),h.clip(Lt),Ct&&h.clip(Ct),zo(F,st),h.restore(),Bo(_,Y,M)):(zo(F,st),Bo(_,Y,M)),(dt||Rt||Lt)&&h.restore()}function Bo(_,M,R){R>0&&(M instanceof Map?M.forEach((L,F)=>{h.strokeStyle=$t=F,h.stroke(L)}):M!=null&&_&&h.stroke(M))}function zo(_,M){M instanceof Map?M.forEach((R,L)=>{h.fillStyle=qt=L,h.fill(R)}):M!=null&&_&&h.fill(M)}function lg(_,M,R,L){let F=T[_],Y;if(L<=0)Y=[0,0];else{let st=F._space=F.space(i,_,M,R,L),lt=F._incrs=F.incrs(i,_,M,R,L,st);Y=Rv(M,R,lt,L,st)}return F._found=Y}function Ml(_,M,R,L,F,Y,st,lt,dt,Rt){let Ct=st%2/2;v==1&&h.translate(Ct,Ct),_e(lt,st,dt,Rt,lt),h.beginPath();let Lt,jt,ye,xe,re=F+(L==0||L==3?-Y:Y);R==0?(jt=F,xe=re):(Lt=F,ye=re);for(let Xt=0;Xt<_.length;Xt++)M[Xt]!=null&&(R==0?Lt=ye=_[Xt]:jt=xe=_[Xt],h.moveTo(Lt,jt),h.lineTo(ye,xe));h.stroke(),v==1&&h.translate(-Ct,-Ct)}function cg(_){let M=!0;return T.forEach((R,L)=>{if(!R.show)return;let F=x[R.scale];if(F.min==null){R._show&&(M=!1,R._show=!1,er(!1));return}else R._show||(M=!1,R._show=!0,er(!1));let Y=R.side,st=Y%2,{min:lt,max:dt}=F,[Rt,Ct]=lg(L,lt,dt,st==0?J:W);if(Ct==0)return;let Lt=F.distr==2,jt=R._splits=R.splits(i,L,lt,dt,Rt,Ct,Lt),ye=F.distr==2?jt.map(zt=>ut[zt]):jt,xe=F.distr==2?ut[jt[1]]-ut[jt[0]]:Rt,re=R._values=R.values(i,R.filter(i,ye,L,Ct,xe),L,Ct,xe);R._rotate=Y==2?R.rotate(i,re,L,Ct):0;let Xt=R._size;R._size=ri(R.size(i,re,L,_)),Xt!=null&&R._size!=Xt&&(M=!1)}),M}function ug(_){let M=!0;return ko.forEach((R,L)=>{let F=R(i,L,Si,_);F!=E[L]&&(M=!1),E[L]=F}),M}function hg(){for(let _=0;_<T.length;_++){let M=T[_];if(!M.show||!M._show)continue;let R=M.side,L=R%2,F,Y,st=M.stroke(i,_),lt=R==0||R==3?-1:1,[dt,Rt]=M._found;if(M.label!=null){let An=M.labelGap*lt,Wn=en((M._lpos+An)*be);Nn(M.labelFont[0],st,"center",R==2?ho:Qh),h.save(),L==1?(F=Y=0,h.translate(Wn,en(Nt+bt/2)),h.rotate((R==3?-Ia:Ia)/2)):(F=en(vt+Ot/2),Y=Wn);let Rs=Lp(M.label)?M.label(i,_,dt,Rt):M.label;h.fillText(Rs,F,Y),h.restore()}if(Rt==0)continue;let Ct=x[M.scale],Lt=L==0?Ot:bt,jt=L==0?vt:Nt,ye=M._splits,xe=Ct.distr==2?ye.map(An=>ut[An]):ye,re=Ct.distr==2?ut[ye[1]]-ut[ye[0]]:dt,Xt=M.ticks,zt=M.border,ke=Xt.show?Xt.size:0,qe=en(ke*be),pn=en((M.alignTo==2?M._size-ke-M.gap:M.gap)*be),Re=M._rotate*-Ia/180,Ye=m(M._pos*be),Vn=(qe+pn)*lt,Tn=Ye+Vn;Y=L==0?Tn:0,F=L==1?Tn:0;let ti=M.font[0],hi=M.align==1?ur:M.align==2?Dl:Re>0?ur:Re<0?Dl:L==0?"center":R==3?Dl:ur,Ti=Re||L==1?"middle":R==2?ho:Qh;Nn(ti,st,hi,Ti);let Gn=M.font[1]*M.lineGap,ei=ye.map(An=>m(a(An,Ct,Lt,jt))),fi=M._values;for(let An=0;An<fi.length;An++){let Wn=fi[An];if(Wn!=null){L==0?F=ei[An]:Y=ei[An],Wn=""+Wn;let Rs=Wn.indexOf(`
`)==-1?[Wn]:Wn.split(/\n/gm);for(let Rn=0;Rn<Rs.length;Rn++){let Oh=Rs[Rn];Re?(h.save(),h.translate(F,Y+Rn*Gn),h.rotate(Re),h.fillText(Oh,0,0),h.restore()):h.fillText(Oh,F,Y+Rn*Gn)}}}Xt.show&&Ml(ei,Xt.filter(i,xe,_,Rt,re),L,R,Ye,qe,Ie(Xt.width*be,3),Xt.stroke(i,_),Xt.dash,Xt.cap);let Ai=M.grid;Ai.show&&Ml(ei,Ai.filter(i,xe,_,Rt,re),L,L==0?2:1,L==0?Nt:vt,L==0?bt:Ot,Ie(Ai.width*be,3),Ai.stroke(i,_),Ai.dash,Ai.cap),zt.show&&Ml([Ye],[1],L==0?1:0,L==0?1:2,L==1?Nt:vt,L==1?bt:Ot,Ie(zt.width*be,3),zt.stroke(i,_),zt.dash,zt.cap)}dn("drawAxes")}function er(_){y.forEach((M,R)=>{R>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let Ho=!1,Sl=!1,oo=[];function fg(){Sl=!1;for(let _=0;_<oo.length;_++)dn(...oo[_]);oo.length=0}function nr(){Ho||(S0(xh),Ho=!0)}function dg(_,M=!1){Ho=!0,Sl=M,_(i),xh(),M&&oo.length>0&&queueMicrotask(fg)}i.batch=dg;function xh(){if(se&&(ws(),se=!1),ge&&(Qt(),ge=!1),Yt){if(Be(d,ur,et),Be(d,ho,St),Be(d,Mo,J),Be(d,So,W),Be(g,ur,et),Be(g,ho,St),Be(g,Mo,J),Be(g,So,W),Be(f,Mo,b),Be(f,So,j),u.width=en(b*be),u.height=en(j*be),T.forEach(({_el:_,_show:M,_size:R,_pos:L,side:F})=>{if(_!=null)if(M){let Y=F===3||F===0?R:0,st=F%2==1;Be(_,st?"left":"top",L-Y),Be(_,st?"width":"height",R),Be(_,st?"top":"left",st?St:et),Be(_,st?"height":"width",st?W:J),Pc(_,Bs)}else qn(_,Bs)}),$t=qt=It=Ee=Ae=un=pe=kt=ae=null,Ge=1,co(!0),et!=_t||St!=wt||J!=Zt||W!=ft){er(!1);let _=J/Zt,M=W/ft;if(at&&!k&&pt.left>=0){pt.left*=_,pt.top*=M,ir&&Ri(ir,en(pt.left),0,J,W),sr&&Ri(sr,0,en(pt.top),J,W);for(let R=0;R<xn.length;R++){let L=xn[R];L!=null&&(Hi[R]*=_,Vi[R]*=M,Ri(L,ri(Hi[R]),ri(Vi[R]),J,W))}}if(Oe.show&&!xt&&Oe.left>=0&&Oe.width>0){Oe.left*=_,Oe.width*=_,Oe.top*=M,Oe.height*=M;for(let R in Al)Be(ar,R,Oe[R])}_t=et,wt=St,Zt=J,ft=W}dn("setSize"),Yt=!1}b>0&&j>0&&(h.clearRect(0,0,u.width,u.height),dn("drawClear"),I.forEach(_=>_()),dn("draw")),Oe.show&&xt&&(Vo(Oe),xt=!1),at&&k&&(As(null,!0,!1),k=!1),Mt.show&&Mt.live&&nt&&(wl(),nt=!1),l||(l=!0,i.status=1,dn("ready")),yt=!1,Ho=!1}i.redraw=(_,M)=>{ge=M||!1,_!==!1?rs(A,C.min,C.max):nr()};function yl(_,M){let R=x[_];if(R.from==null){if(O==0){let L=R.range(i,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(O>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&R.distr==2&&O>0&&(M.min=_i(M.min,t[0]),M.max=_i(M.max,t[0]),M.min==M.max&&M.max++),Z[_]=M,se=!0,nr()}}i.setScale=yl;let bl,El,ir,sr,Mh,Sh,rr,or,yh,bh,Fe,We,ss=!1;const _n=pt.drag;let hn=_n.x,fn=_n.y;at&&(pt.x&&(bl=ii($_,g)),pt.y&&(El=ii(X_,g)),C.ori==0?(ir=bl,sr=El):(ir=El,sr=bl),Fe=pt.left,We=pt.top);const Oe=i.select=Ze({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ar=Oe.show?ii(W_,Oe.over?g:d):null;function Vo(_,M){if(Oe.show){for(let R in _)Oe[R]=_[R],R in Al&&Be(ar,R,_[R]);M!==!1&&dn("setSelect")}}i.setSelect=Vo;function pg(_){if(y[_].show)it&&Pc(Ut[_],Bs);else if(it&&qn(Ut[_],Bs),at){let R=Un?xn[0]:xn[_];R!=null&&Ri(R,-10,-10,J,W)}}function rs(_,M,R){yl(_,{min:M,max:R})}function Ei(_,M,R,L){M.focus!=null&&xg(_),M.show!=null&&y.forEach((F,Y)=>{Y>0&&(_==Y||_==null)&&(F.show=M.show,pg(Y),s==2?(rs(F.facets[0].scale,null,null),rs(F.facets[1].scale,null,null)):rs(F.scale,null,null),nr())}),R!==!1&&dn("setSeries",_,M),L&&uo("setSeries",i,_,M)}i.setSeries=Ei;function mg(_,M){Ze(U[_],M)}function gg(_,M){_.fill=le(_.fill||null),_.dir=Me(_.dir,-1),M=M??U.length,U.splice(M,0,_)}function _g(_){_==null?U.length=0:U.splice(_,1)}i.addBand=gg,i.setBand=mg,i.delBand=_g;function vg(_,M){y[_].alpha=M,at&&xn[_]!=null&&(xn[_].style.opacity=M),it&&Ut[_]&&(Ut[_].style.opacity=M)}let Gi,os,Ts;const lr={focus:!0};function xg(_){if(_!=Ts){let M=_==null,R=Hn.alpha!=1;y.forEach((L,F)=>{if(s==1||F>0){let Y=M||F==0||F==_;L._focus=M?null:Y,R&&vg(F,Y?1:Hn.alpha)}}),Ts=_,R&&nr()}}it&&zi&&Pt(sf,ot,_=>{pt._lock||(tn(_),Ts!=null&&Ei(null,lr,!0,je.setSeries))});function wi(_,M,R){let L=x[M];R&&(_=_/be-(L.ori==1?St:et));let F=J;L.ori==1&&(F=W,_=F-_),L.dir==-1&&(_=F-_);let Y=L._min,st=L._max,lt=_/F,dt=Y+(st-Y)*lt,Rt=L.distr;return Rt==3?kr(10,dt):Rt==4?c0(dt,L.asinh):Rt==100?L.bwd(dt):dt}function Mg(_,M){let R=wi(_,A,M);return _i(R,t[0],X,q)}i.valToIdx=_=>_i(_,t[0]),i.posToIdx=Mg,i.posToVal=wi,i.valToPos=(_,M,R)=>x[M].ori==0?r(_,x[M],R?Ot:J,R?vt:0):o(_,x[M],R?bt:W,R?Nt:0),i.setCursor=(_,M,R)=>{Fe=_.left,We=_.top,As(null,M,R)};function Eh(_,M){Be(ar,ur,Oe.left=_),Be(ar,Mo,Oe.width=M)}function wh(_,M){Be(ar,ho,Oe.top=_),Be(ar,So,Oe.height=M)}let ao=C.ori==0?Eh:wh,lo=C.ori==1?Eh:wh;function Sg(){if(it&&Mt.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&de)continue;let M=Mt.values[_],R=0;for(let L in M)fe[_][R++].firstChild.nodeValue=M[L]}}function wl(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{mt[L]=R}):d0(_.idx)||mt.fill(_.idx),Mt.idx=mt[0]),it&&Mt.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!de)&&yg(R,mt[R]);Sg()}nt=!1,M!==!1&&dn("setLegend")}i.setLegend=wl;function yg(_,M){let R=y[_],L=_==0&&V==2?ut:t[_],F;de?F=R.values(i,_,M)??z:(F=R.value(i,M==null?null:L[M],_,M),F=F==null?z:{_:F}),Mt.values[_]=F}function As(_,M,R){yh=Fe,bh=We,[Fe,We]=pt.move(i,Fe,We),pt.left=Fe,pt.top=We,at&&(ir&&Ri(ir,en(Fe),0,J,W),sr&&Ri(sr,0,en(We),J,W));let L,F=X>q;Gi=De,os=null;let Y=C.ori==0?J:W,st=C.ori==1?J:W;if(Fe<0||O==0||F){L=pt.idx=null;for(let lt=0;lt<y.length;lt++){let dt=xn[lt];dt!=null&&Ri(dt,-10,-10,J,W)}zi&&Ei(null,lr,!0,_==null&&je.setSeries),Mt.live&&(mt.fill(L),nt=!0)}else{let lt,dt,Rt;s==1&&(lt=C.ori==0?Fe:We,dt=wi(lt,A),L=pt.idx=_i(dt,t[0],X,q),Rt=N(t[0][L],C,Y,0));let Ct=-10,Lt=-10,jt=0,ye=0,xe=!0,re="",Xt="";for(let zt=s==2?1:0;zt<y.length;zt++){let ke=y[zt],qe=mt[zt],pn=qe==null?null:s==1?t[zt][qe]:t[zt][1][qe],Re=pt.dataIdx(i,zt,L,dt),Ye=Re==null?null:s==1?t[zt][Re]:t[zt][1][Re];if(nt=nt||Ye!=pn||Re!=qe,mt[zt]=Re,zt>0&&ke.show){let Vn=Re==null?-10:Re==L?Rt:N(s==1?t[0][Re]:t[zt][0][Re],C,Y,0),Tn=Ye==null?-10:G(Ye,s==1?x[ke.scale]:x[ke.facets[1].scale],st,0);if(zi&&Ye!=null){let ti=C.ori==1?Fe:We,hi=nn(Hn.dist(i,zt,Re,Tn,ti));if(hi<Gi){let Ti=Hn.bias;if(Ti!=0){let Gn=wi(ti,ke.scale),ei=Ye>=0?1:-1,fi=Gn>=0?1:-1;fi==ei&&(fi==1?Ti==1?Ye>=Gn:Ye<=Gn:Ti==1?Ye<=Gn:Ye>=Gn)&&(Gi=hi,os=zt)}else Gi=hi,os=zt}}if(nt||Un){let ti,hi;C.ori==0?(ti=Vn,hi=Tn):(ti=Tn,hi=Vn);let Ti,Gn,ei,fi,Ai,An,Wn=!0,Rs=Ue.bbox;if(Rs!=null){Wn=!1;let Rn=Rs(i,zt);ei=Rn.left,fi=Rn.top,Ti=Rn.width,Gn=Rn.height}else ei=ti,fi=hi,Ti=Gn=Ue.size(i,zt);if(An=Ue.fill(i,zt),Ai=Ue.stroke(i,zt),Un)zt==os&&Gi<=Hn.prox&&(Ct=ei,Lt=fi,jt=Ti,ye=Gn,xe=Wn,re=An,Xt=Ai);else{let Rn=xn[zt];Rn!=null&&(Hi[zt]=ei,Vi[zt]=fi,hf(Rn,Ti,Gn,Wn),cf(Rn,An,Ai),Ri(Rn,ri(ei),ri(fi),J,W))}}}}if(Un){let zt=Hn.prox,ke=Ts==null?Gi<=zt:Gi>zt||os!=Ts;if(nt||ke){let qe=xn[0];qe!=null&&(Hi[0]=Ct,Vi[0]=Lt,hf(qe,jt,ye,xe),cf(qe,re,Xt),Ri(qe,ri(Ct),ri(Lt),J,W))}}}if(Oe.show&&ss)if(_!=null){let[lt,dt]=je.scales,[Rt,Ct]=je.match,[Lt,jt]=_.cursor.sync.scales,ye=_.cursor.drag;if(hn=ye._x,fn=ye._y,hn||fn){let{left:xe,top:re,width:Xt,height:zt}=_.select,ke=_.scales[Lt].ori,qe=_.posToVal,pn,Re,Ye,Vn,Tn,ti=lt!=null&&Rt(lt,Lt),hi=dt!=null&&Ct(dt,jt);ti&&hn?(ke==0?(pn=xe,Re=Xt):(pn=re,Re=zt),Ye=x[lt],Vn=N(qe(pn,Lt),Ye,Y,0),Tn=N(qe(pn+Re,Lt),Ye,Y,0),ao(vi(Vn,Tn),nn(Tn-Vn))):ao(0,Y),hi&&fn?(ke==1?(pn=xe,Re=Xt):(pn=re,Re=zt),Ye=x[dt],Vn=G(qe(pn,jt),Ye,st,0),Tn=G(qe(pn+Re,jt),Ye,st,0),lo(vi(Vn,Tn),nn(Tn-Vn))):lo(0,st)}else Rl()}else{let lt=nn(yh-Mh),dt=nn(bh-Sh);if(C.ori==1){let jt=lt;lt=dt,dt=jt}hn=_n.x&&lt>=_n.dist,fn=_n.y&&dt>=_n.dist;let Rt=_n.uni;Rt!=null?hn&&fn&&(hn=lt>=Rt,fn=dt>=Rt,!hn&&!fn&&(dt>lt?fn=!0:hn=!0)):_n.x&&_n.y&&(hn||fn)&&(hn=fn=!0);let Ct,Lt;hn&&(C.ori==0?(Ct=rr,Lt=Fe):(Ct=or,Lt=We),ao(vi(Ct,Lt),nn(Lt-Ct)),fn||lo(0,st)),fn&&(C.ori==1?(Ct=rr,Lt=Fe):(Ct=or,Lt=We),lo(vi(Ct,Lt),nn(Lt-Ct)),hn||ao(0,Y)),!hn&&!fn&&(ao(0,0),lo(0,0))}if(_n._x=hn,_n._y=fn,_==null){if(R){if(Fh!=null){let[lt,dt]=je.scales;je.values[0]=lt!=null?wi(C.ori==0?Fe:We,lt):null,je.values[1]=dt!=null?wi(C.ori==1?Fe:We,dt):null}uo(Il,i,Fe,We,J,W,L)}if(zi){let lt=R&&je.setSeries,dt=Hn.prox;Ts==null?Gi<=dt&&Ei(os,lr,!0,lt):Gi>dt?Ei(null,lr,!0,lt):os!=Ts&&Ei(os,lr,!0,lt)}}nt&&(Mt.idx=L,wl()),M!==!1&&dn("setCursor")}let as=null;Object.defineProperty(i,"rect",{get(){return as==null&&co(!1),as}});function co(_=!1){_?as=null:(as=g.getBoundingClientRect(),dn("syncRect",as))}function Th(_,M,R,L,F,Y,st){pt._lock||ss&&_!=null&&_.movementX==0&&_.movementY==0||(Tl(_,M,R,L,F,Y,st,!1,_!=null),_!=null?As(null,!0,!0):As(M,!0,!1))}function Tl(_,M,R,L,F,Y,st,lt,dt){if(as==null&&co(!1),tn(_),_!=null)R=_.clientX-as.left,L=_.clientY-as.top;else{if(R<0||L<0){Fe=-10,We=-10;return}let[Rt,Ct]=je.scales,Lt=M.cursor.sync,[jt,ye]=Lt.values,[xe,re]=Lt.scales,[Xt,zt]=je.match,ke=M.axes[0].side%2==1,qe=C.ori==0?J:W,pn=C.ori==1?J:W,Re=ke?Y:F,Ye=ke?F:Y,Vn=ke?L:R,Tn=ke?R:L;if(xe!=null?R=Xt(Rt,xe)?a(jt,x[Rt],qe,0):-10:R=qe*(Vn/Re),re!=null?L=zt(Ct,re)?a(ye,x[Ct],pn,0):-10:L=pn*(Tn/Ye),C.ori==1){let ti=R;R=L,L=ti}}dt&&(M==null||M.cursor.event.type==Il)&&((R<=1||R>=J-1)&&(R=Ns(R,J)),(L<=1||L>=W-1)&&(L=Ns(L,W))),lt?(Mh=R,Sh=L,[rr,or]=pt.move(i,R,L)):(Fe=R,We=L)}const Al={width:0,height:0,left:0,top:0};function Rl(){Vo(Al,!1)}let Ah,Rh,Ch,Ph;function Lh(_,M,R,L,F,Y,st){ss=!0,hn=fn=_n._x=_n._y=!1,Tl(_,M,R,L,F,Y,st,!0,!1),_!=null&&(Pt(Ul,Rc,Dh,!1),uo(ef,i,rr,or,J,W,null));let{left:lt,top:dt,width:Rt,height:Ct}=Oe;Ah=lt,Rh=dt,Ch=Rt,Ph=Ct}function Dh(_,M,R,L,F,Y,st){ss=_n._x=_n._y=!1,Tl(_,M,R,L,F,Y,st,!1,!0);let{left:lt,top:dt,width:Rt,height:Ct}=Oe,Lt=Rt>0||Ct>0,jt=Ah!=lt||Rh!=dt||Ch!=Rt||Ph!=Ct;if(Lt&&jt&&Vo(Oe),_n.setScale&&Lt&&jt){let ye=lt,xe=Rt,re=dt,Xt=Ct;if(C.ori==1&&(ye=dt,xe=Ct,re=lt,Xt=Rt),hn&&rs(A,wi(ye,A),wi(ye+xe,A)),fn)for(let zt in x){let ke=x[zt];zt!=A&&ke.from==null&&ke.min!=De&&rs(zt,wi(re+Xt,zt),wi(re,zt))}Rl()}else pt.lock&&(pt._lock=!pt._lock,As(M,!0,_!=null));_!=null&&(P(Ul,Rc),uo(Ul,i,Fe,We,J,W,null))}function bg(_,M,R,L,F,Y,st){if(pt._lock)return;tn(_);let lt=ss;if(ss){let dt=!0,Rt=!0,Ct=10,Lt,jt;C.ori==0?(Lt=hn,jt=fn):(Lt=fn,jt=hn),Lt&&jt&&(dt=Fe<=Ct||Fe>=J-Ct,Rt=We<=Ct||We>=W-Ct),Lt&&dt&&(Fe=Fe<rr?0:J),jt&&Rt&&(We=We<or?0:W),As(null,!0,!0),ss=!1}Fe=-10,We=-10,mt.fill(null),As(null,!0,!0),lt&&(ss=lt)}function Ih(_,M,R,L,F,Y,st){pt._lock||(tn(_),Dt(),Rl(),_!=null&&uo(rf,i,Fe,We,J,W,null))}function Uh(){T.forEach(Cv),rt(i.width,i.height,!0)}Ws(Ga,Pr,Uh);const cr={};cr.mousedown=Lh,cr.mousemove=Th,cr.mouseup=Dh,cr.dblclick=Ih,cr.setSeries=(_,M,R,L)=>{let F=je.match[2];R=F(i,M,R),R!=-1&&Ei(R,L,!0,!1)},at&&(Pt(ef,g,Lh),Pt(Il,g,Th),Pt(nf,g,_=>{tn(_),co(!1)}),Pt(sf,g,bg),Pt(rf,g,Ih),Fc.add(i),i.syncRect=co);const Go=i.hooks=n.hooks||{};function dn(_,M,R){Sl?oo.push([_,M,R]):_ in Go&&Go[_].forEach(L=>{L.call(null,i,M,R)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)Go[M]=(Go[M]||[]).concat(_.hooks[M])});const Nh=(_,M,R)=>R,je=Ze({key:null,setSeries:!1,filters:{pub:gf,sub:gf},scales:[A,y[1]?y[1].scale:null],match:[_f,_f,Nh],values:[null,null]},pt.sync);je.match.length==2&&je.match.push(Nh),pt.sync=je;const Fh=je.key,Cl=em(Fh);function uo(_,M,R,L,F,Y,st){je.filters.pub(_,M,R,L,F,Y,st)&&Cl.pub(_,M,R,L,F,Y,st)}Cl.sub(i);function Eg(_,M,R,L,F,Y,st){je.filters.sub(_,M,R,L,F,Y,st)&&cr[_](null,M,R,L,F,Y,st)}i.pub=Eg;function wg(){Cl.unsub(i),Fc.delete(i),me.clear(),Lc(Ga,Pr,Uh),c.remove(),ot?.remove(),dn("destroy")}i.destroy=wg;function Pl(){dn("init",n,t),Ft(t||n.data,!1),Z[A]?yl(A,Z[A]):Dt(),xt=Oe.show&&(Oe.width>0||Oe.height>0),k=nt=!0,rt(n.width,n.height)}return y.forEach(ro),T.forEach(xl),e?e instanceof HTMLElement?(e.appendChild(c),Pl()):e(i,Pl):Pl(),i}En.assign=Ze;En.fmtNum=qu;En.rangeNum=Wa;En.rangeLog=ol;En.rangeAsinh=$u;En.orient=Ks;En.pxRatio=be;En.join=M0;En.fmtDate=ju,En.tzDate=L0;En.sync=em;{En.addGap=dv,En.clipGaps=cl;let n=En.paths={points:am};n.linear=cm,n.stepped=gv,n.bars=_v,n.spline=xv}const Ko=n=>document.getElementById(n),Pv=["#7cc4ff","#56d6b0","#d59bf6","#ffb652","#f2f5f8","#ff7a5c"],dm=({curves:n},t)=>n[t].signal==="truth"&&n.some(e=>e.signal!=="truth")?"#f2f5f8":Pv[t];function Lv(n,t,e,i){const s={stroke:"#8fa1b3",grid:{stroke:"#1b2733",width:1},ticks:{stroke:"#1b2733"},font:`${.68*i}px system-ui`,size:2.3*i},r={stroke:"#ffb65290",width:1,dash:[4,4],points:{show:!1}};return{width:t,height:e,legend:{show:!1},cursor:{show:!1},padding:[i*(n.names.length?.95:.3),i*.4,0,0],hooks:{draw:[o=>Iv(o,n,i)]},scales:{x:{time:!1},y:{range:(o,a,l)=>{if(!n.centred)return Dv([a,l,...n.levels],n.least);const c=Math.max(Math.abs(a||0),Math.abs(l||0),n.least);return[-c*1.1,c*1.1]}}},axes:[{...s,size:1.5*i,gap:1},{...s,gap:1,space:1.2*i,label:n.title,labelSize:1.1*i,labelFont:`${.7*i}px system-ui`}],series:[{},...n.curves.map((o,a)=>({stroke:dm(n,a),width:1.5,points:{show:!1}})),r,r]}}function Dv(n,t){const e=n.filter(o=>Number.isFinite(o)),[i,s]=e.length?[Math.min(...e),Math.max(...e)]:[0,t],r=Math.max((s-i)*.06,(t-(s-i))/2);return[i-r,s+r]}function Iv(n,t,e){const i=n.ctx,s=devicePixelRatio||1,{left:r,top:o,width:a}=n.bbox;i.save(),i.strokeStyle="#8aa4bd",i.lineWidth=s,i.setLineDash([3*s,3*s]);for(const c of t.levels){const u=n.valToPos(c,"y",!0);i.beginPath(),i.moveTo(r,u),i.lineTo(r+a,u),i.stroke()}i.font=`${.68*e*s}px system-ui`,i.textBaseline="bottom",i.textAlign="right";let l=r+a-.3*e*s;for(let c=t.names.length-1;c>=0;c-=1)i.fillStyle=dm(t,c),i.fillText(t.names[c],l,o-.1*e*s),l-=i.measureText(t.names[c]).width+.7*e*s;i.restore()}class Uv{constructor(t,e){Object.assign(this,{strip:t,window:e,element:document.createElement("div")})}size(){const t=parseFloat(getComputedStyle(document.documentElement).fontSize),e=this.element.parentElement.clientWidth;return{width:Math.max(e,60),height:6.4*t,rem:t}}show({t,curves:e,spread:i},s){const r=this.size();(!this.plot||this.width!==r.width)&&(this.plot&&this.plot.destroy(),this.plot=new En(Lv(this.strip,r.width,r.height,r.rem),[[],...e.map(()=>[]),[],[]],this.element),this.width=r.width);let o=t.length;if(s!==void 0)for(;o>0&&t[o-1]>s;)o-=1;let a=o;for(;a>0&&t[a-1]>(t[o-1]??0)-this.window;)a-=1;const l=u=>u.slice(a,o),c=l(i);this.plot.setData([l(t),...e.map(l),c,c.map(u=>u===null?null:-u)])}}class Nv{setDisplay({charts:t}){Ko("strips").hidden=!t,this.note=t?.note,this.strips=(t?.strips||[]).map(e=>new Uv(e,t.window_s)),Ko("charts").replaceChildren(...this.strips.map(e=>e.element)),Ko("charts-title").textContent=t?.title||""}show(t,e,i){this.strips.forEach((s,r)=>s.show(t[r],i)),this.note&&Ao(li(e,this.note)??["",!1],Ko("charts-note"),"dim")}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const nh="170",Fv=0,Bf=1,Ov=2,pm=1,kv=2,ji=3,Ms=0,kn=1,Pi=2,_s=0,Lr=1,zf=2,Hf=3,Vf=4,Bv=5,zs=100,zv=101,Hv=102,Vv=103,Gv=104,Wv=200,$v=201,Xv=202,qv=203,kc=204,Bc=205,Yv=206,jv=207,Kv=208,Zv=209,Jv=210,Qv=211,tx=212,ex=213,nx=214,zc=0,Hc=1,Vc=2,Vr=3,Gc=4,Wc=5,$c=6,Xc=7,ih=0,ix=1,sx=2,vs=0,rx=1,ox=2,ax=3,lx=4,cx=5,ux=6,hx=7,mm=300,Gr=301,Wr=302,qc=303,Yc=304,dl=306,jc=1e3,Vs=1001,Kc=1002,Mi=1003,fx=1004,Zo=1005,Ii=1006,Bl=1007,Gs=1008,es=1009,gm=1010,_m=1011,Lo=1012,sh=1013,Xs=1014,Ki=1015,Io=1016,rh=1017,oh=1018,$r=1020,vm=35902,xm=1021,Mm=1022,xi=1023,Sm=1024,ym=1025,Dr=1026,Xr=1027,bm=1028,ah=1029,Em=1030,lh=1031,ch=1033,Ua=33776,Na=33777,Fa=33778,Oa=33779,Zc=35840,Jc=35841,Qc=35842,tu=35843,eu=36196,nu=37492,iu=37496,su=37808,ru=37809,ou=37810,au=37811,lu=37812,cu=37813,uu=37814,hu=37815,fu=37816,du=37817,pu=37818,mu=37819,gu=37820,_u=37821,ka=36492,vu=36494,xu=36495,wm=36283,Mu=36284,Su=36285,yu=36286,dx=3200,px=3201,Tm=0,mx=1,gs="",oi="srgb",Zs="srgb-linear",pl="linear",Ce="srgb",hr=7680,Gf=519,gx=512,_x=513,vx=514,Am=515,xx=516,Mx=517,Sx=518,yx=519,Wf=35044,$f="300 es",Zi=2e3,Xa=2001;class Qr{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const i=this._listeners;return i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const i=this._listeners[t.type];if(i!==void 0){t.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const Sn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ba=Math.PI/180,bu=180/Math.PI;function Uo(){const n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Sn[n&255]+Sn[n>>8&255]+Sn[n>>16&255]+Sn[n>>24&255]+"-"+Sn[t&255]+Sn[t>>8&255]+"-"+Sn[t>>16&15|64]+Sn[t>>24&255]+"-"+Sn[e&63|128]+Sn[e>>8&255]+"-"+Sn[e>>16&255]+Sn[e>>24&255]+Sn[i&255]+Sn[i>>8&255]+Sn[i>>16&255]+Sn[i>>24&255]).toLowerCase()}function Dn(n,t,e){return Math.max(t,Math.min(e,n))}function bx(n,t){return(n%t+t)%t}function zl(n,t,e){return(1-e)*n+e*t}function po(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Fn(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}class ue{constructor(t=0,e=0){ue.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Dn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class ee{constructor(t,e,i,s,r,o,a,l,c){ee.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],g=i[8],v=s[0],m=s[3],p=s[6],y=s[1],T=s[4],x=s[7],U=s[2],A=s[5],D=s[8];return r[0]=o*v+a*y+l*U,r[3]=o*m+a*T+l*A,r[6]=o*p+a*x+l*D,r[1]=c*v+u*y+h*U,r[4]=c*m+u*T+h*A,r[7]=c*p+u*x+h*D,r[2]=f*v+d*y+g*U,r[5]=f*m+d*T+g*A,r[8]=f*p+d*x+g*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return t[0]=h*v,t[1]=(s*c-u*i)*v,t[2]=(a*i-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Hl.makeScale(t,e)),this}rotate(t){return this.premultiply(Hl.makeRotation(-t)),this}translate(t,e){return this.premultiply(Hl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const Hl=new ee;function Rm(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function qa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Ex(){const n=qa("canvas");return n.style.display="block",n}const Xf={};function bo(n){n in Xf||(Xf[n]=!0,console.warn(n))}function wx(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}function Tx(n){const t=n.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function Ax(n){const t=n.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const ve={enabled:!0,workingColorSpace:Zs,spaces:{},convert:function(n,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ce&&(n.r=ts(n.r),n.g=ts(n.g),n.b=ts(n.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(n.applyMatrix3(this.spaces[t].toXYZ),n.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ce&&(n.r=Ir(n.r),n.g=Ir(n.g),n.b=Ir(n.b))),n},fromWorkingColorSpace:function(n,t){return this.convert(n,this.workingColorSpace,t)},toWorkingColorSpace:function(n,t){return this.convert(n,t,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===gs?pl:this.spaces[n].transfer},getLuminanceCoefficients:function(n,t=this.workingColorSpace){return n.fromArray(this.spaces[t].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,t,e){return n.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}};function ts(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ir(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}const qf=[.64,.33,.3,.6,.15,.06],Yf=[.2126,.7152,.0722],jf=[.3127,.329],Kf=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Zf=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ve.define({[Zs]:{primaries:qf,whitePoint:jf,transfer:pl,toXYZ:Kf,fromXYZ:Zf,luminanceCoefficients:Yf,workingColorSpaceConfig:{unpackColorSpace:oi},outputColorSpaceConfig:{drawingBufferColorSpace:oi}},[oi]:{primaries:qf,whitePoint:jf,transfer:Ce,toXYZ:Kf,fromXYZ:Zf,luminanceCoefficients:Yf,outputColorSpaceConfig:{drawingBufferColorSpace:oi}}});let fr;class Rx{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{fr===void 0&&(fr=qa("canvas")),fr.width=t.width,fr.height=t.height;const i=fr.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),e=fr}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=qa("canvas");e.width=t.width,e.height=t.height;const i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);const s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ts(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ts(e[i]/255)*255):e[i]=ts(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let Cx=0;class Cm{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Cx++}),this.uuid=Uo(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Vl(s[o].image)):r.push(Vl(s[o]))}else r=Vl(s);i.url=r}return e||(t.images[this.uuid]=i),i}}function Vl(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Rx.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let Px=0;class Bn extends Qr{constructor(t=Bn.DEFAULT_IMAGE,e=Bn.DEFAULT_MAPPING,i=Vs,s=Vs,r=Ii,o=Gs,a=xi,l=es,c=Bn.DEFAULT_ANISOTROPY,u=gs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Px++}),this.uuid=Uo(),this.name="",this.source=new Cm(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ue(0,0),this.repeat=new ue(1,1),this.center=new ue(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const i={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==mm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case jc:t.x=t.x-Math.floor(t.x);break;case Vs:t.x=t.x<0?0:1;break;case Kc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case jc:t.y=t.y-Math.floor(t.y);break;case Vs:t.y=t.y<0?0:1;break;case Kc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Bn.DEFAULT_IMAGE=null;Bn.DEFAULT_MAPPING=mm;Bn.DEFAULT_ANISOTROPY=1;class $e{constructor(t=0,e=0,i=0,s=1){$e.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,x=(d+1)/2,U=(p+1)/2,A=(u+f)/4,D=(h+v)/4,I=(g+m)/4;return T>x&&T>U?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=D/i):x>U?x<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),i=A/s,r=I/s):U<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(U),i=D/r,s=I/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(h-v)/y,this.z=(f-u)/y,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class Lx extends Qr{constructor(t=1,e=1,i={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new $e(0,0,t,e),this.scissorTest=!1,this.viewport=new $e(0,0,t,e);const s={width:t,height:e,depth:1};i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ii,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},i);const r=new Bn(s,i.mapping,i.wrapS,i.wrapT,i.magFilter,i.minFilter,i.format,i.type,i.anisotropy,i.colorSpace);r.flipY=!1,r.generateMipmaps=i.generateMipmaps,r.internalFormat=i.internalFormat,this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.depthTexture=i.depthTexture,this.samples=i.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let i=0,s=t.textures.length;i<s;i++)this.textures[i]=t.textures[i].clone(),this.textures[i].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new Cm(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class qs extends Lx{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}}class Pm extends Bn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Mi,this.minFilter=Mi,this.wrapR=Vs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class Dx extends Bn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Mi,this.minFilter=Mi,this.wrapR=Vs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class ns{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3];const f=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==f||c!==d||u!==g){let m=1-a;const p=l*f+c*d+u*g+h*v,y=p>=0?1:-1,T=1-p*p;if(T>Number.EPSILON){const U=Math.sqrt(T),A=Math.atan2(U,p*y);m=Math.sin(m*A)/U,a=Math.sin(a*A)/U}const x=a*y;if(l=l*m+f*x,c=c*m+d*x,u=u*m+g*x,h=h*m+v*x,m===1-a){const U=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=U,c*=U,u*=U,h*=U}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=i+a+h;if(f>0){const d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){const d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){const d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<Number.EPSILON?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Dn(this.dot(t),-1,1)))}rotateTowards(t,e){const i=this.angleTo(t);if(i===0)return this;const s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const d=1-e;return this._w=d*o+e*this._w,this._x=d*i+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class B{constructor(t=0,e=0,i=0){B.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Jf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Jf.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Gl.copy(this).projectOnVector(t),this.sub(Gl)}reflect(t){return this.sub(Gl.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Dn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){const s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Gl=new B,Jf=new ns;class to{constructor(t=new B(1/0,1/0,1/0),e=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(di.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(di.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const i=di.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const i=t.geometry;if(i!==void 0){const r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,di):di.fromBufferAttribute(r,o),di.applyMatrix4(t.matrixWorld),this.expandByPoint(di);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Jo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Jo.copy(i.boundingBox)),Jo.applyMatrix4(t.matrixWorld),this.union(Jo)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,di),di.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(mo),Qo.subVectors(this.max,mo),dr.subVectors(t.a,mo),pr.subVectors(t.b,mo),mr.subVectors(t.c,mo),ls.subVectors(pr,dr),cs.subVectors(mr,pr),Cs.subVectors(dr,mr);let e=[0,-ls.z,ls.y,0,-cs.z,cs.y,0,-Cs.z,Cs.y,ls.z,0,-ls.x,cs.z,0,-cs.x,Cs.z,0,-Cs.x,-ls.y,ls.x,0,-cs.y,cs.x,0,-Cs.y,Cs.x,0];return!Wl(e,dr,pr,mr,Qo)||(e=[1,0,0,0,1,0,0,0,1],!Wl(e,dr,pr,mr,Qo))?!1:(ta.crossVectors(ls,cs),e=[ta.x,ta.y,ta.z],Wl(e,dr,pr,mr,Qo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,di).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(di).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Wi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Wi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Wi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Wi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Wi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Wi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Wi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Wi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Wi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Wi=[new B,new B,new B,new B,new B,new B,new B,new B],di=new B,Jo=new to,dr=new B,pr=new B,mr=new B,ls=new B,cs=new B,Cs=new B,mo=new B,Qo=new B,ta=new B,Ps=new B;function Wl(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ps.fromArray(n,r);const a=s.x*Math.abs(Ps.x)+s.y*Math.abs(Ps.y)+s.z*Math.abs(Ps.z),l=t.dot(Ps),c=e.dot(Ps),u=i.dot(Ps);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const Ix=new to,go=new B,$l=new B;class No{constructor(t=new B,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const i=this.center;e!==void 0?i.copy(e):Ix.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;go.subVectors(t,this.center);const e=go.lengthSq();if(e>this.radius*this.radius){const i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(go,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):($l.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(go.copy(t.center).add($l)),this.expandByPoint(go.copy(t.center).sub($l))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const $i=new B,Xl=new B,ea=new B,us=new B,ql=new B,na=new B,Yl=new B;class uh{constructor(t=new B,e=new B(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,$i)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=$i.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):($i.copy(this.origin).addScaledVector(this.direction,e),$i.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Xl.copy(t).add(e).multiplyScalar(.5),ea.copy(e).sub(t).normalize(),us.copy(this.origin).sub(Xl);const r=t.distanceTo(e)*.5,o=-this.direction.dot(ea),a=us.dot(this.direction),l=-us.dot(ea),c=us.lengthSq(),u=Math.abs(1-o*o);let h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){const v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Xl).addScaledVector(ea,f),d}intersectSphere(t,e){$i.subVectors(t.center,this.origin);const i=$i.dot(this.direction),s=$i.dot($i)-i*i,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){const i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,$i)!==null}intersectTriangle(t,e,i,s,r){ql.subVectors(e,t),na.subVectors(i,t),Yl.crossVectors(ql,na);let o=this.direction.dot(Yl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;us.subVectors(this.origin,t);const l=a*this.direction.dot(na.crossVectors(us,na));if(l<0)return null;const c=a*this.direction.dot(ql.cross(us));if(c<0||l+c>o)return null;const u=-a*us.dot(Yl);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Ne{constructor(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){Ne.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m)}set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ne().fromArray(this.elements)}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){const e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,i=t.elements,s=1/gr.setFromMatrixColumn(t,0).length(),r=1/gr.setFromMatrixColumn(t,1).length(),o=1/gr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+g,e[10]=f-v*h}else if(t.order==="XZY"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Ux,t,Nx)}lookAt(t,e,i){const s=this.elements;return $n.subVectors(t,e),$n.lengthSq()===0&&($n.z=1),$n.normalize(),hs.crossVectors(i,$n),hs.lengthSq()===0&&(Math.abs(i.z)===1?$n.x+=1e-4:$n.z+=1e-4,$n.normalize(),hs.crossVectors(i,$n)),hs.normalize(),ia.crossVectors($n,hs),s[0]=hs.x,s[4]=ia.x,s[8]=$n.x,s[1]=hs.y,s[5]=ia.y,s[9]=$n.y,s[2]=hs.z,s[6]=ia.z,s[10]=$n.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],g=i[2],v=i[6],m=i[10],p=i[14],y=i[3],T=i[7],x=i[11],U=i[15],A=s[0],D=s[4],I=s[8],w=s[12],S=s[1],C=s[5],V=s[9],N=s[13],G=s[2],Z=s[6],K=s[10],Q=s[14],tt=s[3],ht=s[7],ct=s[11],mt=s[15];return r[0]=o*A+a*S+l*G+c*tt,r[4]=o*D+a*C+l*Z+c*ht,r[8]=o*I+a*V+l*K+c*ct,r[12]=o*w+a*N+l*Q+c*mt,r[1]=u*A+h*S+f*G+d*tt,r[5]=u*D+h*C+f*Z+d*ht,r[9]=u*I+h*V+f*K+d*ct,r[13]=u*w+h*N+f*Q+d*mt,r[2]=g*A+v*S+m*G+p*tt,r[6]=g*D+v*C+m*Z+p*ht,r[10]=g*I+v*V+m*K+p*ct,r[14]=g*w+v*N+m*Q+p*mt,r[3]=y*A+T*S+x*G+U*tt,r[7]=y*D+T*C+x*Z+U*ht,r[11]=y*I+T*V+x*K+U*ct,r[15]=y*w+T*N+x*Q+U*mt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*f+i*c*f+s*a*d-i*l*d)+v*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+e*c*h-e*a*d-r*o*h+i*o*d+r*a*u-i*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-i*o*f+i*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],y=h*m*c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,T=g*f*c-u*m*c-g*l*d+o*m*d+u*l*p-o*f*p,x=u*v*c-g*h*c+g*a*d-o*v*d-u*a*p+o*h*p,U=g*h*l-u*v*l-g*a*f+o*v*f+u*a*m-o*h*m,A=e*y+i*T+s*x+r*U;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/A;return t[0]=y*D,t[1]=(v*f*r-h*m*r-v*s*d+i*m*d+h*s*p-i*f*p)*D,t[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*p+i*l*p)*D,t[3]=(h*l*r-a*f*r-h*s*c+i*f*c+a*s*d-i*l*d)*D,t[4]=T*D,t[5]=(u*m*r-g*f*r+g*s*d-e*m*d-u*s*p+e*f*p)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*D,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*D,t[8]=x*D,t[9]=(g*h*r-u*v*r-g*i*d+e*v*d+u*i*p-e*h*p)*D,t[10]=(o*v*r-g*a*r+g*i*c-e*v*c-o*i*p+e*a*p)*D,t[11]=(u*a*r-o*h*r-u*i*c+e*h*c+o*i*d-e*a*d)*D,t[12]=U*D,t[13]=(u*v*s-g*h*s+g*i*f-e*v*f-u*i*m+e*h*m)*D,t[14]=(g*a*s-o*v*s-g*i*l+e*v*l+o*i*m-e*a*m)*D,t[15]=(o*h*s-u*a*s+u*i*l-e*h*l-o*i*f+e*a*f)*D,this}scale(t){const e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,v=o*u,m=o*h,p=a*h,y=l*c,T=l*u,x=l*h,U=i.x,A=i.y,D=i.z;return s[0]=(1-(v+p))*U,s[1]=(d+x)*U,s[2]=(g-T)*U,s[3]=0,s[4]=(d-x)*A,s[5]=(1-(f+p))*A,s[6]=(m+y)*A,s[7]=0,s[8]=(g+T)*D,s[9]=(m-y)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){const s=this.elements;let r=gr.set(s[0],s[1],s[2]).length();const o=gr.set(s[4],s[5],s[6]).length(),a=gr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],pi.copy(this);const c=1/r,u=1/o,h=1/a;return pi.elements[0]*=c,pi.elements[1]*=c,pi.elements[2]*=c,pi.elements[4]*=u,pi.elements[5]*=u,pi.elements[6]*=u,pi.elements[8]*=h,pi.elements[9]*=h,pi.elements[10]*=h,e.setFromRotationMatrix(pi),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=Zi){const l=this.elements,c=2*r/(e-t),u=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s);let d,g;if(a===Zi)d=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===Xa)d=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=d,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Zi){const l=this.elements,c=1/(e-t),u=1/(i-s),h=1/(o-r),f=(e+t)*c,d=(i+s)*u;let g,v;if(a===Zi)g=(o+r)*h,v=-2*h;else if(a===Xa)g=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-d,l[2]=0,l[6]=0,l[10]=v,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}}const gr=new B,pi=new Ne,Ux=new B(0,0,0),Nx=new B(1,1,1),hs=new B,ia=new B,$n=new B,Qf=new Ne,td=new ns;class Bi{constructor(t=0,e=0,i=0,s=Bi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(Dn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Dn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Dn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Dn(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Dn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-Dn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Qf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Qf,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return td.setFromEuler(this),this.setFromQuaternion(td,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Bi.DEFAULT_ORDER="XYZ";class Lm{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let Fx=0;const ed=new B,_r=new ns,Xi=new Ne,sa=new B,_o=new B,Ox=new B,kx=new ns,nd=new B(1,0,0),id=new B(0,1,0),sd=new B(0,0,1),rd={type:"added"},Bx={type:"removed"},vr={type:"childadded",child:null},jl={type:"childremoved",child:null};class sn extends Qr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Fx++}),this.uuid=Uo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=sn.DEFAULT_UP.clone();const t=new B,e=new Bi,i=new ns,s=new B(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ne},normalMatrix:{value:new ee}}),this.matrix=new Ne,this.matrixWorld=new Ne,this.matrixAutoUpdate=sn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Lm,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return _r.setFromAxisAngle(t,e),this.quaternion.multiply(_r),this}rotateOnWorldAxis(t,e){return _r.setFromAxisAngle(t,e),this.quaternion.premultiply(_r),this}rotateX(t){return this.rotateOnAxis(nd,t)}rotateY(t){return this.rotateOnAxis(id,t)}rotateZ(t){return this.rotateOnAxis(sd,t)}translateOnAxis(t,e){return ed.copy(t).applyQuaternion(this.quaternion),this.position.add(ed.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(nd,t)}translateY(t){return this.translateOnAxis(id,t)}translateZ(t){return this.translateOnAxis(sd,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Xi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?sa.copy(t):sa.set(t,e,i);const s=this.parent;this.updateWorldMatrix(!0,!1),_o.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Xi.lookAt(_o,sa,this.up):Xi.lookAt(sa,_o,this.up),this.quaternion.setFromRotationMatrix(Xi),s&&(Xi.extractRotation(s.matrixWorld),_r.setFromRotationMatrix(Xi),this.quaternion.premultiply(_r.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(rd),vr.child=t,this.dispatchEvent(vr),vr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Bx),jl.child=t,this.dispatchEvent(jl),jl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Xi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Xi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Xi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(rd),vr.child=t,this.dispatchEvent(vr),vr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_o,t,Ox),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_o,kx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){const i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){const s=t.children[i];this.add(s.clone())}return this}}sn.DEFAULT_UP=new B(0,1,0);sn.DEFAULT_MATRIX_AUTO_UPDATE=!0;sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const mi=new B,qi=new B,Kl=new B,Yi=new B,xr=new B,Mr=new B,od=new B,Zl=new B,Jl=new B,Ql=new B,tc=new $e,ec=new $e,nc=new $e;class ai{constructor(t=new B,e=new B,i=new B){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),mi.subVectors(t,e),s.cross(mi);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){mi.subVectors(s,e),qi.subVectors(i,e),Kl.subVectors(t,e);const o=mi.dot(mi),a=mi.dot(qi),l=mi.dot(Kl),c=qi.dot(qi),u=qi.dot(Kl),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Yi)===null?!1:Yi.x>=0&&Yi.y>=0&&Yi.x+Yi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Yi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Yi.x),l.addScaledVector(o,Yi.y),l.addScaledVector(a,Yi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return tc.setScalar(0),ec.setScalar(0),nc.setScalar(0),tc.fromBufferAttribute(t,e),ec.fromBufferAttribute(t,i),nc.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(tc,r.x),o.addScaledVector(ec,r.y),o.addScaledVector(nc,r.z),o}static isFrontFacing(t,e,i,s){return mi.subVectors(i,e),qi.subVectors(t,e),mi.cross(qi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return mi.subVectors(this.c,this.b),qi.subVectors(this.a,this.b),mi.cross(qi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ai.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ai.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return ai.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return ai.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ai.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const i=this.a,s=this.b,r=this.c;let o,a;xr.subVectors(s,i),Mr.subVectors(r,i),Zl.subVectors(t,i);const l=xr.dot(Zl),c=Mr.dot(Zl);if(l<=0&&c<=0)return e.copy(i);Jl.subVectors(t,s);const u=xr.dot(Jl),h=Mr.dot(Jl);if(u>=0&&h<=u)return e.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(i).addScaledVector(xr,o);Ql.subVectors(t,r);const d=xr.dot(Ql),g=Mr.dot(Ql);if(g>=0&&d<=g)return e.copy(r);const v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(Mr,a);const m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return od.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(od,a);const p=1/(m+v+f);return o=v*p,a=f*p,e.copy(i).addScaledVector(xr,o).addScaledVector(Mr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const Dm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},fs={h:0,s:0,l:0},ra={h:0,s:0,l:0};function ic(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}class ce{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=oi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.toWorkingColorSpace(this,e),this}setRGB(t,e,i,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=i,ve.toWorkingColorSpace(this,s),this}setHSL(t,e,i,s=ve.workingColorSpace){if(t=bx(t,1),e=Dn(e,0,1),i=Dn(i,0,1),e===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=ic(o,r,t+1/3),this.g=ic(o,r,t),this.b=ic(o,r,t-1/3)}return ve.toWorkingColorSpace(this,s),this}setStyle(t,e=oi){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=oi){const i=Dm[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ts(t.r),this.g=ts(t.g),this.b=ts(t.b),this}copyLinearToSRGB(t){return this.r=Ir(t.r),this.g=Ir(t.g),this.b=Ir(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=oi){return ve.fromWorkingColorSpace(yn.copy(this),t),Math.round(Dn(yn.r*255,0,255))*65536+Math.round(Dn(yn.g*255,0,255))*256+Math.round(Dn(yn.b*255,0,255))}getHexString(t=oi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.fromWorkingColorSpace(yn.copy(this),e);const i=yn.r,s=yn.g,r=yn.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ve.workingColorSpace){return ve.fromWorkingColorSpace(yn.copy(this),e),t.r=yn.r,t.g=yn.g,t.b=yn.b,t}getStyle(t=oi){ve.fromWorkingColorSpace(yn.copy(this),t);const e=yn.r,i=yn.g,s=yn.b;return t!==oi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(fs),this.setHSL(fs.h+t,fs.s+e,fs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(fs),t.getHSL(ra);const i=zl(fs.h,ra.h,e),s=zl(fs.s,ra.s,e),r=zl(fs.l,ra.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const yn=new ce;ce.NAMES=Dm;let zx=0;class Js extends Qr{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:zx++}),this.uuid=Uo(),this.name="",this.blending=Lr,this.side=Ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=kc,this.blendDst=Bc,this.blendEquation=zs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ce(0,0,0),this.blendAlpha=0,this.depthFunc=Vr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Gf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hr,this.stencilZFail=hr,this.stencilZPass=hr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const i={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Lr&&(i.blending=this.blending),this.side!==Ms&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==kc&&(i.blendSrc=this.blendSrc),this.blendDst!==Bc&&(i.blendDst=this.blendDst),this.blendEquation!==zs&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Vr&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Gf&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==hr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==hr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==hr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let i=null;if(e!==null){const s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class eo extends Js{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bi,this.combine=ih,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const Ke=new B,oa=new ue;class zn{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Wf,this.updateRanges=[],this.gpuType=Ki,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)oa.fromBufferAttribute(this,e),oa.applyMatrix3(t),this.setXY(e,oa.x,oa.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.applyMatrix3(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.applyMatrix4(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.applyNormalMatrix(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ke.fromBufferAttribute(this,e),Ke.transformDirection(t),this.setXYZ(e,Ke.x,Ke.y,Ke.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=po(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Fn(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=po(e,this.array)),e}setX(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=po(e,this.array)),e}setY(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=po(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=po(e,this.array)),e}setW(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array),s=Fn(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array),s=Fn(s,this.array),r=Fn(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Wf&&(t.usage=this.usage),t}}class Im extends zn{constructor(t,e,i){super(new Uint16Array(t),e,i)}}class Um extends zn{constructor(t,e,i){super(new Uint32Array(t),e,i)}}class He extends zn{constructor(t,e,i){super(new Float32Array(t),e,i)}}let Hx=0;const ni=new Ne,sc=new sn,Sr=new B,Xn=new to,vo=new to,mn=new B;class ln extends Qr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Hx++}),this.uuid=Uo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Rm(t)?Um:Im)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new ee().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return ni.makeRotationFromQuaternion(t),this.applyMatrix4(ni),this}rotateX(t){return ni.makeRotationX(t),this.applyMatrix4(ni),this}rotateY(t){return ni.makeRotationY(t),this.applyMatrix4(ni),this}rotateZ(t){return ni.makeRotationZ(t),this.applyMatrix4(ni),this}translate(t,e,i){return ni.makeTranslation(t,e,i),this.applyMatrix4(ni),this}scale(t,e,i){return ni.makeScale(t,e,i),this.applyMatrix4(ni),this}lookAt(t){return sc.lookAt(t),sc.updateMatrix(),this.applyMatrix4(sc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Sr).negate(),this.translate(Sr.x,Sr.y,Sr.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const i=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new He(i,3))}else{for(let i=0,s=e.count;i<s;i++){const r=t[i];e.setXYZ(i,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new to);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){const r=e[i];Xn.setFromBufferAttribute(r),this.morphTargetsRelative?(mn.addVectors(this.boundingBox.min,Xn.min),this.boundingBox.expandByPoint(mn),mn.addVectors(this.boundingBox.max,Xn.max),this.boundingBox.expandByPoint(mn)):(this.boundingBox.expandByPoint(Xn.min),this.boundingBox.expandByPoint(Xn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new No);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(t){const i=this.boundingSphere.center;if(Xn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];vo.setFromBufferAttribute(a),this.morphTargetsRelative?(mn.addVectors(Xn.min,vo.min),Xn.expandByPoint(mn),mn.addVectors(Xn.max,vo.max),Xn.expandByPoint(mn)):(Xn.expandByPoint(vo.min),Xn.expandByPoint(vo.max))}Xn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)mn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(mn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)mn.fromBufferAttribute(a,c),l&&(Sr.fromBufferAttribute(t,c),mn.add(Sr)),s=Math.max(s,i.distanceToSquared(mn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new zn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let I=0;I<i.count;I++)a[I]=new B,l[I]=new B;const c=new B,u=new B,h=new B,f=new ue,d=new ue,g=new ue,v=new B,m=new B;function p(I,w,S){c.fromBufferAttribute(i,I),u.fromBufferAttribute(i,w),h.fromBufferAttribute(i,S),f.fromBufferAttribute(r,I),d.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),d.sub(f),g.sub(f);const C=1/(d.x*g.y-g.x*d.y);isFinite(C)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-d.y).multiplyScalar(C),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(C),a[I].add(v),a[w].add(v),a[S].add(v),l[I].add(m),l[w].add(m),l[S].add(m))}let y=this.groups;y.length===0&&(y=[{start:0,count:t.count}]);for(let I=0,w=y.length;I<w;++I){const S=y[I],C=S.start,V=S.count;for(let N=C,G=C+V;N<G;N+=3)p(t.getX(N+0),t.getX(N+1),t.getX(N+2))}const T=new B,x=new B,U=new B,A=new B;function D(I){U.fromBufferAttribute(s,I),A.copy(U);const w=a[I];T.copy(w),T.sub(U.multiplyScalar(U.dot(w))).normalize(),x.crossVectors(A,w);const C=x.dot(l[I])<0?-1:1;o.setXYZW(I,T.x,T.y,T.z,C)}for(let I=0,w=y.length;I<w;++I){const S=y[I],C=S.start,V=S.count;for(let N=C,G=C+V;N<G;N+=3)D(t.getX(N+0)),D(t.getX(N+1)),D(t.getX(N+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new zn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);const s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,h=new B;if(t)for(let f=0,d=t.count;f<d;f+=3){const g=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)mn.fromBufferAttribute(t,e),mn.normalize(),t.setXYZ(e,mn.x,mn.y,mn.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new zn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new ln,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,i);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],d=t(f,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const i=this.attributes;for(const l in i){const c=i[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const i=t.index;i!==null&&this.setIndex(i.clone(e));const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const ad=new Ne,Ls=new uh,aa=new No,ld=new B,la=new B,ca=new B,ua=new B,rc=new B,ha=new B,cd=new B,fa=new B;class bn extends sn{constructor(t=new ln,e=new eo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){ha.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(rc.fromBufferAttribute(h,t),o?ha.addScaledVector(rc,u):ha.addScaledVector(rc.sub(e),u))}e.add(ha)}return e}raycast(t,e){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),aa.copy(i.boundingSphere),aa.applyMatrix4(r),Ls.copy(t.ray).recast(t.near),!(aa.containsPoint(Ls.origin)===!1&&(Ls.intersectSphere(aa,ld)===null||Ls.origin.distanceToSquared(ld)>(t.far-t.near)**2))&&(ad.copy(r).invert(),Ls.copy(t.ray).applyMatrix4(ad),!(i.boundingBox!==null&&Ls.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Ls)))}_computeIntersections(t,e,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),T=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,U=T;x<U;x+=3){const A=a.getX(x),D=a.getX(x+1),I=a.getX(x+2);s=da(this,p,t,i,c,u,h,A,D,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const y=a.getX(m),T=a.getX(m+1),x=a.getX(m+2);s=da(this,o,t,i,c,u,h,y,T,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),T=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,U=T;x<U;x+=3){const A=x,D=x+1,I=x+2;s=da(this,p,t,i,c,u,h,A,D,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const y=m,T=m+1,x=m+2;s=da(this,o,t,i,c,u,h,y,T,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function Vx(n,t,e,i,s,r,o,a){let l;if(t.side===kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ms,a),l===null)return null;fa.copy(a),fa.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(fa);return c<e.near||c>e.far?null:{distance:c,point:fa.clone(),object:n}}function da(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,la),n.getVertexPosition(l,ca),n.getVertexPosition(c,ua);const u=Vx(n,t,e,i,la,ca,ua,cd);if(u){const h=new B;ai.getBarycoord(cd,la,ca,ua,h),s&&(u.uv=ai.getInterpolatedAttribute(s,a,l,c,h,new ue)),r&&(u.uv1=ai.getInterpolatedAttribute(r,a,l,c,h,new ue)),o&&(u.normal=ai.getInterpolatedAttribute(o,a,l,c,h,new B),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new B,materialIndex:0};ai.getNormal(la,ca,ua,f.normal),u.face=f,u.barycoord=h}return u}class no extends ln{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new He(c,3)),this.setAttribute("normal",new He(u,3)),this.setAttribute("uv",new He(h,2));function g(v,m,p,y,T,x,U,A,D,I,w){const S=x/D,C=U/I,V=x/2,N=U/2,G=A/2,Z=D+1,K=I+1;let Q=0,tt=0;const ht=new B;for(let ct=0;ct<K;ct++){const mt=ct*C-N;for(let Mt=0;Mt<Z;Mt++){const pt=Mt*S-V;ht[v]=pt*y,ht[m]=mt*T,ht[p]=G,c.push(ht.x,ht.y,ht.z),ht[v]=0,ht[m]=0,ht[p]=A>0?1:-1,u.push(ht.x,ht.y,ht.z),h.push(Mt/D),h.push(1-ct/I),Q+=1}}for(let ct=0;ct<I;ct++)for(let mt=0;mt<D;mt++){const Mt=f+mt+Z*ct,pt=f+mt+Z*(ct+1),it=f+(mt+1)+Z*(ct+1),at=f+(mt+1)+Z*ct;l.push(Mt,pt,at),l.push(pt,it,at),tt+=6}a.addGroup(d,tt,w),d+=tt,f+=Q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new no(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function qr(n){const t={};for(const e in n){t[e]={};for(const i in n[e]){const s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function Pn(n){const t={};for(let e=0;e<n.length;e++){const i=qr(n[e]);for(const s in i)t[s]=i[s]}return t}function Gx(n){const t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Nm(n){const t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}const Wx={clone:qr,merge:Pn};var $x=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Xx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Ss extends Js{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=$x,this.fragmentShader=Xx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=qr(t.uniforms),this.uniformsGroups=Gx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}}class Fm extends sn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ne,this.projectionMatrix=new Ne,this.projectionMatrixInverse=new Ne,this.coordinateSystem=Zi}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const ds=new B,ud=new ue,hd=new ue;class Yn extends Fm{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=bu*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(Ba*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return bu*2*Math.atan(Math.tan(Ba*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){ds.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ds.x,ds.y).multiplyScalar(-t/ds.z),ds.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ds.x,ds.y).multiplyScalar(-t/ds.z)}getViewSize(t,e){return this.getViewBounds(t,ud,hd),e.subVectors(hd,ud)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(Ba*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const yr=-90,br=1;class qx extends sn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Yn(yr,br,t,e);s.layers=this.layers,this.add(s);const r=new Yn(yr,br,t,e);r.layers=this.layers,this.add(r);const o=new Yn(yr,br,t,e);o.layers=this.layers,this.add(o);const a=new Yn(yr,br,t,e);a.layers=this.layers,this.add(a);const l=new Yn(yr,br,t,e);l.layers=this.layers,this.add(l);const c=new Yn(yr,br,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===Zi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Xa)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;const v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=v,t.setRenderTarget(i,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}}class Om extends Bn{constructor(t,e,i,s,r,o,a,l,c,u){t=t!==void 0?t:[],e=e!==void 0?e:Gr,super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class Yx extends qs{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Om(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Ii}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new no(5,5,5),r=new Ss({name:"CubemapFromEquirect",uniforms:qr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:kn,blending:_s});r.uniforms.tEquirect.value=e;const o=new bn(s,r),a=e.minFilter;return e.minFilter===Gs&&(e.minFilter=Ii),new qx(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,i,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}}const oc=new B,jx=new B,Kx=new ee;class Os{constructor(t=new B(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){const s=oc.subVectors(i,e).cross(jx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const i=t.delta(oc),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const i=e||Kx.getNormalMatrix(t),s=this.coplanarPoint(oc).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Ds=new No,pa=new B;class hh{constructor(t=new Os,e=new Os,i=new Os,s=new Os,r=new Os,o=new Os){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Zi){const i=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],f=s[7],d=s[8],g=s[9],v=s[10],m=s[11],p=s[12],y=s[13],T=s[14],x=s[15];if(i[0].setComponents(l-r,f-c,m-d,x-p).normalize(),i[1].setComponents(l+r,f+c,m+d,x+p).normalize(),i[2].setComponents(l+o,f+u,m+g,x+y).normalize(),i[3].setComponents(l-o,f-u,m-g,x-y).normalize(),i[4].setComponents(l-a,f-h,m-v,x-T).normalize(),e===Zi)i[5].setComponents(l+a,f+h,m+v,x+T).normalize();else if(e===Xa)i[5].setComponents(a,h,v,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ds.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ds.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ds)}intersectsSprite(t){return Ds.center.set(0,0,0),Ds.radius=.7071067811865476,Ds.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ds)}intersectsSphere(t){const e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let i=0;i<6;i++){const s=e[i];if(pa.x=s.normal.x>0?t.max.x:t.min.x,pa.y=s.normal.y>0?t.max.y:t.min.y,pa.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(pa)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function km(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Zx(n){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){const u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){const g=h[f],v=h[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){const v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class ml extends ln{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){const y=p*f-o;for(let T=0;T<c;T++){const x=T*h-r;g.push(x,-y,0),v.push(0,0,1),m.push(T/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){const T=y+c*p,x=y+c*(p+1),U=y+1+c*(p+1),A=y+1+c*p;d.push(T,x,A),d.push(x,U,A)}this.setIndex(d),this.setAttribute("position",new He(g,3)),this.setAttribute("normal",new He(v,3)),this.setAttribute("uv",new He(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ml(t.width,t.height,t.widthSegments,t.heightSegments)}}var Jx=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Qx=`#ifdef USE_ALPHAHASH
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
#endif`,tM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,eM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,nM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,iM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,sM=`#ifdef USE_AOMAP
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
#endif`,rM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,oM=`#ifdef USE_BATCHING
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
#endif`,aM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,lM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,cM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,uM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,hM=`#ifdef USE_IRIDESCENCE
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
#endif`,fM=`#ifdef USE_BUMPMAP
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
#endif`,dM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,pM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,mM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,gM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,_M=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,vM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,xM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,MM=`#if defined( USE_COLOR_ALPHA )
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
#endif`,SM=`#define PI 3.141592653589793
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
} // validated`,yM=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,bM=`vec3 transformedNormal = objectNormal;
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
#endif`,EM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,wM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,TM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,AM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,RM="gl_FragColor = linearToOutputTexel( gl_FragColor );",CM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,PM=`#ifdef USE_ENVMAP
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
#endif`,LM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,DM=`#ifdef USE_ENVMAP
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
#endif`,IM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,UM=`#ifdef USE_ENVMAP
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
#endif`,NM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,FM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,OM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,kM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,BM=`#ifdef USE_GRADIENTMAP
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
}`,zM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,HM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,VM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,GM=`uniform bool receiveShadow;
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
#endif`,WM=`#ifdef USE_ENVMAP
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
#endif`,$M=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,XM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,qM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,YM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,jM=`PhysicalMaterial material;
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
#endif`,KM=`struct PhysicalMaterial {
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
}`,ZM=`
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
#endif`,JM=`#if defined( RE_IndirectDiffuse )
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
#endif`,QM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,tS=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,eS=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,nS=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,iS=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,sS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,rS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,oS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,aS=`#if defined( USE_POINTS_UV )
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
#endif`,lS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,cS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,uS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,hS=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,fS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,dS=`#ifdef USE_MORPHTARGETS
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
#endif`,pS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,mS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,gS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,_S=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,vS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,xS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,MS=`#ifdef USE_NORMALMAP
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
#endif`,SS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,yS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,bS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ES=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,wS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,TS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,AS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,RS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,CS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,PS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,LS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,DS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,IS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,US=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,NS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,FS=`float getShadowMask() {
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
}`,OS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,kS=`#ifdef USE_SKINNING
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
#endif`,BS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,zS=`#ifdef USE_SKINNING
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
#endif`,HS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,VS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,GS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,WS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,$S=`#ifdef USE_TRANSMISSION
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
#endif`,XS=`#ifdef USE_TRANSMISSION
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
#endif`,qS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,YS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,jS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,KS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const ZS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,JS=`uniform sampler2D t2D;
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
}`,QS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ty=`#ifdef ENVMAP_TYPE_CUBE
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
}`,ey=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ny=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,iy=`#include <common>
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
}`,sy=`#if DEPTH_PACKING == 3200
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
}`,ry=`#define DISTANCE
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
}`,oy=`#define DISTANCE
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
}`,ay=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ly=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cy=`uniform float scale;
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
}`,uy=`uniform vec3 diffuse;
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
}`,hy=`#include <common>
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
}`,fy=`uniform vec3 diffuse;
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
}`,dy=`#define LAMBERT
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
}`,py=`#define LAMBERT
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
}`,my=`#define MATCAP
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
}`,gy=`#define MATCAP
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
}`,_y=`#define NORMAL
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
}`,vy=`#define NORMAL
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
}`,xy=`#define PHONG
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
}`,My=`#define PHONG
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
}`,Sy=`#define STANDARD
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
}`,yy=`#define STANDARD
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
}`,by=`#define TOON
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
}`,Ey=`#define TOON
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
}`,wy=`uniform float size;
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
}`,Ty=`uniform vec3 diffuse;
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
}`,Ay=`#include <common>
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
}`,Ry=`uniform vec3 color;
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
}`,Cy=`uniform float rotation;
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
}`,Py=`uniform vec3 diffuse;
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
}`,ie={alphahash_fragment:Jx,alphahash_pars_fragment:Qx,alphamap_fragment:tM,alphamap_pars_fragment:eM,alphatest_fragment:nM,alphatest_pars_fragment:iM,aomap_fragment:sM,aomap_pars_fragment:rM,batching_pars_vertex:oM,batching_vertex:aM,begin_vertex:lM,beginnormal_vertex:cM,bsdfs:uM,iridescence_fragment:hM,bumpmap_pars_fragment:fM,clipping_planes_fragment:dM,clipping_planes_pars_fragment:pM,clipping_planes_pars_vertex:mM,clipping_planes_vertex:gM,color_fragment:_M,color_pars_fragment:vM,color_pars_vertex:xM,color_vertex:MM,common:SM,cube_uv_reflection_fragment:yM,defaultnormal_vertex:bM,displacementmap_pars_vertex:EM,displacementmap_vertex:wM,emissivemap_fragment:TM,emissivemap_pars_fragment:AM,colorspace_fragment:RM,colorspace_pars_fragment:CM,envmap_fragment:PM,envmap_common_pars_fragment:LM,envmap_pars_fragment:DM,envmap_pars_vertex:IM,envmap_physical_pars_fragment:WM,envmap_vertex:UM,fog_vertex:NM,fog_pars_vertex:FM,fog_fragment:OM,fog_pars_fragment:kM,gradientmap_pars_fragment:BM,lightmap_pars_fragment:zM,lights_lambert_fragment:HM,lights_lambert_pars_fragment:VM,lights_pars_begin:GM,lights_toon_fragment:$M,lights_toon_pars_fragment:XM,lights_phong_fragment:qM,lights_phong_pars_fragment:YM,lights_physical_fragment:jM,lights_physical_pars_fragment:KM,lights_fragment_begin:ZM,lights_fragment_maps:JM,lights_fragment_end:QM,logdepthbuf_fragment:tS,logdepthbuf_pars_fragment:eS,logdepthbuf_pars_vertex:nS,logdepthbuf_vertex:iS,map_fragment:sS,map_pars_fragment:rS,map_particle_fragment:oS,map_particle_pars_fragment:aS,metalnessmap_fragment:lS,metalnessmap_pars_fragment:cS,morphinstance_vertex:uS,morphcolor_vertex:hS,morphnormal_vertex:fS,morphtarget_pars_vertex:dS,morphtarget_vertex:pS,normal_fragment_begin:mS,normal_fragment_maps:gS,normal_pars_fragment:_S,normal_pars_vertex:vS,normal_vertex:xS,normalmap_pars_fragment:MS,clearcoat_normal_fragment_begin:SS,clearcoat_normal_fragment_maps:yS,clearcoat_pars_fragment:bS,iridescence_pars_fragment:ES,opaque_fragment:wS,packing:TS,premultiplied_alpha_fragment:AS,project_vertex:RS,dithering_fragment:CS,dithering_pars_fragment:PS,roughnessmap_fragment:LS,roughnessmap_pars_fragment:DS,shadowmap_pars_fragment:IS,shadowmap_pars_vertex:US,shadowmap_vertex:NS,shadowmask_pars_fragment:FS,skinbase_vertex:OS,skinning_pars_vertex:kS,skinning_vertex:BS,skinnormal_vertex:zS,specularmap_fragment:HS,specularmap_pars_fragment:VS,tonemapping_fragment:GS,tonemapping_pars_fragment:WS,transmission_fragment:$S,transmission_pars_fragment:XS,uv_pars_fragment:qS,uv_pars_vertex:YS,uv_vertex:jS,worldpos_vertex:KS,background_vert:ZS,background_frag:JS,backgroundCube_vert:QS,backgroundCube_frag:ty,cube_vert:ey,cube_frag:ny,depth_vert:iy,depth_frag:sy,distanceRGBA_vert:ry,distanceRGBA_frag:oy,equirect_vert:ay,equirect_frag:ly,linedashed_vert:cy,linedashed_frag:uy,meshbasic_vert:hy,meshbasic_frag:fy,meshlambert_vert:dy,meshlambert_frag:py,meshmatcap_vert:my,meshmatcap_frag:gy,meshnormal_vert:_y,meshnormal_frag:vy,meshphong_vert:xy,meshphong_frag:My,meshphysical_vert:Sy,meshphysical_frag:yy,meshtoon_vert:by,meshtoon_frag:Ey,points_vert:wy,points_frag:Ty,shadow_vert:Ay,shadow_frag:Ry,sprite_vert:Cy,sprite_frag:Py},Et={common:{diffuse:{value:new ce(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new ue(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ce(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ce(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new ce(16777215)},opacity:{value:1},center:{value:new ue(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},Ci={basic:{uniforms:Pn([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.fog]),vertexShader:ie.meshbasic_vert,fragmentShader:ie.meshbasic_frag},lambert:{uniforms:Pn([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,Et.lights,{emissive:{value:new ce(0)}}]),vertexShader:ie.meshlambert_vert,fragmentShader:ie.meshlambert_frag},phong:{uniforms:Pn([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,Et.lights,{emissive:{value:new ce(0)},specular:{value:new ce(1118481)},shininess:{value:30}}]),vertexShader:ie.meshphong_vert,fragmentShader:ie.meshphong_frag},standard:{uniforms:Pn([Et.common,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.roughnessmap,Et.metalnessmap,Et.fog,Et.lights,{emissive:{value:new ce(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ie.meshphysical_vert,fragmentShader:ie.meshphysical_frag},toon:{uniforms:Pn([Et.common,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.gradientmap,Et.fog,Et.lights,{emissive:{value:new ce(0)}}]),vertexShader:ie.meshtoon_vert,fragmentShader:ie.meshtoon_frag},matcap:{uniforms:Pn([Et.common,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,{matcap:{value:null}}]),vertexShader:ie.meshmatcap_vert,fragmentShader:ie.meshmatcap_frag},points:{uniforms:Pn([Et.points,Et.fog]),vertexShader:ie.points_vert,fragmentShader:ie.points_frag},dashed:{uniforms:Pn([Et.common,Et.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ie.linedashed_vert,fragmentShader:ie.linedashed_frag},depth:{uniforms:Pn([Et.common,Et.displacementmap]),vertexShader:ie.depth_vert,fragmentShader:ie.depth_frag},normal:{uniforms:Pn([Et.common,Et.bumpmap,Et.normalmap,Et.displacementmap,{opacity:{value:1}}]),vertexShader:ie.meshnormal_vert,fragmentShader:ie.meshnormal_frag},sprite:{uniforms:Pn([Et.sprite,Et.fog]),vertexShader:ie.sprite_vert,fragmentShader:ie.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ie.background_vert,fragmentShader:ie.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ie.backgroundCube_vert,fragmentShader:ie.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ie.cube_vert,fragmentShader:ie.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ie.equirect_vert,fragmentShader:ie.equirect_frag},distanceRGBA:{uniforms:Pn([Et.common,Et.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ie.distanceRGBA_vert,fragmentShader:ie.distanceRGBA_frag},shadow:{uniforms:Pn([Et.lights,Et.fog,{color:{value:new ce(0)},opacity:{value:1}}]),vertexShader:ie.shadow_vert,fragmentShader:ie.shadow_frag}};Ci.physical={uniforms:Pn([Ci.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new ue(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new ce(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new ue},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new ce(0)},specularColor:{value:new ce(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new ue},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ie.meshphysical_vert,fragmentShader:ie.meshphysical_frag};const ma={r:0,b:0,g:0},Is=new Bi,Ly=new Ne;function Dy(n,t,e,i,s,r,o){const a=new ce(0);let l=r===!0?0:1,c,u,h=null,f=0,d=null;function g(y){let T=y.isScene===!0?y.background:null;return T&&T.isTexture&&(T=(y.backgroundBlurriness>0?e:t).get(T)),T}function v(y){let T=!1;const x=g(y);x===null?p(a,l):x&&x.isColor&&(p(x,1),T=!0);const U=n.xr.getEnvironmentBlendMode();U==="additive"?i.buffers.color.setClear(0,0,0,1,o):U==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||T)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(y,T){const x=g(T);x&&(x.isCubeTexture||x.mapping===dl)?(u===void 0&&(u=new bn(new no(1,1,1),new Ss({name:"BackgroundCubeMaterial",uniforms:qr(Ci.backgroundCube.uniforms),vertexShader:Ci.backgroundCube.vertexShader,fragmentShader:Ci.backgroundCube.fragmentShader,side:kn,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(U,A,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Is.copy(T.backgroundRotation),Is.x*=-1,Is.y*=-1,Is.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(Is.y*=-1,Is.z*=-1),u.material.uniforms.envMap.value=x,u.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(Ly.makeRotationFromEuler(Is)),u.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,(h!==x||f!==x.version||d!==n.toneMapping)&&(u.material.needsUpdate=!0,h=x,f=x.version,d=n.toneMapping),u.layers.enableAll(),y.unshift(u,u.geometry,u.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new bn(new ml(2,2),new Ss({name:"BackgroundMaterial",uniforms:qr(Ci.background.uniforms),vertexShader:Ci.background.vertexShader,fragmentShader:Ci.background.fragmentShader,side:Ms,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||f!==x.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=x,f=x.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function p(y,T){y.getRGB(ma,Nm(n)),i.buffers.color.setClear(ma.r,ma.g,ma.b,T,o)}return{getClearColor:function(){return a},setClearColor:function(y,T=1){a.set(y),l=T,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(y){l=y,p(a,l)},render:v,addToRenderList:m}}function Iy(n,t){const e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null);let r=s,o=!1;function a(S,C,V,N,G){let Z=!1;const K=h(N,V,C);r!==K&&(r=K,c(r.object)),Z=d(S,N,V,G),Z&&g(S,N,V,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,x(S,C,V,N),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(S){return n.bindVertexArray(S)}function u(S){return n.deleteVertexArray(S)}function h(S,C,V){const N=V.wireframe===!0;let G=i[S.id];G===void 0&&(G={},i[S.id]=G);let Z=G[C.id];Z===void 0&&(Z={},G[C.id]=Z);let K=Z[N];return K===void 0&&(K=f(l()),Z[N]=K),K}function f(S){const C=[],V=[],N=[];for(let G=0;G<e;G++)C[G]=0,V[G]=0,N[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:V,attributeDivisors:N,object:S,attributes:{},index:null}}function d(S,C,V,N){const G=r.attributes,Z=C.attributes;let K=0;const Q=V.getAttributes();for(const tt in Q)if(Q[tt].location>=0){const ct=G[tt];let mt=Z[tt];if(mt===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;K++}return r.attributesNum!==K||r.index!==N}function g(S,C,V,N){const G={},Z=C.attributes;let K=0;const Q=V.getAttributes();for(const tt in Q)if(Q[tt].location>=0){let ct=Z[tt];ct===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),G[tt]=mt,K++}r.attributes=G,r.attributesNum=K,r.index=N}function v(){const S=r.newAttributes;for(let C=0,V=S.length;C<V;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){const V=r.newAttributes,N=r.enabledAttributes,G=r.attributeDivisors;V[S]=1,N[S]===0&&(n.enableVertexAttribArray(S),N[S]=1),G[S]!==C&&(n.vertexAttribDivisor(S,C),G[S]=C)}function y(){const S=r.newAttributes,C=r.enabledAttributes;for(let V=0,N=C.length;V<N;V++)C[V]!==S[V]&&(n.disableVertexAttribArray(V),C[V]=0)}function T(S,C,V,N,G,Z,K){K===!0?n.vertexAttribIPointer(S,C,V,G,Z):n.vertexAttribPointer(S,C,V,N,G,Z)}function x(S,C,V,N){v();const G=N.attributes,Z=V.getAttributes(),K=C.defaultAttributeValues;for(const Q in Z){const tt=Z[Q];if(tt.location>=0){let ht=G[Q];if(ht===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ht=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ht=S.instanceColor)),ht!==void 0){const ct=ht.normalized,mt=ht.itemSize,Mt=t.get(ht);if(Mt===void 0)continue;const pt=Mt.buffer,it=Mt.type,at=Mt.bytesPerElement,gt=it===n.INT||it===n.UNSIGNED_INT||ht.gpuType===sh;if(ht.isInterleavedBufferAttribute){const ot=ht.data,Bt=ot.stride,Ht=ht.offset;if(ot.isInstancedInterleavedBuffer){for(let Ut=0;Ut<tt.locationSize;Ut++)p(tt.location+Ut,ot.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let Ut=0;Ut<tt.locationSize;Ut++)m(tt.location+Ut);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let Ut=0;Ut<tt.locationSize;Ut++)T(tt.location+Ut,mt/tt.locationSize,it,ct,Bt*at,(Ht+mt/tt.locationSize*Ut)*at,gt)}else{if(ht.isInstancedBufferAttribute){for(let ot=0;ot<tt.locationSize;ot++)p(tt.location+ot,ht.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ot=0;ot<tt.locationSize;ot++)m(tt.location+ot);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let ot=0;ot<tt.locationSize;ot++)T(tt.location+ot,mt/tt.locationSize,it,ct,mt*at,mt/tt.locationSize*ot*at,gt)}}else if(K!==void 0){const ct=K[Q];if(ct!==void 0)switch(ct.length){case 2:n.vertexAttrib2fv(tt.location,ct);break;case 3:n.vertexAttrib3fv(tt.location,ct);break;case 4:n.vertexAttrib4fv(tt.location,ct);break;default:n.vertexAttrib1fv(tt.location,ct)}}}}y()}function U(){I();for(const S in i){const C=i[S];for(const V in C){const N=C[V];for(const G in N)u(N[G].object),delete N[G];delete C[V]}delete i[S]}}function A(S){if(i[S.id]===void 0)return;const C=i[S.id];for(const V in C){const N=C[V];for(const G in N)u(N[G].object),delete N[G];delete C[V]}delete i[S.id]}function D(S){for(const C in i){const V=i[C];if(V[S.id]===void 0)continue;const N=V[S.id];for(const G in N)u(N[G].object),delete N[G];delete V[S.id]}}function I(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:w,dispose:U,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function Uy(n,t,e){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),e.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),e.update(u,i,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let d=0;for(let g=0;g<h;g++)d+=u[g];e.update(d,i,1)}function l(c,u,h,f){if(h===0)return;const d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(i,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];e.update(g,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Ny(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==xi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const I=D===Io&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==es&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ki&&!I)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),U=g>0,A=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:T,maxFragmentUniforms:x,vertexTextures:U,maxSamples:A}}function Fy(n){const t=this;let e=null,i=0,s=!1,r=!1;const o=new Os,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){const g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{const y=r?0:i,T=y*4;let x=p.clippingState||null;l.value=x,x=u(g,f,T,d);for(let U=0;U!==T;++U)x[U]=e[U];p.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,g){const v=h!==null?h.length:0;let m=null;if(v!==0){if(m=l.value,g!==!0||m===null){const p=d+v*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,x=d;T!==v;++T,x+=4)o.copy(h[T]).applyMatrix4(y,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function Oy(n){let t=new WeakMap;function e(o,a){return a===qc?o.mapping=Gr:a===Yc&&(o.mapping=Wr),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===qc||a===Yc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new Yx(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}class fh extends Fm{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Tr=4,fd=[.125,.215,.35,.446,.526,.582],Hs=20,ac=new fh,dd=new ce;let lc=null,cc=0,uc=0,hc=!1;const ks=(1+Math.sqrt(5))/2,Er=1/ks,pd=[new B(-ks,Er,0),new B(ks,Er,0),new B(-Er,0,ks),new B(Er,0,ks),new B(0,ks,-Er),new B(0,ks,Er),new B(-1,1,-1),new B(1,1,-1),new B(-1,1,1),new B(1,1,1)];class md{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100){lc=this._renderer.getRenderTarget(),cc=this._renderer.getActiveCubeFace(),uc=this._renderer.getActiveMipmapLevel(),hc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,i,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=vd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=_d(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(lc,cc,uc),this._renderer.xr.enabled=hc,t.scissorTest=!1,ga(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Gr||t.mapping===Wr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),lc=this._renderer.getRenderTarget(),cc=this._renderer.getActiveCubeFace(),uc=this._renderer.getActiveMipmapLevel(),hc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Ii,minFilter:Ii,generateMipmaps:!1,type:Io,format:xi,colorSpace:Zs,depthBuffer:!1},s=gd(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=gd(t,e,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=ky(r)),this._blurMaterial=By(r,t,e)}return s}_compileMaterial(t){const e=new bn(this._lodPlanes[0],t);this._renderer.compile(e,ac)}_sceneToCubeUV(t,e,i,s){const a=new Yn(90,1,e,i),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,f=u.toneMapping;u.getClearColor(dd),u.toneMapping=vs,u.autoClear=!1;const d=new eo({name:"PMREM.Background",side:kn,depthWrite:!1,depthTest:!1}),g=new bn(new no,d);let v=!1;const m=t.background;m?m.isColor&&(d.color.copy(m),t.background=null,v=!0):(d.color.copy(dd),v=!0);for(let p=0;p<6;p++){const y=p%3;y===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):y===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));const T=this._cubeSize;ga(s,y*T,p>2?T:0,T,T),u.setRenderTarget(s),v&&u.render(g,a),u.render(t,a)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=f,u.autoClear=h,t.background=m}_textureToCubeUV(t,e){const i=this._renderer,s=t.mapping===Gr||t.mapping===Wr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=vd()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=_d());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new bn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;ga(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,ac)}_applyPMREM(t){const e=this._renderer,i=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=pd[(s-r-1)%pd.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new bn(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[i]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Hs-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):Hs;m>Hs&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Hs}`);const p=[];let y=0;for(let D=0;D<Hs;++D){const I=D/v,w=Math.exp(-I*I/2);p.push(w),D===0?y+=w:D<m&&(y+=2*w)}for(let D=0;D<p.length;D++)p[D]=p[D]/y;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:T}=this;f.dTheta.value=g,f.mipInt.value=T-i;const x=this._sizeLods[s],U=3*x*(s>T-Tr?s-T+Tr:0),A=4*(this._cubeSize-x);ga(e,U,A,3*x,2*x),l.setRenderTarget(e),l.render(h,ac)}}function ky(n){const t=[],e=[],i=[];let s=n;const r=n-Tr+1+fd.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>n-Tr?l=fd[o-n+Tr-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,g=6,v=3,m=2,p=1,y=new Float32Array(v*g*d),T=new Float32Array(m*g*d),x=new Float32Array(p*g*d);for(let A=0;A<d;A++){const D=A%3*2/3-1,I=A>2?0:-1,w=[D,I,0,D+2/3,I,0,D+2/3,I+1,0,D,I,0,D+2/3,I+1,0,D,I+1,0];y.set(w,v*g*A),T.set(f,m*g*A);const S=[A,A,A,A,A,A];x.set(S,p*g*A)}const U=new ln;U.setAttribute("position",new zn(y,v)),U.setAttribute("uv",new zn(T,m)),U.setAttribute("faceIndex",new zn(x,p)),t.push(U),s>Tr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function gd(n,t,e){const i=new qs(n,t,e);return i.texture.mapping=dl,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function ga(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function By(n,t,e){const i=new Float32Array(Hs),s=new B(0,1,0);return new Ss({name:"SphericalGaussianBlur",defines:{n:Hs,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:dh(),fragmentShader:`

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
		`,blending:_s,depthTest:!1,depthWrite:!1})}function _d(){return new Ss({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:dh(),fragmentShader:`

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
		`,blending:_s,depthTest:!1,depthWrite:!1})}function vd(){return new Ss({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:dh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:_s,depthTest:!1,depthWrite:!1})}function dh(){return`

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
	`}function zy(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===qc||l===Yc,u=l===Gr||l===Wr;if(c||u){let h=t.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new md(n)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new md(n)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function Hy(n){const t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){const s=e(i);return s===null&&bo("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function Vy(n,t,e,i){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&t.remove(f.index);for(const g in f.attributes)t.remove(f.attributes[g]);for(const g in f.morphAttributes){const v=f.morphAttributes[g];for(let m=0,p=v.length;m<p;m++)t.remove(v[m])}f.removeEventListener("dispose",o),delete s[f.id];const d=r.get(f);d&&(t.remove(d),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){const f=h.attributes;for(const g in f)t.update(f[g],n.ARRAY_BUFFER);const d=h.morphAttributes;for(const g in d){const v=d[g];for(let m=0,p=v.length;m<p;m++)t.update(v[m],n.ARRAY_BUFFER)}}function c(h){const f=[],d=h.index,g=h.attributes.position;let v=0;if(d!==null){const y=d.array;v=d.version;for(let T=0,x=y.length;T<x;T+=3){const U=y[T+0],A=y[T+1],D=y[T+2];f.push(U,A,A,D,D,U)}}else if(g!==void 0){const y=g.array;v=g.version;for(let T=0,x=y.length/3-1;T<x;T+=3){const U=T+0,A=T+1,D=T+2;f.push(U,A,A,D,D,U)}}else return;const m=new(Rm(f)?Um:Im)(f,1);m.version=v;const p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){const f=r.get(h);if(f){const d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function Gy(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,r,f*o),e.update(d,i,1)}function c(f,d,g){g!==0&&(n.drawElementsInstanced(i,d,r,f*o,g),e.update(d,i,g))}function u(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,i,1)}function h(f,d,g,v){if(g===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(i,d,0,r,f,0,v,0,g);let p=0;for(let y=0;y<g;y++)p+=d[y]*v[y];e.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function Wy(n){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function $y(n,t,e){const i=new WeakMap,s=new $e;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=i.get(a);if(f===void 0||f.count!==h){let w=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();const d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[];let T=0;d===!0&&(T=1),g===!0&&(T=2),v===!0&&(T=3);let x=a.attributes.position.count*T,U=1;x>t.maxTextureSize&&(U=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);const A=new Float32Array(x*U*4*h),D=new Pm(A,x,U,h);D.type=Ki,D.needsUpdate=!0;const I=T*4;for(let S=0;S<h;S++){const C=m[S],V=p[S],N=y[S],G=x*U*4*S;for(let Z=0;Z<C.count;Z++){const K=Z*I;d===!0&&(s.fromBufferAttribute(C,Z),A[G+K+0]=s.x,A[G+K+1]=s.y,A[G+K+2]=s.z,A[G+K+3]=0),g===!0&&(s.fromBufferAttribute(V,Z),A[G+K+4]=s.x,A[G+K+5]=s.y,A[G+K+6]=s.z,A[G+K+7]=0),v===!0&&(s.fromBufferAttribute(N,Z),A[G+K+8]=s.x,A[G+K+9]=s.y,A[G+K+10]=s.z,A[G+K+11]=N.itemSize===4?s.w:1)}}f={count:h,texture:D,size:new ue(x,U)},i.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];const g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function Xy(n,t,e,i){let s=new WeakMap;function r(l){const c=i.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class Bm extends Bn{constructor(t,e,i,s,r,o,a,l,c,u=Dr){if(u!==Dr&&u!==Xr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");i===void 0&&u===Dr&&(i=Xs),i===void 0&&u===Xr&&(i=$r),super(null,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:Mi,this.minFilter=l!==void 0?l:Mi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const zm=new Bn,xd=new Bm(1,1),Hm=new Pm,Vm=new Dx,Gm=new Om,Md=[],Sd=[],yd=new Float32Array(16),bd=new Float32Array(9),Ed=new Float32Array(4);function io(n,t,e){const i=n[0];if(i<=0||i>0)return n;const s=t*e;let r=Md[s];if(r===void 0&&(r=new Float32Array(s),Md[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function rn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function on(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function gl(n,t){let e=Sd[t];e===void 0&&(e=new Int32Array(t),Sd[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function qy(n,t){const e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Yy(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2fv(this.addr,t),on(e,t)}}function jy(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(rn(e,t))return;n.uniform3fv(this.addr,t),on(e,t)}}function Ky(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4fv(this.addr,t),on(e,t)}}function Zy(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;Ed.set(i),n.uniformMatrix2fv(this.addr,!1,Ed),on(e,i)}}function Jy(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;bd.set(i),n.uniformMatrix3fv(this.addr,!1,bd),on(e,i)}}function Qy(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;yd.set(i),n.uniformMatrix4fv(this.addr,!1,yd),on(e,i)}}function tb(n,t){const e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function eb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2iv(this.addr,t),on(e,t)}}function nb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(rn(e,t))return;n.uniform3iv(this.addr,t),on(e,t)}}function ib(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4iv(this.addr,t),on(e,t)}}function sb(n,t){const e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function rb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2uiv(this.addr,t),on(e,t)}}function ob(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(rn(e,t))return;n.uniform3uiv(this.addr,t),on(e,t)}}function ab(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4uiv(this.addr,t),on(e,t)}}function lb(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(xd.compareFunction=Am,r=xd):r=zm,e.setTexture2D(t||r,s)}function cb(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Vm,s)}function ub(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||Gm,s)}function hb(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Hm,s)}function fb(n){switch(n){case 5126:return qy;case 35664:return Yy;case 35665:return jy;case 35666:return Ky;case 35674:return Zy;case 35675:return Jy;case 35676:return Qy;case 5124:case 35670:return tb;case 35667:case 35671:return eb;case 35668:case 35672:return nb;case 35669:case 35673:return ib;case 5125:return sb;case 36294:return rb;case 36295:return ob;case 36296:return ab;case 35678:case 36198:case 36298:case 36306:case 35682:return lb;case 35679:case 36299:case 36307:return cb;case 35680:case 36300:case 36308:case 36293:return ub;case 36289:case 36303:case 36311:case 36292:return hb}}function db(n,t){n.uniform1fv(this.addr,t)}function pb(n,t){const e=io(t,this.size,2);n.uniform2fv(this.addr,e)}function mb(n,t){const e=io(t,this.size,3);n.uniform3fv(this.addr,e)}function gb(n,t){const e=io(t,this.size,4);n.uniform4fv(this.addr,e)}function _b(n,t){const e=io(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function vb(n,t){const e=io(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function xb(n,t){const e=io(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Mb(n,t){n.uniform1iv(this.addr,t)}function Sb(n,t){n.uniform2iv(this.addr,t)}function yb(n,t){n.uniform3iv(this.addr,t)}function bb(n,t){n.uniform4iv(this.addr,t)}function Eb(n,t){n.uniform1uiv(this.addr,t)}function wb(n,t){n.uniform2uiv(this.addr,t)}function Tb(n,t){n.uniform3uiv(this.addr,t)}function Ab(n,t){n.uniform4uiv(this.addr,t)}function Rb(n,t,e){const i=this.cache,s=t.length,r=gl(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||zm,r[o])}function Cb(n,t,e){const i=this.cache,s=t.length,r=gl(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Vm,r[o])}function Pb(n,t,e){const i=this.cache,s=t.length,r=gl(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Gm,r[o])}function Lb(n,t,e){const i=this.cache,s=t.length,r=gl(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Hm,r[o])}function Db(n){switch(n){case 5126:return db;case 35664:return pb;case 35665:return mb;case 35666:return gb;case 35674:return _b;case 35675:return vb;case 35676:return xb;case 5124:case 35670:return Mb;case 35667:case 35671:return Sb;case 35668:case 35672:return yb;case 35669:case 35673:return bb;case 5125:return Eb;case 36294:return wb;case 36295:return Tb;case 36296:return Ab;case 35678:case 36198:case 36298:case 36306:case 35682:return Rb;case 35679:case 36299:case 36307:return Cb;case 35680:case 36300:case 36308:case 36293:return Pb;case 36289:case 36303:case 36311:case 36292:return Lb}}class Ib{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=fb(e.type)}}class Ub{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Db(e.type)}}class Nb{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],i)}}}const fc=/(\w+)(\])?(\[|\.)?/g;function wd(n,t){n.seq.push(t),n.map[t.id]=t}function Fb(n,t,e){const i=n.name,s=i.length;for(fc.lastIndex=0;;){const r=fc.exec(i),o=fc.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){wd(e,c===void 0?new Ib(a,n,t):new Ub(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Nb(a),wd(e,h)),e=h}}}class za{constructor(t,e){this.seq=[],this.map={};const i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);Fb(r,o,this)}}setValue(t,e,i,s){const r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){const s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const i=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&i.push(o)}return i}}function Td(n,t,e){const i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}const Ob=37297;let kb=0;function Bb(n,t){const e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}const Ad=new ee;function zb(n){ve._getMatrix(Ad,ve.workingColorSpace,n);const t=`mat3( ${Ad.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(n)){case pl:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Rd(n,t,e){const i=n.getShaderParameter(t,n.COMPILE_STATUS),s=n.getShaderInfoLog(t).trim();if(i&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+Bb(n.getShaderSource(t),o)}else return s}function Hb(n,t){const e=zb(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function Vb(n,t){let e;switch(t){case rx:e="Linear";break;case ox:e="Reinhard";break;case ax:e="Cineon";break;case lx:e="ACESFilmic";break;case ux:e="AgX";break;case hx:e="Neutral";break;case cx:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const _a=new B;function Gb(){ve.getLuminanceCoefficients(_a);const n=_a.x.toFixed(4),t=_a.y.toFixed(4),e=_a.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Wb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Eo).join(`
`)}function $b(n){const t=[];for(const e in n){const i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Xb(n,t){const e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(t,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Eo(n){return n!==""}function Cd(n,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Pd(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const qb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Eu(n){return n.replace(qb,jb)}const Yb=new Map;function jb(n,t){let e=ie[t];if(e===void 0){const i=Yb.get(t);if(i!==void 0)e=ie[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return Eu(e)}const Kb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ld(n){return n.replace(Kb,Zb)}function Zb(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Dd(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}function Jb(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===pm?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===kv?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===ji&&(t="SHADOWMAP_TYPE_VSM"),t}function Qb(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Gr:case Wr:t="ENVMAP_TYPE_CUBE";break;case dl:t="ENVMAP_TYPE_CUBE_UV";break}return t}function tE(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case Wr:t="ENVMAP_MODE_REFRACTION";break}return t}function eE(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case ih:t="ENVMAP_BLENDING_MULTIPLY";break;case ix:t="ENVMAP_BLENDING_MIX";break;case sx:t="ENVMAP_BLENDING_ADD";break}return t}function nE(n){const t=n.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function iE(n,t,e,i){const s=n.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=Jb(e),c=Qb(e),u=tE(e),h=eE(e),f=nE(e),d=Wb(e),g=$b(r),v=s.createProgram();let m,p,y=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Eo).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Eo).join(`
`),p.length>0&&(p+=`
`)):(m=[Dd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Eo).join(`
`),p=[Dd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==vs?"#define TONE_MAPPING":"",e.toneMapping!==vs?ie.tonemapping_pars_fragment:"",e.toneMapping!==vs?Vb("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ie.colorspace_pars_fragment,Hb("linearToOutputTexel",e.outputColorSpace),Gb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Eo).join(`
`)),o=Eu(o),o=Cd(o,e),o=Pd(o,e),a=Eu(a),a=Cd(a,e),a=Pd(a,e),o=Ld(o),a=Ld(a),e.isRawShaderMaterial!==!0&&(y=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===$f?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===$f?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const T=y+m+o,x=y+p+a,U=Td(s,s.VERTEX_SHADER,T),A=Td(s,s.FRAGMENT_SHADER,x);s.attachShader(v,U),s.attachShader(v,A),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(n.debug.checkShaderErrors){const V=s.getProgramInfoLog(v).trim(),N=s.getShaderInfoLog(U).trim(),G=s.getShaderInfoLog(A).trim();let Z=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(Z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,U,A);else{const Q=Rd(s,U,"vertex"),tt=Rd(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+V+`
`+Q+`
`+tt)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(N===""||G==="")&&(K=!1);K&&(C.diagnostics={runnable:Z,programLog:V,vertexShader:{log:N,prefix:m},fragmentShader:{log:G,prefix:p}})}s.deleteShader(U),s.deleteShader(A),I=new za(s,v),w=Xb(s,v)}let I;this.getUniforms=function(){return I===void 0&&D(this),I};let w;this.getAttributes=function(){return w===void 0&&D(this),w};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,Ob)),S},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=kb++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=U,this.fragmentShader=A,this}let sE=0;class rE{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){const e=this.shaderCache;let i=e.get(t);return i===void 0&&(i=new oE(t),e.set(t,i)),i}}class oE{constructor(t){this.id=sE++,this.code=t,this.usedTimes=0}}function aE(n,t,e,i,s,r,o){const a=new Lm,l=new rE,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let d=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function m(w,S,C,V,N){const G=V.fog,Z=N.geometry,K=w.isMeshStandardMaterial?V.environment:null,Q=(w.isMeshStandardMaterial?e:t).get(w.envMap||K),tt=Q&&Q.mapping===dl?Q.image.height:null,ht=g[w.type];w.precision!==null&&(d=s.getMaxPrecision(w.precision),d!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",d,"instead."));const ct=Z.morphAttributes.position||Z.morphAttributes.normal||Z.morphAttributes.color,mt=ct!==void 0?ct.length:0;let Mt=0;Z.morphAttributes.position!==void 0&&(Mt=1),Z.morphAttributes.normal!==void 0&&(Mt=2),Z.morphAttributes.color!==void 0&&(Mt=3);let pt,it,at,gt;if(ht){const Se=Ci[ht];pt=Se.vertexShader,it=Se.fragmentShader}else pt=w.vertexShader,it=w.fragmentShader,l.update(w),at=l.getVertexShaderID(w),gt=l.getFragmentShaderID(w);const ot=n.getRenderTarget(),Bt=n.state.buffers.depth.getReversed(),Ht=N.isInstancedMesh===!0,Ut=N.isBatchedMesh===!0,fe=!!w.map,Jt=!!w.matcap,de=!!Q,z=!!w.aoMap,Qe=!!w.lightMap,te=!!w.bumpMap,ne=!!w.normalMap,Vt=!!w.displacementMap,me=!!w.emissiveMap,Pt=!!w.metalnessMap,P=!!w.roughnessMap,b=w.anisotropy>0,j=w.clearcoat>0,J=w.dispersion>0,W=w.iridescence>0,et=w.sheen>0,St=w.transmission>0,_t=b&&!!w.anisotropyMap,wt=j&&!!w.clearcoatMap,Zt=j&&!!w.clearcoatNormalMap,ft=j&&!!w.clearcoatRoughnessMap,vt=W&&!!w.iridescenceMap,Nt=W&&!!w.iridescenceThicknessMap,Ot=et&&!!w.sheenColorMap,bt=et&&!!w.sheenRoughnessMap,se=!!w.specularMap,Yt=!!w.specularColorMap,ge=!!w.specularIntensityMap,k=St&&!!w.transmissionMap,xt=St&&!!w.thicknessMap,nt=!!w.gradientMap,rt=!!w.alphaMap,Tt=w.alphaTest>0,At=!!w.alphaHash,Qt=!!w.extensions;let Ve=vs;w.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Ve=n.toneMapping);const cn={shaderID:ht,shaderType:w.type,shaderName:w.name,vertexShader:pt,fragmentShader:it,defines:w.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:d,batching:Ut,batchingColor:Ut&&N._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&N.instanceColor!==null,instancingMorph:Ht&&N.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ot===null?n.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:Zs,alphaToCoverage:!!w.alphaToCoverage,map:fe,matcap:Jt,envMap:de,envMapMode:de&&Q.mapping,envMapCubeUVHeight:tt,aoMap:z,lightMap:Qe,bumpMap:te,normalMap:ne,displacementMap:f&&Vt,emissiveMap:me,normalMapObjectSpace:ne&&w.normalMapType===mx,normalMapTangentSpace:ne&&w.normalMapType===Tm,metalnessMap:Pt,roughnessMap:P,anisotropy:b,anisotropyMap:_t,clearcoat:j,clearcoatMap:wt,clearcoatNormalMap:Zt,clearcoatRoughnessMap:ft,dispersion:J,iridescence:W,iridescenceMap:vt,iridescenceThicknessMap:Nt,sheen:et,sheenColorMap:Ot,sheenRoughnessMap:bt,specularMap:se,specularColorMap:Yt,specularIntensityMap:ge,transmission:St,transmissionMap:k,thicknessMap:xt,gradientMap:nt,opaque:w.transparent===!1&&w.blending===Lr&&w.alphaToCoverage===!1,alphaMap:rt,alphaTest:Tt,alphaHash:At,combine:w.combine,mapUv:fe&&v(w.map.channel),aoMapUv:z&&v(w.aoMap.channel),lightMapUv:Qe&&v(w.lightMap.channel),bumpMapUv:te&&v(w.bumpMap.channel),normalMapUv:ne&&v(w.normalMap.channel),displacementMapUv:Vt&&v(w.displacementMap.channel),emissiveMapUv:me&&v(w.emissiveMap.channel),metalnessMapUv:Pt&&v(w.metalnessMap.channel),roughnessMapUv:P&&v(w.roughnessMap.channel),anisotropyMapUv:_t&&v(w.anisotropyMap.channel),clearcoatMapUv:wt&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:Zt&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:Ot&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:bt&&v(w.sheenRoughnessMap.channel),specularMapUv:se&&v(w.specularMap.channel),specularColorMapUv:Yt&&v(w.specularColorMap.channel),specularIntensityMapUv:ge&&v(w.specularIntensityMap.channel),transmissionMapUv:k&&v(w.transmissionMap.channel),thicknessMapUv:xt&&v(w.thicknessMap.channel),alphaMapUv:rt&&v(w.alphaMap.channel),vertexTangents:!!Z.attributes.tangent&&(ne||b),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!Z.attributes.color&&Z.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!Z.attributes.uv&&(fe||rt),fog:!!G,useFog:w.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:w.flatShading===!0,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:Bt,skinning:N.isSkinnedMesh===!0,morphTargets:Z.morphAttributes.position!==void 0,morphNormals:Z.morphAttributes.normal!==void 0,morphColors:Z.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:Mt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:Ve,decodeVideoTexture:fe&&w.map.isVideoTexture===!0&&ve.getTransfer(w.map.colorSpace)===Ce,decodeVideoTextureEmissive:me&&w.emissiveMap.isVideoTexture===!0&&ve.getTransfer(w.emissiveMap.colorSpace)===Ce,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Pi,flipSided:w.side===kn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Qt&&w.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&w.extensions.multiDraw===!0||Ut)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return cn.vertexUv1s=c.has(1),cn.vertexUv2s=c.has(2),cn.vertexUv3s=c.has(3),c.clear(),cn}function p(w){const S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(w.customFragmentShaderID)),w.defines!==void 0)for(const C in w.defines)S.push(C),S.push(w.defines[C]);return w.isRawShaderMaterial===!1&&(y(S,w),T(S,w),S.push(n.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function y(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function T(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}function x(w){const S=g[w.type];let C;if(S){const V=Ci[S];C=Wx.clone(V.uniforms)}else C=w.uniforms;return C}function U(w,S){let C;for(let V=0,N=u.length;V<N;V++){const G=u[V];if(G.cacheKey===S){C=G,++C.usedTimes;break}}return C===void 0&&(C=new iE(n,S,w,r),u.push(C)),C}function A(w){if(--w.usedTimes===0){const S=u.indexOf(w);u[S]=u[u.length-1],u.pop(),w.destroy()}}function D(w){l.remove(w)}function I(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:x,acquireProgram:U,releaseProgram:A,releaseShaderCache:D,programs:u,dispose:I}}function lE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function cE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function Id(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Ud(){const n=[];let t=0;const e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h,f,d,g,v,m){let p=n[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},n[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.push(p):d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||cE),i.length>1&&i.sort(f||Id),s.length>1&&s.sort(f||Id)}function u(){for(let h=t,f=n.length;h<f;h++){const d=n[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function uE(){let n=new WeakMap;function t(i,s){const r=n.get(i);let o;return r===void 0?(o=new Ud,n.set(i,[o])):s>=r.length?(o=new Ud,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function hE(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new B,color:new ce};break;case"SpotLight":e={position:new B,direction:new B,color:new ce,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new B,color:new ce,distance:0,decay:0};break;case"HemisphereLight":e={direction:new B,skyColor:new ce,groundColor:new ce};break;case"RectAreaLight":e={color:new ce,position:new B,halfWidth:new B,halfHeight:new B};break}return n[t.id]=e,e}}}function fE(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ue};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ue};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ue,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}let dE=0;function pE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function mE(n){const t=new hE,e=fE(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);const s=new B,r=new Ne,o=new Ne;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)i.probe[w].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,y=0,T=0,x=0,U=0,A=0,D=0;c.sort(pE);for(let w=0,S=c.length;w<S;w++){const C=c[w],V=C.color,N=C.intensity,G=C.distance,Z=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=V.r*N,h+=V.g*N,f+=V.b*N;else if(C.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(C.sh.coefficients[K],N);D++}else if(C.isDirectionalLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.directionalShadow[d]=tt,i.directionalShadowMap[d]=Z,i.directionalShadowMatrix[d]=C.shadow.matrix,y++}i.directional[d]=K,d++}else if(C.isSpotLight){const K=t.get(C);K.position.setFromMatrixPosition(C.matrixWorld),K.color.copy(V).multiplyScalar(N),K.distance=G,K.coneCos=Math.cos(C.angle),K.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),K.decay=C.decay,i.spot[v]=K;const Q=C.shadow;if(C.map&&(i.spotLightMap[U]=C.map,U++,Q.updateMatrices(C),C.castShadow&&A++),i.spotLightMatrix[v]=Q.matrix,C.castShadow){const tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.spotShadow[v]=tt,i.spotShadowMap[v]=Z,x++}v++}else if(C.isRectAreaLight){const K=t.get(C);K.color.copy(V).multiplyScalar(N),K.halfWidth.set(C.width*.5,0,0),K.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=K,m++}else if(C.isPointLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),K.distance=C.distance,K.decay=C.decay,C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,i.pointShadow[g]=tt,i.pointShadowMap[g]=Z,i.pointShadowMatrix[g]=C.shadow.matrix,T++}i.point[g]=K,g++}else if(C.isHemisphereLight){const K=t.get(C);K.skyColor.copy(C.color).multiplyScalar(N),K.groundColor.copy(C.groundColor).multiplyScalar(N),i.hemi[p]=K,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Et.LTC_FLOAT_1,i.rectAreaLTC2=Et.LTC_FLOAT_2):(i.rectAreaLTC1=Et.LTC_HALF_1,i.rectAreaLTC2=Et.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;const I=i.hash;(I.directionalLength!==d||I.pointLength!==g||I.spotLength!==v||I.rectAreaLength!==m||I.hemiLength!==p||I.numDirectionalShadows!==y||I.numPointShadows!==T||I.numSpotShadows!==x||I.numSpotMaps!==U||I.numLightProbes!==D)&&(i.directional.length=d,i.spot.length=v,i.rectArea.length=m,i.point.length=g,i.hemi.length=p,i.directionalShadow.length=y,i.directionalShadowMap.length=y,i.pointShadow.length=T,i.pointShadowMap.length=T,i.spotShadow.length=x,i.spotShadowMap.length=x,i.directionalShadowMatrix.length=y,i.pointShadowMatrix.length=T,i.spotLightMatrix.length=x+U-A,i.spotLightMap.length=U,i.numSpotLightShadowsWithMaps=A,i.numLightProbes=D,I.directionalLength=d,I.pointLength=g,I.spotLength=v,I.rectAreaLength=m,I.hemiLength=p,I.numDirectionalShadows=y,I.numPointShadows=T,I.numSpotShadows=x,I.numSpotMaps=U,I.numLightProbes=D,i.version=dE++)}function l(c,u){let h=0,f=0,d=0,g=0,v=0;const m=u.matrixWorldInverse;for(let p=0,y=c.length;p<y;p++){const T=c[p];if(T.isDirectionalLight){const x=i.directional[h];x.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),h++}else if(T.isSpotLight){const x=i.spot[d];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),d++}else if(T.isRectAreaLight){const x=i.rectArea[g];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(T.width*.5,0,0),x.halfHeight.set(0,T.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),g++}else if(T.isPointLight){const x=i.point[f];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){const x=i.hemi[v];x.direction.setFromMatrixPosition(T.matrixWorld),x.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function Nd(n){const t=new mE(n),e=[],i=[];function s(u){c.camera=u,e.length=0,i.length=0}function r(u){e.push(u)}function o(u){i.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function gE(n){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new Nd(n),t.set(s,[a])):r>=o.length?(a=new Nd(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}class _E extends Js{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=dx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class vE extends Js{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const xE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,ME=`uniform sampler2D shadow_pass;
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
}`;function SE(n,t,e){let i=new hh;const s=new ue,r=new ue,o=new $e,a=new _E({depthPacking:px}),l=new vE,c={},u=e.maxTextureSize,h={[Ms]:kn,[kn]:Ms,[Pi]:Pi},f=new Ss({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ue},radius:{value:4}},vertexShader:xE,fragmentShader:ME}),d=f.clone();d.defines.HORIZONTAL_PASS=1;const g=new ln;g.setAttribute("position",new zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new bn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=pm;let p=this.type;this.render=function(A,D,I){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;const w=n.getRenderTarget(),S=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),V=n.state;V.setBlending(_s),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const N=p!==ji&&this.type===ji,G=p===ji&&this.type!==ji;for(let Z=0,K=A.length;Z<K;Z++){const Q=A[Z],tt=Q.shadow;if(tt===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(tt.autoUpdate===!1&&tt.needsUpdate===!1)continue;s.copy(tt.mapSize);const ht=tt.getFrameExtents();if(s.multiply(ht),r.copy(tt.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,tt.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,tt.mapSize.y=r.y)),tt.map===null||N===!0||G===!0){const mt=this.type!==ji?{minFilter:Mi,magFilter:Mi}:{};tt.map!==null&&tt.map.dispose(),tt.map=new qs(s.x,s.y,mt),tt.map.texture.name=Q.name+".shadowMap",tt.camera.updateProjectionMatrix()}n.setRenderTarget(tt.map),n.clear();const ct=tt.getViewportCount();for(let mt=0;mt<ct;mt++){const Mt=tt.getViewport(mt);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),V.viewport(o),tt.updateMatrices(Q,mt),i=tt.getFrustum(),x(D,I,tt.camera,Q,this.type)}tt.isPointLightShadow!==!0&&this.type===ji&&y(tt,I),tt.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(w,S,C)};function y(A,D){const I=t.update(v);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new qs(s.x,s.y)),f.uniforms.shadow_pass.value=A.map.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(D,null,I,f,v,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(D,null,I,d,v,null)}function T(A,D,I,w){let S=null;const C=I.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)S=C;else if(S=I.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const V=S.uuid,N=D.uuid;let G=c[V];G===void 0&&(G={},c[V]=G);let Z=G[N];Z===void 0&&(Z=S.clone(),G[N]=Z,D.addEventListener("dispose",U)),S=Z}if(S.visible=D.visible,S.wireframe=D.wireframe,w===ji?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:h[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,I.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const V=n.properties.get(S);V.light=I}return S}function x(A,D,I,w,S){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&S===ji)&&(!A.frustumCulled||i.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(I.matrixWorldInverse,A.matrixWorld);const N=t.update(A),G=A.material;if(Array.isArray(G)){const Z=N.groups;for(let K=0,Q=Z.length;K<Q;K++){const tt=Z[K],ht=G[tt.materialIndex];if(ht&&ht.visible){const ct=T(A,ht,w,S);A.onBeforeShadow(n,A,D,I,N,ct,tt),n.renderBufferDirect(I,null,N,ct,A,tt),A.onAfterShadow(n,A,D,I,N,ct,tt)}}}else if(G.visible){const Z=T(A,G,w,S);A.onBeforeShadow(n,A,D,I,N,Z,null),n.renderBufferDirect(I,null,N,Z,A,null),A.onAfterShadow(n,A,D,I,N,Z,null)}}const V=A.children;for(let N=0,G=V.length;N<G;N++)x(V[N],D,I,w,S)}function U(A){A.target.removeEventListener("dispose",U);for(const I in c){const w=c[I],S=A.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}const yE={[zc]:Hc,[Vc]:$c,[Gc]:Xc,[Vr]:Wc,[Hc]:zc,[$c]:Vc,[Xc]:Gc,[Wc]:Vr};function bE(n,t){function e(){let k=!1;const xt=new $e;let nt=null;const rt=new $e(0,0,0,0);return{setMask:function(Tt){nt!==Tt&&!k&&(n.colorMask(Tt,Tt,Tt,Tt),nt=Tt)},setLocked:function(Tt){k=Tt},setClear:function(Tt,At,Qt,Ve,cn){cn===!0&&(Tt*=Ve,At*=Ve,Qt*=Ve),xt.set(Tt,At,Qt,Ve),rt.equals(xt)===!1&&(n.clearColor(Tt,At,Qt,Ve),rt.copy(xt))},reset:function(){k=!1,nt=null,rt.set(-1,0,0,0)}}}function i(){let k=!1,xt=!1,nt=null,rt=null,Tt=null;return{setReversed:function(At){if(xt!==At){const Qt=t.get("EXT_clip_control");xt?Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.ZERO_TO_ONE_EXT):Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.NEGATIVE_ONE_TO_ONE_EXT);const Ve=Tt;Tt=null,this.setClear(Ve)}xt=At},getReversed:function(){return xt},setTest:function(At){At?ot(n.DEPTH_TEST):Bt(n.DEPTH_TEST)},setMask:function(At){nt!==At&&!k&&(n.depthMask(At),nt=At)},setFunc:function(At){if(xt&&(At=yE[At]),rt!==At){switch(At){case zc:n.depthFunc(n.NEVER);break;case Hc:n.depthFunc(n.ALWAYS);break;case Vc:n.depthFunc(n.LESS);break;case Vr:n.depthFunc(n.LEQUAL);break;case Gc:n.depthFunc(n.EQUAL);break;case Wc:n.depthFunc(n.GEQUAL);break;case $c:n.depthFunc(n.GREATER);break;case Xc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}rt=At}},setLocked:function(At){k=At},setClear:function(At){Tt!==At&&(xt&&(At=1-At),n.clearDepth(At),Tt=At)},reset:function(){k=!1,nt=null,rt=null,Tt=null,xt=!1}}}function s(){let k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Qt=null,Ve=null,cn=null;return{setTest:function(Se){k||(Se?ot(n.STENCIL_TEST):Bt(n.STENCIL_TEST))},setMask:function(Se){xt!==Se&&!k&&(n.stencilMask(Se),xt=Se)},setFunc:function(Se,tn,Ue){(nt!==Se||rt!==tn||Tt!==Ue)&&(n.stencilFunc(Se,tn,Ue),nt=Se,rt=tn,Tt=Ue)},setOp:function(Se,tn,Ue){(At!==Se||Qt!==tn||Ve!==Ue)&&(n.stencilOp(Se,tn,Ue),At=Se,Qt=tn,Ve=Ue)},setLocked:function(Se){k=Se},setClear:function(Se){cn!==Se&&(n.clearStencil(Se),cn=Se)},reset:function(){k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Qt=null,Ve=null,cn=null}}}const r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,y=null,T=null,x=null,U=null,A=null,D=new ce(0,0,0),I=0,w=!1,S=null,C=null,V=null,N=null,G=null;const Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let K=!1,Q=0;const tt=n.getParameter(n.VERSION);tt.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(tt)[1]),K=Q>=1):tt.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(tt)[1]),K=Q>=2);let ht=null,ct={};const mt=n.getParameter(n.SCISSOR_BOX),Mt=n.getParameter(n.VIEWPORT),pt=new $e().fromArray(mt),it=new $e().fromArray(Mt);function at(k,xt,nt,rt){const Tt=new Uint8Array(4),At=n.createTexture();n.bindTexture(k,At),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Qt=0;Qt<nt;Qt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(xt,0,n.RGBA,1,1,rt,0,n.RGBA,n.UNSIGNED_BYTE,Tt):n.texImage2D(xt+Qt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Tt);return At}const gt={};gt[n.TEXTURE_2D]=at(n.TEXTURE_2D,n.TEXTURE_2D,1),gt[n.TEXTURE_CUBE_MAP]=at(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[n.TEXTURE_2D_ARRAY]=at(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),gt[n.TEXTURE_3D]=at(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(n.DEPTH_TEST),o.setFunc(Vr),te(!1),ne(Bf),ot(n.CULL_FACE),z(_s);function ot(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Bt(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function Ht(k,xt){return h[k]!==xt?(n.bindFramebuffer(k,xt),h[k]=xt,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=xt),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=xt),!0):!1}function Ut(k,xt){let nt=d,rt=!1;if(k){nt=f.get(xt),nt===void 0&&(nt=[],f.set(xt,nt));const Tt=k.textures;if(nt.length!==Tt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let At=0,Qt=Tt.length;At<Qt;At++)nt[At]=n.COLOR_ATTACHMENT0+At;nt.length=Tt.length,rt=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,rt=!0);rt&&n.drawBuffers(nt)}function fe(k){return g!==k?(n.useProgram(k),g=k,!0):!1}const Jt={[zs]:n.FUNC_ADD,[zv]:n.FUNC_SUBTRACT,[Hv]:n.FUNC_REVERSE_SUBTRACT};Jt[Vv]=n.MIN,Jt[Gv]=n.MAX;const de={[Wv]:n.ZERO,[$v]:n.ONE,[Xv]:n.SRC_COLOR,[kc]:n.SRC_ALPHA,[Jv]:n.SRC_ALPHA_SATURATE,[Kv]:n.DST_COLOR,[Yv]:n.DST_ALPHA,[qv]:n.ONE_MINUS_SRC_COLOR,[Bc]:n.ONE_MINUS_SRC_ALPHA,[Zv]:n.ONE_MINUS_DST_COLOR,[jv]:n.ONE_MINUS_DST_ALPHA,[Qv]:n.CONSTANT_COLOR,[tx]:n.ONE_MINUS_CONSTANT_COLOR,[ex]:n.CONSTANT_ALPHA,[nx]:n.ONE_MINUS_CONSTANT_ALPHA};function z(k,xt,nt,rt,Tt,At,Qt,Ve,cn,Se){if(k===_s){v===!0&&(Bt(n.BLEND),v=!1);return}if(v===!1&&(ot(n.BLEND),v=!0),k!==Bv){if(k!==m||Se!==w){if((p!==zs||x!==zs)&&(n.blendEquation(n.FUNC_ADD),p=zs,x=zs),Se)switch(k){case Lr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zf:n.blendFunc(n.ONE,n.ONE);break;case Hf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Vf:n.blendFuncSeparate(n.ZERO,n.SRC_COLOR,n.ZERO,n.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}else switch(k){case Lr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case zf:n.blendFunc(n.SRC_ALPHA,n.ONE);break;case Hf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Vf:n.blendFunc(n.ZERO,n.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}y=null,T=null,U=null,A=null,D.set(0,0,0),I=0,m=k,w=Se}return}Tt=Tt||xt,At=At||nt,Qt=Qt||rt,(xt!==p||Tt!==x)&&(n.blendEquationSeparate(Jt[xt],Jt[Tt]),p=xt,x=Tt),(nt!==y||rt!==T||At!==U||Qt!==A)&&(n.blendFuncSeparate(de[nt],de[rt],de[At],de[Qt]),y=nt,T=rt,U=At,A=Qt),(Ve.equals(D)===!1||cn!==I)&&(n.blendColor(Ve.r,Ve.g,Ve.b,cn),D.copy(Ve),I=cn),m=k,w=!1}function Qe(k,xt){k.side===Pi?Bt(n.CULL_FACE):ot(n.CULL_FACE);let nt=k.side===kn;xt&&(nt=!nt),te(nt),k.blending===Lr&&k.transparent===!1?z(_s):z(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);const rt=k.stencilWrite;a.setTest(rt),rt&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),me(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?ot(n.SAMPLE_ALPHA_TO_COVERAGE):Bt(n.SAMPLE_ALPHA_TO_COVERAGE)}function te(k){S!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),S=k)}function ne(k){k!==Fv?(ot(n.CULL_FACE),k!==C&&(k===Bf?n.cullFace(n.BACK):k===Ov?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Bt(n.CULL_FACE),C=k}function Vt(k){k!==V&&(K&&n.lineWidth(k),V=k)}function me(k,xt,nt){k?(ot(n.POLYGON_OFFSET_FILL),(N!==xt||G!==nt)&&(n.polygonOffset(xt,nt),N=xt,G=nt)):Bt(n.POLYGON_OFFSET_FILL)}function Pt(k){k?ot(n.SCISSOR_TEST):Bt(n.SCISSOR_TEST)}function P(k){k===void 0&&(k=n.TEXTURE0+Z-1),ht!==k&&(n.activeTexture(k),ht=k)}function b(k,xt,nt){nt===void 0&&(ht===null?nt=n.TEXTURE0+Z-1:nt=ht);let rt=ct[nt];rt===void 0&&(rt={type:void 0,texture:void 0},ct[nt]=rt),(rt.type!==k||rt.texture!==xt)&&(ht!==nt&&(n.activeTexture(nt),ht=nt),n.bindTexture(k,xt||gt[k]),rt.type=k,rt.texture=xt)}function j(){const k=ct[ht];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function J(){try{n.compressedTexImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function W(){try{n.compressedTexImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function et(){try{n.texSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function St(){try{n.texSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function _t(){try{n.compressedTexSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function wt(){try{n.compressedTexSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Zt(){try{n.texStorage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ft(){try{n.texStorage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function vt(){try{n.texImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Nt(){try{n.texImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Ot(k){pt.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),pt.copy(k))}function bt(k){it.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),it.copy(k))}function se(k,xt){let nt=c.get(xt);nt===void 0&&(nt=new WeakMap,c.set(xt,nt));let rt=nt.get(k);rt===void 0&&(rt=n.getUniformBlockIndex(xt,k.name),nt.set(k,rt))}function Yt(k,xt){const rt=c.get(xt).get(k);l.get(xt)!==rt&&(n.uniformBlockBinding(xt,rt,k.__bindingPointIndex),l.set(xt,rt))}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},ht=null,ct={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,y=null,T=null,x=null,U=null,A=null,D=new ce(0,0,0),I=0,w=!1,S=null,C=null,V=null,N=null,G=null,pt.set(0,0,n.canvas.width,n.canvas.height),it.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:Bt,bindFramebuffer:Ht,drawBuffers:Ut,useProgram:fe,setBlending:z,setMaterial:Qe,setFlipSided:te,setCullFace:ne,setLineWidth:Vt,setPolygonOffset:me,setScissorTest:Pt,activeTexture:P,bindTexture:b,unbindTexture:j,compressedTexImage2D:J,compressedTexImage3D:W,texImage2D:vt,texImage3D:Nt,updateUBOMapping:se,uniformBlockBinding:Yt,texStorage2D:Zt,texStorage3D:ft,texSubImage2D:et,texSubImage3D:St,compressedTexSubImage2D:_t,compressedTexSubImage3D:wt,scissor:Ot,viewport:bt,reset:ge}}function Fd(n,t,e,i){const s=EE(i);switch(e){case xm:return n*t;case Sm:return n*t;case ym:return n*t*2;case bm:return n*t/s.components*s.byteLength;case ah:return n*t/s.components*s.byteLength;case Em:return n*t*2/s.components*s.byteLength;case lh:return n*t*2/s.components*s.byteLength;case Mm:return n*t*3/s.components*s.byteLength;case xi:return n*t*4/s.components*s.byteLength;case ch:return n*t*4/s.components*s.byteLength;case Ua:case Na:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Fa:case Oa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Jc:case tu:return Math.max(n,16)*Math.max(t,8)/4;case Zc:case Qc:return Math.max(n,8)*Math.max(t,8)/2;case eu:case nu:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case iu:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case su:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ru:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case ou:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case au:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case lu:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case cu:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case uu:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case hu:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case fu:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case du:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case pu:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case mu:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case gu:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case _u:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case ka:case vu:case xu:return Math.ceil(n/4)*Math.ceil(t/4)*16;case wm:case Mu:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Su:case yu:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function EE(n){switch(n){case es:case gm:return{byteLength:1,components:1};case Lo:case _m:case Io:return{byteLength:2,components:1};case rh:case oh:return{byteLength:2,components:4};case Xs:case sh:case Ki:return{byteLength:4,components:1};case vm:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}function wE(n,t,e,i,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ue,u=new WeakMap;let h;const f=new WeakMap;let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,b){return d?new OffscreenCanvas(P,b):qa("canvas")}function v(P,b,j){let J=1;const W=Pt(P);if((W.width>j||W.height>j)&&(J=j/Math.max(W.width,W.height)),J<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){const et=Math.floor(J*W.width),St=Math.floor(J*W.height);h===void 0&&(h=g(et,St));const _t=b?g(et,St):h;return _t.width=et,_t.height=St,_t.getContext("2d").drawImage(P,0,0,et,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+et+"x"+St+")."),_t}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){n.generateMipmap(P)}function y(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(P,b,j,J,W=!1){if(P!==null){if(n[P]!==void 0)return n[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=b;if(b===n.RED&&(j===n.FLOAT&&(et=n.R32F),j===n.HALF_FLOAT&&(et=n.R16F),j===n.UNSIGNED_BYTE&&(et=n.R8)),b===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.R8UI),j===n.UNSIGNED_SHORT&&(et=n.R16UI),j===n.UNSIGNED_INT&&(et=n.R32UI),j===n.BYTE&&(et=n.R8I),j===n.SHORT&&(et=n.R16I),j===n.INT&&(et=n.R32I)),b===n.RG&&(j===n.FLOAT&&(et=n.RG32F),j===n.HALF_FLOAT&&(et=n.RG16F),j===n.UNSIGNED_BYTE&&(et=n.RG8)),b===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.RG8UI),j===n.UNSIGNED_SHORT&&(et=n.RG16UI),j===n.UNSIGNED_INT&&(et=n.RG32UI),j===n.BYTE&&(et=n.RG8I),j===n.SHORT&&(et=n.RG16I),j===n.INT&&(et=n.RG32I)),b===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.RGB8UI),j===n.UNSIGNED_SHORT&&(et=n.RGB16UI),j===n.UNSIGNED_INT&&(et=n.RGB32UI),j===n.BYTE&&(et=n.RGB8I),j===n.SHORT&&(et=n.RGB16I),j===n.INT&&(et=n.RGB32I)),b===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),j===n.UNSIGNED_INT&&(et=n.RGBA32UI),j===n.BYTE&&(et=n.RGBA8I),j===n.SHORT&&(et=n.RGBA16I),j===n.INT&&(et=n.RGBA32I)),b===n.RGB&&j===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),b===n.RGBA){const St=W?pl:ve.getTransfer(J);j===n.FLOAT&&(et=n.RGBA32F),j===n.HALF_FLOAT&&(et=n.RGBA16F),j===n.UNSIGNED_BYTE&&(et=St===Ce?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(P,b){let j;return P?b===null||b===Xs||b===$r?j=n.DEPTH24_STENCIL8:b===Ki?j=n.DEPTH32F_STENCIL8:b===Lo&&(j=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Xs||b===$r?j=n.DEPTH_COMPONENT24:b===Ki?j=n.DEPTH_COMPONENT32F:b===Lo&&(j=n.DEPTH_COMPONENT16),j}function U(P,b){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==Mi&&P.minFilter!==Ii?Math.log2(Math.max(b.width,b.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?b.mipmaps.length:1}function A(P){const b=P.target;b.removeEventListener("dispose",A),I(b),b.isVideoTexture&&u.delete(b)}function D(P){const b=P.target;b.removeEventListener("dispose",D),S(b)}function I(P){const b=i.get(P);if(b.__webglInit===void 0)return;const j=P.source,J=f.get(j);if(J){const W=J[b.__cacheKey];W.usedTimes--,W.usedTimes===0&&w(P),Object.keys(J).length===0&&f.delete(j)}i.remove(P)}function w(P){const b=i.get(P);n.deleteTexture(b.__webglTexture);const j=P.source,J=f.get(j);delete J[b.__cacheKey],o.memory.textures--}function S(P){const b=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(b.__webglFramebuffer[J]))for(let W=0;W<b.__webglFramebuffer[J].length;W++)n.deleteFramebuffer(b.__webglFramebuffer[J][W]);else n.deleteFramebuffer(b.__webglFramebuffer[J]);b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer[J])}else{if(Array.isArray(b.__webglFramebuffer))for(let J=0;J<b.__webglFramebuffer.length;J++)n.deleteFramebuffer(b.__webglFramebuffer[J]);else n.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&n.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let J=0;J<b.__webglColorRenderbuffer.length;J++)b.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(b.__webglColorRenderbuffer[J]);b.__webglDepthRenderbuffer&&n.deleteRenderbuffer(b.__webglDepthRenderbuffer)}const j=P.textures;for(let J=0,W=j.length;J<W;J++){const et=i.get(j[J]);et.__webglTexture&&(n.deleteTexture(et.__webglTexture),o.memory.textures--),i.remove(j[J])}i.remove(P)}let C=0;function V(){C=0}function N(){const P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function G(P){const b=[];return b.push(P.wrapS),b.push(P.wrapT),b.push(P.wrapR||0),b.push(P.magFilter),b.push(P.minFilter),b.push(P.anisotropy),b.push(P.internalFormat),b.push(P.format),b.push(P.type),b.push(P.generateMipmaps),b.push(P.premultiplyAlpha),b.push(P.flipY),b.push(P.unpackAlignment),b.push(P.colorSpace),b.join()}function Z(P,b){const j=i.get(P);if(P.isVideoTexture&&Vt(P),P.isRenderTargetTexture===!1&&P.version>0&&j.__version!==P.version){const J=P.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{it(j,P,b);return}}e.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+b)}function K(P,b){const j=i.get(P);if(P.version>0&&j.__version!==P.version){it(j,P,b);return}e.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+b)}function Q(P,b){const j=i.get(P);if(P.version>0&&j.__version!==P.version){it(j,P,b);return}e.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+b)}function tt(P,b){const j=i.get(P);if(P.version>0&&j.__version!==P.version){at(j,P,b);return}e.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+b)}const ht={[jc]:n.REPEAT,[Vs]:n.CLAMP_TO_EDGE,[Kc]:n.MIRRORED_REPEAT},ct={[Mi]:n.NEAREST,[fx]:n.NEAREST_MIPMAP_NEAREST,[Zo]:n.NEAREST_MIPMAP_LINEAR,[Ii]:n.LINEAR,[Bl]:n.LINEAR_MIPMAP_NEAREST,[Gs]:n.LINEAR_MIPMAP_LINEAR},mt={[gx]:n.NEVER,[yx]:n.ALWAYS,[_x]:n.LESS,[Am]:n.LEQUAL,[vx]:n.EQUAL,[Sx]:n.GEQUAL,[xx]:n.GREATER,[Mx]:n.NOTEQUAL};function Mt(P,b){if(b.type===Ki&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===Ii||b.magFilter===Bl||b.magFilter===Zo||b.magFilter===Gs||b.minFilter===Ii||b.minFilter===Bl||b.minFilter===Zo||b.minFilter===Gs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ht[b.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ht[b.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ht[b.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ct[b.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ct[b.minFilter]),b.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,mt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Mi||b.minFilter!==Zo&&b.minFilter!==Gs||b.type===Ki&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||i.get(b).__currentAnisotropy){const j=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),i.get(b).__currentAnisotropy=b.anisotropy}}}function pt(P,b){let j=!1;P.__webglInit===void 0&&(P.__webglInit=!0,b.addEventListener("dispose",A));const J=b.source;let W=f.get(J);W===void 0&&(W={},f.set(J,W));const et=G(b);if(et!==P.__cacheKey){W[et]===void 0&&(W[et]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),W[et].usedTimes++;const St=W[P.__cacheKey];St!==void 0&&(W[P.__cacheKey].usedTimes--,St.usedTimes===0&&w(b)),P.__cacheKey=et,P.__webglTexture=W[et].texture}return j}function it(P,b,j){let J=n.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(J=n.TEXTURE_2D_ARRAY),b.isData3DTexture&&(J=n.TEXTURE_3D);const W=pt(P,b),et=b.source;e.bindTexture(J,P.__webglTexture,n.TEXTURE0+j);const St=i.get(et);if(et.version!==St.__version||W===!0){e.activeTexture(n.TEXTURE0+j);const _t=ve.getPrimaries(ve.workingColorSpace),wt=b.colorSpace===gs?null:ve.getPrimaries(b.colorSpace),Zt=b.colorSpace===gs||_t===wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Zt);let ft=v(b.image,!1,s.maxTextureSize);ft=me(b,ft);const vt=r.convert(b.format,b.colorSpace),Nt=r.convert(b.type);let Ot=T(b.internalFormat,vt,Nt,b.colorSpace,b.isVideoTexture);Mt(J,b);let bt;const se=b.mipmaps,Yt=b.isVideoTexture!==!0,ge=St.__version===void 0||W===!0,k=et.dataReady,xt=U(b,ft);if(b.isDepthTexture)Ot=x(b.format===Xr,b.type),ge&&(Yt?e.texStorage2D(n.TEXTURE_2D,1,Ot,ft.width,ft.height):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,null));else if(b.isDataTexture)if(se.length>0){Yt&&ge&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,se[0].width,se[0].height);for(let nt=0,rt=se.length;nt<rt;nt++)bt=se[nt],Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,bt.width,bt.height,vt,Nt,bt.data):e.texImage2D(n.TEXTURE_2D,nt,Ot,bt.width,bt.height,0,vt,Nt,bt.data);b.generateMipmaps=!1}else Yt?(ge&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height),k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ft.width,ft.height,vt,Nt,ft.data)):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,ft.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){Yt&&ge&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,se[0].width,se[0].height,ft.depth);for(let nt=0,rt=se.length;nt<rt;nt++)if(bt=se[nt],b.format!==xi)if(vt!==null)if(Yt){if(k)if(b.layerUpdates.size>0){const Tt=Fd(bt.width,bt.height,b.format,b.type);for(const At of b.layerUpdates){const Qt=bt.data.subarray(At*Tt/bt.data.BYTES_PER_ELEMENT,(At+1)*Tt/bt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,At,bt.width,bt.height,1,vt,Qt)}b.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,bt.width,bt.height,ft.depth,vt,bt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,nt,Ot,bt.width,bt.height,ft.depth,0,bt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?k&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,bt.width,bt.height,ft.depth,vt,Nt,bt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,nt,Ot,bt.width,bt.height,ft.depth,0,vt,Nt,bt.data)}else{Yt&&ge&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,se[0].width,se[0].height);for(let nt=0,rt=se.length;nt<rt;nt++)bt=se[nt],b.format!==xi?vt!==null?Yt?k&&e.compressedTexSubImage2D(n.TEXTURE_2D,nt,0,0,bt.width,bt.height,vt,bt.data):e.compressedTexImage2D(n.TEXTURE_2D,nt,Ot,bt.width,bt.height,0,bt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,bt.width,bt.height,vt,Nt,bt.data):e.texImage2D(n.TEXTURE_2D,nt,Ot,bt.width,bt.height,0,vt,Nt,bt.data)}else if(b.isDataArrayTexture)if(Yt){if(ge&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,ft.width,ft.height,ft.depth),k)if(b.layerUpdates.size>0){const nt=Fd(ft.width,ft.height,b.format,b.type);for(const rt of b.layerUpdates){const Tt=ft.data.subarray(rt*nt/ft.data.BYTES_PER_ELEMENT,(rt+1)*nt/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,vt,Nt,Tt)}b.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(b.isData3DTexture)Yt?(ge&&e.texStorage3D(n.TEXTURE_3D,xt,Ot,ft.width,ft.height,ft.depth),k&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)):e.texImage3D(n.TEXTURE_3D,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(b.isFramebufferTexture){if(ge)if(Yt)e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height);else{let nt=ft.width,rt=ft.height;for(let Tt=0;Tt<xt;Tt++)e.texImage2D(n.TEXTURE_2D,Tt,Ot,nt,rt,0,vt,Nt,null),nt>>=1,rt>>=1}}else if(se.length>0){if(Yt&&ge){const nt=Pt(se[0]);e.texStorage2D(n.TEXTURE_2D,xt,Ot,nt.width,nt.height)}for(let nt=0,rt=se.length;nt<rt;nt++)bt=se[nt],Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,vt,Nt,bt):e.texImage2D(n.TEXTURE_2D,nt,Ot,vt,Nt,bt);b.generateMipmaps=!1}else if(Yt){if(ge){const nt=Pt(ft);e.texStorage2D(n.TEXTURE_2D,xt,Ot,nt.width,nt.height)}k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,Nt,ft)}else e.texImage2D(n.TEXTURE_2D,0,Ot,vt,Nt,ft);m(b)&&p(J),St.__version=et.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function at(P,b,j){if(b.image.length!==6)return;const J=pt(P,b),W=b.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+j);const et=i.get(W);if(W.version!==et.__version||J===!0){e.activeTexture(n.TEXTURE0+j);const St=ve.getPrimaries(ve.workingColorSpace),_t=b.colorSpace===gs?null:ve.getPrimaries(b.colorSpace),wt=b.colorSpace===gs||St===_t?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,wt);const Zt=b.isCompressedTexture||b.image[0].isCompressedTexture,ft=b.image[0]&&b.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!Zt&&!ft?vt[rt]=v(b.image[rt],!0,s.maxCubemapSize):vt[rt]=ft?b.image[rt].image:b.image[rt],vt[rt]=me(b,vt[rt]);const Nt=vt[0],Ot=r.convert(b.format,b.colorSpace),bt=r.convert(b.type),se=T(b.internalFormat,Ot,bt,b.colorSpace),Yt=b.isVideoTexture!==!0,ge=et.__version===void 0||J===!0,k=W.dataReady;let xt=U(b,Nt);Mt(n.TEXTURE_CUBE_MAP,b);let nt;if(Zt){Yt&&ge&&e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,se,Nt.width,Nt.height);for(let rt=0;rt<6;rt++){nt=vt[rt].mipmaps;for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];b.format!==xi?Ot!==null?Yt?k&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,At.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,se,At.width,At.height,0,At.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,bt,At.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,se,At.width,At.height,0,Ot,bt,At.data)}}}else{if(nt=b.mipmaps,Yt&&ge){nt.length>0&&xt++;const rt=Pt(vt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,se,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ot,bt,vt[rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,se,vt[rt].width,vt[rt].height,0,Ot,bt,vt[rt].data);for(let Tt=0;Tt<nt.length;Tt++){const Qt=nt[Tt].image[rt].image;Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Qt.width,Qt.height,Ot,bt,Qt.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,se,Qt.width,Qt.height,0,Ot,bt,Qt.data)}}else{Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ot,bt,vt[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,se,Ot,bt,vt[rt]);for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Ot,bt,At.image[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,se,Ot,bt,At.image[rt])}}}m(b)&&p(n.TEXTURE_CUBE_MAP),et.__version=W.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function gt(P,b,j,J,W,et){const St=r.convert(j.format,j.colorSpace),_t=r.convert(j.type),wt=T(j.internalFormat,St,_t,j.colorSpace),Zt=i.get(b),ft=i.get(j);if(ft.__renderTarget=b,!Zt.__hasExternalTextures){const vt=Math.max(1,b.width>>et),Nt=Math.max(1,b.height>>et);W===n.TEXTURE_3D||W===n.TEXTURE_2D_ARRAY?e.texImage3D(W,et,wt,vt,Nt,b.depth,0,St,_t,null):e.texImage2D(W,et,wt,vt,Nt,0,St,_t,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),ne(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,J,W,ft.__webglTexture,0,te(b)):(W===n.TEXTURE_2D||W>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,J,W,ft.__webglTexture,et),e.bindFramebuffer(n.FRAMEBUFFER,null)}function ot(P,b,j){if(n.bindRenderbuffer(n.RENDERBUFFER,P),b.depthBuffer){const J=b.depthTexture,W=J&&J.isDepthTexture?J.type:null,et=x(b.stencilBuffer,W),St=b.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=te(b);ne(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_t,et,b.width,b.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,_t,et,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,et,b.width,b.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,P)}else{const J=b.textures;for(let W=0;W<J.length;W++){const et=J[W],St=r.convert(et.format,et.colorSpace),_t=r.convert(et.type),wt=T(et.internalFormat,St,_t,et.colorSpace),Zt=te(b);j&&ne(b)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Zt,wt,b.width,b.height):ne(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Zt,wt,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,wt,b.width,b.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Bt(P,b){if(b&&b.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const J=i.get(b.depthTexture);J.__renderTarget=b,(!J.__webglTexture||b.depthTexture.image.width!==b.width||b.depthTexture.image.height!==b.height)&&(b.depthTexture.image.width=b.width,b.depthTexture.image.height=b.height,b.depthTexture.needsUpdate=!0),Z(b.depthTexture,0);const W=J.__webglTexture,et=te(b);if(b.depthTexture.format===Dr)ne(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0);else if(b.depthTexture.format===Xr)ne(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0);else throw new Error("Unknown depthTexture format")}function Ht(P){const b=i.get(P),j=P.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==P.depthTexture){const J=P.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),J){const W=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,J.removeEventListener("dispose",W)};J.addEventListener("dispose",W),b.__depthDisposeCallback=W}b.__boundDepthTexture=J}if(P.depthTexture&&!b.__autoAllocateDepthBuffer){if(j)throw new Error("target.depthTexture not supported in Cube render targets");Bt(b.__webglFramebuffer,P)}else if(j){b.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[J]),b.__webglDepthbuffer[J]===void 0)b.__webglDepthbuffer[J]=n.createRenderbuffer(),ot(b.__webglDepthbuffer[J],P,!1);else{const W=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,et=b.__webglDepthbuffer[J];n.bindRenderbuffer(n.RENDERBUFFER,et),n.framebufferRenderbuffer(n.FRAMEBUFFER,W,n.RENDERBUFFER,et)}}else if(e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=n.createRenderbuffer(),ot(b.__webglDepthbuffer,P,!1);else{const J=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=b.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,J,n.RENDERBUFFER,W)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ut(P,b,j){const J=i.get(P);b!==void 0&&gt(J.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&Ht(P)}function fe(P){const b=P.texture,j=i.get(P),J=i.get(b);P.addEventListener("dispose",D);const W=P.textures,et=P.isWebGLCubeRenderTarget===!0,St=W.length>1;if(St||(J.__webglTexture===void 0&&(J.__webglTexture=n.createTexture()),J.__version=b.version,o.memory.textures++),et){j.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(b.mipmaps&&b.mipmaps.length>0){j.__webglFramebuffer[_t]=[];for(let wt=0;wt<b.mipmaps.length;wt++)j.__webglFramebuffer[_t][wt]=n.createFramebuffer()}else j.__webglFramebuffer[_t]=n.createFramebuffer()}else{if(b.mipmaps&&b.mipmaps.length>0){j.__webglFramebuffer=[];for(let _t=0;_t<b.mipmaps.length;_t++)j.__webglFramebuffer[_t]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(St)for(let _t=0,wt=W.length;_t<wt;_t++){const Zt=i.get(W[_t]);Zt.__webglTexture===void 0&&(Zt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&ne(P)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let _t=0;_t<W.length;_t++){const wt=W[_t];j.__webglColorRenderbuffer[_t]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[_t]);const Zt=r.convert(wt.format,wt.colorSpace),ft=r.convert(wt.type),vt=T(wt.internalFormat,Zt,ft,wt.colorSpace,P.isXRRenderTarget===!0),Nt=te(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,Nt,vt,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,j.__webglColorRenderbuffer[_t])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),ot(j.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(et){e.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture),Mt(n.TEXTURE_CUBE_MAP,b);for(let _t=0;_t<6;_t++)if(b.mipmaps&&b.mipmaps.length>0)for(let wt=0;wt<b.mipmaps.length;wt++)gt(j.__webglFramebuffer[_t][wt],P,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,wt);else gt(j.__webglFramebuffer[_t],P,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);m(b)&&p(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let _t=0,wt=W.length;_t<wt;_t++){const Zt=W[_t],ft=i.get(Zt);e.bindTexture(n.TEXTURE_2D,ft.__webglTexture),Mt(n.TEXTURE_2D,Zt),gt(j.__webglFramebuffer,P,Zt,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,0),m(Zt)&&p(n.TEXTURE_2D)}e.unbindTexture()}else{let _t=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(_t,J.__webglTexture),Mt(_t,b),b.mipmaps&&b.mipmaps.length>0)for(let wt=0;wt<b.mipmaps.length;wt++)gt(j.__webglFramebuffer[wt],P,b,n.COLOR_ATTACHMENT0,_t,wt);else gt(j.__webglFramebuffer,P,b,n.COLOR_ATTACHMENT0,_t,0);m(b)&&p(_t),e.unbindTexture()}P.depthBuffer&&Ht(P)}function Jt(P){const b=P.textures;for(let j=0,J=b.length;j<J;j++){const W=b[j];if(m(W)){const et=y(P),St=i.get(W).__webglTexture;e.bindTexture(et,St),p(et),e.unbindTexture()}}}const de=[],z=[];function Qe(P){if(P.samples>0){if(ne(P)===!1){const b=P.textures,j=P.width,J=P.height;let W=n.COLOR_BUFFER_BIT;const et=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(P),_t=b.length>1;if(_t)for(let wt=0;wt<b.length;wt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let wt=0;wt<b.length;wt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(W|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(W|=n.STENCIL_BUFFER_BIT)),_t){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const Zt=i.get(b[wt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,Zt,0)}n.blitFramebuffer(0,0,j,J,0,0,j,J,W,n.NEAREST),l===!0&&(de.length=0,z.length=0,de.push(n.COLOR_ATTACHMENT0+wt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(de.push(et),z.push(et),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,z)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,de))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),_t)for(let wt=0;wt<b.length;wt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const Zt=i.get(b[wt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.TEXTURE_2D,Zt,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){const b=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[b])}}}function te(P){return Math.min(s.maxSamples,P.samples)}function ne(P){const b=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Vt(P){const b=o.render.frame;u.get(P)!==b&&(u.set(P,b),P.update())}function me(P,b){const j=P.colorSpace,J=P.format,W=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||j!==Zs&&j!==gs&&(ve.getTransfer(j)===Ce?(J!==xi||W!==es)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",j)),b}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=N,this.resetTextureUnits=V,this.setTexture2D=Z,this.setTexture2DArray=K,this.setTexture3D=Q,this.setTextureCube=tt,this.rebindTextures=Ut,this.setupRenderTarget=fe,this.updateRenderTargetMipmap=Jt,this.updateMultisampleRenderTarget=Qe,this.setupDepthRenderbuffer=Ht,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=ne}function TE(n,t){function e(i,s=gs){let r;const o=ve.getTransfer(s);if(i===es)return n.UNSIGNED_BYTE;if(i===rh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===oh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===vm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===gm)return n.BYTE;if(i===_m)return n.SHORT;if(i===Lo)return n.UNSIGNED_SHORT;if(i===sh)return n.INT;if(i===Xs)return n.UNSIGNED_INT;if(i===Ki)return n.FLOAT;if(i===Io)return n.HALF_FLOAT;if(i===xm)return n.ALPHA;if(i===Mm)return n.RGB;if(i===xi)return n.RGBA;if(i===Sm)return n.LUMINANCE;if(i===ym)return n.LUMINANCE_ALPHA;if(i===Dr)return n.DEPTH_COMPONENT;if(i===Xr)return n.DEPTH_STENCIL;if(i===bm)return n.RED;if(i===ah)return n.RED_INTEGER;if(i===Em)return n.RG;if(i===lh)return n.RG_INTEGER;if(i===ch)return n.RGBA_INTEGER;if(i===Ua||i===Na||i===Fa||i===Oa)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ua)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Na)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ua)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Na)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Oa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zc||i===Jc||i===Qc||i===tu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Jc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Qc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===tu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===eu||i===nu||i===iu)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===eu||i===nu)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===iu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===su||i===ru||i===ou||i===au||i===lu||i===cu||i===uu||i===hu||i===fu||i===du||i===pu||i===mu||i===gu||i===_u)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===su)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ru)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ou)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===au)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===lu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===cu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===uu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===hu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===du)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===pu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===mu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===gu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===_u)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ka||i===vu||i===xu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===ka)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===vu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===xu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===wm||i===Mu||i===Su||i===yu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===ka)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Mu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Su)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===yu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===$r?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}class AE extends Yn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class Ui extends sn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const RE={type:"move"};class dc{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ui,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ui,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ui,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(RE)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const i=new Ui;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}}const CE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,PE=`
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

}`;class LE{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,i){if(this.texture===null){const s=new Bn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=i.depthNear||e.depthFar!=i.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,i=new Ss({vertexShader:CE,fragmentShader:PE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new bn(new ml(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class DE extends Qr{constructor(t,e){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null;const v=new LE,m=e.getContextAttributes();let p=null,y=null;const T=[],x=[],U=new ue;let A=null;const D=new Yn;D.viewport=new $e;const I=new Yn;I.viewport=new $e;const w=[D,I],S=new AE;let C=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let at=T[it];return at===void 0&&(at=new dc,T[it]=at),at.getTargetRaySpace()},this.getControllerGrip=function(it){let at=T[it];return at===void 0&&(at=new dc,T[it]=at),at.getGripSpace()},this.getHand=function(it){let at=T[it];return at===void 0&&(at=new dc,T[it]=at),at.getHandSpace()};function N(it){const at=x.indexOf(it.inputSource);if(at===-1)return;const gt=T[at];gt!==void 0&&(gt.update(it.inputSource,it.frame,c||o),gt.dispatchEvent({type:it.type,data:it.inputSource}))}function G(){s.removeEventListener("select",N),s.removeEventListener("selectstart",N),s.removeEventListener("selectend",N),s.removeEventListener("squeeze",N),s.removeEventListener("squeezestart",N),s.removeEventListener("squeezeend",N),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",Z);for(let it=0;it<T.length;it++){const at=x[it];at!==null&&(x[it]=null,T[it].disconnect(at))}C=null,V=null,v.reset(),t.setRenderTarget(p),d=null,f=null,h=null,s=null,y=null,pt.stop(),i.isPresenting=!1,t.setPixelRatio(A),t.setSize(U.width,U.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",N),s.addEventListener("selectstart",N),s.addEventListener("selectend",N),s.addEventListener("squeeze",N),s.addEventListener("squeezestart",N),s.addEventListener("squeezeend",N),s.addEventListener("end",G),s.addEventListener("inputsourceschange",Z),m.xrCompatible!==!0&&await e.makeXRCompatible(),A=t.getPixelRatio(),t.getSize(U),s.renderState.layers===void 0){const at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),y=new qs(d.framebufferWidth,d.framebufferHeight,{format:xi,type:es,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,gt=null,ot=null;m.depth&&(ot=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?Xr:Dr,gt=m.stencil?$r:Xs);const Bt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};h=new XRWebGLBinding(s,e),f=h.createProjectionLayer(Bt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),y=new qs(f.textureWidth,f.textureHeight,{format:xi,type:es,depthTexture:new Bm(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function Z(it){for(let at=0;at<it.removed.length;at++){const gt=it.removed[at],ot=x.indexOf(gt);ot>=0&&(x[ot]=null,T[ot].disconnect(gt))}for(let at=0;at<it.added.length;at++){const gt=it.added[at];let ot=x.indexOf(gt);if(ot===-1){for(let Ht=0;Ht<T.length;Ht++)if(Ht>=x.length){x.push(gt),ot=Ht;break}else if(x[Ht]===null){x[Ht]=gt,ot=Ht;break}if(ot===-1)break}const Bt=T[ot];Bt&&Bt.connect(gt)}}const K=new B,Q=new B;function tt(it,at,gt){K.setFromMatrixPosition(at.matrixWorld),Q.setFromMatrixPosition(gt.matrixWorld);const ot=K.distanceTo(Q),Bt=at.projectionMatrix.elements,Ht=gt.projectionMatrix.elements,Ut=Bt[14]/(Bt[10]-1),fe=Bt[14]/(Bt[10]+1),Jt=(Bt[9]+1)/Bt[5],de=(Bt[9]-1)/Bt[5],z=(Bt[8]-1)/Bt[0],Qe=(Ht[8]+1)/Ht[0],te=Ut*z,ne=Ut*Qe,Vt=ot/(-z+Qe),me=Vt*-z;if(at.matrixWorld.decompose(it.position,it.quaternion,it.scale),it.translateX(me),it.translateZ(Vt),it.matrixWorld.compose(it.position,it.quaternion,it.scale),it.matrixWorldInverse.copy(it.matrixWorld).invert(),Bt[10]===-1)it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Pt=Ut+Vt,P=fe+Vt,b=te-me,j=ne+(ot-me),J=Jt*fe/P*Pt,W=de*fe/P*Pt;it.projectionMatrix.makePerspective(b,j,J,W,Pt,P),it.projectionMatrixInverse.copy(it.projectionMatrix).invert()}}function ht(it,at){at===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(at.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let at=it.near,gt=it.far;v.texture!==null&&(v.depthNear>0&&(at=v.depthNear),v.depthFar>0&&(gt=v.depthFar)),S.near=I.near=D.near=at,S.far=I.far=D.far=gt,(C!==S.near||V!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,V=S.far),D.layers.mask=it.layers.mask|2,I.layers.mask=it.layers.mask|4,S.layers.mask=D.layers.mask|I.layers.mask;const ot=it.parent,Bt=S.cameras;ht(S,ot);for(let Ht=0;Ht<Bt.length;Ht++)ht(Bt[Ht],ot);Bt.length===2?tt(S,D,I):S.projectionMatrix.copy(D.projectionMatrix),ct(it,S,ot)};function ct(it,at,gt){gt===null?it.matrix.copy(at.matrixWorld):(it.matrix.copy(gt.matrixWorld),it.matrix.invert(),it.matrix.multiply(at.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=bu*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(it){l=it,f!==null&&(f.fixedFoveation=it),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=it)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let mt=null;function Mt(it,at){if(u=at.getViewerPose(c||o),g=at,u!==null){const gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(y,d.framebuffer),t.setRenderTarget(y));let ot=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Ht=0;Ht<gt.length;Ht++){const Ut=gt[Ht];let fe=null;if(d!==null)fe=d.getViewport(Ut);else{const de=h.getViewSubImage(f,Ut);fe=de.viewport,Ht===0&&(t.setRenderTargetTextures(y,de.colorTexture,f.ignoreDepthValues?void 0:de.depthStencilTexture),t.setRenderTarget(y))}let Jt=w[Ht];Jt===void 0&&(Jt=new Yn,Jt.layers.enable(Ht),Jt.viewport=new $e,w[Ht]=Jt),Jt.matrix.fromArray(Ut.transform.matrix),Jt.matrix.decompose(Jt.position,Jt.quaternion,Jt.scale),Jt.projectionMatrix.fromArray(Ut.projectionMatrix),Jt.projectionMatrixInverse.copy(Jt.projectionMatrix).invert(),Jt.viewport.set(fe.x,fe.y,fe.width,fe.height),Ht===0&&(S.matrix.copy(Jt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(Jt)}const Bt=s.enabledFeatures;if(Bt&&Bt.includes("depth-sensing")){const Ht=h.getDepthInformation(gt[0]);Ht&&Ht.isValid&&Ht.texture&&v.init(t,Ht,s.renderState)}}for(let gt=0;gt<T.length;gt++){const ot=x[gt],Bt=T[gt];ot!==null&&Bt!==void 0&&Bt.update(ot,at,c||o)}mt&&mt(it,at),at.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:at}),g=null}const pt=new km;pt.setAnimationLoop(Mt),this.setAnimationLoop=function(it){mt=it},this.dispose=function(){}}}const Us=new Bi,IE=new Ne;function UE(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Nm(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,T,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,x)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===kn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===kn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const y=t.get(p),T=y.envMap,x=y.envMapRotation;T&&(m.envMap.value=T,Us.copy(x),Us.x*=-1,Us.y*=-1,Us.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(Us.y*=-1,Us.z*=-1),m.envMapRotation.value.setFromMatrix4(IE.makeRotationFromEuler(Us)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=T*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,y){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===kn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const y=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function NE(n,t,e,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(y,T){const x=T.program;i.uniformBlockBinding(y,x)}function c(y,T){let x=s[y.id];x===void 0&&(g(y),x=u(y),s[y.id]=x,y.addEventListener("dispose",m));const U=T.program;i.updateUBOMapping(y,U);const A=t.render.frame;r[y.id]!==A&&(f(y),r[y.id]=A)}function u(y){const T=h();y.__bindingPointIndex=T;const x=n.createBuffer(),U=y.__size,A=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,x),n.bufferData(n.UNIFORM_BUFFER,U,A),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,T,x),x}function h(){for(let y=0;y<a;y++)if(o.indexOf(y)===-1)return o.push(y),y;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(y){const T=s[y.id],x=y.uniforms,U=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,D=x.length;A<D;A++){const I=Array.isArray(x[A])?x[A]:[x[A]];for(let w=0,S=I.length;w<S;w++){const C=I[w];if(d(C,A,w,U)===!0){const V=C.__offset,N=Array.isArray(C.value)?C.value:[C.value];let G=0;for(let Z=0;Z<N.length;Z++){const K=N[Z],Q=v(K);typeof K=="number"||typeof K=="boolean"?(C.__data[0]=K,n.bufferSubData(n.UNIFORM_BUFFER,V+G,C.__data)):K.isMatrix3?(C.__data[0]=K.elements[0],C.__data[1]=K.elements[1],C.__data[2]=K.elements[2],C.__data[3]=0,C.__data[4]=K.elements[3],C.__data[5]=K.elements[4],C.__data[6]=K.elements[5],C.__data[7]=0,C.__data[8]=K.elements[6],C.__data[9]=K.elements[7],C.__data[10]=K.elements[8],C.__data[11]=0):(K.toArray(C.__data,G),G+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,V,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(y,T,x,U){const A=y.value,D=T+"_"+x;if(U[D]===void 0)return typeof A=="number"||typeof A=="boolean"?U[D]=A:U[D]=A.clone(),!0;{const I=U[D];if(typeof A=="number"||typeof A=="boolean"){if(I!==A)return U[D]=A,!0}else if(I.equals(A)===!1)return I.copy(A),!0}return!1}function g(y){const T=y.uniforms;let x=0;const U=16;for(let D=0,I=T.length;D<I;D++){const w=Array.isArray(T[D])?T[D]:[T[D]];for(let S=0,C=w.length;S<C;S++){const V=w[S],N=Array.isArray(V.value)?V.value:[V.value];for(let G=0,Z=N.length;G<Z;G++){const K=N[G],Q=v(K),tt=x%U,ht=tt%Q.boundary,ct=tt+ht;x+=ht,ct!==0&&U-ct<Q.storage&&(x+=U-ct),V.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=x,x+=Q.storage}}}const A=x%U;return A>0&&(x+=U-A),y.__size=x,y.__cache={},this}function v(y){const T={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(T.boundary=4,T.storage=4):y.isVector2?(T.boundary=8,T.storage=8):y.isVector3||y.isColor?(T.boundary=16,T.storage=12):y.isVector4?(T.boundary=16,T.storage=16):y.isMatrix3?(T.boundary=48,T.storage=48):y.isMatrix4?(T.boundary=64,T.storage=64):y.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",y),T}function m(y){const T=y.target;T.removeEventListener("dispose",m);const x=o.indexOf(T.__bindingPointIndex);o.splice(x,1),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(const y in s)n.deleteBuffer(s[y]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class FE{constructor(t={}){const{canvas:e=Ex(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=i.getContextAttributes().alpha}else d=o;const g=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const y=[],T=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=oi,this.toneMapping=vs,this.toneMappingExposure=1;const x=this;let U=!1,A=0,D=0,I=null,w=-1,S=null;const C=new $e,V=new $e;let N=null;const G=new ce(0);let Z=0,K=e.width,Q=e.height,tt=1,ht=null,ct=null;const mt=new $e(0,0,K,Q),Mt=new $e(0,0,K,Q);let pt=!1;const it=new hh;let at=!1,gt=!1;const ot=new Ne,Bt=new Ne,Ht=new B,Ut=new $e,fe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Jt=!1;function de(){return I===null?tt:1}let z=i;function Qe(E,O){return e.getContext(E,O)}try{const E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${nh}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",Tt,!1),e.addEventListener("webglcontextcreationerror",At,!1),z===null){const O="webgl2";if(z=Qe(O,E),z===null)throw Qe(O)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let te,ne,Vt,me,Pt,P,b,j,J,W,et,St,_t,wt,Zt,ft,vt,Nt,Ot,bt,se,Yt,ge,k;function xt(){te=new Hy(z),te.init(),Yt=new TE(z,te),ne=new Ny(z,te,t,Yt),Vt=new bE(z,te),ne.reverseDepthBuffer&&f&&Vt.buffers.depth.setReversed(!0),me=new Wy(z),Pt=new lE,P=new wE(z,te,Vt,Pt,ne,Yt,me),b=new Oy(x),j=new zy(x),J=new Zx(z),ge=new Iy(z,J),W=new Vy(z,J,me,ge),et=new Xy(z,W,J,me),Ot=new $y(z,ne,P),ft=new Fy(Pt),St=new aE(x,b,j,te,ne,ge,ft),_t=new UE(x,Pt),wt=new uE,Zt=new gE(te),Nt=new Dy(x,b,j,Vt,et,d,l),vt=new SE(x,et,ne),k=new NE(z,me,ne,Vt),bt=new Uy(z,te,me),se=new Gy(z,te,me),me.programs=St.programs,x.capabilities=ne,x.extensions=te,x.properties=Pt,x.renderLists=wt,x.shadowMap=vt,x.state=Vt,x.info=me}xt();const nt=new DE(x,z);this.xr=nt,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){const E=te.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){const E=te.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return tt},this.setPixelRatio=function(E){E!==void 0&&(tt=E,this.setSize(K,Q,!1))},this.getSize=function(E){return E.set(K,Q)},this.setSize=function(E,O,X=!0){if(nt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=E,Q=O,e.width=Math.floor(E*tt),e.height=Math.floor(O*tt),X===!0&&(e.style.width=E+"px",e.style.height=O+"px"),this.setViewport(0,0,E,O)},this.getDrawingBufferSize=function(E){return E.set(K*tt,Q*tt).floor()},this.setDrawingBufferSize=function(E,O,X){K=E,Q=O,tt=X,e.width=Math.floor(E*X),e.height=Math.floor(O*X),this.setViewport(0,0,E,O)},this.getCurrentViewport=function(E){return E.copy(C)},this.getViewport=function(E){return E.copy(mt)},this.setViewport=function(E,O,X,q){E.isVector4?mt.set(E.x,E.y,E.z,E.w):mt.set(E,O,X,q),Vt.viewport(C.copy(mt).multiplyScalar(tt).round())},this.getScissor=function(E){return E.copy(Mt)},this.setScissor=function(E,O,X,q){E.isVector4?Mt.set(E.x,E.y,E.z,E.w):Mt.set(E,O,X,q),Vt.scissor(V.copy(Mt).multiplyScalar(tt).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(E){Vt.setScissorTest(pt=E)},this.setOpaqueSort=function(E){ht=E},this.setTransparentSort=function(E){ct=E},this.getClearColor=function(E){return E.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(E=!0,O=!0,X=!0){let q=0;if(E){let H=!1;if(I!==null){const ut=I.texture.format;H=ut===ch||ut===lh||ut===ah}if(H){const ut=I.texture.type,yt=ut===es||ut===Xs||ut===Lo||ut===$r||ut===rh||ut===oh,Ft=Nt.getClearColor(),Dt=Nt.getClearAlpha(),$t=Ft.r,qt=Ft.g,It=Ft.b;yt?(g[0]=$t,g[1]=qt,g[2]=It,g[3]=Dt,z.clearBufferuiv(z.COLOR,0,g)):(v[0]=$t,v[1]=qt,v[2]=It,v[3]=Dt,z.clearBufferiv(z.COLOR,0,v))}else q|=z.COLOR_BUFFER_BIT}O&&(q|=z.DEPTH_BUFFER_BIT),X&&(q|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),z.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",Tt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),wt.dispose(),Zt.dispose(),Pt.dispose(),b.dispose(),j.dispose(),et.dispose(),ge.dispose(),k.dispose(),St.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Hn),nt.removeEventListener("sessionend",zi),Un.stop()};function rt(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),U=!0}function Tt(){console.log("THREE.WebGLRenderer: Context Restored."),U=!1;const E=me.autoReset,O=vt.enabled,X=vt.autoUpdate,q=vt.needsUpdate,H=vt.type;xt(),me.autoReset=E,vt.enabled=O,vt.autoUpdate=X,vt.needsUpdate=q,vt.type=H}function At(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function Qt(E){const O=E.target;O.removeEventListener("dispose",Qt),Ve(O)}function Ve(E){cn(E),Pt.remove(E)}function cn(E){const O=Pt.get(E).programs;O!==void 0&&(O.forEach(function(X){St.releaseProgram(X)}),E.isShaderMaterial&&St.releaseShaderCache(E))}this.renderBufferDirect=function(E,O,X,q,H,ut){O===null&&(O=fe);const yt=H.isMesh&&H.matrixWorld.determinant()<0,Ft=xl(E,O,X,q,H);Vt.setMaterial(q,yt);let Dt=X.index,$t=1;if(q.wireframe===!0){if(Dt=W.getWireframeAttribute(X),Dt===void 0)return;$t=2}const qt=X.drawRange,It=X.attributes.position;let ae=qt.start*$t,Ee=(qt.start+qt.count)*$t;ut!==null&&(ae=Math.max(ae,ut.start*$t),Ee=Math.min(Ee,(ut.start+ut.count)*$t)),Dt!==null?(ae=Math.max(ae,0),Ee=Math.min(Ee,Dt.count)):It!=null&&(ae=Math.max(ae,0),Ee=Math.min(Ee,It.count));const Ae=Ee-ae;if(Ae<0||Ae===1/0)return;ge.setup(H,q,Ft,X,Dt);let un,pe=bt;if(Dt!==null&&(un=J.get(Dt),pe=se,pe.setIndex(un)),H.isMesh)q.wireframe===!0?(Vt.setLineWidth(q.wireframeLinewidth*de()),pe.setMode(z.LINES)):pe.setMode(z.TRIANGLES);else if(H.isLine){let kt=q.linewidth;kt===void 0&&(kt=1),Vt.setLineWidth(kt*de()),H.isLineSegments?pe.setMode(z.LINES):H.isLineLoop?pe.setMode(z.LINE_LOOP):pe.setMode(z.LINE_STRIP)}else H.isPoints?pe.setMode(z.POINTS):H.isSprite&&pe.setMode(z.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)pe.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(te.get("WEBGL_multi_draw"))pe.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const kt=H._multiDrawStarts,Ge=H._multiDrawCounts,_e=H._multiDrawCount,Nn=Dt?J.get(Dt).bytesPerElement:1,yi=Pt.get(q).currentProgram.getUniforms();for(let Mn=0;Mn<_e;Mn++)yi.setValue(z,"_gl_DrawID",Mn),pe.render(kt[Mn]/Nn,Ge[Mn])}else if(H.isInstancedMesh)pe.renderInstances(ae,Ae,H.count);else if(X.isInstancedBufferGeometry){const kt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,Ge=Math.min(X.instanceCount,kt);pe.renderInstances(ae,Ae,Ge)}else pe.render(ae,Ae)};function Se(E,O,X){E.transparent===!0&&E.side===Pi&&E.forceSinglePass===!1?(E.side=kn,E.needsUpdate=!0,Qs(E,O,X),E.side=Ms,E.needsUpdate=!0,Qs(E,O,X),E.side=Pi):Qs(E,O,X)}this.compile=function(E,O,X=null){X===null&&(X=E),p=Zt.get(X),p.init(O),T.push(p),X.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),E!==X&&E.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),p.setupLights();const q=new Set;return E.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const ut=H.material;if(ut)if(Array.isArray(ut))for(let yt=0;yt<ut.length;yt++){const Ft=ut[yt];Se(Ft,X,H),q.add(Ft)}else Se(ut,X,H),q.add(ut)}),T.pop(),p=null,q},this.compileAsync=function(E,O,X=null){const q=this.compile(E,O,X);return new Promise(H=>{function ut(){if(q.forEach(function(yt){Pt.get(yt).currentProgram.isReady()&&q.delete(yt)}),q.size===0){H(E);return}setTimeout(ut,10)}te.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let tn=null;function Ue(E){tn&&tn(E)}function Hn(){Un.stop()}function zi(){Un.start()}const Un=new km;Un.setAnimationLoop(Ue),typeof self<"u"&&Un.setContext(self),this.setAnimationLoop=function(E){tn=E,nt.setAnimationLoop(E),E===null?Un.stop():Un.start()},nt.addEventListener("sessionstart",Hn),nt.addEventListener("sessionend",zi),this.render=function(E,O){if(O!==void 0&&O.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(O),O=nt.getCamera()),E.isScene===!0&&E.onBeforeRender(x,E,O,I),p=Zt.get(E,T.length),p.init(O),T.push(p),Bt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),it.setFromProjectionMatrix(Bt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),m=wt.get(E,y.length),m.init(),y.push(m),nt.enabled===!0&&nt.isPresenting===!0){const ut=x.xr.getDepthSensingMesh();ut!==null&&xn(ut,O,-1/0,x.sortObjects)}xn(E,O,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(ht,ct),Jt=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Jt&&Nt.addToRenderList(m,E),this.info.render.frame++,at===!0&&ft.beginShadows();const X=p.state.shadowsArray;vt.render(X,E,O),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const q=m.opaque,H=m.transmissive;if(p.setupLights(),O.isArrayCamera){const ut=O.cameras;if(H.length>0)for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Vi(q,H,E,Dt)}Jt&&Nt.render(E);for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Hi(m,E,Dt,Dt.viewport)}}else H.length>0&&Vi(q,H,E,O),Jt&&Nt.render(E),Hi(m,E,O);I!==null&&(P.updateMultisampleRenderTarget(I),P.updateRenderTargetMipmap(I)),E.isScene===!0&&E.onAfterRender(x,E,O),ge.resetDefaultState(),w=-1,S=null,T.pop(),T.length>0?(p=T[T.length-1],at===!0&&ft.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,y.pop(),y.length>0?m=y[y.length-1]:m=null};function xn(E,O,X,q){if(E.visible===!1)return;if(E.layers.test(O.layers)){if(E.isGroup)X=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(O);else if(E.isLight)p.pushLight(E),E.castShadow&&p.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||it.intersectsSprite(E)){q&&Ut.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Bt);const yt=et.update(E),Ft=E.material;Ft.visible&&m.push(E,yt,Ft,X,Ut.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||it.intersectsObject(E))){const yt=et.update(E),Ft=E.material;if(q&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ut.copy(E.boundingSphere.center)):(yt.boundingSphere===null&&yt.computeBoundingSphere(),Ut.copy(yt.boundingSphere.center)),Ut.applyMatrix4(E.matrixWorld).applyMatrix4(Bt)),Array.isArray(Ft)){const Dt=yt.groups;for(let $t=0,qt=Dt.length;$t<qt;$t++){const It=Dt[$t],ae=Ft[It.materialIndex];ae&&ae.visible&&m.push(E,yt,ae,X,Ut.z,It)}}else Ft.visible&&m.push(E,yt,Ft,X,Ut.z,null)}}const ut=E.children;for(let yt=0,Ft=ut.length;yt<Ft;yt++)xn(ut[yt],O,X,q)}function Hi(E,O,X,q){const H=E.opaque,ut=E.transmissive,yt=E.transparent;p.setupLightsView(X),at===!0&&ft.setGlobalState(x.clippingPlanes,X),q&&Vt.viewport(C.copy(q)),H.length>0&&bs(H,O,X),ut.length>0&&bs(ut,O,X),yt.length>0&&bs(yt,O,X),Vt.buffers.depth.setTest(!0),Vt.buffers.depth.setMask(!0),Vt.buffers.color.setMask(!0),Vt.setPolygonOffset(!1)}function Vi(E,O,X,q){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[q.id]===void 0&&(p.state.transmissionRenderTarget[q.id]=new qs(1,1,{generateMipmaps:!0,type:te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float")?Io:es,minFilter:Gs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ve.workingColorSpace}));const ut=p.state.transmissionRenderTarget[q.id],yt=q.viewport||C;ut.setSize(yt.z,yt.w);const Ft=x.getRenderTarget();x.setRenderTarget(ut),x.getClearColor(G),Z=x.getClearAlpha(),Z<1&&x.setClearColor(16777215,.5),x.clear(),Jt&&Nt.render(X);const Dt=x.toneMapping;x.toneMapping=vs;const $t=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),p.setupLightsView(q),at===!0&&ft.setGlobalState(x.clippingPlanes,q),bs(E,X,q),P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut),te.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let It=0,ae=O.length;It<ae;It++){const Ee=O[It],Ae=Ee.object,un=Ee.geometry,pe=Ee.material,kt=Ee.group;if(pe.side===Pi&&Ae.layers.test(q.layers)){const Ge=pe.side;pe.side=kn,pe.needsUpdate=!0,ro(Ae,X,q,un,pe,kt),pe.side=Ge,pe.needsUpdate=!0,qt=!0}}qt===!0&&(P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut))}x.setRenderTarget(Ft),x.setClearColor(G,Z),$t!==void 0&&(q.viewport=$t),x.toneMapping=Dt}function bs(E,O,X){const q=O.isScene===!0?O.overrideMaterial:null;for(let H=0,ut=E.length;H<ut;H++){const yt=E[H],Ft=yt.object,Dt=yt.geometry,$t=q===null?yt.material:q,qt=yt.group;Ft.layers.test(X.layers)&&ro(Ft,O,X,Dt,$t,qt)}}function ro(E,O,X,q,H,ut){E.onBeforeRender(x,O,X,q,H,ut),E.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),H.onBeforeRender(x,O,X,q,E,ut),H.transparent===!0&&H.side===Pi&&H.forceSinglePass===!1?(H.side=kn,H.needsUpdate=!0,x.renderBufferDirect(X,O,q,H,E,ut),H.side=Ms,H.needsUpdate=!0,x.renderBufferDirect(X,O,q,H,E,ut),H.side=Pi):x.renderBufferDirect(X,O,q,H,E,ut),E.onAfterRender(x,O,X,q,H,ut)}function Qs(E,O,X){O.isScene!==!0&&(O=fe);const q=Pt.get(E),H=p.state.lights,ut=p.state.shadowsArray,yt=H.state.version,Ft=St.getParameters(E,H.state,ut,O,X),Dt=St.getProgramCacheKey(Ft);let $t=q.programs;q.environment=E.isMeshStandardMaterial?O.environment:null,q.fog=O.fog,q.envMap=(E.isMeshStandardMaterial?j:b).get(E.envMap||q.environment),q.envMapRotation=q.environment!==null&&E.envMap===null?O.environmentRotation:E.envMapRotation,$t===void 0&&(E.addEventListener("dispose",Qt),$t=new Map,q.programs=$t);let qt=$t.get(Dt);if(qt!==void 0){if(q.currentProgram===qt&&q.lightsStateVersion===yt)return Si(E,Ft),qt}else Ft.uniforms=St.getUniforms(E),E.onBeforeCompile(Ft,x),qt=St.acquireProgram(Ft,Dt),$t.set(Dt,qt),q.uniforms=Ft.uniforms;const It=q.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(It.clippingPlanes=ft.uniform),Si(E,Ft),q.needsLights=ko(E),q.lightsStateVersion=yt,q.needsLights&&(It.ambientLightColor.value=H.state.ambient,It.lightProbe.value=H.state.probe,It.directionalLights.value=H.state.directional,It.directionalLightShadows.value=H.state.directionalShadow,It.spotLights.value=H.state.spot,It.spotLightShadows.value=H.state.spotShadow,It.rectAreaLights.value=H.state.rectArea,It.ltc_1.value=H.state.rectAreaLTC1,It.ltc_2.value=H.state.rectAreaLTC2,It.pointLights.value=H.state.point,It.pointLightShadows.value=H.state.pointShadow,It.hemisphereLights.value=H.state.hemi,It.directionalShadowMap.value=H.state.directionalShadowMap,It.directionalShadowMatrix.value=H.state.directionalShadowMatrix,It.spotShadowMap.value=H.state.spotShadowMap,It.spotLightMatrix.value=H.state.spotLightMatrix,It.spotLightMap.value=H.state.spotLightMap,It.pointShadowMap.value=H.state.pointShadowMap,It.pointShadowMatrix.value=H.state.pointShadowMatrix),q.currentProgram=qt,q.uniformsList=null,qt}function Oo(E){if(E.uniformsList===null){const O=E.currentProgram.getUniforms();E.uniformsList=za.seqWithValue(O.seq,E.uniforms)}return E.uniformsList}function Si(E,O){const X=Pt.get(E);X.outputColorSpace=O.outputColorSpace,X.batching=O.batching,X.batchingColor=O.batchingColor,X.instancing=O.instancing,X.instancingColor=O.instancingColor,X.instancingMorph=O.instancingMorph,X.skinning=O.skinning,X.morphTargets=O.morphTargets,X.morphNormals=O.morphNormals,X.morphColors=O.morphColors,X.morphTargetsCount=O.morphTargetsCount,X.numClippingPlanes=O.numClippingPlanes,X.numIntersection=O.numClipIntersection,X.vertexAlphas=O.vertexAlphas,X.vertexTangents=O.vertexTangents,X.toneMapping=O.toneMapping}function xl(E,O,X,q,H){O.isScene!==!0&&(O=fe),P.resetTextureUnits();const ut=O.fog,yt=q.isMeshStandardMaterial?O.environment:null,Ft=I===null?x.outputColorSpace:I.isXRRenderTarget===!0?I.texture.colorSpace:Zs,Dt=(q.isMeshStandardMaterial?j:b).get(q.envMap||yt),$t=q.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,qt=!!X.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),It=!!X.morphAttributes.position,ae=!!X.morphAttributes.normal,Ee=!!X.morphAttributes.color;let Ae=vs;q.toneMapped&&(I===null||I.isXRRenderTarget===!0)&&(Ae=x.toneMapping);const un=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,pe=un!==void 0?un.length:0,kt=Pt.get(q),Ge=p.state.lights;if(at===!0&&(gt===!0||E!==S)){const wn=E===S&&q.id===w;ft.setState(q,E,wn)}let _e=!1;q.version===kt.__version?(kt.needsLights&&kt.lightsStateVersion!==Ge.state.version||kt.outputColorSpace!==Ft||H.isBatchedMesh&&kt.batching===!1||!H.isBatchedMesh&&kt.batching===!0||H.isBatchedMesh&&kt.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&kt.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&kt.instancing===!1||!H.isInstancedMesh&&kt.instancing===!0||H.isSkinnedMesh&&kt.skinning===!1||!H.isSkinnedMesh&&kt.skinning===!0||H.isInstancedMesh&&kt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&kt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&kt.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&kt.instancingMorph===!1&&H.morphTexture!==null||kt.envMap!==Dt||q.fog===!0&&kt.fog!==ut||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==ft.numPlanes||kt.numIntersection!==ft.numIntersection)||kt.vertexAlphas!==$t||kt.vertexTangents!==qt||kt.morphTargets!==It||kt.morphNormals!==ae||kt.morphColors!==Ee||kt.toneMapping!==Ae||kt.morphTargetsCount!==pe)&&(_e=!0):(_e=!0,kt.__version=q.version);let Nn=kt.currentProgram;_e===!0&&(Nn=Qs(q,O,H));let yi=!1,Mn=!1,ws=!1;const Le=Nn.getUniforms(),Qn=kt.uniforms;if(Vt.useProgram(Nn.program)&&(yi=!0,Mn=!0,ws=!0),q.id!==w&&(w=q.id,Mn=!0),yi||S!==E){Vt.buffers.depth.getReversed()?(ot.copy(E.projectionMatrix),Tx(ot),Ax(ot),Le.setValue(z,"projectionMatrix",ot)):Le.setValue(z,"projectionMatrix",E.projectionMatrix),Le.setValue(z,"viewMatrix",E.matrixWorldInverse);const bi=Le.map.cameraPosition;bi!==void 0&&bi.setValue(z,Ht.setFromMatrixPosition(E.matrixWorld)),ne.logarithmicDepthBuffer&&Le.setValue(z,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&Le.setValue(z,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,Mn=!0,ws=!0)}if(H.isSkinnedMesh){Le.setOptional(z,H,"bindMatrix"),Le.setOptional(z,H,"bindMatrixInverse");const wn=H.skeleton;wn&&(wn.boneTexture===null&&wn.computeBoneTexture(),Le.setValue(z,"boneTexture",wn.boneTexture,P))}H.isBatchedMesh&&(Le.setOptional(z,H,"batchingTexture"),Le.setValue(z,"batchingTexture",H._matricesTexture,P),Le.setOptional(z,H,"batchingIdTexture"),Le.setValue(z,"batchingIdTexture",H._indirectTexture,P),Le.setOptional(z,H,"batchingColorTexture"),H._colorsTexture!==null&&Le.setValue(z,"batchingColorTexture",H._colorsTexture,P));const is=X.morphAttributes;if((is.position!==void 0||is.normal!==void 0||is.color!==void 0)&&Ot.update(H,X,Nn),(Mn||kt.receiveShadow!==H.receiveShadow)&&(kt.receiveShadow=H.receiveShadow,Le.setValue(z,"receiveShadow",H.receiveShadow)),q.isMeshGouraudMaterial&&q.envMap!==null&&(Qn.envMap.value=Dt,Qn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),q.isMeshStandardMaterial&&q.envMap===null&&O.environment!==null&&(Qn.envMapIntensity.value=O.environmentIntensity),Mn&&(Le.setValue(z,"toneMappingExposure",x.toneMappingExposure),kt.needsLights&&Es(Qn,ws),ut&&q.fog===!0&&_t.refreshFogUniforms(Qn,ut),_t.refreshMaterialUniforms(Qn,q,tt,Q,p.state.transmissionRenderTarget[E.id]),za.upload(z,Oo(kt),Qn,P)),q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(za.upload(z,Oo(kt),Qn,P),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&Le.setValue(z,"center",H.center),Le.setValue(z,"modelViewMatrix",H.modelViewMatrix),Le.setValue(z,"normalMatrix",H.normalMatrix),Le.setValue(z,"modelMatrix",H.matrixWorld),q.isShaderMaterial||q.isRawShaderMaterial){const wn=q.uniformsGroups;for(let bi=0,ui=wn.length;bi<ui;bi++){const tr=wn[bi];k.update(tr,Nn),k.bind(tr,Nn)}}return Nn}function Es(E,O){E.ambientLightColor.needsUpdate=O,E.lightProbe.needsUpdate=O,E.directionalLights.needsUpdate=O,E.directionalLightShadows.needsUpdate=O,E.pointLights.needsUpdate=O,E.pointLightShadows.needsUpdate=O,E.spotLights.needsUpdate=O,E.spotLightShadows.needsUpdate=O,E.rectAreaLights.needsUpdate=O,E.hemisphereLights.needsUpdate=O}function ko(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return I},this.setRenderTargetTextures=function(E,O,X){Pt.get(E.texture).__webglTexture=O,Pt.get(E.depthTexture).__webglTexture=X;const q=Pt.get(E);q.__hasExternalTextures=!0,q.__autoAllocateDepthBuffer=X===void 0,q.__autoAllocateDepthBuffer||te.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),q.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(E,O){const X=Pt.get(E);X.__webglFramebuffer=O,X.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(E,O=0,X=0){I=E,A=O,D=X;let q=!0,H=null,ut=!1,yt=!1;if(E){const Dt=Pt.get(E);if(Dt.__useDefaultFramebuffer!==void 0)Vt.bindFramebuffer(z.FRAMEBUFFER,null),q=!1;else if(Dt.__webglFramebuffer===void 0)P.setupRenderTarget(E);else if(Dt.__hasExternalTextures)P.rebindTextures(E,Pt.get(E.texture).__webglTexture,Pt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){const It=E.depthTexture;if(Dt.__boundDepthTexture!==It){if(It!==null&&Pt.has(It)&&(E.width!==It.image.width||E.height!==It.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(E)}}const $t=E.texture;($t.isData3DTexture||$t.isDataArrayTexture||$t.isCompressedArrayTexture)&&(yt=!0);const qt=Pt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(qt[O])?H=qt[O][X]:H=qt[O],ut=!0):E.samples>0&&P.useMultisampledRTT(E)===!1?H=Pt.get(E).__webglMultisampledFramebuffer:Array.isArray(qt)?H=qt[X]:H=qt,C.copy(E.viewport),V.copy(E.scissor),N=E.scissorTest}else C.copy(mt).multiplyScalar(tt).floor(),V.copy(Mt).multiplyScalar(tt).floor(),N=pt;if(Vt.bindFramebuffer(z.FRAMEBUFFER,H)&&q&&Vt.drawBuffers(E,H),Vt.viewport(C),Vt.scissor(V),Vt.setScissorTest(N),ut){const Dt=Pt.get(E.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+O,Dt.__webglTexture,X)}else if(yt){const Dt=Pt.get(E.texture),$t=O||0;z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,Dt.__webglTexture,X||0,$t)}w=-1},this.readRenderTargetPixels=function(E,O,X,q,H,ut,yt){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){Vt.bindFramebuffer(z.FRAMEBUFFER,Ft);try{const Dt=E.texture,$t=Dt.format,qt=Dt.type;if(!ne.textureFormatReadable($t)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!ne.textureTypeReadable(qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=E.width-q&&X>=0&&X<=E.height-H&&z.readPixels(O,X,q,H,Yt.convert($t),Yt.convert(qt),ut)}finally{const Dt=I!==null?Pt.get(I).__webglFramebuffer:null;Vt.bindFramebuffer(z.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(E,O,X,q,H,ut,yt){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){const Dt=E.texture,$t=Dt.format,qt=Dt.type;if(!ne.textureFormatReadable($t))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!ne.textureTypeReadable(qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(O>=0&&O<=E.width-q&&X>=0&&X<=E.height-H){Vt.bindFramebuffer(z.FRAMEBUFFER,Ft);const It=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,It),z.bufferData(z.PIXEL_PACK_BUFFER,ut.byteLength,z.STREAM_READ),z.readPixels(O,X,q,H,Yt.convert($t),Yt.convert(qt),0);const ae=I!==null?Pt.get(I).__webglFramebuffer:null;Vt.bindFramebuffer(z.FRAMEBUFFER,ae);const Ee=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await wx(z,Ee,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,It),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,ut),z.deleteBuffer(It),z.deleteSync(Ee),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(E,O=null,X=0){E.isTexture!==!0&&(bo("WebGLRenderer: copyFramebufferToTexture function signature has changed."),O=arguments[0]||null,E=arguments[1]);const q=Math.pow(2,-X),H=Math.floor(E.image.width*q),ut=Math.floor(E.image.height*q),yt=O!==null?O.x:0,Ft=O!==null?O.y:0;P.setTexture2D(E,0),z.copyTexSubImage2D(z.TEXTURE_2D,X,0,0,yt,Ft,H,ut),Vt.unbindTexture()},this.copyTextureToTexture=function(E,O,X=null,q=null,H=0){E.isTexture!==!0&&(bo("WebGLRenderer: copyTextureToTexture function signature has changed."),q=arguments[0]||null,E=arguments[1],O=arguments[2],H=arguments[3]||0,X=null);let ut,yt,Ft,Dt,$t,qt,It,ae,Ee;const Ae=E.isCompressedTexture?E.mipmaps[H]:E.image;X!==null?(ut=X.max.x-X.min.x,yt=X.max.y-X.min.y,Ft=X.isBox3?X.max.z-X.min.z:1,Dt=X.min.x,$t=X.min.y,qt=X.isBox3?X.min.z:0):(ut=Ae.width,yt=Ae.height,Ft=Ae.depth||1,Dt=0,$t=0,qt=0),q!==null?(It=q.x,ae=q.y,Ee=q.z):(It=0,ae=0,Ee=0);const un=Yt.convert(O.format),pe=Yt.convert(O.type);let kt;O.isData3DTexture?(P.setTexture3D(O,0),kt=z.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(P.setTexture2DArray(O,0),kt=z.TEXTURE_2D_ARRAY):(P.setTexture2D(O,0),kt=z.TEXTURE_2D),z.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,O.flipY),z.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),z.pixelStorei(z.UNPACK_ALIGNMENT,O.unpackAlignment);const Ge=z.getParameter(z.UNPACK_ROW_LENGTH),_e=z.getParameter(z.UNPACK_IMAGE_HEIGHT),Nn=z.getParameter(z.UNPACK_SKIP_PIXELS),yi=z.getParameter(z.UNPACK_SKIP_ROWS),Mn=z.getParameter(z.UNPACK_SKIP_IMAGES);z.pixelStorei(z.UNPACK_ROW_LENGTH,Ae.width),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Ae.height),z.pixelStorei(z.UNPACK_SKIP_PIXELS,Dt),z.pixelStorei(z.UNPACK_SKIP_ROWS,$t),z.pixelStorei(z.UNPACK_SKIP_IMAGES,qt);const ws=E.isDataArrayTexture||E.isData3DTexture,Le=O.isDataArrayTexture||O.isData3DTexture;if(E.isRenderTargetTexture||E.isDepthTexture){const Qn=Pt.get(E),is=Pt.get(O),wn=Pt.get(Qn.__renderTarget),bi=Pt.get(is.__renderTarget);Vt.bindFramebuffer(z.READ_FRAMEBUFFER,wn.__webglFramebuffer),Vt.bindFramebuffer(z.DRAW_FRAMEBUFFER,bi.__webglFramebuffer);for(let ui=0;ui<Ft;ui++)ws&&z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Pt.get(E).__webglTexture,H,qt+ui),E.isDepthTexture?(Le&&z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Pt.get(O).__webglTexture,H,Ee+ui),z.blitFramebuffer(Dt,$t,ut,yt,It,ae,ut,yt,z.DEPTH_BUFFER_BIT,z.NEAREST)):Le?z.copyTexSubImage3D(kt,H,It,ae,Ee+ui,Dt,$t,ut,yt):z.copyTexSubImage2D(kt,H,It,ae,Ee+ui,Dt,$t,ut,yt);Vt.bindFramebuffer(z.READ_FRAMEBUFFER,null),Vt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else Le?E.isDataTexture||E.isData3DTexture?z.texSubImage3D(kt,H,It,ae,Ee,ut,yt,Ft,un,pe,Ae.data):O.isCompressedArrayTexture?z.compressedTexSubImage3D(kt,H,It,ae,Ee,ut,yt,Ft,un,Ae.data):z.texSubImage3D(kt,H,It,ae,Ee,ut,yt,Ft,un,pe,Ae):E.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,H,It,ae,ut,yt,un,pe,Ae.data):E.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,H,It,ae,Ae.width,Ae.height,un,Ae.data):z.texSubImage2D(z.TEXTURE_2D,H,It,ae,ut,yt,un,pe,Ae);z.pixelStorei(z.UNPACK_ROW_LENGTH,Ge),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,_e),z.pixelStorei(z.UNPACK_SKIP_PIXELS,Nn),z.pixelStorei(z.UNPACK_SKIP_ROWS,yi),z.pixelStorei(z.UNPACK_SKIP_IMAGES,Mn),H===0&&O.generateMipmaps&&z.generateMipmap(kt),Vt.unbindTexture()},this.copyTextureToTexture3D=function(E,O,X=null,q=null,H=0){return E.isTexture!==!0&&(bo("WebGLRenderer: copyTextureToTexture3D function signature has changed."),X=arguments[0]||null,q=arguments[1]||null,E=arguments[2],O=arguments[3],H=arguments[4]||0),bo('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(E,O,X,q,H)},this.initRenderTarget=function(E){Pt.get(E).__webglFramebuffer===void 0&&P.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?P.setTextureCube(E,0):E.isData3DTexture?P.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?P.setTexture2DArray(E,0):P.setTexture2D(E,0),Vt.unbindTexture()},this.resetState=function(){A=0,D=0,I=null,Vt.reset(),ge.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Zi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}}let Od=class extends sn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Bi,this.environmentIntensity=1,this.environmentRotation=new Bi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};class Fo extends Js{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new ce(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const Ya=new B,ja=new B,kd=new Ne,xo=new uh,va=new No,pc=new B,Bd=new B;class Wm extends sn{constructor(t=new ln,e=new Fo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ya.fromBufferAttribute(e,s-1),ja.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ya.distanceTo(ja);t.setAttribute("lineDistance",new He(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),va.copy(i.boundingSphere),va.applyMatrix4(s),va.radius+=r,t.ray.intersectsSphere(va)===!1)return;kd.copy(s).invert(),xo.copy(t.ray).applyMatrix4(kd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){const d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=u.getX(v),y=u.getX(v+1),T=xa(this,t,xo,l,p,y);T&&e.push(T)}if(this.isLineLoop){const v=u.getX(g-1),m=u.getX(d),p=xa(this,t,xo,l,v,m);p&&e.push(p)}}else{const d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=xa(this,t,xo,l,v,v+1);p&&e.push(p)}if(this.isLineLoop){const v=xa(this,t,xo,l,g-1,d);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function xa(n,t,e,i,s,r){const o=n.geometry.attributes.position;if(Ya.fromBufferAttribute(o,s),ja.fromBufferAttribute(o,r),e.distanceSqToSegment(Ya,ja,pc,Bd)>i)return;pc.applyMatrix4(n.matrixWorld);const l=t.ray.origin.distanceTo(pc);if(!(l<t.near||l>t.far))return{distance:l,point:Bd.clone().applyMatrix4(n.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:n}}const zd=new B,Hd=new B;class $m extends Wm{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)zd.fromBufferAttribute(e,s),Hd.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+zd.distanceTo(Hd);t.setAttribute("lineDistance",new He(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class Xm extends Js{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new ce(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const Vd=new Ne,wu=new uh,Ma=new No,Sa=new B;class OE extends sn{constructor(t=new ln,e=new Xm){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ma.copy(i.boundingSphere),Ma.applyMatrix4(s),Ma.radius+=r,t.ray.intersectsSphere(Ma)===!1)return;Vd.copy(s).invert(),wu.copy(t.ray).applyMatrix4(Vd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){const f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,v=d;g<v;g++){const m=c.getX(g);Sa.fromBufferAttribute(h,m),Gd(Sa,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let g=f,v=d;g<v;g++)Sa.fromBufferAttribute(h,g),Gd(Sa,g,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Gd(n,t,e,i,s,r,o){const a=wu.distanceSqToPoint(n);if(a<e){const l=new B;wu.closestPointToPoint(n,l),l.applyMatrix4(i);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class ph extends ln{constructor(t=[new ue(0,-.5),new ue(.5,0),new ue(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Dn(s,0,Math.PI*2);const r=[],o=[],a=[],l=[],c=[],u=1/e,h=new B,f=new ue,d=new B,g=new B,v=new B;let m=0,p=0;for(let y=0;y<=t.length-1;y++)switch(y){case 0:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,v.copy(d),d.normalize(),l.push(d.x,d.y,d.z);break;case t.length-1:l.push(v.x,v.y,v.z);break;default:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,g.copy(d),d.x+=v.x,d.y+=v.y,d.z+=v.z,d.normalize(),l.push(d.x,d.y,d.z),v.copy(g)}for(let y=0;y<=e;y++){const T=i+y*u*s,x=Math.sin(T),U=Math.cos(T);for(let A=0;A<=t.length-1;A++){h.x=t[A].x*x,h.y=t[A].y,h.z=t[A].x*U,o.push(h.x,h.y,h.z),f.x=y/e,f.y=A/(t.length-1),a.push(f.x,f.y);const D=l[3*A+0]*x,I=l[3*A+1],w=l[3*A+0]*U;c.push(D,I,w)}}for(let y=0;y<e;y++)for(let T=0;T<t.length-1;T++){const x=T+y*t.length,U=x,A=x+t.length,D=x+t.length+1,I=x+1;r.push(U,A,I),r.push(D,I,A)}this.setIndex(r),this.setAttribute("position",new He(o,3)),this.setAttribute("uv",new He(a,2)),this.setAttribute("normal",new He(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ph(t.points,t.segments,t.phiStart,t.phiLength)}}class mh extends ln{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],f=[],d=[];let g=0;const v=[],m=i/2;let p=0;y(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new He(h,3)),this.setAttribute("normal",new He(f,3)),this.setAttribute("uv",new He(d,2));function y(){const x=new B,U=new B;let A=0;const D=(e-t)/i;for(let I=0;I<=r;I++){const w=[],S=I/r,C=S*(e-t)+t;for(let V=0;V<=s;V++){const N=V/s,G=N*l+a,Z=Math.sin(G),K=Math.cos(G);U.x=C*Z,U.y=-S*i+m,U.z=C*K,h.push(U.x,U.y,U.z),x.set(Z,D,K).normalize(),f.push(x.x,x.y,x.z),d.push(N,1-S),w.push(g++)}v.push(w)}for(let I=0;I<s;I++)for(let w=0;w<r;w++){const S=v[w][I],C=v[w+1][I],V=v[w+1][I+1],N=v[w][I+1];(t>0||w!==0)&&(u.push(S,C,N),A+=3),(e>0||w!==r-1)&&(u.push(C,V,N),A+=3)}c.addGroup(p,A,0),p+=A}function T(x){const U=g,A=new ue,D=new B;let I=0;const w=x===!0?t:e,S=x===!0?1:-1;for(let V=1;V<=s;V++)h.push(0,m*S,0),f.push(0,S,0),d.push(.5,.5),g++;const C=g;for(let V=0;V<=s;V++){const G=V/s*l+a,Z=Math.cos(G),K=Math.sin(G);D.x=w*K,D.y=m*S,D.z=w*Z,h.push(D.x,D.y,D.z),f.push(0,S,0),A.x=Z*.5+.5,A.y=K*.5*S+.5,d.push(A.x,A.y),g++}for(let V=0;V<s;V++){const N=U+V,G=C+V;x===!0?u.push(G,G+1,N):u.push(G+1,G,N),I+=3}c.addGroup(p,I,x===!0?1:2),p+=I}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new mh(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}const ya=new B,ba=new B,mc=new B,Ea=new ai;class qm extends ln{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){const s=Math.pow(10,4),r=Math.cos(Ba*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);const{a:v,b:m,c:p}=Ea;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),Ea.getNormal(mc),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){const T=(y+1)%3,x=h[y],U=h[T],A=Ea[u[y]],D=Ea[u[T]],I=`${x}_${U}`,w=`${U}_${x}`;w in f&&f[w]?(mc.dot(f[w].normal)<=r&&(d.push(A.x,A.y,A.z),d.push(D.x,D.y,D.z)),f[w]=null):I in f||(f[I]={index0:c[y],index1:c[T],normal:mc.clone()})}}for(const g in f)if(f[g]){const{index0:v,index1:m}=f[g];ya.fromBufferAttribute(a,v),ba.fromBufferAttribute(a,m),d.push(ya.x,ya.y,ya.z),d.push(ba.x,ba.y,ba.z)}this.setAttribute("position",new He(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}}class _l extends ln{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const u=[],h=new B,f=new B,d=[],g=[],v=[],m=[];for(let p=0;p<=i;p++){const y=[],T=p/i;let x=0;p===0&&o===0?x=.5/e:p===i&&l===Math.PI&&(x=-.5/e);for(let U=0;U<=e;U++){const A=U/e;h.x=-t*Math.cos(s+A*r)*Math.sin(o+T*a),h.y=t*Math.cos(o+T*a),h.z=t*Math.sin(s+A*r)*Math.sin(o+T*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),m.push(A+x,1-T),y.push(c++)}u.push(y)}for(let p=0;p<i;p++)for(let y=0;y<e;y++){const T=u[p][y+1],x=u[p][y],U=u[p+1][y],A=u[p+1][y+1];(p!==0||o>0)&&d.push(T,x,A),(p!==i-1||l<Math.PI)&&d.push(x,U,A)}this.setIndex(d),this.setAttribute("position",new He(g,3)),this.setAttribute("normal",new He(v,3)),this.setAttribute("uv",new He(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new _l(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}}class gh extends ln{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new B,h=new B,f=new B;for(let d=0;d<=i;d++)for(let g=0;g<=s;g++){const v=g/s*r,m=d/i*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(d/i)}for(let d=1;d<=i;d++)for(let g=1;g<=s;g++){const v=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,y=(s+1)*d+g;o.push(v,m,y),o.push(m,p,y)}this.setIndex(o),this.setAttribute("position",new He(a,3)),this.setAttribute("normal",new He(l,3)),this.setAttribute("uv",new He(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new gh(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class kE extends Js{static get type(){return"MeshLambertMaterial"}constructor(t){super(),this.isMeshLambertMaterial=!0,this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Tm,this.normalScale=new ue(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bi,this.combine=ih,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class Ym extends Fo{static get type(){return"LineDashedMaterial"}constructor(t){super(),this.isLineDashedMaterial=!0,this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}}class jm extends sn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ce(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class BE extends jm{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(sn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ce(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const gc=new Ne,Wd=new B,$d=new B;class zE{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ue(512,512),this.map=null,this.mapPass=null,this.matrix=new Ne,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new hh,this._frameExtents=new ue(1,1),this._viewportCount=1,this._viewports=[new $e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,i=this.matrix;Wd.setFromMatrixPosition(t.matrixWorld),e.position.copy(Wd),$d.setFromMatrixPosition(t.target.matrixWorld),e.lookAt($d),e.updateMatrixWorld(),gc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(gc),i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(gc)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class HE extends zE{constructor(){super(new fh(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class VE extends jm{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(sn.DEFAULT_UP),this.updateMatrix(),this.target=new sn,this.shadow=new HE}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:nh}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=nh);function Ka(n,t=!1){const e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new ln;let c=0;for(let u=0;u<n.length;++u){const h=n[u];let f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(const d in h.attributes){if(!i.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+d+'" attribute exists among all geometries, or in none of them.'),null;r[d]===void 0&&(r[d]=[]),r[d].push(h.attributes[d]),f++}if(f!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(const d in h.morphAttributes){if(!s.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;o[d]===void 0&&(o[d]=[]),o[d].push(h.morphAttributes[d])}if(t){let d;if(e)d=h.index.count;else if(h.attributes.position!==void 0)d=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,d,u),c+=d}}if(e){let u=0;const h=[];for(let f=0;f<n.length;++f){const d=n[f].index;for(let g=0;g<d.count;++g)h.push(d.getX(g)+u);u+=n[f].attributes.position.count}l.setIndex(h)}for(const u in r){const h=Xd(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(const u in o){const h=o[u][0].length;if(h===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let f=0;f<h;++f){const d=[];for(let v=0;v<o[u].length;++v)d.push(o[u][v][f]);const g=Xd(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(g)}}return l}function Xd(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){const u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}const o=new t(r),a=new zn(o,e,i);let l=0;for(let c=0;c<n.length;++c){const u=n[c];if(u.isInterleavedBufferAttribute){const h=l/e;for(let f=0,d=u.count;f<d;f++)for(let g=0;g<e;g++){const v=u.getComponent(f,g);a.setComponent(f+h,g,v)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}const GE={...Wt,limit:"#6f8aa5"},Ys=n=>GE[n],Km={x:new B(1,0,0),y:new B(0,1,0),z:new B(0,0,1)},Oi=n=>Qa?Math.ceil(n/2):n,WE=n=>new B(...Do[n]),Zm=(n,t)=>new ns().setFromUnitVectors(Km[n],WE(t));function _c(n,{colour:t,centre_m:e,along:i},s){n.deleteAttribute("uv");const r=new ce(t),o=new Float32Array(n.attributes.position.count*3);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return n.setAttribute("color",new zn(o,3)),i&&n.applyQuaternion(Zm(s,i)),n.translate(...e)}const $E={box:n=>_c(new no(...n.size_m),n),cylinder:n=>_c(new mh(n.radius_m,n.other_radius_m??n.radius_m,n.length_m,Oi(32)),n,"y"),torus:n=>_c(new gh(n.radius_m,n.thickness_m,Oi(8),Oi(72)),n,"z")},Tu=n=>n.map(t=>$E[t.kind](t));function XE(n){const t=new Ui,e=n.role==="predicted"||n.role==="truth";t.inner=e?YE(n):qE(n),t.add(t.inner);const{min:i,max:s}=new to().setFromObject(t.inner);return t.reach="xyz".split("").map(r=>Math.max(-i[r],s[r])),t}function qE({shape:n}){const t=new Ui,e=n.filter(s=>s.lit),i=n.filter(s=>!s.lit);return e.length&&(t.lit=new kE({vertexColors:!0}),t.add(new bn(Ka(Tu(e)),t.lit))),i.length&&t.add(new bn(Ka(Tu(i)),new eo({vertexColors:!0}))),t}function YE({role:n,shape:t}){const e=Tu(t),i=Ys(n),s=new bn(Ka(e),new eo({color:i,transparent:!0,opacity:.16,depthWrite:!1}));return s.add(new $m(Ka(e.map(r=>new qm(r,40))),new Fo({color:i,transparent:!0,opacity:.75}))),s}function Au(n,t){const e=Oi(64);return Array.from({length:e+1},(i,s)=>{const r=s/e*2*Math.PI;return new B(n,t*Math.cos(r),t*Math.sin(r))})}function qd(n,t,e){return Array.from({length:e},(i,s)=>{const r=s/e*2*Math.PI;return n.map((o,a)=>new B(o,t[a]*Math.cos(r),t[a]*Math.sin(r)))})}function Ru(n,t){const[e,i]=[[],[]];for(const r of n){let o=0;for(let a=1;a<r.length;a+=1)e.push(r[a-1],r[a]),i.push(o,o+=r[a].distanceTo(r[a-1]))}const s=new ln().setFromPoints(e);return s.setAttribute("lineDistance",new He(i,1)),new $m(s,t)}const _h=(n,t)=>new eo({color:Ys(n),transparent:!0,opacity:t,side:Pi,forceSinglePass:!0,depthWrite:!1}),Cu=(n,t)=>new Fo({color:Ys(n),transparent:!0,opacity:t});function jE(n){const{stations_m:t,radii_m:e}=n,i=new Ui;if(n.skin){const a=new bn(new ph(t.map((l,c)=>new ue(e[c],l)),Oi(48)),_h(n.role,.05));a.rotation.z=-Math.PI/2,i.add(a)}const s=[...qd(t,e,n.meridians),...n.rings.map(([a,l])=>Au(a,l))],r=[...qd(t,e,n.faint_meridians),...n.faint_rings.map(([a,l])=>Au(a,l))];n.axis&&r.push([t[0],t[t.length-1]].map(a=>new B(a,0,0)));const o=()=>new Ym({color:Ys(n.role),dashSize:.35,gapSize:.22,transparent:!0,opacity:.85});return s.length&&i.add(Ru(s,n.dashed?o():Cu(n.role,.8))),r.length&&i.add(Ru(r,Cu(n.role,.38))),i.quaternion.copy(Zm("x",n.along)),i.position.set(...n.origin_m),i}function KE({role:n,radius_m:t}){const e=new Ui,i=([r,o,a])=>[new B(r,o,a),new B(o,r,a),new B(a,o,r)],s=Au(0,t).map(r=>i(r.toArray()));return e.add(new bn(new _l(t,Oi(32),Oi(20)),_h(n,.1)),Ru([0,1,2].map(r=>s.map(o=>o[r])),Cu(n,.7))),e}const ZE=n=>n.kind==="sphere"?KE(n):jE(n);function JE(){const n=[];let t=7;const e=()=>(t=t*16807%2147483647,t/2147483647);for(let s=0;s<Oi(1400);s+=1){const r=2*e()-1,o=2*Math.PI*e(),a=Math.sqrt(1-r*r);n.push(900*a*Math.cos(o),900*r,900*a*Math.sin(o))}const i=new ln;return i.setAttribute("position",new He(n,3)),new OE(i,new Xm({color:9413562,size:1.3,sizeAttenuation:!1,transparent:!0,opacity:.7}))}function QE({direction:n,half_angle_rad:t,colour:e}){const i=new B(...n).normalize(),s=Math.PI/2-t,r=new _l(500*Math.sin(t),Oi(96),Oi(16),0,2*Math.PI,0,1.05*s);r.applyQuaternion(new ns().setFromUnitVectors(Km.y,i.clone().negate()));const o=r.attributes.position,a=new ce().setStyle(e,Zs),l=[],c=new B;for(let h=0;h<o.count;h+=1){c.fromBufferAttribute(o,h).normalize();const f=Math.sin(23*c.x+5*Math.sin(17*c.z))*Math.sin(19*c.z+4*Math.sin(13*c.x)),g=Math.max(.15,c.x*-.35+c.y*.75+c.z*.35)*(.124+.024*f);l.push(g*a.r,g*a.g,g*a.b)}r.setAttribute("color",new He(l,3));const u=new bn(r,new eo({vertexColors:!0}));return u.position.copy(i).multiplyScalar(500),u}function tw(n){const t=new Ui;n.stars&&t.add(JE());for(const e of n.sky)t.add(QE(e));return t}class ew{constructor(t,e=24,i=10){this.stations=e,this.sides=i,this.places=new Float32Array(e*i*3);const s=[];for(let o=0;o<e-1;o+=1)for(let a=0;a<i;a+=1){const l=o*i+a,c=o*i+(a+1)%i;s.push(l,c,l+i,c,c+i,l+i)}const r=new ln;r.setAttribute("position",new zn(this.places,3)),r.setIndex(s),this.mesh=new bn(r,_h(t,.22)),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set({rows:t,at:e,n:i}){if(this.mesh.visible=i>1,!!this.mesh.visible){for(let s=0;s<this.stations;s+=1){const r=s/(this.stations-1)*(i-1),o=Math.min(Math.floor(r),i-2),a=r-o,l=u=>t[o][e+u]+(t[o+1][e+u]-t[o][e+u])*a,c=l(3);for(let u=0;u<this.sides;u+=1){const h=u/this.sides*2*Math.PI,f=(s*this.sides+u)*3;this.places[f]=l(0),this.places[f+1]=l(1)+c*Math.cos(h),this.places[f+2]=l(2)+c*Math.sin(h)}}this.mesh.geometry.attributes.position.needsUpdate=!0}}}class nw{constructor(t,e,i){this.most=e,this.places=new Float32Array(e*3);const s=new ln;s.setAttribute("position",new zn(this.places,3));const r=i?new Ym({color:Ys(t),dashSize:.25,gapSize:.2}):new Fo({color:Ys(t)});this.dashed=i,this.line=new Wm(s,r),this.line.frustumCulled=!1,this.line.visible=!1}set({rows:t,at:e,n:i}){const s=i>0?t[i-1]:null;if(t===this.rows&&i===this.count&&s===this.last)return;Object.assign(this,{rows:t,count:i,last:s});const r=Math.max(1,Math.ceil(i/this.most));let o=0;for(let a=0;a<i&&o<this.most;a+=r,o+=1){const l=t[a];this.places[o*3]=l[e],this.places[o*3+1]=l[e+1],this.places[o*3+2]=l[e+2]}this.line.geometry.setDrawRange(0,o),this.line.geometry.attributes.position.needsUpdate=!0,this.dashed&&this.line.computeLineDistances(),this.line.visible=o>1}}const iw=.5,sw=25,rw=[5,4],vc=new WeakMap,[xc,Ar,Rr]=[new Ne,new $e,new $e];function ow(n){return vc.has(n)||vc.set(n,new qm(n,sw)),vc.get(n)}class Yd{constructor(t){Object.assign(this,{canvas:t,pen:t.getContext("2d",{willReadFrequently:!0}),ratio:1,cut:!1,colour:"#000"}),this.at={left:0,top:0,width:0,height:0}}setPixelRatio(t){this.ratio=t}setSize(t,e){this.size={width:t,height:e},this.canvas.width=Math.max(1,Math.round(t*this.ratio)),this.canvas.height=Math.max(1,Math.round(e*this.ratio))}setScissorTest(t){this.cut=t}setScissor(){}setViewport(t,e,i,s){this.at={left:t,top:this.size.height-e-s,width:i,height:s}}setClearColor(t){this.colour=`#${t.toString(16).padStart(6,"0")}`}clear(){const{left:t,top:e,width:i,height:s}=this.cut?this.at:{left:0,top:0,...this.size};this.pen.setTransform(this.ratio,0,0,this.ratio,0,0),this.pen.fillStyle=this.colour,this.pen.fillRect(t,e,i,s)}clearDepth(){}dispose(){}render(t,e){const{pen:i,at:s}=this;t.updateMatrixWorld(),e.updateMatrixWorld(),i.save(),i.beginPath(),i.rect(s.left,s.top,s.width,s.height),i.clip();const r=new Ne().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);t.traverseVisible(o=>{o.layers.test(e.layers)&&(o.isLine?this.lines(o,o.geometry,o.isLineSegments?2:1,r,`#${o.material.color.getHexString()}`):o.isMesh&&o.material.opacity>iw&&this.lines(o,ow(o.geometry),2,r,Wt.plain))}),i.restore()}lines({matrixWorld:t,material:e},i,s,r,o){const{pen:a}=this,{position:l}=i.attributes,c=Math.min(l.count,i.drawRange.count);xc.multiplyMatrices(r,t),a.strokeStyle=o,a.globalAlpha=e.transparent?e.opacity:1,a.lineWidth=1,a.setLineDash(e.isLineDashedMaterial?rw:[]),a.beginPath();for(let u=0;u+1<c;u+=s)Ar.fromBufferAttribute(l,u).setW(1).applyMatrix4(xc),Rr.fromBufferAttribute(l,u+1).setW(1).applyMatrix4(xc),aw()&&(a.moveTo(...this.place(Ar)),a.lineTo(...this.place(Rr)));a.stroke(),a.globalAlpha=1}place(t){const{left:e,top:i,width:s,height:r}=this.at;return[e+(t.x/t.w+1)/2*s,i+(1-t.y/t.w)/2*r]}pixels(){return this.pen.getImageData(0,0,this.canvas.width,this.canvas.height).data}}function aw(){const[n,t]=[Ar.z+Ar.w,Rr.z+Rr.w];return n<=0&&t<=0?!1:(n<=0?Ar.lerp(Rr,(1e-6-n)/(t-n)):t<=0&&Rr.lerp(Ar,(1e-6-t)/(n-t)),!0)}const wa=1,lw=22e5,[cw,uw,jd]=[60,38,.35],Mc=Qa?.5:1,hw=1e3,Kd=24,fw=64,[dw,pw]=[860723,3159354],Ta=n=>new B(...Do[n]);class mw{constructor(t,e,i,s){this.elements={view:e,camera:i,labels:s},this.canvas=t;const r={antialias:!Qa,alpha:!1,powerPreference:"high-performance",preserveDrawingBuffer:!0},o=t.getContext("webgl2",r);this.webgl=o!==null,this.webgl?(this.renderer=new FE({canvas:t,context:o,...r}),this.renderer.autoClear=!1,t.addEventListener("webglcontextlost",()=>this.outline())):this.renderer=new Yd(t),this.scene=new Od,this.scene.add(new BE(14674431,2763306,.9));const a=new VE(16777215,2.3);a.position.set(-6,9,5),this.scene.add(a),this.far=new Od,this.perspective=new Yn(32,1,.1,2e3),this.ortho=new fh(-1,1,1,-1,-100,200),this.onboard=new Yn(20,1,.02,2e3);for(const c of[this.perspective,this.ortho])c.layers.enable(wa);Object.assign(this,{display:null,world:null,items:new Map,bodies:[],eyes:[],chosen:0}),Object.assign(this,{enabled:!0,drawn:0,quality:Mc,adaptive:!0,pace:33,since:0}),this.marks=new Map,this.follow(e),this.resize();const l=new ResizeObserver(()=>this.resize());for(const c of[e,i])l.observe(c);addEventListener("resize",()=>this.resize())}outline(){const t=this.canvas.cloneNode(!1);this.canvas.replaceWith(t),this.renderer.dispose(),Object.assign(this,{canvas:t,webgl:!1,renderer:new Yd(t)}),this.resize()}adapt(t){if(!this.adaptive)return;this.pace=this.pace*.8+Math.min(t,400)*.2,this.since+=1;const e=this.pace>cw&&this.quality>jd,i=this.pace<uw&&this.quality<Mc;this.since<(i?150:6)||!(e||i)||(this.quality=Math.max(jd,Math.min(Mc,this.quality*(e?.7:1.25))),this.since=0,this.resize())}setDisplay(t){for(const e of[this.world,...this.far.children])_w(e);this.far.clear(),this.far.add(tw(t)),this.world=new Ui,this.scene.add(this.world),this.items.clear(),this.bodies=t.bodies.map(e=>this.add(e,XE(e),!Array.isArray(e.place))),this.moving=this.bodies.filter(({moves:e})=>e);for(const e of t.surfaces){const i=this.add(e,ZE(e),e.kind==="sphere"&&!Array.isArray(e.place));i.moves?this.moving.push(i):e.kind==="sphere"&&i.object.position.set(...e.place)}this.lines=t.lines.map(e=>this.addLine(e)),this.eyes=t.views.map(e=>({azimuth:e.azimuth_rad,height:e.height_rad,zoom:1,focus:e.kind==="perspective"?new B(...Zd(e,null)):null})),(this.display===null||this.chosen>=t.views.length)&&(this.chosen=0),this.display=t,this.frame=null,this.shot=[]}add(t,e,i){const s={item:t,object:e,moves:i};return i?(e.visible=!1,e.traverse(r=>r.layers.set(wa))):t.kind==="body"&&e.position.set(...t.place),this.items.set(t.name,e),this.world.add(e),s}addLine(t){const e=Array.isArray(t.points),i=e?t.points.length:t.kind==="line"?fw:t.since?Kd+3:hw,s=new nw(t.role,i,t.dashed);e?s.set({rows:t.points,at:0,n:i}):s.line.layers.set(wa),this.items.set(t.name,s.line),this.world.add(s.line);const r=t.spread?new ew(t.role):null;return r&&(r.mesh.layers.set(wa),this.world.add(r.mesh)),{line:t,path:s,tube:r,stands:e}}place(t,e,i,s){this.frame=t;for(const{item:r,object:o}of this.moving){const a=Fi(t,r.place,r.axes);o.visible=!!a,a&&o.position.set(...a);const l=a&&r.attitude?li(t,r.attitude):void 0;l&&o.inner.quaternion.set(...l),r.role==="measured"&&o.inner?.lit&&o.inner.lit.emissive.setHex(s?pw:dw)}for(const{line:r,path:o,tube:a,stands:l}of this.lines)if(!l)if(r.kind==="line"){const c=li(t,r.points)||[];o.set({rows:c,at:0,n:c.length})}else{const c=zg(r,e?.trails.get(r.name)||[],t,i,Kd);o.set(c),a?.set(c)}}known(t){for(const e of t){const{item:i}=this.bodies.find(r=>r.item.name===e),s=Fi(this.frame,i.place,i.axes);if(s)return{item:i,at:s,turn:i.attitude?li(this.frame,i.attitude):void 0}}return null}resize(){const t=[this.elements.view,this.elements.camera].map(u=>u.getBoundingClientRect()),e=t.filter(u=>u.width>0),i=Math.min(...e.map(u=>u.left)),s=Math.min(...e.map(u=>u.top)),r=Math.max(...e.map(u=>u.right))-i,o=Math.max(...e.map(u=>u.bottom))-s,a=u=>({left:u.left-i,bottom:s+o-u.bottom,width:u.width,height:u.height});this.places={view:a(t[0]),camera:a(t[1])};const{canvas:l}=this;Object.assign(l.style,{left:`${i}px`,top:`${s}px`,width:`${r}px`,height:`${o}px`});const c=Math.min(devicePixelRatio||1,Math.sqrt(lw/Math.max(r*o,1)));this.renderer.setPixelRatio(c*this.quality),this.renderer.setSize(r,o,!1),this.renderer.setScissorTest(!1),this.renderer.setClearColor(527378,1),this.renderer.clear(),this.renderer.setScissorTest(!0),this.shot=[],this.tall=parseFloat(getComputedStyle(this.elements.labels).fontSize)}follow(t){let e=null;t.addEventListener("pointerdown",i=>{i.target.closest("button")||(e=[i.clientX,i.clientY],t.setPointerCapture(i.pointerId))}),t.addEventListener("pointermove",i=>{e&&(this.turn((i.clientX-e[0])*.005,(i.clientY-e[1])*.005),e=[i.clientX,i.clientY])}),t.addEventListener("pointerup",()=>{e=null}),t.addEventListener("wheel",i=>{i.preventDefault(),this.zoom(Math.exp(i.deltaY*.001))},{passive:!1})}turn(t,e){const i=this.eyes[this.chosen];i?.focus&&(i.azimuth+=t,i.height=Math.max(-1.4,Math.min(1.4,i.height+e)))}zoom(t){const e=this.eyes[this.chosen];e&&(e.zoom=Math.max(.15,Math.min(4,e.zoom*t)))}draw(){if(!this.enabled||!this.display)return;this.drawn+=1;const{view:t,camera:e}=this.places,i=this.display.views[this.chosen],s=i.kind==="flat";if(s)for(const{object:c}of this.bodies)c.scale.setComponent("xyz".indexOf(i.up[1]),1/i.stretch);const r=s?this.flat(i,t):this.orbit(i,t);if(this.into(t,r,!s),this.label(r,t,s?i:null),s)for(const{object:c}of this.bodies)c.scale.set(1,1,1);if(!this.display.camera||e.height<=20)return;const{at:o,turn:a}=gw(this.display.camera,this.known(this.display.camera.carried_by)),l=[...o,...a];l.some((c,u)=>c!==this.shot[u])&&(this.shot=l,this.aim(this.display.camera,o,a,e),this.into(e,this.onboard,!0))}orbit(t,e){const i=this.perspective,s=e.width/Math.max(e.height,1),r=this.eyes[this.chosen],{focus:o}=r;o.lerp(new B(...Zd(t,this.known(t.follow)?.at)),.08);const a=o.distanceTo(new B(...t.centre_m)),l=r.zoom*(t.distance_m+t.growth*a)*Math.max(1,1.45/s),c=Math.cos(r.height);return i.position.set(o.x+l*c*Math.cos(r.azimuth),o.y+l*Math.sin(r.height),o.z+l*c*Math.sin(r.azimuth)),i.lookAt(o),i.aspect=s,i.updateProjectionMatrix(),i}flat(t,e){const i=this.ortho,s=t.span_m/2*this.eyes[this.chosen].zoom,r=s/(e.width/Math.max(e.height,1))/t.stretch;Object.assign(i,{left:-s,right:s,top:r,bottom:-r});const o=new B(...t.centre_m);return i.up.copy(Ta(t.up)),i.position.copy(Ta(t.right)).cross(i.up).multiplyScalar(50).add(o),i.lookAt(o),i.updateProjectionMatrix(),i}aim(t,e,i,s){const r=this.onboard,o=new ns(...i);r.up.copy(Ta(t.up).applyQuaternion(o)),r.position.set(...e),r.lookAt(r.position.clone().add(Ta(t.look).applyQuaternion(o)));const a=Math.max(Li(t.look,t.aim_m)-Li(t.look,e),.4),[l,c]=t.half_field;this.cameraTan=Math.max(l,Math.min(c,t.half_height_m/a)),r.fov=2*Math.atan(this.cameraTan)*180/Math.PI,r.aspect=s.width/Math.max(s.height,1),r.updateProjectionMatrix(),r.updateMatrixWorld()}into(t,e,i){if(this.renderer.setViewport(t.left,t.bottom,t.width,t.height),this.renderer.setScissor(t.left,t.bottom,t.width,t.height),this.renderer.setClearColor(329740,1),this.renderer.clear(!0,!0),i){const s=e.position.clone();e.position.set(0,0,0),e.updateMatrixWorld(),this.renderer.render(this.far,e),e.position.copy(s),e.updateMatrixWorld(),this.renderer.clearDepth()}this.renderer.render(this.scene,e)}label(t,e,i){const s=i?i.up:"+y",r=i?i.stretch:1,o=new Map;for(const{text:l,at_m:c}of this.display.labels)o.set(l,{text:l,at:c,drop:1});for(const{item:l,object:c}of this.bodies){const u=l.label?Fi(this.frame,l.place,l.axes):void 0;if(!u)continue;const h=u.map((f,d)=>f+Do[s][d]*c.reach[d]/r);o.set(`body ${l.name}`,{text:l.label,at:h,role:l.role})}for(const[l,c]of this.marks)o.has(l)||(c.remove(),this.marks.delete(l));t.updateMatrixWorld();const a=[];for(const[l,{text:c,at:u,role:h,drop:f}]of o){let d=this.marks.get(l);d||(d=document.createElement("span"),d.textContent=c,h&&(d.className="body",d.style.color=Ys(h)),this.elements.labels.append(d),this.marks.set(l,d));const g=new B(u[0],u[1],u[2]).project(t),v=Math.abs(g.x)<.98&&Math.abs(g.y)<.96&&g.z<1;d.style.display=v?"":"none";const m=Math.round((g.x+1)/2*e.width);let p=Math.round((1-g.y)/2*e.height)+(f?14:0);if(h){const y=([T,x])=>Math.abs(T-m)<5*this.tall&&Math.abs(x-p)<this.tall;for(;a.some(y);)p-=2;a.push([m,p])}d.style.left=`${m}px`,d.style.top=`${p}px`}}onCamera(t){const e=new B(...t).project(this.onboard);return e.z>1?null:[e.x,e.y]}covers(t){const e=this.items.get(t),i=e.visible,s=[i,!1].map(o=>{if(e.visible=o,this.draw(),!this.webgl)return this.renderer.pixels();const a=this.renderer.getContext(),l=new Uint8Array(a.drawingBufferWidth*a.drawingBufferHeight*4);return a.readPixels(0,0,a.drawingBufferWidth,a.drawingBufferHeight,a.RGBA,a.UNSIGNED_BYTE,l),l});e.visible=i;let r=0;for(let o=0;o<s[0].length;o+=4)(s[0][o]!==s[1][o]||s[0][o+1]!==s[1][o+1])&&(r+=1);return r}}function gw(n,t){if(!t)return{at:n.start_m,turn:[0,0,0,1]};const e=n.turns&&t.turn||[0,0,0,1],i=new B(...n.at_m).applyQuaternion(new ns(...e));return{at:[t.at[0]+i.x,t.at[1]+i.y,t.at[2]+i.z],turn:e}}function _w(n){n?.traverse(t=>{t.geometry?.dispose(),t.material?.dispose()}),n?.removeFromParent()}function Zd(n,t){if(!n.follow.length)return n.centre_m;const e=t?Li(n.along,t)-Li(n.along,n.centre_m):n.start_m,i=n.share*Math.sign(n.start_m)*Math.max(n.least_m,e*Math.sign(n.start_m));return n.centre_m.map((s,r)=>s+i*Do[n.along][r])}function vw(n){return n.kind==="flat"&&n.stretch!==1?oe($.exaggerated,{axis:n.up[1],n:n.stretch}):""}const gn=n=>document.getElementById(n),xw=["section","lights","ladder","reticle","ball","dial"],Mw=["section-note","why","ladder-counts","link-counts","charts-note"],Sw=250;class yw{constructor(t,e){Object.assign(this,{scene:t,choose:e}),this.instruments=new Zg,this.commands=new e_,this.charts=new Nv,this.chartsAt=0,this.text=""}setDisplay(t){const e=JSON.stringify(t);if(e===this.text){this.scene.place(null,null,0,!1);return}this.text=e,this.display=t,this.instruments.setDisplay(t),this.commands.setDisplay(t),this.charts.setDisplay(t),Jg(t.section),Hg(t.attitude),$g(t.lamps);for(const i of["trip","ladder-panel"])gn(i).hidden=!t.link;gn("clock-rx").parentElement.hidden=!t.link,gn("camera").hidden=!t.camera,gn("clock-pred").parentElement.hidden=!t.predicted,t.camera&&(gn("camera").setAttribute("aria-label",t.camera.title),gn("camera-tag").textContent=t.camera.title),Gh(t,this.choose),gn("legend").replaceChildren(...t.legend.map(({role:i,words:s,dashed:r})=>{const o=document.createElement("span");return o.className=r?"dash":"",o.style.color=Wt[i],o.textContent=s,o})),this.scene.setDisplay(t),gn("views").replaceChildren(...t.views.map((i,s)=>{const r=document.createElement("button");return r.textContent=i.label,r.dataset.view=i.label.toLowerCase(),r.onclick=()=>this.setView(s),r})),gn("views").hidden=t.views.length<2,this.setView(this.scene.chosen)}blank(){if(this.display){for(const t of[this.instruments,this.commands,this.charts])t.setDisplay(this.display);Gh(this.display,this.choose),this.scene.place(null,null,0,!1);for(const t of xw)js(gn(t));for(const t of Mw)gn(t).textContent="";for(const t of["gen","rx","pred"])Xo(t,void 0,"",!1);Ao(void 0,gn("foot-words"))}}setView(t){this.scene.chosen=t,[...gn("views").children].forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),gn("scale").textContent=vw(this.display.views[t])}nextView(){this.display&&this.setView((this.scene.chosen+1)%this.display.views.length)}clocks(t,e,i,s,r){const o=jn(t,this.display.measured),a=jn(t,this.display.predicted);Xo("gen",o?.t,i,r),Xo("rx",o?.received,s,r),Xo("pred",a?.t,a?oe($.ahead,{s:Xe(a.t-e,1)}):"",r)}show({run:t,frame:e,rungs:i,history:s,now:r,stale:o,until:a}){const{display:l}=this,c=jn(e,l.measured);this.instruments.show(e,o),l.section&&Qg(l.section,e),l.attitude&&Vg(l.attitude,e),l.lamps&&Xg(l.lamps,e),this.commands.show(e),l.link&&this.showLink(t,e,c,i,r),this.scene.place(e,s,r,o),performance.now()-this.chartsAt>Sw&&(this.chartsAt=performance.now(),this.charts.show(s.charts,e,a))}showLink(t,e,i,s,r){n_(gn("dial"),t,e.round_trip,i?.transit),i_(e,i,t.step_s),v_(gn("ladder"),t,this.display.commands.axes,s,r),vn(gn("ladder-counts"),M_(s))}showReticle(t){this.display?.camera&&t&&s_(gn("reticle"),this.scene,this.display.camera,t)}}const ki=n=>document.getElementById(n),Aa=2,[Jd,Sc,bw]=[1280,66,4e6],[Ew,ww,Tw,Qd]=[250,150,3e3,1e3],Aw=["video/webm;codecs=vp8","video/webm;codecs=vp9","video/webm"],Rw=6e4,[Cw,Pw,Pu]=[15,25,1.5],tp=.3,Lw=16;function yc(n,t,e){const i=t instanceof Blob?t:new Blob([t],{type:e}),s=document.createElement("a");s.href=URL.createObjectURL(i),s.download=n,s.click(),setTimeout(()=>URL.revokeObjectURL(s.href),Rw)}const ep=n=>/[",\n]/.test(n)?`"${n.replaceAll('"','""')}"`:n,np=(n,t,e)=>`${[n,t==="plain"?"":t].filter(Boolean).join(" ")}${e?` [${e}]`:""}`;function Dw({display:n,frames:t}){const e=[];for(const a of n.instruments?.rows||[])for(const{role:l,value:c}of a.readings)e.push([np(a.label,l,a.unit),u=>ci(u,c)]);const{axes:i,rows:s,unit:r}=n.commands;for(const{label:a,value:l}of s)i.forEach((c,u)=>e.push([np(`${a} ${c.name}`,"",r),h=>h.signals[l.signal]?.parts[l.part]?.[u]]));const o=new Map;for(const a of t)for(const[l,c]of Object.entries(jn(a,"truth")?.parts||{}))!o.has(l)&&bc(c)&&o.set(l,bc(c).length);for(const[a,l]of o)for(let c=0;c<l;c+=1)e.push([`truth ${a}${l>1?` ${c}`:""}`,u=>bc(jn(u,"truth")?.parts[a])?.[c]]);return e}function bc(n){const t=Array.isArray(n)?n:[n];return t.length&&t.length<=Lw&&t.every(e=>typeof e=="number"||e===null)?t:void 0}function Iw(n){const t=Dw(n),e=s=>Number.isFinite(s)?String(Number(s.toFixed(6))):"",i=[[...Ig,...t.map(([s])=>s)].map(ep)];for(const s of n.frames)i.push([e(s.t),e(s.k),ep(s.mode||""),...t.map(([,r])=>e(r(s)))]);return`${i.map(s=>s.join(",")).join(`
`)}
`}function Jm(n){const t=p=>ki(p).getBoundingClientRect(),e=parseFloat(getComputedStyle(document.documentElement).fontSize),[i,s,r]=[t("view"),1.9*e,.5*e],o=[];let a=i.width;const[l,c,u,h]=["camera","section","ladder","instruments-rows"].map(t);if(l.width){const p=Math.min(l.width/l.height*i.height,i.width);o.push({draw:Uw,x:a+r,y:s,width:p,height:p*l.height/l.width}),a+=r+p}const[f,d]=[s+i.height+r,Math.max(Pu*e*ki("instruments-rows").children.length,Cw*e)];let g=0;const v=(p,y,T=d)=>{o.push({draw:p,x:g,y:f+(d-T)/2,width:y,height:T}),g+=y+2*r};c.width&&v(Nw,d),h.width&&v(kw,Math.min(Pw*e,a-g),Pu*e*ki("instruments-rows").children.length);const m=a-g;return u.width&&m>u.width/3&&v(Fw,Math.min(m,u.width),Math.min(m,u.width)*u.height/u.width),{rem:e,head:s,parts:o,view:i,panels:n,width:a,height:o.some(({y:p})=>p>s)?f+d+r:s+i.height}}function Lu(n,{rem:t,head:e,parts:i,view:s,panels:r,width:o},a){const l=n.getContext("2d"),c=n.width/o;l.setTransform(c,0,0,c,0,0),l.fillStyle="#080c12",l.fillRect(0,0,o,n.height/c),l.font=`600 ${.9*t}px system-ui, sans-serif`,l.fillStyle=Wt.text,l.textBaseline="middle",l.textAlign="left",l.fillText(a,.5*t,e/2,o-t),tg(l,r.scene,"view",{x:0,y:e,width:s.width,height:s.height}),Ow(l,s,e,t);for(const u of i)u.draw(l,u,t,r)}const Qm=(n,t,{x:e,y:i,width:s,height:r})=>n.drawImage(ki(t),e,i,s,r);function Uw(n,t,e,i){tg(n,i.scene,"camera",t),Qm(n,"reticle",t),n.font=`${.76*e}px system-ui, sans-serif`,ze(n,ki("camera-tag").textContent,t.x+.6*e,t.y+.9*e,Wt.measured)}function Nw(n,{x:t,y:e,width:i,height:s}){const r=ki("section"),o=Math.min(r.height,r.width*s/i),a=Math.min(r.width,r.height*i/s);n.drawImage(r,(r.width-a)/2,(r.height-o)/2,a,o,t,e,i,s)}const Fw=(n,t)=>Qm(n,"ladder",t);function tg(n,t,e,i){const{left:s,bottom:r,width:o,height:a}=t.places[e],{canvas:l}=t,c=l.width/parseFloat(l.style.width);o>0&&a>0&&n.drawImage(l,s*c,l.height-(r+a)*c,o*c,a*c,i.x,i.y,i.width,i.height)}function Ow(n,t,e,i){n.save(),n.beginPath(),n.rect(0,e,t.width,t.height),n.clip();for(const s of ki("labels").children){if(s.style.display==="none")continue;const r=s.className==="body";n.font=`${r?600:400} ${.72*i}px system-ui, sans-serif`,ze(n,s.textContent,parseFloat(s.style.left),e+parseFloat(s.style.top)-(r?1.15*i:0),s.style.color||"#93a7ba","center")}n.font=`${.76*i}px system-ui, sans-serif`;for(const s of ki("legend").children){const r=s.getBoundingClientRect(),[o,a]=[r.left-t.left,e+r.top-t.top+r.height/2];n.fillStyle=s.style.color;for(const[l,c]of s.className==="dash"?[[0,.22],[.36,.58],[.72,.9]]:[[0,.9]])n.fillRect(o+l*i,a-.1*i,(c-l)*i,.2*i);ze(n,s.textContent,o+1.25*i,a,s.style.color)}ze(n,ki("scale").textContent,t.width-.7*i,e+t.height-i,Wt.dim,"right"),n.restore()}function kw(n,{x:t,y:e,width:i},s){[...ki("instruments-rows").children].forEach((r,o)=>{const a=[...r.children],l=i*(1-tp)/Math.max(a.length-1,1);a.forEach((c,u)=>{n.font=`${c.tagName==="B"?600:400} ${.8*s}px system-ui, sans-serif`,ze(n,c.textContent,u?t+i*tp+l*u:t,e+Pu*s*(o+.5),getComputedStyle(c).color,u?"right":"left")})})}function Bw(n,t,e){const{scene:i}=n,{adaptive:s,quality:r}=i;Object.assign(i,{adaptive:!1,quality:Aa}),i.resize();const o=document.createElement("canvas");return Pg(Aa,()=>{e(),i.draw();const a=Jm(n);Object.assign(o,{width:Math.round(a.width*Aa),height:Math.round(a.height*Aa)}),Lu(o,a,t)}),Object.assign(i,{adaptive:s,quality:r}),i.resize(),e(),i.draw(),o}class Ur{static kind=Aw.find(t=>globalThis.MediaRecorder?.isTypeSupported(t));static get possible(){return Ur.kind!==void 0&&!!HTMLCanvasElement.prototype.captureStream}constructor(t,e,i,s){const r=Jm(t),o=document.createElement("canvas");Object.assign(o,{width:Jd,height:(c=>2*Math.round(c/2))(Jd*r.height/r.width)}),Object.assign(this,{parts:[],bytes:0,pictures:0,ending:1/0,done:s});const l=o.captureStream(1e3/Sc);Lu(o,r,e()),this.recorder=new MediaRecorder(l,{mimeType:Ur.kind,videoBitsPerSecond:bw}),this.recorder.ondataavailable=({data:c})=>{this.parts.push(c),this.bytes+=c.size},this.recorder.onerror=c=>{this.problem=c.error},this.recorder.onstop=()=>this.over(),this.recorder.start(Ew),this.timer=setInterval(()=>{this.ending===1/0&&!i(Sc)&&this.stop(),Lu(o,r,e()),this.pictures+=1;const c=performance.now()-this.ending;this.recorder.state!=="inactive"&&(c>Tw||c>ww&&this.bytes>Qd)&&this.recorder.stop()},Sc)}stop(){this.ending===1/0&&(this.ending=performance.now())}over(){clearInterval(this.timer);const t=this.problem??(this.bytes>Qd?void 0:new Error(Ug));this.done(new Blob(this.parts,{type:"video/webm"}),t)}}const zw=2e3,{escape:ms}=d_,Ra=n=>String(n).padStart(2,"0");let Nr=null,Ec=0;function Hw(n){if(!Number.isFinite(n))return $.unknown;const t=new Date(n*1e3);return`${t.getFullYear()}-${Ra(t.getMonth()+1)}-${Ra(t.getDate())} ${Ra(t.getHours())}:${Ra(t.getMinutes())}`}function Vw(n){il()||ys(`<h3 id="runs">${$.review_title}</h3><p class="dim">${$.review_truth}</p>
      <div id="runs-table"></div><p id="review-error" class="alarm" role="alert"></p>
      <div class="buttons">${Yr}</div>`,t=>{t.classList.add("wide"),t.onclose=()=>t.classList.remove("wide")}),ng(n),eg(n,document.getElementById("runs"))}async function eg(n,t){clearTimeout(Ec);const e=()=>t.isConnected&&il();try{const i=await n.link.get("api/runs"),s=JSON.stringify(i)===JSON.stringify(Nr);Nr=i,e()&&!s&&ng(n)}catch(i){if(!e())return;document.getElementById("review-error").textContent=i.message,Nr===null&&(document.getElementById("runs-table").textContent="")}clearTimeout(Ec),e()&&(Ec=setTimeout(()=>eg(n,t),zw))}function ng(n){const t=document.getElementById("runs-table"),e=document.activeElement?.dataset.run,i=Gw(n.store);if(Nr===null&&!i){t.innerHTML=`<p>${$.runs_loading}</p>`;return}const s=(Nr||[]).filter(l=>l.name!==i?.name),r=s.map((l,c)=>Ww(l,c,n.store.display));i&&r.unshift(`<tr class="dim"><td></td><td>${ms(i.name)}</td><td colspan="6">${ms(i.words)}</td><td></td></tr>`);const o=$.runs_columns.map(l=>`<th scope="col">${l}</th>`).join("");t.innerHTML=r.length?`<table class="runs"><tr>${o}<th></th></tr>${r.join("")}</table>`:`<p>${Nr===null?$.runs_loading:$.review_none}</p>`;const a=document.getElementById("review-error");for(const l of t.querySelectorAll("[data-run]"))l.onclick=()=>n.open(s[l.dataset.row],a);for(const l of t.querySelectorAll("[data-report]"))l.onclick=()=>n.report(l.dataset.report,a);e&&[...t.querySelectorAll("[data-run]")].find(l=>l.dataset.run===e)?.focus()}function Gw({status:n}){return!n.run||!["starting","flying","closing"].includes(n.phase)?null:{name:n.run,words:n.phase==="closing"?$.runs_closing:$.runs_flying}}function Ww(n,t,e){const i=o=>`<td>${ms(o??"")}</td>`,s=jr(String(n.reason??"").replaceAll("_"," ")),r=n.report?`title="${ms(oe($.runs_report,{name:n.name}))}"`:`disabled title="${$.runs_no_report}"`;return`<tr>${i(Hw(n.ended))}${i(n.name)}${i(n.scenario)}${i(n.mode?tl(e,n.mode):"")}
    ${i(n.operator)}${i(n.seed)}<td class="num">${Xe(n.duration_s,1)} s</td>
    <td class="${n.success===!0?"ok":""}">${n.success===!0?"✓":"✗"} ${ms(s)}</td>
    <td class="acts"><button data-run="${ms(n.name)}" data-row="${t}" title="${ms(oe($.runs_open,{name:n.name}))}">${$.review_open}</button>
    <button data-report="${ms(n.name)}" ${r}>${$.review_report}</button></td></tr>`}const Kt=n=>document.getElementById(n),Ca=[.25,.5,1,2,4,8,16],ip=4,$w=5,Xw=new Set(["KeyM","KeyP","KeyT"]);class qw{constructor(t,e,i,s){Object.assign(this,{link:t,panels:e,store:i,back:s,on:!1,run:null,at:0,playing:!1,speed:ip,film:null});const r={"review-close":()=>this.leave(),"review-play":()=>this.play(!this.playing),"review-step-back":()=>this.step(-1),"review-step-on":()=>this.step(1),"review-event-back":()=>this.jump(-1),"review-event-on":()=>this.jump(1),"review-report":()=>this.report(this.run.name,Kt("review-now")),"review-png":()=>this.saveFigure(),"review-csv":()=>yc(`${this.file()}.csv`,Iw(this.run),"text/csv"),"review-webm":()=>this.record()};for(const[o,a]of Object.entries(r))Kt(o).onclick=a;for(const o of["report","png","csv","webm"])Kt(`review-${o}`).title=$[`review_${o}_hint`];Kt("review-webm").disabled=!Ur.possible,Ur.possible||(Kt("review-webm").title=$.review_webm_none),Kt("review-time").oninput=()=>this.seek(Number(Kt("review-time").value)),Kt("review-speed").replaceChildren(...Ca.map(o=>new Option(oe($.review_times,{n:o}),o))),Kt("review-speed").value=ip,Kt("review-speed").onchange=()=>{this.setSpeed(Number(Kt("review-speed").value)),Kt("review-time").focus()},Kt("review-events").onchange=()=>{this.toEvent(this.run.events[Number(Kt("review-events").value)]),Kt("review-events").value="",Kt("review-time").focus()},addEventListener("keydown",o=>this.key(o),!0)}list(){Vw(this)}async open(t,e){e.textContent=$.review_loading;try{this.run=await this.link.get(`api/runs/${sp(t.name)}`)}catch(i){e.textContent=i.message;return}this.row=t,el(),this.on&&this.end(),this.start()}async report(t,e){const i=window.open("","_blank");if(!i){e.textContent=$.review_no_tab;return}i.opener=null;try{const{url:s}=await this.link.get(`api/reports/${sp(t)}`);i.location.replace(new URL(s,location.href))}catch(s){i.close(),e.textContent=s.message}}start(){const{run:t}=this;this.on=!0,this.history=new pp(t.display,1/0);for(const e of t.frames)this.history.add(e);this.rungs=t.ladder.map(bp),this.shownRungs={k:-1,rungs:[]},Kt("scrubber").hidden=!1,Kt("bottom").hidden=!0,document.body.classList.add("reviewing"),document.body.classList.remove("stale"),Kt("review-time").max=String(t.frames.length-1),this.panels.setDisplay(t.display),t.display.camera&&(Kt("camera-tag").textContent=t.display.camera.review_title),Kt("run-name").textContent=[oe($.review_of,{name:t.name}),...this.facts()].join(" · "),Kt("run-name").title=Kt("run-name").textContent,this.marks(),this.play(!1),this.go(t.frames.length-1),Kt("review-time").focus()}facts(){const{run:t}=this;return[t.display.modes.length?oe($.review_flown,{mode:tl(t.display,t.mode)}):"",t.display.link?`${t.forward_s} s + ${t.back_s} s`:"",oe($.review_seed,{n:t.seed})].filter(Boolean)}end(){this.film?.stop(),this.on=!1,this.playing=!1}leave(){this.end(),Kt("scrubber").hidden=!0,Kt("bottom").hidden=!1,document.body.classList.remove("reviewing"),Kt("run-name").textContent="",Kt("run-name").title="",Kt("camera-tag").textContent=this.run.display.camera?.title||"",this.say("",!1),this.panels.blank(),this.back(),document.activeElement?.blur()}key(t){if(!this.on||Kt("dialog").open||t.ctrlKey||t.metaKey||t.altKey||t.code!=="Escape"&&Hu(t.target))return;if(t.code==="Space"&&t.target instanceof HTMLButtonElement){t.stopImmediatePropagation();return}const e={Escape:()=>this.leave(),Space:()=>t.repeat||this.play(!this.playing),ArrowLeft:()=>t.shiftKey?this.jump(-1):this.step(-1),ArrowRight:()=>t.shiftKey?this.jump(1):this.step(1),ArrowUp:()=>this.faster(1),ArrowDown:()=>this.faster(-1),Home:()=>this.seek(0),End:()=>this.seek(this.run.frames.length-1)}[t.code];!e&&!Xw.has(t.code)||(t.preventDefault(),t.stopImmediatePropagation(),e?.())}play(t){this.playing=t,Kt("review-play").textContent=t?$.stop_play:$.play,t&&this.at>=this.run.frames.length-1&&this.go(0),this.rebase()}rebase(){this.playedAt=performance.now(),this.playedFrom=this.run.frames[this.at].t,this.filmed=0}setSpeed(t){this.speed=t,Kt("review-speed").value=String(t),this.on&&this.rebase()}faster(t){this.setSpeed(Ca[Math.max(0,Math.min(Ca.length-1,Ca.indexOf(this.speed)+t))])}step(t){this.play(!1),this.go(this.at+t)}jump(t){const e=this.stops.filter(i=>t>0?i>this.at:i<this.at);e.length&&(this.play(!1),this.go(t>0?Math.min(...e):Math.max(...e)))}toEvent(t){t&&(this.play(!1),this.go(this.pictureOf(t)))}pictureOf({t}){const e=this.run.frames.findIndex(i=>i.t>=t-1e-9);return e<0?this.run.frames.length-1:e}go(t){this.at=Math.max(0,Math.min(this.run.frames.length-1,t)),Kt("review-time").value=String(this.at);const e=this.run.frames[this.at].t,i=this.run.events.findLast(r=>r.t<=e),s=`${Xe(e,1)} s${i&&e-i.t<$w?` · ${this.eventWords(i)}`:""}`;Kt("review-now").textContent=s,Kt("review-now").title=s,Kt("review-time").setAttribute("aria-valuetext",s)}seek(t){this.go(t),this.rebase()}eventWords({code:t,text:e}){return this.run.operator==="console"&&$.stick_events[t]||e}advance(){this.playing&&!this.film&&this.playTo(performance.now()-this.playedAt)}playTo(t){const e=this.playedFrom+this.speed*t/1e3;let i=this.at;for(;i<this.run.frames.length-1&&this.run.frames[i].t<e;)i+=1;i!==this.at&&this.go(i),i>=this.run.frames.length-1&&this.play(!1)}filmOn(t){return this.filmed+=t,this.on&&this.playing&&this.playTo(this.filmed),this.on&&this.playing}marks(){const{events:t,frames:e}=this.run,i=Math.max(e.length-1,1);this.stops=[...new Set(t.map(r=>this.pictureOf(r)))],Kt("review-marks").replaceChildren(...this.stops.map(r=>{const o=document.createElement("i");return o.style.left=`${r/i*100}%`,o}));const s=t.length?oe($.review_events_some,{n:t.length}):$.review_events_none;Kt("review-events").disabled=!t.length,Kt("review-events").replaceChildren(new Option(s,""),...t.map((r,o)=>new Option(`${Xe(r.t,1)} s · ${this.eventWords(r)}`,o)))}frame(){return this.run.frames[this.at]}show(){this.advance();const{run:t}=this,e=this.frame(),i=jn(e,t.display.measured),s=this.ladderAt(e.k);this.banner(s),vp(t.display,e,e.mode,!1),this.panels.clocks(e,e.t,i?oe($.age,{s:Xe(e.t-i.t,1)}):"","",!1),this.panels.show({run:t,frame:e,history:this.history,now:e.t,stale:!1,until:e.t,rungs:s})}ladderAt(t){if(this.shownRungs.k!==t){const e=this.rungs.findIndex(i=>i.sent>t);this.shownRungs={k:t,rungs:this.rungs.slice(0,e<0?this.rungs.length:e).map(i=>g_(i,t))}}return this.shownRungs.rungs}banner(t){const{run:e,row:i}=this;if(this.at===e.frames.length-1){const s=e.verdict?.words??(i?.reason?String(i.reason).replaceAll("_"," "):"");this.say(s&&jr(s),!(e.verdict?.success??i?.success))}else if(t.some(Ep)){const s=e.display.abort;this.say(s?oe($.aborted_so,{does:s}):$.aborted,!0)}else this.say("",!1)}say(t,e){const i=Kt("banner");i.dataset.said!==t&&(i.dataset.said=t,i.textContent=t),i.classList.toggle("alarm",!!t&&e)}file(){return this.run.name.replaceAll(/[^\w.-]+/g,"_")}caption(){return[this.run.name,...this.facts(),Kt("review-now").textContent,Kt("banner").textContent].filter(Boolean).join(" · ")}async saveFigure(){const t=Bw(this.panels,this.caption(),()=>{this.show(),this.panels.showReticle(this.frame())}),e=await new Promise(i=>{t.toBlob(i,"image/png")});e&&yc(`${this.file()}-${Xe(this.frame().t,1)}s.png`,e)}record(){if(this.film){this.film.stop();return}this.play(!0),Kt("review-webm").textContent=$.review_webm_stop,this.film=new Ur(this.panels,()=>this.caption(),t=>this.filmOn(t),(t,e)=>{this.film=null,Kt("review-webm").textContent=$.review_webm,e?Kt("review-now").textContent=oe($.review_failed,{why:e.message}):yc(`${this.file()}.webm`,t)})}}const sp=n=>n.split("/").map(encodeURIComponent).join("/"),Yw=6e3;class jw{constructor(){this.status={phase:"idle",lease:"free",pages:0,note:""},this.can={fly:!1,desk:!1},this.connected=!1,this.display=null,this.asked="",this.reset(null)}reset(t){this.run=t,this.frame=null,this.frameAt=0,this.verdict=null,this.ladder=new Map,this.events=[],this.abortAt=null,t&&(this.display=t.display,this.history=new pp(t.display,Yw),this.history.begin(t.trails),this.rungs(t.ladder||[]))}take(t){switch(t.type){case"hello":this.can=t.can,this.asked=t.mode||"",t.display&&!this.display&&(this.display=t.display);break;case"run":this.reset(t);break;case"status":this.status=t;break;case"frame":this.takeFrame(t);break;case"ladder":this.rungs(t.ladder);break;case"verdict":this.verdict=t;break;case"event":this.events.push(t);break}!t.type&&t.link&&(this.connected=t.link==="open",t.why&&(this.why=t.why))}takeFrame(t){if(this.frame=t,this.frameAt=performance.now(),this.rungs(t.ladder),this.history.add(t),this.sent?.parts.kind===Cr&&this.abortAt===null){const e=[...this.ladder.values()].find(i=>i.kind===Cr);this.abortAt=(e?.sent??t.k)*this.run.step_s}}get measured(){return jn(this.frame,this.display?.measured)}get predicted(){return jn(this.frame,this.display?.predicted)}get sent(){return this.frame?.signals[this.display.commands.sent]}rungs(t){for(const e of t)this.ladder.set(e[0],bp(e));for(;this.ladder.size>700;)this.ladder.delete(this.ladder.keys().next().value)}now(){if(!this.frame)return 0;if(this.frame.paused||this.verdict||this.status.phase!=="flying")return this.frame.t;const t=(performance.now()-this.frameAt)/1e3*this.run.pace;return this.frame.t+Math.min(t,this.run.step_s)}silence(){return!this.frame||this.verdict||this.frame.paused||this.status.phase!=="flying"?0:(performance.now()-this.frameAt)/1e3}}const he=n=>document.getElementById(n),Kw=1e3/30,[Zw,Jw]=[60,120],Za=1,Du=2e3;for(const n of document.querySelectorAll("[data-s]"))n.textContent=$[n.dataset.s];for(const n of document.querySelectorAll("[data-a]"))n.setAttribute("aria-label",$[n.dataset.a]);const Gt=new jw,Ni=new mw(he("gl"),he("view"),he("camera"),he("labels")),so=new yw(Ni,n=>vh(n));Ni.enabled=!new URLSearchParams(location.search).has("plain");let Ha=-1/0,wc=0,rp=0,op=null,ap=null;const Ln=new R_((n,t)=>Zn?.stick(n,t)),Iu=new m_(Zn),vl=new w_(Zn,Gt),On=new qw(Zn,so,Gt,()=>ig());function Qw(n){if(n.type==="desk"){Iu.show(n,Gt.status.lease==="you");return}const{phase:t,lease:e}=Gt.status;Gt.take(n),(n.type==="run"||n.type==="hello")&&!On.on&&ig(),n.type==="status"&&(n.phase==="starting"&&t!=="starting"&&(el(),On.on&&n.lease==="you"&&On.leave()),n.phase==="refused"&&t!=="refused"&&n.lease==="you"&&Ja(n.note),n.phase!==t&&il()&&On.list(),n.lease==="you"&&e!=="you"&&Ln.taken(),Uu(),Iu.lease(n.lease==="you")),n.type==="verdict"&&Gt.frame&&ap!==n&&!On.on&&!Gt.can.desk&&(ap=n,Mp(n,Gt.can.fly&&Gt.status.lease==="you",()=>Ja())),n.type==="event"&&(he("event").textContent=`${Xe(n.t,1)} s · ${tT(n)}`),n.type==="reply"&&!n.ok&&(he("event").textContent=n.code?nl(n.code):n.text),n.type||Uu()}function tT({code:n,text:t}){return Gt.run?.operator==="console"&&$.stick_events[n]||t}function ig(){const{display:n}=Gt;if(n){if(so.setDisplay(n),Ln.setController(n.controller),Iu.task={hint:n.hint,goal:n.goal,display:n},!Gt.run){he("run-name").textContent="";return}he("run-name").textContent=n.link?`${Gt.run.name} · ${Gt.run.forward_s} s + ${Gt.run.back_s} s`:Gt.run.name,he("run-name").title=he("run-name").textContent}}async function sg(){await Zn.ask({do:Gt.status.lease==="you"?"drop":"take"})}function vh(n){Gt.frame&&vl.steer({do:"mode",mode:n})}function rg(){Gt.frame&&vl.steer({do:Gt.frame.paused?"resume":"pause"})}function og(){const n=performance.now();n-Ha<Du?(Ha=-1/0,vl.abort()):Ha=n,lp(),setTimeout(lp,Du+50)}function lp(){const n=performance.now()-Ha<Du;he("abort").classList.toggle("armed",n),he("abort").querySelector("small").textContent=n?$.abort_armed:$.abort_hint}function Ja(n=""){Gt.status.lease!=="you"&&Zn.ask({do:"take"}),xp(Gt,t=>Zn.ask(t),n)}function eT(){const n=_p(Gt.display).map(t=>t.name);n.length&&vh(n[(n.indexOf(Gt.frame?.mode)+1)%n.length])}const cp={KeyT:sg,KeyP:rg,KeyX:og,KeyN:()=>Ja(),KeyV:()=>so.nextView(),KeyL:()=>On.list(),KeyG:()=>Tp(Ln,Gt.display),Slash:()=>Fu(Gt.display),KeyM:eT,Equal:()=>Ni.zoom(.85),Minus:()=>Ni.zoom(1.18),BracketLeft:()=>Ni.turn(.15,0),BracketRight:()=>Ni.turn(-.15,0)};addEventListener("keydown",n=>{if(n.repeat||n.ctrlKey||n.metaKey||n.altKey||Hu(n.target)||he("dialog").open&&n.code!=="KeyX")return;const t=l_(Gt.display,n.code);cp[n.code]&&Zn?cp[n.code]():t&&Zn&&!On.on&&vh(t.name)});he("lease").onclick=sg;he("pause").onclick=rg;he("abort").onclick=og;he("restart").onclick=()=>Ja();he("open-review").onclick=()=>On.list();he("open-settings").onclick=()=>Tp(Ln,Gt.display);he("open-help").onclick=()=>Fu(Gt.display);function Uu(){const{status:n}=Gt,t=n.lease==="you";he("lease").textContent=t?$.drop:n.lease==="other"?$.taken:$.take,he("lease").disabled=n.lease==="other",he("lease").classList.toggle("primary",n.lease==="free"),he("pages").textContent=n.pages===1?$.pages_one:oe($.pages,{n:n.pages}),he("socket-state").textContent=Gt.connected?`● ${$.socket_open}`:`○ ${$.socket_closed}`,he("socket-state").className=Gt.connected?"ok":"alarm";for(const e of["pause","restart"])he(e).disabled=!t}function Cn(n,t,e){const i=he("banner"),s=n?`${Pe(n)}${t?`<small>${Pe(t)}</small>`:""}`:"";i.dataset.said!==s&&(i.dataset.said=s,i.innerHTML=s),i.classList.toggle("alarm",!!e)}function nT(n){const{status:t,frame:e,run:i,verdict:s}=Gt,r=vl.words();if(r)Cn(...r,!0);else if(!Gt.connected&&Zn)Cn($.socket_closed,"",!0);else if(t.phase==="idle")Cn($.idle,$.idle_text);else if(t.phase==="starting")Cn($.starting,t.run||"");else if(t.phase==="refused")Cn($.run_refused,t.note,!0);else if(t.note?.startsWith("failed"))Cn($.run_failed,t.note.slice(7),!0);else if(n>Za)Cn(oe($.stale_frames,{s:n.toFixed(0)}),"",!0);else if(Gt.abortAt!==null&&!s&&e){const o=!Gt.display.link||[...Gt.ladder.values()].some(Ep),a=Gt.display.abort,l=e.t-Gt.abortAt,c=l>i.forward_s+i.back_s+2*i.step_s+Za;o?Cn(a?oe($.aborted_so,{does:a}):$.aborted,"",!0):c?Cn($.abort_untold,oe($.abort_untold_hint,{s:l.toFixed(0)}),!0):Cn(oe($.abort_sent,{s:Math.max(0,i.forward_s-l).toFixed(0)}),"",!0)}else t.pilot_lost?Cn($.pilot_lost,"",!0):e?.paused?Cn($.paused,""):e&&!Gt.measured&&t.phase==="flying"?Cn($.no_telemetry,oe($.first_in,{s:Math.max(0,i.back_s-e.t).toFixed(0)})):s?Cn(jr(s.words),"",!s.success):Cn("")}function iT(){const n=Gt.status.lease==="you",t=Ln.state().held,e=Ln.stuck(),i=n?Ln.axes.length?Ln.gone()?$.stick_gone:e.length?oe($.stick_stuck,{axes:e.join(", ")}):t?`${$.stick_held} · ${$[Ln.source]}`:$.stick_open:$.stick_none:$.stick_watch;vn(he("stick-state"),i),he("stick-state").className=n?t&&!e.length?"ok":"alarm":"dim";const s=Gt.display?.controller?.step_name;vn(he("step"),n&&Ln.source==="keyboard"&&Ln.deflections.length>1?`${s} ${Ln.step}`:"")}function sT(){const n=[Ni.webgl?"":$.no_webgl,up?"":$.no_storage,Ln.axes.length?$.pad_notes[Ln.lacks()]:""];vn(he("notes"),n.filter(Boolean).join(" · ")),he("notes").title=he("notes").textContent}function rT(n,t){const{run:e,measured:i}=Gt,s=i?t-i.t:null,r=s!==null&&s>e.back_s+Za*Math.max(e.pace,1);return so.clocks(n,t,s===null?"":oe($.age,{s:Xe(s,1)}),i?oe($.ago,{s:Xe(Math.max(t-i.received,0),1)}):"",r),r}function oT(){const{frame:n,run:t,history:e}=Gt,i=Gt.silence();if(nT(i),iT(),sT(),vn(he("pause"),n?.paused?$.resume:$.pause),vp(Gt.display,n,n?.mode||t?.mode,Gt.status.lease==="you"),!t||!n)return;const s=Gt.now(),r=rT(n,s)||i>Za||!Gt.connected;document.body.classList.toggle("stale",r),so.show({run:t,frame:n,history:e,rungs:[...Gt.ladder.values()],now:s,stale:r})}function ag(n){if(requestAnimationFrame(ag),n-wc<Kw-2)return;Ni.adapt(n-wc),wc=n;const t=n-rp>(Gt.frame===op&&!On.on?Jw:Zw);t&&(rp=n,op=Gt.frame,On.on?On.show():oT()),Ni.draw(),t&&so.showReticle(On.on?On.frame():Gt.frame)}Uu();Zn?Zn.listen(Qw):Nu($.no_token_title,$.no_page_token);requestAnimationFrame(ag);window.rvd={store:Gt,scene:Ni,stick:Ln,review:On,link:Zn};
