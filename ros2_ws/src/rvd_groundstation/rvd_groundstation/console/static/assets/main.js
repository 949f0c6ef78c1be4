import{r as fg,a as dg,b as Zd,l as Zn}from"./index.js";const Yr={"+x":[1,0,0],"-x":[-1,0,0],"+y":[0,1,0],"-y":[0,-1,0],"+z":[0,0,1],"-z":[0,0,-1]};function Mi(n,t){const e=n?.signals[t];return e?.ok?e:void 0}function ci(n,t){return t?Mi(n,t.signal)?.parts[t.part]??void 0:void 0}const Jd=(n,t)=>Array.isArray(n)?n[t]:n;function On(n,{signal:t,part:e,index:i,factor:s}){const r=Mi(n,t)?.parts[e];if(r==null)return;const o=i.map(a=>Jd(r,a));if(!o.some(a=>a==null))return s*(o.length===1?o[0]:Math.hypot(...o))}function vs(n,t){return t!==null&&typeof t=="object"?On(n,t):t??void 0}function Qd(n,t="xyz"){if(n==null)return;const e=[0,0,0];for(let i=0;i<t.length;i+=1){const s=Jd(n,i);if(s==null)return;e["xyz".indexOf(t[i])]=s}return e}function Si(n,t,e){return Array.isArray(t)?t:Qd(ci(n,t),e)}function Ii(n,t){const e=Yr[n];return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}class tp{constructor(t,e){this.display=t,this.keep=e,this.trails=new Map;for(const i of t?.lines||[])i.kind==="trail"&&this.trails.set(i.name,[]);this.charts=(t?.charts?.strips||[]).map(i=>({t:[],curves:i.curves.map(()=>[]),spread:[]}))}begin(t){for(const e of this.display.lines)for(const i of t?.[e.name]||[]){const s=Qd(i.slice(2,-1),e.axes);s&&this.trails.get(e.name).push([i[0],i[1],...s,i[i.length-1]??0])}}add(t){for(const e of this.display.lines)e.kind==="trail"&&this.extend(e,t);this.display.charts?.strips.forEach((e,i)=>this.plot(e,this.charts[i],t))}extend(t,e){const i=this.trails.get(t.name),s=Si(e,t.place,t.axes);if(!s||i.length&&e.t<=i[i.length-1][0])return;const r=t.spread?On(e,t.spread)??0:0;i.push([e.t,e.signals[t.place.signal].t,...s,r]),i.length>this.keep&&i.shift()}plot(t,e,i){const s=[...t.curves,t.spread].filter(Boolean).map(a=>a.signal),r=Mi(i,s.find(a=>a!=="truth")??"truth");if(!r||r.t<=(e.t[e.t.length-1]??-1/0))return;e.t.push(r.t),t.curves.forEach((a,l)=>e.curves[l].push(On(i,a)??null));const o=t.spread?On(i,t.spread):void 0;e.spread.push(o===void 0?null:o*t.spread_factor)}}function pg(n,t,e,i,s){let r=t.length;for(;r>0&&t[r-1][0]>i;)r-=1;if(!n.since)return{rows:t,at:2,n:r};const o=Mi(e,n.since.signal),a=Si(e,n.place,n.axes),l=Si(e,n.since,n.axes);if(!o||!a||!l)return{rows:[],at:0,n:0};let c=r;for(;c>0&&t[c-1][1]>o.t;)c-=1;const u=[[...l,n.since_spread?On(e,n.since_spread)??0:0]],h=Math.max(1,Math.floor((r-c)/s));for(let f=c;f<r;f+=h)u.push(t[f].slice(2));return u.push([...a,n.spread?On(e,n.spread)??0:0]),{rows:u,at:0,n:u.length}}const mg=2,gg=.6,Rh=1,[_g,vg]=[9,11],xg=3;function Mg(n,{role:t,value:e,low:i,high:s}){const r=On(n,e),[o,a]=[vs(n,i),vs(n,s)];if(r===void 0)return;const l=[];return o!==void 0&&l.push({role:t,value:r,limit:o,over:o-r,sense:"<"}),a!==void 0&&l.push({role:t,value:r,limit:a,over:r-a,sense:">"}),l.sort((c,u)=>u.over-c.over)[0]}function Sg(n,t){return t.readings.map(e=>Mg(n,e)).filter(Boolean).sort((e,i)=>i.over-e.over)[0]}function yg(n,t,e){return t.map(i=>{const s=Sg(n,i),r=e(i.words),o=s?s.over>=0||r&&s.over>-i.back:r;return{words:i.words,level:i.level,on:o,seen:s&&{...s,label:i.label,unit:i.unit,digits:i.digits}}})}function Eg({run:n,frame:t,measured:e,sent:i,silence:s,connected:r,pilotLost:o},a){const l=Math.max(n.pace,1),c=Rh+n.step_s/n.pace,u=r?s:Math.max(s,c),h=t.t+u*n.pace-(e?e.t:0),f=u>=c||h>n.back_s+2*n.step_s+Rh*l,d=n.operator==="console"&&i&&i.parts.kind!==xg&&[_g,vg].includes(i.parts.reason);return[{words:a.telemetry,level:"warning",on:f,age:h},{words:a.pilot,level:"warning",on:!!o},{words:a.nobody,level:"caution",on:!!(d&&!o),after:gg}]}class bg{constructor(){this.standing=new Map,this.pending=new Map}stands(t){return this.standing.has(t)}clear(){this.standing.clear(),this.pending.clear()}judge(t,e){for(const r of t){const o=this.standing.get(r.words);r.on?this.pending.has(r.words)||this.pending.set(r.words,e):this.pending.delete(r.words),r.on&&(o||e-this.pending.get(r.words)>=(r.after||0))?this.standing.set(r.words,{acknowledged:!1,...o,...r,last:e}):o&&e-o.last>=mg?this.standing.delete(r.words):o&&Object.assign(o,{seen:r.seen??o.seen,age:r.age})}const i=new Map(t.map(({words:r},o)=>[r,o]));for(const r of this.standing.keys())i.has(r)||this.standing.delete(r);const s=r=>[r.acknowledged?1:0,r.level==="warning"?0:1,i.get(r.words)];return this.shown=[...this.standing.values()].sort((r,o)=>{const[a,l]=[s(r),s(o)];return a[0]-l[0]||a[1]-l[1]||a[2]-l[2]}),this.shown}acknowledge(){for(const t of this.standing.values())t.acknowledged=!0}get loud(){const t=[...this.standing.values()].filter(e=>!e.acknowledged);return t.some(e=>e.level==="warning")?"warning":t.length?"caution":""}}const Xt={measured:"#7cc4ff",predicted:"#ffb652",truth:"#f2f5f8",target:"#dbe5ee",plain:"#dbe5ee",pilot:"#7cc4ff",automatic:"#d59bf6",sent:"#56d6b0",limit:"#8aa4bd",guide:"#b9c2a0",goal:"#56d6b0",ok:"#56d6b0",alarm:"#ff7a5c",dim:"#8fa1b3",line:"#263544",text:"#dbe5ee"},Ya=!new URLSearchParams(location.search).has("fine")&&/swiftshader|llvmpipe|softpipe|software|basic render/i.test(wg());function wg(){const n=document.createElement("canvas").getContext("webgl2");if(!n)return"software";const t=n.getExtension("WEBGL_debug_renderer_info"),e=String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),e}function $e(n,t){n.textContent!==t&&(n.textContent=t)}const gc=new Map;let wa=12;const Tg=new ResizeObserver(n=>n.forEach(({target:t})=>ep(t)));function ep(n){const{width:t,height:e}=n.getBoundingClientRect();gc.set(n,{w:t,h:e}),wa=parseFloat(getComputedStyle(document.documentElement).fontSize)}const Ka=n=>Math.max(11,.74*n);function Kr(n){gc.has(n)||(ep(n),Tg.observe(n));const{w:t,h:e}=gc.get(n),i=Math.min(devicePixelRatio||1,2),s=Math.max(1,Math.round(t*i)),r=Math.max(1,Math.round(e*i));(n.width!==s||n.height!==r)&&Object.assign(n,{width:s,height:r});const o=n.getContext("2d",{willReadFrequently:Ya});return o.setTransform(i,0,0,i,0,0),o.clearRect(0,0,t,e),o.font=`${Ka(wa)}px system-ui, sans-serif`,o.lineWidth=wa/12,{pen:o,w:t,h:e,rem:wa}}function Or(n,t,e,i,s,r){n.strokeStyle=s,n.setLineDash(r||[]),n.beginPath(),n.arc(t,e,Math.max(i,0),0,7),n.stroke(),n.setLineDash([])}function Ke(n,t,e,i,s,r="left",o="middle"){n.fillStyle=s,n.textAlign=r,n.textBaseline=o,n.fillText(t,e,i)}const J={title:"RVD console",clocks:"Three clocks",clock_generated:"generated on board",clock_received:"received on the ground",clock_predicted:"predicted for",modes:"Who decides",mode_turn:"{modes} in turn",mode_ground:"ground",mode_board:"on board",pause:"Pause",resume:"Resume",abort:"ABORT",abort_hint:"X twice",abort_armed:"again: ABORT",instruments:"Instruments",columns:{measured:"measured",predicted:"predicted",truth:"truth",plain:""},limit:"limit",weight:"pilot weight",scene:"Scene",views:"Views",camera_side:"Camera, delay and charts",ladder:"Command ladder",ladder_alt:"Commands on their way to the craft and back",ladder_ground:"ground",ladder_link:"on the link",ladder_craft:"at the craft",ladder_back:"telemetry on its way back",ladder_known:"known",ladder_narrow:["ground","link","craft","back","known"],round_trip:"Round trip",dial_alt:"Dial of the round trip",restart:"New run",review:"Review",settings:"Stick",help:"Help",stop:"Stop run",review_close:"Leave review",play:"Play",stop_play:"Stop",scrub:"Instant of the review",review_title:"Review a run",review_none:"No finished runs here yet: a run is listed once its bag is closed.",review_loading:"Reading the bag…",review_open:"Open",take:"Take the stick",drop:"Release the stick",taken:"Another page has the stick",stick_yours:"You have the stick",stick_held:"stick live",stick_open:"DEAD-MAN OPEN: automatic alone flies",stick_watch:"watching",stick_none:"you are in charge",keyboard:"keyboard",gamepad:"gamepad",stick_events:{STICK_LOST:"nobody holds the stick, or the dead-man is open",STICK:"the stick counts"},pages_one:"1 page",pages:"{n} pages",of:"of",socket_open:"connected",socket_closed:"NOT CONNECTED",idle:"Ready",idle_text:"Take the stick (T), then start a run (N).",starting:"The graph is coming up…",paused:"PAUSED",stale:"STALE",no_telemetry:"no telemetry yet",first_in:"first telemetry in {s} s",pilot_lost:"PILOT LOST: the automatic controller flies alone",stale_frames:"NO DATA FOR {s} s",aborted:"ABORT in force",aborted_so:"ABORT in force: {does}",abort_sent:"ABORT sent, acting in about {s} s",abort_asked:"ABORT: waiting for the answer",abort_unconfirmed:"ABORT NOT CONFIRMED",abort_again:"no answer; asked {n} times, asking again",abort_accepted:"ABORT accepted, goes out with the next frame",abort_untold:"ABORT sent, NOT ACKNOWLEDGED",abort_untold_hint:"sent {s} s ago; telemetry has not told whether it is in force",unconfirmed:"{name} NOT CONFIRMED",unconfirmed_hint:"The run did not answer in 2 s. Try again.",no_webgl:"No WebGL: the scene is drawn in lines",no_storage:"Storage is blocked: settings are not remembered",stick_gone:"GAMEPAD GONE: automatic alone flies",stick_stuck:"NOT AT REST: {axes} counts as 0 until it has been centred",run_failed:"The run could not be flown: see the terminal",run_refused:"No run with these settings",verdict_title:"Verdict",verdict_time:"time",fly_again:"Fly again (N)",close:"Close",cancel:"Cancel",start:"Start",seed:"seed",mode:"mode",seed_hint:"empty: the next one",new_run:"New run",new_run_text:"A new run in a new folder. A run under way is stopped.",no_fly:"This console belongs to one run; start it with ./rvd fly --operator console to fly again.",no_page_token:"This page needs the token of the address that the console printed.",no_token_title:"No token",exaggerated:"{axis} scale × {n}",link:{transit:"transit",p99:"p99",lost:"lost",late:"late",corrupted:"damaged",gap:"last gap"},age:"age {s} s",ago:"{s} s ago",ahead:"in {s} s",now:"now",settings_title:"The stick",settings_dead_zone:"dead zone",settings_axis:"axis",settings_pair:"buttons {plus} / {minus}, or",settings_invert:"inverted",settings_button:"dead-man button",settings_space:"keyboard: hold Space as dead-man",settings_none:"No gamepad seen. Press a button on it.",settings_pads:"Gamepads",settings_now:"now",pad_notes:{"":"",choose:"Several gamepads: choose one under Stick (G)",setup:"The gamepad must be set up under Stick (G) before it flies"},pad_plain:"no standard mapping",pad_live:"axes {axes} · pressed {buttons}",pad_nothing:"none",pad_choose:"Several gamepads are connected: choose one.",pad_setup:"This gamepad has no standard mapping: its axes and buttons may be anything. It does not fly before each axis and the dead-man button have been set.",pad_ready:"This gamepad is set up.",pad_start:"Set it up step by step",pad_next:"Next",pad_skip:"No such axis",pad_stop:"Stop",pad_rest:"Let go of all its sticks, triggers and buttons, then go on.",pad_move:"Push the stick all the way for {what} ({name}).",pad_back:"Let it go.",pad_trigger:"Axis {axis} does not rest at 0, as a trigger does not: take another.",pad_hold:"Press the button that is to be held while flying.",help_title:"Keys",help_step:"{name} of the keys",or:"or",review_truth:"Review shows the truth. It never reaches this page while a run is flown.",unknown:"–",alarms:"Alarms",acknowledge:"Acknowledge (K)",digits:"Position and rates of the craft",field:"field {deg}°",field_was:"(was {deg}°)",desk:{door:"Which volunteer? Enter the number you were given; no name is asked or kept.",volunteer:"volunteer number",begin:"Begin",heading:"{who}, flight {n} of {of}",training:"Training: this flight does not count.",counts:"This flight counts.",condition:"Control: {mode}",clock:"The clock starts when the graph is up.",fly:"Start the flight",rest_title:"A break",rest:"Rest your eyes and hands.",go_on:"Go on",done_title:"Finished",done:"Thank you, {who}. All flights are flown and rated.",next:"Next volunteer",yes:"Yes",no:"No",again:"Answer again",pick:"Pick the sentence that fits best.",save:"Save the ratings",weigh:"Which of the two contributed more to the workload of flying in this way?",pair:"pair {n} of {of}",tree:{controllable:"Was the craft controllable?",adequate:"Was adequate performance ({goal}) attainable with a tolerable pilot workload?",satisfactory:"Was it satisfactory without improvement?"},ratings:["","Excellent, highly desirable: compensation not a factor","Good, negligible deficiencies: compensation not a factor","Fair, some mildly unpleasant deficiencies: minimal compensation","Minor but annoying deficiencies: moderate compensation","Moderately objectionable deficiencies: considerable compensation","Very objectionable but tolerable deficiencies: extensive compensation","Major deficiencies: adequate performance not attainable with maximum tolerable compensation","Major deficiencies: considerable compensation needed for control","Major deficiencies: intense compensation needed to retain control","Major deficiencies: control lost during some part of the flight"],tlx:{mental:["Mental demand","How mentally demanding was the flight?","very low","very high"],physical:["Physical demand","How physically demanding was the flight?","very low","very high"],temporal:["Temporal demand","How hurried or rushed was the pace?","very low","very high"],performance:["Performance","How successful were you in doing what you were asked to do?","perfect","failure"],effort:["Effort","How hard did you have to work for your level of performance?","very low","very high"],frustration:["Frustration","How insecure, discouraged, irritated, stressed and annoyed were you?","very low","very high"]},errors:{VOLUNTEER:"A whole number from 1 to 999, please.",STAGE:"Not now.",RATING:"The rating is incomplete.",TLX:"Please set every scale.",WEIGHTS:"Please choose in every pair."}}},Ag=[["T","take or release the stick"],["Space","dead-man, if so chosen under Stick"],["P","pause, resume"],["X X","ABORT, past every buffer{abort}"],["K","acknowledge the alarms: they fall silent until the next one"],["O","sound of the alarms on, off"],["N","new run"],["V","next view"],["+ − [ ]","zoom and turn the scene"],["L","review a run"],["G","stick settings"],["?","this list"],["Esc","close"],["","A key that is released commands zero. Without focus, without this page, or with the dead-man open, there is no pilot: the automatic controller flies alone."]],xo={none:"no alarm",sound_on:"Sound on (O)",sound_off:"Sound off (O)",beyond:"{said}{label} {value}, limit {limit}",telemetry:"TELEMETRY LOST",pilot:"PILOT LOST",nobody:"NOBODY HOLDS THE STICK"},np={good:"A good approach",keys:"Keys"},Rg={ArrowUp:"↑",ArrowDown:"↓",ArrowLeft:"←",ArrowRight:"→"},Cg=["nobody","pilot","automatic","blend","guard"],Ch=["","nothing due","wrong length","checksum","out of order","too old","out of range","an input was missing","as the mode says","stick invalid: automatic alone","automatic invalid: counts as neutral","neither valid: neutral","ABORT in force"],Pg=["sent","due","executed","effect seen","refused","missed","unknown"],Lg={LEASE:"Take the stick first (T).",TAKEN:"Another page has the stick.",NO_RUN:"No run is under way.",NO_FLY:J.no_fly,NO_ANSWER:"The run did not answer.",DESK:"The session says what is flown.",MODE:"No such mode.",SETTINGS:"Too many settings, or one that is too long.",SEED:"The seed must be a whole number."};function Me(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}function Dg(n,[t,e],i,[s,r],o,a,l,c){const u=Math.hypot(s-t,r-e),[h,f]=[(s-t)/u,(r-e)/u],[d,g]=[t+h*i,e+f*i],[v,m]=[d-h*a*.9,g-f*a*.9];if(n.fillStyle=o,n.beginPath(),n.moveTo(d,g),n.lineTo(v-f*a*.5,m+h*a*.5),n.lineTo(v+f*a*.5,m-h*a*.5),n.closePath(),n.fill(),!l)return;const p=[v-h*a*1.6,m-f*a*.9];for(;c.some(([y,T])=>Math.abs(y-p[0])<3*a&&Math.abs(T-p[1])<a);)p[1]+=a;c.push(p),Ke(n,l,...p,o,"center")}const Ui=n=>document.getElementById(n),Ph=.75*Math.PI;function Ig(n){Ui("attitude").hidden=!n,n&&(Ui("attitude-title").textContent=n.title,Ui("ball").setAttribute("aria-label",n.alt))}const Lh=(n,t)=>{const e=Math.max(0,...t.filter(i=>i!==void 0).map(Math.abs));return n.find(i=>e<=i)??n[n.length-1]},Wo=(n,t)=>Math.max(-1,Math.min(1,n/t)),Dh=(n,t)=>n>0?`+${Re(n,t)}`:Re(n,t);function Ug(n,t){const{pen:e,w:i,h:s,rem:r}=Kr(Ui("ball")),o=Math.min(i*.6,s)/2-.95*r,[a,l]=[o+1.1*r,s/2],c=v=>v?.map(m=>On(t,m)),u=n.needles[0],[h,f]=[c(u.angles),c(u.rates)],d=Lh(n.scales,h),g=f?Lh(n.rate_scales,f):1;e.fillStyle="#0a1420",e.beginPath(),e.arc(a,l,o,0,7),e.fill(),Or(e,a,l,o,Xt.dim),e.strokeStyle=Xt.line,e.beginPath(),e.moveTo(a-o,l),e.lineTo(a+o,l),e.moveTo(a,l-o),e.lineTo(a,l+o);for(const v of[-.5,.5])e.moveTo(a+v*o,l-r*.25),e.lineTo(a+v*o,l+r*.25),e.moveTo(a-r*.25,l+v*o),e.lineTo(a+r*.25,l+v*o);for(const v of[-1,-.5,0,.5,1]){const m=v*Ph-Math.PI/2;e.moveTo(a+o*Math.cos(m),l+o*Math.sin(m)),e.lineTo(a+(o-r*.4)*Math.cos(m),l+(o-r*.4)*Math.sin(m))}e.stroke(),n.limit!==null&&n.limit<=d&&Or(e,a,l,n.limit/d*o,Xt.limit,[r*.3,r*.25]);for(const v of[...n.needles].reverse()){const[m,p,y]=c(v.angles);if(m===void 0)continue;const T=Xt[v.role];e.strokeStyle=T,e.fillStyle=T;const x=o-.15*r,[U,A]=[a+Wo(y,d)*x,l-Wo(p,d)*x],D=S=>Math.sqrt(Math.max(x*x-S*S,0))*.8;e.lineWidth=r*(v===u?.16:.08),e.beginPath(),e.moveTo(a-D(A-l),A),e.lineTo(a+D(A-l),A),e.moveTo(U,l-D(U-a)),e.lineTo(U,l+D(U-a)),e.stroke();const I=Wo(m,d)*Ph-Math.PI/2,w=(S,C)=>[a+S*Math.cos(C),l+S*Math.sin(C)];e.beginPath(),e.moveTo(...w(o,I)),e.lineTo(...w(o-r*.8,I-.09)),e.lineTo(...w(o-r*.8,I+.09)),e.closePath(),v===u?e.fill():(e.lineWidth=r/12,e.stroke())}e.lineWidth=r/12,f&&f[0]!==void 0&&Ng(e,a,l,o,r,f.map(v=>Wo(v,g)),Xt[u.role]),e.strokeStyle=Xt.text,e.beginPath(),e.moveTo(a-r*.9,l),e.lineTo(a-r*.3,l),e.moveTo(a+r*.3,l),e.lineTo(a+r*.9,l),e.stroke(),Fg(e,n,{angles:h,rates:f,scale:d,rateScale:g,w:i,h:s,rem:r})}function Ng(n,t,e,i,s,[r,o,a],l){n.fillStyle=l;const c=(h,f,d,g)=>{n.beginPath(),n.moveTo(h,f),n.lineTo(h+d*s*.6-g*s*.3,f+g*s*.6+d*s*.3),n.lineTo(h+d*s*.6+g*s*.3,f+g*s*.6-d*s*.3),n.closePath(),n.fill()},u=i+s*.25;c(t+r*i,e-u,0,-1),c(t+u,e-o*i,1,0),c(t+a*i,e+u,0,1)}function Fg(n,t,{angles:e,rates:i,scale:s,rateScale:r,w:o,h:a,rem:l}){const c=o-l*.2,u=o*.6+l*1.3;["roll","pitch","yaw"].forEach((f,d)=>{const g=a/2+(d-1.4)*l*2.3;Ke(n,f,u,g,Xt.dim),n.font=`600 ${.95*l}px system-ui, sans-serif`;const v=t.limit!==null&&Math.abs(e[d])>t.limit;Ke(n,`${v?"▲ ":""}${Dh(e[d],t.digits)}`,c,g,Xt[t.needles[0].role],"right"),n.font=`${Ka(l)}px system-ui, sans-serif`,i&&Ke(n,`${Dh(i[d],t.digits+1)} /s`,c,g+l*.95,Xt.dim,"right")}),[`ring ±${s} ${t.unit}`,...i?[`edge ±${r} ${t.unit}/s`]:[]].forEach((f,d)=>Ke(n,f,c,a-l*(1.5-d),Xt.dim,"right"))}function Og(n){Ui("lamps").hidden=!n,n&&(Ui("lamps-title").textContent=n.title,Ui("lights").setAttribute("aria-label",n.alt),Ui("lights").style.height=`${2*n.groups.length}rem`)}function kg(n,t){const{pen:e,w:i,h:s,rem:r}=Kr(Ui("lights")),[o,a,l]=[n.on,n.glow,n.counts].map(g=>ci(t,g));n.note&&Fa(ci(t,n.note)??["",!1],Ui("lamps-note"),"dim");const c=Math.max(...n.groups.map(g=>g.labels.length+Bg(g.labels)*.5)),[u,h]=[11.5*r,i-5.2*r],f=Math.min((h-u)/c,2.6*r);let d=0;n.groups.forEach((g,v)=>{const m=(v+.36)*(s/n.groups.length);Ke(e,g.name,0,m,Xt.text),Ke(e,g.words,1.8*r,m,Xt.dim);let p=u;g.labels.forEach((y,T)=>{const x=T===0||g.labels[T-1]!==y;x&&T>0&&(p+=f*.5);const U=Math.max(a?.[d]??0,o?.[d]?1:0);Or(e,p,m,r*.42,o?.[d]?"#ffffff":"#3a4f63"),e.globalAlpha=U,e.fillStyle=Xt[n.role],e.beginPath(),e.arc(p,m,r*.4,0,7),e.fill(),e.globalAlpha=1;let A=T;for(;g.labels[A+1]===y;)A+=1;x&&Ke(e,y,p+(A-T)*f/2,m+r*.92,Xt.dim,"center"),p+=f,d+=1}),l&&Ke(e,`${l[v]} pulses`,i,m,Xt.text,"right")})}const Bg=n=>n.filter((t,e)=>e>0&&n[e-1]!==t).length;function zg(n,{w:t,h:e,rem:i},s,r,o){const a=e/2/o,[l,c]=[t/2,e/2],u=s.half_view*a;n.strokeStyle=Xt.limit,n.strokeRect(l-u,c-u,2*u,2*u);const[h,f]=[ci(r,s.points),ci(r,s.used)];if(!h)return;const d=s.width_px;for(let g=0;2*g<h.length;g+=1){if(h[2*g]===null||h[2*g+1]===null)continue;const v=l+(h[2*g]/d-.5)*2*u,m=c+(h[2*g+1]/d-.5)*2*u;n.lineWidth=i/8,Or(n,v,m,i*.38,f?.[g]?Xt.ok:Xt.dim),n.lineWidth=i/12,f?.[g]&&(n.fillStyle=Xt.ok,n.beginPath(),n.arc(v,m,i*.14,0,7),n.fill())}}const Qe=n=>document.getElementById(n),Hg=4,Vg=["measured","predicted","truth","plain"];function Re(n,t){if(n==null||!Number.isFinite(n))return J.unknown;const e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","−")}const $o=(n,t,e)=>typeof n=="number"?String(n).replace("-","−"):Re(t,e);function ip(n,{low:t,high:e},i){const[s,r]=[vs(n,t),vs(n,e)];return s===void 0&&r===void 0?"":r===void 0?`> ${$o(t,s,i)}`:s===void 0?`< ${$o(e,r,i)}`:`${$o(t,s,i)}…${$o(e,r,i)}`}class Gg{setDisplay(t){const e=t.instruments;if(Qe("instruments").hidden=!e,this.rows=[],!e)return;Qe("instruments-title").textContent=e.title;const i=Vg.filter(r=>e.rows.some(o=>o.readings.some(a=>a.role===r)));Qe("instruments").style.setProperty("--columns",i.length);const s=si("div","head");s.append(...[["",""],...i.map(r=>[J.columns[r],r]),["",""],[J.limit,"dim"]].map(([r,o])=>si("span",o,r))),Qe("instruments-rows").replaceChildren(s,...e.rows.map(r=>{const o=si("div","row"),a=new Map(i.map(c=>[c,si("b",c)])),l=si("u");return o.append(si("span","",r.label),...a.values(),si("u","unit",r.unit),l),this.rows.push({row:r,cells:a,limit:l}),o}))}show(t,e){for(const{row:i,cells:s,limit:r}of this.rows){let o="";for(const a of i.readings){const l=On(t,a.value),c=s.get(a.role);$e(c,Re(l,i.digits)),c.classList.toggle("stale-value",e&&a.role==="measured"),c.classList.toggle("bad",l<=vs(t,a.low)||l>=vs(t,a.high)),o=ip(t,a,i.digits)||o}$e(r,o)}}}function si(n,t="",e=""){const i=document.createElement(n);return t&&(i.className=t),i.textContent=e,i}function Wg(n){Qe("cut").hidden=!n,n&&(Qe("section-title").textContent=n.title,Qe("section").setAttribute("aria-label",n.alt),Qe("foot").hidden=!n.foot,n.foot&&(Qe("foot-label").textContent=n.foot.label))}const sp={dot(n,t,e,i,s){n.fillStyle=i,n.beginPath(),n.arc(t,e,s*.3,0,7),n.fill()},ring(n,t,e,i,s,r){n.fillStyle=`${i}30`,n.beginPath(),n.arc(t,e,Math.max(s*.3,r),0,7),n.fill(),n.stroke()},cross(n,t,e,i,s){const r=s*.32;n.beginPath(),n.moveTo(t-r,e-r),n.lineTo(t+r,e+r),n.moveTo(t-r,e+r),n.lineTo(t+r,e-r),n.stroke()},square(n,t,e,i,s){n.strokeRect(t-s*.35,e-s*.35,s*.7,s*.7)}};function $g(n,t){const{pen:e,w:i,h:s,rem:r}=Kr(Qe("section")),[o,a]=[i/2,s/2],l=Math.min(i,s)/2-.9*r;e.strokeStyle=Xt.line,e.beginPath(),e.moveTo(o-l,a),e.lineTo(o+l,a),e.moveTo(o,a-l),e.lineTo(o,a+l),e.stroke(),Fa(n.note?ci(t,n.note):["",!1],Qe("section-note"),"dim"),n.foot&&Fa(ci(t,n.foot.words),Qe("foot-words"));const c=vs(t,n.extent_m);if(!c)return;const u=l/c;for(const d of n.rings){const g=vs(t,d.radius_m);g!==void 0&&(Or(e,o,a,g*u,Xt[d.role],d.dashed?[r*.3,r*.25]:null),d.written&&Ke(e,`${g.toFixed(2)} m`,o+g*u*.72,a-g*u*.72-r*.3,Xt[d.role]))}Ke(e,n.names?.[1]??Ih(n.up),o+r*.3,a-l,Xt.dim),Ke(e,n.names?.[0]??Ih(n.right),o+l,a-r*.6,Xt.dim,"right");const h=[],f=d=>[o+Ii(n.right,d)*u,a-Ii(n.up,d)*u];for(const d of n.spots){const g=Si(t,d.place);if(!g)continue;const v=Xt[d.role],[m,p]=f(g);if(e.strokeStyle=v,Math.hypot(m-o,p-a)>l+.5*r){Dg(e,[o,a],l,[m,p],v,r,d.mark==="cross"?"":`${(Math.hypot(m-o,p-a)/u).toFixed(1)} m`,h);continue}const y=d.origin&&Si(t,d.origin);y&&(e.setLineDash([r*.2,r*.2]),e.beginPath(),e.moveTo(...f(y)),e.lineTo(m,p),e.stroke(),e.setLineDash([])),sp[d.mark](e,m,p,v,r,d.spread?(On(t,d.spread)??0)*u:0);const T=d.rate&&Si(t,d.rate);if(T){const x=d.ahead_s*u;e.beginPath(),e.moveTo(m,p),e.lineTo(m+Ii(n.right,T)*x,p-Ii(n.up,T)*x),e.stroke()}}}const Ih=n=>n.replace("+","").replace("-","−");function Fa(n,t,e=""){const[i,s]=n||[J.unknown,!1];$e(t,i),t.className=s?"alarm":e}function _c(n,t){const e=Re(n,t);return Number(n.toFixed(t))>0?`+${e}`:e}function Xg(n){const t=si("div","bar");return t.append(document.createElement("i"),document.createElement("span")),t.firstChild.style.background=n,t}class qg{setDisplay({commands:t,link:e}){this.commands=t,this.link=e,Qe("commands-title").textContent=t.unit?`${t.title}, ${t.unit}`:t.title;const i=t.axes.map(o=>si("span","dim",o.name)),s=t.rows.map(o=>si("span",o.role==="automatic"?"auto":"",o.label));this.rows=t.rows.map(o=>({row:o,bars:t.axes.map(()=>Xg(Xt[o.role]))}));const r=i.length<=Hg?[[si("span"),...i],...this.rows.map(({bars:o},a)=>[s[a],...o])]:[[si("span"),...s],...i.map((o,a)=>[o,...this.rows.map(({bars:l})=>l[a])])];Qe("bars").style.setProperty("--columns",r[0].length-1),Qe("bars").replaceChildren(...r.flat())}show(t){const e=t.signals[this.commands.sent];for(const{row:s,bars:r}of this.rows){const a=(s.value.signal===this.commands.sent?e:Mi(t,s.value.signal))?.parts[s.value.part];this.commands.axes.forEach((l,c)=>this.bar(r[c],a?.[c]??null,l.highest))}const i=e&&this.link?[Cg[e.parts.by]]:[];e&&e.parts.weight!==null&&e.parts.by===3&&i.push(`${J.weight} ${e.parts.weight}`),e&&Ch[e.parts.reason]&&i.push(Ch[e.parts.reason]),$e(Qe("why"),i.join(" · "))}bar(t,e,i){const s=Math.min(Math.abs(e||0)/i,1)*48;t.firstChild.style.left=`${e<0?50-s:50}%`,t.firstChild.style.width=`${s}%`,$e(t.lastChild,e===null?J.unknown:_c(e,this.commands.digits))}}function El(n,t,e,i){const s=Qe(`clock-${n}`);$e(s,t===void 0?J.unknown:`${Re(t,1)} s`),$e(Qe(`clock-${n}-age`),e),s.parentElement.classList.toggle("stale",!!i)}function Yg(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=Kr(n),[l,c,u]=[r/2,o*.56,Math.min(r/2,o*.56)-a*.5],h=t.forward_s+t.back_s,f=Math.max(h*1.5,1),d=m=>Math.PI*(.8+1.4*Math.max(0,Math.min(1,m/f)));s.lineWidth=a*.45,s.strokeStyle="#1b2733",s.beginPath(),s.arc(l,c,u,d(0),d(f)),s.stroke(),e!==void 0&&(s.strokeStyle=e>h+1?Xt.alarm:Xt.measured,s.beginPath(),s.arc(l,c,u,d(0),d(e)),s.stroke()),i&&(s.lineWidth=a*.16,s.strokeStyle=Xt.guide,s.beginPath(),s.arc(l,c,u-a*.5,d(0),d(i)),s.stroke()),s.strokeStyle=Xt.text,s.lineWidth=a*.12;const g=d(h);s.beginPath(),s.moveTo(l+(u-a*.4)*Math.cos(g),c+(u-a*.4)*Math.sin(g)),s.lineTo(l+(u+a*.4)*Math.cos(g),c+(u+a*.4)*Math.sin(g)),s.stroke(),s.font=`600 ${1.35*a}px system-ui, sans-serif`,Ke(s,e===void 0?J.unknown:`${e.toFixed(1)} s`,l,c-a*.05,Xt.text,"center"),s.font=`${Ka(a)}px system-ui, sans-serif`;const v=`${t.forward_s} + ${t.back_s} s`;s.measureText(v).width<1.55*u&&Ke(s,v,l,c+a*1.2,Xt.dim,"center")}function Kg(n,t,e){const{link:i,gap:s}=n,r=[[J.link.transit,t?`${Re(t.transit,2)} s`:J.unknown]];i&&r.push([J.link.p99,`${Re(i.delay_p99,2)} s`],[J.link.lost,i.lost+i.outage],[J.link.late,i.late],[J.link.corrupted,i.corrupted]),r.push([J.link.gap,s?Me(J.ago,{s:Re((n.k-s.k)*e,0)}):J.unknown]);const o=r.map(([a,l])=>`<dt>${a}</dt><dd>${l}</dd>`).join("");Qe("link-counts").innerHTML!==o&&(Qe("link-counts").innerHTML=o)}function jg(n,t,e,i,s){const{pen:r,w:o,h:a,rem:l}=Kr(n),[c,u]=[o/2,a/2];r.strokeStyle="#dbe5ee90",r.beginPath(),r.moveTo(c-o*.3,u),r.lineTo(c-l,u),r.moveTo(c+l,u),r.lineTo(c+o*.3,u),r.moveTo(c,u-a*.36),r.lineTo(c,u-l),r.moveTo(c,u+l),r.lineTo(c,u+a*.36);for(let g=-3;g<=3;g+=1)g&&(r.moveTo(c+g*o*.1,u-l*.25),r.lineTo(c+g*o*.1,u+l*.25));r.stroke();const h=t.known(e.carried_by);if(!h)return;const f=h.item.role==="truth";for(const g of e.marks){const v=Si(i,g.at),m=v&&!(f&&g.role==="predicted")&&t.onCamera(v);if(!m)continue;const p=Xt[g.role],[y,T]=[c+m[0]*o/2,u-m[1]*a/2];if(r.strokeStyle=p,g.radius_m===null){sp.square(r,y,T,p,l);continue}const x=Math.max(Ii(e.look,v)-Ii(e.look,h.at),.05);Or(r,y,T,Math.min(g.radius_m/x/t.cameraTan*(a/2),a),p),r.strokeStyle=`${p}80`,r.beginPath(),r.moveTo(c,u),r.lineTo(y,T),r.stroke()}if(e.pixels&&zg(r,{w:o,h:a,rem:l},e.pixels,i,t.cameraTan),e.gauge&&Zg(r,o,a-s,l,e.gauge,i,f),e.numbers)return;const d=e.distance.map(g=>On(i,g.value)).find(g=>g!==void 0);d!==void 0&&Ke(r,`${Re(d,e.digits)} ${e.unit}`,l*.6,a-l*.9,Xt.measured)}function Zg(n,t,e,i,s,r,o){const[a,l,c]=[t-i*2.9,i*1.5,e-i*1.2],{low:u,high:h}=s,f=d=>c-(Math.max(u,Math.min(h,d))-u)/(h-u)*(c-l);n.strokeStyle="#dbe5eea0",n.beginPath(),n.moveTo(a,l),n.lineTo(a,c);for(let d=0;u+d*s.tick<=h+1e-9;d+=1){const g=f(u+d*s.tick),v=d%s.long_ticks===0;n.moveTo(a,g),n.lineTo(a+i*(v?.5:.25),g),v&&Ke(n,Re(u+d*s.tick,s.digits),a+i*.65,g,Xt.text)}n.stroke(),s.limit!==null&&(n.strokeStyle=Xt.alarm,n.beginPath(),n.moveTo(a-i*.5,f(s.limit)),n.lineTo(a+i*.5,f(s.limit)),n.stroke());for(const{role:d,value:g}of s.readings){const v=On(r,g);if(v===void 0||o&&d!=="truth")continue;const m=f(v),p=Xt[d==="truth"?"measured":d];n.beginPath(),n.moveTo(a-i*.1,m),n.lineTo(a-i*.75,m-i*.36),n.lineTo(a-i*.75,m+i*.36),n.closePath(),d==="predicted"?(n.strokeStyle=p,n.stroke()):(n.fillStyle=p,n.fill())}Ke(n,s.unit,a,l-i*.7,Xt.dim,"center")}const Uh={warning:{every:900,notes:[[960,0],[720,.16]]},caution:{every:3e3,notes:[[520,0]]}},[bl,Nh]=[.13,.12];class Jg{constructor(){Object.assign(this,{on:!1,context:null,level:"",at:-1/0,sung:0})}toggle(){if(this.on=!this.on,this.on&&!this.context){const t=window.AudioContext||window.webkitAudioContext;t&&(this.context=new t)}this.context?.resume(),this.at=-1/0}sing(t,e){if(t!==this.level&&(this.at=-1/0),this.level=t,!(!this.on||!t||!this.context||e-this.at<Uh[t].every)){this.at=e,this.sung+=1;for(const[i,s]of Uh[t].notes)this.note(i,s)}}note(t,e){const{context:i}=this,s=i.currentTime+e,[r,o]=[i.createOscillator(),i.createGain()];r.frequency.value=t,o.gain.setValueAtTime(0,s),o.gain.linearRampToValueAtTime(Nh,s+.015),o.gain.setValueAtTime(Nh,s+bl-.03),o.gain.linearRampToValueAtTime(0,s+bl),r.connect(o).connect(i.destination),r.start(s),r.stop(s+bl)}}const Gi=n=>document.getElementById(n),Qg=100;class t_{constructor(t){this.store=t,this.alarms=new bg,this.sound=new Jg,this.run=null,Gi("alarm-ack").onclick=()=>this.acknowledge(),Gi("alarm-sound").onclick=()=>this.toggleSound(),this.look(),setInterval(()=>this.look(),Qg)}acknowledge(){this.alarms.acknowledge(),this.look()}toggleSound(){this.sound.toggle(),this.look()}look(){const{store:t,alarms:e}=this,i=performance.now(),{run:s,frame:r,display:o,status:a}=t;if(s!==this.run&&e.clear(),this.run=s,!(s&&r&&!t.verdict&&a.phase==="flying"))e.clear();else if(!r.paused||!t.connected){const c={run:s,frame:r,measured:t.measured,sent:t.sent,silence:t.silence(),connected:t.connected,pilotLost:a.pilot_lost};e.judge([...Eg(c,xo),...yg(r,o.alarms,u=>e.stands(u))],i/1e3)}this.show(),this.sound.sing(e.loud,i)}show(){const t=[...this.alarms.standing.values()].length?this.alarms.shown:[],[e,...i]=t;Gi("alarms").className=e?e.acknowledged?"seen":e.level:"",$e(Gi("alarm-words"),e?e.words:xo.none),$e(Gi("alarm-detail"),e?e_(e):""),$e(Gi("alarm-more"),i.map(s=>s.words).join(" · ")),Gi("alarm-ack").disabled=!this.alarms.loud,$e(Gi("alarm-sound"),this.sound.on?xo.sound_on:xo.sound_off),Gi("alarm-sound").setAttribute("aria-pressed",String(this.sound.on))}}function e_({seen:n,age:t}){if(t!==void 0)return Me(J.age,{s:Re(t,1)});if(!n?.label)return"";const e=n.unit?` ${n.unit}`:"",i=n.role==="plain"?"":`${J.columns[n.role]} `;return Me(xo.beyond,{said:i,label:n.label,value:`${Re(n.value,n.digits)}${e}`,limit:Re(n.limit,n.digits)})}function re(n){const t=document.createElement("span");return t.textContent=n,t.innerHTML.replaceAll('"',"&quot;")}function n_(n,t){const e=n.gates.findIndex(s=>t===void 0||s.at<t),i=n.gates.map((s,r)=>({at:`${Re(s.at,Number.isInteger(s.at)?0:1)} ${n.unit}`,wanted:s.wanted,next:r===e&&t!==void 0}));return n.contact.length?[...i,{at:n.contact_label,wanted:n.contact,next:t!==void 0&&e<0}]:i}function rp(n,t){const e=n_(n,t).map(({at:i,wanted:s,next:r})=>`<tr class="${r?"next":""}"><th>${re(i)}</th><td>${re(s.join(", "))}</td></tr>`);return`<h4>${np.good}</h4><table>${e.join("")}</table>`}const Ta=()=>document.getElementById("modes"),i_=(n,t)=>(n?.modes||[]).find(e=>e.name===t),s_=(n,t)=>t?`${n} (${t.replace(/^Key/,"")})`:n,op=(n,t)=>i_(n,t)?.label??t,r_=(n,t)=>(n?.modes||[]).find(e=>e.key&&e.key===t),ap=n=>(n?.modes||[]).filter(t=>!t.key);function o_(n,t){Ta().hidden=!n.modes.length,Ta().classList.toggle("told",n.on_board!==null),Ta().replaceChildren(...n.modes.map(e=>{const i=document.createElement("button");return i.dataset.mode=e.name,i.title=e.words,i.textContent=s_(e.label,e.key),n.on_board&&i.append(document.createElement("small")),i.onclick=()=>t(e.name),i}))}function lp(n,t,e,i){const s=ci(t,n?.on_board);for(const r of Ta().children){const[o,a]=[r.dataset.mode===e,r.dataset.mode===s];r.disabled=!i,r.setAttribute("aria-pressed",String(o));const l=r.querySelector("small");l&&$e(l,[o?J.mode_ground:"",a?J.mode_board:""].filter(Boolean).join(" · "))}}function a_(n){const t=ap(n).map(i=>i.label.toLowerCase()).join(", "),e=(n?.modes||[]).filter(i=>i.key).map(i=>[i.key.replace(/^Key/,""),i.words||i.label]);return t?[["M",Me(J.mode_turn,{modes:t})],...e]:e}const Ao=()=>document.getElementById("dialog");function js(n,t){const e=Ao();e.innerHTML=n,e.open||e.showModal();for(const i of e.querySelectorAll("[data-close]"))i.onclick=()=>e.close();return t&&t(e),e}function wu(){Ao().open&&Ao().close()}const Lo=`<button data-close>${J.close}</button>`;function Tu(n,t){js(`<h3>${re(n)}</h3><p>${re(t)}</p><div class="buttons">${Lo}</div>`)}const vc=n=>Rg[n]||n.replace(/^Key/,"");function cp(n){const t=n?.controller,e=(t?.axes||[]).map(s=>[s.keys.map(r=>r.map(vc).join(" / ")).join(` ${J.or} `),`${t.verb} ${s.positive} / ${s.negative} (${s.name})`]);for(const s of t?.buttons||[])e.push([vc(s.key),s.words]);const i=t?.key_deflections.length||0;return i>1&&e.push([Array.from({length:i},(s,r)=>r+1).join(" "),Me(J.help_step,{name:t.step_name})]),e}function up(n){const t=n?.abort?`: ${n.abort}`:"",[[e,i],...s]=Ag.map(([a,l])=>[a,Me(l,{abort:t})]),r=[[e,i],...cp(n),...a_(n),...s].map(([a,l])=>a?`<tr><td><kbd>${re(a)}</kbd></td><td>${re(l)}</td></tr>`:`<tr><td colspan="2">${re(l)}</td></tr>`),o=n?.guidance?rp(n.guidance):"";js(`<h3>${J.help_title}</h3><table>${r.join("")}</table>${o}<div class="buttons">${Lo}</div>`)}function Au(n){return Lg[n]||n}function l_(n,t){const e=n.fields.map(i=>{const s=`${i.section} ${i.key}`,r=t[s]??i.value,o=`data-setting="${re(s)}" title="${re(`${i.key}: ${i.hint}`)}"`,a=i.choices.length?`<select ${o}>${i.choices.map(l=>`<option ${l===r?"selected":""}>${re(l)}</option>`).join("")}</select>`:`<input ${o} value="${re(r)}" maxlength="200">`;return`<label>${re(i.label)} ${a} <span class="dim">${re(i.unit)}</span></label>`});return`<fieldset><legend>${re(n.title)}</legend>${e.join("")}</fieldset>`}function c_(n,t){const e={};for(const i of t)for(const s of i.fields){const r=`${s.section} ${s.key}`,o=[...n.querySelectorAll("[data-setting]")].find(a=>a.dataset.setting===r).value;o.trim()!==s.value&&(e[r]=o)}return e}let Fh={};function u_(n,t,e=""){if(!n.can.fly){Tu(J.new_run,J.no_fly);return}const i=n.display?.modes||[],s=n.display?.forms||[],r=n.frame?.mode||n.run?.mode||n.asked,o=i.map(a=>`<option value="${a.name}" ${a.name===r?"selected":""}>${re(a.label)}</option>`);js(`<h3>${J.new_run}</h3><p>${J.new_run_text}</p>
    <p>${i.length?`<label>${J.mode} <select id="new-mode">${o.join("")}</select></label> &nbsp;`:""}
    <label>${J.seed} <input id="new-seed" size="15" inputmode="numeric" placeholder="${J.seed_hint}"></label></p>
    <div class="forms">${s.map(a=>l_(a,Fh)).join("")}</div>
    <p id="new-error" class="alarm" role="alert">${re(e)}</p>
    <div class="buttons"><button data-close>${J.cancel}</button><button class="primary" id="new-start">${J.start}</button></div>`,a=>{a.classList.toggle("wide",s.length>0),a.onclose=()=>a.classList.remove("wide");const l=async()=>{const c=a.querySelector("#new-seed").value.trim(),u={do:"fly",mode:a.querySelector("#new-mode")?.value??null};c&&(u.seed=Number(c)),s.length&&(u.settings=Fh=c_(a,s));const h=await t(u);h.ok?a.close():a.querySelector("#new-error").textContent=Au(h.code)};a.querySelector("#new-start").onclick=l,a.querySelector("#new-seed").onkeydown=c=>{c.key==="Enter"&&l()},a.querySelector("#new-start").focus()})}function h_(n,t,e){const i=n.success,s=(o,a,l,c)=>`<tr><th>${re(o)}</th><td class="${c===!1?"alarm":""}">${re(a)}</td><td class="dim">${re(l)}</td></tr>`,r=n.measures.filter(o=>o.value!==null).map(o=>s(o.words,`${Re(o.value,o.digits)} ${o.unit}`,ip(null,o,o.digits),o.ok));js(`<h3>${J.verdict_title}</h3>
    <p class="verdict ${i?"ok":"alarm"}" id="verdict-words">${i?"✓":"✗"} ${re(Do(n.words))}</p>
    <table>${s(J.verdict_time,`${Re(n.duration,1)} s`,"",null)}${r.join("")}</table>
    <div class="buttons">${Lo}${t?`<button class="primary" id="again">${J.fly_again}</button>`:""}</div>`,o=>{const a=o.querySelector("#again");a&&(a.onclick=()=>{o.close(),e()})})}function f_(){return Ao().open&&Ao().querySelector("#runs")!==null}const Do=n=>n.charAt(0).toUpperCase()+n.slice(1);function d_(n,t){const e=n.map(i=>`<tr><td>${re(i.name)}</td><td>${re(i.mode||"")}</td>
    <td class="${i.success?"ok":""}">${i.success?"✓":"✗"} ${re(Do((i.reason||"").replaceAll("_"," ")))}</td>
    <td><button data-run="${re(i.name)}">${J.review_open}</button></td></tr>`);js(`<h3 id="runs">${J.review_title}</h3><p class="dim">${J.review_truth}</p>
    ${n.length?`<table>${e.join("")}</table>`:`<p>${J.review_none}</p>`}
    <p id="review-error" class="alarm"></p><div class="buttons">${Lo}</div>`,i=>{for(const s of i.querySelectorAll("[data-run]"))s.onclick=()=>t(s.dataset.run,i.querySelector("#review-error"))})}const fr=n=>document.getElementById(n),Oh=5,p_=.12;class m_{constructor(t,e,i){Object.assign(this,{store:t,scene:e,stick:i,run:null,moved:!1,caps:[],said:"",display:null})}heard({held:t,at:e}){this.store.run!==this.run&&Object.assign(this,{run:this.store.run,moved:!1}),this.store.status.phase==="flying"&&t&&e.some(i=>i!==0)&&(this.moved=!0)}wanted(t){const{store:e}=this,i=e.status.phase==="flying",s=["idle","starting","refused"].includes(e.status.phase);return!t&&e.status.lease==="you"&&!!e.display?.controller&&(s&&!e.can.desk||i&&!this.moved&&!e.verdict)}show(t){const{display:e,frame:i}=this.store,s=this.wanted(t);if(fr("coach").hidden=!s,!s)return;e!==this.display&&this.build(e);const r=e.guidance?.distance.map(c=>On(i,c)).find(c=>c!==void 0);this.place(i);const o=fr("coach-caps").hidden?[]:e.controller.axes.map(c=>c.along&&c.keys.length>0),a=this.stick.source==="keyboard"?cp(e).filter((c,u)=>!o[u]).map(([c,u])=>`<tr><th><kbd>${re(c)}</kbd></th><td>${re(u)}</td></tr>`).join(""):"",l=(e.guidance?rp(e.guidance,r):"")+(a?`<h4 class="keys">${np.keys}</h4><table class="keys">${a}</table>`:"");l!==this.said&&(this.said=l,fr("coach-card").innerHTML=l)}build(t){this.display=t,this.caps=[];for(const e of t.controller.axes.filter(i=>i.along&&i.keys.length))[[e.keys[0][0],e.positive,1],[e.keys[0][1],e.negative,-1]].forEach(([i,s,r])=>{const o=document.createElement("span");o.innerHTML=`<kbd>${re(vc(i))}</kbd> ${re(s)}`,this.caps.push({cap:o,towards:Yr[e.along].map(a=>a*r)})});fr("coach-caps").replaceChildren(...this.caps.map(({cap:e})=>e))}place(t){const{scene:e,stick:i}=this,s=e.moving?.find(({item:u})=>u.kind==="body"&&u.role==="measured"),r=s&&Si(t,s.item.place,s.item.axes),o=r&&e.onView(r);if(fr("coach-caps").hidden=!o||i.source!=="keyboard",fr("coach-caps").hidden)return;const a=this.caps.map(({towards:u})=>{const h=e.onView(r.map((f,d)=>f+.5*u[d]));return h?[h[0]-o[0],h[1]-o[1]]:[0,0]}),l=Math.max(...a.map(([u,h])=>Math.hypot(u,h)),1e-9),c=parseFloat(getComputedStyle(document.documentElement).fontSize);this.caps.forEach(({cap:u},h)=>{const f=Math.hypot(...a[h]);u.hidden=f<p_*l,!u.hidden&&(u.style.left=`${Math.round(o[0]+a[h][0]/f*Oh*c*1.25)}px`,u.style.top=`${Math.round(o[1]+a[h][1]/f*Oh*c)}px`)})}}const we=J.desk,g_=5;class __{constructor(t){this.link=t,this.task={hint:"",goal:"",display:null},this.state=null,this.mine=!1}show(t,e){const i=!this.state||JSON.stringify({...this.state,rest_s:0})!==JSON.stringify({...t,rest_s:0});this.state=t,this.mine=e,i&&this.draw()}lease(t){t!==this.mine&&(this.mine=t,this.state&&this.draw())}draw(){if(clearInterval(this.timer),!this.mine)return;const t=this.state.stage;t==="flying"?wu():this[t]()}async ask(t,e,i){const s=await this.link.ask({do:"desk",act:t,...e}),r=i?.querySelector(".error");return!s.ok&&r&&(r.textContent=we.errors[s.code]||Au(s.code)),s.ok}frame(t,e,i,s){const r=js(`<h3>${re(t)}</h3>${e}<p class="error alarm" role="alert"></p><div class="buttons">${i}</div>`,s);return r.oncancel=o=>o.preventDefault(),r}door(){this.frame(this.state.title,`<p>${we.door}</p><p><label>${we.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,`<button class="primary" id="desk-go">${we.begin}</button>`,t=>{const e=()=>this.ask("begin",{volunteer:Number(t.querySelector("#volunteer").value)},t);t.querySelector("#desk-go").onclick=e,t.querySelector("#volunteer").onkeydown=i=>{i.key==="Enter"&&e()},t.querySelector("#volunteer").focus()})}heading(){return Me(we.heading,{who:this.state.who,n:this.state.number,of:this.state.of})}ready(){const t=this.state.training?we.training:we.counts;this.frame(this.heading(),`<p>${t}</p><p>${Me(we.condition,{mode:re(op(this.task.display,this.state.mode))})}</p><p class="dim">${re(this.task.hint)} ${we.clock}</p>`,`<button class="primary" id="desk-go">${we.fly}</button>`,e=>{e.querySelector("#desk-go").onclick=()=>this.ask("fly",{},e),e.querySelector("#desk-go").focus()})}rest(){const t=performance.now()+this.state.rest_s*1e3;this.frame(we.rest_title,`<p>${we.rest}</p><p class="verdict" id="rest-left"></p>`,`<button class="primary" id="desk-go">${we.go_on}</button>`,e=>{const i=e.querySelector("#desk-go");i.onclick=()=>this.ask("go_on",{},e);const s=()=>{const r=Math.max(0,(t-performance.now())/1e3);e.querySelector("#rest-left").textContent=`${r.toFixed(0)} s`,i.disabled=r>0};s(),this.timer=setInterval(s,500)})}done(){this.frame(we.done_title,`<p>${Me(we.done,{who:this.state.who})}</p>`,`<button id="desk-go">${we.next}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("leave",{},t)})}rate(){this.answers={},this.question("controllable")}question(t){const{verdict:e}=this.state,i=`<button data-answer="yes">${we.yes}</button><button data-answer="no">${we.no}</button>`;this.frame(`${this.heading()} · Cooper-Harper`,`<p class="${e.success?"ok":""}">${re(Do(e.words||""))}</p><p>${re(Me(we.tree[t],{goal:this.task.goal}))}</p>`,i,s=>{s.querySelector("[data-answer=yes]").focus();for(const r of s.querySelectorAll("[data-answer]"))r.onclick=()=>this.answered(t,r.dataset.answer==="yes")})}answered(t,e){const i=["controllable","adequate","satisfactory"];if(this.answers[t]=e,!e)for(const r of i.slice(i.indexOf(t)+1))this.answers[r]=!1;const s=i[i.indexOf(t)+1];e&&s?this.question(s):this.pick()}pick(){const{controllable:t,adequate:e,satisfactory:i}=this.answers,r=(t?e?i?[1,2,3]:[4,5,6]:[7,8,9]:[10]).map(o=>`<button data-rating="${o}"><b>${o}</b> ${we.ratings[o]}</button>`).join("");this.frame(`${this.heading()} · Cooper-Harper`,`<p>${we.pick}</p><div class="choices">${r}</div>`,`<button id="desk-back">${we.again}</button>`,o=>{o.querySelector("#desk-back").onclick=()=>this.rate();for(const a of o.querySelectorAll("[data-rating]"))a.onclick=()=>{this.answers.rating=Number(a.dataset.rating),this.tlx()};o.querySelector("[data-rating]").focus()})}tlx(){const t=Object.entries(we.tlx).map(([e,[i,s,r,o]])=>`<fieldset><legend>${i}</legend>
      <label for="tlx-${e}">${s}</label><input type="range" id="tlx-${e}" data-tlx="${e}" min="0" max="100" step="${g_}" value="50">
      <div class="scale-ends"><span>${r}</span><output id="out-${e}">–</output><span>${o}</span></div></fieldset>`).join("");this.frame(`${this.heading()} · NASA-TLX`,t,`<button class="primary" id="desk-go" disabled>${we.save}</button>`,e=>{const i=new Set,s=r=>{i.add(r.dataset.tlx),e.querySelector(`#out-${r.dataset.tlx}`).textContent=r.value,e.querySelector("#desk-go").disabled=i.size<Object.keys(we.tlx).length};for(const r of e.querySelectorAll("[data-tlx]"))r.oninput=()=>s(r),r.onkeydown=o=>{o.key==="Enter"&&s(r)},r.onpointerup=()=>s(r);e.querySelector("#desk-go").onclick=()=>{const r=Object.fromEntries([...e.querySelectorAll("[data-tlx]")].map(o=>[o.dataset.tlx,Number(o.value)]));this.ask("rate",{cooper_harper:this.answers,tlx:r},e)}})}weigh(t=[]){const{pairs:e}=this.state,i=e[t.length].map(r=>`<button data-scale="${r}"><b>${we.tlx[r][0]}</b> ${we.tlx[r][1]}</button>`).join(""),s=`${this.heading()} · NASA-TLX · ${Me(we.pair,{n:t.length+1,of:e.length})}`;this.frame(s,`<p>${we.weigh}</p><div class="choices">${i}</div>`,`<button id="desk-back">${we.again}</button>`,r=>{r.querySelector("#desk-back").onclick=()=>this.weigh();for(const o of r.querySelectorAll("[data-scale]"))o.onclick=()=>{const a=[...t,o.dataset.scale];a.length<e.length?this.weigh(a):this.ask("weigh",{chosen:a},r)};r.querySelector("[data-scale]").focus()})}}const[Ru,hp,ja,Ro,Cu,Pu,Lu]=[0,1,2,3,4,5,6],Dr=3,v_=44,fp=6,kh={[ja]:"✓",[Ro]:"✓",[Cu]:"✗",[Pu]:"✗",[Lu]:"?"};function dp([n,t,e,i,s,r,o,...a]){return{seq:n,sent:t,due:e,kind:i,state:s,refusal:r,told:o,value:a}}function x_(n,t){return n.told>=0&&n.told<=t?n:{...n,state:t<n.due?Ru:hp,told:-1}}const M_=n=>n.kind===Dr&&(n.state===ja||n.state===Ro);function S_(n,t,e){const i=e.step_s,s=Math.max(n.due-n.sent,1);if(n.told>=0)return .8+.2*Math.min(1,(t-n.told)*i/fp);if(t<n.due)return .05+.37*((t-n.sent)/s);const r=Math.max(e.back_s/i,1);return .46+.34*Math.min(1,(t-n.due)/r)}function y_(n,t,e,i,s){const{pen:r,w:o,h:a,rem:l}=Kr(n),c=s/t.step_s,u=l*1.35,[h,f,d,g,v]=o<v_*l?J.ladder_narrow:[J.ladder_ground,J.ladder_link,J.ladder_craft,J.ladder_back,J.ladder_known],m=[[0,.05,h],[.05,.42,f],[.42,.5,d],[.5,.8,g],[.8,1,v]];for(const[x,U,A]of m)r.fillStyle=A===d?"#17222e":"#0a1018",r.fillRect(x*o+1,u,(U-x)*o-2,a-u),x!==0&&Ke(r,A,(x+U)/2*o,l*.55,Xt.dim,"center");Ke(r,h,0,l*.55,Xt.dim);const p=(a-u)/e.length;e.forEach((x,U)=>Ke(r,x.name,l*.35,u+p*(U+.5),Xt.dim));const y=Math.max(2,.37*o/Math.max(t.forward_s/t.step_s,8)-1),T={top:u,lane:p,bottom:a,width:Math.min(y,l),rem:l};for(const x of i){const U=S_(x,c,t);U>=1||x.told>=0&&(c-x.told)*t.step_s>fp||E_(r,x,U*o,e,T)}}function E_(n,t,e,i,{top:s,lane:r,bottom:o,width:a,rem:l}){const c=t.state===Cu||t.state===Pu,u=t.value.some(f=>f!==0),h=t.kind===Dr||c?Xt.alarm:t.state===Ro||t.state===ja?Xt.ok:t.state===Lu?Xt.dim:t.state===hp?Xt.predicted:Xt.measured;if(n.fillStyle=h,!u&&!c&&t.kind!==Dr){n.globalAlpha=t.state===Ro?.25:.5,i.forEach((f,d)=>n.fillRect(e,s+r*(d+.5)-1,Math.max(a*.5,1),2)),n.globalAlpha=1;return}(t.kind===Dr||c)&&n.fillRect(e,s,Math.max(1.5,a*.4),o-s),i.forEach((f,d)=>{const g=t.value[d];if(!g)return;const v=Math.min(Math.abs(g)/f.highest,1)*r*.46,m=s+r*(d+.5);t.state===Ru&&(n.globalAlpha=.85),n.fillRect(e,g>0?m-v:m,a,v),n.globalAlpha=1}),kh[t.state]&&c&&Ke(n,kh[t.state],e,s+l*.4,h)}function b_(n){const t={};for(const s of n)t[s.state]=(t[s.state]||0)+1;const i=[`${t[Ru]||0} ${J.ladder_link}`];for(const s of[ja,Ro,Cu,Pu,Lu])t[s]&&i.push(`${t[s]} ${Pg[s]}`);return i.join(" · ")}function w_(n){const t=document.getElementById("top"),e=new ResizeObserver(()=>{document.documentElement.style.setProperty("--top",`${t.offsetHeight}px`),n.resize()});for(const i of["top","app"])e.observe(document.getElementById(i))}const Bh=2500,T_=500,A_=800,R_=8e3,C_=n=>new Promise(t=>{setTimeout(t,n)});class P_{constructor(t,e){Object.assign(this,{link:t,store:e,wanted:null,unanswered:null})}async steer(t){this.unanswered=null,(await this.link.ask({...t,run:this.store.run?.name},Bh)).code==="NO_ANSWER"&&(this.unanswered={wish:t,at:performance.now()})}async abort(){const t=this.store.run?.name;if(this.wanted&&!this.wanted.accepted&&this.goesOn(this.wanted))return;const e={run:t,times:0,since:performance.now(),accepted:!1};this.wanted=e;do{e.times+=1;const i=await this.link.ask({do:"abort",run:t},Bh);e.accepted=i.ok,i.ok||await C_(T_)}while(!e.accepted&&this.goesOn(e))}goesOn({run:t}){const{store:e}=this;return e.run!==null&&e.run.name===t&&!e.verdict&&(e.status.phase==="flying"||!e.connected)}words(){const{store:t,wanted:e,unanswered:i}=this,s=t.connected?"":`${J.socket_closed}. `;if(e&&!this.goesOn(e))this.wanted=null;else{if(e&&!e.accepted)return performance.now()-e.since<A_?[J.abort_asked,""]:[J.abort_unconfirmed,s+Me(J.abort_again,{n:e.times})];if(e&&t.abortAt===null&&t.connected)return[J.abort_accepted,t.frame?.paused?J.paused:""]}if(!i||performance.now()-i.at>R_||this.done(i.wish))return null;const r=i.wish.do==="mode"?op(t.display,i.wish.mode):J[i.wish.do];return[Me(J.unconfirmed,{name:r.toUpperCase()}),s+J.unconfirmed_hint]}done(t){const{frame:e,verdict:i,connected:s}=this.store;return i?!0:!e||!s?!1:t.do==="mode"?e.mode===t.mode:!!e.paused==(t.do==="pause")}}const L_=20,D_=4,pp="rvd.stick",Oa=-1;function zh(n,t){if(!Number.isFinite(n))return 0;const e=Math.min(Math.abs(n),1);return e<=t?0:Math.sign(n)*(e-t)/(1-t)}class I_{constructor(t){this.onChange=t,this.down=new Set,this.step=1,this.source="keyboard",this.pads=[],this.gamepad=null,this.settingUp=!1,this.settings=N_(),this.setController(null),addEventListener("keydown",i=>this.key(i,!0)),addEventListener("keyup",i=>this.key(i,!1));const e=()=>{this.down.clear(),this.send(!0)};addEventListener("blur",e),document.addEventListener("visibilitychange",e),setInterval(()=>this.poll(),L_)}setController(t){this.axes=t?.axes||[],this.deflections=t?.key_deflections||[1],this.step=Math.min(this.step,this.deflections.length),this.keys=new Map,this.buttons=t?.buttons||[],this.axes.forEach((e,i)=>e.keys.forEach(([s,r])=>this.keys.set(s,[i,1]).set(r,[i,-1]))),this.disarm()}taken(){this.down.clear(),this.disarm()}disarm(){this.armed=this.axes.map(()=>!1)}wiring(t,e){const i=this.settings.pads[t.id]?.axes[e.name];return i?i.axis<t.axes.length?i:null:t.mapping==="standard"&&e.pad_pair?e.pad_pair.every(s=>s<t.buttons.length)?{pair:e.pad_pair,sign:1}:null:t.mapping!=="standard"||e.pad_axis>=t.axes.length?null:{axis:e.pad_axis,sign:e.pad_inverted?-1:1}}button(t){const e=this.settings.pads[t.id]?.button??(t.mapping==="standard"?D_:null);return e!==null&&e<t.buttons.length?e:null}ready(t){return!this.settingUp&&this.button(t)!==null&&this.axes.every(e=>this.wiring(t,e)!==null)}lacks(){return this.pads.length?this.gamepad?this.ready(this.gamepad)?"":"setup":"choose":""}pick(t){this.change({chosen:{id:t.id,index:t.index??0}})}setUp(t,{axes:e={},button:i}){const s=this.settings.pads[t.id]||{axes:{},button:null},r={axes:{...s.axes,...e},button:i??s.button};this.change({pads:{...this.settings.pads,[t.id]:r}})}change(t){this.settings={...this.settings,...t},this.disarm(),fg("local",pp,JSON.stringify(this.settings))}choose(){const{chosen:t}=this.settings,e=this.pads.filter(i=>i.id===t?.id);return e.length===1?e[0]:e.length>1?e.find(i=>i.index===t.index)||null:this.pads.length===1?this.pads[0]:null}deflection(t){return this.axes.map(e=>{const i=this.wiring(t,e);return i?i.pair?zh(Vh(t,i.pair[0])-Vh(t,i.pair[1]),this.settings.deadZone):i.axis===Oa?0:i.sign*zh(t.axes[i.axis],this.settings.deadZone):null})}key(t,e){if(t.ctrlKey||t.metaKey||t.altKey||mp(t.target)||e&&t.target instanceof Element&&t.target.closest("input, select, dialog"))return;const i=Number(/^(?:Digit|Numpad)([1-9])$/.exec(t.code)?.[1]);if(e&&i<=this.deflections.length){this.step=i,this.send(!0);return}const s=this.buttons.some(o=>o.key===t.code);if(!this.keys.has(t.code)&&!s&&t.code!=="Space"||t.code==="Space"&&!this.settings.holdSpace||(t.preventDefault(),t.repeat))return;const r=this.down.has(t.code);e?this.down.add(t.code):this.down.delete(t.code),e&&(this.source="keyboard"),r!==e&&this.send(!0)}poll(){this.pads=U_();const t=this.choose();(t?.id!==this.gamepad?.id||t?.index!==this.gamepad?.index)&&this.disarm(),this.gamepad=t,t&&this.ready(t)&&wl(t,this.button(t))&&(this.source="gamepad"),this.holds()?this.deflection(t).forEach((e,i)=>{e===0&&(this.armed[i]=!0)}):this.disarm(),this.send(!1)}holds(){const t=this.gamepad;return this.source==="gamepad"&&Hh()&&t!==null&&this.ready(t)&&wl(t,this.button(t))}gone(){return this.source==="gamepad"&&this.gamepad===null}stuck(){return this.holds()?this.axes.filter((t,e)=>!this.armed[e]).map(t=>t.name):[]}pressed(){const t=this.source==="gamepad"?this.gamepad:null;return this.buttons.reduce((e,i,s)=>{const r=t?t.mapping==="standard"&&wl(t,i.pad_button):this.down.has(i.key);return e|(r?1<<s:0)},0)}withButtons(t){return this.buttons.length?{...t,buttons:this.pressed()}:t}state(){if(this.source==="gamepad"){const i=this.holds();return this.withButtons({held:i,at:i?this.deflection(this.gamepad).map((s,r)=>this.armed[r]?s:0):this.axes.map(()=>0)})}const t=this.axes.map(()=>0);for(const i of this.down)this.keys.has(i)&&(t[this.keys.get(i)[0]]+=this.keys.get(i)[1]);const e=this.deflections[this.step-1];return this.withButtons({held:Hh()&&(!this.settings.holdSpace||this.down.has("Space")),at:t.map(i=>Math.max(-1,Math.min(1,i))*e)})}send(t){this.onChange(this.state(),t)}}const Hh=()=>document.visibilityState==="visible"&&document.hasFocus();function U_(){try{return[...navigator.getGamepads?.()||[]].filter(n=>n&&n.connected!==!1)}catch{return[]}}function wl(n,t){return!!n.buttons[t]?.pressed}function Vh(n,t){const e=n.buttons[t];return e?Math.max(e.value??0,e.pressed&&!e.value?1:0):0}function mp(n){return n instanceof Element&&!!n.closest("input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]")}function N_(){let n=null;try{n=JSON.parse(dg("local",pp))}catch{}const t={};for(const[e,i]of Object.entries(n?.pads??{})){const s=Object.entries(i?.axes??{}).filter(([,r])=>Number.isInteger(r?.axis)&&r.axis>=Oa&&Math.abs(r.sign)===1);t[e]={axes:Object.fromEntries(s),button:Number.isInteger(i?.button)&&i.button>=0?i.button:null}}return{pads:t,chosen:typeof n?.chosen?.id=="string"?n.chosen:null,holdSpace:n?.holdSpace===!0,deadZone:n?.deadZone>=0&&n.deadZone<=.4?Number(n.deadZone):.08}}const F_=60,[O_,Gh]=[.5,.3];function k_(n,t,e){if(t===null)return J.unknown;const{axes:i,digits:s}=n.commands;return i.length===n.controller.axes.length?_c(t*i[e].highest,s):_c(t,2)}class B_{constructor(t,e){Object.assign(this,{stick:t,display:e,seen:null,lead:null}),this.dialog=js(`<h3>${J.settings_title}</h3><p id="pad-note" role="status"></p>
      <fieldset id="pads"><legend>${J.settings_pads}</legend></fieldset><p id="pad-lead" role="status"></p><div id="pad-steps" class="buttons"></div>
      <table id="pad-axes"></table>
      <p><label>${J.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${t.settings.deadZone}"></label></p>
      <p><label><input type="checkbox" id="hold-space" ${t.settings.holdSpace?"checked":""}> ${J.settings_space}</label></p>
      ${Zd?"":`<p class="alarm">${J.no_storage}</p>`}<div class="buttons">${Lo}</div>`),this.body=this.$("#pads"),this.dialog.onchange=i=>this.changed(i.target),this.timer=setInterval(()=>this.look(),F_),this.look()}$(t){return this.dialog.querySelector(t)}look(){const{stick:t}=this;if(!this.dialog.open||!this.dialog.contains(this.body)){clearInterval(this.timer),t.settingUp=!1;return}const e=t.gamepad,i=JSON.stringify([t.pads.map(s=>[s.id,s.index]),e?.index,t.settings.pads,t.settings.chosen]);i!==this.seen&&(this.lead&&this.lead.index!==e?.index&&this.stop(),this.seen=i,this.build()),t.pads.forEach((s,r)=>$e(this.$(`[data-live="${r}"]`),Me(J.pad_live,{axes:s.axes.map(o=>Re(o,2)).join(" "),buttons:s.buttons.flatMap((o,a)=>o.pressed?[a]:[]).join(" ")||J.pad_nothing}))),e&&(t.deflection(e).forEach((s,r)=>$e(this.$(`[data-now="${t.axes[r].name}"]`),k_(this.display,s,r))),this.lead&&this.follow(e))}build(){const{stick:t}=this,e=t.gamepad;this.$("#pads").hidden=!t.pads.length,this.$("#pads").innerHTML=`<legend>${J.settings_pads}</legend>${t.pads.map((r,o)=>`<p><label><input type="radio" name="pad" value="${o}" ${r===e?"checked":""}>
      ${re(r.id)}${r.mapping==="standard"?"":` (${J.pad_plain})`}</label><br><small class="dim num" data-live="${o}"></small></p>`).join("")}`;const i=e&&t.ready(e),s=t.pads.length?e?i||this.lead?J.pad_ready:J.pad_setup:J.pad_choose:J.settings_none;$e(this.$("#pad-note"),this.lead?"":s),this.$("#pad-note").className=!e||i?"":"alarm",this.$("#pad-axes").innerHTML=e?this.table(e):"",this.lead||this.buttons(e&&t.axes.length?[["pad-start",J.pad_start,()=>this.begin(e)]]:[])}table(t){const{stick:e}=this;return`${e.axes.map(s=>{const r=e.wiring(t,s);return`<tr><td>${re(`${s.positive} / ${s.negative}`)}</td>
        <td>${r?.pair?`${Me(J.settings_pair,{plus:r.pair[0],minus:r.pair[1]})} `:""}<label>${J.settings_axis} <input type="number" class="short" min="${Oa}" max="${t.axes.length-1}" data-axis="${s.name}" value="${r?.axis??""}"></label></td>
        <td><label><input type="checkbox" data-invert="${s.name}" ${r?.sign<0?"checked":""}> ${J.settings_invert}</label></td>
        <td>${J.settings_now} <b data-now="${s.name}"></b></td></tr>`}).join("")}<tr><td>${J.settings_button}</td><td colspan="3"><input type="number" class="short" min="0" max="${t.buttons.length-1}"
      id="pad-button" aria-label="${J.settings_button}" value="${e.button(t)??""}"></td></tr>`}changed(t){const{stick:e}=this,i=e.gamepad;if(t.name==="pad")e.pick(e.pads[Number(t.value)]);else if(t.id==="pad-zone")e.change({deadZone:Number(t.value)});else if(t.id==="hold-space")e.change({holdSpace:t.checked});else if(i&&t.validity.valid&&(t.type==="checkbox"||t.value!=="")){const s=t.dataset.axis||t.dataset.invert;t.id==="pad-button"?e.setUp(i,{button:Number(t.value)}):s&&this.$(`[data-axis="${s}"]`).value!==""&&e.setUp(i,{axes:{[s]:{axis:Number(this.$(`[data-axis="${s}"]`).value),sign:this.$(`[data-invert="${s}"]`).checked?-1:1}}})}}buttons(t){this.$("#pad-steps").replaceChildren(...t.map(([e,i,s])=>{const r=document.createElement("button");return Object.assign(r,{id:e,textContent:i,onclick:s}),r}))}begin(t){this.stick.settingUp=!0,this.lead={index:t.index,at:-1,axes:{},back:null},this.seen=null,this.say(J.pad_rest),this.buttons([["pad-next",J.pad_next,()=>{Object.assign(this.lead,{rest:[...this.stick.gamepad.axes],down:this.stick.gamepad.buttons.map(e=>e.pressed)}),this.next()}],["pad-stop",J.pad_stop,()=>this.stop()]])}say(t){$e(this.$("#pad-lead"),t)}stop(){this.stick.settingUp=!1,this.lead=null,this.seen=null,this.say("")}next(){const{lead:t,stick:e}=this;t.at+=1;const i=e.axes[t.at];if(!i){this.say(J.pad_hold),this.buttons([["pad-stop",J.pad_stop,()=>this.stop()]]);return}this.say(Me(J.pad_move,{what:i.positive,name:i.name})),this.buttons([["pad-skip",J.pad_skip,()=>{t.axes[i.name]={axis:Oa,sign:1},this.next()}],["pad-stop",J.pad_stop,()=>this.stop()]])}follow(t){const{lead:e,stick:i}=this;if(e.at<0)return;const s=t.axes.map((c,u)=>c-e.rest[u]);if(e.back!==null){if(Math.abs(s[e.back])>Gh)return;e.back=null,this.next();return}const r=i.axes[e.at];if(!r){const c=t.buttons.findIndex((h,f)=>h.pressed&&!e.down[f]);if(c<0)return;const{axes:u}=e;this.stop(),i.setUp(t,{axes:u,button:c});return}const o=Object.values(e.axes).map(c=>c.axis),a=s.map((c,u)=>o.includes(u)?0:Math.abs(c)),l=a.indexOf(Math.max(...a));if(a[l]>O_){if(Math.abs(e.rest[l])>Gh){this.say(`${Me(J.pad_trigger,{axis:l})} ${Me(J.pad_move,{what:r.positive,name:r.name})}`);return}e.axes[r.name]={axis:l,sign:Math.sign(s[l])},e.back=l,this.say(J.pad_back)}}}function gp(n,t){return new B_(n,t)}const z_=!0,ln="u-",H_="uplot",V_=ln+"hz",G_=ln+"vt",W_=ln+"title",$_=ln+"wrap",X_=ln+"under",q_=ln+"over",Y_=ln+"axis",zs=ln+"off",K_=ln+"select",j_=ln+"cursor-x",Z_=ln+"cursor-y",J_=ln+"cursor-pt",Q_=ln+"legend",t0=ln+"live",e0=ln+"inline",n0=ln+"series",i0=ln+"marker",Wh=ln+"label",s0=ln+"value",Mo="width",So="height",uo="top",$h="bottom",dr="left",Tl="right",Du="#000",Xh=Du+"0",Al="mousemove",qh="mousedown",Rl="mouseup",Yh="mouseenter",Kh="mouseleave",jh="dblclick",r0="resize",o0="scroll",Zh="change",ka="dppxchange",Iu="--",jr=typeof window<"u",xc=jr?document:null,Ir=jr?window:null,a0=jr?navigator:null;let Ee,Xo;function Mc(){let n=devicePixelRatio;Ee!=n&&(Ee=n,Xo&&yc(Zh,Xo,Mc),Xo=matchMedia(`(min-resolution: ${Ee-.001}dppx) and (max-resolution: ${Ee+.001}dppx)`),$s(Zh,Xo,Mc),Ir.dispatchEvent(new CustomEvent(ka)))}function qn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Sc(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Be(n,t,e){n.style[t]=e+"px"}function gi(n,t,e,i){let s=xc.createElement(n);return t!=null&&qn(s,t),e?.insertBefore(s,i),s}function ii(n,t){return gi("div",n,t)}const Jh=new WeakMap;function Pi(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Jh.get(n);r!=o&&(n.style.transform=r,Jh.set(n,r),t<0||e<0||t>i||e>s?qn(n,zs):Sc(n,zs))}const Qh=new WeakMap;function tf(n,t,e){let i=t+e,s=Qh.get(n);i!=s&&(Qh.set(n,i),n.style.background=t,n.style.borderColor=e)}const ef=new WeakMap;function nf(n,t,e,i){let s=t+""+e,r=ef.get(n);s!=r&&(ef.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}const Uu={passive:!0},l0={...Uu,capture:!0};function $s(n,t,e,i){t.addEventListener(n,e,i?l0:Uu)}function yc(n,t,e,i){t.removeEventListener(n,e,Uu)}jr&&Mc();function _i(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:jn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function _p(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}const vp=n=>n!=null,xp=n=>n!=null&&n>0,Za=_p(vp),c0=_p(xp);function u0(n,t,e,i=0,s=!1){let r=s?c0:Za,o=s?xp:vp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??De,l??-De]}function Ja(n,t,e,i){let s=of(n),r=of(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ji:Mp,a=s==1?jn:ri,l=r==1?ri:jn,c=a(o(sn(n))),u=l(o(sn(t))),h=kr(e,c),f=kr(e,u);return e==10&&(c<0&&(h=Ie(h,-c)),u<0&&(f=Ie(f,-u))),i||e==2?(n=h*s,t=f*r):(n=bp(n,h),t=Qa(t,f)),[n,t]}function Nu(n,t,e,i){let s=Ja(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}const Fu=.1,sf={mode:3,pad:Fu},wo={pad:0,soft:null,mode:0},h0={min:wo,max:wo};function Ba(n,t,e,i){return tl(e)?rf(n,t,e):(wo.pad=e,wo.soft=i?0:null,wo.mode=i?3:0,rf(n,t,h0))}function xe(n,t){return n??t}function f0(n,t,e){for(t=xe(t,0),e=xe(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function rf(n,t,e){let i=e.min,s=e.max,r=xe(i.pad,0),o=xe(s.pad,0),a=xe(i.hard,-De),l=xe(s.hard,De),c=xe(i.soft,De),u=xe(s.soft,-De),h=xe(i.mode,0),f=xe(s.mode,0),d=t-n,g=Ji(d),v=In(sn(n),sn(t)),m=Ji(v),p=sn(m-g);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,h==2&&c!=De&&(r=0),f==2&&u!=-De&&(o=0)));let y=d||v||1e3,T=Ji(y),x=kr(10,jn(T)),U=y*(d==0?n==0?.1:1:r),A=Ie(bp(n-U,x/10),24),D=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:De,I=In(a,A<D&&n>=D?D:vi(D,A)),w=y*(d==0?t==0?.1:1:o),S=Ie(Qa(t+w,x/10),24),C=t<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-De,V=vi(l,S>C&&t<=C?C:In(C,S));return I==V&&I==0&&(V=100),[I,V]}const d0=new Intl.NumberFormat(jr?a0.language:"en-US"),Ou=n=>d0.format(n),Jn=Math,Aa=Jn.PI,sn=Jn.abs,jn=Jn.floor,nn=Jn.round,ri=Jn.ceil,vi=Jn.min,In=Jn.max,kr=Jn.pow,of=Jn.sign,Ji=Jn.log10,Mp=Jn.log2,p0=(n,t=1)=>Jn.sinh(n)*t,Cl=(n,t=1)=>Jn.asinh(n/t),De=1/0;function af(n){return(Ji((n^n>>31)-(n>>31))|0)+1}function Ec(n,t,e){return vi(In(n,t),e)}function Sp(n){return typeof n=="function"}function ae(n){return Sp(n)?n:()=>n}const m0=()=>{},yp=n=>n,Ep=(n,t)=>t,g0=n=>null,lf=n=>!0,cf=(n,t)=>n==t,_0=/\.\d*?(?=9{6,}|0{6,})/gm,Xs=n=>{if(Tp(n)||xs.has(n))return n;const t=`${n}`,e=t.match(_0);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Xs(s)}e${r}`}return Ie(n,i)};function Fs(n,t){return Xs(Ie(Xs(n/t))*t)}function Qa(n,t){return Xs(ri(Xs(n/t))*t)}function bp(n,t){return Xs(jn(Xs(n/t))*t)}function Ie(n,t=0){if(Tp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return nn(i)/e}const xs=new Map;function wp(n){return((""+n).split(".")[1]||"").length}function Co(n,t,e,i){let s=[],r=i.map(wp);for(let o=t;o<e;o++){let a=sn(o),l=Ie(kr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Ie(u,h);s.push(f),xs.set(f,h)}}return s}const To={},ku=[],Br=[null,null],ps=Array.isArray,Tp=Number.isInteger,v0=n=>n===void 0;function uf(n){return typeof n=="string"}function tl(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function x0(n){return n!=null&&typeof n=="object"}const M0=Object.getPrototypeOf(Uint8Array),Ap="__proto__";function zr(n,t=tl){let e;if(ps(n)){let i=n.find(s=>s!=null);if(ps(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=zr(n[s],t)}else e=n.slice()}else if(n instanceof M0)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Ap&&(e[i]=zr(n[i],t))}else e=n;return e}function Je(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Ap&&(tl(n[s])?Je(n[s],zr(i[s])):n[s]=zr(i[s]))}return n}const S0=0,y0=1,E0=2;function b0(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function w0(n,t){if(R0(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return C0(o[0])||(o=A0(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:y0,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?f!=S0&&(h[m]=v,f==E0&&d.push(m)):h[m]=v}b0(h,d,s),i.push(h)}}return i}const T0=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function A0(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function R0(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function C0(n,t=100){const e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=In(1,jn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const Rp=["January","February","March","April","May","June","July","August","September","October","November","December"],Cp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Pp(n){return n.slice(0,3)}const P0=Cp.map(Pp),L0=Rp.map(Pp),D0={MMMM:Rp,MMM:L0,WWWW:Cp,WWW:P0};function ho(n){return(n<10?"0":"")+n}function I0(n){return(n<10?"00":n<100?"0":"")+n}const U0={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ho(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ho(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ho(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ho(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ho(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>I0(n.getMilliseconds())};function Bu(n,t){t=t||D0;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?U0[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const N0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function F0(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==N0?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}const Lp=n=>n%1==0,za=[1,2,2.5,5],O0=Co(10,-32,0,za),Dp=Co(10,0,32,za),k0=Dp.filter(Lp),Os=O0.concat(Dp),zu=`
`,Ip="{YYYY}",hf=zu+Ip,Up="{M}/{D}",yo=zu+Up,qo=yo+"/{YY}",Np="{aa}",B0="{h}:{mm}",Rr=B0+Np,ff=zu+Rr,df=":{ss}",Te=null;function Fp(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Co(10,0,3,za).filter(Lp):Co(10,-3,0,za)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Ip,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",hf,Te,Te,Te,Te,Te,1],[s,Up,hf,Te,Te,Te,Te,Te,1],[i,"{h}"+Np,qo,Te,yo,Te,Te,Te,1],[e,Rr,qo,Te,yo,Te,Te,Te,1],[t,df,qo+" "+Rr,Te,yo+" "+Rr,Te,ff,Te,1],[n,df+".{fff}",qo+" "+Rr,Te,yo+" "+Rr,Te,ff,Te,1]];function u(h){return(f,d,g,v,m,p)=>{let y=[],T=m>=o,x=m>=r&&m<o,U=h(g),A=Ie(U*n,3),D=Pl(U.getFullYear(),T?0:U.getMonth(),x||T?1:U.getDate()),I=Ie(D*n,3);if(x||T){let w=x?m/r:0,S=T?m/o:0,C=A==I?A:Ie(Pl(D.getFullYear()+S,D.getMonth()+w,1)*n,3),V=new Date(nn(C/n)),N=V.getFullYear(),G=V.getMonth();for(let j=0;C<=v;j++){let K=Pl(N+S*j,G+w*j,1),Q=K-h(Ie(K*n,3));C=Ie((+K+Q)*n,3),C<=v&&y.push(C)}}else{let w=m>=s?s:m,S=jn(g)-jn(A),C=I+S+Qa(A-I,w);y.push(C);let V=h(C),N=V.getHours()+V.getMinutes()/e+V.getSeconds()/i,G=m/i,j=f.axes[d]._space,K=p/j;for(;C=Ie(C+m,n==1?0:3),!(C>v);)if(G>1){let Q=jn(Ie(N+G,6))%24,ct=h(C).getHours()-Q;ct>1&&(ct=-1),C-=ct*i,N=(N+G)%24;let mt=y[y.length-1];Ie((C-mt)/m,3)*K>=.7&&y.push(C)}else y.push(C)}return y}}return[l,c,u]}const[z0,H0,V0]=Fp(1),[G0,W0,$0]=Fp(.001);Co(2,-53,53,[1]);function pf(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function mf(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,f,d;return i.map(g=>{let v=n(g),m=v.getFullYear(),p=v.getMonth(),y=v.getDate(),T=v.getHours(),x=v.getMinutes(),U=v.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||T!=h&&a[5]||x!=f&&a[6]||U!=d&&a[7]||a[1];return l=m,c=p,u=y,h=T,f=x,d=U,A(v)})}}function X0(n,t){let e=Bu(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Pl(n,t,e){return new Date(n,t,e)}function gf(n,t){return t(n)}const q0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function _f(n,t){return(e,i,s,r)=>r==null?Iu:t(n(i))}function Y0(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function K0(n,t){return n.series[t].fill(n,t)}const j0={show:!0,live:!0,isolate:!1,mount:m0,markers:{show:!0,width:2,stroke:Y0,fill:K0,dash:"solid"},idx:null,idxs:null,values:[]};function Z0(n,t){let e=n.cursor.points,i=ii(),s=e.size(n,t);Be(i,Mo,s),Be(i,So,s);let r=s/-2;Be(i,"marginLeft",r),Be(i,"marginTop",r);let o=e.width(n,t,s);return o&&Be(i,"borderWidth",o),i}function J0(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Q0(n,t){let e=n.series[t].points;return e._stroke||e._fill}function tv(n,t){return n.series[t].points.size}const Ll=[0,0];function ev(n,t,e){return Ll[0]=t,Ll[1]=e,Ll}function Yo(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Dl(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}const nv={show:!0,x:!0,y:!0,lock:!1,move:ev,points:{one:!1,show:Z0,size:tv,width:0,stroke:Q0,fill:J0},bind:{mousedown:Yo,mouseup:Yo,click:Yo,dblclick:Yo,mousemove:Dl,mouseleave:Dl,mouseenter:Dl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Op={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Hu=Je({},Op,{filter:Ep}),kp=Je({},Hu,{size:10}),Bp=Je({},Op,{show:!1}),Vu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',zp="bold "+Vu,Hp=1.5,vf={show:!0,scale:"x",stroke:Du,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zp,side:2,grid:Hu,ticks:kp,border:Bp,font:Vu,lineGap:Hp,rotate:0},iv="Value",sv="Time",xf={show:!0,scale:"x",auto:!1,sorted:1,min:De,max:-De,idxs:[]};function rv(n,t,e,i,s){return t.map(r=>r==null?"":Ou(r))}function ov(n,t,e,i,s,r,o){let a=[],l=xs.get(s)||0;e=o?e:Ie(Qa(e,s),l);for(let c=e;c<=i;c=Ie(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function bc(n,t,e,i,s,r,o){const a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ji:Mp,u=jn(c(e));s=kr(l,u),l==10&&(s=Os[_i(s,Os)]);let h=e,f=s*l;l==10&&(f=Os[_i(f,Os)]);do a.push(h),h=h+s,l==10&&!xs.has(h)&&(h=Ie(h,xs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Os[_i(f,Os)]));while(h<=i);return a}function av(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?bc(n,t,In(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?bc(n,t,In(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}const Vp=/./,lv=/[12357]/,cv=/[125]/,Mf=/1/,wc=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function uv(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Vp:l(7,o)-u>=c?lv:l(5,o)-u>=c?cv:Mf;if(h==Mf){let f=sn(l(1,o)-u);if(f<c)return wc(t.slice().reverse(),a.distr,h,ri(c/f)).reverse()}return wc(t,a.distr,h,1)}function hv(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=sn(l(1,o)-l(2,o));return c<a?wc(t.slice().reverse(),3,Vp,ri(a/c)).reverse():t}function fv(n,t,e,i){return i==null?Iu:t==null?"":Ou(t)}const Sf={show:!0,scale:"y",stroke:Du,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zp,side:3,grid:Hu,ticks:kp,border:Bp,font:Vu,lineGap:Hp,rotate:0};function dv(n,t){let e=3+(n||1)*2;return Ie(e*t,3)}function pv(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=sn(o-r),l=n.series[t],c=a/(l.points.space*Ee);return i[1]-i[0]<=c}const yf={scale:null,auto:!0,sorted:0,min:De,max:-De},Gp=(n,t,e,i,s)=>s,Ef={show:!0,auto:!0,sorted:0,gaps:Gp,alpha:1,facets:[Je({},yf,{scale:"x"}),Je({},yf,{scale:"y"})]},bf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Gp,alpha:1,points:{show:pv,filter:null},values:null,min:De,max:-De,idxs:[],path:null,clip:null};function mv(n,t,e,i,s){return e/10}const Wp={time:z_,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},gv=Je({},Wp,{time:!1,ori:1}),wf={};function $p(n,t){let e=wf[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(wf[n]=e)),e}const Hr=1,Tc=2;function Zs(n,t,e){const i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,v,nl,Zr,sl,qp,Kp):e(s,l,c,u,h,p,m,d,f,v,g,il,Jr,$u,Yp,jp)}function Gu(n,t){let e=0,i=0,s=xe(n.bands,ku);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function _v(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Qi(n,t,e,i,s,r){return Zs(n,t,(o,a,l,c,u,h,f,d,g,v,m)=>{let p=o.pxRound;const y=c.dir*(c.ori==0?1:-1),T=c.ori==0?Zr:Jr;let x,U;y==1?(x=e,U=i):(x=i,U=e);let A=p(h(a[x],c,v,d)),D=p(f(l[x],u,m,g)),I=p(h(a[U],c,v,d)),w=p(f(r==1?u.max:u.min,u,m,g)),S=new Path2D(s);return T(S,I,w),T(S,A,w),T(S,A,D),S})}function el(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=t==0?sl:$u;let l=e;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function vv(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Wu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(n[h]),g=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=d&&a.push([d,g])}return a}function Tf(n){return n==0?yp:n==1?nn:t=>Fs(t,n)}function Xp(n){let t=n==0?nl:il,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=vi(c,a/2,l/2),u=vi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const nl=(n,t,e)=>{n.moveTo(t,e)},il=(n,t,e)=>{n.moveTo(e,t)},Zr=(n,t,e)=>{n.lineTo(t,e)},Jr=(n,t,e)=>{n.lineTo(e,t)},sl=Xp(0),$u=Xp(1),qp=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Yp=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Kp=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},jp=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Zp(n){return(t,e,i,s,r)=>Zs(t,e,(o,a,l,c,u,h,f,d,g,v,m)=>{let{pxRound:p,points:y}=o,T,x;c.ori==0?(T=nl,x=qp):(T=il,x=Yp);const U=Ie(y.width*Ee,3);let A=(y.size-y.width)/2*Ee,D=Ie(A*2,3),I=new Path2D,w=new Path2D,{left:S,top:C,width:V,height:N}=t.bbox;sl(w,S-D,C-D,V+D*2,N+D*2);const G=j=>{if(l[j]!=null){let K=p(h(a[j],c,v,d)),Q=p(f(l[j],u,m,g));T(I,K+A,Q),x(I,K,Q,A,0,Aa*2)}};if(r)r.forEach(G);else for(let j=i;j<=s;j++)G(j);return{stroke:U>0?I:null,fill:I,clip:w,flags:Hr|Tc}})}function Jp(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}const xv=Jp(Zr),Mv=Jp(Jr);function Qp(n){const t=xe(n?.alignGaps,0);return(e,i,s,r)=>Zs(e,i,(o,a,l,c,u,h,f,d,g,v,m)=>{[s,r]=Za(l,s,r);let p=o.pxRound,y=N=>p(h(N,c,v,d)),T=N=>p(f(N,u,m,g)),x,U;c.ori==0?(x=Zr,U=xv):(x=Jr,U=Mv);const A=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},I=D.stroke;let w=!1;if(r-s>=v*4){let N=pt=>e.posToVal(pt,c.key,!0),G=null,j=null,K,Q,tt,ht=y(a[A==1?s:r]),ct=y(a[s]),mt=y(a[r]),Mt=N(A==1?ct+1:mt-1);for(let pt=A==1?s:r;pt>=s&&pt<=r;pt+=A){let it=a[pt],gt=(A==1?it<Mt:it>Mt)?ht:y(it),ot=l[pt];gt==ht?ot!=null?(Q=ot,G==null?(x(I,gt,T(Q)),K=G=j=Q):Q<G?G=Q:Q>j&&(j=Q)):ot===null&&(w=!0):(G!=null&&U(I,ht,T(G),T(j),T(K),T(Q)),ot!=null?(Q=ot,x(I,gt,T(Q)),G=j=K=Q):(G=j=null,ot===null&&(w=!0)),ht=gt,Mt=N(ht+A))}G!=null&&G!=j&&tt!=ht&&U(I,ht,T(G),T(j),T(K),T(Q))}else for(let N=A==1?s:r;N>=s&&N<=r;N+=A){let G=l[N];G===null?w=!0:G!=null&&x(I,y(a[N]),T(G))}let[C,V]=Gu(e,i);if(o.fill!=null||C!=0){let N=D.fill=new Path2D(I),G=o.fillTo(e,i,o.min,o.max,C),j=T(G),K=y(a[s]),Q=y(a[r]);A==-1&&([Q,K]=[K,Q]),x(N,Q,j),x(N,K,j)}if(!o.spanGaps){let N=[];w&&N.push(...Wu(a,l,s,r,A,y,t)),D.gaps=N=o.gaps(e,i,s,r,N),D.clip=el(N,c.ori,d,g,v,m)}return V!=0&&(D.band=V==2?[Qi(e,i,s,r,I,-1),Qi(e,i,s,r,I,1)]:Qi(e,i,s,r,I,V)),D})}function Sv(n){const t=xe(n.align,1),e=xe(n.ascDesc,!1),i=xe(n.alignGaps,0),s=xe(n.extend,!1);return(r,o,a,l)=>Zs(r,o,(c,u,h,f,d,g,v,m,p,y,T)=>{[a,l]=Za(h,a,l);let x=c.pxRound,{left:U,width:A}=r.bbox,D=ct=>x(g(ct,f,y,m)),I=ct=>x(v(ct,d,T,p)),w=f.ori==0?Zr:Jr;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Hr},C=S.stroke,V=f.dir*(f.ori==0?1:-1);let N=I(h[V==1?a:l]),G=D(u[V==1?a:l]),j=G,K=G;s&&t==-1&&(K=U,w(C,K,N)),w(C,G,N);for(let ct=V==1?a:l;ct>=a&&ct<=l;ct+=V){let mt=h[ct];if(mt==null)continue;let Mt=D(u[ct]),pt=I(mt);t==1?w(C,Mt,N):w(C,j,pt),w(C,Mt,pt),N=pt,j=Mt}let Q=j;s&&t==1&&(Q=U+A,w(C,Q,N));let[tt,ht]=Gu(r,o);if(c.fill!=null||tt!=0){let ct=S.fill=new Path2D(C),mt=c.fillTo(r,o,c.min,c.max,tt),Mt=I(mt);w(ct,Q,Mt),w(ct,K,Mt)}if(!c.spanGaps){let ct=[];ct.push(...Wu(u,h,a,l,V,D,i));let mt=c.width*Ee/2,Mt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(it=>{it[0]+=Mt,it[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=el(ct,f.ori,m,p,y,T)}return ht!=0&&(S.band=ht==2?[Qi(r,o,a,l,C,-1),Qi(r,o,a,l,C,1)]:Qi(r,o,a,l,C,ht)),S})}function Af(n,t,e,i,s,r,o=De){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=sn(n[l]-n[a]);u<c&&(c=u,o=sn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function yv(n){n=n||To;const t=xe(n.size,[.6,De,1]),e=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=ae(s),o=1-t[0],a=xe(t[1],De),l=xe(t[2],1),c=xe(n.disp,To),u=xe(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,v,m)=>Zs(d,g,(p,y,T,x,U,A,D,I,w,S,C)=>{let V=p.pxRound,N=e,G=i*Ee,j=a*Ee,K=l*Ee,Q,tt;x.ori==0?[Q,tt]=r(d,g):[tt,Q]=r(d,g);const ht=x.dir*(x.ori==0?1:-1);let ct=x.ori==0?sl:$u,mt=x.ori==0?u:(W,et,St,_t,wt,jt,ft)=>{u(W,et,St,wt,_t,ft,jt)},Mt=xe(d.bands,ku).find(W=>W.series[0]==g),pt=Mt!=null?Mt.dir:0,it=p.fillTo(d,g,p.min,p.max,pt),at=V(D(it,U,C,w)),gt,ot,Bt,Ht=S,Ut=V(p.width*Ee),he=!1,Zt=null,fe=null,z=null,tn=null;h!=null&&(Ut==0||f!=null)&&(he=!0,Zt=h.values(d,g,v,m),fe=new Map,new Set(Zt).forEach(W=>{W!=null&&fe.set(W,new Path2D)}),Ut>0&&(z=f.values(d,g,v,m),tn=new Map,new Set(z).forEach(W=>{W!=null&&tn.set(W,new Path2D)})));let{x0:Qt,size:ee}=c;if(Qt!=null&&ee!=null){N=1,y=Qt.values(d,g,v,m),Qt.unit==2&&(y=y.map(St=>d.posToVal(I+St*S,x.key,!0)));let W=ee.values(d,g,v,m);ee.unit==2?ot=W[0]*S:ot=A(W[0],x,S,I)-A(0,x,S,I),Ht=Af(y,T,A,x,S,I,Ht),Bt=Ht-ot+G}else Ht=Af(y,T,A,x,S,I,Ht),Bt=Ht*o+G,ot=Ht-Bt;Bt<1&&(Bt=0),Ut>=ot/2&&(Ut=0),Bt<5&&(V=yp);let Gt=Bt>0,pe=Ht-Bt-(Gt?Ut:0);ot=V(Ec(pe,K,j)),gt=(N==0?ot/2:N==ht?0:ot)-N*ht*((N==0?G/2:0)+(Gt?Ut/2:0));const Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=he?null:new Path2D;let E=null;if(Mt!=null)E=d.data[Mt.series[1]];else{let{y0:W,y1:et}=c;W!=null&&et!=null&&(T=et.values(d,g,v,m),E=W.values(d,g,v,m))}let Y=Q*ot,Z=tt*ot;for(let W=ht==1?v:m;W>=v&&W<=m;W+=ht){let et=T[W];if(et==null)continue;if(E!=null){let Ot=E[W]??0;if(et-Ot==0)continue;at=D(Ot,U,C,w)}let St=x.distr!=2||c!=null?y[W]:W,_t=A(St,x,S,I),wt=D(xe(et,it),U,C,w),jt=V(_t-gt),ft=V(In(wt,at)),vt=V(vi(wt,at)),Nt=ft-vt;if(et!=null){let Ot=et<0?Z:Y,Et=et<0?Y:Z;he?(Ut>0&&z[W]!=null&&ct(tn.get(z[W]),jt,vt+jn(Ut/2),ot,In(0,Nt-Ut),Ot,Et),Zt[W]!=null&&ct(fe.get(Zt[W]),jt,vt+jn(Ut/2),ot,In(0,Nt-Ut),Ot,Et)):ct(P,jt,vt+jn(Ut/2),ot,In(0,Nt-Ut),Ot,Et),mt(d,g,W,jt-Ut/2,vt,ot+Ut,Nt)}}return Ut>0?Pt.stroke=he?tn:P:he||(Pt._fill=p.width==0?p._fill:p._stroke??p._fill,Pt.width=0),Pt.fill=he?fe:P,Pt})}function Ev(n,t){const e=xe(t?.alignGaps,0);return(i,s,r,o)=>Zs(i,s,(a,l,c,u,h,f,d,g,v,m,p)=>{[r,o]=Za(c,r,o);let y=a.pxRound,T=Q=>y(f(Q,u,m,g)),x=Q=>y(d(Q,h,p,v)),U,A,D;u.ori==0?(U=nl,D=Zr,A=Kp):(U=il,D=Jr,A=jp);const I=u.dir*(u.ori==0?1:-1);let w=T(l[I==1?r:o]),S=w,C=[],V=[];for(let Q=I==1?r:o;Q>=r&&Q<=o;Q+=I)if(c[Q]!=null){let ht=l[Q],ct=T(ht);C.push(S=ct),V.push(x(c[Q]))}const N={stroke:n(C,V,U,D,A,y),fill:null,clip:null,band:null,gaps:null,flags:Hr},G=N.stroke;let[j,K]=Gu(i,s);if(a.fill!=null||j!=0){let Q=N.fill=new Path2D(G),tt=a.fillTo(i,s,a.min,a.max,j),ht=x(tt);D(Q,S,ht),D(Q,w,ht)}if(!a.spanGaps){let Q=[];Q.push(...Wu(l,c,r,o,I,T,e)),N.gaps=Q=a.gaps(i,s,r,o,Q),N.clip=el(Q,u.ori,g,v,m,p)}return K!=0&&(N.band=K==2?[Qi(i,s,r,o,G,-1),Qi(i,s,r,o,G,1)]:Qi(i,s,r,o,G,K)),N})}function bv(n){return Ev(wv,n)}function wv(n,t,e,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,t[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,n[f+1],t[f+1])}return a}const Ac=new Set;function Rf(){for(let n of Ac)n.syncRect(!0)}jr&&($s(r0,Ir,Rf),$s(o0,Ir,Rf,!0),$s(ka,Ir,()=>{vn.pxRatio=Ee}));const Tv=Qp(),Av=Zp();function Cf(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Rc(r,o,t,e))}function Rv(n,t){return n.map((e,i)=>i==0?{}:Je({},t,e))}function Rc(n,t,e,i){return Je({},t==0?e:i,n)}function tm(n,t,e){return t==null?Br:[t,e]}const Cv=tm;function Pv(n,t,e){return t==null?Br:Ba(t,e,Fu,!0)}function em(n,t,e,i){return t==null?Br:Ja(t,e,n.scales[i].log,!1)}const Lv=em;function nm(n,t,e,i){return t==null?Br:Nu(t,e,n.scales[i].log,!1)}const Dv=nm;function Iv(n,t,e,i,s){let r=In(af(n),af(t)),o=t-n,a=_i(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?xs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Pf(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=nn((e=+s)*Ee))+"px"),[n,t,e]}function Uv(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ie(t[2]*Ee,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function vn(n,t,e){const i={mode:xe(n.mode,1)},s=i.mode;function r(_,M,R,L){let F=M.valToPct(_);return L+R*(M.dir==-1?1-F:F)}function o(_,M,R,L){let F=M.valToPct(_);return L+R*(M.dir==-1?F:1-F)}function a(_,M,R,L){return M.ori==0?r(_,M,R,L):o(_,M,R,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=ii(H_);if(n.id!=null&&(c.id=n.id),qn(c,n.class),n.title){let _=ii(W_,c);_.textContent=n.title}const u=gi("canvas"),h=i.ctx=u.getContext("2d"),f=ii($_,c);$s("click",f,_=>{_.target===g&&(Fe!=ar||Ge!=lr)&&_n.click(i,_)},!0);const d=i.under=ii(X_,f);f.appendChild(u);const g=i.over=ii(q_,f);n=zr(n);const v=+xe(n.pxAlign,1),m=Tf(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});const p=n.ms||.001,y=i.series=s==1?Cf(n.series||[],xf,bf,!1):Rv(n.series||[null],Ef),T=i.axes=Cf(n.axes||[],vf,Sf,!0),x=i.scales={},U=i.bands=n.bands||[];U.forEach(_=>{_.fill=ae(_.fill||null),_.dir=xe(_.dir,-1)});const A=s==2?y[1].facets[0].scale:y[0].scale,D={axes:Zm,series:Qn},I=(n.drawOrder||["axes","series"]).map(_=>D[_]);function w(_){const M=_.distr==3?R=>Ji(R>0?R:_.clamp(i,R,_.min,_.max,_.key)):_.distr==4?R=>Cl(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=M(R),{_min:F,_max:q}=_,st=q-F;return(L-F)/st}}function S(_){let M=x[_];if(M==null){let R=(n.scales||To)[_]||To;if(R.from!=null){S(R.from);let L=Je({},x[R.from],R,{key:_});L.valToPct=w(L),x[_]=L}else{M=x[_]=Je({},_==A?Wp:gv,R),M.key=_;let L=M.time,F=M.range,q=ps(F);if((_!=A||s==2&&!L)&&(q&&(F[0]==null||F[1]==null)&&(F={min:F[0]==null?sf:{mode:1,hard:F[0],soft:F[0]},max:F[1]==null?sf:{mode:1,hard:F[1],soft:F[1]}},q=!1),!q&&tl(F))){let st=F;F=(lt,dt,Rt)=>dt==null?Br:Ba(dt,Rt,st)}M.range=ae(F||(L?Cv:_==A?M.distr==3?Lv:M.distr==4?Dv:tm:M.distr==3?em:M.distr==4?nm:Pv)),M.auto=ae(q?!1:M.auto),M.clamp=ae(M.clamp||mv),M._min=M._max=null,M.valToPct=w(M)}}}S("x"),S("y"),s==1&&y.forEach(_=>{S(_.scale)}),T.forEach(_=>{S(_.scale)});for(let _ in n.scales)S(_);const C=x[A],V=C.distr;let N,G;C.ori==0?(qn(c,V_),N=r,G=o):(qn(c,G_),N=o,G=r);const j={};for(let _ in x){let M=x[_];(M.min!=null||M.max!=null)&&(j[_]={min:M.min,max:M.max},M.min=M.max=null)}const K=n.tzDate||(_=>new Date(nn(_/p))),Q=n.fmtDate||Bu,tt=p==1?V0(K):$0(K),ht=mf(K,pf(p==1?H0:W0,Q)),ct=_f(K,gf(q0,Q)),mt=[],Mt=i.legend=Je({},j0,n.legend),pt=i.cursor=Je({},nv,{drag:{y:s==2}},n.cursor),it=Mt.show,at=pt.show,gt=Mt.markers;Mt.idxs=mt,gt.width=ae(gt.width),gt.dash=ae(gt.dash),gt.stroke=ae(gt.stroke),gt.fill=ae(gt.fill);let ot,Bt,Ht,Ut=[],he=[],Zt,fe=!1,z={};if(Mt.live){const _=y[1]?y[1].values:null;fe=_!=null,Zt=fe?_(i,1,0):{_:0};for(let M in Zt)z[M]=Iu}if(it)if(ot=gi("table",Q_,c),Ht=gi("tbody",null,ot),Mt.mount(i,ot),fe){Bt=gi("thead",null,ot,Ht);let _=gi("tr",null,Bt);gi("th",null,_);for(var tn in Zt)gi("th",Wh,_).textContent=tn}else qn(ot,e0),Mt.live&&qn(ot,t0);const Qt={show:!0},ee={show:!1};function Gt(_,M){if(M==0&&(fe||!Mt.live||s==2))return Br;let R=[],L=gi("tr",n0,Ht,Ht.childNodes[M]);qn(L,_.class),_.show||qn(L,zs);let F=gi("th",null,L);if(gt.show){let lt=ii(i0,F);if(M>0){let dt=gt.width(i,M);dt&&(lt.style.border=dt+"px "+gt.dash(i,M)+" "+gt.stroke(i,M)),lt.style.background=gt.fill(i,M)}}let q=ii(Wh,F);_.label instanceof HTMLElement?q.appendChild(_.label):q.textContent=_.label,M>0&&(gt.show||(q.style.color=_.width>0?gt.stroke(i,M):gt.fill(i,M)),Pt("click",F,lt=>{if(pt._lock)return;en(lt);let dt=y.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Rt=y.some((Ct,Lt)=>Lt>0&&Lt!=dt&&Ct.show);y.forEach((Ct,Lt)=>{Lt>0&&Ti(Lt,Rt?Lt==dt?Qt:ee:Qt,!0,je.setSeries)})}else Ti(dt,{show:!_.show},!0,je.setSeries)},!1),Bi&&Pt(Yh,F,lt=>{pt._lock||(en(lt),Ti(y.indexOf(_),ur,!0,je.setSeries))},!1));for(var st in Zt){let lt=gi("td",s0,L);lt.textContent="--",R.push(lt)}return[L,R]}const pe=new Map;function Pt(_,M,R,L=!0){const F=pe.get(M)||{},q=pt.bind[_](i,M,R,L);q&&($s(_,M,F[_]=q),pe.set(M,F))}function P(_,M,R){const L=pe.get(M)||{};for(let F in L)(_==null||F==_)&&(yc(F,M,L[F]),delete L[F]);_==null&&pe.delete(M)}let E=0,Y=0,Z=0,W=0,et=0,St=0,_t=et,wt=St,jt=Z,ft=W,vt=0,Nt=0,Ot=0,Et=0;i.bbox={};let ie=!1,Yt=!1,me=!1,k=!1,xt=!1,nt=!1;function rt(_,M,R){(R||_!=i.width||M!=i.height)&&Tt(_,M),ir(!1),me=!0,Yt=!0,sr()}function Tt(_,M){i.width=E=Z=_,i.height=Y=W=M,et=St=0,un(),Se();let R=i.bbox;vt=R.left=Fs(et*Ee,.5),Nt=R.top=Fs(St*Ee,.5),Ot=R.width=Fs(Z*Ee,.5),Et=R.height=Fs(W*Ee,.5)}const At=3;function Jt(){let _=!1,M=0;for(;!_;){M++;let R=Km(M),L=jm(M);_=M==At||R&&L,_||(Tt(i.width,i.height),Yt=!0)}}function He({width:_,height:M}){rt(_,M)}i.setSize=He;function un(){let _=!1,M=!1,R=!1,L=!1;T.forEach((F,q)=>{if(F.show&&F._show){let{side:st,_size:lt}=F,dt=st%2,Rt=F.label!=null?F.labelSize:0,Ct=lt+Rt;Ct>0&&(dt?(Z-=Ct,st==3?(et+=Ct,L=!0):R=!0):(W-=Ct,st==0?(St+=Ct,_=!0):M=!0))}}),Ei[0]=_,Ei[1]=R,Ei[2]=M,Ei[3]=L,Z-=b[1]+b[3],et+=b[3],W-=b[2]+b[0],St+=b[0]}function Se(){let _=et+Z,M=St+W,R=et,L=St;function F(q,st){switch(q){case 1:return _+=st,_-st;case 2:return M+=st,M-st;case 3:return R-=st,R+st;case 0:return L-=st,L+st}}T.forEach((q,st)=>{if(q.show&&q._show){let lt=q.side;q._pos=F(lt,q._size),q.label!=null&&(q._lpos=F(lt,q.labelSize))}})}if(pt.dataIdx==null){let _=pt.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let R=_.prox=ae(_.prox),L=_.bias??=0;pt.dataIdx=(F,q,st,lt)=>{if(q==0)return st;let dt=st,Rt=R(F,q,st,lt)??De,Ct=Rt>=0&&Rt<De,Lt=C.ori==0?Z:W,Kt=pt.left,ye=t[0],ve=t[q];if(M.has(ve[st])){dt=null;let se=null,$t=null,zt;if(L==0||L==-1)for(zt=st;se==null&&zt-- >0;)M.has(ve[zt])||(se=zt);if(L==0||L==1)for(zt=st;$t==null&&zt++<ve.length;)M.has(ve[zt])||($t=zt);if(se!=null||$t!=null)if(Ct){let ke=se==null?-1/0:N(ye[se],C,Lt,0),qe=$t==null?1/0:N(ye[$t],C,Lt,0),mn=Kt-ke,Ce=qe-Kt;mn<=Ce?mn<=Rt&&(dt=se):Ce<=Rt&&(dt=$t)}else dt=$t==null?se:se==null?$t:st-se<=$t-st?se:$t}else Ct&&sn(Kt-N(ye[st],C,Lt,0))>Rt&&(dt=null);return dt}}const en=_=>{pt.event=_};pt.idxs=mt,pt._lock=!1;let Ue=pt.points;Ue.show=ae(Ue.show),Ue.size=ae(Ue.size),Ue.stroke=ae(Ue.stroke),Ue.width=ae(Ue.width),Ue.fill=ae(Ue.fill);const Hn=i.focus=Je({},n.focus||{alpha:.3},pt.focus),Bi=Hn.prox>=0,Un=Bi&&Ue.one;let xn=[],zi=[],Hi=[];function ys(_,M){let R=Ue.show(i,M);if(R instanceof HTMLElement)return qn(R,J_),qn(R,_.class),Pi(R,-10,-10,Z,W),g.insertBefore(R,xn[M]),R}function so(_,M){if(s==1||M>0){let R=s==1&&x[_.scale].time,L=_.value;_.value=R?uf(L)?_f(K,gf(L,Q)):L||ct:L||fv,_.label=_.label||(R?sv:iv)}if(Un||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Tv||g0,_.fillTo=ae(_.fillTo||_v),_.pxAlign=+xe(_.pxAlign,v),_.pxRound=Tf(_.pxAlign),_.stroke=ae(_.stroke||null),_.fill=ae(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=dv(In(1,_.width),1),L=_.points=Je({},{size:R,width:In(1,R*.2),stroke:_.stroke,space:R*2,paths:Av,_stroke:null,_fill:null},_.points);L.show=ae(L.show),L.filter=ae(L.filter),L.fill=ae(L.fill),L.stroke=ae(L.stroke),L.paths=ae(L.paths),L.pxAlign=_.pxAlign}if(it){let R=Gt(_,M);Ut.splice(M,0,R[0]),he.splice(M,0,R[1]),Mt.values.push(null)}if(at){mt.splice(M,0,null);let R=null;Un?M==0&&(R=ys(_,M)):M>0&&(R=ys(_,M)),xn.splice(M,0,R),zi.splice(M,0,0),Hi.splice(M,0,0)}pn("addSeries",M)}function er(_,M){M=M??y.length,_=s==1?Rc(_,M,xf,bf):Rc(_,M,{},Ef),y.splice(M,0,_),so(y[M],M)}i.addSeries=er;function Oo(_){if(y.splice(_,1),it){Mt.values.splice(_,1),he.splice(_,1);let M=Ut.splice(_,1)[0];P(null,M.firstChild),M.remove()}at&&(mt.splice(_,1),xn.splice(_,1)[0].remove(),zi.splice(_,1),Hi.splice(_,1)),pn("delSeries",_)}i.delSeries=Oo;const Ei=[!1,!1,!1,!1];function hl(_,M){if(_._show=_.show,_.show){let R=_.side%2,L=x[_.scale];L==null&&(_.scale=R?y[1].scale:A,L=x[_.scale]);let F=L.time;_.size=ae(_.size),_.space=ae(_.space),_.rotate=ae(_.rotate),ps(_.incrs)&&_.incrs.forEach(st=>{!xs.has(st)&&xs.set(st,wp(st))}),_.incrs=ae(_.incrs||(L.distr==2?k0:F?p==1?z0:G0:Os)),_.splits=ae(_.splits||(F&&L.distr==1?tt:L.distr==3?bc:L.distr==4?av:ov)),_.stroke=ae(_.stroke),_.grid.stroke=ae(_.grid.stroke),_.ticks.stroke=ae(_.ticks.stroke),_.border.stroke=ae(_.border.stroke);let q=_.values;_.values=ps(q)&&!ps(q[0])?ae(q):F?ps(q)?mf(K,pf(q,Q)):uf(q)?X0(K,q):q||ht:q||rv,_.filter=ae(_.filter||(L.distr>=3&&L.log==10?uv:L.distr==3&&L.log==2?hv:Ep)),_.font=Pf(_.font),_.labelFont=Pf(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Ei[M]=!0,_._el=ii(Y_,f))}}function Es(_,M,R,L){let[F,q,st,lt]=R,dt=M%2,Rt=0;return dt==0&&(lt||q)&&(Rt=M==0&&!F||M==2&&!st?nn(vf.size/3):0),dt==1&&(F||st)&&(Rt=M==1&&!q||M==3&&!lt?nn(Sf.size/2):0),Rt}const ko=i.padding=(n.padding||[Es,Es,Es,Es]).map(_=>ae(xe(_,Es))),b=i._padding=ko.map((_,M)=>_(i,M,Ei,0));let O,$=null,X=null;const H=s==1?y[0].idxs:null;let ut=null,yt=!1;function Ft(_,M){if(t=_??[],i.data=i._data=t,s==2){O=0;for(let R=1;R<y.length;R++)O+=t[R][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ut=t[0],O=ut.length;let R=t;if(V==2){R=t.slice();let L=R[0]=Array(O);for(let F=0;F<O;F++)L[F]=F}i._data=t=R}if(ir(!0),pn("setData"),V==2&&(me=!0),M!==!1){let R=C;R.auto(i,yt)?Dt():rs(A,R.min,R.max),k=k||pt.left>=0,nt=!0,sr()}}i.setData=Ft;function Dt(){yt=!0;let _,M;s==1&&(O>0?($=H[0]=0,X=H[1]=O-1,_=t[0][$],M=t[0][X],V==2?(_=$,M=X):_==M&&(V==3?[_,M]=Ja(_,_,C.log,!1):V==4?[_,M]=Nu(_,_,C.log,!1):C.time?M=_+nn(86400/p):[_,M]=Ba(_,M,Fu,!0))):($=H[0]=_=null,X=H[1]=M=null)),rs(A,_,M)}let Wt,qt,It,oe,be,Ae,hn,de,kt,Ve;function ge(_,M,R,L,F,q){_??=Xh,R??=ku,L??="butt",F??=Xh,q??="round",_!=Wt&&(h.strokeStyle=Wt=_),F!=qt&&(h.fillStyle=qt=F),M!=It&&(h.lineWidth=It=M),q!=be&&(h.lineJoin=be=q),L!=Ae&&(h.lineCap=Ae=L),R!=oe&&h.setLineDash(oe=R)}function Nn(_,M,R,L){M!=qt&&(h.fillStyle=qt=M),_!=hn&&(h.font=hn=_),R!=de&&(h.textAlign=de=R),L!=kt&&(h.textBaseline=kt=L)}function bi(_,M,R,L,F=0){if(L.length>0&&_.auto(i,yt)&&(M==null||M.min==null)){let q=xe($,0),st=xe(X,L.length-1),lt=R.min==null?u0(L,q,st,F,_.distr==3):[R.min,R.max];_.min=vi(_.min,R.min=lt[0]),_.max=In(_.max,R.max=lt[1])}}const Mn={min:null,max:null};function bs(){for(let L in x){let F=x[L];j[L]==null&&(F.min==null||j[A]!=null&&F.auto(i,yt))&&(j[L]=Mn)}for(let L in x){let F=x[L];j[L]==null&&F.from!=null&&j[F.from]!=null&&(j[L]=Mn)}j[A]!=null&&ir(!0);let _={};for(let L in j){let F=j[L];if(F!=null){let q=_[L]=zr(x[L],x0);if(F.min!=null)Je(q,F);else if(L!=A||s==2)if(O==0&&q.from==null){let st=q.range(i,null,null,L);q.min=st[0],q.max=st[1]}else q.min=De,q.max=-De}}if(O>0){y.forEach((L,F)=>{if(s==1){let q=L.scale,st=j[q];if(st==null)return;let lt=_[q];if(F==0){let dt=lt.range(i,lt.min,lt.max,q);lt.min=dt[0],lt.max=dt[1],$=_i(lt.min,t[0]),X=_i(lt.max,t[0]),X-$>1&&(t[0][$]<lt.min&&$++,t[0][X]>lt.max&&X--),L.min=ut[$],L.max=ut[X]}else L.show&&L.auto&&bi(lt,st,L,t[F],L.sorted);L.idxs[0]=$,L.idxs[1]=X}else if(F>0&&L.show&&L.auto){let[q,st]=L.facets,lt=q.scale,dt=st.scale,[Rt,Ct]=t[F],Lt=_[lt],Kt=_[dt];Lt!=null&&bi(Lt,j[lt],q,Rt,q.sorted),Kt!=null&&bi(Kt,j[dt],st,Ct,st.sorted),L.min=st.min,L.max=st.max}});for(let L in _){let F=_[L],q=j[L];if(F.from==null&&(q==null||q.min==null)){let st=F.range(i,F.min==De?null:F.min,F.max==-De?null:F.max,L);F.min=st[0],F.max=st[1]}}}for(let L in _){let F=_[L];if(F.from!=null){let q=_[F.from];if(q.min==null)F.min=F.max=null;else{let st=F.range(i,q.min,q.max,L);F.min=st[0],F.max=st[1]}}}let M={},R=!1;for(let L in _){let F=_[L],q=x[L];if(q.min!=F.min||q.max!=F.max){q.min=F.min,q.max=F.max;let st=q.distr;q._min=st==3?Ji(q.min):st==4?Cl(q.min,q.asinh):st==100?q.fwd(q.min):q.min,q._max=st==3?Ji(q.max):st==4?Cl(q.max,q.asinh):st==100?q.fwd(q.max):q.max,M[L]=R=!0}}if(R){y.forEach((L,F)=>{s==2?F>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)me=!0,pn("setScale",L);at&&pt.left>=0&&(k=nt=!0)}for(let L in j)j[L]=null}function Le(_){let M=Ec($-1,0,O-1),R=Ec(X+1,0,O-1);for(;_[M]==null&&M>0;)M--;for(;_[R]==null&&R<O-1;)R++;return[M,R]}function Qn(){if(O>0){let _=y.some(M=>M._focus)&&Ve!=Hn.alpha;_&&(h.globalAlpha=Ve=Hn.alpha),y.forEach((M,R)=>{if(R>0&&M.show&&(is(R,!1),is(R,!0),M._paths==null)){let L=Ve;Ve!=M.alpha&&(h.globalAlpha=Ve=M.alpha);let F=s==2?[0,t[R][0].length-1]:Le(t[R]);M._paths=M.paths(i,R,F[0],F[1]),Ve!=L&&(h.globalAlpha=Ve=L)}}),y.forEach((M,R)=>{if(R>0&&M.show){let L=Ve;Ve!=M.alpha&&(h.globalAlpha=Ve=M.alpha),M._paths!=null&&wn(R,!1);{let F=M._paths!=null?M._paths.gaps:null,q=M.points.show(i,R,$,X,F),st=M.points.filter(i,R,q,F);(q||st)&&(M.points._paths=M.points.paths(i,R,$,X,st),wn(R,!0))}Ve!=L&&(h.globalAlpha=Ve=L),pn("drawSeries",R)}}),_&&(h.globalAlpha=Ve=1)}}function is(_,M){let R=M?y[_].points:y[_];R._stroke=R.stroke(i,_),R._fill=R.fill(i,_)}function wn(_,M){let R=M?y[_].points:y[_],{stroke:L,fill:F,clip:q,flags:st,_stroke:lt=R._stroke,_fill:dt=R._fill,_width:Rt=R.width}=R._paths;Rt=Ie(Rt*Ee,3);let Ct=null,Lt=Rt%2/2;M&&dt==null&&(dt=Rt>0?"#fff":lt);let Kt=R.pxAlign==1&&Lt>0;if(Kt&&h.translate(Lt,Lt),!M){let ye=vt-Rt/2,ve=Nt-Rt/2,se=Ot+Rt,$t=Et+Rt;Ct=new Path2D,Ct.rect(ye,ve,se,$t)}M?nr(lt,Rt,R.dash,R.cap,dt,L,F,st,q):wi(_,lt,Rt,R.dash,R.cap,dt,L,F,st,Ct,q),Kt&&h.translate(-Lt,-Lt)}function wi(_,M,R,L,F,q,st,lt,dt,Rt,Ct){let Lt=!1;dt!=0&&U.forEach((Kt,ye)=>{if(Kt.series[0]==_){let ve=y[Kt.series[1]],se=t[Kt.series[1]],$t=(ve._paths||To).band;ps($t)&&($t=Kt.dir==1?$t[0]:$t[1]);let zt,ke=null;ve.show&&$t&&f0(se,$,X)?(ke=Kt.fill(i,ye)||q,zt=ve._paths.clip):$t=null,nr(M,R,L,F,ke,st,lt,dt,Rt,Ct,zt,$t),Lt=!0}}),Lt||nr(M,R,L,F,q,st,lt,dt,Rt,Ct)}const ui=Hr|Tc;function nr(_,M,R,L,F,q,st,lt,dt,Rt,Ct,Lt){ge(_,M,R,L,F),(dt||Rt||Lt)&&(h.save(),dt&&h.clip(dt),Rt&&h.clip(Rt)),Lt?(lt&ui)==ui?(h.clip(Lt),Ct&&h.clip(Ct),zo(F,st),Bo(_,q,M)):lt&Tc?(zo(F,st),h.clip(Lt),Bo(_,q,M)):lt&Hr&&(h.save(),h.clip(Lt),Ct&&h.clip(Ct),zo(F,st),h.restore(),Bo(_,q,M)):(zo(F,st),Bo(_,q,M)),(dt||Rt||Lt)&&h.restore()}function Bo(_,M,R){R>0&&(M instanceof Map?M.forEach((L,F)=>{h.strokeStyle=Wt=F,h.stroke(L)}):M!=null&&_&&h.stroke(M))}function zo(_,M){M instanceof Map?M.forEach((R,L)=>{h.fillStyle=qt=L,h.fill(R)}):M!=null&&_&&h.fill(M)}function Ym(_,M,R,L){let F=T[_],q;if(L<=0)q=[0,0];else{let st=F._space=F.space(i,_,M,R,L),lt=F._incrs=F.incrs(i,_,M,R,L,st);q=Iv(M,R,lt,L,st)}return F._found=q}function fl(_,M,R,L,F,q,st,lt,dt,Rt){let Ct=st%2/2;v==1&&h.translate(Ct,Ct),ge(lt,st,dt,Rt,lt),h.beginPath();let Lt,Kt,ye,ve,se=F+(L==0||L==3?-q:q);R==0?(Kt=F,ve=se):(Lt=F,ye=se);for(let $t=0;$t<_.length;$t++)M[$t]!=null&&(R==0?Lt=ye=_[$t]:Kt=ve=_[$t],h.moveTo(Lt,Kt),h.lineTo(ye,ve));h.stroke(),v==1&&h.translate(-Ct,-Ct)}function Km(_){let M=!0;return T.forEach((R,L)=>{if(!R.show)return;let F=x[R.scale];if(F.min==null){R._show&&(M=!1,R._show=!1,ir(!1));return}else R._show||(M=!1,R._show=!0,ir(!1));let q=R.side,st=q%2,{min:lt,max:dt}=F,[Rt,Ct]=Ym(L,lt,dt,st==0?Z:W);if(Ct==0)return;let Lt=F.distr==2,Kt=R._splits=R.splits(i,L,lt,dt,Rt,Ct,Lt),ye=F.distr==2?Kt.map(zt=>ut[zt]):Kt,ve=F.distr==2?ut[Kt[1]]-ut[Kt[0]]:Rt,se=R._values=R.values(i,R.filter(i,ye,L,Ct,ve),L,Ct,ve);R._rotate=q==2?R.rotate(i,se,L,Ct):0;let $t=R._size;R._size=ri(R.size(i,se,L,_)),$t!=null&&R._size!=$t&&(M=!1)}),M}function jm(_){let M=!0;return ko.forEach((R,L)=>{let F=R(i,L,Ei,_);F!=b[L]&&(M=!1),b[L]=F}),M}function Zm(){for(let _=0;_<T.length;_++){let M=T[_];if(!M.show||!M._show)continue;let R=M.side,L=R%2,F,q,st=M.stroke(i,_),lt=R==0||R==3?-1:1,[dt,Rt]=M._found;if(M.label!=null){let An=M.labelGap*lt,Wn=nn((M._lpos+An)*Ee);Nn(M.labelFont[0],st,"center",R==2?uo:$h),h.save(),L==1?(F=q=0,h.translate(Wn,nn(Nt+Et/2)),h.rotate((R==3?-Aa:Aa)/2)):(F=nn(vt+Ot/2),q=Wn);let As=Sp(M.label)?M.label(i,_,dt,Rt):M.label;h.fillText(As,F,q),h.restore()}if(Rt==0)continue;let Ct=x[M.scale],Lt=L==0?Ot:Et,Kt=L==0?vt:Nt,ye=M._splits,ve=Ct.distr==2?ye.map(An=>ut[An]):ye,se=Ct.distr==2?ut[ye[1]]-ut[ye[0]]:dt,$t=M.ticks,zt=M.border,ke=$t.show?$t.size:0,qe=nn(ke*Ee),mn=nn((M.alignTo==2?M._size-ke-M.gap:M.gap)*Ee),Ce=M._rotate*-Aa/180,Ye=m(M._pos*Ee),Vn=(qe+mn)*lt,Tn=Ye+Vn;q=L==0?Tn:0,F=L==1?Tn:0;let ti=M.font[0],hi=M.align==1?dr:M.align==2?Tl:Ce>0?dr:Ce<0?Tl:L==0?"center":R==3?Tl:dr,Ri=Ce||L==1?"middle":R==2?uo:$h;Nn(ti,st,hi,Ri);let Gn=M.font[1]*M.lineGap,ei=ye.map(An=>m(a(An,Ct,Lt,Kt))),fi=M._values;for(let An=0;An<fi.length;An++){let Wn=fi[An];if(Wn!=null){L==0?F=ei[An]:q=ei[An],Wn=""+Wn;let As=Wn.indexOf(`
`)==-1?[Wn]:Wn.split(/\n/gm);for(let Rn=0;Rn<As.length;Rn++){let Ah=As[Rn];Ce?(h.save(),h.translate(F,q+Rn*Gn),h.rotate(Ce),h.fillText(Ah,0,0),h.restore()):h.fillText(Ah,F,q+Rn*Gn)}}}$t.show&&fl(ei,$t.filter(i,ve,_,Rt,se),L,R,Ye,qe,Ie($t.width*Ee,3),$t.stroke(i,_),$t.dash,$t.cap);let Ci=M.grid;Ci.show&&fl(ei,Ci.filter(i,ve,_,Rt,se),L,L==0?2:1,L==0?Nt:vt,L==0?Et:Ot,Ie(Ci.width*Ee,3),Ci.stroke(i,_),Ci.dash,Ci.cap),zt.show&&fl([Ye],[1],L==0?1:0,L==0?1:2,L==1?Nt:vt,L==1?Et:Ot,Ie(zt.width*Ee,3),zt.stroke(i,_),zt.dash,zt.cap)}pn("drawAxes")}function ir(_){y.forEach((M,R)=>{R>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let Ho=!1,dl=!1,ro=[];function Jm(){dl=!1;for(let _=0;_<ro.length;_++)pn(...ro[_]);ro.length=0}function sr(){Ho||(T0(ch),Ho=!0)}function Qm(_,M=!1){Ho=!0,dl=M,_(i),ch(),M&&ro.length>0&&queueMicrotask(Jm)}i.batch=Qm;function ch(){if(ie&&(bs(),ie=!1),me&&(Jt(),me=!1),Yt){if(Be(d,dr,et),Be(d,uo,St),Be(d,Mo,Z),Be(d,So,W),Be(g,dr,et),Be(g,uo,St),Be(g,Mo,Z),Be(g,So,W),Be(f,Mo,E),Be(f,So,Y),u.width=nn(E*Ee),u.height=nn(Y*Ee),T.forEach(({_el:_,_show:M,_size:R,_pos:L,side:F})=>{if(_!=null)if(M){let q=F===3||F===0?R:0,st=F%2==1;Be(_,st?"left":"top",L-q),Be(_,st?"width":"height",R),Be(_,st?"top":"left",st?St:et),Be(_,st?"height":"width",st?W:Z),Sc(_,zs)}else qn(_,zs)}),Wt=qt=It=be=Ae=hn=de=kt=oe=null,Ve=1,lo(!0),et!=_t||St!=wt||Z!=jt||W!=ft){ir(!1);let _=Z/jt,M=W/ft;if(at&&!k&&pt.left>=0){pt.left*=_,pt.top*=M,rr&&Pi(rr,nn(pt.left),0,Z,W),or&&Pi(or,0,nn(pt.top),Z,W);for(let R=0;R<xn.length;R++){let L=xn[R];L!=null&&(zi[R]*=_,Hi[R]*=M,Pi(L,ri(zi[R]),ri(Hi[R]),Z,W))}}if(Oe.show&&!xt&&Oe.left>=0&&Oe.width>0){Oe.left*=_,Oe.width*=_,Oe.top*=M,Oe.height*=M;for(let R in xl)Be(cr,R,Oe[R])}_t=et,wt=St,jt=Z,ft=W}pn("setSize"),Yt=!1}E>0&&Y>0&&(h.clearRect(0,0,u.width,u.height),pn("drawClear"),I.forEach(_=>_()),pn("draw")),Oe.show&&xt&&(Vo(Oe),xt=!1),at&&k&&(Ts(null,!0,!1),k=!1),Mt.show&&Mt.live&&nt&&(_l(),nt=!1),l||(l=!0,i.status=1,pn("ready")),yt=!1,Ho=!1}i.redraw=(_,M)=>{me=M||!1,_!==!1?rs(A,C.min,C.max):sr()};function pl(_,M){let R=x[_];if(R.from==null){if(O==0){let L=R.range(i,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(O>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&R.distr==2&&O>0&&(M.min=_i(M.min,t[0]),M.max=_i(M.max,t[0]),M.min==M.max&&M.max++),j[_]=M,ie=!0,sr()}}i.setScale=pl;let ml,gl,rr,or,uh,hh,ar,lr,fh,dh,Fe,Ge,ss=!1;const _n=pt.drag;let fn=_n.x,dn=_n.y;at&&(pt.x&&(ml=ii(j_,g)),pt.y&&(gl=ii(Z_,g)),C.ori==0?(rr=ml,or=gl):(rr=gl,or=ml),Fe=pt.left,Ge=pt.top);const Oe=i.select=Je({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),cr=Oe.show?ii(K_,Oe.over?g:d):null;function Vo(_,M){if(Oe.show){for(let R in _)Oe[R]=_[R],R in xl&&Be(cr,R,_[R]);M!==!1&&pn("setSelect")}}i.setSelect=Vo;function tg(_){if(y[_].show)it&&Sc(Ut[_],zs);else if(it&&qn(Ut[_],zs),at){let R=Un?xn[0]:xn[_];R!=null&&Pi(R,-10,-10,Z,W)}}function rs(_,M,R){pl(_,{min:M,max:R})}function Ti(_,M,R,L){M.focus!=null&&rg(_),M.show!=null&&y.forEach((F,q)=>{q>0&&(_==q||_==null)&&(F.show=M.show,tg(q),s==2?(rs(F.facets[0].scale,null,null),rs(F.facets[1].scale,null,null)):rs(F.scale,null,null),sr())}),R!==!1&&pn("setSeries",_,M),L&&co("setSeries",i,_,M)}i.setSeries=Ti;function eg(_,M){Je(U[_],M)}function ng(_,M){_.fill=ae(_.fill||null),_.dir=xe(_.dir,-1),M=M??U.length,U.splice(M,0,_)}function ig(_){_==null?U.length=0:U.splice(_,1)}i.addBand=ng,i.setBand=eg,i.delBand=ig;function sg(_,M){y[_].alpha=M,at&&xn[_]!=null&&(xn[_].style.opacity=M),it&&Ut[_]&&(Ut[_].style.opacity=M)}let Vi,os,ws;const ur={focus:!0};function rg(_){if(_!=ws){let M=_==null,R=Hn.alpha!=1;y.forEach((L,F)=>{if(s==1||F>0){let q=M||F==0||F==_;L._focus=M?null:q,R&&sg(F,q?1:Hn.alpha)}}),ws=_,R&&sr()}}it&&Bi&&Pt(Kh,ot,_=>{pt._lock||(en(_),ws!=null&&Ti(null,ur,!0,je.setSeries))});function Ai(_,M,R){let L=x[M];R&&(_=_/Ee-(L.ori==1?St:et));let F=Z;L.ori==1&&(F=W,_=F-_),L.dir==-1&&(_=F-_);let q=L._min,st=L._max,lt=_/F,dt=q+(st-q)*lt,Rt=L.distr;return Rt==3?kr(10,dt):Rt==4?p0(dt,L.asinh):Rt==100?L.bwd(dt):dt}function og(_,M){let R=Ai(_,A,M);return _i(R,t[0],$,X)}i.valToIdx=_=>_i(_,t[0]),i.posToIdx=og,i.posToVal=Ai,i.valToPos=(_,M,R)=>x[M].ori==0?r(_,x[M],R?Ot:Z,R?vt:0):o(_,x[M],R?Et:W,R?Nt:0),i.setCursor=(_,M,R)=>{Fe=_.left,Ge=_.top,Ts(null,M,R)};function ph(_,M){Be(cr,dr,Oe.left=_),Be(cr,Mo,Oe.width=M)}function mh(_,M){Be(cr,uo,Oe.top=_),Be(cr,So,Oe.height=M)}let oo=C.ori==0?ph:mh,ao=C.ori==1?ph:mh;function ag(){if(it&&Mt.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&fe)continue;let M=Mt.values[_],R=0;for(let L in M)he[_][R++].firstChild.nodeValue=M[L]}}function _l(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{mt[L]=R}):v0(_.idx)||mt.fill(_.idx),Mt.idx=mt[0]),it&&Mt.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!fe)&&lg(R,mt[R]);ag()}nt=!1,M!==!1&&pn("setLegend")}i.setLegend=_l;function lg(_,M){let R=y[_],L=_==0&&V==2?ut:t[_],F;fe?F=R.values(i,_,M)??z:(F=R.value(i,M==null?null:L[M],_,M),F=F==null?z:{_:F}),Mt.values[_]=F}function Ts(_,M,R){fh=Fe,dh=Ge,[Fe,Ge]=pt.move(i,Fe,Ge),pt.left=Fe,pt.top=Ge,at&&(rr&&Pi(rr,nn(Fe),0,Z,W),or&&Pi(or,0,nn(Ge),Z,W));let L,F=$>X;Vi=De,os=null;let q=C.ori==0?Z:W,st=C.ori==1?Z:W;if(Fe<0||O==0||F){L=pt.idx=null;for(let lt=0;lt<y.length;lt++){let dt=xn[lt];dt!=null&&Pi(dt,-10,-10,Z,W)}Bi&&Ti(null,ur,!0,_==null&&je.setSeries),Mt.live&&(mt.fill(L),nt=!0)}else{let lt,dt,Rt;s==1&&(lt=C.ori==0?Fe:Ge,dt=Ai(lt,A),L=pt.idx=_i(dt,t[0],$,X),Rt=N(t[0][L],C,q,0));let Ct=-10,Lt=-10,Kt=0,ye=0,ve=!0,se="",$t="";for(let zt=s==2?1:0;zt<y.length;zt++){let ke=y[zt],qe=mt[zt],mn=qe==null?null:s==1?t[zt][qe]:t[zt][1][qe],Ce=pt.dataIdx(i,zt,L,dt),Ye=Ce==null?null:s==1?t[zt][Ce]:t[zt][1][Ce];if(nt=nt||Ye!=mn||Ce!=qe,mt[zt]=Ce,zt>0&&ke.show){let Vn=Ce==null?-10:Ce==L?Rt:N(s==1?t[0][Ce]:t[zt][0][Ce],C,q,0),Tn=Ye==null?-10:G(Ye,s==1?x[ke.scale]:x[ke.facets[1].scale],st,0);if(Bi&&Ye!=null){let ti=C.ori==1?Fe:Ge,hi=sn(Hn.dist(i,zt,Ce,Tn,ti));if(hi<Vi){let Ri=Hn.bias;if(Ri!=0){let Gn=Ai(ti,ke.scale),ei=Ye>=0?1:-1,fi=Gn>=0?1:-1;fi==ei&&(fi==1?Ri==1?Ye>=Gn:Ye<=Gn:Ri==1?Ye<=Gn:Ye>=Gn)&&(Vi=hi,os=zt)}else Vi=hi,os=zt}}if(nt||Un){let ti,hi;C.ori==0?(ti=Vn,hi=Tn):(ti=Tn,hi=Vn);let Ri,Gn,ei,fi,Ci,An,Wn=!0,As=Ue.bbox;if(As!=null){Wn=!1;let Rn=As(i,zt);ei=Rn.left,fi=Rn.top,Ri=Rn.width,Gn=Rn.height}else ei=ti,fi=hi,Ri=Gn=Ue.size(i,zt);if(An=Ue.fill(i,zt),Ci=Ue.stroke(i,zt),Un)zt==os&&Vi<=Hn.prox&&(Ct=ei,Lt=fi,Kt=Ri,ye=Gn,ve=Wn,se=An,$t=Ci);else{let Rn=xn[zt];Rn!=null&&(zi[zt]=ei,Hi[zt]=fi,nf(Rn,Ri,Gn,Wn),tf(Rn,An,Ci),Pi(Rn,ri(ei),ri(fi),Z,W))}}}}if(Un){let zt=Hn.prox,ke=ws==null?Vi<=zt:Vi>zt||os!=ws;if(nt||ke){let qe=xn[0];qe!=null&&(zi[0]=Ct,Hi[0]=Lt,nf(qe,Kt,ye,ve),tf(qe,se,$t),Pi(qe,ri(Ct),ri(Lt),Z,W))}}}if(Oe.show&&ss)if(_!=null){let[lt,dt]=je.scales,[Rt,Ct]=je.match,[Lt,Kt]=_.cursor.sync.scales,ye=_.cursor.drag;if(fn=ye._x,dn=ye._y,fn||dn){let{left:ve,top:se,width:$t,height:zt}=_.select,ke=_.scales[Lt].ori,qe=_.posToVal,mn,Ce,Ye,Vn,Tn,ti=lt!=null&&Rt(lt,Lt),hi=dt!=null&&Ct(dt,Kt);ti&&fn?(ke==0?(mn=ve,Ce=$t):(mn=se,Ce=zt),Ye=x[lt],Vn=N(qe(mn,Lt),Ye,q,0),Tn=N(qe(mn+Ce,Lt),Ye,q,0),oo(vi(Vn,Tn),sn(Tn-Vn))):oo(0,q),hi&&dn?(ke==1?(mn=ve,Ce=$t):(mn=se,Ce=zt),Ye=x[dt],Vn=G(qe(mn,Kt),Ye,st,0),Tn=G(qe(mn+Ce,Kt),Ye,st,0),ao(vi(Vn,Tn),sn(Tn-Vn))):ao(0,st)}else Ml()}else{let lt=sn(fh-uh),dt=sn(dh-hh);if(C.ori==1){let Kt=lt;lt=dt,dt=Kt}fn=_n.x&&lt>=_n.dist,dn=_n.y&&dt>=_n.dist;let Rt=_n.uni;Rt!=null?fn&&dn&&(fn=lt>=Rt,dn=dt>=Rt,!fn&&!dn&&(dt>lt?dn=!0:fn=!0)):_n.x&&_n.y&&(fn||dn)&&(fn=dn=!0);let Ct,Lt;fn&&(C.ori==0?(Ct=ar,Lt=Fe):(Ct=lr,Lt=Ge),oo(vi(Ct,Lt),sn(Lt-Ct)),dn||ao(0,st)),dn&&(C.ori==1?(Ct=ar,Lt=Fe):(Ct=lr,Lt=Ge),ao(vi(Ct,Lt),sn(Lt-Ct)),fn||oo(0,q)),!fn&&!dn&&(oo(0,0),ao(0,0))}if(_n._x=fn,_n._y=dn,_==null){if(R){if(Th!=null){let[lt,dt]=je.scales;je.values[0]=lt!=null?Ai(C.ori==0?Fe:Ge,lt):null,je.values[1]=dt!=null?Ai(C.ori==1?Fe:Ge,dt):null}co(Al,i,Fe,Ge,Z,W,L)}if(Bi){let lt=R&&je.setSeries,dt=Hn.prox;ws==null?Vi<=dt&&Ti(os,ur,!0,lt):Vi>dt?Ti(null,ur,!0,lt):os!=ws&&Ti(os,ur,!0,lt)}}nt&&(Mt.idx=L,_l()),M!==!1&&pn("setCursor")}let as=null;Object.defineProperty(i,"rect",{get(){return as==null&&lo(!1),as}});function lo(_=!1){_?as=null:(as=g.getBoundingClientRect(),pn("syncRect",as))}function gh(_,M,R,L,F,q,st){pt._lock||ss&&_!=null&&_.movementX==0&&_.movementY==0||(vl(_,M,R,L,F,q,st,!1,_!=null),_!=null?Ts(null,!0,!0):Ts(M,!0,!1))}function vl(_,M,R,L,F,q,st,lt,dt){if(as==null&&lo(!1),en(_),_!=null)R=_.clientX-as.left,L=_.clientY-as.top;else{if(R<0||L<0){Fe=-10,Ge=-10;return}let[Rt,Ct]=je.scales,Lt=M.cursor.sync,[Kt,ye]=Lt.values,[ve,se]=Lt.scales,[$t,zt]=je.match,ke=M.axes[0].side%2==1,qe=C.ori==0?Z:W,mn=C.ori==1?Z:W,Ce=ke?q:F,Ye=ke?F:q,Vn=ke?L:R,Tn=ke?R:L;if(ve!=null?R=$t(Rt,ve)?a(Kt,x[Rt],qe,0):-10:R=qe*(Vn/Ce),se!=null?L=zt(Ct,se)?a(ye,x[Ct],mn,0):-10:L=mn*(Tn/Ye),C.ori==1){let ti=R;R=L,L=ti}}dt&&(M==null||M.cursor.event.type==Al)&&((R<=1||R>=Z-1)&&(R=Fs(R,Z)),(L<=1||L>=W-1)&&(L=Fs(L,W))),lt?(uh=R,hh=L,[ar,lr]=pt.move(i,R,L)):(Fe=R,Ge=L)}const xl={width:0,height:0,left:0,top:0};function Ml(){Vo(xl,!1)}let _h,vh,xh,Mh;function Sh(_,M,R,L,F,q,st){ss=!0,fn=dn=_n._x=_n._y=!1,vl(_,M,R,L,F,q,st,!0,!1),_!=null&&(Pt(Rl,xc,yh,!1),co(qh,i,ar,lr,Z,W,null));let{left:lt,top:dt,width:Rt,height:Ct}=Oe;_h=lt,vh=dt,xh=Rt,Mh=Ct}function yh(_,M,R,L,F,q,st){ss=_n._x=_n._y=!1,vl(_,M,R,L,F,q,st,!1,!0);let{left:lt,top:dt,width:Rt,height:Ct}=Oe,Lt=Rt>0||Ct>0,Kt=_h!=lt||vh!=dt||xh!=Rt||Mh!=Ct;if(Lt&&Kt&&Vo(Oe),_n.setScale&&Lt&&Kt){let ye=lt,ve=Rt,se=dt,$t=Ct;if(C.ori==1&&(ye=dt,ve=Ct,se=lt,$t=Rt),fn&&rs(A,Ai(ye,A),Ai(ye+ve,A)),dn)for(let zt in x){let ke=x[zt];zt!=A&&ke.from==null&&ke.min!=De&&rs(zt,Ai(se+$t,zt),Ai(se,zt))}Ml()}else pt.lock&&(pt._lock=!pt._lock,Ts(M,!0,_!=null));_!=null&&(P(Rl,xc),co(Rl,i,Fe,Ge,Z,W,null))}function cg(_,M,R,L,F,q,st){if(pt._lock)return;en(_);let lt=ss;if(ss){let dt=!0,Rt=!0,Ct=10,Lt,Kt;C.ori==0?(Lt=fn,Kt=dn):(Lt=dn,Kt=fn),Lt&&Kt&&(dt=Fe<=Ct||Fe>=Z-Ct,Rt=Ge<=Ct||Ge>=W-Ct),Lt&&dt&&(Fe=Fe<ar?0:Z),Kt&&Rt&&(Ge=Ge<lr?0:W),Ts(null,!0,!0),ss=!1}Fe=-10,Ge=-10,mt.fill(null),Ts(null,!0,!0),lt&&(ss=lt)}function Eh(_,M,R,L,F,q,st){pt._lock||(en(_),Dt(),Ml(),_!=null&&co(jh,i,Fe,Ge,Z,W,null))}function bh(){T.forEach(Uv),rt(i.width,i.height,!0)}$s(ka,Ir,bh);const hr={};hr.mousedown=Sh,hr.mousemove=gh,hr.mouseup=yh,hr.dblclick=Eh,hr.setSeries=(_,M,R,L)=>{let F=je.match[2];R=F(i,M,R),R!=-1&&Ti(R,L,!0,!1)},at&&(Pt(qh,g,Sh),Pt(Al,g,gh),Pt(Yh,g,_=>{en(_),lo(!1)}),Pt(Kh,g,cg),Pt(jh,g,Eh),Ac.add(i),i.syncRect=lo);const Go=i.hooks=n.hooks||{};function pn(_,M,R){dl?ro.push([_,M,R]):_ in Go&&Go[_].forEach(L=>{L.call(null,i,M,R)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)Go[M]=(Go[M]||[]).concat(_.hooks[M])});const wh=(_,M,R)=>R,je=Je({key:null,setSeries:!1,filters:{pub:lf,sub:lf},scales:[A,y[1]?y[1].scale:null],match:[cf,cf,wh],values:[null,null]},pt.sync);je.match.length==2&&je.match.push(wh),pt.sync=je;const Th=je.key,Sl=$p(Th);function co(_,M,R,L,F,q,st){je.filters.pub(_,M,R,L,F,q,st)&&Sl.pub(_,M,R,L,F,q,st)}Sl.sub(i);function ug(_,M,R,L,F,q,st){je.filters.sub(_,M,R,L,F,q,st)&&hr[_](null,M,R,L,F,q,st)}i.pub=ug;function hg(){Sl.unsub(i),Ac.delete(i),pe.clear(),yc(ka,Ir,bh),c.remove(),ot?.remove(),pn("destroy")}i.destroy=hg;function yl(){pn("init",n,t),Ft(t||n.data,!1),j[A]?pl(A,j[A]):Dt(),xt=Oe.show&&(Oe.width>0||Oe.height>0),k=nt=!0,rt(n.width,n.height)}return y.forEach(so),T.forEach(hl),e?e instanceof HTMLElement?(e.appendChild(c),yl()):e(i,yl):yl(),i}vn.assign=Je;vn.fmtNum=Ou;vn.rangeNum=Ba;vn.rangeLog=Ja;vn.rangeAsinh=Nu;vn.orient=Zs;vn.pxRatio=Ee;vn.join=w0;vn.fmtDate=Bu,vn.tzDate=F0;vn.sync=$p;{vn.addGap=vv,vn.clipGaps=el;let n=vn.paths={points:Zp};n.linear=Qp,n.stepped=Sv,n.bars=yv,n.spline=bv}const Rs=n=>document.getElementById(n),Nv=["#7cc4ff","#56d6b0","#d59bf6","#ffb652","#f2f5f8","#ff7a5c"],[Fv,Ov]=["#ffb65238","#ffb652a0"],[kv,Bv]=[5.8,4.9],zv=3,[Hv,Vv]=[690,.78],im=({curves:n},t)=>n[t].signal==="truth"&&n.some(e=>e.signal!=="truth")?"#f2f5f8":Nv[t];function Lf(n){const t=10**Math.floor(Math.log10(n));return[8,6,5,4,3,2,1.5,1].map(e=>Number((e*t).toPrecision(2))).find(e=>e<=n*(1+1e-9))}function Gv(n,t,e,i,s){const r=Math.round(Ka(i)),o={stroke:"#a9b7c5",grid:{stroke:"#1b2733",width:1},ticks:{stroke:"#1b2733",size:4},font:`${r}px system-ui`},a={stroke:Ov,width:1,points:{show:!1}},l=n.curves.length+1,c=s?{}:{label:n.title,labelSize:r*1.35,labelFont:`${r}px system-ui`},u=n.centred&&s?{splits:(h,f,d,g)=>[-Lf(g/1.1),0,Lf(g/1.1)],values:(h,f)=>f.map(d=>d===0?"":String(d).replace("-","−"))}:{};return{width:t,height:e,legend:{show:!1},cursor:{show:!1},padding:[r*(n.names.length?1.2:.5),r*.5,0,0],hooks:{draw:[h=>$v(h,n,r)]},bands:[{series:[l,l+1],fill:Fv}],scales:{x:{time:!1},y:{range:(h,f,d)=>{if(!n.centred)return Wv([f,d,...n.levels],n.least);const g=Math.max(Math.abs(f||0),Math.abs(d||0),n.least);return[-g*1.1,g*1.1]}}},axes:[{...o,size:r*1.7,gap:1,space:r*2.8},{...o,size:r*(s?2.8:3),gap:1,space:r*1.7,...u,...c}],series:[{},...n.curves.map((h,f)=>({stroke:im(n,f),width:s?1.2:1.5,points:{show:!1}})),a,a]}}function Wv(n,t){const e=n.filter(o=>Number.isFinite(o)),[i,s]=e.length?[Math.min(...e),Math.max(...e)]:[0,t],r=Math.max((s-i)*.06,(t-(s-i))/2);return[i-r,s+r]}function $v(n,t,e){const i=n.ctx,s=vn.pxRatio,{left:r,top:o,width:a}=n.bbox;i.save(),i.strokeStyle="#8aa4bd",i.lineWidth=s,i.setLineDash([3*s,3*s]);for(const c of t.levels){const u=n.valToPos(c,"y",!0);i.beginPath(),i.moveTo(r,u),i.lineTo(r+a,u),i.stroke()}i.font=`${e*s}px system-ui`,i.textBaseline="bottom",i.textAlign="right";let l=r+a-.4*e*s;for(let c=t.names.length-1;c>=0;c-=1)i.fillStyle=im(t,c),i.fillText(t.names[c],l,o-.1*e*s),l-=i.measureText(t.names[c]).width+.9*e*s;i.restore()}class Xv{constructor(t,e,i){if(Object.assign(this,{strip:t,window:e,beside:i,element:document.createElement("div"),place:document.createElement("div")}),this.element.classList.toggle("wide",!i),i){const s=document.createElement("span");s.textContent=t.title,this.element.append(s)}this.element.append(this.place)}size(){const t=parseFloat(getComputedStyle(document.documentElement).fontSize),e=Math.floor(this.element.clientWidth),i=Math.round((this.beside?Bv:kv)*t*(innerHeight<Hv?Vv:1));return this.reserved!==i&&(this.place.style.height=`${i}px`),this.reserved=i,{width:Math.max(e,60),height:i,rem:t}}show({t,curves:e,spread:i},s){const r=this.size();(!this.plot||this.width!==r.width||this.height!==r.height)&&(this.plot&&this.plot.destroy(),this.plot=new vn(Gv(this.strip,r.width,r.height,r.rem,this.beside),[[],...e.map(()=>[]),[],[]],this.place),Object.assign(this,{width:r.width,height:r.height}));let o=t.length;if(s!==void 0)for(;o>0&&t[o-1]>s;)o-=1;let a=o;for(;a>0&&t[a-1]>(t[o-1]??0)-this.window;)a-=1;const l=u=>u.slice(a,o),c=l(i);this.plot.setData([l(t),...e.map(l),c,c.map(u=>u===null?null:-u)])}}class qv{constructor(){this.strips=[],addEventListener("resize",()=>this.strips.forEach(t=>t.size()))}setDisplay({charts:t}){Rs("strips").hidden=!t,this.note=t?.note,this.strips=(t?.strips||[]).map(i=>new Xv(i,t.window_s,t.columns>1&&!i.wide)),Rs("charts").style.setProperty("--columns",t?.columns??1),Rs("charts").replaceChildren(...this.strips.map(i=>i.element));for(const i of this.strips)i.size();Rs("charts-title").textContent=t?.title||"";const e=[["line",t?.curve],["band",t?.band]].filter(([,i])=>i);Rs("charts-key").hidden=e.length===0,Rs("charts-key").replaceChildren(...e.map(([i,s])=>{const r=document.createElement("span");return r.className=i,r.textContent=s,r}))}show(t,e,i){this.turn=!this.turn,this.strips.forEach((s,r)=>{(this.strips.length<=zv||s.plot===void 0||r%2===1===this.turn)&&s.show(t[r],i)}),this.note&&Fa(ci(e,this.note)??["",!1],Rs("charts-note"),"dim")}}const Yv=.9;function Kv([n,t]){const e=[n];for(;e[e.length-1]<t;)e.push(Math.min(2*e[e.length-1],t));return e}function jv({half_field:n,half_height_m:t},e,i){const s=Kv(n),r=t/e,o=s.findIndex(l=>l>=r),a=o<0?s.length-1:o;return i===s[a+1]&&r>Yv*s[a]?i:s[a]}const Df=n=>2*Math.atan(n)*180/Math.PI,Cs=n=>document.getElementById(n),Zv=5e3,Jv=["measured","predicted"],Qv=(n,t)=>{const e=Re(n,t);return n>0&&Number(n.toFixed(t))!==0?`+${e}`:e};class tx{constructor(){this.height=0,new ResizeObserver(([t])=>{this.height=t.borderBoxSize[0].blockSize}).observe(Cs("digits"))}setDisplay(t){const e=t?.numbers;if(Cs("digits").hidden=!e,Object.assign(this,{cells:[],tan:void 0,changedAt:-1/0}),$e(Cs("camera-field"),""),!e)return;const i=Jv.filter(a=>e.rows.some(l=>[...l.place,...l.rate].some(c=>c.role===a)));Cs("digits").style.setProperty("--digits",i.length);const s=[],r=(a,l,c)=>i.map(u=>{const h=s[s.push(document.createElement("b"))-1];h.className=u;const f=a.find(d=>d.role===u);return h.textContent=f?J.unknown:"",f&&this.cells.push({cell:h,reading:f,digits:l,isSigned:c}),h}),o=(a,l="")=>{Object.assign(s[s.push(document.createElement("span"))-1],{textContent:a,className:l})};for(const a of[e.place_unit,e.rate_unit])["",...i.map((l,c)=>c?"":a)].forEach(l=>o(l,"unit"));for(const a of e.rows)o(a.label),r(a.place,e.place_digits,a.signed),o(a.rate_label),r(a.rate,e.rate_digits,a.signed&&!a.rate_label);Cs("digits").replaceChildren(...s)}show(t,e){for(const{cell:i,reading:s,digits:r,isSigned:o}of this.cells){const a=t?On(t,s.value):void 0;$e(i,a===void 0?J.unknown:o?Qv(a,r):Re(a,r)),i.classList.toggle("stale-value",!!e&&s.role==="measured")}}field(t){if(t===void 0)return;const e=performance.now();this.tan!==void 0&&t!==this.tan&&Object.assign(this,{changedAt:e,was:this.tan}),this.tan=t;const i=e-this.changedAt<Zv,s=Me(J.field,{deg:Re(Df(t),0)});$e(Cs("camera-field"),i?`${s} ${Me(J.field_was,{deg:Re(Df(this.was),0)})}`:s),Cs("camera-field").classList.toggle("news",i)}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Xu="170",ex=0,If=1,nx=2,sm=1,ix=2,Ki=3,Ms=0,kn=1,Di=2,gs=0,Ur=1,Uf=2,Nf=3,Ff=4,sx=5,Hs=100,rx=101,ox=102,ax=103,lx=104,cx=200,ux=201,hx=202,fx=203,Cc=204,Pc=205,dx=206,px=207,mx=208,gx=209,_x=210,vx=211,xx=212,Mx=213,Sx=214,Lc=0,Dc=1,Ic=2,Vr=3,Uc=4,Nc=5,Fc=6,Oc=7,qu=0,yx=1,Ex=2,_s=0,bx=1,wx=2,Tx=3,Ax=4,Rx=5,Cx=6,Px=7,rm=300,Gr=301,Wr=302,kc=303,Bc=304,rl=306,zc=1e3,Gs=1001,Hc=1002,yi=1003,Lx=1004,Ko=1005,Ni=1006,Il=1007,Ws=1008,es=1009,om=1010,am=1011,Po=1012,Yu=1013,qs=1014,ji=1015,Io=1016,Ku=1017,ju=1018,$r=1020,lm=35902,cm=1021,um=1022,xi=1023,hm=1024,fm=1025,Nr=1026,Xr=1027,dm=1028,Zu=1029,pm=1030,Ju=1031,Qu=1033,Ra=33776,Ca=33777,Pa=33778,La=33779,Vc=35840,Gc=35841,Wc=35842,$c=35843,Xc=36196,qc=37492,Yc=37496,Kc=37808,jc=37809,Zc=37810,Jc=37811,Qc=37812,tu=37813,eu=37814,nu=37815,iu=37816,su=37817,ru=37818,ou=37819,au=37820,lu=37821,Da=36492,cu=36494,uu=36495,mm=36283,hu=36284,fu=36285,du=36286,Dx=3200,Ix=3201,gm=0,Ux=1,ms="",oi="srgb",Js="srgb-linear",ol="linear",Pe="srgb",pr=7680,Of=519,Nx=512,Fx=513,Ox=514,_m=515,kx=516,Bx=517,zx=518,Hx=519,kf=35044,Bf="300 es",Zi=2e3,Ha=2001;class Qr{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const i=this._listeners;return i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const i=this._listeners[t.type];if(i!==void 0){t.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const Sn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ia=Math.PI/180,pu=180/Math.PI;function Uo(){const n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Sn[n&255]+Sn[n>>8&255]+Sn[n>>16&255]+Sn[n>>24&255]+"-"+Sn[t&255]+Sn[t>>8&255]+"-"+Sn[t>>16&15|64]+Sn[t>>24&255]+"-"+Sn[e&63|128]+Sn[e>>8&255]+"-"+Sn[e>>16&255]+Sn[e>>24&255]+Sn[i&255]+Sn[i>>8&255]+Sn[i>>16&255]+Sn[i>>24&255]).toLowerCase()}function Dn(n,t,e){return Math.max(t,Math.min(e,n))}function Vx(n,t){return(n%t+t)%t}function Ul(n,t,e){return(1-e)*n+e*t}function fo(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Fn(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}class ce{constructor(t=0,e=0){ce.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Dn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class te{constructor(t,e,i,s,r,o,a,l,c){te.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],g=i[8],v=s[0],m=s[3],p=s[6],y=s[1],T=s[4],x=s[7],U=s[2],A=s[5],D=s[8];return r[0]=o*v+a*y+l*U,r[3]=o*m+a*T+l*A,r[6]=o*p+a*x+l*D,r[1]=c*v+u*y+h*U,r[4]=c*m+u*T+h*A,r[7]=c*p+u*x+h*D,r[2]=f*v+d*y+g*U,r[5]=f*m+d*T+g*A,r[8]=f*p+d*x+g*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return t[0]=h*v,t[1]=(s*c-u*i)*v,t[2]=(a*i-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Nl.makeScale(t,e)),this}rotate(t){return this.premultiply(Nl.makeRotation(-t)),this}translate(t,e){return this.premultiply(Nl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const Nl=new te;function vm(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Va(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Gx(){const n=Va("canvas");return n.style.display="block",n}const zf={};function Eo(n){n in zf||(zf[n]=!0,console.warn(n))}function Wx(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}function $x(n){const t=n.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function Xx(n){const t=n.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const _e={enabled:!0,workingColorSpace:Js,spaces:{},convert:function(n,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Pe&&(n.r=ts(n.r),n.g=ts(n.g),n.b=ts(n.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(n.applyMatrix3(this.spaces[t].toXYZ),n.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Pe&&(n.r=Fr(n.r),n.g=Fr(n.g),n.b=Fr(n.b))),n},fromWorkingColorSpace:function(n,t){return this.convert(n,this.workingColorSpace,t)},toWorkingColorSpace:function(n,t){return this.convert(n,t,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===ms?ol:this.spaces[n].transfer},getLuminanceCoefficients:function(n,t=this.workingColorSpace){return n.fromArray(this.spaces[t].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,t,e){return n.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}};function ts(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Fr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}const Hf=[.64,.33,.3,.6,.15,.06],Vf=[.2126,.7152,.0722],Gf=[.3127,.329],Wf=new te().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),$f=new te().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);_e.define({[Js]:{primaries:Hf,whitePoint:Gf,transfer:ol,toXYZ:Wf,fromXYZ:$f,luminanceCoefficients:Vf,workingColorSpaceConfig:{unpackColorSpace:oi},outputColorSpaceConfig:{drawingBufferColorSpace:oi}},[oi]:{primaries:Hf,whitePoint:Gf,transfer:Pe,toXYZ:Wf,fromXYZ:$f,luminanceCoefficients:Vf,outputColorSpaceConfig:{drawingBufferColorSpace:oi}}});let mr;class qx{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{mr===void 0&&(mr=Va("canvas")),mr.width=t.width,mr.height=t.height;const i=mr.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),e=mr}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Va("canvas");e.width=t.width,e.height=t.height;const i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);const s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ts(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ts(e[i]/255)*255):e[i]=ts(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let Yx=0;class xm{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Yx++}),this.uuid=Uo(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Fl(s[o].image)):r.push(Fl(s[o]))}else r=Fl(s);i.url=r}return e||(t.images[this.uuid]=i),i}}function Fl(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?qx.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let Kx=0;class Bn extends Qr{constructor(t=Bn.DEFAULT_IMAGE,e=Bn.DEFAULT_MAPPING,i=Gs,s=Gs,r=Ni,o=Ws,a=xi,l=es,c=Bn.DEFAULT_ANISOTROPY,u=ms){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Kx++}),this.uuid=Uo(),this.name="",this.source=new xm(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ce(0,0),this.repeat=new ce(1,1),this.center=new ce(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new te,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const i={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==rm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case zc:t.x=t.x-Math.floor(t.x);break;case Gs:t.x=t.x<0?0:1;break;case Hc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case zc:t.y=t.y-Math.floor(t.y);break;case Gs:t.y=t.y<0?0:1;break;case Hc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Bn.DEFAULT_IMAGE=null;Bn.DEFAULT_MAPPING=rm;Bn.DEFAULT_ANISOTROPY=1;class We{constructor(t=0,e=0,i=0,s=1){We.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,x=(d+1)/2,U=(p+1)/2,A=(u+f)/4,D=(h+v)/4,I=(g+m)/4;return T>x&&T>U?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=D/i):x>U?x<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),i=A/s,r=I/s):U<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(U),i=D/r,s=I/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(h-v)/y,this.z=(f-u)/y,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class jx extends Qr{constructor(t=1,e=1,i={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new We(0,0,t,e),this.scissorTest=!1,this.viewport=new We(0,0,t,e);const s={width:t,height:e,depth:1};i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ni,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},i);const r=new Bn(s,i.mapping,i.wrapS,i.wrapT,i.magFilter,i.minFilter,i.format,i.type,i.anisotropy,i.colorSpace);r.flipY=!1,r.generateMipmaps=i.generateMipmaps,r.internalFormat=i.internalFormat,this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.depthTexture=i.depthTexture,this.samples=i.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let i=0,s=t.textures.length;i<s;i++)this.textures[i]=t.textures[i].clone(),this.textures[i].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new xm(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Ys extends jx{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}}class Mm extends Bn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=yi,this.minFilter=yi,this.wrapR=Gs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class Zx extends Bn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=yi,this.minFilter=yi,this.wrapR=Gs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class ns{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3];const f=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==f||c!==d||u!==g){let m=1-a;const p=l*f+c*d+u*g+h*v,y=p>=0?1:-1,T=1-p*p;if(T>Number.EPSILON){const U=Math.sqrt(T),A=Math.atan2(U,p*y);m=Math.sin(m*A)/U,a=Math.sin(a*A)/U}const x=a*y;if(l=l*m+f*x,c=c*m+d*x,u=u*m+g*x,h=h*m+v*x,m===1-a){const U=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=U,c*=U,u*=U,h*=U}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=i+a+h;if(f>0){const d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){const d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){const d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<Number.EPSILON?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Dn(this.dot(t),-1,1)))}rotateTowards(t,e){const i=this.angleTo(t);if(i===0)return this;const s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const d=1-e;return this._w=d*o+e*this._w,this._x=d*i+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class B{constructor(t=0,e=0,i=0){B.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Xf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Xf.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ol.copy(this).projectOnVector(t),this.sub(Ol)}reflect(t){return this.sub(Ol.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Dn(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){const s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Ol=new B,Xf=new ns;class to{constructor(t=new B(1/0,1/0,1/0),e=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(di.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(di.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const i=di.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const i=t.geometry;if(i!==void 0){const r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,di):di.fromBufferAttribute(r,o),di.applyMatrix4(t.matrixWorld),this.expandByPoint(di);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),jo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),jo.copy(i.boundingBox)),jo.applyMatrix4(t.matrixWorld),this.union(jo)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,di),di.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(po),Zo.subVectors(this.max,po),gr.subVectors(t.a,po),_r.subVectors(t.b,po),vr.subVectors(t.c,po),ls.subVectors(_r,gr),cs.subVectors(vr,_r),Ps.subVectors(gr,vr);let e=[0,-ls.z,ls.y,0,-cs.z,cs.y,0,-Ps.z,Ps.y,ls.z,0,-ls.x,cs.z,0,-cs.x,Ps.z,0,-Ps.x,-ls.y,ls.x,0,-cs.y,cs.x,0,-Ps.y,Ps.x,0];return!kl(e,gr,_r,vr,Zo)||(e=[1,0,0,0,1,0,0,0,1],!kl(e,gr,_r,vr,Zo))?!1:(Jo.crossVectors(ls,cs),e=[Jo.x,Jo.y,Jo.z],kl(e,gr,_r,vr,Zo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,di).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(di).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Wi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Wi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Wi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Wi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Wi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Wi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Wi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Wi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Wi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Wi=[new B,new B,new B,new B,new B,new B,new B,new B],di=new B,jo=new to,gr=new B,_r=new B,vr=new B,ls=new B,cs=new B,Ps=new B,po=new B,Zo=new B,Jo=new B,Ls=new B;function kl(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ls.fromArray(n,r);const a=s.x*Math.abs(Ls.x)+s.y*Math.abs(Ls.y)+s.z*Math.abs(Ls.z),l=t.dot(Ls),c=e.dot(Ls),u=i.dot(Ls);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const Jx=new to,mo=new B,Bl=new B;class No{constructor(t=new B,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const i=this.center;e!==void 0?i.copy(e):Jx.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;mo.subVectors(t,this.center);const e=mo.lengthSq();if(e>this.radius*this.radius){const i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(mo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Bl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(mo.copy(t.center).add(Bl)),this.expandByPoint(mo.copy(t.center).sub(Bl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const $i=new B,zl=new B,Qo=new B,us=new B,Hl=new B,ta=new B,Vl=new B;class th{constructor(t=new B,e=new B(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,$i)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=$i.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):($i.copy(this.origin).addScaledVector(this.direction,e),$i.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){zl.copy(t).add(e).multiplyScalar(.5),Qo.copy(e).sub(t).normalize(),us.copy(this.origin).sub(zl);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Qo),a=us.dot(this.direction),l=-us.dot(Qo),c=us.lengthSq(),u=Math.abs(1-o*o);let h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){const v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(zl).addScaledVector(Qo,f),d}intersectSphere(t,e){$i.subVectors(t.center,this.origin);const i=$i.dot(this.direction),s=$i.dot($i)-i*i,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){const i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,$i)!==null}intersectTriangle(t,e,i,s,r){Hl.subVectors(e,t),ta.subVectors(i,t),Vl.crossVectors(Hl,ta);let o=this.direction.dot(Vl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;us.subVectors(this.origin,t);const l=a*this.direction.dot(ta.crossVectors(us,ta));if(l<0)return null;const c=a*this.direction.dot(Hl.cross(us));if(c<0||l+c>o)return null;const u=-a*us.dot(Vl);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Ne{constructor(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){Ne.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m)}set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ne().fromArray(this.elements)}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){const e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,i=t.elements,s=1/xr.setFromMatrixColumn(t,0).length(),r=1/xr.setFromMatrixColumn(t,1).length(),o=1/xr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+g,e[10]=f-v*h}else if(t.order==="XZY"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Qx,t,tM)}lookAt(t,e,i){const s=this.elements;return $n.subVectors(t,e),$n.lengthSq()===0&&($n.z=1),$n.normalize(),hs.crossVectors(i,$n),hs.lengthSq()===0&&(Math.abs(i.z)===1?$n.x+=1e-4:$n.z+=1e-4,$n.normalize(),hs.crossVectors(i,$n)),hs.normalize(),ea.crossVectors($n,hs),s[0]=hs.x,s[4]=ea.x,s[8]=$n.x,s[1]=hs.y,s[5]=ea.y,s[9]=$n.y,s[2]=hs.z,s[6]=ea.z,s[10]=$n.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],g=i[2],v=i[6],m=i[10],p=i[14],y=i[3],T=i[7],x=i[11],U=i[15],A=s[0],D=s[4],I=s[8],w=s[12],S=s[1],C=s[5],V=s[9],N=s[13],G=s[2],j=s[6],K=s[10],Q=s[14],tt=s[3],ht=s[7],ct=s[11],mt=s[15];return r[0]=o*A+a*S+l*G+c*tt,r[4]=o*D+a*C+l*j+c*ht,r[8]=o*I+a*V+l*K+c*ct,r[12]=o*w+a*N+l*Q+c*mt,r[1]=u*A+h*S+f*G+d*tt,r[5]=u*D+h*C+f*j+d*ht,r[9]=u*I+h*V+f*K+d*ct,r[13]=u*w+h*N+f*Q+d*mt,r[2]=g*A+v*S+m*G+p*tt,r[6]=g*D+v*C+m*j+p*ht,r[10]=g*I+v*V+m*K+p*ct,r[14]=g*w+v*N+m*Q+p*mt,r[3]=y*A+T*S+x*G+U*tt,r[7]=y*D+T*C+x*j+U*ht,r[11]=y*I+T*V+x*K+U*ct,r[15]=y*w+T*N+x*Q+U*mt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*f+i*c*f+s*a*d-i*l*d)+v*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+e*c*h-e*a*d-r*o*h+i*o*d+r*a*u-i*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-i*o*f+i*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],y=h*m*c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,T=g*f*c-u*m*c-g*l*d+o*m*d+u*l*p-o*f*p,x=u*v*c-g*h*c+g*a*d-o*v*d-u*a*p+o*h*p,U=g*h*l-u*v*l-g*a*f+o*v*f+u*a*m-o*h*m,A=e*y+i*T+s*x+r*U;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/A;return t[0]=y*D,t[1]=(v*f*r-h*m*r-v*s*d+i*m*d+h*s*p-i*f*p)*D,t[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*p+i*l*p)*D,t[3]=(h*l*r-a*f*r-h*s*c+i*f*c+a*s*d-i*l*d)*D,t[4]=T*D,t[5]=(u*m*r-g*f*r+g*s*d-e*m*d-u*s*p+e*f*p)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*D,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*D,t[8]=x*D,t[9]=(g*h*r-u*v*r-g*i*d+e*v*d+u*i*p-e*h*p)*D,t[10]=(o*v*r-g*a*r+g*i*c-e*v*c-o*i*p+e*a*p)*D,t[11]=(u*a*r-o*h*r-u*i*c+e*h*c+o*i*d-e*a*d)*D,t[12]=U*D,t[13]=(u*v*s-g*h*s+g*i*f-e*v*f-u*i*m+e*h*m)*D,t[14]=(g*a*s-o*v*s-g*i*l+e*v*l+o*i*m-e*a*m)*D,t[15]=(o*h*s-u*a*s+u*i*l-e*h*l-o*i*f+e*a*f)*D,this}scale(t){const e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,v=o*u,m=o*h,p=a*h,y=l*c,T=l*u,x=l*h,U=i.x,A=i.y,D=i.z;return s[0]=(1-(v+p))*U,s[1]=(d+x)*U,s[2]=(g-T)*U,s[3]=0,s[4]=(d-x)*A,s[5]=(1-(f+p))*A,s[6]=(m+y)*A,s[7]=0,s[8]=(g+T)*D,s[9]=(m-y)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){const s=this.elements;let r=xr.set(s[0],s[1],s[2]).length();const o=xr.set(s[4],s[5],s[6]).length(),a=xr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],pi.copy(this);const c=1/r,u=1/o,h=1/a;return pi.elements[0]*=c,pi.elements[1]*=c,pi.elements[2]*=c,pi.elements[4]*=u,pi.elements[5]*=u,pi.elements[6]*=u,pi.elements[8]*=h,pi.elements[9]*=h,pi.elements[10]*=h,e.setFromRotationMatrix(pi),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=Zi){const l=this.elements,c=2*r/(e-t),u=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s);let d,g;if(a===Zi)d=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===Ha)d=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=d,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Zi){const l=this.elements,c=1/(e-t),u=1/(i-s),h=1/(o-r),f=(e+t)*c,d=(i+s)*u;let g,v;if(a===Zi)g=(o+r)*h,v=-2*h;else if(a===Ha)g=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-d,l[2]=0,l[6]=0,l[10]=v,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}}const xr=new B,pi=new Ne,Qx=new B(0,0,0),tM=new B(1,1,1),hs=new B,ea=new B,$n=new B,qf=new Ne,Yf=new ns;class ki{constructor(t=0,e=0,i=0,s=ki.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(Dn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Dn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Dn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Dn(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Dn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-Dn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return qf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(qf,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Yf.setFromEuler(this),this.setFromQuaternion(Yf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}ki.DEFAULT_ORDER="XYZ";class Sm{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let eM=0;const Kf=new B,Mr=new ns,Xi=new Ne,na=new B,go=new B,nM=new B,iM=new ns,jf=new B(1,0,0),Zf=new B(0,1,0),Jf=new B(0,0,1),Qf={type:"added"},sM={type:"removed"},Sr={type:"childadded",child:null},Gl={type:"childremoved",child:null};class rn extends Qr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:eM++}),this.uuid=Uo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=rn.DEFAULT_UP.clone();const t=new B,e=new ki,i=new ns,s=new B(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ne},normalMatrix:{value:new te}}),this.matrix=new Ne,this.matrixWorld=new Ne,this.matrixAutoUpdate=rn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Sm,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Mr.setFromAxisAngle(t,e),this.quaternion.multiply(Mr),this}rotateOnWorldAxis(t,e){return Mr.setFromAxisAngle(t,e),this.quaternion.premultiply(Mr),this}rotateX(t){return this.rotateOnAxis(jf,t)}rotateY(t){return this.rotateOnAxis(Zf,t)}rotateZ(t){return this.rotateOnAxis(Jf,t)}translateOnAxis(t,e){return Kf.copy(t).applyQuaternion(this.quaternion),this.position.add(Kf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(jf,t)}translateY(t){return this.translateOnAxis(Zf,t)}translateZ(t){return this.translateOnAxis(Jf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Xi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?na.copy(t):na.set(t,e,i);const s=this.parent;this.updateWorldMatrix(!0,!1),go.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Xi.lookAt(go,na,this.up):Xi.lookAt(na,go,this.up),this.quaternion.setFromRotationMatrix(Xi),s&&(Xi.extractRotation(s.matrixWorld),Mr.setFromRotationMatrix(Xi),this.quaternion.premultiply(Mr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Qf),Sr.child=t,this.dispatchEvent(Sr),Sr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(sM),Gl.child=t,this.dispatchEvent(Gl),Gl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Xi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Xi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Xi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Qf),Sr.child=t,this.dispatchEvent(Sr),Sr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(go,t,nM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(go,iM,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){const i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){const s=t.children[i];this.add(s.clone())}return this}}rn.DEFAULT_UP=new B(0,1,0);rn.DEFAULT_MATRIX_AUTO_UPDATE=!0;rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const mi=new B,qi=new B,Wl=new B,Yi=new B,yr=new B,Er=new B,td=new B,$l=new B,Xl=new B,ql=new B,Yl=new We,Kl=new We,jl=new We;class ai{constructor(t=new B,e=new B,i=new B){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),mi.subVectors(t,e),s.cross(mi);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){mi.subVectors(s,e),qi.subVectors(i,e),Wl.subVectors(t,e);const o=mi.dot(mi),a=mi.dot(qi),l=mi.dot(Wl),c=qi.dot(qi),u=qi.dot(Wl),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Yi)===null?!1:Yi.x>=0&&Yi.y>=0&&Yi.x+Yi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Yi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Yi.x),l.addScaledVector(o,Yi.y),l.addScaledVector(a,Yi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Yl.setScalar(0),Kl.setScalar(0),jl.setScalar(0),Yl.fromBufferAttribute(t,e),Kl.fromBufferAttribute(t,i),jl.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Yl,r.x),o.addScaledVector(Kl,r.y),o.addScaledVector(jl,r.z),o}static isFrontFacing(t,e,i,s){return mi.subVectors(i,e),qi.subVectors(t,e),mi.cross(qi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return mi.subVectors(this.c,this.b),qi.subVectors(this.a,this.b),mi.cross(qi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ai.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ai.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return ai.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return ai.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ai.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const i=this.a,s=this.b,r=this.c;let o,a;yr.subVectors(s,i),Er.subVectors(r,i),$l.subVectors(t,i);const l=yr.dot($l),c=Er.dot($l);if(l<=0&&c<=0)return e.copy(i);Xl.subVectors(t,s);const u=yr.dot(Xl),h=Er.dot(Xl);if(u>=0&&h<=u)return e.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(i).addScaledVector(yr,o);ql.subVectors(t,r);const d=yr.dot(ql),g=Er.dot(ql);if(g>=0&&d<=g)return e.copy(r);const v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(Er,a);const m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return td.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(td,a);const p=1/(m+v+f);return o=v*p,a=f*p,e.copy(i).addScaledVector(yr,o).addScaledVector(Er,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const ym={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},fs={h:0,s:0,l:0},ia={h:0,s:0,l:0};function Zl(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}class le{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=oi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.toWorkingColorSpace(this,e),this}setRGB(t,e,i,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=i,_e.toWorkingColorSpace(this,s),this}setHSL(t,e,i,s=_e.workingColorSpace){if(t=Vx(t,1),e=Dn(e,0,1),i=Dn(i,0,1),e===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Zl(o,r,t+1/3),this.g=Zl(o,r,t),this.b=Zl(o,r,t-1/3)}return _e.toWorkingColorSpace(this,s),this}setStyle(t,e=oi){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=oi){const i=ym[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ts(t.r),this.g=ts(t.g),this.b=ts(t.b),this}copyLinearToSRGB(t){return this.r=Fr(t.r),this.g=Fr(t.g),this.b=Fr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=oi){return _e.fromWorkingColorSpace(yn.copy(this),t),Math.round(Dn(yn.r*255,0,255))*65536+Math.round(Dn(yn.g*255,0,255))*256+Math.round(Dn(yn.b*255,0,255))}getHexString(t=oi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.fromWorkingColorSpace(yn.copy(this),e);const i=yn.r,s=yn.g,r=yn.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=_e.workingColorSpace){return _e.fromWorkingColorSpace(yn.copy(this),e),t.r=yn.r,t.g=yn.g,t.b=yn.b,t}getStyle(t=oi){_e.fromWorkingColorSpace(yn.copy(this),t);const e=yn.r,i=yn.g,s=yn.b;return t!==oi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(fs),this.setHSL(fs.h+t,fs.s+e,fs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(fs),t.getHSL(ia);const i=Ul(fs.h,ia.h,e),s=Ul(fs.s,ia.s,e),r=Ul(fs.l,ia.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const yn=new le;le.NAMES=ym;let rM=0;class Qs extends Qr{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:rM++}),this.uuid=Uo(),this.name="",this.blending=Ur,this.side=Ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Cc,this.blendDst=Pc,this.blendEquation=Hs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new le(0,0,0),this.blendAlpha=0,this.depthFunc=Vr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Of,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=pr,this.stencilZFail=pr,this.stencilZPass=pr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const i={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Ur&&(i.blending=this.blending),this.side!==Ms&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Cc&&(i.blendSrc=this.blendSrc),this.blendDst!==Pc&&(i.blendDst=this.blendDst),this.blendEquation!==Hs&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Vr&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Of&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==pr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==pr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==pr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let i=null;if(e!==null){const s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class eo extends Qs{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new le(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ki,this.combine=qu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const Ze=new B,sa=new ce;class zn{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=kf,this.updateRanges=[],this.gpuType=ji,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)sa.fromBufferAttribute(this,e),sa.applyMatrix3(t),this.setXY(e,sa.x,sa.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ze.fromBufferAttribute(this,e),Ze.applyMatrix3(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ze.fromBufferAttribute(this,e),Ze.applyMatrix4(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ze.fromBufferAttribute(this,e),Ze.applyNormalMatrix(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ze.fromBufferAttribute(this,e),Ze.transformDirection(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=fo(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Fn(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=fo(e,this.array)),e}setX(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=fo(e,this.array)),e}setY(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=fo(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=fo(e,this.array)),e}setW(t,e){return this.normalized&&(e=Fn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array),s=Fn(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=Fn(e,this.array),i=Fn(i,this.array),s=Fn(s,this.array),r=Fn(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==kf&&(t.usage=this.usage),t}}class Em extends zn{constructor(t,e,i){super(new Uint16Array(t),e,i)}}class bm extends zn{constructor(t,e,i){super(new Uint32Array(t),e,i)}}class ze extends zn{constructor(t,e,i){super(new Float32Array(t),e,i)}}let oM=0;const ni=new Ne,Jl=new rn,br=new B,Xn=new to,_o=new to,gn=new B;class cn extends Qr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:oM++}),this.uuid=Uo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(vm(t)?bm:Em)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new te().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return ni.makeRotationFromQuaternion(t),this.applyMatrix4(ni),this}rotateX(t){return ni.makeRotationX(t),this.applyMatrix4(ni),this}rotateY(t){return ni.makeRotationY(t),this.applyMatrix4(ni),this}rotateZ(t){return ni.makeRotationZ(t),this.applyMatrix4(ni),this}translate(t,e,i){return ni.makeTranslation(t,e,i),this.applyMatrix4(ni),this}scale(t,e,i){return ni.makeScale(t,e,i),this.applyMatrix4(ni),this}lookAt(t){return Jl.lookAt(t),Jl.updateMatrix(),this.applyMatrix4(Jl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(br).negate(),this.translate(br.x,br.y,br.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const i=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ze(i,3))}else{for(let i=0,s=e.count;i<s;i++){const r=t[i];e.setXYZ(i,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new to);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){const r=e[i];Xn.setFromBufferAttribute(r),this.morphTargetsRelative?(gn.addVectors(this.boundingBox.min,Xn.min),this.boundingBox.expandByPoint(gn),gn.addVectors(this.boundingBox.max,Xn.max),this.boundingBox.expandByPoint(gn)):(this.boundingBox.expandByPoint(Xn.min),this.boundingBox.expandByPoint(Xn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new No);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(t){const i=this.boundingSphere.center;if(Xn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];_o.setFromBufferAttribute(a),this.morphTargetsRelative?(gn.addVectors(Xn.min,_o.min),Xn.expandByPoint(gn),gn.addVectors(Xn.max,_o.max),Xn.expandByPoint(gn)):(Xn.expandByPoint(_o.min),Xn.expandByPoint(_o.max))}Xn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)gn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(gn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)gn.fromBufferAttribute(a,c),l&&(br.fromBufferAttribute(t,c),gn.add(br)),s=Math.max(s,i.distanceToSquared(gn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new zn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let I=0;I<i.count;I++)a[I]=new B,l[I]=new B;const c=new B,u=new B,h=new B,f=new ce,d=new ce,g=new ce,v=new B,m=new B;function p(I,w,S){c.fromBufferAttribute(i,I),u.fromBufferAttribute(i,w),h.fromBufferAttribute(i,S),f.fromBufferAttribute(r,I),d.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),d.sub(f),g.sub(f);const C=1/(d.x*g.y-g.x*d.y);isFinite(C)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-d.y).multiplyScalar(C),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(C),a[I].add(v),a[w].add(v),a[S].add(v),l[I].add(m),l[w].add(m),l[S].add(m))}let y=this.groups;y.length===0&&(y=[{start:0,count:t.count}]);for(let I=0,w=y.length;I<w;++I){const S=y[I],C=S.start,V=S.count;for(let N=C,G=C+V;N<G;N+=3)p(t.getX(N+0),t.getX(N+1),t.getX(N+2))}const T=new B,x=new B,U=new B,A=new B;function D(I){U.fromBufferAttribute(s,I),A.copy(U);const w=a[I];T.copy(w),T.sub(U.multiplyScalar(U.dot(w))).normalize(),x.crossVectors(A,w);const C=x.dot(l[I])<0?-1:1;o.setXYZW(I,T.x,T.y,T.z,C)}for(let I=0,w=y.length;I<w;++I){const S=y[I],C=S.start,V=S.count;for(let N=C,G=C+V;N<G;N+=3)D(t.getX(N+0)),D(t.getX(N+1)),D(t.getX(N+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new zn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);const s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,h=new B;if(t)for(let f=0,d=t.count;f<d;f+=3){const g=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)gn.fromBufferAttribute(t,e),gn.normalize(),t.setXYZ(e,gn.x,gn.y,gn.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new zn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new cn,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,i);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],d=t(f,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const i=this.attributes;for(const l in i){const c=i[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const i=t.index;i!==null&&this.setIndex(i.clone(e));const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const ed=new Ne,Ds=new th,ra=new No,nd=new B,oa=new B,aa=new B,la=new B,Ql=new B,ca=new B,id=new B,ua=new B;class bn extends rn{constructor(t=new cn,e=new eo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){ca.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(Ql.fromBufferAttribute(h,t),o?ca.addScaledVector(Ql,u):ca.addScaledVector(Ql.sub(e),u))}e.add(ca)}return e}raycast(t,e){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ra.copy(i.boundingSphere),ra.applyMatrix4(r),Ds.copy(t.ray).recast(t.near),!(ra.containsPoint(Ds.origin)===!1&&(Ds.intersectSphere(ra,nd)===null||Ds.origin.distanceToSquared(nd)>(t.far-t.near)**2))&&(ed.copy(r).invert(),Ds.copy(t.ray).applyMatrix4(ed),!(i.boundingBox!==null&&Ds.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Ds)))}_computeIntersections(t,e,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),T=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,U=T;x<U;x+=3){const A=a.getX(x),D=a.getX(x+1),I=a.getX(x+2);s=ha(this,p,t,i,c,u,h,A,D,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const y=a.getX(m),T=a.getX(m+1),x=a.getX(m+2);s=ha(this,o,t,i,c,u,h,y,T,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),T=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,U=T;x<U;x+=3){const A=x,D=x+1,I=x+2;s=ha(this,p,t,i,c,u,h,A,D,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const y=m,T=m+1,x=m+2;s=ha(this,o,t,i,c,u,h,y,T,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function aM(n,t,e,i,s,r,o,a){let l;if(t.side===kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ms,a),l===null)return null;ua.copy(a),ua.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(ua);return c<e.near||c>e.far?null:{distance:c,point:ua.clone(),object:n}}function ha(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,oa),n.getVertexPosition(l,aa),n.getVertexPosition(c,la);const u=aM(n,t,e,i,oa,aa,la,id);if(u){const h=new B;ai.getBarycoord(id,oa,aa,la,h),s&&(u.uv=ai.getInterpolatedAttribute(s,a,l,c,h,new ce)),r&&(u.uv1=ai.getInterpolatedAttribute(r,a,l,c,h,new ce)),o&&(u.normal=ai.getInterpolatedAttribute(o,a,l,c,h,new B),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new B,materialIndex:0};ai.getNormal(oa,aa,la,f.normal),u.face=f,u.barycoord=h}return u}class no extends cn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ze(c,3)),this.setAttribute("normal",new ze(u,3)),this.setAttribute("uv",new ze(h,2));function g(v,m,p,y,T,x,U,A,D,I,w){const S=x/D,C=U/I,V=x/2,N=U/2,G=A/2,j=D+1,K=I+1;let Q=0,tt=0;const ht=new B;for(let ct=0;ct<K;ct++){const mt=ct*C-N;for(let Mt=0;Mt<j;Mt++){const pt=Mt*S-V;ht[v]=pt*y,ht[m]=mt*T,ht[p]=G,c.push(ht.x,ht.y,ht.z),ht[v]=0,ht[m]=0,ht[p]=A>0?1:-1,u.push(ht.x,ht.y,ht.z),h.push(Mt/D),h.push(1-ct/I),Q+=1}}for(let ct=0;ct<I;ct++)for(let mt=0;mt<D;mt++){const Mt=f+mt+j*ct,pt=f+mt+j*(ct+1),it=f+(mt+1)+j*(ct+1),at=f+(mt+1)+j*ct;l.push(Mt,pt,at),l.push(pt,it,at),tt+=6}a.addGroup(d,tt,w),d+=tt,f+=Q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new no(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function qr(n){const t={};for(const e in n){t[e]={};for(const i in n[e]){const s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function Ln(n){const t={};for(let e=0;e<n.length;e++){const i=qr(n[e]);for(const s in i)t[s]=i[s]}return t}function lM(n){const t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function wm(n){const t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}const cM={clone:qr,merge:Ln};var uM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,hM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Ss extends Qs{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=uM,this.fragmentShader=hM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=qr(t.uniforms),this.uniformsGroups=lM(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}}class Tm extends rn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ne,this.projectionMatrix=new Ne,this.projectionMatrixInverse=new Ne,this.coordinateSystem=Zi}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const ds=new B,sd=new ce,rd=new ce;class Yn extends Tm{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=pu*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(Ia*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return pu*2*Math.atan(Math.tan(Ia*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){ds.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ds.x,ds.y).multiplyScalar(-t/ds.z),ds.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ds.x,ds.y).multiplyScalar(-t/ds.z)}getViewSize(t,e){return this.getViewBounds(t,sd,rd),e.subVectors(rd,sd)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(Ia*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const wr=-90,Tr=1;class fM extends rn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Yn(wr,Tr,t,e);s.layers=this.layers,this.add(s);const r=new Yn(wr,Tr,t,e);r.layers=this.layers,this.add(r);const o=new Yn(wr,Tr,t,e);o.layers=this.layers,this.add(o);const a=new Yn(wr,Tr,t,e);a.layers=this.layers,this.add(a);const l=new Yn(wr,Tr,t,e);l.layers=this.layers,this.add(l);const c=new Yn(wr,Tr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===Zi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ha)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;const v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=v,t.setRenderTarget(i,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}}class Am extends Bn{constructor(t,e,i,s,r,o,a,l,c,u){t=t!==void 0?t:[],e=e!==void 0?e:Gr,super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class dM extends Ys{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Am(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Ni}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new no(5,5,5),r=new Ss({name:"CubemapFromEquirect",uniforms:qr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:kn,blending:gs});r.uniforms.tEquirect.value=e;const o=new bn(s,r),a=e.minFilter;return e.minFilter===Ws&&(e.minFilter=Ni),new fM(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,i,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}}const tc=new B,pM=new B,mM=new te;class ks{constructor(t=new B(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){const s=tc.subVectors(i,e).cross(pM.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const i=t.delta(tc),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const i=e||mM.getNormalMatrix(t),s=this.coplanarPoint(tc).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Is=new No,fa=new B;class eh{constructor(t=new ks,e=new ks,i=new ks,s=new ks,r=new ks,o=new ks){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Zi){const i=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],f=s[7],d=s[8],g=s[9],v=s[10],m=s[11],p=s[12],y=s[13],T=s[14],x=s[15];if(i[0].setComponents(l-r,f-c,m-d,x-p).normalize(),i[1].setComponents(l+r,f+c,m+d,x+p).normalize(),i[2].setComponents(l+o,f+u,m+g,x+y).normalize(),i[3].setComponents(l-o,f-u,m-g,x-y).normalize(),i[4].setComponents(l-a,f-h,m-v,x-T).normalize(),e===Zi)i[5].setComponents(l+a,f+h,m+v,x+T).normalize();else if(e===Ha)i[5].setComponents(a,h,v,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Is.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Is.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Is)}intersectsSprite(t){return Is.center.set(0,0,0),Is.radius=.7071067811865476,Is.applyMatrix4(t.matrixWorld),this.intersectsSphere(Is)}intersectsSphere(t){const e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let i=0;i<6;i++){const s=e[i];if(fa.x=s.normal.x>0?t.max.x:t.min.x,fa.y=s.normal.y>0?t.max.y:t.min.y,fa.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(fa)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Rm(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function gM(n){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){const u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){const g=h[f],v=h[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){const v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class al extends cn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){const y=p*f-o;for(let T=0;T<c;T++){const x=T*h-r;g.push(x,-y,0),v.push(0,0,1),m.push(T/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){const T=y+c*p,x=y+c*(p+1),U=y+1+c*(p+1),A=y+1+c*p;d.push(T,x,A),d.push(x,U,A)}this.setIndex(d),this.setAttribute("position",new ze(g,3)),this.setAttribute("normal",new ze(v,3)),this.setAttribute("uv",new ze(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new al(t.width,t.height,t.widthSegments,t.heightSegments)}}var _M=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,vM=`#ifdef USE_ALPHAHASH
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
#endif`,xM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,MM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,SM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,yM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,EM=`#ifdef USE_AOMAP
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
#endif`,bM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wM=`#ifdef USE_BATCHING
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
#endif`,TM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,AM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,RM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,CM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,PM=`#ifdef USE_IRIDESCENCE
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
#endif`,LM=`#ifdef USE_BUMPMAP
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
#endif`,DM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,IM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,UM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,NM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,FM=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,OM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,kM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,BM=`#if defined( USE_COLOR_ALPHA )
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
#endif`,zM=`#define PI 3.141592653589793
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
} // validated`,HM=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,VM=`vec3 transformedNormal = objectNormal;
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
#endif`,GM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,WM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,$M=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,XM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qM="gl_FragColor = linearToOutputTexel( gl_FragColor );",YM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,KM=`#ifdef USE_ENVMAP
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
#endif`,jM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,ZM=`#ifdef USE_ENVMAP
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
#endif`,JM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,QM=`#ifdef USE_ENVMAP
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
#endif`,tS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,eS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,nS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,iS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,sS=`#ifdef USE_GRADIENTMAP
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
}`,rS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,oS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,aS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,lS=`uniform bool receiveShadow;
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
#endif`,cS=`#ifdef USE_ENVMAP
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
#endif`,uS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,hS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,fS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,dS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,pS=`PhysicalMaterial material;
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
#endif`,mS=`struct PhysicalMaterial {
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
}`,gS=`
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
#endif`,_S=`#if defined( RE_IndirectDiffuse )
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
#endif`,vS=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,xS=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,MS=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,SS=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,yS=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ES=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,bS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,wS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,TS=`#if defined( USE_POINTS_UV )
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
#endif`,AS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,RS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,CS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,PS=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,LS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,DS=`#ifdef USE_MORPHTARGETS
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
#endif`,IS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,US=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,NS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,FS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,OS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,BS=`#ifdef USE_NORMALMAP
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
#endif`,zS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,HS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,VS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,GS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,WS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,$S=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,XS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,qS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,YS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,KS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,jS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ZS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,JS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,QS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ty=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,ey=`float getShadowMask() {
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
}`,ny=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,iy=`#ifdef USE_SKINNING
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
#endif`,sy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ry=`#ifdef USE_SKINNING
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
#endif`,oy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ay=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ly=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,cy=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,uy=`#ifdef USE_TRANSMISSION
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
#endif`,hy=`#ifdef USE_TRANSMISSION
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
#endif`,fy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,py=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,my=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const gy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,_y=`uniform sampler2D t2D;
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
}`,vy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xy=`#ifdef ENVMAP_TYPE_CUBE
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
}`,My=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Sy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yy=`#include <common>
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
}`,Ey=`#if DEPTH_PACKING == 3200
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
}`,by=`#define DISTANCE
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
}`,wy=`#define DISTANCE
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
}`,Ty=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ay=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ry=`uniform float scale;
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
}`,Cy=`uniform vec3 diffuse;
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
}`,Py=`#include <common>
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
}`,Ly=`uniform vec3 diffuse;
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
}`,Dy=`#define LAMBERT
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
}`,Iy=`#define LAMBERT
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
}`,Uy=`#define MATCAP
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
}`,Ny=`#define MATCAP
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
}`,Fy=`#define NORMAL
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
}`,Oy=`#define NORMAL
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
}`,ky=`#define PHONG
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
}`,By=`#define PHONG
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
}`,zy=`#define STANDARD
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
}`,Hy=`#define STANDARD
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
}`,Vy=`#define TOON
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
}`,Gy=`#define TOON
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
}`,Wy=`uniform float size;
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
}`,$y=`uniform vec3 diffuse;
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
}`,Xy=`#include <common>
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
}`,qy=`uniform vec3 color;
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
}`,Yy=`uniform float rotation;
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
}`,Ky=`uniform vec3 diffuse;
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
}`,ne={alphahash_fragment:_M,alphahash_pars_fragment:vM,alphamap_fragment:xM,alphamap_pars_fragment:MM,alphatest_fragment:SM,alphatest_pars_fragment:yM,aomap_fragment:EM,aomap_pars_fragment:bM,batching_pars_vertex:wM,batching_vertex:TM,begin_vertex:AM,beginnormal_vertex:RM,bsdfs:CM,iridescence_fragment:PM,bumpmap_pars_fragment:LM,clipping_planes_fragment:DM,clipping_planes_pars_fragment:IM,clipping_planes_pars_vertex:UM,clipping_planes_vertex:NM,color_fragment:FM,color_pars_fragment:OM,color_pars_vertex:kM,color_vertex:BM,common:zM,cube_uv_reflection_fragment:HM,defaultnormal_vertex:VM,displacementmap_pars_vertex:GM,displacementmap_vertex:WM,emissivemap_fragment:$M,emissivemap_pars_fragment:XM,colorspace_fragment:qM,colorspace_pars_fragment:YM,envmap_fragment:KM,envmap_common_pars_fragment:jM,envmap_pars_fragment:ZM,envmap_pars_vertex:JM,envmap_physical_pars_fragment:cS,envmap_vertex:QM,fog_vertex:tS,fog_pars_vertex:eS,fog_fragment:nS,fog_pars_fragment:iS,gradientmap_pars_fragment:sS,lightmap_pars_fragment:rS,lights_lambert_fragment:oS,lights_lambert_pars_fragment:aS,lights_pars_begin:lS,lights_toon_fragment:uS,lights_toon_pars_fragment:hS,lights_phong_fragment:fS,lights_phong_pars_fragment:dS,lights_physical_fragment:pS,lights_physical_pars_fragment:mS,lights_fragment_begin:gS,lights_fragment_maps:_S,lights_fragment_end:vS,logdepthbuf_fragment:xS,logdepthbuf_pars_fragment:MS,logdepthbuf_pars_vertex:SS,logdepthbuf_vertex:yS,map_fragment:ES,map_pars_fragment:bS,map_particle_fragment:wS,map_particle_pars_fragment:TS,metalnessmap_fragment:AS,metalnessmap_pars_fragment:RS,morphinstance_vertex:CS,morphcolor_vertex:PS,morphnormal_vertex:LS,morphtarget_pars_vertex:DS,morphtarget_vertex:IS,normal_fragment_begin:US,normal_fragment_maps:NS,normal_pars_fragment:FS,normal_pars_vertex:OS,normal_vertex:kS,normalmap_pars_fragment:BS,clearcoat_normal_fragment_begin:zS,clearcoat_normal_fragment_maps:HS,clearcoat_pars_fragment:VS,iridescence_pars_fragment:GS,opaque_fragment:WS,packing:$S,premultiplied_alpha_fragment:XS,project_vertex:qS,dithering_fragment:YS,dithering_pars_fragment:KS,roughnessmap_fragment:jS,roughnessmap_pars_fragment:ZS,shadowmap_pars_fragment:JS,shadowmap_pars_vertex:QS,shadowmap_vertex:ty,shadowmask_pars_fragment:ey,skinbase_vertex:ny,skinning_pars_vertex:iy,skinning_vertex:sy,skinnormal_vertex:ry,specularmap_fragment:oy,specularmap_pars_fragment:ay,tonemapping_fragment:ly,tonemapping_pars_fragment:cy,transmission_fragment:uy,transmission_pars_fragment:hy,uv_pars_fragment:fy,uv_pars_vertex:dy,uv_vertex:py,worldpos_vertex:my,background_vert:gy,background_frag:_y,backgroundCube_vert:vy,backgroundCube_frag:xy,cube_vert:My,cube_frag:Sy,depth_vert:yy,depth_frag:Ey,distanceRGBA_vert:by,distanceRGBA_frag:wy,equirect_vert:Ty,equirect_frag:Ay,linedashed_vert:Ry,linedashed_frag:Cy,meshbasic_vert:Py,meshbasic_frag:Ly,meshlambert_vert:Dy,meshlambert_frag:Iy,meshmatcap_vert:Uy,meshmatcap_frag:Ny,meshnormal_vert:Fy,meshnormal_frag:Oy,meshphong_vert:ky,meshphong_frag:By,meshphysical_vert:zy,meshphysical_frag:Hy,meshtoon_vert:Vy,meshtoon_frag:Gy,points_vert:Wy,points_frag:$y,shadow_vert:Xy,shadow_frag:qy,sprite_vert:Yy,sprite_frag:Ky},bt={common:{diffuse:{value:new le(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new te}},envmap:{envMap:{value:null},envMapRotation:{value:new te},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new te}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new te}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new te},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new te},normalScale:{value:new ce(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new te},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new te}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new te}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new te}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new le(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new le(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0},uvTransform:{value:new te}},sprite:{diffuse:{value:new le(16777215)},opacity:{value:1},center:{value:new ce(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}}},Li={basic:{uniforms:Ln([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:ne.meshbasic_vert,fragmentShader:ne.meshbasic_frag},lambert:{uniforms:Ln([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new le(0)}}]),vertexShader:ne.meshlambert_vert,fragmentShader:ne.meshlambert_frag},phong:{uniforms:Ln([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new le(0)},specular:{value:new le(1118481)},shininess:{value:30}}]),vertexShader:ne.meshphong_vert,fragmentShader:ne.meshphong_frag},standard:{uniforms:Ln([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new le(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag},toon:{uniforms:Ln([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new le(0)}}]),vertexShader:ne.meshtoon_vert,fragmentShader:ne.meshtoon_frag},matcap:{uniforms:Ln([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:ne.meshmatcap_vert,fragmentShader:ne.meshmatcap_frag},points:{uniforms:Ln([bt.points,bt.fog]),vertexShader:ne.points_vert,fragmentShader:ne.points_frag},dashed:{uniforms:Ln([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ne.linedashed_vert,fragmentShader:ne.linedashed_frag},depth:{uniforms:Ln([bt.common,bt.displacementmap]),vertexShader:ne.depth_vert,fragmentShader:ne.depth_frag},normal:{uniforms:Ln([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:ne.meshnormal_vert,fragmentShader:ne.meshnormal_frag},sprite:{uniforms:Ln([bt.sprite,bt.fog]),vertexShader:ne.sprite_vert,fragmentShader:ne.sprite_frag},background:{uniforms:{uvTransform:{value:new te},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ne.background_vert,fragmentShader:ne.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new te}},vertexShader:ne.backgroundCube_vert,fragmentShader:ne.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ne.cube_vert,fragmentShader:ne.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ne.equirect_vert,fragmentShader:ne.equirect_frag},distanceRGBA:{uniforms:Ln([bt.common,bt.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ne.distanceRGBA_vert,fragmentShader:ne.distanceRGBA_frag},shadow:{uniforms:Ln([bt.lights,bt.fog,{color:{value:new le(0)},opacity:{value:1}}]),vertexShader:ne.shadow_vert,fragmentShader:ne.shadow_frag}};Li.physical={uniforms:Ln([Li.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new te},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new te},clearcoatNormalScale:{value:new ce(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new te},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new te},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new te},sheen:{value:0},sheenColor:{value:new le(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new te},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new te},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new te},transmissionSamplerSize:{value:new ce},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new te},attenuationDistance:{value:0},attenuationColor:{value:new le(0)},specularColor:{value:new le(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new te},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new te},anisotropyVector:{value:new ce},anisotropyMap:{value:null},anisotropyMapTransform:{value:new te}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag};const da={r:0,b:0,g:0},Us=new ki,jy=new Ne;function Zy(n,t,e,i,s,r,o){const a=new le(0);let l=r===!0?0:1,c,u,h=null,f=0,d=null;function g(y){let T=y.isScene===!0?y.background:null;return T&&T.isTexture&&(T=(y.backgroundBlurriness>0?e:t).get(T)),T}function v(y){let T=!1;const x=g(y);x===null?p(a,l):x&&x.isColor&&(p(x,1),T=!0);const U=n.xr.getEnvironmentBlendMode();U==="additive"?i.buffers.color.setClear(0,0,0,1,o):U==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||T)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(y,T){const x=g(T);x&&(x.isCubeTexture||x.mapping===rl)?(u===void 0&&(u=new bn(new no(1,1,1),new Ss({name:"BackgroundCubeMaterial",uniforms:qr(Li.backgroundCube.uniforms),vertexShader:Li.backgroundCube.vertexShader,fragmentShader:Li.backgroundCube.fragmentShader,side:kn,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(U,A,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Us.copy(T.backgroundRotation),Us.x*=-1,Us.y*=-1,Us.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(Us.y*=-1,Us.z*=-1),u.material.uniforms.envMap.value=x,u.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(jy.makeRotationFromEuler(Us)),u.material.toneMapped=_e.getTransfer(x.colorSpace)!==Pe,(h!==x||f!==x.version||d!==n.toneMapping)&&(u.material.needsUpdate=!0,h=x,f=x.version,d=n.toneMapping),u.layers.enableAll(),y.unshift(u,u.geometry,u.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new bn(new al(2,2),new Ss({name:"BackgroundMaterial",uniforms:qr(Li.background.uniforms),vertexShader:Li.background.vertexShader,fragmentShader:Li.background.fragmentShader,side:Ms,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.toneMapped=_e.getTransfer(x.colorSpace)!==Pe,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||f!==x.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=x,f=x.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function p(y,T){y.getRGB(da,wm(n)),i.buffers.color.setClear(da.r,da.g,da.b,T,o)}return{getClearColor:function(){return a},setClearColor:function(y,T=1){a.set(y),l=T,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(y){l=y,p(a,l)},render:v,addToRenderList:m}}function Jy(n,t){const e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null);let r=s,o=!1;function a(S,C,V,N,G){let j=!1;const K=h(N,V,C);r!==K&&(r=K,c(r.object)),j=d(S,N,V,G),j&&g(S,N,V,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),(j||o)&&(o=!1,x(S,C,V,N),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(S){return n.bindVertexArray(S)}function u(S){return n.deleteVertexArray(S)}function h(S,C,V){const N=V.wireframe===!0;let G=i[S.id];G===void 0&&(G={},i[S.id]=G);let j=G[C.id];j===void 0&&(j={},G[C.id]=j);let K=j[N];return K===void 0&&(K=f(l()),j[N]=K),K}function f(S){const C=[],V=[],N=[];for(let G=0;G<e;G++)C[G]=0,V[G]=0,N[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:V,attributeDivisors:N,object:S,attributes:{},index:null}}function d(S,C,V,N){const G=r.attributes,j=C.attributes;let K=0;const Q=V.getAttributes();for(const tt in Q)if(Q[tt].location>=0){const ct=G[tt];let mt=j[tt];if(mt===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;K++}return r.attributesNum!==K||r.index!==N}function g(S,C,V,N){const G={},j=C.attributes;let K=0;const Q=V.getAttributes();for(const tt in Q)if(Q[tt].location>=0){let ct=j[tt];ct===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),G[tt]=mt,K++}r.attributes=G,r.attributesNum=K,r.index=N}function v(){const S=r.newAttributes;for(let C=0,V=S.length;C<V;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){const V=r.newAttributes,N=r.enabledAttributes,G=r.attributeDivisors;V[S]=1,N[S]===0&&(n.enableVertexAttribArray(S),N[S]=1),G[S]!==C&&(n.vertexAttribDivisor(S,C),G[S]=C)}function y(){const S=r.newAttributes,C=r.enabledAttributes;for(let V=0,N=C.length;V<N;V++)C[V]!==S[V]&&(n.disableVertexAttribArray(V),C[V]=0)}function T(S,C,V,N,G,j,K){K===!0?n.vertexAttribIPointer(S,C,V,G,j):n.vertexAttribPointer(S,C,V,N,G,j)}function x(S,C,V,N){v();const G=N.attributes,j=V.getAttributes(),K=C.defaultAttributeValues;for(const Q in j){const tt=j[Q];if(tt.location>=0){let ht=G[Q];if(ht===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ht=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ht=S.instanceColor)),ht!==void 0){const ct=ht.normalized,mt=ht.itemSize,Mt=t.get(ht);if(Mt===void 0)continue;const pt=Mt.buffer,it=Mt.type,at=Mt.bytesPerElement,gt=it===n.INT||it===n.UNSIGNED_INT||ht.gpuType===Yu;if(ht.isInterleavedBufferAttribute){const ot=ht.data,Bt=ot.stride,Ht=ht.offset;if(ot.isInstancedInterleavedBuffer){for(let Ut=0;Ut<tt.locationSize;Ut++)p(tt.location+Ut,ot.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let Ut=0;Ut<tt.locationSize;Ut++)m(tt.location+Ut);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let Ut=0;Ut<tt.locationSize;Ut++)T(tt.location+Ut,mt/tt.locationSize,it,ct,Bt*at,(Ht+mt/tt.locationSize*Ut)*at,gt)}else{if(ht.isInstancedBufferAttribute){for(let ot=0;ot<tt.locationSize;ot++)p(tt.location+ot,ht.meshPerAttribute);S.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ot=0;ot<tt.locationSize;ot++)m(tt.location+ot);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let ot=0;ot<tt.locationSize;ot++)T(tt.location+ot,mt/tt.locationSize,it,ct,mt*at,mt/tt.locationSize*ot*at,gt)}}else if(K!==void 0){const ct=K[Q];if(ct!==void 0)switch(ct.length){case 2:n.vertexAttrib2fv(tt.location,ct);break;case 3:n.vertexAttrib3fv(tt.location,ct);break;case 4:n.vertexAttrib4fv(tt.location,ct);break;default:n.vertexAttrib1fv(tt.location,ct)}}}}y()}function U(){I();for(const S in i){const C=i[S];for(const V in C){const N=C[V];for(const G in N)u(N[G].object),delete N[G];delete C[V]}delete i[S]}}function A(S){if(i[S.id]===void 0)return;const C=i[S.id];for(const V in C){const N=C[V];for(const G in N)u(N[G].object),delete N[G];delete C[V]}delete i[S.id]}function D(S){for(const C in i){const V=i[C];if(V[S.id]===void 0)continue;const N=V[S.id];for(const G in N)u(N[G].object),delete N[G];delete V[S.id]}}function I(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:w,dispose:U,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function Qy(n,t,e){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),e.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),e.update(u,i,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let d=0;for(let g=0;g<h;g++)d+=u[g];e.update(d,i,1)}function l(c,u,h,f){if(h===0)return;const d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(i,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];e.update(g,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function tE(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==xi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const I=D===Io&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==es&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==ji&&!I)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),U=g>0,A=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:T,maxFragmentUniforms:x,vertexTextures:U,maxSamples:A}}function eE(n){const t=this;let e=null,i=0,s=!1,r=!1;const o=new ks,a=new te,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){const g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{const y=r?0:i,T=y*4;let x=p.clippingState||null;l.value=x,x=u(g,f,T,d);for(let U=0;U!==T;++U)x[U]=e[U];p.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,g){const v=h!==null?h.length:0;let m=null;if(v!==0){if(m=l.value,g!==!0||m===null){const p=d+v*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,x=d;T!==v;++T,x+=4)o.copy(h[T]).applyMatrix4(y,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function nE(n){let t=new WeakMap;function e(o,a){return a===kc?o.mapping=Gr:a===Bc&&(o.mapping=Wr),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===kc||a===Bc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new dM(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}class nh extends Tm{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Cr=4,od=[.125,.215,.35,.446,.526,.582],Vs=20,ec=new nh,ad=new le;let nc=null,ic=0,sc=0,rc=!1;const Bs=(1+Math.sqrt(5))/2,Ar=1/Bs,ld=[new B(-Bs,Ar,0),new B(Bs,Ar,0),new B(-Ar,0,Bs),new B(Ar,0,Bs),new B(0,Bs,-Ar),new B(0,Bs,Ar),new B(-1,1,-1),new B(1,1,-1),new B(-1,1,1),new B(1,1,1)];class cd{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100){nc=this._renderer.getRenderTarget(),ic=this._renderer.getActiveCubeFace(),sc=this._renderer.getActiveMipmapLevel(),rc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,i,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=fd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=hd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(nc,ic,sc),this._renderer.xr.enabled=rc,t.scissorTest=!1,pa(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Gr||t.mapping===Wr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),nc=this._renderer.getRenderTarget(),ic=this._renderer.getActiveCubeFace(),sc=this._renderer.getActiveMipmapLevel(),rc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Ni,minFilter:Ni,generateMipmaps:!1,type:Io,format:xi,colorSpace:Js,depthBuffer:!1},s=ud(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=ud(t,e,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=iE(r)),this._blurMaterial=sE(r,t,e)}return s}_compileMaterial(t){const e=new bn(this._lodPlanes[0],t);this._renderer.compile(e,ec)}_sceneToCubeUV(t,e,i,s){const a=new Yn(90,1,e,i),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,f=u.toneMapping;u.getClearColor(ad),u.toneMapping=_s,u.autoClear=!1;const d=new eo({name:"PMREM.Background",side:kn,depthWrite:!1,depthTest:!1}),g=new bn(new no,d);let v=!1;const m=t.background;m?m.isColor&&(d.color.copy(m),t.background=null,v=!0):(d.color.copy(ad),v=!0);for(let p=0;p<6;p++){const y=p%3;y===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):y===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));const T=this._cubeSize;pa(s,y*T,p>2?T:0,T,T),u.setRenderTarget(s),v&&u.render(g,a),u.render(t,a)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=f,u.autoClear=h,t.background=m}_textureToCubeUV(t,e){const i=this._renderer,s=t.mapping===Gr||t.mapping===Wr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=fd()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=hd());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new bn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;pa(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,ec)}_applyPMREM(t){const e=this._renderer,i=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=ld[(s-r-1)%ld.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new bn(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[i]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Vs-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):Vs;m>Vs&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Vs}`);const p=[];let y=0;for(let D=0;D<Vs;++D){const I=D/v,w=Math.exp(-I*I/2);p.push(w),D===0?y+=w:D<m&&(y+=2*w)}for(let D=0;D<p.length;D++)p[D]=p[D]/y;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:T}=this;f.dTheta.value=g,f.mipInt.value=T-i;const x=this._sizeLods[s],U=3*x*(s>T-Cr?s-T+Cr:0),A=4*(this._cubeSize-x);pa(e,U,A,3*x,2*x),l.setRenderTarget(e),l.render(h,ec)}}function iE(n){const t=[],e=[],i=[];let s=n;const r=n-Cr+1+od.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>n-Cr?l=od[o-n+Cr-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,g=6,v=3,m=2,p=1,y=new Float32Array(v*g*d),T=new Float32Array(m*g*d),x=new Float32Array(p*g*d);for(let A=0;A<d;A++){const D=A%3*2/3-1,I=A>2?0:-1,w=[D,I,0,D+2/3,I,0,D+2/3,I+1,0,D,I,0,D+2/3,I+1,0,D,I+1,0];y.set(w,v*g*A),T.set(f,m*g*A);const S=[A,A,A,A,A,A];x.set(S,p*g*A)}const U=new cn;U.setAttribute("position",new zn(y,v)),U.setAttribute("uv",new zn(T,m)),U.setAttribute("faceIndex",new zn(x,p)),t.push(U),s>Cr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function ud(n,t,e){const i=new Ys(n,t,e);return i.texture.mapping=rl,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function pa(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function sE(n,t,e){const i=new Float32Array(Vs),s=new B(0,1,0);return new Ss({name:"SphericalGaussianBlur",defines:{n:Vs,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:ih(),fragmentShader:`

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
		`,blending:gs,depthTest:!1,depthWrite:!1})}function hd(){return new Ss({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:ih(),fragmentShader:`

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
		`,blending:gs,depthTest:!1,depthWrite:!1})}function fd(){return new Ss({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:ih(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:gs,depthTest:!1,depthWrite:!1})}function ih(){return`

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
	`}function rE(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===kc||l===Bc,u=l===Gr||l===Wr;if(c||u){let h=t.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new cd(n)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new cd(n)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function oE(n){const t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){const s=e(i);return s===null&&Eo("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function aE(n,t,e,i){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&t.remove(f.index);for(const g in f.attributes)t.remove(f.attributes[g]);for(const g in f.morphAttributes){const v=f.morphAttributes[g];for(let m=0,p=v.length;m<p;m++)t.remove(v[m])}f.removeEventListener("dispose",o),delete s[f.id];const d=r.get(f);d&&(t.remove(d),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){const f=h.attributes;for(const g in f)t.update(f[g],n.ARRAY_BUFFER);const d=h.morphAttributes;for(const g in d){const v=d[g];for(let m=0,p=v.length;m<p;m++)t.update(v[m],n.ARRAY_BUFFER)}}function c(h){const f=[],d=h.index,g=h.attributes.position;let v=0;if(d!==null){const y=d.array;v=d.version;for(let T=0,x=y.length;T<x;T+=3){const U=y[T+0],A=y[T+1],D=y[T+2];f.push(U,A,A,D,D,U)}}else if(g!==void 0){const y=g.array;v=g.version;for(let T=0,x=y.length/3-1;T<x;T+=3){const U=T+0,A=T+1,D=T+2;f.push(U,A,A,D,D,U)}}else return;const m=new(vm(f)?bm:Em)(f,1);m.version=v;const p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){const f=r.get(h);if(f){const d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function lE(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,r,f*o),e.update(d,i,1)}function c(f,d,g){g!==0&&(n.drawElementsInstanced(i,d,r,f*o,g),e.update(d,i,g))}function u(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,i,1)}function h(f,d,g,v){if(g===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(i,d,0,r,f,0,v,0,g);let p=0;for(let y=0;y<g;y++)p+=d[y]*v[y];e.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function cE(n){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function uE(n,t,e){const i=new WeakMap,s=new We;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=i.get(a);if(f===void 0||f.count!==h){let w=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();const d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[];let T=0;d===!0&&(T=1),g===!0&&(T=2),v===!0&&(T=3);let x=a.attributes.position.count*T,U=1;x>t.maxTextureSize&&(U=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);const A=new Float32Array(x*U*4*h),D=new Mm(A,x,U,h);D.type=ji,D.needsUpdate=!0;const I=T*4;for(let S=0;S<h;S++){const C=m[S],V=p[S],N=y[S],G=x*U*4*S;for(let j=0;j<C.count;j++){const K=j*I;d===!0&&(s.fromBufferAttribute(C,j),A[G+K+0]=s.x,A[G+K+1]=s.y,A[G+K+2]=s.z,A[G+K+3]=0),g===!0&&(s.fromBufferAttribute(V,j),A[G+K+4]=s.x,A[G+K+5]=s.y,A[G+K+6]=s.z,A[G+K+7]=0),v===!0&&(s.fromBufferAttribute(N,j),A[G+K+8]=s.x,A[G+K+9]=s.y,A[G+K+10]=s.z,A[G+K+11]=N.itemSize===4?s.w:1)}}f={count:h,texture:D,size:new ce(x,U)},i.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];const g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function hE(n,t,e,i){let s=new WeakMap;function r(l){const c=i.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class Cm extends Bn{constructor(t,e,i,s,r,o,a,l,c,u=Nr){if(u!==Nr&&u!==Xr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");i===void 0&&u===Nr&&(i=qs),i===void 0&&u===Xr&&(i=$r),super(null,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:yi,this.minFilter=l!==void 0?l:yi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const Pm=new Bn,dd=new Cm(1,1),Lm=new Mm,Dm=new Zx,Im=new Am,pd=[],md=[],gd=new Float32Array(16),_d=new Float32Array(9),vd=new Float32Array(4);function io(n,t,e){const i=n[0];if(i<=0||i>0)return n;const s=t*e;let r=pd[s];if(r===void 0&&(r=new Float32Array(s),pd[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function on(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function an(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function ll(n,t){let e=md[t];e===void 0&&(e=new Int32Array(t),md[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function fE(n,t){const e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function dE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(on(e,t))return;n.uniform2fv(this.addr,t),an(e,t)}}function pE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(on(e,t))return;n.uniform3fv(this.addr,t),an(e,t)}}function mE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(on(e,t))return;n.uniform4fv(this.addr,t),an(e,t)}}function gE(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(on(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),an(e,t)}else{if(on(e,i))return;vd.set(i),n.uniformMatrix2fv(this.addr,!1,vd),an(e,i)}}function _E(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(on(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),an(e,t)}else{if(on(e,i))return;_d.set(i),n.uniformMatrix3fv(this.addr,!1,_d),an(e,i)}}function vE(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(on(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),an(e,t)}else{if(on(e,i))return;gd.set(i),n.uniformMatrix4fv(this.addr,!1,gd),an(e,i)}}function xE(n,t){const e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function ME(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(on(e,t))return;n.uniform2iv(this.addr,t),an(e,t)}}function SE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(on(e,t))return;n.uniform3iv(this.addr,t),an(e,t)}}function yE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(on(e,t))return;n.uniform4iv(this.addr,t),an(e,t)}}function EE(n,t){const e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function bE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(on(e,t))return;n.uniform2uiv(this.addr,t),an(e,t)}}function wE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(on(e,t))return;n.uniform3uiv(this.addr,t),an(e,t)}}function TE(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(on(e,t))return;n.uniform4uiv(this.addr,t),an(e,t)}}function AE(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(dd.compareFunction=_m,r=dd):r=Pm,e.setTexture2D(t||r,s)}function RE(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Dm,s)}function CE(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||Im,s)}function PE(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Lm,s)}function LE(n){switch(n){case 5126:return fE;case 35664:return dE;case 35665:return pE;case 35666:return mE;case 35674:return gE;case 35675:return _E;case 35676:return vE;case 5124:case 35670:return xE;case 35667:case 35671:return ME;case 35668:case 35672:return SE;case 35669:case 35673:return yE;case 5125:return EE;case 36294:return bE;case 36295:return wE;case 36296:return TE;case 35678:case 36198:case 36298:case 36306:case 35682:return AE;case 35679:case 36299:case 36307:return RE;case 35680:case 36300:case 36308:case 36293:return CE;case 36289:case 36303:case 36311:case 36292:return PE}}function DE(n,t){n.uniform1fv(this.addr,t)}function IE(n,t){const e=io(t,this.size,2);n.uniform2fv(this.addr,e)}function UE(n,t){const e=io(t,this.size,3);n.uniform3fv(this.addr,e)}function NE(n,t){const e=io(t,this.size,4);n.uniform4fv(this.addr,e)}function FE(n,t){const e=io(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function OE(n,t){const e=io(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function kE(n,t){const e=io(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function BE(n,t){n.uniform1iv(this.addr,t)}function zE(n,t){n.uniform2iv(this.addr,t)}function HE(n,t){n.uniform3iv(this.addr,t)}function VE(n,t){n.uniform4iv(this.addr,t)}function GE(n,t){n.uniform1uiv(this.addr,t)}function WE(n,t){n.uniform2uiv(this.addr,t)}function $E(n,t){n.uniform3uiv(this.addr,t)}function XE(n,t){n.uniform4uiv(this.addr,t)}function qE(n,t,e){const i=this.cache,s=t.length,r=ll(e,s);on(i,r)||(n.uniform1iv(this.addr,r),an(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Pm,r[o])}function YE(n,t,e){const i=this.cache,s=t.length,r=ll(e,s);on(i,r)||(n.uniform1iv(this.addr,r),an(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Dm,r[o])}function KE(n,t,e){const i=this.cache,s=t.length,r=ll(e,s);on(i,r)||(n.uniform1iv(this.addr,r),an(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Im,r[o])}function jE(n,t,e){const i=this.cache,s=t.length,r=ll(e,s);on(i,r)||(n.uniform1iv(this.addr,r),an(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Lm,r[o])}function ZE(n){switch(n){case 5126:return DE;case 35664:return IE;case 35665:return UE;case 35666:return NE;case 35674:return FE;case 35675:return OE;case 35676:return kE;case 5124:case 35670:return BE;case 35667:case 35671:return zE;case 35668:case 35672:return HE;case 35669:case 35673:return VE;case 5125:return GE;case 36294:return WE;case 36295:return $E;case 36296:return XE;case 35678:case 36198:case 36298:case 36306:case 35682:return qE;case 35679:case 36299:case 36307:return YE;case 35680:case 36300:case 36308:case 36293:return KE;case 36289:case 36303:case 36311:case 36292:return jE}}class JE{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=LE(e.type)}}class QE{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=ZE(e.type)}}class tb{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],i)}}}const oc=/(\w+)(\])?(\[|\.)?/g;function xd(n,t){n.seq.push(t),n.map[t.id]=t}function eb(n,t,e){const i=n.name,s=i.length;for(oc.lastIndex=0;;){const r=oc.exec(i),o=oc.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){xd(e,c===void 0?new JE(a,n,t):new QE(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new tb(a),xd(e,h)),e=h}}}class Ua{constructor(t,e){this.seq=[],this.map={};const i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);eb(r,o,this)}}setValue(t,e,i,s){const r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){const s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const i=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&i.push(o)}return i}}function Md(n,t,e){const i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}const nb=37297;let ib=0;function sb(n,t){const e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}const Sd=new te;function rb(n){_e._getMatrix(Sd,_e.workingColorSpace,n);const t=`mat3( ${Sd.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(n)){case ol:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function yd(n,t,e){const i=n.getShaderParameter(t,n.COMPILE_STATUS),s=n.getShaderInfoLog(t).trim();if(i&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+sb(n.getShaderSource(t),o)}else return s}function ob(n,t){const e=rb(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function ab(n,t){let e;switch(t){case bx:e="Linear";break;case wx:e="Reinhard";break;case Tx:e="Cineon";break;case Ax:e="ACESFilmic";break;case Cx:e="AgX";break;case Px:e="Neutral";break;case Rx:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const ma=new B;function lb(){_e.getLuminanceCoefficients(ma);const n=ma.x.toFixed(4),t=ma.y.toFixed(4),e=ma.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function cb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(bo).join(`
`)}function ub(n){const t=[];for(const e in n){const i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function hb(n,t){const e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(t,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function bo(n){return n!==""}function Ed(n,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function bd(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const fb=/^[ \t]*#include +<([\w\d./]+)>/gm;function mu(n){return n.replace(fb,pb)}const db=new Map;function pb(n,t){let e=ne[t];if(e===void 0){const i=db.get(t);if(i!==void 0)e=ne[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return mu(e)}const mb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function wd(n){return n.replace(mb,gb)}function gb(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Td(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}function _b(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===sm?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===ix?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===Ki&&(t="SHADOWMAP_TYPE_VSM"),t}function vb(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Gr:case Wr:t="ENVMAP_TYPE_CUBE";break;case rl:t="ENVMAP_TYPE_CUBE_UV";break}return t}function xb(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case Wr:t="ENVMAP_MODE_REFRACTION";break}return t}function Mb(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case qu:t="ENVMAP_BLENDING_MULTIPLY";break;case yx:t="ENVMAP_BLENDING_MIX";break;case Ex:t="ENVMAP_BLENDING_ADD";break}return t}function Sb(n){const t=n.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function yb(n,t,e,i){const s=n.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=_b(e),c=vb(e),u=xb(e),h=Mb(e),f=Sb(e),d=cb(e),g=ub(r),v=s.createProgram();let m,p,y=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(bo).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(bo).join(`
`),p.length>0&&(p+=`
`)):(m=[Td(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(bo).join(`
`),p=[Td(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==_s?"#define TONE_MAPPING":"",e.toneMapping!==_s?ne.tonemapping_pars_fragment:"",e.toneMapping!==_s?ab("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ne.colorspace_pars_fragment,ob("linearToOutputTexel",e.outputColorSpace),lb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(bo).join(`
`)),o=mu(o),o=Ed(o,e),o=bd(o,e),a=mu(a),a=Ed(a,e),a=bd(a,e),o=wd(o),a=wd(a),e.isRawShaderMaterial!==!0&&(y=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===Bf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Bf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const T=y+m+o,x=y+p+a,U=Md(s,s.VERTEX_SHADER,T),A=Md(s,s.FRAGMENT_SHADER,x);s.attachShader(v,U),s.attachShader(v,A),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(n.debug.checkShaderErrors){const V=s.getProgramInfoLog(v).trim(),N=s.getShaderInfoLog(U).trim(),G=s.getShaderInfoLog(A).trim();let j=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(j=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,U,A);else{const Q=yd(s,U,"vertex"),tt=yd(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+V+`
`+Q+`
`+tt)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(N===""||G==="")&&(K=!1);K&&(C.diagnostics={runnable:j,programLog:V,vertexShader:{log:N,prefix:m},fragmentShader:{log:G,prefix:p}})}s.deleteShader(U),s.deleteShader(A),I=new Ua(s,v),w=hb(s,v)}let I;this.getUniforms=function(){return I===void 0&&D(this),I};let w;this.getAttributes=function(){return w===void 0&&D(this),w};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,nb)),S},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=ib++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=U,this.fragmentShader=A,this}let Eb=0;class bb{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){const e=this.shaderCache;let i=e.get(t);return i===void 0&&(i=new wb(t),e.set(t,i)),i}}class wb{constructor(t){this.id=Eb++,this.code=t,this.usedTimes=0}}function Tb(n,t,e,i,s,r,o){const a=new Sm,l=new bb,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let d=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function m(w,S,C,V,N){const G=V.fog,j=N.geometry,K=w.isMeshStandardMaterial?V.environment:null,Q=(w.isMeshStandardMaterial?e:t).get(w.envMap||K),tt=Q&&Q.mapping===rl?Q.image.height:null,ht=g[w.type];w.precision!==null&&(d=s.getMaxPrecision(w.precision),d!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",d,"instead."));const ct=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mt=ct!==void 0?ct.length:0;let Mt=0;j.morphAttributes.position!==void 0&&(Mt=1),j.morphAttributes.normal!==void 0&&(Mt=2),j.morphAttributes.color!==void 0&&(Mt=3);let pt,it,at,gt;if(ht){const Se=Li[ht];pt=Se.vertexShader,it=Se.fragmentShader}else pt=w.vertexShader,it=w.fragmentShader,l.update(w),at=l.getVertexShaderID(w),gt=l.getFragmentShaderID(w);const ot=n.getRenderTarget(),Bt=n.state.buffers.depth.getReversed(),Ht=N.isInstancedMesh===!0,Ut=N.isBatchedMesh===!0,he=!!w.map,Zt=!!w.matcap,fe=!!Q,z=!!w.aoMap,tn=!!w.lightMap,Qt=!!w.bumpMap,ee=!!w.normalMap,Gt=!!w.displacementMap,pe=!!w.emissiveMap,Pt=!!w.metalnessMap,P=!!w.roughnessMap,E=w.anisotropy>0,Y=w.clearcoat>0,Z=w.dispersion>0,W=w.iridescence>0,et=w.sheen>0,St=w.transmission>0,_t=E&&!!w.anisotropyMap,wt=Y&&!!w.clearcoatMap,jt=Y&&!!w.clearcoatNormalMap,ft=Y&&!!w.clearcoatRoughnessMap,vt=W&&!!w.iridescenceMap,Nt=W&&!!w.iridescenceThicknessMap,Ot=et&&!!w.sheenColorMap,Et=et&&!!w.sheenRoughnessMap,ie=!!w.specularMap,Yt=!!w.specularColorMap,me=!!w.specularIntensityMap,k=St&&!!w.transmissionMap,xt=St&&!!w.thicknessMap,nt=!!w.gradientMap,rt=!!w.alphaMap,Tt=w.alphaTest>0,At=!!w.alphaHash,Jt=!!w.extensions;let He=_s;w.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(He=n.toneMapping);const un={shaderID:ht,shaderType:w.type,shaderName:w.name,vertexShader:pt,fragmentShader:it,defines:w.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:d,batching:Ut,batchingColor:Ut&&N._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&N.instanceColor!==null,instancingMorph:Ht&&N.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ot===null?n.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:Js,alphaToCoverage:!!w.alphaToCoverage,map:he,matcap:Zt,envMap:fe,envMapMode:fe&&Q.mapping,envMapCubeUVHeight:tt,aoMap:z,lightMap:tn,bumpMap:Qt,normalMap:ee,displacementMap:f&&Gt,emissiveMap:pe,normalMapObjectSpace:ee&&w.normalMapType===Ux,normalMapTangentSpace:ee&&w.normalMapType===gm,metalnessMap:Pt,roughnessMap:P,anisotropy:E,anisotropyMap:_t,clearcoat:Y,clearcoatMap:wt,clearcoatNormalMap:jt,clearcoatRoughnessMap:ft,dispersion:Z,iridescence:W,iridescenceMap:vt,iridescenceThicknessMap:Nt,sheen:et,sheenColorMap:Ot,sheenRoughnessMap:Et,specularMap:ie,specularColorMap:Yt,specularIntensityMap:me,transmission:St,transmissionMap:k,thicknessMap:xt,gradientMap:nt,opaque:w.transparent===!1&&w.blending===Ur&&w.alphaToCoverage===!1,alphaMap:rt,alphaTest:Tt,alphaHash:At,combine:w.combine,mapUv:he&&v(w.map.channel),aoMapUv:z&&v(w.aoMap.channel),lightMapUv:tn&&v(w.lightMap.channel),bumpMapUv:Qt&&v(w.bumpMap.channel),normalMapUv:ee&&v(w.normalMap.channel),displacementMapUv:Gt&&v(w.displacementMap.channel),emissiveMapUv:pe&&v(w.emissiveMap.channel),metalnessMapUv:Pt&&v(w.metalnessMap.channel),roughnessMapUv:P&&v(w.roughnessMap.channel),anisotropyMapUv:_t&&v(w.anisotropyMap.channel),clearcoatMapUv:wt&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:jt&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:Ot&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:Et&&v(w.sheenRoughnessMap.channel),specularMapUv:ie&&v(w.specularMap.channel),specularColorMapUv:Yt&&v(w.specularColorMap.channel),specularIntensityMapUv:me&&v(w.specularIntensityMap.channel),transmissionMapUv:k&&v(w.transmissionMap.channel),thicknessMapUv:xt&&v(w.thicknessMap.channel),alphaMapUv:rt&&v(w.alphaMap.channel),vertexTangents:!!j.attributes.tangent&&(ee||E),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!j.attributes.uv&&(he||rt),fog:!!G,useFog:w.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:w.flatShading===!0,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:Bt,skinning:N.isSkinnedMesh===!0,morphTargets:j.morphAttributes.position!==void 0,morphNormals:j.morphAttributes.normal!==void 0,morphColors:j.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:Mt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:He,decodeVideoTexture:he&&w.map.isVideoTexture===!0&&_e.getTransfer(w.map.colorSpace)===Pe,decodeVideoTextureEmissive:pe&&w.emissiveMap.isVideoTexture===!0&&_e.getTransfer(w.emissiveMap.colorSpace)===Pe,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Di,flipSided:w.side===kn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Jt&&w.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&w.extensions.multiDraw===!0||Ut)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return un.vertexUv1s=c.has(1),un.vertexUv2s=c.has(2),un.vertexUv3s=c.has(3),c.clear(),un}function p(w){const S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(w.customFragmentShaderID)),w.defines!==void 0)for(const C in w.defines)S.push(C),S.push(w.defines[C]);return w.isRawShaderMaterial===!1&&(y(S,w),T(S,w),S.push(n.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function y(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function T(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}function x(w){const S=g[w.type];let C;if(S){const V=Li[S];C=cM.clone(V.uniforms)}else C=w.uniforms;return C}function U(w,S){let C;for(let V=0,N=u.length;V<N;V++){const G=u[V];if(G.cacheKey===S){C=G,++C.usedTimes;break}}return C===void 0&&(C=new yb(n,S,w,r),u.push(C)),C}function A(w){if(--w.usedTimes===0){const S=u.indexOf(w);u[S]=u[u.length-1],u.pop(),w.destroy()}}function D(w){l.remove(w)}function I(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:x,acquireProgram:U,releaseProgram:A,releaseShaderCache:D,programs:u,dispose:I}}function Ab(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Rb(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function Ad(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Rd(){const n=[];let t=0;const e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h,f,d,g,v,m){let p=n[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},n[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.push(p):d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||Rb),i.length>1&&i.sort(f||Ad),s.length>1&&s.sort(f||Ad)}function u(){for(let h=t,f=n.length;h<f;h++){const d=n[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function Cb(){let n=new WeakMap;function t(i,s){const r=n.get(i);let o;return r===void 0?(o=new Rd,n.set(i,[o])):s>=r.length?(o=new Rd,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function Pb(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new B,color:new le};break;case"SpotLight":e={position:new B,direction:new B,color:new le,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new B,color:new le,distance:0,decay:0};break;case"HemisphereLight":e={direction:new B,skyColor:new le,groundColor:new le};break;case"RectAreaLight":e={color:new le,position:new B,halfWidth:new B,halfHeight:new B};break}return n[t.id]=e,e}}}function Lb(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ce};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ce};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ce,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}let Db=0;function Ib(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function Ub(n){const t=new Pb,e=Lb(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);const s=new B,r=new Ne,o=new Ne;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)i.probe[w].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,y=0,T=0,x=0,U=0,A=0,D=0;c.sort(Ib);for(let w=0,S=c.length;w<S;w++){const C=c[w],V=C.color,N=C.intensity,G=C.distance,j=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=V.r*N,h+=V.g*N,f+=V.b*N;else if(C.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(C.sh.coefficients[K],N);D++}else if(C.isDirectionalLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.directionalShadow[d]=tt,i.directionalShadowMap[d]=j,i.directionalShadowMatrix[d]=C.shadow.matrix,y++}i.directional[d]=K,d++}else if(C.isSpotLight){const K=t.get(C);K.position.setFromMatrixPosition(C.matrixWorld),K.color.copy(V).multiplyScalar(N),K.distance=G,K.coneCos=Math.cos(C.angle),K.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),K.decay=C.decay,i.spot[v]=K;const Q=C.shadow;if(C.map&&(i.spotLightMap[U]=C.map,U++,Q.updateMatrices(C),C.castShadow&&A++),i.spotLightMatrix[v]=Q.matrix,C.castShadow){const tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.spotShadow[v]=tt,i.spotShadowMap[v]=j,x++}v++}else if(C.isRectAreaLight){const K=t.get(C);K.color.copy(V).multiplyScalar(N),K.halfWidth.set(C.width*.5,0,0),K.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=K,m++}else if(C.isPointLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),K.distance=C.distance,K.decay=C.decay,C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,i.pointShadow[g]=tt,i.pointShadowMap[g]=j,i.pointShadowMatrix[g]=C.shadow.matrix,T++}i.point[g]=K,g++}else if(C.isHemisphereLight){const K=t.get(C);K.skyColor.copy(C.color).multiplyScalar(N),K.groundColor.copy(C.groundColor).multiplyScalar(N),i.hemi[p]=K,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=bt.LTC_FLOAT_1,i.rectAreaLTC2=bt.LTC_FLOAT_2):(i.rectAreaLTC1=bt.LTC_HALF_1,i.rectAreaLTC2=bt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;const I=i.hash;(I.directionalLength!==d||I.pointLength!==g||I.spotLength!==v||I.rectAreaLength!==m||I.hemiLength!==p||I.numDirectionalShadows!==y||I.numPointShadows!==T||I.numSpotShadows!==x||I.numSpotMaps!==U||I.numLightProbes!==D)&&(i.directional.length=d,i.spot.length=v,i.rectArea.length=m,i.point.length=g,i.hemi.length=p,i.directionalShadow.length=y,i.directionalShadowMap.length=y,i.pointShadow.length=T,i.pointShadowMap.length=T,i.spotShadow.length=x,i.spotShadowMap.length=x,i.directionalShadowMatrix.length=y,i.pointShadowMatrix.length=T,i.spotLightMatrix.length=x+U-A,i.spotLightMap.length=U,i.numSpotLightShadowsWithMaps=A,i.numLightProbes=D,I.directionalLength=d,I.pointLength=g,I.spotLength=v,I.rectAreaLength=m,I.hemiLength=p,I.numDirectionalShadows=y,I.numPointShadows=T,I.numSpotShadows=x,I.numSpotMaps=U,I.numLightProbes=D,i.version=Db++)}function l(c,u){let h=0,f=0,d=0,g=0,v=0;const m=u.matrixWorldInverse;for(let p=0,y=c.length;p<y;p++){const T=c[p];if(T.isDirectionalLight){const x=i.directional[h];x.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),h++}else if(T.isSpotLight){const x=i.spot[d];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),d++}else if(T.isRectAreaLight){const x=i.rectArea[g];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(T.width*.5,0,0),x.halfHeight.set(0,T.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),g++}else if(T.isPointLight){const x=i.point[f];x.position.setFromMatrixPosition(T.matrixWorld),x.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){const x=i.hemi[v];x.direction.setFromMatrixPosition(T.matrixWorld),x.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function Cd(n){const t=new Ub(n),e=[],i=[];function s(u){c.camera=u,e.length=0,i.length=0}function r(u){e.push(u)}function o(u){i.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function Nb(n){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new Cd(n),t.set(s,[a])):r>=o.length?(a=new Cd(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}class Fb extends Qs{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=Dx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class Ob extends Qs{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const kb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Bb=`uniform sampler2D shadow_pass;
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
}`;function zb(n,t,e){let i=new eh;const s=new ce,r=new ce,o=new We,a=new Fb({depthPacking:Ix}),l=new Ob,c={},u=e.maxTextureSize,h={[Ms]:kn,[kn]:Ms,[Di]:Di},f=new Ss({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ce},radius:{value:4}},vertexShader:kb,fragmentShader:Bb}),d=f.clone();d.defines.HORIZONTAL_PASS=1;const g=new cn;g.setAttribute("position",new zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new bn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=sm;let p=this.type;this.render=function(A,D,I){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;const w=n.getRenderTarget(),S=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),V=n.state;V.setBlending(gs),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const N=p!==Ki&&this.type===Ki,G=p===Ki&&this.type!==Ki;for(let j=0,K=A.length;j<K;j++){const Q=A[j],tt=Q.shadow;if(tt===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(tt.autoUpdate===!1&&tt.needsUpdate===!1)continue;s.copy(tt.mapSize);const ht=tt.getFrameExtents();if(s.multiply(ht),r.copy(tt.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,tt.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,tt.mapSize.y=r.y)),tt.map===null||N===!0||G===!0){const mt=this.type!==Ki?{minFilter:yi,magFilter:yi}:{};tt.map!==null&&tt.map.dispose(),tt.map=new Ys(s.x,s.y,mt),tt.map.texture.name=Q.name+".shadowMap",tt.camera.updateProjectionMatrix()}n.setRenderTarget(tt.map),n.clear();const ct=tt.getViewportCount();for(let mt=0;mt<ct;mt++){const Mt=tt.getViewport(mt);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),V.viewport(o),tt.updateMatrices(Q,mt),i=tt.getFrustum(),x(D,I,tt.camera,Q,this.type)}tt.isPointLightShadow!==!0&&this.type===Ki&&y(tt,I),tt.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(w,S,C)};function y(A,D){const I=t.update(v);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new Ys(s.x,s.y)),f.uniforms.shadow_pass.value=A.map.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(D,null,I,f,v,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(D,null,I,d,v,null)}function T(A,D,I,w){let S=null;const C=I.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)S=C;else if(S=I.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const V=S.uuid,N=D.uuid;let G=c[V];G===void 0&&(G={},c[V]=G);let j=G[N];j===void 0&&(j=S.clone(),G[N]=j,D.addEventListener("dispose",U)),S=j}if(S.visible=D.visible,S.wireframe=D.wireframe,w===Ki?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:h[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,I.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const V=n.properties.get(S);V.light=I}return S}function x(A,D,I,w,S){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&S===Ki)&&(!A.frustumCulled||i.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(I.matrixWorldInverse,A.matrixWorld);const N=t.update(A),G=A.material;if(Array.isArray(G)){const j=N.groups;for(let K=0,Q=j.length;K<Q;K++){const tt=j[K],ht=G[tt.materialIndex];if(ht&&ht.visible){const ct=T(A,ht,w,S);A.onBeforeShadow(n,A,D,I,N,ct,tt),n.renderBufferDirect(I,null,N,ct,A,tt),A.onAfterShadow(n,A,D,I,N,ct,tt)}}}else if(G.visible){const j=T(A,G,w,S);A.onBeforeShadow(n,A,D,I,N,j,null),n.renderBufferDirect(I,null,N,j,A,null),A.onAfterShadow(n,A,D,I,N,j,null)}}const V=A.children;for(let N=0,G=V.length;N<G;N++)x(V[N],D,I,w,S)}function U(A){A.target.removeEventListener("dispose",U);for(const I in c){const w=c[I],S=A.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}const Hb={[Lc]:Dc,[Ic]:Fc,[Uc]:Oc,[Vr]:Nc,[Dc]:Lc,[Fc]:Ic,[Oc]:Uc,[Nc]:Vr};function Vb(n,t){function e(){let k=!1;const xt=new We;let nt=null;const rt=new We(0,0,0,0);return{setMask:function(Tt){nt!==Tt&&!k&&(n.colorMask(Tt,Tt,Tt,Tt),nt=Tt)},setLocked:function(Tt){k=Tt},setClear:function(Tt,At,Jt,He,un){un===!0&&(Tt*=He,At*=He,Jt*=He),xt.set(Tt,At,Jt,He),rt.equals(xt)===!1&&(n.clearColor(Tt,At,Jt,He),rt.copy(xt))},reset:function(){k=!1,nt=null,rt.set(-1,0,0,0)}}}function i(){let k=!1,xt=!1,nt=null,rt=null,Tt=null;return{setReversed:function(At){if(xt!==At){const Jt=t.get("EXT_clip_control");xt?Jt.clipControlEXT(Jt.LOWER_LEFT_EXT,Jt.ZERO_TO_ONE_EXT):Jt.clipControlEXT(Jt.LOWER_LEFT_EXT,Jt.NEGATIVE_ONE_TO_ONE_EXT);const He=Tt;Tt=null,this.setClear(He)}xt=At},getReversed:function(){return xt},setTest:function(At){At?ot(n.DEPTH_TEST):Bt(n.DEPTH_TEST)},setMask:function(At){nt!==At&&!k&&(n.depthMask(At),nt=At)},setFunc:function(At){if(xt&&(At=Hb[At]),rt!==At){switch(At){case Lc:n.depthFunc(n.NEVER);break;case Dc:n.depthFunc(n.ALWAYS);break;case Ic:n.depthFunc(n.LESS);break;case Vr:n.depthFunc(n.LEQUAL);break;case Uc:n.depthFunc(n.EQUAL);break;case Nc:n.depthFunc(n.GEQUAL);break;case Fc:n.depthFunc(n.GREATER);break;case Oc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}rt=At}},setLocked:function(At){k=At},setClear:function(At){Tt!==At&&(xt&&(At=1-At),n.clearDepth(At),Tt=At)},reset:function(){k=!1,nt=null,rt=null,Tt=null,xt=!1}}}function s(){let k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Jt=null,He=null,un=null;return{setTest:function(Se){k||(Se?ot(n.STENCIL_TEST):Bt(n.STENCIL_TEST))},setMask:function(Se){xt!==Se&&!k&&(n.stencilMask(Se),xt=Se)},setFunc:function(Se,en,Ue){(nt!==Se||rt!==en||Tt!==Ue)&&(n.stencilFunc(Se,en,Ue),nt=Se,rt=en,Tt=Ue)},setOp:function(Se,en,Ue){(At!==Se||Jt!==en||He!==Ue)&&(n.stencilOp(Se,en,Ue),At=Se,Jt=en,He=Ue)},setLocked:function(Se){k=Se},setClear:function(Se){un!==Se&&(n.clearStencil(Se),un=Se)},reset:function(){k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Jt=null,He=null,un=null}}}const r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,y=null,T=null,x=null,U=null,A=null,D=new le(0,0,0),I=0,w=!1,S=null,C=null,V=null,N=null,G=null;const j=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let K=!1,Q=0;const tt=n.getParameter(n.VERSION);tt.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(tt)[1]),K=Q>=1):tt.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(tt)[1]),K=Q>=2);let ht=null,ct={};const mt=n.getParameter(n.SCISSOR_BOX),Mt=n.getParameter(n.VIEWPORT),pt=new We().fromArray(mt),it=new We().fromArray(Mt);function at(k,xt,nt,rt){const Tt=new Uint8Array(4),At=n.createTexture();n.bindTexture(k,At),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Jt=0;Jt<nt;Jt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(xt,0,n.RGBA,1,1,rt,0,n.RGBA,n.UNSIGNED_BYTE,Tt):n.texImage2D(xt+Jt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Tt);return At}const gt={};gt[n.TEXTURE_2D]=at(n.TEXTURE_2D,n.TEXTURE_2D,1),gt[n.TEXTURE_CUBE_MAP]=at(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[n.TEXTURE_2D_ARRAY]=at(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),gt[n.TEXTURE_3D]=at(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(n.DEPTH_TEST),o.setFunc(Vr),Qt(!1),ee(If),ot(n.CULL_FACE),z(gs);function ot(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Bt(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function Ht(k,xt){return h[k]!==xt?(n.bindFramebuffer(k,xt),h[k]=xt,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=xt),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=xt),!0):!1}function Ut(k,xt){let nt=d,rt=!1;if(k){nt=f.get(xt),nt===void 0&&(nt=[],f.set(xt,nt));const Tt=k.textures;if(nt.length!==Tt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let At=0,Jt=Tt.length;At<Jt;At++)nt[At]=n.COLOR_ATTACHMENT0+At;nt.length=Tt.length,rt=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,rt=!0);rt&&n.drawBuffers(nt)}function he(k){return g!==k?(n.useProgram(k),g=k,!0):!1}const Zt={[Hs]:n.FUNC_ADD,[rx]:n.FUNC_SUBTRACT,[ox]:n.FUNC_REVERSE_SUBTRACT};Zt[ax]=n.MIN,Zt[lx]=n.MAX;const fe={[cx]:n.ZERO,[ux]:n.ONE,[hx]:n.SRC_COLOR,[Cc]:n.SRC_ALPHA,[_x]:n.SRC_ALPHA_SATURATE,[mx]:n.DST_COLOR,[dx]:n.DST_ALPHA,[fx]:n.ONE_MINUS_SRC_COLOR,[Pc]:n.ONE_MINUS_SRC_ALPHA,[gx]:n.ONE_MINUS_DST_COLOR,[px]:n.ONE_MINUS_DST_ALPHA,[vx]:n.CONSTANT_COLOR,[xx]:n.ONE_MINUS_CONSTANT_COLOR,[Mx]:n.CONSTANT_ALPHA,[Sx]:n.ONE_MINUS_CONSTANT_ALPHA};function z(k,xt,nt,rt,Tt,At,Jt,He,un,Se){if(k===gs){v===!0&&(Bt(n.BLEND),v=!1);return}if(v===!1&&(ot(n.BLEND),v=!0),k!==sx){if(k!==m||Se!==w){if((p!==Hs||x!==Hs)&&(n.blendEquation(n.FUNC_ADD),p=Hs,x=Hs),Se)switch(k){case Ur:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Uf:n.blendFunc(n.ONE,n.ONE);break;case Nf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ff:n.blendFuncSeparate(n.ZERO,n.SRC_COLOR,n.ZERO,n.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}else switch(k){case Ur:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Uf:n.blendFunc(n.SRC_ALPHA,n.ONE);break;case Nf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ff:n.blendFunc(n.ZERO,n.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}y=null,T=null,U=null,A=null,D.set(0,0,0),I=0,m=k,w=Se}return}Tt=Tt||xt,At=At||nt,Jt=Jt||rt,(xt!==p||Tt!==x)&&(n.blendEquationSeparate(Zt[xt],Zt[Tt]),p=xt,x=Tt),(nt!==y||rt!==T||At!==U||Jt!==A)&&(n.blendFuncSeparate(fe[nt],fe[rt],fe[At],fe[Jt]),y=nt,T=rt,U=At,A=Jt),(He.equals(D)===!1||un!==I)&&(n.blendColor(He.r,He.g,He.b,un),D.copy(He),I=un),m=k,w=!1}function tn(k,xt){k.side===Di?Bt(n.CULL_FACE):ot(n.CULL_FACE);let nt=k.side===kn;xt&&(nt=!nt),Qt(nt),k.blending===Ur&&k.transparent===!1?z(gs):z(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);const rt=k.stencilWrite;a.setTest(rt),rt&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),pe(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?ot(n.SAMPLE_ALPHA_TO_COVERAGE):Bt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Qt(k){S!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),S=k)}function ee(k){k!==ex?(ot(n.CULL_FACE),k!==C&&(k===If?n.cullFace(n.BACK):k===nx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Bt(n.CULL_FACE),C=k}function Gt(k){k!==V&&(K&&n.lineWidth(k),V=k)}function pe(k,xt,nt){k?(ot(n.POLYGON_OFFSET_FILL),(N!==xt||G!==nt)&&(n.polygonOffset(xt,nt),N=xt,G=nt)):Bt(n.POLYGON_OFFSET_FILL)}function Pt(k){k?ot(n.SCISSOR_TEST):Bt(n.SCISSOR_TEST)}function P(k){k===void 0&&(k=n.TEXTURE0+j-1),ht!==k&&(n.activeTexture(k),ht=k)}function E(k,xt,nt){nt===void 0&&(ht===null?nt=n.TEXTURE0+j-1:nt=ht);let rt=ct[nt];rt===void 0&&(rt={type:void 0,texture:void 0},ct[nt]=rt),(rt.type!==k||rt.texture!==xt)&&(ht!==nt&&(n.activeTexture(nt),ht=nt),n.bindTexture(k,xt||gt[k]),rt.type=k,rt.texture=xt)}function Y(){const k=ct[ht];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Z(){try{n.compressedTexImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function W(){try{n.compressedTexImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function et(){try{n.texSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function St(){try{n.texSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function _t(){try{n.compressedTexSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function wt(){try{n.compressedTexSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function jt(){try{n.texStorage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ft(){try{n.texStorage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function vt(){try{n.texImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Nt(){try{n.texImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Ot(k){pt.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),pt.copy(k))}function Et(k){it.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),it.copy(k))}function ie(k,xt){let nt=c.get(xt);nt===void 0&&(nt=new WeakMap,c.set(xt,nt));let rt=nt.get(k);rt===void 0&&(rt=n.getUniformBlockIndex(xt,k.name),nt.set(k,rt))}function Yt(k,xt){const rt=c.get(xt).get(k);l.get(xt)!==rt&&(n.uniformBlockBinding(xt,rt,k.__bindingPointIndex),l.set(xt,rt))}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},ht=null,ct={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,y=null,T=null,x=null,U=null,A=null,D=new le(0,0,0),I=0,w=!1,S=null,C=null,V=null,N=null,G=null,pt.set(0,0,n.canvas.width,n.canvas.height),it.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:Bt,bindFramebuffer:Ht,drawBuffers:Ut,useProgram:he,setBlending:z,setMaterial:tn,setFlipSided:Qt,setCullFace:ee,setLineWidth:Gt,setPolygonOffset:pe,setScissorTest:Pt,activeTexture:P,bindTexture:E,unbindTexture:Y,compressedTexImage2D:Z,compressedTexImage3D:W,texImage2D:vt,texImage3D:Nt,updateUBOMapping:ie,uniformBlockBinding:Yt,texStorage2D:jt,texStorage3D:ft,texSubImage2D:et,texSubImage3D:St,compressedTexSubImage2D:_t,compressedTexSubImage3D:wt,scissor:Ot,viewport:Et,reset:me}}function Pd(n,t,e,i){const s=Gb(i);switch(e){case cm:return n*t;case hm:return n*t;case fm:return n*t*2;case dm:return n*t/s.components*s.byteLength;case Zu:return n*t/s.components*s.byteLength;case pm:return n*t*2/s.components*s.byteLength;case Ju:return n*t*2/s.components*s.byteLength;case um:return n*t*3/s.components*s.byteLength;case xi:return n*t*4/s.components*s.byteLength;case Qu:return n*t*4/s.components*s.byteLength;case Ra:case Ca:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Pa:case La:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Gc:case $c:return Math.max(n,16)*Math.max(t,8)/4;case Vc:case Wc:return Math.max(n,8)*Math.max(t,8)/2;case Xc:case qc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Yc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Kc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case jc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Zc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Qc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case tu:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case eu:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case nu:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case iu:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case su:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case ru:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case ou:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case au:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case lu:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Da:case cu:case uu:return Math.ceil(n/4)*Math.ceil(t/4)*16;case mm:case hu:return Math.ceil(n/4)*Math.ceil(t/4)*8;case fu:case du:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Gb(n){switch(n){case es:case om:return{byteLength:1,components:1};case Po:case am:case Io:return{byteLength:2,components:1};case Ku:case ju:return{byteLength:2,components:4};case qs:case Yu:case ji:return{byteLength:4,components:1};case lm:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}function Wb(n,t,e,i,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ce,u=new WeakMap;let h;const f=new WeakMap;let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,E){return d?new OffscreenCanvas(P,E):Va("canvas")}function v(P,E,Y){let Z=1;const W=Pt(P);if((W.width>Y||W.height>Y)&&(Z=Y/Math.max(W.width,W.height)),Z<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){const et=Math.floor(Z*W.width),St=Math.floor(Z*W.height);h===void 0&&(h=g(et,St));const _t=E?g(et,St):h;return _t.width=et,_t.height=St,_t.getContext("2d").drawImage(P,0,0,et,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+et+"x"+St+")."),_t}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){n.generateMipmap(P)}function y(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(P,E,Y,Z,W=!1){if(P!==null){if(n[P]!==void 0)return n[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=E;if(E===n.RED&&(Y===n.FLOAT&&(et=n.R32F),Y===n.HALF_FLOAT&&(et=n.R16F),Y===n.UNSIGNED_BYTE&&(et=n.R8)),E===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.R8UI),Y===n.UNSIGNED_SHORT&&(et=n.R16UI),Y===n.UNSIGNED_INT&&(et=n.R32UI),Y===n.BYTE&&(et=n.R8I),Y===n.SHORT&&(et=n.R16I),Y===n.INT&&(et=n.R32I)),E===n.RG&&(Y===n.FLOAT&&(et=n.RG32F),Y===n.HALF_FLOAT&&(et=n.RG16F),Y===n.UNSIGNED_BYTE&&(et=n.RG8)),E===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.RG8UI),Y===n.UNSIGNED_SHORT&&(et=n.RG16UI),Y===n.UNSIGNED_INT&&(et=n.RG32UI),Y===n.BYTE&&(et=n.RG8I),Y===n.SHORT&&(et=n.RG16I),Y===n.INT&&(et=n.RG32I)),E===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(et=n.RGB16UI),Y===n.UNSIGNED_INT&&(et=n.RGB32UI),Y===n.BYTE&&(et=n.RGB8I),Y===n.SHORT&&(et=n.RGB16I),Y===n.INT&&(et=n.RGB32I)),E===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),Y===n.UNSIGNED_INT&&(et=n.RGBA32UI),Y===n.BYTE&&(et=n.RGBA8I),Y===n.SHORT&&(et=n.RGBA16I),Y===n.INT&&(et=n.RGBA32I)),E===n.RGB&&Y===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),E===n.RGBA){const St=W?ol:_e.getTransfer(Z);Y===n.FLOAT&&(et=n.RGBA32F),Y===n.HALF_FLOAT&&(et=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(et=St===Pe?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(P,E){let Y;return P?E===null||E===qs||E===$r?Y=n.DEPTH24_STENCIL8:E===ji?Y=n.DEPTH32F_STENCIL8:E===Po&&(Y=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===qs||E===$r?Y=n.DEPTH_COMPONENT24:E===ji?Y=n.DEPTH_COMPONENT32F:E===Po&&(Y=n.DEPTH_COMPONENT16),Y}function U(P,E){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==yi&&P.minFilter!==Ni?Math.log2(Math.max(E.width,E.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?E.mipmaps.length:1}function A(P){const E=P.target;E.removeEventListener("dispose",A),I(E),E.isVideoTexture&&u.delete(E)}function D(P){const E=P.target;E.removeEventListener("dispose",D),S(E)}function I(P){const E=i.get(P);if(E.__webglInit===void 0)return;const Y=P.source,Z=f.get(Y);if(Z){const W=Z[E.__cacheKey];W.usedTimes--,W.usedTimes===0&&w(P),Object.keys(Z).length===0&&f.delete(Y)}i.remove(P)}function w(P){const E=i.get(P);n.deleteTexture(E.__webglTexture);const Y=P.source,Z=f.get(Y);delete Z[E.__cacheKey],o.memory.textures--}function S(P){const E=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(E.__webglFramebuffer[Z]))for(let W=0;W<E.__webglFramebuffer[Z].length;W++)n.deleteFramebuffer(E.__webglFramebuffer[Z][W]);else n.deleteFramebuffer(E.__webglFramebuffer[Z]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[Z])}else{if(Array.isArray(E.__webglFramebuffer))for(let Z=0;Z<E.__webglFramebuffer.length;Z++)n.deleteFramebuffer(E.__webglFramebuffer[Z]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let Z=0;Z<E.__webglColorRenderbuffer.length;Z++)E.__webglColorRenderbuffer[Z]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[Z]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}const Y=P.textures;for(let Z=0,W=Y.length;Z<W;Z++){const et=i.get(Y[Z]);et.__webglTexture&&(n.deleteTexture(et.__webglTexture),o.memory.textures--),i.remove(Y[Z])}i.remove(P)}let C=0;function V(){C=0}function N(){const P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function G(P){const E=[];return E.push(P.wrapS),E.push(P.wrapT),E.push(P.wrapR||0),E.push(P.magFilter),E.push(P.minFilter),E.push(P.anisotropy),E.push(P.internalFormat),E.push(P.format),E.push(P.type),E.push(P.generateMipmaps),E.push(P.premultiplyAlpha),E.push(P.flipY),E.push(P.unpackAlignment),E.push(P.colorSpace),E.join()}function j(P,E){const Y=i.get(P);if(P.isVideoTexture&&Gt(P),P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){const Z=P.image;if(Z===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(Z.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{it(Y,P,E);return}}e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+E)}function K(P,E){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){it(Y,P,E);return}e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+E)}function Q(P,E){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){it(Y,P,E);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+E)}function tt(P,E){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){at(Y,P,E);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+E)}const ht={[zc]:n.REPEAT,[Gs]:n.CLAMP_TO_EDGE,[Hc]:n.MIRRORED_REPEAT},ct={[yi]:n.NEAREST,[Lx]:n.NEAREST_MIPMAP_NEAREST,[Ko]:n.NEAREST_MIPMAP_LINEAR,[Ni]:n.LINEAR,[Il]:n.LINEAR_MIPMAP_NEAREST,[Ws]:n.LINEAR_MIPMAP_LINEAR},mt={[Nx]:n.NEVER,[Hx]:n.ALWAYS,[Fx]:n.LESS,[_m]:n.LEQUAL,[Ox]:n.EQUAL,[zx]:n.GEQUAL,[kx]:n.GREATER,[Bx]:n.NOTEQUAL};function Mt(P,E){if(E.type===ji&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===Ni||E.magFilter===Il||E.magFilter===Ko||E.magFilter===Ws||E.minFilter===Ni||E.minFilter===Il||E.minFilter===Ko||E.minFilter===Ws)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ht[E.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ht[E.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ht[E.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ct[E.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ct[E.minFilter]),E.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,mt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===yi||E.minFilter!==Ko&&E.minFilter!==Ws||E.type===ji&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){const Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function pt(P,E){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,E.addEventListener("dispose",A));const Z=E.source;let W=f.get(Z);W===void 0&&(W={},f.set(Z,W));const et=G(E);if(et!==P.__cacheKey){W[et]===void 0&&(W[et]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),W[et].usedTimes++;const St=W[P.__cacheKey];St!==void 0&&(W[P.__cacheKey].usedTimes--,St.usedTimes===0&&w(E)),P.__cacheKey=et,P.__webglTexture=W[et].texture}return Y}function it(P,E,Y){let Z=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(Z=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(Z=n.TEXTURE_3D);const W=pt(P,E),et=E.source;e.bindTexture(Z,P.__webglTexture,n.TEXTURE0+Y);const St=i.get(et);if(et.version!==St.__version||W===!0){e.activeTexture(n.TEXTURE0+Y);const _t=_e.getPrimaries(_e.workingColorSpace),wt=E.colorSpace===ms?null:_e.getPrimaries(E.colorSpace),jt=E.colorSpace===ms||_t===wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,jt);let ft=v(E.image,!1,s.maxTextureSize);ft=pe(E,ft);const vt=r.convert(E.format,E.colorSpace),Nt=r.convert(E.type);let Ot=T(E.internalFormat,vt,Nt,E.colorSpace,E.isVideoTexture);Mt(Z,E);let Et;const ie=E.mipmaps,Yt=E.isVideoTexture!==!0,me=St.__version===void 0||W===!0,k=et.dataReady,xt=U(E,ft);if(E.isDepthTexture)Ot=x(E.format===Xr,E.type),me&&(Yt?e.texStorage2D(n.TEXTURE_2D,1,Ot,ft.width,ft.height):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,null));else if(E.isDataTexture)if(ie.length>0){Yt&&me&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ie[0].width,ie[0].height);for(let nt=0,rt=ie.length;nt<rt;nt++)Et=ie[nt],Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(n.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,vt,Nt,Et.data);E.generateMipmaps=!1}else Yt?(me&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height),k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ft.width,ft.height,vt,Nt,ft.data)):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,ft.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){Yt&&me&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,ie[0].width,ie[0].height,ft.depth);for(let nt=0,rt=ie.length;nt<rt;nt++)if(Et=ie[nt],E.format!==xi)if(vt!==null)if(Yt){if(k)if(E.layerUpdates.size>0){const Tt=Pd(Et.width,Et.height,E.format,E.type);for(const At of E.layerUpdates){const Jt=Et.data.subarray(At*Tt/Et.data.BYTES_PER_ELEMENT,(At+1)*Tt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,At,Et.width,Et.height,1,vt,Jt)}E.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,Et.width,Et.height,ft.depth,vt,Et.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,nt,Ot,Et.width,Et.height,ft.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?k&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,Et.width,Et.height,ft.depth,vt,Nt,Et.data):e.texImage3D(n.TEXTURE_2D_ARRAY,nt,Ot,Et.width,Et.height,ft.depth,0,vt,Nt,Et.data)}else{Yt&&me&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ie[0].width,ie[0].height);for(let nt=0,rt=ie.length;nt<rt;nt++)Et=ie[nt],E.format!==xi?vt!==null?Yt?k&&e.compressedTexSubImage2D(n.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Et.data):e.compressedTexImage2D(n.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(n.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,vt,Nt,Et.data)}else if(E.isDataArrayTexture)if(Yt){if(me&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,ft.width,ft.height,ft.depth),k)if(E.layerUpdates.size>0){const nt=Pd(ft.width,ft.height,E.format,E.type);for(const rt of E.layerUpdates){const Tt=ft.data.subarray(rt*nt/ft.data.BYTES_PER_ELEMENT,(rt+1)*nt/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,vt,Nt,Tt)}E.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(E.isData3DTexture)Yt?(me&&e.texStorage3D(n.TEXTURE_3D,xt,Ot,ft.width,ft.height,ft.depth),k&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)):e.texImage3D(n.TEXTURE_3D,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(E.isFramebufferTexture){if(me)if(Yt)e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height);else{let nt=ft.width,rt=ft.height;for(let Tt=0;Tt<xt;Tt++)e.texImage2D(n.TEXTURE_2D,Tt,Ot,nt,rt,0,vt,Nt,null),nt>>=1,rt>>=1}}else if(ie.length>0){if(Yt&&me){const nt=Pt(ie[0]);e.texStorage2D(n.TEXTURE_2D,xt,Ot,nt.width,nt.height)}for(let nt=0,rt=ie.length;nt<rt;nt++)Et=ie[nt],Yt?k&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,vt,Nt,Et):e.texImage2D(n.TEXTURE_2D,nt,Ot,vt,Nt,Et);E.generateMipmaps=!1}else if(Yt){if(me){const nt=Pt(ft);e.texStorage2D(n.TEXTURE_2D,xt,Ot,nt.width,nt.height)}k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,Nt,ft)}else e.texImage2D(n.TEXTURE_2D,0,Ot,vt,Nt,ft);m(E)&&p(Z),St.__version=et.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function at(P,E,Y){if(E.image.length!==6)return;const Z=pt(P,E),W=E.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+Y);const et=i.get(W);if(W.version!==et.__version||Z===!0){e.activeTexture(n.TEXTURE0+Y);const St=_e.getPrimaries(_e.workingColorSpace),_t=E.colorSpace===ms?null:_e.getPrimaries(E.colorSpace),wt=E.colorSpace===ms||St===_t?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,wt);const jt=E.isCompressedTexture||E.image[0].isCompressedTexture,ft=E.image[0]&&E.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!jt&&!ft?vt[rt]=v(E.image[rt],!0,s.maxCubemapSize):vt[rt]=ft?E.image[rt].image:E.image[rt],vt[rt]=pe(E,vt[rt]);const Nt=vt[0],Ot=r.convert(E.format,E.colorSpace),Et=r.convert(E.type),ie=T(E.internalFormat,Ot,Et,E.colorSpace),Yt=E.isVideoTexture!==!0,me=et.__version===void 0||Z===!0,k=W.dataReady;let xt=U(E,Nt);Mt(n.TEXTURE_CUBE_MAP,E);let nt;if(jt){Yt&&me&&e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,ie,Nt.width,Nt.height);for(let rt=0;rt<6;rt++){nt=vt[rt].mipmaps;for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];E.format!==xi?Ot!==null?Yt?k&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,At.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,ie,At.width,At.height,0,At.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,Et,At.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,ie,At.width,At.height,0,Ot,Et,At.data)}}}else{if(nt=E.mipmaps,Yt&&me){nt.length>0&&xt++;const rt=Pt(vt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,ie,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ot,Et,vt[rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ie,vt[rt].width,vt[rt].height,0,Ot,Et,vt[rt].data);for(let Tt=0;Tt<nt.length;Tt++){const Jt=nt[Tt].image[rt].image;Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Jt.width,Jt.height,Ot,Et,Jt.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,ie,Jt.width,Jt.height,0,Ot,Et,Jt.data)}}else{Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ot,Et,vt[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ie,Ot,Et,vt[rt]);for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];Yt?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Ot,Et,At.image[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,ie,Ot,Et,At.image[rt])}}}m(E)&&p(n.TEXTURE_CUBE_MAP),et.__version=W.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function gt(P,E,Y,Z,W,et){const St=r.convert(Y.format,Y.colorSpace),_t=r.convert(Y.type),wt=T(Y.internalFormat,St,_t,Y.colorSpace),jt=i.get(E),ft=i.get(Y);if(ft.__renderTarget=E,!jt.__hasExternalTextures){const vt=Math.max(1,E.width>>et),Nt=Math.max(1,E.height>>et);W===n.TEXTURE_3D||W===n.TEXTURE_2D_ARRAY?e.texImage3D(W,et,wt,vt,Nt,E.depth,0,St,_t,null):e.texImage2D(W,et,wt,vt,Nt,0,St,_t,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),ee(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,Z,W,ft.__webglTexture,0,Qt(E)):(W===n.TEXTURE_2D||W>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,Z,W,ft.__webglTexture,et),e.bindFramebuffer(n.FRAMEBUFFER,null)}function ot(P,E,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,P),E.depthBuffer){const Z=E.depthTexture,W=Z&&Z.isDepthTexture?Z.type:null,et=x(E.stencilBuffer,W),St=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=Qt(E);ee(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_t,et,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,_t,et,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,et,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,P)}else{const Z=E.textures;for(let W=0;W<Z.length;W++){const et=Z[W],St=r.convert(et.format,et.colorSpace),_t=r.convert(et.type),wt=T(et.internalFormat,St,_t,et.colorSpace),jt=Qt(E);Y&&ee(E)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,jt,wt,E.width,E.height):ee(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,jt,wt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,wt,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Bt(P,E){if(E&&E.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const Z=i.get(E.depthTexture);Z.__renderTarget=E,(!Z.__webglTexture||E.depthTexture.image.width!==E.width||E.depthTexture.image.height!==E.height)&&(E.depthTexture.image.width=E.width,E.depthTexture.image.height=E.height,E.depthTexture.needsUpdate=!0),j(E.depthTexture,0);const W=Z.__webglTexture,et=Qt(E);if(E.depthTexture.format===Nr)ee(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0);else if(E.depthTexture.format===Xr)ee(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0);else throw new Error("Unknown depthTexture format")}function Ht(P){const E=i.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==P.depthTexture){const Z=P.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),Z){const W=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,Z.removeEventListener("dispose",W)};Z.addEventListener("dispose",W),E.__depthDisposeCallback=W}E.__boundDepthTexture=Z}if(P.depthTexture&&!E.__autoAllocateDepthBuffer){if(Y)throw new Error("target.depthTexture not supported in Cube render targets");Bt(E.__webglFramebuffer,P)}else if(Y){E.__webglDepthbuffer=[];for(let Z=0;Z<6;Z++)if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[Z]),E.__webglDepthbuffer[Z]===void 0)E.__webglDepthbuffer[Z]=n.createRenderbuffer(),ot(E.__webglDepthbuffer[Z],P,!1);else{const W=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,et=E.__webglDepthbuffer[Z];n.bindRenderbuffer(n.RENDERBUFFER,et),n.framebufferRenderbuffer(n.FRAMEBUFFER,W,n.RENDERBUFFER,et)}}else if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),ot(E.__webglDepthbuffer,P,!1);else{const Z=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,Z,n.RENDERBUFFER,W)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ut(P,E,Y){const Z=i.get(P);E!==void 0&&gt(Z.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&Ht(P)}function he(P){const E=P.texture,Y=i.get(P),Z=i.get(E);P.addEventListener("dispose",D);const W=P.textures,et=P.isWebGLCubeRenderTarget===!0,St=W.length>1;if(St||(Z.__webglTexture===void 0&&(Z.__webglTexture=n.createTexture()),Z.__version=E.version,o.memory.textures++),et){Y.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(E.mipmaps&&E.mipmaps.length>0){Y.__webglFramebuffer[_t]=[];for(let wt=0;wt<E.mipmaps.length;wt++)Y.__webglFramebuffer[_t][wt]=n.createFramebuffer()}else Y.__webglFramebuffer[_t]=n.createFramebuffer()}else{if(E.mipmaps&&E.mipmaps.length>0){Y.__webglFramebuffer=[];for(let _t=0;_t<E.mipmaps.length;_t++)Y.__webglFramebuffer[_t]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(St)for(let _t=0,wt=W.length;_t<wt;_t++){const jt=i.get(W[_t]);jt.__webglTexture===void 0&&(jt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&ee(P)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let _t=0;_t<W.length;_t++){const wt=W[_t];Y.__webglColorRenderbuffer[_t]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[_t]);const jt=r.convert(wt.format,wt.colorSpace),ft=r.convert(wt.type),vt=T(wt.internalFormat,jt,ft,wt.colorSpace,P.isXRRenderTarget===!0),Nt=Qt(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,Nt,vt,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,Y.__webglColorRenderbuffer[_t])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),ot(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(et){e.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture),Mt(n.TEXTURE_CUBE_MAP,E);for(let _t=0;_t<6;_t++)if(E.mipmaps&&E.mipmaps.length>0)for(let wt=0;wt<E.mipmaps.length;wt++)gt(Y.__webglFramebuffer[_t][wt],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,wt);else gt(Y.__webglFramebuffer[_t],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);m(E)&&p(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let _t=0,wt=W.length;_t<wt;_t++){const jt=W[_t],ft=i.get(jt);e.bindTexture(n.TEXTURE_2D,ft.__webglTexture),Mt(n.TEXTURE_2D,jt),gt(Y.__webglFramebuffer,P,jt,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,0),m(jt)&&p(n.TEXTURE_2D)}e.unbindTexture()}else{let _t=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(_t,Z.__webglTexture),Mt(_t,E),E.mipmaps&&E.mipmaps.length>0)for(let wt=0;wt<E.mipmaps.length;wt++)gt(Y.__webglFramebuffer[wt],P,E,n.COLOR_ATTACHMENT0,_t,wt);else gt(Y.__webglFramebuffer,P,E,n.COLOR_ATTACHMENT0,_t,0);m(E)&&p(_t),e.unbindTexture()}P.depthBuffer&&Ht(P)}function Zt(P){const E=P.textures;for(let Y=0,Z=E.length;Y<Z;Y++){const W=E[Y];if(m(W)){const et=y(P),St=i.get(W).__webglTexture;e.bindTexture(et,St),p(et),e.unbindTexture()}}}const fe=[],z=[];function tn(P){if(P.samples>0){if(ee(P)===!1){const E=P.textures,Y=P.width,Z=P.height;let W=n.COLOR_BUFFER_BIT;const et=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(P),_t=E.length>1;if(_t)for(let wt=0;wt<E.length;wt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let wt=0;wt<E.length;wt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(W|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(W|=n.STENCIL_BUFFER_BIT)),_t){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const jt=i.get(E[wt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,jt,0)}n.blitFramebuffer(0,0,Y,Z,0,0,Y,Z,W,n.NEAREST),l===!0&&(fe.length=0,z.length=0,fe.push(n.COLOR_ATTACHMENT0+wt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(fe.push(et),z.push(et),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,z)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,fe))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),_t)for(let wt=0;wt<E.length;wt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const jt=i.get(E[wt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+wt,n.TEXTURE_2D,jt,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){const E=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function Qt(P){return Math.min(s.maxSamples,P.samples)}function ee(P){const E=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Gt(P){const E=o.render.frame;u.get(P)!==E&&(u.set(P,E),P.update())}function pe(P,E){const Y=P.colorSpace,Z=P.format,W=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==Js&&Y!==ms&&(_e.getTransfer(Y)===Pe?(Z!==xi||W!==es)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Y)),E}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=N,this.resetTextureUnits=V,this.setTexture2D=j,this.setTexture2DArray=K,this.setTexture3D=Q,this.setTextureCube=tt,this.rebindTextures=Ut,this.setupRenderTarget=he,this.updateRenderTargetMipmap=Zt,this.updateMultisampleRenderTarget=tn,this.setupDepthRenderbuffer=Ht,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=ee}function $b(n,t){function e(i,s=ms){let r;const o=_e.getTransfer(s);if(i===es)return n.UNSIGNED_BYTE;if(i===Ku)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ju)return n.UNSIGNED_SHORT_5_5_5_1;if(i===lm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===om)return n.BYTE;if(i===am)return n.SHORT;if(i===Po)return n.UNSIGNED_SHORT;if(i===Yu)return n.INT;if(i===qs)return n.UNSIGNED_INT;if(i===ji)return n.FLOAT;if(i===Io)return n.HALF_FLOAT;if(i===cm)return n.ALPHA;if(i===um)return n.RGB;if(i===xi)return n.RGBA;if(i===hm)return n.LUMINANCE;if(i===fm)return n.LUMINANCE_ALPHA;if(i===Nr)return n.DEPTH_COMPONENT;if(i===Xr)return n.DEPTH_STENCIL;if(i===dm)return n.RED;if(i===Zu)return n.RED_INTEGER;if(i===pm)return n.RG;if(i===Ju)return n.RG_INTEGER;if(i===Qu)return n.RGBA_INTEGER;if(i===Ra||i===Ca||i===Pa||i===La)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ra)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ra)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ca)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Vc||i===Gc||i===Wc||i===$c)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Vc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Gc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Wc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===$c)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Xc||i===qc||i===Yc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Xc||i===qc)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Yc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Kc||i===jc||i===Zc||i===Jc||i===Qc||i===tu||i===eu||i===nu||i===iu||i===su||i===ru||i===ou||i===au||i===lu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Kc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===jc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Zc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Jc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Qc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===tu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===eu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===nu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===iu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===su)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ru)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ou)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===au)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===lu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Da||i===cu||i===uu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Da)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===cu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===uu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===mm||i===hu||i===fu||i===du)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Da)return r.COMPRESSED_RED_RGTC1_EXT;if(i===hu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===fu)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===du)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===$r?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}class Xb extends Yn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class Fi extends rn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const qb={type:"move"};class ac{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(qb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const i=new Fi;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}}const Yb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Kb=`
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

}`;class jb{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,i){if(this.texture===null){const s=new Bn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=i.depthNear||e.depthFar!=i.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,i=new Ss({vertexShader:Yb,fragmentShader:Kb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new bn(new al(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class Zb extends Qr{constructor(t,e){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null;const v=new jb,m=e.getContextAttributes();let p=null,y=null;const T=[],x=[],U=new ce;let A=null;const D=new Yn;D.viewport=new We;const I=new Yn;I.viewport=new We;const w=[D,I],S=new Xb;let C=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let at=T[it];return at===void 0&&(at=new ac,T[it]=at),at.getTargetRaySpace()},this.getControllerGrip=function(it){let at=T[it];return at===void 0&&(at=new ac,T[it]=at),at.getGripSpace()},this.getHand=function(it){let at=T[it];return at===void 0&&(at=new ac,T[it]=at),at.getHandSpace()};function N(it){const at=x.indexOf(it.inputSource);if(at===-1)return;const gt=T[at];gt!==void 0&&(gt.update(it.inputSource,it.frame,c||o),gt.dispatchEvent({type:it.type,data:it.inputSource}))}function G(){s.removeEventListener("select",N),s.removeEventListener("selectstart",N),s.removeEventListener("selectend",N),s.removeEventListener("squeeze",N),s.removeEventListener("squeezestart",N),s.removeEventListener("squeezeend",N),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",j);for(let it=0;it<T.length;it++){const at=x[it];at!==null&&(x[it]=null,T[it].disconnect(at))}C=null,V=null,v.reset(),t.setRenderTarget(p),d=null,f=null,h=null,s=null,y=null,pt.stop(),i.isPresenting=!1,t.setPixelRatio(A),t.setSize(U.width,U.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",N),s.addEventListener("selectstart",N),s.addEventListener("selectend",N),s.addEventListener("squeeze",N),s.addEventListener("squeezestart",N),s.addEventListener("squeezeend",N),s.addEventListener("end",G),s.addEventListener("inputsourceschange",j),m.xrCompatible!==!0&&await e.makeXRCompatible(),A=t.getPixelRatio(),t.getSize(U),s.renderState.layers===void 0){const at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),y=new Ys(d.framebufferWidth,d.framebufferHeight,{format:xi,type:es,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,gt=null,ot=null;m.depth&&(ot=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?Xr:Nr,gt=m.stencil?$r:qs);const Bt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};h=new XRWebGLBinding(s,e),f=h.createProjectionLayer(Bt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),y=new Ys(f.textureWidth,f.textureHeight,{format:xi,type:es,depthTexture:new Cm(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function j(it){for(let at=0;at<it.removed.length;at++){const gt=it.removed[at],ot=x.indexOf(gt);ot>=0&&(x[ot]=null,T[ot].disconnect(gt))}for(let at=0;at<it.added.length;at++){const gt=it.added[at];let ot=x.indexOf(gt);if(ot===-1){for(let Ht=0;Ht<T.length;Ht++)if(Ht>=x.length){x.push(gt),ot=Ht;break}else if(x[Ht]===null){x[Ht]=gt,ot=Ht;break}if(ot===-1)break}const Bt=T[ot];Bt&&Bt.connect(gt)}}const K=new B,Q=new B;function tt(it,at,gt){K.setFromMatrixPosition(at.matrixWorld),Q.setFromMatrixPosition(gt.matrixWorld);const ot=K.distanceTo(Q),Bt=at.projectionMatrix.elements,Ht=gt.projectionMatrix.elements,Ut=Bt[14]/(Bt[10]-1),he=Bt[14]/(Bt[10]+1),Zt=(Bt[9]+1)/Bt[5],fe=(Bt[9]-1)/Bt[5],z=(Bt[8]-1)/Bt[0],tn=(Ht[8]+1)/Ht[0],Qt=Ut*z,ee=Ut*tn,Gt=ot/(-z+tn),pe=Gt*-z;if(at.matrixWorld.decompose(it.position,it.quaternion,it.scale),it.translateX(pe),it.translateZ(Gt),it.matrixWorld.compose(it.position,it.quaternion,it.scale),it.matrixWorldInverse.copy(it.matrixWorld).invert(),Bt[10]===-1)it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Pt=Ut+Gt,P=he+Gt,E=Qt-pe,Y=ee+(ot-pe),Z=Zt*he/P*Pt,W=fe*he/P*Pt;it.projectionMatrix.makePerspective(E,Y,Z,W,Pt,P),it.projectionMatrixInverse.copy(it.projectionMatrix).invert()}}function ht(it,at){at===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(at.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let at=it.near,gt=it.far;v.texture!==null&&(v.depthNear>0&&(at=v.depthNear),v.depthFar>0&&(gt=v.depthFar)),S.near=I.near=D.near=at,S.far=I.far=D.far=gt,(C!==S.near||V!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,V=S.far),D.layers.mask=it.layers.mask|2,I.layers.mask=it.layers.mask|4,S.layers.mask=D.layers.mask|I.layers.mask;const ot=it.parent,Bt=S.cameras;ht(S,ot);for(let Ht=0;Ht<Bt.length;Ht++)ht(Bt[Ht],ot);Bt.length===2?tt(S,D,I):S.projectionMatrix.copy(D.projectionMatrix),ct(it,S,ot)};function ct(it,at,gt){gt===null?it.matrix.copy(at.matrixWorld):(it.matrix.copy(gt.matrixWorld),it.matrix.invert(),it.matrix.multiply(at.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=pu*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(it){l=it,f!==null&&(f.fixedFoveation=it),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=it)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let mt=null;function Mt(it,at){if(u=at.getViewerPose(c||o),g=at,u!==null){const gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(y,d.framebuffer),t.setRenderTarget(y));let ot=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Ht=0;Ht<gt.length;Ht++){const Ut=gt[Ht];let he=null;if(d!==null)he=d.getViewport(Ut);else{const fe=h.getViewSubImage(f,Ut);he=fe.viewport,Ht===0&&(t.setRenderTargetTextures(y,fe.colorTexture,f.ignoreDepthValues?void 0:fe.depthStencilTexture),t.setRenderTarget(y))}let Zt=w[Ht];Zt===void 0&&(Zt=new Yn,Zt.layers.enable(Ht),Zt.viewport=new We,w[Ht]=Zt),Zt.matrix.fromArray(Ut.transform.matrix),Zt.matrix.decompose(Zt.position,Zt.quaternion,Zt.scale),Zt.projectionMatrix.fromArray(Ut.projectionMatrix),Zt.projectionMatrixInverse.copy(Zt.projectionMatrix).invert(),Zt.viewport.set(he.x,he.y,he.width,he.height),Ht===0&&(S.matrix.copy(Zt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(Zt)}const Bt=s.enabledFeatures;if(Bt&&Bt.includes("depth-sensing")){const Ht=h.getDepthInformation(gt[0]);Ht&&Ht.isValid&&Ht.texture&&v.init(t,Ht,s.renderState)}}for(let gt=0;gt<T.length;gt++){const ot=x[gt],Bt=T[gt];ot!==null&&Bt!==void 0&&Bt.update(ot,at,c||o)}mt&&mt(it,at),at.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:at}),g=null}const pt=new Rm;pt.setAnimationLoop(Mt),this.setAnimationLoop=function(it){mt=it},this.dispose=function(){}}}const Ns=new ki,Jb=new Ne;function Qb(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,wm(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,T,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,x)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===kn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===kn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const y=t.get(p),T=y.envMap,x=y.envMapRotation;T&&(m.envMap.value=T,Ns.copy(x),Ns.x*=-1,Ns.y*=-1,Ns.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(Ns.y*=-1,Ns.z*=-1),m.envMapRotation.value.setFromMatrix4(Jb.makeRotationFromEuler(Ns)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=T*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,y){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===kn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const y=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function tw(n,t,e,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(y,T){const x=T.program;i.uniformBlockBinding(y,x)}function c(y,T){let x=s[y.id];x===void 0&&(g(y),x=u(y),s[y.id]=x,y.addEventListener("dispose",m));const U=T.program;i.updateUBOMapping(y,U);const A=t.render.frame;r[y.id]!==A&&(f(y),r[y.id]=A)}function u(y){const T=h();y.__bindingPointIndex=T;const x=n.createBuffer(),U=y.__size,A=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,x),n.bufferData(n.UNIFORM_BUFFER,U,A),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,T,x),x}function h(){for(let y=0;y<a;y++)if(o.indexOf(y)===-1)return o.push(y),y;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(y){const T=s[y.id],x=y.uniforms,U=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,D=x.length;A<D;A++){const I=Array.isArray(x[A])?x[A]:[x[A]];for(let w=0,S=I.length;w<S;w++){const C=I[w];if(d(C,A,w,U)===!0){const V=C.__offset,N=Array.isArray(C.value)?C.value:[C.value];let G=0;for(let j=0;j<N.length;j++){const K=N[j],Q=v(K);typeof K=="number"||typeof K=="boolean"?(C.__data[0]=K,n.bufferSubData(n.UNIFORM_BUFFER,V+G,C.__data)):K.isMatrix3?(C.__data[0]=K.elements[0],C.__data[1]=K.elements[1],C.__data[2]=K.elements[2],C.__data[3]=0,C.__data[4]=K.elements[3],C.__data[5]=K.elements[4],C.__data[6]=K.elements[5],C.__data[7]=0,C.__data[8]=K.elements[6],C.__data[9]=K.elements[7],C.__data[10]=K.elements[8],C.__data[11]=0):(K.toArray(C.__data,G),G+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,V,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(y,T,x,U){const A=y.value,D=T+"_"+x;if(U[D]===void 0)return typeof A=="number"||typeof A=="boolean"?U[D]=A:U[D]=A.clone(),!0;{const I=U[D];if(typeof A=="number"||typeof A=="boolean"){if(I!==A)return U[D]=A,!0}else if(I.equals(A)===!1)return I.copy(A),!0}return!1}function g(y){const T=y.uniforms;let x=0;const U=16;for(let D=0,I=T.length;D<I;D++){const w=Array.isArray(T[D])?T[D]:[T[D]];for(let S=0,C=w.length;S<C;S++){const V=w[S],N=Array.isArray(V.value)?V.value:[V.value];for(let G=0,j=N.length;G<j;G++){const K=N[G],Q=v(K),tt=x%U,ht=tt%Q.boundary,ct=tt+ht;x+=ht,ct!==0&&U-ct<Q.storage&&(x+=U-ct),V.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=x,x+=Q.storage}}}const A=x%U;return A>0&&(x+=U-A),y.__size=x,y.__cache={},this}function v(y){const T={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(T.boundary=4,T.storage=4):y.isVector2?(T.boundary=8,T.storage=8):y.isVector3||y.isColor?(T.boundary=16,T.storage=12):y.isVector4?(T.boundary=16,T.storage=16):y.isMatrix3?(T.boundary=48,T.storage=48):y.isMatrix4?(T.boundary=64,T.storage=64):y.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",y),T}function m(y){const T=y.target;T.removeEventListener("dispose",m);const x=o.indexOf(T.__bindingPointIndex);o.splice(x,1),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(const y in s)n.deleteBuffer(s[y]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class ew{constructor(t={}){const{canvas:e=Gx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=i.getContextAttributes().alpha}else d=o;const g=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const y=[],T=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=oi,this.toneMapping=_s,this.toneMappingExposure=1;const x=this;let U=!1,A=0,D=0,I=null,w=-1,S=null;const C=new We,V=new We;let N=null;const G=new le(0);let j=0,K=e.width,Q=e.height,tt=1,ht=null,ct=null;const mt=new We(0,0,K,Q),Mt=new We(0,0,K,Q);let pt=!1;const it=new eh;let at=!1,gt=!1;const ot=new Ne,Bt=new Ne,Ht=new B,Ut=new We,he={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Zt=!1;function fe(){return I===null?tt:1}let z=i;function tn(b,O){return e.getContext(b,O)}try{const b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Xu}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",Tt,!1),e.addEventListener("webglcontextcreationerror",At,!1),z===null){const O="webgl2";if(z=tn(O,b),z===null)throw tn(O)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(b){throw console.error("THREE.WebGLRenderer: "+b.message),b}let Qt,ee,Gt,pe,Pt,P,E,Y,Z,W,et,St,_t,wt,jt,ft,vt,Nt,Ot,Et,ie,Yt,me,k;function xt(){Qt=new oE(z),Qt.init(),Yt=new $b(z,Qt),ee=new tE(z,Qt,t,Yt),Gt=new Vb(z,Qt),ee.reverseDepthBuffer&&f&&Gt.buffers.depth.setReversed(!0),pe=new cE(z),Pt=new Ab,P=new Wb(z,Qt,Gt,Pt,ee,Yt,pe),E=new nE(x),Y=new rE(x),Z=new gM(z),me=new Jy(z,Z),W=new aE(z,Z,pe,me),et=new hE(z,W,Z,pe),Ot=new uE(z,ee,P),ft=new eE(Pt),St=new Tb(x,E,Y,Qt,ee,me,ft),_t=new Qb(x,Pt),wt=new Cb,jt=new Nb(Qt),Nt=new Zy(x,E,Y,Gt,et,d,l),vt=new zb(x,et,ee),k=new tw(z,pe,ee,Gt),Et=new Qy(z,Qt,pe),ie=new lE(z,Qt,pe),pe.programs=St.programs,x.capabilities=ee,x.extensions=Qt,x.properties=Pt,x.renderLists=wt,x.shadowMap=vt,x.state=Gt,x.info=pe}xt();const nt=new Zb(x,z);this.xr=nt,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){const b=Qt.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=Qt.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return tt},this.setPixelRatio=function(b){b!==void 0&&(tt=b,this.setSize(K,Q,!1))},this.getSize=function(b){return b.set(K,Q)},this.setSize=function(b,O,$=!0){if(nt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=b,Q=O,e.width=Math.floor(b*tt),e.height=Math.floor(O*tt),$===!0&&(e.style.width=b+"px",e.style.height=O+"px"),this.setViewport(0,0,b,O)},this.getDrawingBufferSize=function(b){return b.set(K*tt,Q*tt).floor()},this.setDrawingBufferSize=function(b,O,$){K=b,Q=O,tt=$,e.width=Math.floor(b*$),e.height=Math.floor(O*$),this.setViewport(0,0,b,O)},this.getCurrentViewport=function(b){return b.copy(C)},this.getViewport=function(b){return b.copy(mt)},this.setViewport=function(b,O,$,X){b.isVector4?mt.set(b.x,b.y,b.z,b.w):mt.set(b,O,$,X),Gt.viewport(C.copy(mt).multiplyScalar(tt).round())},this.getScissor=function(b){return b.copy(Mt)},this.setScissor=function(b,O,$,X){b.isVector4?Mt.set(b.x,b.y,b.z,b.w):Mt.set(b,O,$,X),Gt.scissor(V.copy(Mt).multiplyScalar(tt).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(b){Gt.setScissorTest(pt=b)},this.setOpaqueSort=function(b){ht=b},this.setTransparentSort=function(b){ct=b},this.getClearColor=function(b){return b.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(b=!0,O=!0,$=!0){let X=0;if(b){let H=!1;if(I!==null){const ut=I.texture.format;H=ut===Qu||ut===Ju||ut===Zu}if(H){const ut=I.texture.type,yt=ut===es||ut===qs||ut===Po||ut===$r||ut===Ku||ut===ju,Ft=Nt.getClearColor(),Dt=Nt.getClearAlpha(),Wt=Ft.r,qt=Ft.g,It=Ft.b;yt?(g[0]=Wt,g[1]=qt,g[2]=It,g[3]=Dt,z.clearBufferuiv(z.COLOR,0,g)):(v[0]=Wt,v[1]=qt,v[2]=It,v[3]=Dt,z.clearBufferiv(z.COLOR,0,v))}else X|=z.COLOR_BUFFER_BIT}O&&(X|=z.DEPTH_BUFFER_BIT),$&&(X|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),z.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",Tt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),wt.dispose(),jt.dispose(),Pt.dispose(),E.dispose(),Y.dispose(),et.dispose(),me.dispose(),k.dispose(),St.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Hn),nt.removeEventListener("sessionend",Bi),Un.stop()};function rt(b){b.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),U=!0}function Tt(){console.log("THREE.WebGLRenderer: Context Restored."),U=!1;const b=pe.autoReset,O=vt.enabled,$=vt.autoUpdate,X=vt.needsUpdate,H=vt.type;xt(),pe.autoReset=b,vt.enabled=O,vt.autoUpdate=$,vt.needsUpdate=X,vt.type=H}function At(b){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function Jt(b){const O=b.target;O.removeEventListener("dispose",Jt),He(O)}function He(b){un(b),Pt.remove(b)}function un(b){const O=Pt.get(b).programs;O!==void 0&&(O.forEach(function($){St.releaseProgram($)}),b.isShaderMaterial&&St.releaseShaderCache(b))}this.renderBufferDirect=function(b,O,$,X,H,ut){O===null&&(O=he);const yt=H.isMesh&&H.matrixWorld.determinant()<0,Ft=hl(b,O,$,X,H);Gt.setMaterial(X,yt);let Dt=$.index,Wt=1;if(X.wireframe===!0){if(Dt=W.getWireframeAttribute($),Dt===void 0)return;Wt=2}const qt=$.drawRange,It=$.attributes.position;let oe=qt.start*Wt,be=(qt.start+qt.count)*Wt;ut!==null&&(oe=Math.max(oe,ut.start*Wt),be=Math.min(be,(ut.start+ut.count)*Wt)),Dt!==null?(oe=Math.max(oe,0),be=Math.min(be,Dt.count)):It!=null&&(oe=Math.max(oe,0),be=Math.min(be,It.count));const Ae=be-oe;if(Ae<0||Ae===1/0)return;me.setup(H,X,Ft,$,Dt);let hn,de=Et;if(Dt!==null&&(hn=Z.get(Dt),de=ie,de.setIndex(hn)),H.isMesh)X.wireframe===!0?(Gt.setLineWidth(X.wireframeLinewidth*fe()),de.setMode(z.LINES)):de.setMode(z.TRIANGLES);else if(H.isLine){let kt=X.linewidth;kt===void 0&&(kt=1),Gt.setLineWidth(kt*fe()),H.isLineSegments?de.setMode(z.LINES):H.isLineLoop?de.setMode(z.LINE_LOOP):de.setMode(z.LINE_STRIP)}else H.isPoints?de.setMode(z.POINTS):H.isSprite&&de.setMode(z.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)de.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(Qt.get("WEBGL_multi_draw"))de.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const kt=H._multiDrawStarts,Ve=H._multiDrawCounts,ge=H._multiDrawCount,Nn=Dt?Z.get(Dt).bytesPerElement:1,bi=Pt.get(X).currentProgram.getUniforms();for(let Mn=0;Mn<ge;Mn++)bi.setValue(z,"_gl_DrawID",Mn),de.render(kt[Mn]/Nn,Ve[Mn])}else if(H.isInstancedMesh)de.renderInstances(oe,Ae,H.count);else if($.isInstancedBufferGeometry){const kt=$._maxInstanceCount!==void 0?$._maxInstanceCount:1/0,Ve=Math.min($.instanceCount,kt);de.renderInstances(oe,Ae,Ve)}else de.render(oe,Ae)};function Se(b,O,$){b.transparent===!0&&b.side===Di&&b.forceSinglePass===!1?(b.side=kn,b.needsUpdate=!0,er(b,O,$),b.side=Ms,b.needsUpdate=!0,er(b,O,$),b.side=Di):er(b,O,$)}this.compile=function(b,O,$=null){$===null&&($=b),p=jt.get($),p.init(O),T.push(p),$.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),b!==$&&b.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),p.setupLights();const X=new Set;return b.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const ut=H.material;if(ut)if(Array.isArray(ut))for(let yt=0;yt<ut.length;yt++){const Ft=ut[yt];Se(Ft,$,H),X.add(Ft)}else Se(ut,$,H),X.add(ut)}),T.pop(),p=null,X},this.compileAsync=function(b,O,$=null){const X=this.compile(b,O,$);return new Promise(H=>{function ut(){if(X.forEach(function(yt){Pt.get(yt).currentProgram.isReady()&&X.delete(yt)}),X.size===0){H(b);return}setTimeout(ut,10)}Qt.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let en=null;function Ue(b){en&&en(b)}function Hn(){Un.stop()}function Bi(){Un.start()}const Un=new Rm;Un.setAnimationLoop(Ue),typeof self<"u"&&Un.setContext(self),this.setAnimationLoop=function(b){en=b,nt.setAnimationLoop(b),b===null?Un.stop():Un.start()},nt.addEventListener("sessionstart",Hn),nt.addEventListener("sessionend",Bi),this.render=function(b,O){if(O!==void 0&&O.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(O),O=nt.getCamera()),b.isScene===!0&&b.onBeforeRender(x,b,O,I),p=jt.get(b,T.length),p.init(O),T.push(p),Bt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),it.setFromProjectionMatrix(Bt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),m=wt.get(b,y.length),m.init(),y.push(m),nt.enabled===!0&&nt.isPresenting===!0){const ut=x.xr.getDepthSensingMesh();ut!==null&&xn(ut,O,-1/0,x.sortObjects)}xn(b,O,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(ht,ct),Zt=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Zt&&Nt.addToRenderList(m,b),this.info.render.frame++,at===!0&&ft.beginShadows();const $=p.state.shadowsArray;vt.render($,b,O),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const X=m.opaque,H=m.transmissive;if(p.setupLights(),O.isArrayCamera){const ut=O.cameras;if(H.length>0)for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Hi(X,H,b,Dt)}Zt&&Nt.render(b);for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];zi(m,b,Dt,Dt.viewport)}}else H.length>0&&Hi(X,H,b,O),Zt&&Nt.render(b),zi(m,b,O);I!==null&&(P.updateMultisampleRenderTarget(I),P.updateRenderTargetMipmap(I)),b.isScene===!0&&b.onAfterRender(x,b,O),me.resetDefaultState(),w=-1,S=null,T.pop(),T.length>0?(p=T[T.length-1],at===!0&&ft.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,y.pop(),y.length>0?m=y[y.length-1]:m=null};function xn(b,O,$,X){if(b.visible===!1)return;if(b.layers.test(O.layers)){if(b.isGroup)$=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(O);else if(b.isLight)p.pushLight(b),b.castShadow&&p.pushShadow(b);else if(b.isSprite){if(!b.frustumCulled||it.intersectsSprite(b)){X&&Ut.setFromMatrixPosition(b.matrixWorld).applyMatrix4(Bt);const yt=et.update(b),Ft=b.material;Ft.visible&&m.push(b,yt,Ft,$,Ut.z,null)}}else if((b.isMesh||b.isLine||b.isPoints)&&(!b.frustumCulled||it.intersectsObject(b))){const yt=et.update(b),Ft=b.material;if(X&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),Ut.copy(b.boundingSphere.center)):(yt.boundingSphere===null&&yt.computeBoundingSphere(),Ut.copy(yt.boundingSphere.center)),Ut.applyMatrix4(b.matrixWorld).applyMatrix4(Bt)),Array.isArray(Ft)){const Dt=yt.groups;for(let Wt=0,qt=Dt.length;Wt<qt;Wt++){const It=Dt[Wt],oe=Ft[It.materialIndex];oe&&oe.visible&&m.push(b,yt,oe,$,Ut.z,It)}}else Ft.visible&&m.push(b,yt,Ft,$,Ut.z,null)}}const ut=b.children;for(let yt=0,Ft=ut.length;yt<Ft;yt++)xn(ut[yt],O,$,X)}function zi(b,O,$,X){const H=b.opaque,ut=b.transmissive,yt=b.transparent;p.setupLightsView($),at===!0&&ft.setGlobalState(x.clippingPlanes,$),X&&Gt.viewport(C.copy(X)),H.length>0&&ys(H,O,$),ut.length>0&&ys(ut,O,$),yt.length>0&&ys(yt,O,$),Gt.buffers.depth.setTest(!0),Gt.buffers.depth.setMask(!0),Gt.buffers.color.setMask(!0),Gt.setPolygonOffset(!1)}function Hi(b,O,$,X){if(($.isScene===!0?$.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[X.id]===void 0&&(p.state.transmissionRenderTarget[X.id]=new Ys(1,1,{generateMipmaps:!0,type:Qt.has("EXT_color_buffer_half_float")||Qt.has("EXT_color_buffer_float")?Io:es,minFilter:Ws,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_e.workingColorSpace}));const ut=p.state.transmissionRenderTarget[X.id],yt=X.viewport||C;ut.setSize(yt.z,yt.w);const Ft=x.getRenderTarget();x.setRenderTarget(ut),x.getClearColor(G),j=x.getClearAlpha(),j<1&&x.setClearColor(16777215,.5),x.clear(),Zt&&Nt.render($);const Dt=x.toneMapping;x.toneMapping=_s;const Wt=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),p.setupLightsView(X),at===!0&&ft.setGlobalState(x.clippingPlanes,X),ys(b,$,X),P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut),Qt.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let It=0,oe=O.length;It<oe;It++){const be=O[It],Ae=be.object,hn=be.geometry,de=be.material,kt=be.group;if(de.side===Di&&Ae.layers.test(X.layers)){const Ve=de.side;de.side=kn,de.needsUpdate=!0,so(Ae,$,X,hn,de,kt),de.side=Ve,de.needsUpdate=!0,qt=!0}}qt===!0&&(P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut))}x.setRenderTarget(Ft),x.setClearColor(G,j),Wt!==void 0&&(X.viewport=Wt),x.toneMapping=Dt}function ys(b,O,$){const X=O.isScene===!0?O.overrideMaterial:null;for(let H=0,ut=b.length;H<ut;H++){const yt=b[H],Ft=yt.object,Dt=yt.geometry,Wt=X===null?yt.material:X,qt=yt.group;Ft.layers.test($.layers)&&so(Ft,O,$,Dt,Wt,qt)}}function so(b,O,$,X,H,ut){b.onBeforeRender(x,O,$,X,H,ut),b.modelViewMatrix.multiplyMatrices($.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),H.onBeforeRender(x,O,$,X,b,ut),H.transparent===!0&&H.side===Di&&H.forceSinglePass===!1?(H.side=kn,H.needsUpdate=!0,x.renderBufferDirect($,O,X,H,b,ut),H.side=Ms,H.needsUpdate=!0,x.renderBufferDirect($,O,X,H,b,ut),H.side=Di):x.renderBufferDirect($,O,X,H,b,ut),b.onAfterRender(x,O,$,X,H,ut)}function er(b,O,$){O.isScene!==!0&&(O=he);const X=Pt.get(b),H=p.state.lights,ut=p.state.shadowsArray,yt=H.state.version,Ft=St.getParameters(b,H.state,ut,O,$),Dt=St.getProgramCacheKey(Ft);let Wt=X.programs;X.environment=b.isMeshStandardMaterial?O.environment:null,X.fog=O.fog,X.envMap=(b.isMeshStandardMaterial?Y:E).get(b.envMap||X.environment),X.envMapRotation=X.environment!==null&&b.envMap===null?O.environmentRotation:b.envMapRotation,Wt===void 0&&(b.addEventListener("dispose",Jt),Wt=new Map,X.programs=Wt);let qt=Wt.get(Dt);if(qt!==void 0){if(X.currentProgram===qt&&X.lightsStateVersion===yt)return Ei(b,Ft),qt}else Ft.uniforms=St.getUniforms(b),b.onBeforeCompile(Ft,x),qt=St.acquireProgram(Ft,Dt),Wt.set(Dt,qt),X.uniforms=Ft.uniforms;const It=X.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(It.clippingPlanes=ft.uniform),Ei(b,Ft),X.needsLights=ko(b),X.lightsStateVersion=yt,X.needsLights&&(It.ambientLightColor.value=H.state.ambient,It.lightProbe.value=H.state.probe,It.directionalLights.value=H.state.directional,It.directionalLightShadows.value=H.state.directionalShadow,It.spotLights.value=H.state.spot,It.spotLightShadows.value=H.state.spotShadow,It.rectAreaLights.value=H.state.rectArea,It.ltc_1.value=H.state.rectAreaLTC1,It.ltc_2.value=H.state.rectAreaLTC2,It.pointLights.value=H.state.point,It.pointLightShadows.value=H.state.pointShadow,It.hemisphereLights.value=H.state.hemi,It.directionalShadowMap.value=H.state.directionalShadowMap,It.directionalShadowMatrix.value=H.state.directionalShadowMatrix,It.spotShadowMap.value=H.state.spotShadowMap,It.spotLightMatrix.value=H.state.spotLightMatrix,It.spotLightMap.value=H.state.spotLightMap,It.pointShadowMap.value=H.state.pointShadowMap,It.pointShadowMatrix.value=H.state.pointShadowMatrix),X.currentProgram=qt,X.uniformsList=null,qt}function Oo(b){if(b.uniformsList===null){const O=b.currentProgram.getUniforms();b.uniformsList=Ua.seqWithValue(O.seq,b.uniforms)}return b.uniformsList}function Ei(b,O){const $=Pt.get(b);$.outputColorSpace=O.outputColorSpace,$.batching=O.batching,$.batchingColor=O.batchingColor,$.instancing=O.instancing,$.instancingColor=O.instancingColor,$.instancingMorph=O.instancingMorph,$.skinning=O.skinning,$.morphTargets=O.morphTargets,$.morphNormals=O.morphNormals,$.morphColors=O.morphColors,$.morphTargetsCount=O.morphTargetsCount,$.numClippingPlanes=O.numClippingPlanes,$.numIntersection=O.numClipIntersection,$.vertexAlphas=O.vertexAlphas,$.vertexTangents=O.vertexTangents,$.toneMapping=O.toneMapping}function hl(b,O,$,X,H){O.isScene!==!0&&(O=he),P.resetTextureUnits();const ut=O.fog,yt=X.isMeshStandardMaterial?O.environment:null,Ft=I===null?x.outputColorSpace:I.isXRRenderTarget===!0?I.texture.colorSpace:Js,Dt=(X.isMeshStandardMaterial?Y:E).get(X.envMap||yt),Wt=X.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,qt=!!$.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),It=!!$.morphAttributes.position,oe=!!$.morphAttributes.normal,be=!!$.morphAttributes.color;let Ae=_s;X.toneMapped&&(I===null||I.isXRRenderTarget===!0)&&(Ae=x.toneMapping);const hn=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,de=hn!==void 0?hn.length:0,kt=Pt.get(X),Ve=p.state.lights;if(at===!0&&(gt===!0||b!==S)){const wn=b===S&&X.id===w;ft.setState(X,b,wn)}let ge=!1;X.version===kt.__version?(kt.needsLights&&kt.lightsStateVersion!==Ve.state.version||kt.outputColorSpace!==Ft||H.isBatchedMesh&&kt.batching===!1||!H.isBatchedMesh&&kt.batching===!0||H.isBatchedMesh&&kt.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&kt.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&kt.instancing===!1||!H.isInstancedMesh&&kt.instancing===!0||H.isSkinnedMesh&&kt.skinning===!1||!H.isSkinnedMesh&&kt.skinning===!0||H.isInstancedMesh&&kt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&kt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&kt.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&kt.instancingMorph===!1&&H.morphTexture!==null||kt.envMap!==Dt||X.fog===!0&&kt.fog!==ut||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==ft.numPlanes||kt.numIntersection!==ft.numIntersection)||kt.vertexAlphas!==Wt||kt.vertexTangents!==qt||kt.morphTargets!==It||kt.morphNormals!==oe||kt.morphColors!==be||kt.toneMapping!==Ae||kt.morphTargetsCount!==de)&&(ge=!0):(ge=!0,kt.__version=X.version);let Nn=kt.currentProgram;ge===!0&&(Nn=er(X,O,H));let bi=!1,Mn=!1,bs=!1;const Le=Nn.getUniforms(),Qn=kt.uniforms;if(Gt.useProgram(Nn.program)&&(bi=!0,Mn=!0,bs=!0),X.id!==w&&(w=X.id,Mn=!0),bi||S!==b){Gt.buffers.depth.getReversed()?(ot.copy(b.projectionMatrix),$x(ot),Xx(ot),Le.setValue(z,"projectionMatrix",ot)):Le.setValue(z,"projectionMatrix",b.projectionMatrix),Le.setValue(z,"viewMatrix",b.matrixWorldInverse);const wi=Le.map.cameraPosition;wi!==void 0&&wi.setValue(z,Ht.setFromMatrixPosition(b.matrixWorld)),ee.logarithmicDepthBuffer&&Le.setValue(z,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&Le.setValue(z,"isOrthographic",b.isOrthographicCamera===!0),S!==b&&(S=b,Mn=!0,bs=!0)}if(H.isSkinnedMesh){Le.setOptional(z,H,"bindMatrix"),Le.setOptional(z,H,"bindMatrixInverse");const wn=H.skeleton;wn&&(wn.boneTexture===null&&wn.computeBoneTexture(),Le.setValue(z,"boneTexture",wn.boneTexture,P))}H.isBatchedMesh&&(Le.setOptional(z,H,"batchingTexture"),Le.setValue(z,"batchingTexture",H._matricesTexture,P),Le.setOptional(z,H,"batchingIdTexture"),Le.setValue(z,"batchingIdTexture",H._indirectTexture,P),Le.setOptional(z,H,"batchingColorTexture"),H._colorsTexture!==null&&Le.setValue(z,"batchingColorTexture",H._colorsTexture,P));const is=$.morphAttributes;if((is.position!==void 0||is.normal!==void 0||is.color!==void 0)&&Ot.update(H,$,Nn),(Mn||kt.receiveShadow!==H.receiveShadow)&&(kt.receiveShadow=H.receiveShadow,Le.setValue(z,"receiveShadow",H.receiveShadow)),X.isMeshGouraudMaterial&&X.envMap!==null&&(Qn.envMap.value=Dt,Qn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),X.isMeshStandardMaterial&&X.envMap===null&&O.environment!==null&&(Qn.envMapIntensity.value=O.environmentIntensity),Mn&&(Le.setValue(z,"toneMappingExposure",x.toneMappingExposure),kt.needsLights&&Es(Qn,bs),ut&&X.fog===!0&&_t.refreshFogUniforms(Qn,ut),_t.refreshMaterialUniforms(Qn,X,tt,Q,p.state.transmissionRenderTarget[b.id]),Ua.upload(z,Oo(kt),Qn,P)),X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(Ua.upload(z,Oo(kt),Qn,P),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&Le.setValue(z,"center",H.center),Le.setValue(z,"modelViewMatrix",H.modelViewMatrix),Le.setValue(z,"normalMatrix",H.normalMatrix),Le.setValue(z,"modelMatrix",H.matrixWorld),X.isShaderMaterial||X.isRawShaderMaterial){const wn=X.uniformsGroups;for(let wi=0,ui=wn.length;wi<ui;wi++){const nr=wn[wi];k.update(nr,Nn),k.bind(nr,Nn)}}return Nn}function Es(b,O){b.ambientLightColor.needsUpdate=O,b.lightProbe.needsUpdate=O,b.directionalLights.needsUpdate=O,b.directionalLightShadows.needsUpdate=O,b.pointLights.needsUpdate=O,b.pointLightShadows.needsUpdate=O,b.spotLights.needsUpdate=O,b.spotLightShadows.needsUpdate=O,b.rectAreaLights.needsUpdate=O,b.hemisphereLights.needsUpdate=O}function ko(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return I},this.setRenderTargetTextures=function(b,O,$){Pt.get(b.texture).__webglTexture=O,Pt.get(b.depthTexture).__webglTexture=$;const X=Pt.get(b);X.__hasExternalTextures=!0,X.__autoAllocateDepthBuffer=$===void 0,X.__autoAllocateDepthBuffer||Qt.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),X.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(b,O){const $=Pt.get(b);$.__webglFramebuffer=O,$.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(b,O=0,$=0){I=b,A=O,D=$;let X=!0,H=null,ut=!1,yt=!1;if(b){const Dt=Pt.get(b);if(Dt.__useDefaultFramebuffer!==void 0)Gt.bindFramebuffer(z.FRAMEBUFFER,null),X=!1;else if(Dt.__webglFramebuffer===void 0)P.setupRenderTarget(b);else if(Dt.__hasExternalTextures)P.rebindTextures(b,Pt.get(b.texture).__webglTexture,Pt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const It=b.depthTexture;if(Dt.__boundDepthTexture!==It){if(It!==null&&Pt.has(It)&&(b.width!==It.image.width||b.height!==It.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(b)}}const Wt=b.texture;(Wt.isData3DTexture||Wt.isDataArrayTexture||Wt.isCompressedArrayTexture)&&(yt=!0);const qt=Pt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(qt[O])?H=qt[O][$]:H=qt[O],ut=!0):b.samples>0&&P.useMultisampledRTT(b)===!1?H=Pt.get(b).__webglMultisampledFramebuffer:Array.isArray(qt)?H=qt[$]:H=qt,C.copy(b.viewport),V.copy(b.scissor),N=b.scissorTest}else C.copy(mt).multiplyScalar(tt).floor(),V.copy(Mt).multiplyScalar(tt).floor(),N=pt;if(Gt.bindFramebuffer(z.FRAMEBUFFER,H)&&X&&Gt.drawBuffers(b,H),Gt.viewport(C),Gt.scissor(V),Gt.setScissorTest(N),ut){const Dt=Pt.get(b.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+O,Dt.__webglTexture,$)}else if(yt){const Dt=Pt.get(b.texture),Wt=O||0;z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,Dt.__webglTexture,$||0,Wt)}w=-1},this.readRenderTargetPixels=function(b,O,$,X,H,ut,yt){if(!(b&&b.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){Gt.bindFramebuffer(z.FRAMEBUFFER,Ft);try{const Dt=b.texture,Wt=Dt.format,qt=Dt.type;if(!ee.textureFormatReadable(Wt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!ee.textureTypeReadable(qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=b.width-X&&$>=0&&$<=b.height-H&&z.readPixels(O,$,X,H,Yt.convert(Wt),Yt.convert(qt),ut)}finally{const Dt=I!==null?Pt.get(I).__webglFramebuffer:null;Gt.bindFramebuffer(z.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(b,O,$,X,H,ut,yt){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){const Dt=b.texture,Wt=Dt.format,qt=Dt.type;if(!ee.textureFormatReadable(Wt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!ee.textureTypeReadable(qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(O>=0&&O<=b.width-X&&$>=0&&$<=b.height-H){Gt.bindFramebuffer(z.FRAMEBUFFER,Ft);const It=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,It),z.bufferData(z.PIXEL_PACK_BUFFER,ut.byteLength,z.STREAM_READ),z.readPixels(O,$,X,H,Yt.convert(Wt),Yt.convert(qt),0);const oe=I!==null?Pt.get(I).__webglFramebuffer:null;Gt.bindFramebuffer(z.FRAMEBUFFER,oe);const be=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await Wx(z,be,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,It),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,ut),z.deleteBuffer(It),z.deleteSync(be),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(b,O=null,$=0){b.isTexture!==!0&&(Eo("WebGLRenderer: copyFramebufferToTexture function signature has changed."),O=arguments[0]||null,b=arguments[1]);const X=Math.pow(2,-$),H=Math.floor(b.image.width*X),ut=Math.floor(b.image.height*X),yt=O!==null?O.x:0,Ft=O!==null?O.y:0;P.setTexture2D(b,0),z.copyTexSubImage2D(z.TEXTURE_2D,$,0,0,yt,Ft,H,ut),Gt.unbindTexture()},this.copyTextureToTexture=function(b,O,$=null,X=null,H=0){b.isTexture!==!0&&(Eo("WebGLRenderer: copyTextureToTexture function signature has changed."),X=arguments[0]||null,b=arguments[1],O=arguments[2],H=arguments[3]||0,$=null);let ut,yt,Ft,Dt,Wt,qt,It,oe,be;const Ae=b.isCompressedTexture?b.mipmaps[H]:b.image;$!==null?(ut=$.max.x-$.min.x,yt=$.max.y-$.min.y,Ft=$.isBox3?$.max.z-$.min.z:1,Dt=$.min.x,Wt=$.min.y,qt=$.isBox3?$.min.z:0):(ut=Ae.width,yt=Ae.height,Ft=Ae.depth||1,Dt=0,Wt=0,qt=0),X!==null?(It=X.x,oe=X.y,be=X.z):(It=0,oe=0,be=0);const hn=Yt.convert(O.format),de=Yt.convert(O.type);let kt;O.isData3DTexture?(P.setTexture3D(O,0),kt=z.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(P.setTexture2DArray(O,0),kt=z.TEXTURE_2D_ARRAY):(P.setTexture2D(O,0),kt=z.TEXTURE_2D),z.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,O.flipY),z.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),z.pixelStorei(z.UNPACK_ALIGNMENT,O.unpackAlignment);const Ve=z.getParameter(z.UNPACK_ROW_LENGTH),ge=z.getParameter(z.UNPACK_IMAGE_HEIGHT),Nn=z.getParameter(z.UNPACK_SKIP_PIXELS),bi=z.getParameter(z.UNPACK_SKIP_ROWS),Mn=z.getParameter(z.UNPACK_SKIP_IMAGES);z.pixelStorei(z.UNPACK_ROW_LENGTH,Ae.width),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Ae.height),z.pixelStorei(z.UNPACK_SKIP_PIXELS,Dt),z.pixelStorei(z.UNPACK_SKIP_ROWS,Wt),z.pixelStorei(z.UNPACK_SKIP_IMAGES,qt);const bs=b.isDataArrayTexture||b.isData3DTexture,Le=O.isDataArrayTexture||O.isData3DTexture;if(b.isRenderTargetTexture||b.isDepthTexture){const Qn=Pt.get(b),is=Pt.get(O),wn=Pt.get(Qn.__renderTarget),wi=Pt.get(is.__renderTarget);Gt.bindFramebuffer(z.READ_FRAMEBUFFER,wn.__webglFramebuffer),Gt.bindFramebuffer(z.DRAW_FRAMEBUFFER,wi.__webglFramebuffer);for(let ui=0;ui<Ft;ui++)bs&&z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Pt.get(b).__webglTexture,H,qt+ui),b.isDepthTexture?(Le&&z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Pt.get(O).__webglTexture,H,be+ui),z.blitFramebuffer(Dt,Wt,ut,yt,It,oe,ut,yt,z.DEPTH_BUFFER_BIT,z.NEAREST)):Le?z.copyTexSubImage3D(kt,H,It,oe,be+ui,Dt,Wt,ut,yt):z.copyTexSubImage2D(kt,H,It,oe,be+ui,Dt,Wt,ut,yt);Gt.bindFramebuffer(z.READ_FRAMEBUFFER,null),Gt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else Le?b.isDataTexture||b.isData3DTexture?z.texSubImage3D(kt,H,It,oe,be,ut,yt,Ft,hn,de,Ae.data):O.isCompressedArrayTexture?z.compressedTexSubImage3D(kt,H,It,oe,be,ut,yt,Ft,hn,Ae.data):z.texSubImage3D(kt,H,It,oe,be,ut,yt,Ft,hn,de,Ae):b.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,H,It,oe,ut,yt,hn,de,Ae.data):b.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,H,It,oe,Ae.width,Ae.height,hn,Ae.data):z.texSubImage2D(z.TEXTURE_2D,H,It,oe,ut,yt,hn,de,Ae);z.pixelStorei(z.UNPACK_ROW_LENGTH,Ve),z.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ge),z.pixelStorei(z.UNPACK_SKIP_PIXELS,Nn),z.pixelStorei(z.UNPACK_SKIP_ROWS,bi),z.pixelStorei(z.UNPACK_SKIP_IMAGES,Mn),H===0&&O.generateMipmaps&&z.generateMipmap(kt),Gt.unbindTexture()},this.copyTextureToTexture3D=function(b,O,$=null,X=null,H=0){return b.isTexture!==!0&&(Eo("WebGLRenderer: copyTextureToTexture3D function signature has changed."),$=arguments[0]||null,X=arguments[1]||null,b=arguments[2],O=arguments[3],H=arguments[4]||0),Eo('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(b,O,$,X,H)},this.initRenderTarget=function(b){Pt.get(b).__webglFramebuffer===void 0&&P.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?P.setTextureCube(b,0):b.isData3DTexture?P.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?P.setTexture2DArray(b,0):P.setTexture2D(b,0),Gt.unbindTexture()},this.resetState=function(){A=0,D=0,I=null,Gt.reset(),me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Zi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}}let Ld=class extends rn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ki,this.environmentIntensity=1,this.environmentRotation=new ki,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};class Fo extends Qs{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new le(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const Ga=new B,Wa=new B,Dd=new Ne,vo=new th,ga=new No,lc=new B,Id=new B;class Um extends rn{constructor(t=new cn,e=new Fo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ga.fromBufferAttribute(e,s-1),Wa.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ga.distanceTo(Wa);t.setAttribute("lineDistance",new ze(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ga.copy(i.boundingSphere),ga.applyMatrix4(s),ga.radius+=r,t.ray.intersectsSphere(ga)===!1)return;Dd.copy(s).invert(),vo.copy(t.ray).applyMatrix4(Dd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){const d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=u.getX(v),y=u.getX(v+1),T=_a(this,t,vo,l,p,y);T&&e.push(T)}if(this.isLineLoop){const v=u.getX(g-1),m=u.getX(d),p=_a(this,t,vo,l,v,m);p&&e.push(p)}}else{const d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=_a(this,t,vo,l,v,v+1);p&&e.push(p)}if(this.isLineLoop){const v=_a(this,t,vo,l,g-1,d);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function _a(n,t,e,i,s,r){const o=n.geometry.attributes.position;if(Ga.fromBufferAttribute(o,s),Wa.fromBufferAttribute(o,r),e.distanceSqToSegment(Ga,Wa,lc,Id)>i)return;lc.applyMatrix4(n.matrixWorld);const l=t.ray.origin.distanceTo(lc);if(!(l<t.near||l>t.far))return{distance:l,point:Id.clone().applyMatrix4(n.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:n}}const Ud=new B,Nd=new B;class Nm extends Um{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Ud.fromBufferAttribute(e,s),Nd.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Ud.distanceTo(Nd);t.setAttribute("lineDistance",new ze(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class Fm extends Qs{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new le(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const Fd=new Ne,gu=new th,va=new No,xa=new B;class nw extends rn{constructor(t=new cn,e=new Fm){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),va.copy(i.boundingSphere),va.applyMatrix4(s),va.radius+=r,t.ray.intersectsSphere(va)===!1)return;Fd.copy(s).invert(),gu.copy(t.ray).applyMatrix4(Fd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){const f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,v=d;g<v;g++){const m=c.getX(g);xa.fromBufferAttribute(h,m),Od(xa,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let g=f,v=d;g<v;g++)xa.fromBufferAttribute(h,g),Od(xa,g,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Od(n,t,e,i,s,r,o){const a=gu.distanceSqToPoint(n);if(a<e){const l=new B;gu.closestPointToPoint(n,l),l.applyMatrix4(i);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class sh extends cn{constructor(t=[new ce(0,-.5),new ce(.5,0),new ce(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Dn(s,0,Math.PI*2);const r=[],o=[],a=[],l=[],c=[],u=1/e,h=new B,f=new ce,d=new B,g=new B,v=new B;let m=0,p=0;for(let y=0;y<=t.length-1;y++)switch(y){case 0:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,v.copy(d),d.normalize(),l.push(d.x,d.y,d.z);break;case t.length-1:l.push(v.x,v.y,v.z);break;default:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,g.copy(d),d.x+=v.x,d.y+=v.y,d.z+=v.z,d.normalize(),l.push(d.x,d.y,d.z),v.copy(g)}for(let y=0;y<=e;y++){const T=i+y*u*s,x=Math.sin(T),U=Math.cos(T);for(let A=0;A<=t.length-1;A++){h.x=t[A].x*x,h.y=t[A].y,h.z=t[A].x*U,o.push(h.x,h.y,h.z),f.x=y/e,f.y=A/(t.length-1),a.push(f.x,f.y);const D=l[3*A+0]*x,I=l[3*A+1],w=l[3*A+0]*U;c.push(D,I,w)}}for(let y=0;y<e;y++)for(let T=0;T<t.length-1;T++){const x=T+y*t.length,U=x,A=x+t.length,D=x+t.length+1,I=x+1;r.push(U,A,I),r.push(D,I,A)}this.setIndex(r),this.setAttribute("position",new ze(o,3)),this.setAttribute("uv",new ze(a,2)),this.setAttribute("normal",new ze(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new sh(t.points,t.segments,t.phiStart,t.phiLength)}}class rh extends cn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],f=[],d=[];let g=0;const v=[],m=i/2;let p=0;y(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new ze(h,3)),this.setAttribute("normal",new ze(f,3)),this.setAttribute("uv",new ze(d,2));function y(){const x=new B,U=new B;let A=0;const D=(e-t)/i;for(let I=0;I<=r;I++){const w=[],S=I/r,C=S*(e-t)+t;for(let V=0;V<=s;V++){const N=V/s,G=N*l+a,j=Math.sin(G),K=Math.cos(G);U.x=C*j,U.y=-S*i+m,U.z=C*K,h.push(U.x,U.y,U.z),x.set(j,D,K).normalize(),f.push(x.x,x.y,x.z),d.push(N,1-S),w.push(g++)}v.push(w)}for(let I=0;I<s;I++)for(let w=0;w<r;w++){const S=v[w][I],C=v[w+1][I],V=v[w+1][I+1],N=v[w][I+1];(t>0||w!==0)&&(u.push(S,C,N),A+=3),(e>0||w!==r-1)&&(u.push(C,V,N),A+=3)}c.addGroup(p,A,0),p+=A}function T(x){const U=g,A=new ce,D=new B;let I=0;const w=x===!0?t:e,S=x===!0?1:-1;for(let V=1;V<=s;V++)h.push(0,m*S,0),f.push(0,S,0),d.push(.5,.5),g++;const C=g;for(let V=0;V<=s;V++){const G=V/s*l+a,j=Math.cos(G),K=Math.sin(G);D.x=w*K,D.y=m*S,D.z=w*j,h.push(D.x,D.y,D.z),f.push(0,S,0),A.x=j*.5+.5,A.y=K*.5*S+.5,d.push(A.x,A.y),g++}for(let V=0;V<s;V++){const N=U+V,G=C+V;x===!0?u.push(G,G+1,N):u.push(G+1,G,N),I+=3}c.addGroup(p,I,x===!0?1:2),p+=I}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new rh(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}const Ma=new B,Sa=new B,cc=new B,ya=new ai;class Om extends cn{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){const s=Math.pow(10,4),r=Math.cos(Ia*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);const{a:v,b:m,c:p}=ya;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),ya.getNormal(cc),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){const T=(y+1)%3,x=h[y],U=h[T],A=ya[u[y]],D=ya[u[T]],I=`${x}_${U}`,w=`${U}_${x}`;w in f&&f[w]?(cc.dot(f[w].normal)<=r&&(d.push(A.x,A.y,A.z),d.push(D.x,D.y,D.z)),f[w]=null):I in f||(f[I]={index0:c[y],index1:c[T],normal:cc.clone()})}}for(const g in f)if(f[g]){const{index0:v,index1:m}=f[g];Ma.fromBufferAttribute(a,v),Sa.fromBufferAttribute(a,m),d.push(Ma.x,Ma.y,Ma.z),d.push(Sa.x,Sa.y,Sa.z)}this.setAttribute("position",new ze(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}}class cl extends cn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const u=[],h=new B,f=new B,d=[],g=[],v=[],m=[];for(let p=0;p<=i;p++){const y=[],T=p/i;let x=0;p===0&&o===0?x=.5/e:p===i&&l===Math.PI&&(x=-.5/e);for(let U=0;U<=e;U++){const A=U/e;h.x=-t*Math.cos(s+A*r)*Math.sin(o+T*a),h.y=t*Math.cos(o+T*a),h.z=t*Math.sin(s+A*r)*Math.sin(o+T*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),m.push(A+x,1-T),y.push(c++)}u.push(y)}for(let p=0;p<i;p++)for(let y=0;y<e;y++){const T=u[p][y+1],x=u[p][y],U=u[p+1][y],A=u[p+1][y+1];(p!==0||o>0)&&d.push(T,x,A),(p!==i-1||l<Math.PI)&&d.push(x,U,A)}this.setIndex(d),this.setAttribute("position",new ze(g,3)),this.setAttribute("normal",new ze(v,3)),this.setAttribute("uv",new ze(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new cl(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}}class oh extends cn{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new B,h=new B,f=new B;for(let d=0;d<=i;d++)for(let g=0;g<=s;g++){const v=g/s*r,m=d/i*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(d/i)}for(let d=1;d<=i;d++)for(let g=1;g<=s;g++){const v=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,y=(s+1)*d+g;o.push(v,m,y),o.push(m,p,y)}this.setIndex(o),this.setAttribute("position",new ze(a,3)),this.setAttribute("normal",new ze(l,3)),this.setAttribute("uv",new ze(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new oh(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class iw extends Qs{static get type(){return"MeshLambertMaterial"}constructor(t){super(),this.isMeshLambertMaterial=!0,this.color=new le(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new le(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=gm,this.normalScale=new ce(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ki,this.combine=qu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class km extends Fo{static get type(){return"LineDashedMaterial"}constructor(t){super(),this.isLineDashedMaterial=!0,this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}}class Bm extends rn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new le(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class sw extends Bm{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(rn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new le(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const uc=new Ne,kd=new B,Bd=new B;class rw{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ce(512,512),this.map=null,this.mapPass=null,this.matrix=new Ne,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new eh,this._frameExtents=new ce(1,1),this._viewportCount=1,this._viewports=[new We(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,i=this.matrix;kd.setFromMatrixPosition(t.matrixWorld),e.position.copy(kd),Bd.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Bd),e.updateMatrixWorld(),uc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(uc),i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(uc)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class ow extends rw{constructor(){super(new nh(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class aw extends Bm{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(rn.DEFAULT_UP),this.updateMatrix(),this.target=new rn,this.shadow=new ow}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Xu}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Xu);function $a(n,t=!1){const e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new cn;let c=0;for(let u=0;u<n.length;++u){const h=n[u];let f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(const d in h.attributes){if(!i.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+d+'" attribute exists among all geometries, or in none of them.'),null;r[d]===void 0&&(r[d]=[]),r[d].push(h.attributes[d]),f++}if(f!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(const d in h.morphAttributes){if(!s.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;o[d]===void 0&&(o[d]=[]),o[d].push(h.morphAttributes[d])}if(t){let d;if(e)d=h.index.count;else if(h.attributes.position!==void 0)d=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,d,u),c+=d}}if(e){let u=0;const h=[];for(let f=0;f<n.length;++f){const d=n[f].index;for(let g=0;g<d.count;++g)h.push(d.getX(g)+u);u+=n[f].attributes.position.count}l.setIndex(h)}for(const u in r){const h=zd(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(const u in o){const h=o[u][0].length;if(h===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let f=0;f<h;++f){const d=[];for(let v=0;v<o[u].length;++v)d.push(o[u][v][f]);const g=zd(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(g)}}return l}function zd(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){const u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}const o=new t(r),a=new zn(o,e,i);let l=0;for(let c=0;c<n.length;++c){const u=n[c];if(u.isInterleavedBufferAttribute){const h=l/e;for(let f=0,d=u.count;f<d;f++)for(let g=0;g<e;g++){const v=u.getComponent(f,g);a.setComponent(f+h,g,v)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}const lw={...Xt,limit:"#6f8aa5"},Ks=n=>lw[n],zm={x:new B(1,0,0),y:new B(0,1,0),z:new B(0,0,1)},Oi=n=>Ya?Math.ceil(n/2):n,cw=n=>new B(...Yr[n]),Hm=(n,t)=>new ns().setFromUnitVectors(zm[n],cw(t));function hc(n,{colour:t,centre_m:e,along:i},s){n.deleteAttribute("uv");const r=new le(t),o=new Float32Array(n.attributes.position.count*3);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return n.setAttribute("color",new zn(o,3)),i&&n.applyQuaternion(Hm(s,i)),n.translate(...e)}const uw={box:n=>hc(new no(...n.size_m),n),cylinder:n=>hc(new rh(n.radius_m,n.other_radius_m??n.radius_m,n.length_m,Oi(32)),n,"y"),torus:n=>hc(new oh(n.radius_m,n.thickness_m,Oi(8),Oi(72)),n,"z")},_u=n=>n.map(t=>uw[t.kind](t));function hw(n){const t=new Fi,e=n.role==="predicted"||n.role==="truth";t.inner=e?dw(n):fw(n),t.add(t.inner);const{min:i,max:s}=new to().setFromObject(t.inner);return t.reach="xyz".split("").map(r=>Math.max(-i[r],s[r])),t}function fw({shape:n}){const t=new Fi,e=n.filter(s=>s.lit),i=n.filter(s=>!s.lit);return e.length&&(t.lit=new iw({vertexColors:!0}),t.add(new bn($a(_u(e)),t.lit))),i.length&&t.add(new bn($a(_u(i)),new eo({vertexColors:!0}))),t}function dw({role:n,shape:t}){const e=_u(t),i=Ks(n),s=new bn($a(e),new eo({color:i,transparent:!0,opacity:.16,depthWrite:!1}));return s.add(new Nm($a(e.map(r=>new Om(r,40))),new Fo({color:i,transparent:!0,opacity:.75}))),s}function vu(n,t){const e=Oi(64);return Array.from({length:e+1},(i,s)=>{const r=s/e*2*Math.PI;return new B(n,t*Math.cos(r),t*Math.sin(r))})}function Hd(n,t,e){return Array.from({length:e},(i,s)=>{const r=s/e*2*Math.PI;return n.map((o,a)=>new B(o,t[a]*Math.cos(r),t[a]*Math.sin(r)))})}function xu(n,t){const[e,i]=[[],[]];for(const r of n){let o=0;for(let a=1;a<r.length;a+=1)e.push(r[a-1],r[a]),i.push(o,o+=r[a].distanceTo(r[a-1]))}const s=new cn().setFromPoints(e);return s.setAttribute("lineDistance",new ze(i,1)),new Nm(s,t)}const ah=(n,t)=>new eo({color:Ks(n),transparent:!0,opacity:t,side:Di,forceSinglePass:!0,depthWrite:!1}),Mu=(n,t)=>new Fo({color:Ks(n),transparent:!0,opacity:t});function pw(n){const{stations_m:t,radii_m:e}=n,i=new Fi;if(n.skin){const a=new bn(new sh(t.map((l,c)=>new ce(e[c],l)),Oi(48)),ah(n.role,.05));a.rotation.z=-Math.PI/2,i.add(a)}const s=[...Hd(t,e,n.meridians),...n.rings.map(([a,l])=>vu(a,l))],r=[...Hd(t,e,n.faint_meridians),...n.faint_rings.map(([a,l])=>vu(a,l))];n.axis&&r.push([t[0],t[t.length-1]].map(a=>new B(a,0,0)));const o=()=>new km({color:Ks(n.role),dashSize:.35,gapSize:.22,transparent:!0,opacity:.85});return s.length&&i.add(xu(s,n.dashed?o():Mu(n.role,.8))),r.length&&i.add(xu(r,Mu(n.role,.38))),i.quaternion.copy(Hm("x",n.along)),i.position.set(...n.origin_m),i}function mw({role:n,radius_m:t}){const e=new Fi,i=([r,o,a])=>[new B(r,o,a),new B(o,r,a),new B(a,o,r)],s=vu(0,t).map(r=>i(r.toArray()));return e.add(new bn(new cl(t,Oi(32),Oi(20)),ah(n,.1)),xu([0,1,2].map(r=>s.map(o=>o[r])),Mu(n,.7))),e}const gw=n=>n.kind==="sphere"?mw(n):pw(n);function _w(){const n=[];let t=7;const e=()=>(t=t*16807%2147483647,t/2147483647);for(let s=0;s<Oi(1400);s+=1){const r=2*e()-1,o=2*Math.PI*e(),a=Math.sqrt(1-r*r);n.push(900*a*Math.cos(o),900*r,900*a*Math.sin(o))}const i=new cn;return i.setAttribute("position",new ze(n,3)),new nw(i,new Fm({color:9413562,size:1.3,sizeAttenuation:!1,transparent:!0,opacity:.7}))}function vw({direction:n,half_angle_rad:t,colour:e}){const i=new B(...n).normalize(),s=Math.PI/2-t,r=new cl(500*Math.sin(t),Oi(96),Oi(16),0,2*Math.PI,0,1.05*s);r.applyQuaternion(new ns().setFromUnitVectors(zm.y,i.clone().negate()));const o=r.attributes.position,a=new le().setStyle(e,Js),l=[],c=new B;for(let h=0;h<o.count;h+=1){c.fromBufferAttribute(o,h).normalize();const f=Math.sin(23*c.x+5*Math.sin(17*c.z))*Math.sin(19*c.z+4*Math.sin(13*c.x)),g=Math.max(.15,c.x*-.35+c.y*.75+c.z*.35)*(.124+.024*f);l.push(g*a.r,g*a.g,g*a.b)}r.setAttribute("color",new ze(l,3));const u=new bn(r,new eo({vertexColors:!0}));return u.position.copy(i).multiplyScalar(500),u}function xw(n){const t=new Fi;n.stars&&t.add(_w());for(const e of n.sky)t.add(vw(e));return t}class Mw{constructor(t,e=24,i=10){this.stations=e,this.sides=i,this.places=new Float32Array(e*i*3);const s=[];for(let o=0;o<e-1;o+=1)for(let a=0;a<i;a+=1){const l=o*i+a,c=o*i+(a+1)%i;s.push(l,c,l+i,c,c+i,l+i)}const r=new cn;r.setAttribute("position",new zn(this.places,3)),r.setIndex(s),this.mesh=new bn(r,ah(t,.22)),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set({rows:t,at:e,n:i}){if(this.mesh.visible=i>1,!!this.mesh.visible){for(let s=0;s<this.stations;s+=1){const r=s/(this.stations-1)*(i-1),o=Math.min(Math.floor(r),i-2),a=r-o,l=u=>t[o][e+u]+(t[o+1][e+u]-t[o][e+u])*a,c=l(3);for(let u=0;u<this.sides;u+=1){const h=u/this.sides*2*Math.PI,f=(s*this.sides+u)*3;this.places[f]=l(0),this.places[f+1]=l(1)+c*Math.cos(h),this.places[f+2]=l(2)+c*Math.sin(h)}}this.mesh.geometry.attributes.position.needsUpdate=!0}}}class Sw{constructor(t,e,i){this.most=e,this.places=new Float32Array(e*3);const s=new cn;s.setAttribute("position",new zn(this.places,3));const r=i?new km({color:Ks(t),dashSize:.25,gapSize:.2}):new Fo({color:Ks(t)});this.dashed=i,this.line=new Um(s,r),this.line.frustumCulled=!1,this.line.visible=!1}set({rows:t,at:e,n:i}){const s=i>0?t[i-1]:null;if(t===this.rows&&i===this.count&&s===this.last)return;Object.assign(this,{rows:t,count:i,last:s});const r=Math.max(1,Math.ceil(i/this.most));let o=0;for(let a=0;a<i&&o<this.most;a+=r,o+=1){const l=t[a];this.places[o*3]=l[e],this.places[o*3+1]=l[e+1],this.places[o*3+2]=l[e+2]}this.line.geometry.setDrawRange(0,o),this.line.geometry.attributes.position.needsUpdate=!0,this.dashed&&this.line.computeLineDistances(),this.line.visible=o>1}}const yw=.5,Ew=25,bw=[5,4],fc=new WeakMap,[dc,Pr,Lr]=[new Ne,new We,new We];function ww(n){return fc.has(n)||fc.set(n,new Om(n,Ew)),fc.get(n)}class Vd{constructor(t){Object.assign(this,{canvas:t,pen:t.getContext("2d",{willReadFrequently:!0}),ratio:1,cut:!1,colour:"#000"}),this.at={left:0,top:0,width:0,height:0}}setPixelRatio(t){this.ratio=t}setSize(t,e){this.size={width:t,height:e},this.canvas.width=Math.max(1,Math.round(t*this.ratio)),this.canvas.height=Math.max(1,Math.round(e*this.ratio))}setScissorTest(t){this.cut=t}setScissor(){}setViewport(t,e,i,s){this.at={left:t,top:this.size.height-e-s,width:i,height:s}}setClearColor(t){this.colour=`#${t.toString(16).padStart(6,"0")}`}clear(){const{left:t,top:e,width:i,height:s}=this.cut?this.at:{left:0,top:0,...this.size};this.pen.setTransform(this.ratio,0,0,this.ratio,0,0),this.pen.fillStyle=this.colour,this.pen.fillRect(t,e,i,s)}clearDepth(){}dispose(){}render(t,e){const{pen:i,at:s}=this;t.updateMatrixWorld(),e.updateMatrixWorld(),i.save(),i.beginPath(),i.rect(s.left,s.top,s.width,s.height),i.clip();const r=new Ne().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);t.traverseVisible(o=>{o.layers.test(e.layers)&&(o.isLine?this.lines(o,o.geometry,o.isLineSegments?2:1,r,`#${o.material.color.getHexString()}`):o.isMesh&&o.material.opacity>yw&&this.lines(o,ww(o.geometry),2,r,Xt.plain))}),i.restore()}lines({matrixWorld:t,material:e},i,s,r,o){const{pen:a}=this,{position:l}=i.attributes,c=Math.min(l.count,i.drawRange.count);dc.multiplyMatrices(r,t),a.strokeStyle=o,a.globalAlpha=e.transparent?e.opacity:1,a.lineWidth=1,a.setLineDash(e.isLineDashedMaterial?bw:[]),a.beginPath();for(let u=0;u+1<c;u+=s)Pr.fromBufferAttribute(l,u).setW(1).applyMatrix4(dc),Lr.fromBufferAttribute(l,u+1).setW(1).applyMatrix4(dc),Tw()&&(a.moveTo(...this.place(Pr)),a.lineTo(...this.place(Lr)));a.stroke(),a.globalAlpha=1}place(t){const{left:e,top:i,width:s,height:r}=this.at;return[e+(t.x/t.w+1)/2*s,i+(1-t.y/t.w)/2*r]}pixels(){return this.pen.getImageData(0,0,this.canvas.width,this.canvas.height).data}}function Tw(){const[n,t]=[Pr.z+Pr.w,Lr.z+Lr.w];return n<=0&&t<=0?!1:(n<=0?Pr.lerp(Lr,(1e-6-n)/(t-n)):t<=0&&Lr.lerp(Pr,(1e-6-t)/(n-t)),!0)}const Ea=1,Aw=22e5,[Rw,Cw,Gd]=[60,38,.35],pc=Ya?.5:1,Pw=1e3,Wd=24,Lw=64,[Dw,Iw]=[860723,3159354],ba=n=>new B(...Yr[n]);class Uw{constructor(t,e,i,s){this.elements={view:e,camera:i,labels:s},this.canvas=t;const r={antialias:!Ya,alpha:!1,powerPreference:"high-performance",preserveDrawingBuffer:!0},o=t.getContext("webgl2",r);this.webgl=o!==null,this.webgl?(this.renderer=new ew({canvas:t,context:o,...r}),this.renderer.autoClear=!1,t.addEventListener("webglcontextlost",()=>this.outline())):this.renderer=new Vd(t),this.scene=new Ld,this.scene.add(new sw(14674431,2763306,.9));const a=new aw(16777215,2.3);a.position.set(-6,9,5),this.scene.add(a),this.far=new Ld,this.perspective=new Yn(32,1,.1,2e3),this.ortho=new nh(-1,1,1,-1,-100,200),this.onboard=new Yn(20,1,.02,2e3);for(const c of[this.perspective,this.ortho])c.layers.enable(Ea);Object.assign(this,{display:null,world:null,items:new Map,bodies:[],eyes:[],chosen:0}),Object.assign(this,{enabled:!0,drawn:0,quality:pc,adaptive:!0,pace:33,since:0}),this.marks=new Map,this.follow(e),this.resize();const l=new ResizeObserver(()=>this.resize());for(const c of[e,i])l.observe(c);addEventListener("resize",()=>this.resize())}outline(){const t=this.canvas.cloneNode(!1);this.canvas.replaceWith(t),this.renderer.dispose(),Object.assign(this,{canvas:t,webgl:!1,renderer:new Vd(t)}),this.resize()}adapt(t){if(!this.adaptive)return;this.pace=this.pace*.8+Math.min(t,400)*.2,this.since+=1;const e=this.pace>Rw&&this.quality>Gd,i=this.pace<Cw&&this.quality<pc;this.since<(i?150:6)||!(e||i)||(this.quality=Math.max(Gd,Math.min(pc,this.quality*(e?.7:1.25))),this.since=0,this.resize())}setDisplay(t){for(const e of[this.world,...this.far.children])Fw(e);this.far.clear(),this.far.add(xw(t)),this.world=new Fi,this.scene.add(this.world),this.items.clear(),this.bodies=t.bodies.map(e=>this.add(e,hw(e),!Array.isArray(e.place))),this.moving=this.bodies.filter(({moves:e})=>e);for(const e of t.surfaces){const i=this.add(e,gw(e),e.kind==="sphere"&&!Array.isArray(e.place));i.moves?this.moving.push(i):e.kind==="sphere"&&i.object.position.set(...e.place)}this.lines=t.lines.map(e=>this.addLine(e)),this.eyes=t.views.map(e=>({azimuth:e.azimuth_rad,height:e.height_rad,zoom:1,focus:e.kind==="perspective"?new B(...$d(e,null)):null})),(this.display===null||this.chosen>=t.views.length)&&(this.chosen=0),this.display=t,this.cameraTan=void 0,this.frame=null,this.shot=[]}add(t,e,i){const s={item:t,object:e,moves:i};return i?(e.visible=!1,e.traverse(r=>r.layers.set(Ea))):t.kind==="body"&&e.position.set(...t.place),this.items.set(t.name,e),this.world.add(e),s}addLine(t){const e=Array.isArray(t.points),i=e?t.points.length:t.kind==="line"?Lw:t.since?Wd+3:Pw,s=new Sw(t.role,i,t.dashed);e?s.set({rows:t.points,at:0,n:i}):s.line.layers.set(Ea),this.items.set(t.name,s.line),this.world.add(s.line);const r=t.spread?new Mw(t.role):null;return r&&(r.mesh.layers.set(Ea),this.world.add(r.mesh)),{line:t,path:s,tube:r,stands:e}}place(t,e,i,s){this.frame=t;for(const{item:r,object:o}of this.moving){const a=Si(t,r.place,r.axes);o.visible=!!a,a&&o.position.set(...a);const l=a&&r.attitude?ci(t,r.attitude):void 0;l&&o.inner.quaternion.set(...l),r.role==="measured"&&o.inner?.lit&&o.inner.lit.emissive.setHex(s?Iw:Dw)}for(const{line:r,path:o,tube:a,stands:l}of this.lines)if(!l)if(r.kind==="line"){const c=ci(t,r.points)||[];o.set({rows:c,at:0,n:c.length})}else{const c=pg(r,e?.trails.get(r.name)||[],t,i,Wd);o.set(c),a?.set(c)}}known(t){for(const e of t){const{item:i}=this.bodies.find(r=>r.item.name===e),s=Si(this.frame,i.place,i.axes);if(s)return{item:i,at:s,turn:i.attitude?ci(this.frame,i.attitude):void 0}}return null}resize(){const t=[this.elements.view,this.elements.camera].map(u=>u.getBoundingClientRect()),e=t.filter(u=>u.width>0),i=Math.min(...e.map(u=>u.left)),s=Math.min(...e.map(u=>u.top)),r=Math.max(...e.map(u=>u.right))-i,o=Math.max(...e.map(u=>u.bottom))-s,a=u=>({left:u.left-i,bottom:s+o-u.bottom,width:u.width,height:u.height});this.places={view:a(t[0]),camera:a(t[1])};const{canvas:l}=this;Object.assign(l.style,{left:`${i+scrollX}px`,top:`${s+scrollY}px`,width:`${r}px`,height:`${o}px`});const c=Math.min(devicePixelRatio||1,Math.sqrt(Aw/Math.max(r*o,1)));this.renderer.setPixelRatio(c*this.quality),this.renderer.setSize(r,o,!1),this.renderer.setScissorTest(!1),this.renderer.setClearColor(527378,1),this.renderer.clear(),this.renderer.setScissorTest(!0),this.shot=[],this.tall=parseFloat(getComputedStyle(this.elements.labels).fontSize)}follow(t){let e=null;t.addEventListener("pointerdown",i=>{i.target.closest("button")||(e=[i.clientX,i.clientY],t.setPointerCapture(i.pointerId))}),t.addEventListener("pointermove",i=>{e&&(this.turn((i.clientX-e[0])*.005,(i.clientY-e[1])*.005),e=[i.clientX,i.clientY])}),t.addEventListener("pointerup",()=>{e=null}),t.addEventListener("wheel",i=>{i.preventDefault(),this.zoom(Math.exp(i.deltaY*.001))},{passive:!1})}turn(t,e){const i=this.eyes[this.chosen];i?.focus&&(i.azimuth+=t,i.height=Math.max(-1.4,Math.min(1.4,i.height+e)))}zoom(t){const e=this.eyes[this.chosen];e&&(e.zoom=Math.max(.15,Math.min(4,e.zoom*t)))}draw(){if(!this.enabled||!this.display)return;this.drawn+=1;const{view:t,camera:e}=this.places,i=this.display.views[this.chosen],s=i.kind==="flat";if(s)for(const{object:c}of this.bodies)c.scale.setComponent("xyz".indexOf(i.up[1]),1/i.stretch);const r=s?this.flat(i,t):this.orbit(i,t);if(this.lens=r,this.into(t,r,!s),this.label(r,t,s?i:null),s)for(const{object:c}of this.bodies)c.scale.set(1,1,1);if(!this.display.camera||e.height<=20)return;const{at:o,turn:a}=Nw(this.display.camera,this.known(this.display.camera.carried_by)),l=[...o,...a];l.some((c,u)=>c!==this.shot[u])&&(this.shot=l,this.aim(this.display.camera,o,a,e),this.into(e,this.onboard,!0))}orbit(t,e){const i=this.perspective,s=e.width/Math.max(e.height,1),r=this.eyes[this.chosen],{focus:o}=r;o.lerp(new B(...$d(t,this.known(t.follow)?.at)),.08);const a=o.distanceTo(new B(...t.centre_m)),l=r.zoom*(t.distance_m+t.growth*a)*Math.max(1,1.45/s),c=Math.cos(r.height);return i.position.set(o.x+l*c*Math.cos(r.azimuth),o.y+l*Math.sin(r.height),o.z+l*c*Math.sin(r.azimuth)),i.lookAt(o),i.aspect=s,i.updateProjectionMatrix(),i}flat(t,e){const i=this.ortho,s=t.span_m/2*this.eyes[this.chosen].zoom,r=s/(e.width/Math.max(e.height,1))/t.stretch;Object.assign(i,{left:-s,right:s,top:r,bottom:-r});const o=new B(...t.centre_m);return i.up.copy(ba(t.up)),i.position.copy(ba(t.right)).cross(i.up).multiplyScalar(50).add(o),i.lookAt(o),i.updateProjectionMatrix(),i}aim(t,e,i,s){const r=this.onboard,o=new ns(...i);r.up.copy(ba(t.up).applyQuaternion(o)),r.position.set(...e),r.lookAt(r.position.clone().add(ba(t.look).applyQuaternion(o)));const a=Math.max(Ii(t.look,t.aim_m)-Ii(t.look,e),.4);this.cameraTan=jv(t,a,this.cameraTan),r.fov=2*Math.atan(this.cameraTan)*180/Math.PI,r.aspect=s.width/Math.max(s.height,1),r.updateProjectionMatrix(),r.updateMatrixWorld()}into(t,e,i){if(this.renderer.setViewport(t.left,t.bottom,t.width,t.height),this.renderer.setScissor(t.left,t.bottom,t.width,t.height),this.renderer.setClearColor(329740,1),this.renderer.clear(!0,!0),i){const s=e.position.clone();e.position.set(0,0,0),e.updateMatrixWorld(),this.renderer.render(this.far,e),e.position.copy(s),e.updateMatrixWorld(),this.renderer.clearDepth()}this.renderer.render(this.scene,e)}label(t,e,i){const s=i?i.up:"+y",r=i?i.stretch:1,o=new Map;for(const{text:l,at_m:c}of this.display.labels)o.set(l,{text:l,at:c,drop:1});for(const{item:l,object:c}of this.bodies){const u=l.label?Si(this.frame,l.place,l.axes):void 0;if(!u)continue;const h=u.map((f,d)=>f+Yr[s][d]*c.reach[d]/r);o.set(`body ${l.name}`,{text:l.label,at:h,role:l.role})}for(const[l,c]of this.marks)o.has(l)||(c.remove(),this.marks.delete(l));t.updateMatrixWorld();const a=[];for(const[l,{text:c,at:u,role:h,drop:f}]of o){let d=this.marks.get(l);d||(d=document.createElement("span"),d.textContent=c,h&&(d.className="body",d.style.color=Ks(h)),this.elements.labels.append(d),this.marks.set(l,d));const g=new B(u[0],u[1],u[2]).project(t),v=Math.abs(g.x)<.98&&Math.abs(g.y)<.96&&g.z<1;d.style.display=v?"":"none";const m=Math.round((g.x+1)/2*e.width);let p=Math.round((1-g.y)/2*e.height)+(f?14:0);if(h){const y=([T,x])=>Math.abs(T-m)<5*this.tall&&Math.abs(x-p)<this.tall;for(;a.some(y);)p-=2;a.push([m,p])}d.style.left=`${m}px`,d.style.top=`${p}px`}}onView(t){if(!this.lens)return null;const e=new B(...t).project(this.lens);return e.z>1?null:[(e.x+1)/2*this.places.view.width,(1-e.y)/2*this.places.view.height]}onCamera(t){const e=new B(...t).project(this.onboard);return e.z>1?null:[e.x,e.y]}covers(t){const e=this.items.get(t),i=e.visible,s=[i,!1].map(o=>{if(e.visible=o,this.draw(),!this.webgl)return this.renderer.pixels();const a=this.renderer.getContext(),l=new Uint8Array(a.drawingBufferWidth*a.drawingBufferHeight*4);return a.readPixels(0,0,a.drawingBufferWidth,a.drawingBufferHeight,a.RGBA,a.UNSIGNED_BYTE,l),l});e.visible=i;let r=0;for(let o=0;o<s[0].length;o+=4)(s[0][o]!==s[1][o]||s[0][o+1]!==s[1][o+1])&&(r+=1);return r}}function Nw(n,t){if(!t)return{at:n.start_m,turn:[0,0,0,1]};const e=n.turns&&t.turn||[0,0,0,1],i=new B(...n.at_m).applyQuaternion(new ns(...e));return{at:[t.at[0]+i.x,t.at[1]+i.y,t.at[2]+i.z],turn:e}}function Fw(n){n?.traverse(t=>{t.geometry?.dispose(),t.material?.dispose()}),n?.removeFromParent()}function $d(n,t){if(!n.follow.length)return n.centre_m;const e=t?Ii(n.along,t)-Ii(n.along,n.centre_m):n.start_m,i=n.share*Math.sign(n.start_m)*Math.max(n.least_m,e*Math.sign(n.start_m));return n.centre_m.map((s,r)=>s+i*Yr[n.along][r])}function Ow(n){return n.kind==="flat"&&n.stretch!==1?Me(J.exaggerated,{axis:n.up[1],n:n.stretch}):""}const Cn=n=>document.getElementById(n),kw=250;class Bw{constructor(t,e){Object.assign(this,{scene:t,choose:e}),this.instruments=new Gg,this.commands=new qg,this.charts=new qv,this.digits=new tx,this.chartsAt=0,this.text=""}setDisplay(t){const e=JSON.stringify(t);if(e===this.text){this.scene.place(null,null,0,!1);return}this.text=e,this.display=t,this.instruments.setDisplay(t),this.commands.setDisplay(t),this.charts.setDisplay(t),this.digits.setDisplay(t.camera),Wg(t.section),Ig(t.attitude),Og(t.lamps);for(const i of["trip","ladder-panel"])Cn(i).hidden=!t.link;Cn("clock-rx").parentElement.hidden=!t.link,Cn("camera").hidden=!t.camera,Cn("clock-pred").parentElement.hidden=!t.predicted,t.camera&&(Cn("camera").setAttribute("aria-label",t.camera.title),Cn("camera-tag").textContent=t.camera.title),o_(t,this.choose),Cn("legend").replaceChildren(...t.legend.map(({role:i,words:s,dashed:r})=>{const o=document.createElement("span");return o.className=r?"dash":"",o.style.color=Xt[i],o.textContent=s,o})),this.scene.setDisplay(t),Cn("views").replaceChildren(...t.views.map((i,s)=>{const r=document.createElement("button");return r.textContent=i.label,r.dataset.view=i.label.toLowerCase(),r.onclick=()=>this.setView(s),r})),Cn("views").hidden=t.views.length<2,this.setView(this.scene.chosen)}setView(t){this.scene.chosen=t,[...Cn("views").children].forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),Cn("scale").textContent=Ow(this.display.views[t])}nextView(){this.display&&this.setView((this.scene.chosen+1)%this.display.views.length)}clocks(t,e,i,s,r){const o=Mi(t,this.display.measured),a=Mi(t,this.display.predicted);El("gen",o?.t,i,r),El("rx",o?.received,s,r),El("pred",a?.t,a?Me(J.ahead,{s:Re(a.t-e,1)}):"",r)}show({run:t,frame:e,rungs:i,history:s,now:r,stale:o,until:a}){const{display:l}=this,c=Mi(e,l.measured);this.instruments.show(e,o),l.section&&$g(l.section,e),l.attitude&&Ug(l.attitude,e),l.lamps&&kg(l.lamps,e),this.commands.show(e),this.digits.show(e,o),l.link&&this.showLink(t,e,c,i,r),this.scene.place(e,s,r,o),performance.now()-this.chartsAt>kw&&(this.chartsAt=performance.now(),this.charts.show(s.charts,e,a))}showLink(t,e,i,s,r){Yg(Cn("dial"),t,e.round_trip,i?.transit),Kg(e,i,t.step_s),y_(Cn("ladder"),t,this.display.commands.axes,s,r),$e(Cn("ladder-counts"),b_(s))}showReticle(t){!this.display?.camera||!t||(jg(Cn("reticle"),this.scene,this.display.camera,t,this.digits.height),this.digits.field(this.scene.cameraTan))}}const Xe=n=>document.getElementById(n),zw=4;class Hw{constructor(t,e,i){Object.assign(this,{link:t,panels:e,back:i,on:!1,run:null,at:0,playing:!1}),Xe("review-close").onclick=()=>this.leave(),Xe("review-play").onclick=()=>this.play(!this.playing),Xe("review-time").oninput=()=>this.go(Number(Xe("review-time").value)),addEventListener("keydown",s=>{this.on&&s.key==="Escape"&&!Xe("dialog").open&&this.leave()})}async list(){try{const t=await this.link.get("api/runs");d_(t,(e,i)=>this.open(e,i))}catch(t){Tu(J.review_title,t.message)}}async open(t,e){e.textContent=J.review_loading;try{this.run=await this.link.get(`api/runs/${t.split("/").map(encodeURIComponent).join("/")}`)}catch(i){e.textContent=i.message;return}wu(),this.start()}start(){const{run:t}=this;this.on=!0,this.history=new tp(t.display,1/0);for(const e of t.frames)this.history.add(e);this.rungs=t.ladder.map(dp),Xe("scrubber").hidden=!1,Xe("bottom").hidden=!0,Xe("review-time").max=String(t.frames.length-1),this.panels.setDisplay(t.display),t.display.camera&&(Xe("camera-tag").textContent=t.display.camera.review_title),Xe("run-name").textContent=`${J.review}: ${t.name}`,this.marks(),this.go(t.frames.length-1),Xe("review-time").focus()}leave(){this.on=!1,this.playing=!1,Xe("scrubber").hidden=!0,Xe("bottom").hidden=!1,Xe("camera-tag").textContent=this.run.display.camera?.title||"",this.back()}play(t){this.playing=t,Xe("review-play").textContent=t?J.stop_play:J.play,t&&this.at>=this.run.frames.length-1&&this.go(0),this.playedAt=performance.now(),this.playedFrom=this.run.frames[this.at].t}go(t){this.at=Math.max(0,Math.min(this.run.frames.length-1,t)),Xe("review-time").value=String(this.at);const e=this.run.frames[this.at].t,i=this.run.events.filter(r=>r.t<=e),s=i[i.length-1];Xe("review-now").textContent=`${Re(e,1)} s${s&&e-s.t<5?` · ${s.text}`:""}`,Xe("review-time").setAttribute("aria-valuetext",Xe("review-now").textContent),this.playing&&(this.playedAt=performance.now(),this.playedFrom=e)}advance(){if(!this.playing)return;const t=this.playedFrom+zw*(performance.now()-this.playedAt)/1e3;let e=this.at;for(;e<this.run.frames.length-1&&this.run.frames[e].t<t;)e+=1;if(e!==this.at){const[i,s]=[this.playedAt,this.playedFrom];this.go(e),Object.assign(this,{playedAt:i,playedFrom:s})}e>=this.run.frames.length-1&&this.play(!1)}marks(){const t=Xe("review-time").getBoundingClientRect(),e=Xe("review-marks"),i=this.run.frames[this.run.frames.length-1].t||1;e.style.left=`${Xe("review-time").offsetLeft}px`,e.style.width=`${t.width}px`,e.innerHTML="";for(const s of this.run.events){const r=document.createElement("i");r.style.left=`${s.t/i*100}%`,r.title=`${Re(s.t,1)} s ${s.node}: ${s.text}`,e.append(r)}}frame(){return this.run.frames[this.at]}show(){this.advance();const{run:t}=this,e=this.frame(),i=Mi(e,t.display.measured);this.banner(),lp(t.display,e,e.mode,!1),this.panels.clocks(e,e.t,i?Me(J.age,{s:Re(e.t-i.t,1)}):"","",!1),this.panels.show({run:t,frame:e,history:this.history,now:e.t,stale:!1,until:e.t,rungs:this.rungs.filter(s=>s.sent<=e.k).map(s=>x_(s,e.k))})}banner(){const t=Xe("banner"),e=this.at===this.run.frames.length-1&&this.run.verdict,i=e?Do(this.run.verdict.words):"";t.dataset.said!==i&&(t.dataset.said=i,t.textContent=i),t.classList.toggle("alarm",!!e&&!this.run.verdict.success)}}const Vw=6e3;class Gw{constructor(){this.status={phase:"idle",lease:"free",pages:0,note:""},this.can={fly:!1,desk:!1},this.connected=!1,this.display=null,this.asked="",this.reset(null)}reset(t){this.run=t,this.frame=null,this.frameAt=0,this.verdict=null,this.ladder=new Map,this.events=[],this.abortAt=null,t&&(this.display=t.display,this.history=new tp(t.display,Vw),this.history.begin(t.trails),this.rungs(t.ladder||[]))}take(t){switch(t.type){case"hello":this.can=t.can,this.asked=t.mode||"",t.display&&!this.display&&(this.display=t.display);break;case"run":this.reset(t);break;case"status":this.status=t;break;case"frame":this.takeFrame(t);break;case"ladder":this.rungs(t.ladder);break;case"verdict":this.verdict=t;break;case"event":this.events.push(t);break}!t.type&&t.link&&(this.connected=t.link==="open",t.why&&(this.why=t.why))}takeFrame(t){if(this.frame=t,this.frameAt=performance.now(),this.rungs(t.ladder),this.history.add(t),this.sent?.parts.kind===Dr&&this.abortAt===null){const e=[...this.ladder.values()].find(i=>i.kind===Dr);this.abortAt=(e?.sent??t.k)*this.run.step_s}}get measured(){return Mi(this.frame,this.display?.measured)}get predicted(){return Mi(this.frame,this.display?.predicted)}get sent(){return this.frame?.signals[this.display.commands.sent]}rungs(t){for(const e of t)this.ladder.set(e[0],dp(e));for(;this.ladder.size>700;)this.ladder.delete(this.ladder.keys().next().value)}now(){if(!this.frame)return 0;if(this.frame.paused||this.verdict||this.status.phase!=="flying")return this.frame.t;const t=(performance.now()-this.frameAt)/1e3*this.run.pace;return this.frame.t+Math.min(t,this.run.step_s)}silence(){return!this.frame||this.verdict||this.frame.paused||this.status.phase!=="flying"?0:(performance.now()-this.frameAt)/1e3}}const ue=n=>document.getElementById(n),Ww=1e3/30,[$w,Xw]=[60,120],Xa=1,Su=2e3;for(const n of document.querySelectorAll("[data-s]"))n.textContent=J[n.dataset.s];for(const n of document.querySelectorAll("[data-a]"))n.setAttribute("aria-label",J[n.dataset.a]);const Vt=new Gw,li=new Uw(ue("gl"),ue("view"),ue("camera"),ue("labels")),tr=new Bw(li,n=>lh(n));li.enabled=!new URLSearchParams(location.search).has("plain");let Na=-1/0,mc=0,Xd=0,qd=null,Yd=null;const En=new I_((n,t)=>{Vm.heard(n),Zn?.stick(n,t)}),yu=new __(Zn),ul=new P_(Zn,Vt),Kn=new Hw(Zn,tr,()=>Gm()),Eu=new t_(Vt);w_(li);const Vm=new m_(Vt,li,En);function qw(n){if(n.type==="desk"){yu.show(n,Vt.status.lease==="you");return}const{phase:t,lease:e}=Vt.status;Vt.take(n),(n.type==="run"||n.type==="hello")&&!Kn.on&&Gm(),n.type==="status"&&(n.phase==="starting"&&t!=="starting"&&wu(),n.phase==="refused"&&t!=="refused"&&n.lease==="you"&&qa(n.note),n.phase==="ended"&&t==="closing"&&f_()&&Kn.list(),n.lease==="you"&&e!=="you"&&En.taken(),bu(),yu.lease(n.lease==="you")),n.type==="verdict"&&Vt.frame&&Yd!==n&&!Kn.on&&!Vt.can.desk&&(Yd=n,h_(n,Vt.can.fly&&Vt.status.lease==="you",()=>qa())),n.type==="event"&&(ue("event").textContent=`${Re(n.t,1)} s · ${Yw(n)}`),n.type==="reply"&&!n.ok&&(ue("event").textContent=n.code?Au(n.code):n.text),n.type||bu()}function Yw({code:n,text:t}){return Vt.run?.operator==="console"&&J.stick_events[n]||t}function Gm(){const{display:n}=Vt;if(n){if(tr.setDisplay(n),En.setController(n.controller),yu.task={hint:n.hint,goal:n.goal,display:n},!Vt.run){ue("run-name").textContent="";return}ue("run-name").textContent=n.link?`${Vt.run.name} · ${Vt.run.forward_s} s + ${Vt.run.back_s} s`:Vt.run.name,ue("run-name").title=ue("run-name").textContent}}async function Wm(){await Zn.ask({do:Vt.status.lease==="you"?"drop":"take"})}function lh(n){Vt.frame&&ul.steer({do:"mode",mode:n})}function $m(){Vt.frame&&ul.steer({do:Vt.frame.paused?"resume":"pause"})}function Xm(){const n=performance.now();n-Na<Su?(Na=-1/0,ul.abort()):Na=n,Kd(),setTimeout(Kd,Su+50)}function Kd(){const n=performance.now()-Na<Su;ue("abort").classList.toggle("armed",n),ue("abort").querySelector("small").textContent=n?J.abort_armed:J.abort_hint}function qa(n=""){Vt.status.lease!=="you"&&Zn.ask({do:"take"}),u_(Vt,t=>Zn.ask(t),n)}function Kw(){const n=ap(Vt.display).map(t=>t.name);n.length&&lh(n[(n.indexOf(Vt.frame?.mode)+1)%n.length])}const jd={KeyT:Wm,KeyP:$m,KeyX:Xm,KeyN:()=>qa(),KeyV:()=>tr.nextView(),KeyL:()=>Kn.list(),KeyG:()=>gp(En,Vt.display),Slash:()=>up(Vt.display),KeyM:Kw,KeyK:()=>Eu.acknowledge(),KeyO:()=>Eu.toggleSound(),Equal:()=>li.zoom(.85),Minus:()=>li.zoom(1.18),BracketLeft:()=>li.turn(.15,0),BracketRight:()=>li.turn(-.15,0)};addEventListener("keydown",n=>{if(n.repeat||n.ctrlKey||n.metaKey||n.altKey||mp(n.target)||ue("dialog").open&&!["KeyX","KeyK","KeyO"].includes(n.code))return;const t=r_(Vt.display,n.code);jd[n.code]&&Zn?jd[n.code]():t&&Zn&&!Kn.on&&lh(t.name)});ue("lease").onclick=Wm;ue("pause").onclick=$m;ue("abort").onclick=Xm;ue("restart").onclick=()=>qa();ue("open-review").onclick=()=>Kn.list();ue("open-settings").onclick=()=>gp(En,Vt.display);ue("open-help").onclick=()=>up(Vt.display);function bu(){const{status:n}=Vt,t=n.lease==="you";ue("lease").textContent=t?J.drop:n.lease==="other"?J.taken:J.take,ue("lease").disabled=n.lease==="other",ue("lease").classList.toggle("primary",n.lease==="free"),ue("pages").textContent=n.pages===1?J.pages_one:Me(J.pages,{n:n.pages}),ue("socket-state").textContent=Vt.connected?`● ${J.socket_open}`:`○ ${J.socket_closed}`,ue("socket-state").className=Vt.connected?"ok":"alarm";for(const e of["pause","restart"])ue(e).disabled=!t}function Pn(n,t,e){const i=ue("banner"),s=n?`${re(n)}${t?`<small>${re(t)}</small>`:""}`:"";i.dataset.said!==s&&(i.dataset.said=s,i.innerHTML=s),i.classList.toggle("alarm",!!e)}function jw(n){const{status:t,frame:e,run:i,verdict:s}=Vt,r=ul.words();if(r)Pn(...r,!0);else if(!Vt.connected&&Zn)Pn(J.socket_closed,"",!0);else if(t.phase==="idle")Pn(J.idle,J.idle_text);else if(t.phase==="starting"||t.phase==="flying"&&!e)Pn(J.starting,t.progress||t.run||"");else if(t.phase==="refused")Pn(J.run_refused,t.note,!0);else if(t.note?.startsWith("failed"))Pn(J.run_failed,t.note.slice(7),!0);else if(n>Xa)Pn(Me(J.stale_frames,{s:n.toFixed(0)}),"",!0);else if(Vt.abortAt!==null&&!s&&e){const o=!Vt.display.link||[...Vt.ladder.values()].some(M_),a=Vt.display.abort,l=e.t-Vt.abortAt,c=l>i.forward_s+i.back_s+2*i.step_s+Xa;o?Pn(a?Me(J.aborted_so,{does:a}):J.aborted,"",!0):c?Pn(J.abort_untold,Me(J.abort_untold_hint,{s:l.toFixed(0)}),!0):Pn(Me(J.abort_sent,{s:Math.max(0,i.forward_s-l).toFixed(0)}),"",!0)}else t.pilot_lost?Pn(J.pilot_lost,"",!0):e?.paused?Pn(J.paused,""):e&&!Vt.measured&&t.phase==="flying"?Pn(J.no_telemetry,Me(J.first_in,{s:Math.max(0,i.back_s-e.t).toFixed(0)})):s?Pn(Do(s.words),"",!s.success):Pn("")}function Zw(){const n=Vt.status.lease==="you",t=En.state().held,e=En.stuck(),i=n?En.axes.length?En.gone()?J.stick_gone:e.length?Me(J.stick_stuck,{axes:e.join(", ")}):t?`${J.stick_held} · ${J[En.source]}`:J.stick_open:J.stick_none:J.stick_watch;$e(ue("stick-state"),i),ue("stick-state").className=n?t&&!e.length?"ok":"alarm":"dim";const s=Vt.display?.controller?.step_name;$e(ue("step"),n&&En.source==="keyboard"&&En.deflections.length>1?`${s} ${En.step}`:"")}function Jw(){const n=[li.webgl?"":J.no_webgl,Zd?"":J.no_storage,En.axes.length?J.pad_notes[En.lacks()]:""];$e(ue("notes"),n.filter(Boolean).join(" · ")),ue("notes").title=ue("notes").textContent}function Qw(n,t){const{run:e,measured:i}=Vt,s=i?t-i.t:null,r=s!==null&&s>e.back_s+Xa*Math.max(e.pace,1);return tr.clocks(n,t,s===null?"":Me(J.age,{s:Re(s,1)}),i?Me(J.ago,{s:Re(Math.max(t-i.received,0),1)}):"",r),r}function tT(){const{frame:n,run:t,history:e}=Vt,i=Vt.silence();if(jw(i),Zw(),Jw(),$e(ue("pause"),n?.paused?J.resume:J.pause),lp(Vt.display,n,n?.mode||t?.mode,Vt.status.lease==="you"),!t||!n)return;const s=Vt.now(),r=Qw(n,s)||i>Xa||!Vt.connected;document.body.classList.toggle("stale",r),tr.show({run:t,frame:n,history:e,rungs:[...Vt.ladder.values()],now:s,stale:r})}function qm(n){if(requestAnimationFrame(qm),n-mc<Ww-2)return;li.adapt(n-mc),mc=n;const t=n-Xd>(Vt.frame===qd&&!Kn.on?Xw:$w);t&&(Xd=n,qd=Vt.frame,Kn.on?Kn.show():tT()),li.draw(),t&&Vm.show(Kn.on),t&&tr.showReticle(Kn.on?Kn.frame():Vt.frame)}bu();Zn?Zn.listen(qw):Tu(J.no_token_title,J.no_page_token);requestAnimationFrame(qm);window.rvd={store:Vt,scene:li,stick:En,review:Kn,link:Zn,panels:tr,alarms:Eu};
