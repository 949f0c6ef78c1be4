import{r as b_,a as E_,b as tm,l as ui}from"./index.js";const lo={"+x":[1,0,0],"-x":[-1,0,0],"+y":[0,1,0],"-y":[0,-1,0],"+z":[0,0,1],"-z":[0,0,-1]};function Bn(n,t){const e=n?.signals[t];return e?.ok?e:void 0}function Zn(n,t){return t?Bn(n,t.signal)?.parts[t.part]??void 0:void 0}const Kc=(n,t)=>Array.isArray(n)?n[t]:n;function Rn(n,{signal:t,part:e,index:i,factor:s,past:r}){const o=Bn(n,t)?.parts[e];if(o==null)return;const a=i.map(c=>Kc(o,c));if(a.some(c=>c==null))return;const l=r!=null&&Kc(o,r)>0?-1:1;return s*(a.length===1?a[0]:l*Math.hypot(...a))}function Bi(n,t){return t!==null&&typeof t=="object"?Rn(n,t):t??void 0}function oh(n,t="xyz"){if(n==null)return;const e=[0,0,0];for(let i=0;i<t.length;i+=1){const s=Kc(n,i);if(s==null)return;e["xyz".indexOf(t[i])]=s}return e}function yi(n,t,e){return Array.isArray(t)?t:oh(Zn(n,t),e)}function Ii(n,t){const e=lo[n];return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}class ah{constructor(t,e){this.display=t,this.keep=e,this.trails=new Map;for(const i of t?.lines||[])i.kind==="trail"&&this.trails.set(i.name,[]);this.charts=(t?.charts?.strips||[]).map(i=>({t:[],curves:i.curves.map(()=>[]),spread:[]}))}begin(t){for(const e of this.display.lines)for(const i of t?.[e.name]||[]){const s=oh(i.slice(2,-1),e.axes);s&&this.trails.get(e.name).push([i[0],i[1],...s,i[i.length-1]??0])}}add(t){for(const e of this.display.lines)e.kind==="trail"&&this.extend(e,t);this.display.charts?.strips.forEach((e,i)=>this.plot(e,this.charts[i],t))}extend(t,e){const i=this.trails.get(t.name),s=yi(e,t.place,t.axes);if(!s||i.length&&e.t<=i[i.length-1][0])return;const r=t.spread?Rn(e,t.spread)??0:0;i.push([e.t,e.signals[t.place.signal].t,...s,r]),i.length>this.keep&&i.shift()}plot(t,e,i){const s=[...t.curves,t.spread].filter(Boolean).map(a=>a.signal),r=Bn(i,s.find(a=>a!=="truth")??"truth");if(!r||r.t<=(e.t[e.t.length-1]??-1/0))return;e.t.push(r.t),t.curves.forEach((a,l)=>e.curves[l].push(Rn(i,a)??null));const o=t.spread?Rn(i,t.spread):void 0;e.spread.push(o===void 0?null:o*t.spread_factor)}}function T_(n,t,e,i,s){let r=t.length;for(;r>0&&t[r-1][0]>i;)r-=1;if(!n.since)return{rows:t,at:2,n:r};const o=Bn(e,n.since.signal),a=yi(e,n.place,n.axes),l=yi(e,n.since,n.axes);if(!o||!a||!l)return{rows:[],at:0,n:0};const c=n.spread?Rn(e,n.spread)??0:0,u=[[...l,n.since_spread?Rn(e,n.since_spread)??0:0]],h=Zn(e,n.anew);if(h)for(const d of h)u.push([...oh(d,n.axes),c]);else{const d=Bn(e,n.place.signal).t;for(;r>0&&t[r-1][1]>d;)r-=1;let f=r;for(;f>0&&t[f-1][1]>o.t;)f-=1;const g=Math.max(1,Math.floor((r-f)/s));for(let v=f;v<r;v+=g)u.push(t[v].slice(2))}return u.push([...a,c]),{rows:u,at:0,n:u.length}}const A_=2,R_=.6,md=1;function C_(n,{role:t,value:e,low:i,high:s}){const r=Rn(n,e),[o,a]=[Bi(n,i),Bi(n,s)];if(r===void 0)return;const l=[];return o!==void 0&&l.push({role:t,value:r,limit:o,over:o-r,sense:"<"}),a!==void 0&&l.push({role:t,value:r,limit:a,over:r-a,sense:">"}),l.sort((c,u)=>u.over-c.over)[0]}function P_(n,t){return t.readings.map(e=>C_(n,e)).filter(Boolean).sort((e,i)=>i.over-e.over)[0]}function L_(n,t,e){return t.map(i=>{const s=P_(n,i),r=e(i.words),o=s?s.over>=0||r&&s.over>-i.back:r;return{words:i.words,level:i.level,on:o,seen:s&&{...s,label:i.label,unit:i.unit,digits:i.digits}}})}function D_({run:n,frame:t,measured:e,flies:i,silence:s,connected:r,pilotLost:o},a){const l=Math.max(n.pace,1),c=md+n.step_s/n.pace,u=r?s:Math.max(s,c),h=Math.max(t.t,e?.received??0)+u*n.pace-(e?e.t:0),d=u>=c||h>n.back_s+2*n.step_s+md*l,f=n.operator==="console"&&i?.unheld;return[{words:a.telemetry,level:"warning",on:d,age:h},{words:a.pilot,level:"warning",on:!!o,flies:i},{words:a.nobody,level:"caution",on:!!(f&&!o),flies:i,after:R_}]}class I_{constructor(){this.standing=new Map,this.pending=new Map}stands(t){return this.standing.has(t)}clear(){this.standing.clear(),this.pending.clear()}judge(t,e){for(const r of t){const o=this.standing.get(r.words);r.on?this.pending.has(r.words)||this.pending.set(r.words,e):this.pending.delete(r.words),r.on&&(o||e-this.pending.get(r.words)>=(r.after||0))?this.standing.set(r.words,{acknowledged:!1,...o,...r,last:e}):o&&e-o.last>=A_?this.standing.delete(r.words):o&&Object.assign(o,{seen:r.seen??o.seen,age:r.age,flies:r.flies})}const i=new Map(t.map(({words:r},o)=>[r,o]));for(const r of this.standing.keys())i.has(r)||this.standing.delete(r);const s=r=>[r.acknowledged?1:0,r.level==="warning"?0:1,i.get(r.words)];return this.shown=[...this.standing.values()].sort((r,o)=>{const[a,l]=[s(r),s(o)];return a[0]-l[0]||a[1]-l[1]||a[2]-l[2]}),this.shown}acknowledge(){for(const t of this.standing.values())t.acknowledged=!0}get loud(){const t=[...this.standing.values()].filter(e=>!e.acknowledged);return t.some(e=>e.level==="warning")?"warning":t.length?"caution":""}}const Wt={measured:"#7cc4ff",predicted:"#ffb652",truth:"#f2f5f8",target:"#dbe5ee",plain:"#dbe5ee",pilot:"#7cc4ff",automatic:"#d59bf6",sent:"#56d6b0",limit:"#8aa4bd",guide:"#b9c2a0",goal:"#56d6b0",ok:"#56d6b0",alarm:"#ff7a5c",dim:"#8fa1b3",line:"#263544",text:"#dbe5ee"},Ml=!new URLSearchParams(location.search).has("fine")&&/swiftshader|llvmpipe|softpipe|software|basic render/i.test(U_());function U_(){const n=document.createElement("canvas").getContext("webgl2");if(!n)return"software";const t=n.getExtension("WEBGL_debug_renderer_info"),e=String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),e}function Oe(n,t){n.textContent!==t&&(n.textContent=t)}const Zc=new Map;let Ya=12;const N_=new ResizeObserver(n=>n.forEach(({target:t})=>em(t)));function em(n){const{width:t,height:e}=n.getBoundingClientRect();Zc.set(n,{w:t,h:e}),Ya=parseFloat(getComputedStyle(document.documentElement).fontSize)}const yl=n=>Math.max(11,.74*n);let ja=()=>Math.min(devicePixelRatio||1,2);function F_(n,t){const e=ja;ja=()=>n;try{t()}finally{ja=e}}function Ts(n){Zc.has(n)||(em(n),N_.observe(n));const{w:t,h:e}=Zc.get(n),i=ja(),s=Math.max(1,Math.round(t*i)),r=Math.max(1,Math.round(e*i));(n.width!==s||n.height!==r)&&Object.assign(n,{width:s,height:r});const o=n.getContext("2d",{willReadFrequently:Ml});return o.setTransform(i,0,0,i,0,0),o.clearRect(0,0,t,e),o.font=`${yl(Ya)}px system-ui, sans-serif`,o.lineWidth=Ya/12,{pen:o,w:t,h:e,rem:Ya}}function Zr(n,t,e,i,s,r){n.strokeStyle=s,n.setLineDash(r||[]),n.beginPath(),n.arc(t,e,Math.max(i,0),0,7),n.stroke(),n.setLineDash([])}function Ne(n,t,e,i,s,r="left",o="middle"){n.fillStyle=s,n.textAlign=r,n.textBaseline=o,n.fillText(t,e,i)}const[Vr,As,ws,nr,Io]=[0,1,2,3,4],[O_,Uo,ol,No,nm,gd]=[7,8,9,10,11,12],Jl={[Vr]:"nobody flies",[As]:"the pilot flies",[ws]:"the automatic controller flies",[nr]:"the pilot and the automatic controller fly together",[Io]:"the guard on board flies"},k_="who flies is not known",Qi=["","nothing was due","wrong length","wrong checksum","out of order","too old","out of range","an input was missing","as the mode says","no valid stick","no valid automatic command","neither a valid stick nor a valid automatic command","ABORT is in force"],_d={manual:[Vr,As],shared:[Vr,As,ws,nr],auto:[Vr,ws]},vd={[`${As} ${Uo}`]:["the pilot flies alone",Qi[Uo]],[`${ws} ${Uo}`]:["the automatic controller flies alone",Qi[Uo]],[`${ws} ${ol}`]:["the automatic controller flies alone",Qi[ol]],[`${ws} ${No}`]:["a neutral command flies",Qi[No]],[`${nr} ${No}`]:["the pilot flies, blended with a neutral command",Qi[No]],[`shared ${As} 0`]:["the pilot flies","the automatic controller let the command pass"],[`shared ${ws} 0`]:["the automatic controller flies","it changed what the pilot commanded"]},B_={[ol]:[As,nr],[nm]:[As,ws,nr]},z_="the reason that is told does not fit";function H_(n,t,e){if(!(t in Jl)||!(e in Qi))return{who:k_,why:"",pilot:!1,alarm:!0};if(e===gd)return t===Io?{who:Jl[Io],why:Qi[gd],pilot:!1,alarm:!0}:{who:"nobody flies from the ground",why:"every command says ABORT",pilot:!1,alarm:!0};const[i,s]=vd[`${n} ${t} ${e}`]??vd[`${t} ${e}`]??[Jl[t],Qi[e]],r=n in _d&&t!==Io&&(!_d[n].includes(t)||n==="shared"&&e===Uo&&t!==Vr),o=B_[e]?.includes(t);return{who:i,why:o?z_:r?"decided before the mode was changed":s,pilot:t===As||t===nr,unheld:e===ol||e===nm,alarm:t===Vr||t===Io||e===O_||e===No||o===!0}}const lh=({who:n,why:t})=>t?`${n}: ${t}`:n;function ch(n,t){const e=t&&n?.link?t.signals[n.commands.sent]:null;if(!e||e.parts.by===null)return null;const i=n.modes.some(({name:s})=>s===t.mode)?t.mode:"";return H_(i,e.parts.by,e.parts.reason)}const G_=n=>Qi[n]??"";function Go(n,t){return t&&!t.pilot?`${n}: ${t.who}`:n}function V_(n,[t,e],i,[s,r],o,a,l,c){const u=Math.hypot(s-t,r-e),[h,d]=[(s-t)/u,(r-e)/u],[f,g]=[t+h*i,e+d*i],[v,m]=[f-h*a*.9,g-d*a*.9];if(n.fillStyle=o,n.beginPath(),n.moveTo(f,g),n.lineTo(v-d*a*.5,m+h*a*.5),n.lineTo(v+d*a*.5,m-h*a*.5),n.closePath(),n.fill(),!l)return;const p=[v-h*a*1.6,m-d*a*.9];for(;c.some(([y,E])=>Math.abs(y-p[0])<3*a&&Math.abs(E-p[1])<a);)p[1]+=a;c.push(p),Ne(n,l,...p,o,"center")}const W_={review_bar:"Review",review_event_back:"«",review_step_back:"‹",review_step_on:"›",review_event_on:"»",review_event_back_alt:"to the event before",review_step_back_alt:"one picture back",review_step_on_alt:"one picture on",review_event_on_alt:"to the next event",review_speed:"Speed of the review",review_times:"{n} ×",review_events:"Events of the run",review_events_some:"Events ({n})",review_events_none:"No events",review_report:"Report",review_png:"PNG",review_csv:"CSV",review_webm:"WebM",review_webm_stop:"Stop the video",review_report_hint:"Open the report of this run in a tab of its own",review_png_hint:"Save what is shown now as a picture",review_csv_hint:"Save the numbers of all instants as a table",review_webm_hint:"Play on from here, to the end or until it is stopped, and save it as a video",review_no_tab:"The browser did not allow a new tab.",review_webm_none:"This browser records no WebM video",review_failed:"not saved: {why}",review_of:"Review: {name}",review_flown:"{mode} at the start",review_seed:"seed {n}",runs_loading:"Reading the list…",runs_columns:["ended","run","scenario","mode","operator","seed","time","verdict"],runs_flying:"under way",runs_closing:"its bag is being closed…",runs_no_report:"This run has no report: ./rvd report makes one.",runs_report:"Report of {name}",runs_open:"Review {name}"},$_=[["","In a review:"],["Space","play, stop"],["← →","one picture back, on"],["Shift ← →","to the event before, to the next one"],["↑ ↓","faster, slower"],["Home End","to the beginning, to the end"],["Esc","leave the review"]],X_=["t [s]","step","mode"],q_="no picture was recorded",N={...W_,title:"RVD console",clocks:"Three clocks",clock_generated:"generated on board",clock_received:"received on the ground",clock_predicted:"predicted for",modes:"Who decides",mode_turn:"{modes} in turn",mode_ground:"ground",mode_board:"on board",pause:"Pause",resume:"Resume",abort:"ABORT",abort_hint:"X twice",abort_armed:"again: ABORT",instruments:"Instruments",columns:{measured:"measured",predicted:"predicted",truth:"truth",plain:""},limit:"limit",weight:"pilot weight",scene:"Scene",views:"Views",camera_side:"Camera, delay and charts",ladder:"Command ladder",ladder_alt:"Commands on their way to the craft and back",ladder_ground:"ground",ladder_link:"on the link",ladder_craft:"at the craft",ladder_back:"telemetry on its way back",ladder_known:"known",ladder_untold:"this craft acknowledges none",ladder_narrow:["ground","link","craft","back","known"],round_trip:"Round trip",dial_alt:"Dial of the round trip",restart:"New run",review:"Review",settings:"Stick",help:"Help",stop:"Stop run",review_close:"Leave review",play:"Play",stop_play:"Stop",scrub:"Instant of the review",review_title:"Review a run",review_none:"No finished runs here yet: a run is listed once its bag is closed.",review_loading:"Reading the bag…",review_open:"Open",take:"Take the stick",drop:"Release the stick",taken:"Another page has the stick",stick_yours:"You have the stick",stick_held:"stick live",stick_open:"DEAD-MAN OPEN",stick_away:"NO FOCUS",stick_unheard:"STICK NOT HEARD",stick_released:"STICK RELEASED while “{what}” is open",stick_back:"Close it to fly on.",watch_only:"Watching only",abort_watch:"not from here",live_head:"LIVE FLIGHT · {t} s · {mode}",live_back:"Back to the flight",review_in_flight:"A flight is under way. It stays in view beside the review, and ABORT works.",stick_watch:"watching",stick_none:"you are in charge",keyboard:"keyboard",gamepad:"gamepad",stick_events:{STICK_LOST:"nobody holds the stick, or the dead-man is open",STICK:"the stick counts"},pages_one:"1 page",pages:"{n} pages",of:"of",socket_closed:"NOT CONNECTED",idle:"Ready",idle_text:"Take the stick (T), then start a run (N).",starting:"The graph is coming up…",paused:"PAUSED",stale:"STALE",no_telemetry:"no telemetry yet",first_in:"first telemetry in {s} s",pilot_lost:"PILOT LOST",stale_frames:"NO DATA FOR {s} s",aborted:"ABORTED",aborted_so:"ABORTED: {does}",stop_run:"End the flight",stop_hint:"ends the run under way; its folder is kept whole",abort_sent:"ABORT sent, acting in about {s} s",abort_asked:"ABORT: waiting for the answer",abort_unconfirmed:"ABORT NOT CONFIRMED",abort_again:"no answer; asked {n} times, asking again",abort_accepted:"ABORT accepted, goes out with the next frame",abort_untold:"ABORT sent, NOT ACKNOWLEDGED",abort_untold_hint:"sent {s} s ago; telemetry has not told whether it is in force",unconfirmed:"{name} NOT CONFIRMED",unconfirmed_hint:"The run did not answer in 2 s. Try again.",no_webgl:"No WebGL: the scene is drawn in lines",no_storage:"Storage is blocked: settings are not remembered",stick_gone:"GAMEPAD GONE",stick_stuck:"NOT AT REST: {axes} counts as 0 until it has been centred",run_failed:"The run could not be flown: see the terminal",run_refused:"No run with these settings",verdict_title:"Verdict",verdict_time:"time",fly_again:"Fly again (N)",close:"Close",cancel:"Cancel",start:"Start",seed:"seed",mode:"mode",seed_hint:"empty: the next one",new_run:"New run",new_run_text:"A new run in a new folder. A run under way is stopped.",no_fly:"This console belongs to one run; start it with ./rvd fly --operator console to fly again.",no_page_token:"This page needs the token of the address that the console printed.",no_token_title:"No token",wrong_token:"WRONG TOKEN",wrong_token_text:"This console was started anew, or never knew this page: open the address that it printed.",line:{opening:"○ connecting",open:"● connected",silent:"○ NOTHING HEARD",closed:"○ NOT CONNECTED",full:"○ NO ROOM",stranger:"○ WRONG TOKEN",none:"○ NO TOKEN"},connecting:"Connecting…",line_full:"NO ROOM: as many pages are open as this console takes",line_silent:"NO CONNECTION: nothing heard for {s} s",line_lost:"NOT CONNECTED: no server for {s} s",line_old:"All that is shown is so old.",line_again_old:"All that is shown is at least so old. The page comes back by itself.",line_again:"The page comes back by itself.",before:"{s} s ago",exaggerated:"{axis} scale × {n}",link:{transit:"transit",p99:"p99",lost:"lost",late:"late",corrupted:"damaged",gap:"last gap"},age:"age {s} s",ago:"{s} s ago",ahead:"in {s} s",now:"now",settings_title:"The stick",settings_dead_zone:"dead zone",settings_axis:"axis",settings_pair:"buttons {plus} / {minus}, or",settings_invert:"inverted",settings_button:"dead-man button",settings_space:"keyboard: hold Space as dead-man",settings_none:"No gamepad seen. Press a button on it.",settings_pads:"Gamepads",settings_now:"now",pad_notes:{"":"",choose:"Several gamepads: choose one under Stick (G)",setup:"The gamepad must be set up under Stick (G) before it flies"},pad_plain:"no standard mapping",pad_live:"axes {axes} · pressed {buttons}",pad_nothing:"none",pad_choose:"Several gamepads are connected: choose one.",pad_setup:"This gamepad has no standard mapping: its axes and buttons may be anything. It does not fly before each axis and the dead-man button have been set.",pad_ready:"This gamepad is set up.",pad_start:"Set it up step by step",pad_next:"Next",pad_skip:"No such axis",pad_stop:"Stop",pad_rest:"Let go of all its sticks, triggers and buttons, then go on.",pad_move:"Push the stick all the way for {what} ({name}).",pad_back:"Let it go.",pad_trigger:"Axis {axis} does not rest at 0, as a trigger does not: take another.",pad_hold:"Press the button that is to be held while flying.",dialog:"a dialog",help_title:"Keys",help_step:"{name} of the keys",or:"or",review_truth:"Review shows the truth. It never reaches this page while a run is flown.",unknown:"–",alarms:"Alarms",acknowledge:"Acknowledge (K)",digits:"Position and rates of the craft",field:"field {deg}°",field_was:"(was {deg}°)",desk:{door:"Which volunteer? Enter the number you were given; no name is asked or kept.",volunteer:"volunteer number",begin:"Begin",heading:"{who}, flight {n} of {of}",training:"Training: this flight does not count.",counts:"This flight counts.",condition:"Control: {mode}",clock:"The clock starts when the graph is up.",fly:"Start the flight",rest_title:"A break",rest:"Rest your eyes and hands.",go_on:"Go on",done_title:"Finished",done:"Thank you, {who}. All flights are flown and rated.",next:"Next volunteer",session:"Session: {title}",is_training:"training",is_counted:"counts",open:"Session",idle:"Take the stick (T) to go on with the session.",broken:"This flight does not count: {why}.",flown_again:"It is flown again, with the same start.",unset:"not set",back:"Back",change:"Change",chosen:"What contributed more to the workload, in each pair:",save_pairs:"Save",yes:"Yes",no:"No",again:"Answer again",pick:"Pick the sentence that fits best.",save:"Save the ratings",weigh:"Which of the two contributed more to the workload of flying in this way?",pair:"pair {n} of {of}",tree:{controllable:"Was the craft controllable?",adequate:"Was adequate performance ({goal}) attainable with a tolerable pilot workload?",satisfactory:"Was it satisfactory without improvement?"},ratings:["","Excellent, highly desirable: compensation not a factor","Good, negligible deficiencies: compensation not a factor","Fair, some mildly unpleasant deficiencies: minimal compensation","Minor but annoying deficiencies: moderate compensation","Moderately objectionable deficiencies: considerable compensation","Very objectionable but tolerable deficiencies: extensive compensation","Major deficiencies: adequate performance not attainable with maximum tolerable compensation","Major deficiencies: considerable compensation needed for control","Major deficiencies: intense compensation needed to retain control","Major deficiencies: control lost during some part of the flight"],tlx:{mental:["Mental demand","How mentally demanding was the flight?","very low","very high"],physical:["Physical demand","How physically demanding was the flight?","very low","very high"],temporal:["Temporal demand","How hurried or rushed was the pace?","very low","very high"],performance:["Performance","How successful were you in doing what you were asked to do?","perfect","failure"],effort:["Effort","How hard did you have to work for your level of performance?","very low","very high"],frustration:["Frustration","How insecure, discouraged, irritated, stressed and annoyed were you?","very low","very high"]},errors:{VOLUNTEER:"A whole number from 1 to 999, please.",STAGE:"Not now.",RATING:"The rating is incomplete.",TLX:"Please set every scale.",WEIGHTS:"Please choose in every pair.",CLOSING:"One moment: the recording of the last flight is being closed."}}},Y_=[["T","take or release the stick"],["Space","dead-man, if so chosen under Stick"],["P","pause, resume"],["X X","ABORT, past every buffer{abort}"],["K","acknowledge the alarms: they fall silent until the next one"],["O","sound of the alarms on, off"],["N","new run"],["V","next view"],["+ − [ ]","zoom and turn the scene"],["L","review a run"],["G","stick settings"],["?","this list"],["Esc","close"],["","A key that is released commands zero. Without focus, without this page, with the dead-man open, or while a dialog or a review is open, there is no pilot: the mode says who flies then, in shared the automatic controller, in manual nobody, and the page says what was decided."]],Fo={none:"no alarm",sound_on:"Sound on (O)",sound_off:"Sound off (O)",beyond:"{said}{label} {value}, limit {limit}",telemetry:"TELEMETRY LOST",pilot:"PILOT LOST",nobody:"NOBODY HOLDS THE STICK"},im={good:"A good approach",keys:"Keys"},j_={ArrowUp:"↑",ArrowDown:"↓",ArrowLeft:"←",ArrowRight:"→"},K_=["sent","due","executed","effect seen","refused","missed","unknown"],Z_={LEASE:"Take the stick first (T).",TAKEN:"Another page has the stick.",NO_RUN:"No run is under way.",WATCH:"This page watches only. To fly, open the first address that the console printed.",NO_FLY:N.no_fly,NO_ANSWER:"The run did not answer.",DESK:"The session says what is flown.",SESSION_MODE:"The session says in which mode this flight is flown.",SESSION_PAUSE:"A flight of a session is not paused.",SESSION_STOP:"A flight of a session is flown to its end. Only ABORT ends it before, and it does not count then.",NO_DESK:"This console leads no session.",JSON:"The console did not understand the page: reload it.",REQUEST:"The console did not understand the page: reload it.",ID:"The console did not understand the page: reload it.",LENGTH:"A stick sample was damaged and left out.",KIND:"A stick sample was damaged and left out.",RANGE:"A stick sample was out of range and left out.",MODE:"No such mode.",SETTINGS:"Too many settings, or one that is too long.",SEED:"The seed must be a whole number."};function Yt(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}const Ui=n=>document.getElementById(n),xd=.75*Math.PI;function J_(n){Ui("attitude").hidden=!n,n&&(Ui("attitude-title").textContent=n.title,Ui("ball").setAttribute("aria-label",n.alt))}const Md=(n,t)=>{const e=Math.max(0,...t.filter(i=>i!==void 0).map(Math.abs));return n.find(i=>e<=i)??n[n.length-1]},ua=(n,t)=>Math.max(-1,Math.min(1,n/t)),yd=(n,t)=>n>0?`+${_e(n,t)}`:_e(n,t);function Sd(n,t){const{pen:e,w:i,h:s,rem:r}=Ts(Ui("ball")),o=Math.min(i*.6,s)/2-.95*r,[a,l]=[o+1.1*r,s/2],c=v=>v?.map(m=>Rn(t,m)),u=n.needles[0],[h,d]=[c(u.angles),c(u.rates)],f=Md(n.scales,h),g=d?Md(n.rate_scales,d):1;e.fillStyle="#0a1420",e.beginPath(),e.arc(a,l,o,0,7),e.fill(),Zr(e,a,l,o,Wt.dim),e.strokeStyle=Wt.line,e.beginPath(),e.moveTo(a-o,l),e.lineTo(a+o,l),e.moveTo(a,l-o),e.lineTo(a,l+o);for(const v of[-.5,.5])e.moveTo(a+v*o,l-r*.25),e.lineTo(a+v*o,l+r*.25),e.moveTo(a-r*.25,l+v*o),e.lineTo(a+r*.25,l+v*o);for(const v of[-1,-.5,0,.5,1]){const m=v*xd-Math.PI/2;e.moveTo(a+o*Math.cos(m),l+o*Math.sin(m)),e.lineTo(a+(o-r*.4)*Math.cos(m),l+(o-r*.4)*Math.sin(m))}e.stroke(),n.limit!==null&&n.limit<=f&&Zr(e,a,l,n.limit/f*o,Wt.limit,[r*.3,r*.25]);for(const v of[...n.needles].reverse()){const[m,p,y]=c(v.angles);if(m===void 0)continue;const E=Wt[v.role];e.strokeStyle=E,e.fillStyle=E;const x=o-.15*r,[U,A]=[a+ua(y,f)*x,l-ua(p,f)*x],D=S=>Math.sqrt(Math.max(x*x-S*S,0))*.8;e.lineWidth=r*(v===u?.16:.08),e.beginPath(),e.moveTo(a-D(A-l),A),e.lineTo(a+D(A-l),A),e.moveTo(U,l-D(U-a)),e.lineTo(U,l+D(U-a)),e.stroke();const I=ua(m,f)*xd-Math.PI/2,T=(S,C)=>[a+S*Math.cos(C),l+S*Math.sin(C)];e.beginPath(),e.moveTo(...T(o,I)),e.lineTo(...T(o-r*.8,I-.09)),e.lineTo(...T(o-r*.8,I+.09)),e.closePath(),v===u?e.fill():(e.lineWidth=r/12,e.stroke())}e.lineWidth=r/12,d&&d[0]!==void 0&&Q_(e,a,l,o,r,d.map(v=>ua(v,g)),Wt[u.role]),e.strokeStyle=Wt.text,e.beginPath(),e.moveTo(a-r*.9,l),e.lineTo(a-r*.3,l),e.moveTo(a+r*.3,l),e.lineTo(a+r*.9,l),e.stroke(),t0(e,n,{angles:h,rates:d,scale:f,rateScale:g,w:i,h:s,rem:r})}function Q_(n,t,e,i,s,[r,o,a],l){n.fillStyle=l;const c=(h,d,f,g)=>{n.beginPath(),n.moveTo(h,d),n.lineTo(h+f*s*.6-g*s*.3,d+g*s*.6+f*s*.3),n.lineTo(h+f*s*.6+g*s*.3,d+g*s*.6-f*s*.3),n.closePath(),n.fill()},u=i+s*.25;c(t+r*i,e-u,0,-1),c(t+u,e-o*i,1,0),c(t+a*i,e+u,0,1)}function t0(n,t,{angles:e,rates:i,scale:s,rateScale:r,w:o,h:a,rem:l}){const c=o-l*.2,u=o*.6+l*1.3;["roll","pitch","yaw"].forEach((d,f)=>{const g=a/2+(f-1.4)*l*2.3;Ne(n,d,u,g,Wt.dim),n.font=`600 ${.95*l}px system-ui, sans-serif`;const v=t.limit!==null&&Math.abs(e[f])>t.limit;Ne(n,`${v?"▲ ":""}${yd(e[f],t.digits)}`,c,g,Wt[t.needles[0].role],"right"),n.font=`${yl(l)}px system-ui, sans-serif`,i&&Ne(n,`${yd(i[f],t.digits+1)} /s`,c,g+l*.95,Wt.dim,"right")}),[`ring ±${s} ${t.unit}`,...i?[`edge ±${r} ${t.unit}/s`]:[]].forEach((d,f)=>Ne(n,d,c,a-l*(1.5-f),Wt.dim,"right"))}function e0(n){Ui("lamps").hidden=!n,n&&(Ui("lamps-title").textContent=n.title,Ui("lights").setAttribute("aria-label",n.alt),Ui("lights").style.height=`${2*n.groups.length}rem`)}function wd(n,t){const{pen:e,w:i,h:s,rem:r}=Ts(Ui("lights")),[o,a,l]=[n.on,n.glow,n.counts].map(g=>Zn(t,g));n.note&&al(Zn(t,n.note)??["",!1],Ui("lamps-note"),"dim");const c=Math.max(...n.groups.map(g=>g.labels.length+n0(g.labels)*.5)),[u,h]=[11.5*r,i-5.2*r],d=Math.min((h-u)/c,2.6*r);let f=0;n.groups.forEach((g,v)=>{const m=(v+.36)*(s/n.groups.length);Ne(e,g.name,0,m,Wt.text),Ne(e,g.words,1.8*r,m,Wt.dim);let p=u;g.labels.forEach((y,E)=>{const x=E===0||g.labels[E-1]!==y;x&&E>0&&(p+=d*.5);const U=Math.max(a?.[f]??0,o?.[f]?1:0);Zr(e,p,m,r*.42,o?.[f]?"#ffffff":"#3a4f63"),e.globalAlpha=U,e.fillStyle=Wt[n.role],e.beginPath(),e.arc(p,m,r*.4,0,7),e.fill(),e.globalAlpha=1;let A=E;for(;g.labels[A+1]===y;)A+=1;x&&Ne(e,y,p+(A-E)*d/2,m+r*.92,Wt.dim,"center"),p+=d,f+=1}),l&&Ne(e,`${l[v]} pulses`,i,m,Wt.text,"right")})}const n0=n=>n.filter((t,e)=>e>0&&n[e-1]!==t).length;function i0(n,{w:t,h:e,rem:i},s,r,o){const a=e/2/o,[l,c]=[t/2,e/2],u=s.half_view*a;n.strokeStyle=Wt.limit,n.strokeRect(l-u,c-u,2*u,2*u);const[h,d]=[Zn(r,s.points),Zn(r,s.used)];if(!h)return;const f=s.width_px;for(let g=0;2*g<h.length;g+=1){if(h[2*g]===null||h[2*g+1]===null)continue;const v=l+(h[2*g]/f-.5)*2*u,m=c+(h[2*g+1]/f-.5)*2*u;n.lineWidth=i/8,Zr(n,v,m,i*.38,d?.[g]?Wt.ok:Wt.dim),n.lineWidth=i/12,d?.[g]&&(n.fillStyle=Wt.ok,n.beginPath(),n.arc(v,m,i*.14,0,7),n.fill())}}const en=n=>document.getElementById(n),s0=4,r0=["measured","predicted","truth","plain"];function _e(n,t){if(n==null||!Number.isFinite(n))return N.unknown;const e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","−")}const ha=(n,t,e)=>typeof n=="number"?String(n).replace("-","−"):_e(t,e);function uh(n,{low:t,high:e},i){const[s,r]=[Bi(n,t),Bi(n,e)];return s===void 0&&r===void 0?"":r===void 0?`> ${ha(t,s,i)}`:s===void 0?`< ${ha(e,r,i)}`:`${ha(t,s,i)}…${ha(e,r,i)}`}class o0{setDisplay(t){const e=t.instruments;if(en("instruments").hidden=!e,this.rows=[],!e)return;en("instruments-title").textContent=e.title;const i=r0.filter(r=>e.rows.some(o=>o.readings.some(a=>a.role===r)));en("instruments").style.setProperty("--columns",i.length);const s=ri("div","head");s.append(...[["",""],...i.map(r=>[N.columns[r],r]),["",""],[N.limit,"dim"]].map(([r,o])=>ri("span",o,r))),en("instruments-rows").replaceChildren(s,...e.rows.map(r=>{const o=ri("div","row"),a=new Map(i.map(c=>[c,ri("b",c)])),l=ri("u");return o.append(ri("span","",r.label),...a.values(),ri("u","unit",r.unit),l),this.rows.push({row:r,cells:a,limit:l}),o}))}show(t,e){for(const{row:i,cells:s,limit:r}of this.rows){let o="";for(const a of i.readings){const l=Rn(t,a.value),c=s.get(a.role);Oe(c,_e(l,i.digits)),c.classList.toggle("stale-value",e&&a.role==="measured"),c.classList.toggle("bad",l<=Bi(t,a.low)||l>=Bi(t,a.high)),o=uh(t,a,i.digits)||o}Oe(r,o)}}}function ri(n,t="",e=""){const i=document.createElement(n);return t&&(i.className=t),i.textContent=e,i}function a0(n){en("cut").hidden=!n,n&&(en("section-title").textContent=n.title,en("section").setAttribute("aria-label",n.alt),en("foot").hidden=!n.foot,n.foot&&(en("foot-label").textContent=n.foot.label))}const sm={dot(n,t,e,i,s){n.fillStyle=i,n.beginPath(),n.arc(t,e,s*.3,0,7),n.fill()},ring(n,t,e,i,s,r){n.fillStyle=`${i}30`,n.beginPath(),n.arc(t,e,Math.max(s*.3,r),0,7),n.fill(),n.stroke()},cross(n,t,e,i,s){const r=s*.32;n.beginPath(),n.moveTo(t-r,e-r),n.lineTo(t+r,e+r),n.moveTo(t-r,e+r),n.lineTo(t+r,e-r),n.stroke()},square(n,t,e,i,s){n.strokeRect(t-s*.35,e-s*.35,s*.7,s*.7)}};function bd(n,t){const{pen:e,w:i,h:s,rem:r}=Ts(en("section")),[o,a]=[i/2,s/2],l=Math.min(i,s)/2-.9*r;e.strokeStyle=Wt.line,e.beginPath(),e.moveTo(o-l,a),e.lineTo(o+l,a),e.moveTo(o,a-l),e.lineTo(o,a+l),e.stroke(),al(n.note?Zn(t,n.note):["",!1],en("section-note"),"dim"),n.foot&&al(Zn(t,n.foot.words),en("foot-words"));const c=Bi(t,n.extent_m);if(!c)return;const u=l/c;for(const f of n.rings){const g=Bi(t,f.radius_m);g!==void 0&&(Zr(e,o,a,g*u,Wt[f.role],f.dashed?[r*.3,r*.25]:null),f.written&&Ne(e,`${g.toFixed(2)} m`,o+g*u*.72,a-g*u*.72-r*.3,Wt[f.role]))}Ne(e,n.names?.[1]??Ed(n.up),o+r*.3,a-l,Wt.dim),Ne(e,n.names?.[0]??Ed(n.right),o+l,a-r*.6,Wt.dim,"right");const h=[],d=f=>[o+Ii(n.right,f)*u,a-Ii(n.up,f)*u];for(const f of n.spots){const g=yi(t,f.place);if(!g)continue;const v=Wt[f.role],[m,p]=d(g);if(e.strokeStyle=v,Math.hypot(m-o,p-a)>l+.5*r){V_(e,[o,a],l,[m,p],v,r,f.mark==="cross"?"":`${(Math.hypot(m-o,p-a)/u).toFixed(1)} m`,h);continue}const y=f.origin&&yi(t,f.origin);y&&(e.setLineDash([r*.2,r*.2]),e.beginPath(),e.moveTo(...d(y)),e.lineTo(m,p),e.stroke(),e.setLineDash([])),sm[f.mark](e,m,p,v,r,f.spread?(Rn(t,f.spread)??0)*u:0);const E=f.rate&&yi(t,f.rate);if(E){const x=f.ahead_s*u;e.beginPath(),e.moveTo(m,p),e.lineTo(m+Ii(n.right,E)*x,p-Ii(n.up,E)*x),e.stroke()}}}const Ed=n=>n.replace("+","").replace("-","−");function al(n,t,e=""){const[i,s]=n||[N.unknown,!1];Oe(t,i),t.className=s?"alarm":e}function Jc(n,t){const e=_e(n,t);return Number(n.toFixed(t))>0?`+${e}`:e}function l0(n){const t=ri("div","bar");return t.append(document.createElement("i"),document.createElement("span")),t.firstChild.style.background=n,t}class c0{setDisplay(t){const{commands:e}=t;this.display=t,this.commands=e,en("commands-title").textContent=e.unit?`${e.title}, ${e.unit}`:e.title;const i=e.axes.map(o=>ri("span","dim",o.name)),s=e.rows.map(o=>ri("span",o.role==="automatic"?"auto":"",o.label));this.rows=e.rows.map(o=>({row:o,bars:e.axes.map(()=>l0(Wt[o.role]))}));const r=i.length<=s0?[[ri("span"),...i],...this.rows.map(({bars:o},a)=>[s[a],...o])]:[[ri("span"),...s],...i.map((o,a)=>[o,...this.rows.map(({bars:l})=>l[a])])];en("bars").style.setProperty("--columns",r[0].length-1),en("bars").replaceChildren(...r.flat())}show(t){const e=t.signals[this.commands.sent];for(const{row:r,bars:o}of this.rows){const l=(r.value.signal===this.commands.sent?e:Bn(t,r.value.signal))?.parts[r.value.part];this.commands.axes.forEach((c,u)=>this.bar(o[u],l?.[u]??null,c.highest))}const i=ch(this.display,t),s=i?[lh(i)]:[G_(e?.parts.reason)];i?.pilot&&e.parts.weight!==null&&e.parts.by===nr&&s.push(`${N.weight} ${e.parts.weight}`),Oe(en("why"),s.filter(Boolean).join(" · "))}bar(t,e,i){const s=Math.min(Math.abs(e||0)/i,1)*48;t.firstChild.style.left=`${e<0?50-s:50}%`,t.firstChild.style.width=`${s}%`,Oe(t.lastChild,e===null?N.unknown:Jc(e,this.commands.digits))}}function Ql(n,t,e,i){const s=en(`clock-${n}`);Oe(s,t===void 0?N.unknown:`${_e(t,1)} s`),Oe(en(`clock-${n}-age`),e),s.parentElement.classList.toggle("stale",!!i)}function u0(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=Ts(n),[l,c,u]=[r/2,o*.56,Math.min(r/2,o*.56)-a*.5],h=t.forward_s+t.back_s,d=Math.max(h*1.5,1),f=m=>Math.PI*(.8+1.4*Math.max(0,Math.min(1,m/d)));s.lineWidth=a*.45,s.strokeStyle="#1b2733",s.beginPath(),s.arc(l,c,u,f(0),f(d)),s.stroke(),e!==void 0&&(s.strokeStyle=e>h+1?Wt.alarm:Wt.measured,s.beginPath(),s.arc(l,c,u,f(0),f(e)),s.stroke()),i&&(s.lineWidth=a*.16,s.strokeStyle=Wt.guide,s.beginPath(),s.arc(l,c,u-a*.5,f(0),f(i)),s.stroke()),s.strokeStyle=Wt.text,s.lineWidth=a*.12;const g=f(h);s.beginPath(),s.moveTo(l+(u-a*.4)*Math.cos(g),c+(u-a*.4)*Math.sin(g)),s.lineTo(l+(u+a*.4)*Math.cos(g),c+(u+a*.4)*Math.sin(g)),s.stroke(),s.font=`600 ${1.35*a}px system-ui, sans-serif`,Ne(s,e===void 0?N.unknown:`${e.toFixed(1)} s`,l,c-a*.05,Wt.text,"center"),s.font=`${yl(a)}px system-ui, sans-serif`;const v=`${t.forward_s} + ${t.back_s} s`;s.measureText(v).width<1.55*u&&Ne(s,v,l,c+a*1.2,Wt.dim,"center")}function h0(n,t,e,i){const{link:s,gap:r}=n,o=[[N.link.transit,t?`${_e(t.transit,2)} s`:N.unknown]];s&&o.push([N.link.p99,`${_e(s.delay_p99,2)} s`],[N.link.lost,s.lost+s.outage],[N.link.late,s.late],[N.link.corrupted,s.corrupted]),o.push([N.link.gap,r?Yt(N.ago,{s:_e(Math.max(i-r.k*e,0),0)}):N.unknown]);const a=o.map(([l,c])=>`<dt>${l}</dt><dd>${c}</dd>`).join("");en("link-counts").innerHTML!==a&&(en("link-counts").innerHTML=a)}function d0(n,t,e,i,s){const{pen:r,w:o,h:a,rem:l}=Ts(n),[c,u]=[o/2,a/2];r.strokeStyle="#dbe5ee90",r.beginPath(),r.moveTo(c-o*.3,u),r.lineTo(c-l,u),r.moveTo(c+l,u),r.lineTo(c+o*.3,u),r.moveTo(c,u-a*.36),r.lineTo(c,u-l),r.moveTo(c,u+l),r.lineTo(c,u+a*.36);for(let g=-3;g<=3;g+=1)g&&(r.moveTo(c+g*o*.1,u-l*.25),r.lineTo(c+g*o*.1,u+l*.25));r.stroke();const h=t.known(e.carried_by);if(!h){Ne(r,N.no_telemetry,c,u+a*.36+l,Wt.dim,"center");return}const d=h.item.role==="truth";for(const g of e.marks){const v=yi(i,g.at),m=v&&!(d&&g.role==="predicted")&&t.onCamera(v);if(!m)continue;const p=Wt[g.role],[y,E]=[c+m[0]*o/2,u-m[1]*a/2];if(r.strokeStyle=p,g.radius_m===null){sm.square(r,y,E,p,l);continue}const x=Math.max(Ii(e.look,v)-Ii(e.look,h.at),.05);Zr(r,y,E,Math.min(g.radius_m/x/t.cameraTan*(a/2),a),p),r.strokeStyle=`${p}80`,r.beginPath(),r.moveTo(c,u),r.lineTo(y,E),r.stroke()}if(e.pixels&&i0(r,{w:o,h:a,rem:l},e.pixels,i,t.cameraTan),e.gauge&&f0(r,o,a-s,l,e.gauge,i,d),e.numbers)return;const f=e.distance.map(g=>Rn(i,g.value)).find(g=>g!==void 0);f!==void 0&&Ne(r,`${_e(f,e.digits)} ${e.unit}`,l*.6,a-l*.9,Wt.measured)}function f0(n,t,e,i,s,r,o){const[a,l,c]=[t-i*2.9,i*1.5,e-i*1.2],{low:u,high:h}=s,d=f=>c-(Math.max(u,Math.min(h,f))-u)/(h-u)*(c-l);n.strokeStyle="#dbe5eea0",n.beginPath(),n.moveTo(a,l),n.lineTo(a,c);for(let f=0;u+f*s.tick<=h+1e-9;f+=1){const g=d(u+f*s.tick),v=f%s.long_ticks===0;n.moveTo(a,g),n.lineTo(a+i*(v?.5:.25),g),v&&Ne(n,_e(u+f*s.tick,s.digits),a+i*.65,g,Wt.text)}n.stroke(),s.limit!==null&&(n.strokeStyle=Wt.alarm,n.beginPath(),n.moveTo(a-i*.5,d(s.limit)),n.lineTo(a+i*.5,d(s.limit)),n.stroke());for(const{role:f,value:g}of s.readings){const v=Rn(r,g);if(v===void 0||o&&f!=="truth")continue;const m=d(v),p=Wt[f==="truth"?"measured":f];n.beginPath(),n.moveTo(a-i*.1,m),n.lineTo(a-i*.75,m-i*.36),n.lineTo(a-i*.75,m+i*.36),n.closePath(),f==="predicted"?(n.strokeStyle=p,n.stroke()):(n.fillStyle=p,n.fill())}Ne(n,s.unit,a,l-i*.7,Wt.dim,"center")}const Td={warning:{every:900,notes:[[960,0],[720,.16]]},caution:{every:3e3,notes:[[520,0]]}},[tc,Ad]=[.13,.12];class p0{constructor(){Object.assign(this,{on:!1,context:null,level:"",at:-1/0,sung:0})}toggle(){if(this.on=!this.on,this.on&&!this.context){const t=window.AudioContext||window.webkitAudioContext;t&&(this.context=new t)}this.context?.resume(),this.at=-1/0}sing(t,e){if(t!==this.level&&(this.at=-1/0),this.level=t,!(!this.on||!t||!this.context||e-this.at<Td[t].every)){this.at=e,this.sung+=1;for(const[i,s]of Td[t].notes)this.note(i,s)}}note(t,e){const{context:i}=this,s=i.currentTime+e,[r,o]=[i.createOscillator(),i.createGain()];r.frequency.value=t,o.gain.setValueAtTime(0,s),o.gain.linearRampToValueAtTime(Ad,s+.015),o.gain.setValueAtTime(Ad,s+tc-.03),o.gain.linearRampToValueAtTime(0,s+tc),r.connect(o).connect(i.destination),r.start(s),r.stop(s+tc)}}const $i=n=>document.getElementById(n),m0=100;class g0{constructor(t){this.store=t,this.alarms=new I_,this.sound=new p0,this.run=null,$i("alarm-ack").onclick=()=>this.acknowledge(),$i("alarm-sound").onclick=()=>this.toggleSound(),this.look(),setInterval(()=>this.look(),m0)}acknowledge(){this.alarms.acknowledge(),this.look()}toggleSound(){this.sound.toggle(),this.look()}look(){const{store:t,alarms:e}=this,i=performance.now(),{run:s,frame:r,display:o,status:a}=t;if(s!==this.run&&e.clear(),this.run=s,!(s&&r&&!t.verdict&&a.phase==="flying"))e.clear();else if(!r.paused||!t.connected){const c={run:s,frame:r,measured:t.measured,silence:t.silence(),connected:t.connected,pilotLost:a.pilot_lost,flies:t.dead()?null:ch(o,r)};e.judge([...D_(c,Fo),...L_(r,o.alarms,u=>e.stands(u))],i/1e3)}this.show(),this.sound.sing(e.loud,i)}words(){const[t]=this.alarms.loud?this.alarms.shown:[];return t?[t.words,Rd(t)].filter(Boolean).join(": "):""}show(){const t=[...this.alarms.standing.values()].length?this.alarms.shown:[],[e,...i]=t;$i("alarms").className=e?e.acknowledged?"seen":e.level:"",Oe($i("alarm-words"),e?e.words:Fo.none),Oe($i("alarm-detail"),e?Rd(e):""),Oe($i("alarm-more"),i.map(s=>s.words).join(" · ")),$i("alarm-ack").disabled=!this.alarms.loud,Oe($i("alarm-sound"),this.sound.on?Fo.sound_on:Fo.sound_off),$i("alarm-sound").setAttribute("aria-pressed",String(this.sound.on))}}function Rd({seen:n,age:t,flies:e}){if(t!==void 0)return Yt(N.age,{s:_e(t,1)});if(e)return lh(e);if(!n?.label)return"";const i=n.unit?` ${n.unit}`:"",s=n.role==="plain"?"":`${N.columns[n.role]} `;return Yt(Fo.beyond,{said:s,label:n.label,value:`${_e(n.value,n.digits)}${i}`,limit:_e(n.limit,n.digits)})}function ce(n){const t=document.createElement("span");return t.textContent=n,t.innerHTML.replaceAll('"',"&quot;")}function Ke(n,t="",e=!1){const i=document.getElementById("banner"),s=n?`${ce(n)}${t?`<small>${ce(t)}</small>`:""}`:"";i.dataset.said!==s&&(i.dataset.said=s,i.innerHTML=s),i.classList.toggle("alarm",!!(n&&e))}function _0(n,t){const e=n.gates.findIndex(s=>t===void 0||s.at<t),i=n.gates.map((s,r)=>({at:`${_e(s.at,Number.isInteger(s.at)?0:1)} ${n.unit}`,wanted:s.wanted,next:r===e&&t!==void 0}));return n.contact.length?[...i,{at:n.contact_label,wanted:n.contact,next:t!==void 0&&e<0}]:i}function rm(n,t){const e=_0(n,t).map(({at:i,wanted:s,next:r})=>`<tr class="${r?"next":""}"><th>${ce(i)}</th><td>${ce(s.join(", "))}</td></tr>`);return`<h4>${im.good}</h4><table>${e.join("")}</table>`}const Ka=()=>document.getElementById("modes"),v0=(n,t)=>(n?.modes||[]).find(e=>e.name===t),x0=(n,t)=>t?`${n} (${t.replace(/^Key/,"")})`:n,ir=(n,t)=>v0(n,t)?.label??t,M0=(n,t)=>(n?.modes||[]).find(e=>e.key&&e.key===t),om=n=>(n?.modes||[]).filter(t=>!t.key);function y0(n,t){Ka().hidden=!n.modes.length,Ka().classList.toggle("told",n.on_board!==null),Ka().replaceChildren(...n.modes.map(e=>{const i=document.createElement("button");return i.dataset.mode=e.name,i.title=e.words,i.textContent=x0(e.label,e.key),n.on_board&&i.append(document.createElement("small")),i.onclick=()=>t(e.name),i}))}function am(n,t,e,i){const s=Zn(t,n?.on_board);for(const r of Ka().children){const[o,a]=[r.dataset.mode===e,r.dataset.mode===s];r.disabled=!i,r.setAttribute("aria-pressed",String(o));const l=r.querySelector("small");l&&Oe(l,[o?N.mode_ground:"",a?N.mode_board:""].filter(Boolean).join(" · "))}}function S0(n){const t=om(n).map(i=>i.label.toLowerCase()).join(", "),e=(n?.modes||[]).filter(i=>i.key).map(i=>[i.key.replace(/^Key/,""),i.words||i.label]);return t?[["M",Yt(N.mode_turn,{modes:t})],...e]:e}const rs=()=>document.getElementById("dialog");function Ls(n,t){const e=rs();e.oncancel=null,delete e.dataset.passes,e.innerHTML=n,e.open||e.showModal();for(const i of e.querySelectorAll("[data-close]"))i.onclick=()=>e.close();return t&&t(e),e}function $o(){rs().open&&rs().close()}function lm(){return rs().open?rs().querySelector("h3")?.textContent||N.dialog:""}function cm(n){const t=rs();if(!t.open)return!1;const e=t.querySelector(`[data-key="${n}"]`);if(e)e.click();else if(t.dataset.passes!==void 0)return t.close(),!1;return!0}function um(n){const t=rs();let e=t.querySelector("#dialog-note");!e&&n&&(e=document.createElement("p"),Object.assign(e,{id:"dialog-note",className:"alarm"}),e.setAttribute("role","alert"),t.querySelector("h3")?.after(e)),e&&e.textContent!==n&&(e.textContent=n),e&&(e.hidden=!n)}const Ko=`<button data-close>${N.close}</button>`;function Sl(n,t){Ls(`<h3>${ce(n)}</h3><p>${ce(t)}</p><div class="buttons">${Ko}</div>`)}const ll=n=>j_[n]||n.replace(/^Key/,"");function hh(n){const t=n?.controller,e=(t?.axes||[]).map(s=>[s.keys.map(r=>r.map(ll).join(" / ")).join(` ${N.or} `),`${t.verb} ${s.positive} / ${s.negative} (${s.name})`]);for(const s of t?.buttons||[])e.push([ll(s.key),s.words]);const i=t?.key_deflections.length||0;return i>1&&e.push([Array.from({length:i},(s,r)=>r+1).join(" "),Yt(N.help_step,{name:t.step_name})]),e}function dh(n){const t=n?.abort?`: ${n.abort}`:"",[[e,i],...s]=Y_.map(([a,l])=>[a,Yt(l,{abort:t})]),r=[[e,i],...hh(n),...S0(n),...s,...$_].map(([a,l])=>a?`<tr><td><kbd>${ce(a)}</kbd></td><td>${ce(l)}</td></tr>`:`<tr><td colspan="2">${ce(l)}</td></tr>`),o=n?.guidance?rm(n.guidance):"";Ls(`<h3>${N.help_title}</h3><table>${r.join("")}</table>${o}<div class="buttons"><button data-close data-key="Slash">${N.close}</button></div>`,a=>{a.dataset.passes=""})}function Zo(n){return Z_[n]||n}function w0(n,t){const e=n.fields.map(i=>{const s=`${i.section} ${i.key}`,r=t[s]??i.value,o=`data-setting="${ce(s)}" title="${ce(`${i.key}: ${i.hint}`)}"`,a=i.choices.length?`<select ${o}>${i.choices.map(l=>`<option ${l===r?"selected":""}>${ce(l)}</option>`).join("")}</select>`:`<input ${o} value="${ce(r)}" maxlength="200">`;return`<label>${ce(i.label)} ${a} <span class="dim">${ce(i.unit)}</span></label>`});return`<fieldset><legend>${ce(n.title)}</legend>${e.join("")}</fieldset>`}function b0(n,t){const e={};for(const i of t)for(const s of i.fields){const r=`${s.section} ${s.key}`,o=[...n.querySelectorAll("[data-setting]")].find(a=>a.dataset.setting===r).value;o.trim()!==s.value&&(e[r]=o)}return e}let Cd={};function hm(n,t,e="",i=null){if(!n.can.fly){Sl(N.new_run,N.no_fly);return}const s=n.display?.modes||[],r=n.display?.forms||[],o=n.frame?.mode||n.run?.mode||n.asked,a=s.map(l=>`<option value="${l.name}" ${l.name===o?"selected":""}>${ce(l.label)}</option>`);Ls(`<h3>${N.new_run}</h3><p>${N.new_run_text}</p>
    <p>${s.length?`<label>${N.mode} <select id="new-mode">${a.join("")}</select></label> &nbsp;`:""}
    <label>${N.seed} <input id="new-seed" size="15" inputmode="numeric" placeholder="${N.seed_hint}"></label></p>
    <div class="forms">${r.map(l=>w0(l,Cd)).join("")}</div>
    <p id="new-error" class="alarm" role="alert">${ce(e)}</p>
    <div class="buttons"><button data-close>${N.cancel}</button>${i?`<button id="new-stop" title="${N.stop_hint}">${N.stop_run}</button>`:""}<button class="primary" id="new-start">${N.start}</button></div>`,l=>{l.classList.toggle("wide",r.length>0),l.onclose=()=>l.classList.remove("wide");const c=async()=>{const u=l.querySelector("#new-seed").value.trim(),h={do:"fly",mode:l.querySelector("#new-mode")?.value??null};u&&(h.seed=Number(u)),r.length&&(h.settings=Cd=b0(l,r));const d=await t(h);d.ok?l.close():l.querySelector("#new-error").textContent=Zo(d.code)};l.querySelector("#new-start").onclick=c,i&&(l.querySelector("#new-stop").onclick=()=>{l.close(),i()}),l.querySelector("#new-seed").onkeydown=u=>{u.key==="Enter"&&c()},l.querySelector("#new-start").focus()})}function dm(n,t,e){const i=n.success,s=(o,a,l,c)=>`<tr><th>${ce(o)}</th><td class="${c===!1?"alarm":""}">${ce(a)}</td><td class="dim">${ce(l)}</td></tr>`,r=n.measures.filter(o=>o.value!==null).map(o=>s(o.words,`${_e(o.value,o.digits)} ${o.unit}`,uh(null,o,o.digits),o.ok));Ls(`<h3>${N.verdict_title}</h3>
    <p class="verdict ${i?"ok":"alarm"}" id="verdict-words">${i?"✓":"✗"} ${ce(sr(n.words))}</p>
    <table>${s(N.verdict_time,`${_e(n.duration,1)} s`,"",null)}${r.join("")}</table>
    <div class="buttons">${Ko}${t?`<button class="primary" id="again" data-key="KeyN">${N.fly_again}</button>`:""}</div>`,o=>{const a=o.querySelector("#again");a&&(a.onclick=()=>{o.close(),e()})})}function wl(){return rs().open&&rs().querySelector("#runs")!==null}const sr=n=>n.charAt(0).toUpperCase()+n.slice(1),E0=Object.freeze(Object.defineProperty({__proto__:null,close:$o,closeButton:Ko,escape:ce,help:dh,keyName:ll,keyRows:hh,message:Sl,newRun:hm,note:um,open:Ls,refused:Zo,runsShown:wl,sentence:sr,takesKey:cm,title:lm,verdict:dm},Symbol.toStringTag,{value:"Module"})),wr=n=>document.getElementById(n),Pd=5,T0=.12;class A0{constructor(t,e,i){Object.assign(this,{store:t,scene:e,stick:i,run:null,moved:!1,caps:[],said:"",display:null})}heard({held:t,at:e}){this.store.run!==this.run&&Object.assign(this,{run:this.store.run,moved:!1}),this.store.status.phase==="flying"&&t&&e.some(i=>i!==0)&&(this.moved=!0)}wanted(t){const{store:e}=this,i=e.status.phase==="flying",s=["idle","starting","refused"].includes(e.status.phase);return!t&&e.status.lease==="you"&&!!e.display?.controller&&(s&&!e.can.desk||i&&!this.moved&&!e.verdict)}show(t){const{display:e,frame:i}=this.store,s=this.wanted(t);if(wr("coach").hidden=!s,!s)return;e!==this.display&&this.build(e);const r=e.guidance?.distance.map(c=>Rn(i,c)).find(c=>c!==void 0);this.place(i);const o=wr("coach-caps").hidden?[]:e.controller.axes.map(c=>c.along&&c.keys.length>0),a=this.stick.source==="keyboard"?hh(e).filter((c,u)=>!o[u]).map(([c,u])=>`<tr><th><kbd>${ce(c)}</kbd></th><td>${ce(u)}</td></tr>`).join(""):"",l=(e.guidance?rm(e.guidance,r):"")+(a?`<h4 class="keys">${im.keys}</h4><table class="keys">${a}</table>`:"");l!==this.said&&(this.said=l,wr("coach-card").innerHTML=l)}build(t){this.display=t,this.caps=[];for(const e of t.controller.axes.filter(i=>i.along&&i.keys.length))[[e.keys[0][0],e.positive,1],[e.keys[0][1],e.negative,-1]].forEach(([i,s,r])=>{const o=document.createElement("span");o.innerHTML=`<kbd>${ce(ll(i))}</kbd> ${ce(s)}`,this.caps.push({cap:o,towards:lo[e.along].map(a=>a*r)})});wr("coach-caps").replaceChildren(...this.caps.map(({cap:e})=>e))}place(t){const{scene:e,stick:i}=this,s=e.moving?.find(({item:u})=>u.kind==="body"&&u.role==="measured"),r=s&&yi(t,s.item.place,s.item.axes),o=r&&e.onView(r);if(wr("coach-caps").hidden=!o||i.source!=="keyboard",wr("coach-caps").hidden)return;const a=this.caps.map(({towards:u})=>{const h=e.onView(r.map((d,f)=>d+.5*u[f]));return h?[h[0]-o[0],h[1]-o[1]]:[0,0]}),l=Math.max(...a.map(([u,h])=>Math.hypot(u,h)),1e-9),c=parseFloat(getComputedStyle(document.documentElement).fontSize);this.caps.forEach(({cap:u},h)=>{const d=Math.hypot(...a[h]);u.hidden=d<T0*l,!u.hidden&&(u.style.left=`${Math.round(o[0]+a[h][0]/d*Pd*c*1.25)}px`,u.style.top=`${Math.round(o[1]+a[h][1]/d*Pd*c)}px`)})}}const Zt=N.desk,R0=5;class C0{constructor(t){this.link=t,this.task={hint:"",goal:"",display:null},this.state=null,this.mine=!1,this.page=null,document.getElementById("dialog").addEventListener("close",({target:e})=>{e.querySelector("[data-desk]")||setTimeout(()=>{e.open||this.reopen()})})}show(t,e){const i=r=>JSON.stringify({...r,rest_s:0,closing:!1}),s=!this.state||i(this.state)!==i(t);this.state=t,this.mine=e,t.stage==="rest"&&s&&(this.restUntil=performance.now()+t.rest_s*1e3),s?this.draw():this.wait()}lease(t){t!==this.mine&&(this.mine=t,t?this.page?this.page():this.state&&this.draw():this.shut())}draw(){clearInterval(this.timer);const t=this.state.stage;this.page=null,this.mine&&(t==="flying"?$o():this.turn(()=>this[t]()))}turn(t){this.page=t,t()}reopen(){this.mine&&this.page&&this.page()}shut(){document.querySelector("#dialog [data-desk]")&&$o()}title(){if(!this.state)return"";const{title:t,who:e,stage:i,training:s,mode:r}=this.state,o=e?[i==="done"?e:this.heading()]:[];return r&&o.push(ir(this.task.display,r),s?Zt.is_training:Zt.is_counted),[...o,Yt(Zt.session,{title:t})].join(" · ")}async ask(t,e,i){const s=await this.link.ask({do:"desk",act:t,...e}),r=i?.querySelector(".error");return!s.ok&&r&&(r.textContent=Zt.errors[s.code]||Zo(s.code)),s.ok}frame(t,e,i,s){const r=Ls(`<h3 data-desk>${ce(t)}</h3>${e}<p class="error alarm" role="alert"></p><div class="buttons">${i}</div>`,s);return r.onclose=null,this.wait(),r}wait(){const t=document.querySelector("#dialog [data-waits]");t&&(t.disabled=this.state.closing,document.querySelector("#dialog .error").textContent=this.state.closing?Zt.errors.CLOSING:"",this.state.closing||t.focus())}door(){this.frame(this.state.title,`<p>${Zt.door}</p><p><label>${Zt.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,`<button class="primary" id="desk-go">${Zt.begin}</button>`,t=>{const e=()=>this.ask("begin",{volunteer:Number(t.querySelector("#volunteer").value)},t);t.querySelector("#desk-go").onclick=e,t.querySelector("#volunteer").onkeydown=i=>{i.key==="Enter"&&e()},t.querySelector("#volunteer").focus()})}heading(){return Yt(Zt.heading,{who:this.state.who,n:this.state.number,of:this.state.of})}ready(){const t=this.state.training?Zt.training:Zt.counts,e=this.state.why?`<p class="alarm">${ce(this.state.why)}</p>`:"";this.frame(this.heading(),`${e}<p>${t}</p><p>${Yt(Zt.condition,{mode:ce(ir(this.task.display,this.state.mode))})}</p><p class="dim">${ce(this.task.hint)} ${Zt.clock}</p>`,`<button class="primary" id="desk-go" data-waits>${Zt.fly}</button>`,i=>{i.querySelector("#desk-go").onclick=()=>this.ask("fly",{},i)})}broken(){this.frame(this.heading(),`<p class="verdict alarm" id="desk-why">${ce(Yt(Zt.broken,{why:this.state.why}))}</p><p>${Zt.flown_again}</p>`,`<button class="primary" id="desk-go" data-waits>${Zt.go_on}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("go_on",{},t)})}closing(){this.frame(this.heading(),`<p>${Zt.errors.CLOSING}</p>`,"")}rest(){this.frame(Zt.rest_title,`<p>${Zt.rest}</p><p class="verdict" id="rest-left"></p>`,`<button class="primary" id="desk-go">${Zt.go_on}</button>`,t=>{const e=t.querySelector("#desk-go"),i=t.querySelector("#rest-left");e.onclick=()=>this.ask("go_on",{},t);const s=()=>{const r=Math.max(0,(this.restUntil-performance.now())/1e3);i.textContent=`${r.toFixed(0)} s`,e.disabled=r>0};s(),clearInterval(this.timer),this.timer=setInterval(s,500)})}done(){this.frame(Zt.done_title,`<p>${Yt(Zt.done,{who:this.state.who})}</p>`,`<button id="desk-go">${Zt.next}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("leave",{},t)})}rate(){this.answers={},this.scales=new Map,this.turn(()=>this.question("controllable"))}question(t){const{verdict:e}=this.state,i=`<button data-answer="yes">${Zt.yes}</button><button data-answer="no">${Zt.no}</button>`;this.frame(`${this.heading()} · Cooper-Harper`,`<p class="${e.success?"ok":""}">${ce(sr(e.words||""))}</p>${this.state.why?`<p class="alarm">${ce(this.state.why)}</p>`:""}<p>${ce(Yt(Zt.tree[t],{goal:this.task.goal}))}</p>`,i,s=>{s.querySelector("[data-answer=yes]").focus();for(const r of s.querySelectorAll("[data-answer]"))r.onclick=()=>this.answered(t,r.dataset.answer==="yes")})}answered(t,e){const i=["controllable","adequate","satisfactory"];if(this.answers[t]=e,!e)for(const r of i.slice(i.indexOf(t)+1))this.answers[r]=!1;const s=i[i.indexOf(t)+1];this.turn(e&&s?()=>this.question(s):()=>this.pick())}pick(){const{controllable:t,adequate:e,satisfactory:i}=this.answers,r=(t?e?i?[1,2,3]:[4,5,6]:[7,8,9]:[10]).map(o=>`<button data-rating="${o}"><b>${o}</b> ${Zt.ratings[o]}</button>`).join("");this.frame(`${this.heading()} · Cooper-Harper`,`<p>${Zt.pick}</p><div class="choices">${r}</div>`,`<button id="desk-back">${Zt.again}</button>`,o=>{o.querySelector("#desk-back").onclick=()=>this.rate();for(const a of o.querySelectorAll("[data-rating]"))a.onclick=()=>{this.answers.rating=Number(a.dataset.rating),this.turn(()=>this.tlx())};o.querySelector("[data-rating]").focus()})}tlx(){const t=Object.entries(Zt.tlx).map(([e,[i,s,r,o]])=>`<fieldset><legend>${i}</legend>
      <label for="tlx-${e}">${s}</label><input type="range" class="unset" aria-valuetext="${Zt.unset}" id="tlx-${e}" data-tlx="${e}" min="0" max="100" step="${R0}" value="50">
      <div class="scale-ends"><span>${r}</span><output id="out-${e}">–</output><span>${o}</span></div></fieldset>`).join("");this.frame(`${this.heading()} · NASA-TLX`,t,`<button id="desk-back">${Zt.again}</button><button class="primary" id="desk-go" disabled>${Zt.save}</button>`,e=>{const{scales:i}=this,s=r=>{i.set(r.dataset.tlx,Number(r.value)),r.classList.remove("unset"),r.removeAttribute("aria-valuetext"),e.querySelector(`#out-${r.dataset.tlx}`).textContent=r.value,e.querySelector("#desk-go").disabled=i.size<Object.keys(Zt.tlx).length};for(const r of e.querySelectorAll("[data-tlx]"))i.has(r.dataset.tlx)&&(r.value=i.get(r.dataset.tlx),s(r)),r.oninput=()=>s(r),r.onkeydown=o=>{o.key==="Enter"&&s(r)},r.onpointerup=()=>s(r);e.querySelector("#desk-back").onclick=()=>this.rate(),e.querySelector("#desk-go").onclick=()=>this.ask("rate",{cooper_harper:this.answers,tlx:Object.fromEntries(i)},e)})}weigh(){this.chosen=[],this.turn(()=>this.pair(0))}pair(t){const{chosen:e}=this,{pairs:i}=this.state,s=i[t].map(o=>`<button data-scale="${o}" aria-pressed="${e[t]===o}"><b>${Zt.tlx[o][0]}</b> ${Zt.tlx[o][1]}</button>`).join(""),r=`${this.heading()} · NASA-TLX · ${Yt(Zt.pair,{n:t+1,of:i.length})}`;this.frame(r,`<p>${Zt.weigh}</p><div class="choices">${s}</div>`,t>0?`<button id="desk-back">${Zt.back}</button>`:"",o=>{t>0&&(o.querySelector("#desk-back").onclick=()=>this.turn(()=>this.pair(t-1)));for(const a of o.querySelectorAll("[data-scale]"))a.onclick=()=>{e[t]=a.dataset.scale;const l=i.findIndex((c,u)=>!e[u]);this.turn(l<0?()=>this.pairs():()=>this.pair(l))};(o.querySelector("[aria-pressed=true]")||o.querySelector("[data-scale]")).focus()})}pairs(){const{chosen:t}=this,e=s=>Zt.tlx[s][0],i=this.state.pairs.map((s,r)=>`<tr><td>${s.map(o=>o===t[r]?`<b>${e(o)} ✓</b>`:e(o)).join(` ${N.or} `)}</td>
      <td><button data-pair="${r}" aria-label="${Zt.change} ${s.map(e).join(` ${N.or} `)}">${Zt.change}</button></td></tr>`).join("");this.frame(`${this.heading()} · NASA-TLX`,`<p>${Zt.chosen}</p><table>${i}</table>`,`<button class="primary" id="desk-go">${Zt.save_pairs}</button>`,s=>{for(const r of s.querySelectorAll("[data-pair]"))r.onclick=()=>this.turn(()=>this.pair(Number(r.dataset.pair)));s.querySelector("#desk-go").onclick=()=>this.ask("weigh",{chosen:t},s),s.querySelector("#desk-go").focus()})}}const[fh,fm,bl,Xo,ph,mh,gh]=[0,1,2,3,4,5,6],Wr=3,P0=44,pm=6,Ld={[bl]:"✓",[Xo]:"✓",[ph]:"✗",[mh]:"✗",[gh]:"?"};function mm([n,t,e,i,s,r,o,...a]){return{seq:n,sent:t,due:e,kind:i,state:s,refusal:r,told:o,value:a}}function L0(n,t){return n.told>=0&&n.told<=t?n:{...n,state:t<n.due?fh:fm,told:-1}}const _h=n=>n.kind===Wr&&(n.state===bl||n.state===Xo);function D0(n,t,e){const i=e.step_s,s=Math.max(n.due-n.sent,1);if(n.told>=0)return .8+.2*Math.min(1,(t-n.told)*i/pm);if(t<n.due)return .05+.37*((t-n.sent)/s);const r=Math.max(e.back_s/i,1);return .46+.34*Math.min(1,(t-n.due)/r)}function I0(n,t,e,i,s){const{pen:r,w:o,h:a,rem:l}=Ts(n),c=s/t.step_s,u=l*1.35,[h,d,f,g,v]=o<P0*l?N.ladder_narrow:[N.ladder_ground,N.ladder_link,N.ladder_craft,N.ladder_back,N.ladder_known],m=[[0,.05,h],[.05,.42,d],[.42,.5,f],[.5,.8,g],[.8,1,v]];for(const[x,U,A]of m)r.fillStyle=A===f?"#17222e":"#0a1018",r.fillRect(x*o+1,u,(U-x)*o-2,a-u),x!==0&&Ne(r,A,(x+U)/2*o,l*.55,Wt.dim,"center");Ne(r,h,0,l*.55,Wt.dim);const p=(a-u)/e.length;e.forEach((x,U)=>Ne(r,x.name,l*.35,u+p*(U+.5),Wt.dim));const y=Math.max(2,.37*o/Math.max(t.forward_s/t.step_s,8)-1),E={top:u,lane:p,bottom:a,width:Math.min(y,l),rem:l};for(const x of i){const U=D0(x,c,t);U>=1||x.told>=0&&(c-x.told)*t.step_s>pm||U0(r,x,U*o,e,E)}}function U0(n,t,e,i,{top:s,lane:r,bottom:o,width:a,rem:l}){const c=t.state===ph||t.state===mh,u=t.value.some(d=>d!==0),h=t.kind===Wr||c?Wt.alarm:t.state===Xo||t.state===bl?Wt.ok:t.state===gh?Wt.dim:t.state===fm?Wt.predicted:Wt.measured;if(n.fillStyle=h,!u&&!c&&t.kind!==Wr){n.globalAlpha=t.state===Xo?.25:.5,i.forEach((d,f)=>n.fillRect(e,s+r*(f+.5)-1,Math.max(a*.5,1),2)),n.globalAlpha=1;return}(t.kind===Wr||c)&&n.fillRect(e,s,Math.max(1.5,a*.4),o-s),i.forEach((d,f)=>{const g=t.value[f];if(!g)return;const v=Math.min(Math.abs(g)/d.highest,1)*r*.46,m=s+r*(f+.5);t.state===fh&&(n.globalAlpha=.85),n.fillRect(e,g>0?m-v:m,a,v),n.globalAlpha=1}),Ld[t.state]&&c&&Ne(n,Ld[t.state],e,s+l*.4,h)}function N0(n,t){const e={};for(const r of n)e[r.state]=(e[r.state]||0)+1;const i=e[fh]||0,s=[...n.some(_h)?[N.aborted]:[],`${i} ${N.ladder_link}`];if(!t)return[...s,N.ladder_untold].join(" · ");for(const r of[bl,Xo,ph,mh,gh])e[r]&&s.push(`${e[r]} ${K_[r]}`);return s.join(" · ")}function F0(n){const t=document.getElementById("top"),e=new ResizeObserver(()=>{document.documentElement.style.setProperty("--top",`${t.offsetHeight}px`),n.resize()});for(const i of["top","app"])e.observe(document.getElementById(i))}const ks=n=>document.getElementById(n),O0=5,k0=["measured","predicted","plain"];class B0{constructor(t){ks("live-back").onclick=t,this.rows=null}show(t,e){const{display:i,frame:s}=t;if(ks("live").hidden=!s,!s)return;Oe(ks("live-head"),Yt(N.live_head,{t:_e(s.t,1),mode:ir(i,s.mode)})),this.say(ks("live-words"),e.map(([o,a])=>[o,a?"alarm":""]));const r=(i.instruments?.rows||[]).slice(0,O0).flatMap(o=>{const a=o.readings.filter(u=>k0.includes(u.role)).map(u=>[u,Rn(s,u.value)]);if(!a.length)return[];const l=a.some(([u,h])=>h<=Bi(s,u.low)||h>=Bi(s,u.high)),c=a.map(([,u])=>_e(u,o.digits)).join(" / ");return[[`${o.label} ${c} ${o.unit}${l?` ▲ ${uh(s,a[0][0],o.digits)}`:""}`,l?"alarm":""]]});this.say(ks("live-rows"),r),ks("live").classList.toggle("dead",!t.connected)}say(t,e){const i=JSON.stringify(e);t.dataset.said!==i&&(t.dataset.said=i,t.replaceChildren(...e.filter(([s])=>s).map(([s,r])=>{const o=document.createElement("span");return o.textContent=s,r&&(o.className=r),o})))}hide(){ks("live").hidden=!0}}const Dd=2500,z0=500,H0=800,G0=8e3,V0=n=>new Promise(t=>{setTimeout(t,n)});class W0{constructor(t,e){Object.assign(this,{link:t,store:e,wanted:null,unanswered:null})}async steer(t){this.unanswered=null,(await this.link.ask({...t,run:this.store.run?.name},Dd)).code==="NO_ANSWER"&&(this.unanswered={wish:t,at:performance.now()})}async abort(){const t=this.store.run?.name;if(this.wanted&&!this.wanted.accepted&&this.goesOn(this.wanted))return;const e={run:t,times:0,since:performance.now(),accepted:!1};this.wanted=e;do{e.times+=1;const i=await this.link.ask({do:"abort",run:t},Dd);e.accepted=i.ok,i.ok||await V0(z0)}while(!e.accepted&&this.goesOn(e))}goesOn({run:t}){const{store:e}=this;return e.run!==null&&e.run.name===t&&!e.verdict&&(e.status.phase==="flying"||!e.connected)}words(){const{store:t,wanted:e,unanswered:i}=this,s=t.connected?"":`${N.socket_closed}. `;if(e&&!this.goesOn(e))this.wanted=null;else{if(e&&!e.accepted)return performance.now()-e.since<H0?[N.abort_asked,""]:[N.abort_unconfirmed,s+Yt(N.abort_again,{n:e.times})];if(e&&t.abortAt===null&&t.connected)return[N.abort_accepted,t.frame?.paused?N.paused:""]}if(!i||performance.now()-i.at>G0||this.done(i.wish))return null;const r=i.wish.do==="mode"?ir(t.display,i.wish.mode):N[i.wish.do];return[Yt(N.unconfirmed,{name:r.toUpperCase()}),s+N.unconfirmed_hint]}done(t){const{frame:e,verdict:i,connected:s}=this.store;return i?!0:!e||!s?!1:t.do==="stop"?this.store.status.phase!=="flying":t.do==="mode"?e.mode===t.mode:!!e.paused==(t.do==="pause")}}const $0=20,X0=4,gm="rvd.stick",cl=-1;function Id(n,t){if(!Number.isFinite(n))return 0;const e=Math.min(Math.abs(n),1);return e<=t?0:Math.sign(n)*(e-t)/(1-t)}class q0{constructor(t,e=()=>""){this.onChange=t,this.barred=e,this.down=new Set,this.step=1,this.source="keyboard",this.pads=[],this.gamepad=null,this.settingUp=!1,this.settings=K0(),this.setController(null),addEventListener("keydown",s=>this.key(s,!0)),addEventListener("keyup",s=>this.key(s,!1));const i=()=>{this.down.clear(),this.send(!0)};addEventListener("blur",i),document.addEventListener("visibilitychange",i),setInterval(()=>this.poll(),$0)}setController(t){this.axes=t?.axes||[],this.deflections=t?.key_deflections||[1],this.step=Math.min(this.step,this.deflections.length),this.keys=new Map,this.buttons=t?.buttons||[],this.axes.forEach((e,i)=>e.keys.forEach(([s,r])=>this.keys.set(s,[i,1]).set(r,[i,-1]))),this.disarm()}taken(){this.down.clear(),this.disarm()}disarm(){this.armed=this.axes.map(()=>!1)}wiring(t,e){const i=this.settings.pads[t.id]?.axes[e.name];return i?i.axis<t.axes.length?i:null:t.mapping==="standard"&&e.pad_pair?e.pad_pair.every(s=>s<t.buttons.length)?{pair:e.pad_pair,sign:1}:null:t.mapping!=="standard"||e.pad_axis>=t.axes.length?null:{axis:e.pad_axis,sign:e.pad_inverted?-1:1}}button(t){const e=this.settings.pads[t.id]?.button??(t.mapping==="standard"?X0:null);return e!==null&&e<t.buttons.length?e:null}ready(t){return!this.settingUp&&this.button(t)!==null&&this.axes.every(e=>this.wiring(t,e)!==null)}lacks(){return this.pads.length?this.gamepad?this.ready(this.gamepad)?"":"setup":"choose":""}pick(t){this.change({chosen:{id:t.id,index:t.index??0}})}setUp(t,{axes:e={},button:i}){const s=this.settings.pads[t.id]||{axes:{},button:null},r={axes:{...s.axes,...e},button:i??s.button};this.change({pads:{...this.settings.pads,[t.id]:r}})}change(t){this.settings={...this.settings,...t},this.disarm(),b_("local",gm,JSON.stringify(this.settings))}choose(){const{chosen:t}=this.settings,e=this.pads.filter(i=>i.id===t?.id);return e.length===1?e[0]:e.length>1?e.find(i=>i.index===t.index)||null:this.pads.length===1?this.pads[0]:null}deflection(t){return this.axes.map(e=>{const i=this.wiring(t,e);return i?i.pair?Id(Ud(t,i.pair[0])-Ud(t,i.pair[1]),this.settings.deadZone):i.axis===cl?0:i.sign*Id(t.axes[i.axis],this.settings.deadZone):null})}key(t,e){if(t.ctrlKey||t.metaKey||t.altKey||vh(t.target)||e&&t.target instanceof Element&&t.target.closest("input, select, dialog"))return;const i=Number(/^(?:Digit|Numpad)([1-9])$/.exec(t.code)?.[1]);if(e&&i<=this.deflections.length){this.step=i,this.send(!0);return}const s=this.buttons.some(o=>o.key===t.code);if(!this.keys.has(t.code)&&!s&&t.code!=="Space"||t.code==="Space"&&!this.settings.holdSpace||(t.preventDefault(),t.repeat))return;const r=this.down.has(t.code);e?this.down.add(t.code):this.down.delete(t.code),e&&(this.source="keyboard"),r!==e&&this.send(!0)}poll(){this.barred()&&this.down.clear(),this.pads=j0();const t=this.choose();(t?.id!==this.gamepad?.id||t?.index!==this.gamepad?.index)&&this.disarm(),this.gamepad=t,t&&this.ready(t)&&ec(t,this.button(t))&&(this.source="gamepad"),this.holds()?this.deflection(t).forEach((e,i)=>{e===0&&(this.armed[i]=!0)}):this.disarm(),this.send(!1)}free(){return Y0()&&!this.barred()}holds(){const t=this.gamepad;return this.source==="gamepad"&&this.free()&&t!==null&&this.ready(t)&&ec(t,this.button(t))}gone(){return this.source==="gamepad"&&this.gamepad===null}stuck(){return this.holds()?this.axes.filter((t,e)=>!this.armed[e]).map(t=>t.name):[]}pressed(){const t=this.source==="gamepad"?this.gamepad:null;return this.buttons.reduce((e,i,s)=>{const r=t?t.mapping==="standard"&&ec(t,i.pad_button):this.down.has(i.key);return e|(r?1<<s:0)},0)}withButtons(t){return this.buttons.length?{...t,buttons:this.pressed()}:t}state(){if(this.source==="gamepad"){const i=this.holds();return this.withButtons({held:i,at:i?this.deflection(this.gamepad).map((s,r)=>this.armed[r]?s:0):this.axes.map(()=>0)})}const t=this.axes.map(()=>0);for(const i of this.down)this.keys.has(i)&&(t[this.keys.get(i)[0]]+=this.keys.get(i)[1]);const e=this.deflections[this.step-1];return this.withButtons({held:this.free()&&(!this.settings.holdSpace||this.down.has("Space")),at:t.map(i=>Math.max(-1,Math.min(1,i))*e)})}send(t){this.onChange(this.state(),t)}}const Y0=()=>document.visibilityState==="visible"&&document.hasFocus();function j0(){try{return[...navigator.getGamepads?.()||[]].filter(n=>n&&n.connected!==!1)}catch{return[]}}function ec(n,t){return!!n.buttons[t]?.pressed}function Ud(n,t){const e=n.buttons[t];return e?Math.max(e.value??0,e.pressed&&!e.value?1:0):0}function vh(n){return n instanceof Element&&!!n.closest("input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]")}function K0(){let n=null;try{n=JSON.parse(E_("local",gm))}catch{}const t={};for(const[e,i]of Object.entries(n?.pads??{})){const s=Object.entries(i?.axes??{}).filter(([,r])=>Number.isInteger(r?.axis)&&r.axis>=cl&&Math.abs(r.sign)===1);t[e]={axes:Object.fromEntries(s),button:Number.isInteger(i?.button)&&i.button>=0?i.button:null}}return{pads:t,chosen:typeof n?.chosen?.id=="string"?n.chosen:null,holdSpace:n?.holdSpace===!0,deadZone:n?.deadZone>=0&&n.deadZone<=.4?Number(n.deadZone):.08}}const Z0=60,[J0,Nd]=[.5,.3];function Q0(n,t,e){if(t===null)return N.unknown;const{axes:i,digits:s}=n.commands;return i.length===n.controller.axes.length?Jc(t*i[e].highest,s):Jc(t,2)}class tv{constructor(t,e){Object.assign(this,{stick:t,display:e,seen:null,lead:null}),this.dialog=Ls(`<h3>${N.settings_title}</h3><p id="pad-note" role="status"></p>
      <fieldset id="pads"><legend>${N.settings_pads}</legend></fieldset><p id="pad-lead" role="status"></p><div id="pad-steps" class="buttons"></div>
      <table id="pad-axes"></table>
      <p><label>${N.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${t.settings.deadZone}"></label></p>
      <p><label><input type="checkbox" id="hold-space" ${t.settings.holdSpace?"checked":""}> ${N.settings_space}</label></p>
      ${tm?"":`<p class="alarm">${N.no_storage}</p>`}<div class="buttons">${Ko}</div>`),this.body=this.$("#pads"),this.dialog.onchange=i=>this.changed(i.target),this.timer=setInterval(()=>this.look(),Z0),this.look()}$(t){return this.dialog.querySelector(t)}look(){const{stick:t}=this;if(!this.dialog.open||!this.dialog.contains(this.body)){clearInterval(this.timer),t.settingUp=!1;return}const e=t.gamepad,i=JSON.stringify([t.pads.map(s=>[s.id,s.index]),e?.index,t.settings.pads,t.settings.chosen]);i!==this.seen&&(this.lead&&this.lead.index!==e?.index&&this.stop(),this.seen=i,this.build()),t.pads.forEach((s,r)=>Oe(this.$(`[data-live="${r}"]`),Yt(N.pad_live,{axes:s.axes.map(o=>_e(o,2)).join(" "),buttons:s.buttons.flatMap((o,a)=>o.pressed?[a]:[]).join(" ")||N.pad_nothing}))),e&&(t.deflection(e).forEach((s,r)=>Oe(this.$(`[data-now="${t.axes[r].name}"]`),Q0(this.display,s,r))),this.lead&&this.follow(e))}build(){const{stick:t}=this,e=t.gamepad;this.$("#pads").hidden=!t.pads.length,this.$("#pads").innerHTML=`<legend>${N.settings_pads}</legend>${t.pads.map((r,o)=>`<p><label><input type="radio" name="pad" value="${o}" ${r===e?"checked":""}>
      ${ce(r.id)}${r.mapping==="standard"?"":` (${N.pad_plain})`}</label><br><small class="dim num" data-live="${o}"></small></p>`).join("")}`;const i=e&&t.ready(e),s=t.pads.length?e?i||this.lead?N.pad_ready:N.pad_setup:N.pad_choose:N.settings_none;Oe(this.$("#pad-note"),this.lead?"":s),this.$("#pad-note").className=!e||i?"":"alarm",this.$("#pad-axes").innerHTML=e?this.table(e):"",this.lead||this.buttons(e&&t.axes.length?[["pad-start",N.pad_start,()=>this.begin(e)]]:[])}table(t){const{stick:e}=this;return`${e.axes.map(s=>{const r=e.wiring(t,s);return`<tr><td>${ce(`${s.positive} / ${s.negative}`)}</td>
        <td>${r?.pair?`${Yt(N.settings_pair,{plus:r.pair[0],minus:r.pair[1]})} `:""}<label>${N.settings_axis} <input type="number" class="short" min="${cl}" max="${t.axes.length-1}" data-axis="${s.name}" value="${r?.axis??""}"></label></td>
        <td><label><input type="checkbox" data-invert="${s.name}" ${r?.sign<0?"checked":""}> ${N.settings_invert}</label></td>
        <td>${N.settings_now} <b data-now="${s.name}"></b></td></tr>`}).join("")}<tr><td>${N.settings_button}</td><td colspan="3"><input type="number" class="short" min="0" max="${t.buttons.length-1}"
      id="pad-button" aria-label="${N.settings_button}" value="${e.button(t)??""}"></td></tr>`}changed(t){const{stick:e}=this,i=e.gamepad;if(t.name==="pad")e.pick(e.pads[Number(t.value)]);else if(t.id==="pad-zone")e.change({deadZone:Number(t.value)});else if(t.id==="hold-space")e.change({holdSpace:t.checked});else if(i&&t.validity.valid&&(t.type==="checkbox"||t.value!=="")){const s=t.dataset.axis||t.dataset.invert;t.id==="pad-button"?e.setUp(i,{button:Number(t.value)}):s&&this.$(`[data-axis="${s}"]`).value!==""&&e.setUp(i,{axes:{[s]:{axis:Number(this.$(`[data-axis="${s}"]`).value),sign:this.$(`[data-invert="${s}"]`).checked?-1:1}}})}}buttons(t){this.$("#pad-steps").replaceChildren(...t.map(([e,i,s])=>{const r=document.createElement("button");return Object.assign(r,{id:e,textContent:i,onclick:s}),r}))}begin(t){this.stick.settingUp=!0,this.lead={index:t.index,at:-1,axes:{},back:null},this.seen=null,this.say(N.pad_rest),this.buttons([["pad-next",N.pad_next,()=>{Object.assign(this.lead,{rest:[...this.stick.gamepad.axes],down:this.stick.gamepad.buttons.map(e=>e.pressed)}),this.next()}],["pad-stop",N.pad_stop,()=>this.stop()]])}say(t){Oe(this.$("#pad-lead"),t)}stop(){this.stick.settingUp=!1,this.lead=null,this.seen=null,this.say("")}next(){const{lead:t,stick:e}=this;t.at+=1;const i=e.axes[t.at];if(!i){this.say(N.pad_hold),this.buttons([["pad-stop",N.pad_stop,()=>this.stop()]]);return}this.say(Yt(N.pad_move,{what:i.positive,name:i.name})),this.buttons([["pad-skip",N.pad_skip,()=>{t.axes[i.name]={axis:cl,sign:1},this.next()}],["pad-stop",N.pad_stop,()=>this.stop()]])}follow(t){const{lead:e,stick:i}=this;if(e.at<0)return;const s=t.axes.map((c,u)=>c-e.rest[u]);if(e.back!==null){if(Math.abs(s[e.back])>Nd)return;e.back=null,this.next();return}const r=i.axes[e.at];if(!r){const c=t.buttons.findIndex((h,d)=>h.pressed&&!e.down[d]);if(c<0)return;const{axes:u}=e;this.stop(),i.setUp(t,{axes:u,button:c});return}const o=Object.values(e.axes).map(c=>c.axis),a=s.map((c,u)=>o.includes(u)?0:Math.abs(c)),l=a.indexOf(Math.max(...a));if(a[l]>J0){if(Math.abs(e.rest[l])>Nd){this.say(`${Yt(N.pad_trigger,{axis:l})} ${Yt(N.pad_move,{what:r.positive,name:r.name})}`);return}e.axes[r.name]={axis:l,sign:Math.sign(s[l])},e.back=l,this.say(N.pad_back)}}}function _m(n,t){return new tv(n,t)}const ev=!0,un="u-",nv="uplot",iv=un+"hz",sv=un+"vt",rv=un+"title",ov=un+"wrap",av=un+"under",lv=un+"over",cv=un+"axis",Ks=un+"off",uv=un+"select",hv=un+"cursor-x",dv=un+"cursor-y",fv=un+"cursor-pt",pv=un+"legend",mv=un+"live",gv=un+"inline",_v=un+"series",vv=un+"marker",Fd=un+"label",xv=un+"value",Oo="width",ko="height",Eo="top",Od="bottom",br="left",nc="right",xh="#000",kd=xh+"0",ic="mousemove",Bd="mousedown",sc="mouseup",zd="mouseenter",Hd="mouseleave",Gd="dblclick",Mv="resize",yv="scroll",Vd="change",ul="dppxchange",Mh="--",co=typeof window<"u",Qc=co?document:null,$r=co?window:null,Sv=co?navigator:null;let Te,da;function tu(){let n=devicePixelRatio;Te!=n&&(Te=n,da&&nu(Vd,da,tu),da=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),er(Vd,da,tu),$r.dispatchEvent(new CustomEvent(ul)))}function jn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function eu(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ge(n,t,e){n.style[t]=e+"px"}function _i(n,t,e,i){let s=Qc.createElement(n);return t!=null&&jn(s,t),e?.insertBefore(s,i),s}function si(n,t){return _i("div",n,t)}const Wd=new WeakMap;function Pi(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Wd.get(n);r!=o&&(n.style.transform=r,Wd.set(n,r),t<0||e<0||t>i||e>s?jn(n,Ks):eu(n,Ks))}const $d=new WeakMap;function Xd(n,t,e){let i=t+e,s=$d.get(n);i!=s&&($d.set(n,i),n.style.background=t,n.style.borderColor=e)}const qd=new WeakMap;function Yd(n,t,e,i){let s=t+""+e,r=qd.get(n);s!=r&&(qd.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}const yh={passive:!0},wv={...yh,capture:!0};function er(n,t,e,i){t.addEventListener(n,e,i?wv:yh)}function nu(n,t,e,i){t.removeEventListener(n,e,yh)}co&&tu();function vi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Jn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function vm(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}const xm=n=>n!=null,Mm=n=>n!=null&&n>0,El=vm(xm),bv=vm(Mm);function Ev(n,t,e,i=0,s=!1){let r=s?bv:El,o=s?Mm:xm;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ie,l??-Ie]}function Tl(n,t,e,i){let s=Zd(n),r=Zd(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?ns:ym,a=s==1?Jn:oi,l=r==1?oi:Jn,c=a(o(on(n))),u=l(o(on(t))),h=Jr(e,c),d=Jr(e,u);return e==10&&(c<0&&(h=Ue(h,-c)),u<0&&(d=Ue(d,-u))),i||e==2?(n=h*s,t=d*r):(n=Em(n,h),t=Al(t,d)),[n,t]}function Sh(n,t,e,i){let s=Tl(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}const wh=.1,jd={mode:3,pad:wh},Vo={pad:0,soft:null,mode:0},Tv={min:Vo,max:Vo};function hl(n,t,e,i){return Rl(e)?Kd(n,t,e):(Vo.pad=e,Vo.soft=i?0:null,Vo.mode=i?3:0,Kd(n,t,Tv))}function we(n,t){return n??t}function Av(n,t,e){for(t=we(t,0),e=we(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Kd(n,t,e){let i=e.min,s=e.max,r=we(i.pad,0),o=we(s.pad,0),a=we(i.hard,-Ie),l=we(s.hard,Ie),c=we(i.soft,Ie),u=we(s.soft,-Ie),h=we(i.mode,0),d=we(s.mode,0),f=t-n,g=ns(f),v=Nn(on(n),on(t)),m=ns(v),p=on(m-g);(f<1e-24||p>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Ie&&(r=0),d==2&&u!=-Ie&&(o=0)));let y=f||v||1e3,E=ns(y),x=Jr(10,Jn(E)),U=y*(f==0?n==0?.1:1:r),A=Ue(Em(n-U,x/10),24),D=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Ie,I=Nn(a,A<D&&n>=D?D:xi(D,A)),T=y*(f==0?t==0?.1:1:o),S=Ue(Al(t+T,x/10),24),C=t<=u&&(d==1||d==3&&S>=u||d==2&&S<=u)?u:-Ie,V=xi(l,S>C&&t<=C?C:Nn(C,S));return I==V&&I==0&&(V=100),[I,V]}const Rv=new Intl.NumberFormat(co?Sv.language:"en-US"),bh=n=>Rv.format(n),Qn=Math,Za=Qn.PI,on=Qn.abs,Jn=Qn.floor,rn=Qn.round,oi=Qn.ceil,xi=Qn.min,Nn=Qn.max,Jr=Qn.pow,Zd=Qn.sign,ns=Qn.log10,ym=Qn.log2,Cv=(n,t=1)=>Qn.sinh(n)*t,rc=(n,t=1)=>Qn.asinh(n/t),Ie=1/0;function Jd(n){return(ns((n^n>>31)-(n>>31))|0)+1}function iu(n,t,e){return xi(Nn(n,t),e)}function Sm(n){return typeof n=="function"}function he(n){return Sm(n)?n:()=>n}const Pv=()=>{},wm=n=>n,bm=(n,t)=>t,Lv=n=>null,Qd=n=>!0,tf=(n,t)=>n==t,Dv=/\.\d*?(?=9{6,}|0{6,})/gm,rr=n=>{if(Am(n)||Rs.has(n))return n;const t=`${n}`,e=t.match(Dv);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${rr(s)}e${r}`}return Ue(n,i)};function Xs(n,t){return rr(Ue(rr(n/t))*t)}function Al(n,t){return rr(oi(rr(n/t))*t)}function Em(n,t){return rr(Jn(rr(n/t))*t)}function Ue(n,t=0){if(Am(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return rn(i)/e}const Rs=new Map;function Tm(n){return((""+n).split(".")[1]||"").length}function qo(n,t,e,i){let s=[],r=i.map(Tm);for(let o=t;o<e;o++){let a=on(o),l=Ue(Jr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Ue(u,h);s.push(d),Rs.set(d,h)}}return s}const Wo={},Eh=[],Qr=[null,null],ys=Array.isArray,Am=Number.isInteger,Iv=n=>n===void 0;function ef(n){return typeof n=="string"}function Rl(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Uv(n){return n!=null&&typeof n=="object"}const Nv=Object.getPrototypeOf(Uint8Array),Rm="__proto__";function to(n,t=Rl){let e;if(ys(n)){let i=n.find(s=>s!=null);if(ys(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=to(n[s],t)}else e=n.slice()}else if(n instanceof Nv)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Rm&&(e[i]=to(n[i],t))}else e=n;return e}function Qe(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Rm&&(Rl(n[s])?Qe(n[s],to(i[s])):n[s]=to(i[s]))}return n}const Fv=0,Ov=1,kv=2;function Bv(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function zv(n,t){if(Vv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Wv(o[0])||(o=Gv(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:Ov,f=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?d!=Fv&&(h[m]=v,d==kv&&f.push(m)):h[m]=v}Bv(h,f,s),i.push(h)}}return i}const Hv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Gv(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Vv(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Wv(n,t=100){const e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=Nn(1,Jn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const Cm=["January","February","March","April","May","June","July","August","September","October","November","December"],Pm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Lm(n){return n.slice(0,3)}const $v=Pm.map(Lm),Xv=Cm.map(Lm),qv={MMMM:Cm,MMM:Xv,WWWW:Pm,WWW:$v};function To(n){return(n<10?"0":"")+n}function Yv(n){return(n<10?"00":n<100?"0":"")+n}const jv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>To(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>To(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>To(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>To(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>To(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Yv(n.getMilliseconds())};function Th(n,t){t=t||qv;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?jv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const Kv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Zv(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==Kv?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}const Dm=n=>n%1==0,dl=[1,2,2.5,5],Jv=qo(10,-32,0,dl),Im=qo(10,0,32,dl),Qv=Im.filter(Dm),qs=Jv.concat(Im),Ah=`
`,Um="{YYYY}",nf=Ah+Um,Nm="{M}/{D}",Bo=Ah+Nm,fa=Bo+"/{YY}",Fm="{aa}",tx="{h}:{mm}",Br=tx+Fm,sf=Ah+Br,rf=":{ss}",Re=null;function Om(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?qo(10,0,3,dl).filter(Dm):qo(10,-3,0,dl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Um,Re,Re,Re,Re,Re,Re,1],[s*28,"{MMM}",nf,Re,Re,Re,Re,Re,1],[s,Nm,nf,Re,Re,Re,Re,Re,1],[i,"{h}"+Fm,fa,Re,Bo,Re,Re,Re,1],[e,Br,fa,Re,Bo,Re,Re,Re,1],[t,rf,fa+" "+Br,Re,Bo+" "+Br,Re,sf,Re,1],[n,rf+".{fff}",fa+" "+Br,Re,Bo+" "+Br,Re,sf,Re,1]];function u(h){return(d,f,g,v,m,p)=>{let y=[],E=m>=o,x=m>=r&&m<o,U=h(g),A=Ue(U*n,3),D=oc(U.getFullYear(),E?0:U.getMonth(),x||E?1:U.getDate()),I=Ue(D*n,3);if(x||E){let T=x?m/r:0,S=E?m/o:0,C=A==I?A:Ue(oc(D.getFullYear()+S,D.getMonth()+T,1)*n,3),V=new Date(rn(C/n)),F=V.getFullYear(),W=V.getMonth();for(let Z=0;C<=v;Z++){let K=oc(F+S*Z,W+T*Z,1),Q=K-h(Ue(K*n,3));C=Ue((+K+Q)*n,3),C<=v&&y.push(C)}}else{let T=m>=s?s:m,S=Jn(g)-Jn(A),C=I+S+Al(A-I,T);y.push(C);let V=h(C),F=V.getHours()+V.getMinutes()/e+V.getSeconds()/i,W=m/i,Z=d.axes[f]._space,K=p/Z;for(;C=Ue(C+m,n==1?0:3),!(C>v);)if(W>1){let Q=Jn(Ue(F+W,6))%24,ct=h(C).getHours()-Q;ct>1&&(ct=-1),C-=ct*i,F=(F+W)%24;let gt=y[y.length-1];Ue((C-gt)/m,3)*K>=.7&&y.push(C)}else y.push(C)}return y}}return[l,c,u]}const[ex,nx,ix]=Om(1),[sx,rx,ox]=Om(.001);qo(2,-53,53,[1]);function of(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function af(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,d,f;return i.map(g=>{let v=n(g),m=v.getFullYear(),p=v.getMonth(),y=v.getDate(),E=v.getHours(),x=v.getMinutes(),U=v.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||E!=h&&a[5]||x!=d&&a[6]||U!=f&&a[7]||a[1];return l=m,c=p,u=y,h=E,d=x,f=U,A(v)})}}function ax(n,t){let e=Th(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function oc(n,t,e){return new Date(n,t,e)}function lf(n,t){return t(n)}const lx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function cf(n,t){return(e,i,s,r)=>r==null?Mh:t(n(i))}function cx(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function ux(n,t){return n.series[t].fill(n,t)}const hx={show:!0,live:!0,isolate:!1,mount:Pv,markers:{show:!0,width:2,stroke:cx,fill:ux,dash:"solid"},idx:null,idxs:null,values:[]};function dx(n,t){let e=n.cursor.points,i=si(),s=e.size(n,t);Ge(i,Oo,s),Ge(i,ko,s);let r=s/-2;Ge(i,"marginLeft",r),Ge(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ge(i,"borderWidth",o),i}function fx(n,t){let e=n.series[t].points;return e._fill||e._stroke}function px(n,t){let e=n.series[t].points;return e._stroke||e._fill}function mx(n,t){return n.series[t].points.size}const ac=[0,0];function gx(n,t,e){return ac[0]=t,ac[1]=e,ac}function pa(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function lc(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}const _x={show:!0,x:!0,y:!0,lock:!1,move:gx,points:{one:!1,show:dx,size:mx,width:0,stroke:px,fill:fx},bind:{mousedown:pa,mouseup:pa,click:pa,dblclick:pa,mousemove:lc,mouseleave:lc,mouseenter:lc},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},km={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Rh=Qe({},km,{filter:bm}),Bm=Qe({},Rh,{size:10}),zm=Qe({},km,{show:!1}),Ch='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Hm="bold "+Ch,Gm=1.5,uf={show:!0,scale:"x",stroke:xh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Hm,side:2,grid:Rh,ticks:Bm,border:zm,font:Ch,lineGap:Gm,rotate:0},vx="Value",xx="Time",hf={show:!0,scale:"x",auto:!1,sorted:1,min:Ie,max:-Ie,idxs:[]};function Mx(n,t,e,i,s){return t.map(r=>r==null?"":bh(r))}function yx(n,t,e,i,s,r,o){let a=[],l=Rs.get(s)||0;e=o?e:Ue(Al(e,s),l);for(let c=e;c<=i;c=Ue(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function su(n,t,e,i,s,r,o){const a=[],l=n.scales[n.axes[t].scale].log,c=l==10?ns:ym,u=Jn(c(e));s=Jr(l,u),l==10&&(s=qs[vi(s,qs)]);let h=e,d=s*l;l==10&&(d=qs[vi(d,qs)]);do a.push(h),h=h+s,l==10&&!Rs.has(h)&&(h=Ue(h,Rs.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=qs[vi(d,qs)]));while(h<=i);return a}function Sx(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?su(n,t,Nn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?su(n,t,Nn(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}const Vm=/./,wx=/[12357]/,bx=/[125]/,df=/1/,ru=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Ex(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Vm:l(7,o)-u>=c?wx:l(5,o)-u>=c?bx:df;if(h==df){let d=on(l(1,o)-u);if(d<c)return ru(t.slice().reverse(),a.distr,h,oi(c/d)).reverse()}return ru(t,a.distr,h,1)}function Tx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=on(l(1,o)-l(2,o));return c<a?ru(t.slice().reverse(),3,Vm,oi(a/c)).reverse():t}function Ax(n,t,e,i){return i==null?Mh:t==null?"":bh(t)}const ff={show:!0,scale:"y",stroke:xh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Hm,side:3,grid:Rh,ticks:Bm,border:zm,font:Ch,lineGap:Gm,rotate:0};function Rx(n,t){let e=3+(n||1)*2;return Ue(e*t,3)}function Cx(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=on(o-r),l=n.series[t],c=a/(l.points.space*Te);return i[1]-i[0]<=c}const pf={scale:null,auto:!0,sorted:0,min:Ie,max:-Ie},Wm=(n,t,e,i,s)=>s,mf={show:!0,auto:!0,sorted:0,gaps:Wm,alpha:1,facets:[Qe({},pf,{scale:"x"}),Qe({},pf,{scale:"y"})]},gf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Wm,alpha:1,points:{show:Cx,filter:null},values:null,min:Ie,max:-Ie,idxs:[],path:null,clip:null};function Px(n,t,e,i,s){return e/10}const $m={time:ev,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Lx=Qe({},$m,{time:!1,ori:1}),_f={};function Xm(n,t){let e=_f[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(_f[n]=e)),e}const eo=1,ou=2;function cr(n,t,e){const i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,d,f,g,v,Pl,uo,Dl,Ym,Km):e(s,l,c,u,h,p,m,f,d,v,g,Ll,ho,Dh,jm,Zm)}function Ph(n,t){let e=0,i=0,s=we(n.bands,Eh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Dx(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function is(n,t,e,i,s,r){return cr(n,t,(o,a,l,c,u,h,d,f,g,v,m)=>{let p=o.pxRound;const y=c.dir*(c.ori==0?1:-1),E=c.ori==0?uo:ho;let x,U;y==1?(x=e,U=i):(x=i,U=e);let A=p(h(a[x],c,v,f)),D=p(d(l[x],u,m,g)),I=p(h(a[U],c,v,f)),T=p(d(r==1?u.max:u.min,u,m,g)),S=new Path2D(s);return E(S,I,T),E(S,A,T),E(S,A,D),S})}function Cl(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=t==0?Dl:Dh;let l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Ix(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Lh(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),g=d==h?f:r(n[d]),v=h-s;f=o<=0&&v>=0&&v<l?r(n[v]):f;let p=d+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=f&&a.push([f,g])}return a}function vf(n){return n==0?wm:n==1?rn:t=>Xs(t,n)}function qm(n){let t=n==0?Pl:Ll,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=xi(c,a/2,l/2),u=xi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const Pl=(n,t,e)=>{n.moveTo(t,e)},Ll=(n,t,e)=>{n.moveTo(e,t)},uo=(n,t,e)=>{n.lineTo(t,e)},ho=(n,t,e)=>{n.lineTo(e,t)},Dl=qm(0),Dh=qm(1),Ym=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},jm=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Km=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Zm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Jm(n){return(t,e,i,s,r)=>cr(t,e,(o,a,l,c,u,h,d,f,g,v,m)=>{let{pxRound:p,points:y}=o,E,x;c.ori==0?(E=Pl,x=Ym):(E=Ll,x=jm);const U=Ue(y.width*Te,3);let A=(y.size-y.width)/2*Te,D=Ue(A*2,3),I=new Path2D,T=new Path2D,{left:S,top:C,width:V,height:F}=t.bbox;Dl(T,S-D,C-D,V+D*2,F+D*2);const W=Z=>{if(l[Z]!=null){let K=p(h(a[Z],c,v,f)),Q=p(d(l[Z],u,m,g));E(I,K+A,Q),x(I,K,Q,A,0,Za*2)}};if(r)r.forEach(W);else for(let Z=i;Z<=s;Z++)W(Z);return{stroke:U>0?I:null,fill:I,clip:T,flags:eo|ou}})}function Qm(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}const Ux=Qm(uo),Nx=Qm(ho);function tg(n){const t=we(n?.alignGaps,0);return(e,i,s,r)=>cr(e,i,(o,a,l,c,u,h,d,f,g,v,m)=>{[s,r]=El(l,s,r);let p=o.pxRound,y=F=>p(h(F,c,v,f)),E=F=>p(d(F,u,m,g)),x,U;c.ori==0?(x=uo,U=Ux):(x=ho,U=Nx);const A=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:eo},I=D.stroke;let T=!1;if(r-s>=v*4){let F=mt=>e.posToVal(mt,c.key,!0),W=null,Z=null,K,Q,tt,ht=y(a[A==1?s:r]),ct=y(a[s]),gt=y(a[r]),yt=F(A==1?ct+1:gt-1);for(let mt=A==1?s:r;mt>=s&&mt<=r;mt+=A){let it=a[mt],_t=(A==1?it<yt:it>yt)?ht:y(it),ot=l[mt];_t==ht?ot!=null?(Q=ot,W==null?(x(I,_t,E(Q)),K=W=Z=Q):Q<W?W=Q:Q>Z&&(Z=Q)):ot===null&&(T=!0):(W!=null&&U(I,ht,E(W),E(Z),E(K),E(Q)),ot!=null?(Q=ot,x(I,_t,E(Q)),W=Z=K=Q):(W=Z=null,ot===null&&(T=!0)),ht=_t,yt=F(ht+A))}W!=null&&W!=Z&&tt!=ht&&U(I,ht,E(W),E(Z),E(K),E(Q))}else for(let F=A==1?s:r;F>=s&&F<=r;F+=A){let W=l[F];W===null?T=!0:W!=null&&x(I,y(a[F]),E(W))}let[C,V]=Ph(e,i);if(o.fill!=null||C!=0){let F=D.fill=new Path2D(I),W=o.fillTo(e,i,o.min,o.max,C),Z=E(W),K=y(a[s]),Q=y(a[r]);A==-1&&([Q,K]=[K,Q]),x(F,Q,Z),x(F,K,Z)}if(!o.spanGaps){let F=[];T&&F.push(...Lh(a,l,s,r,A,y,t)),D.gaps=F=o.gaps(e,i,s,r,F),D.clip=Cl(F,c.ori,f,g,v,m)}return V!=0&&(D.band=V==2?[is(e,i,s,r,I,-1),is(e,i,s,r,I,1)]:is(e,i,s,r,I,V)),D})}function Fx(n){const t=we(n.align,1),e=we(n.ascDesc,!1),i=we(n.alignGaps,0),s=we(n.extend,!1);return(r,o,a,l)=>cr(r,o,(c,u,h,d,f,g,v,m,p,y,E)=>{[a,l]=El(h,a,l);let x=c.pxRound,{left:U,width:A}=r.bbox,D=ct=>x(g(ct,d,y,m)),I=ct=>x(v(ct,f,E,p)),T=d.ori==0?uo:ho;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:eo},C=S.stroke,V=d.dir*(d.ori==0?1:-1);let F=I(h[V==1?a:l]),W=D(u[V==1?a:l]),Z=W,K=W;s&&t==-1&&(K=U,T(C,K,F)),T(C,W,F);for(let ct=V==1?a:l;ct>=a&&ct<=l;ct+=V){let gt=h[ct];if(gt==null)continue;let yt=D(u[ct]),mt=I(gt);t==1?T(C,yt,F):T(C,Z,mt),T(C,yt,mt),F=mt,Z=yt}let Q=Z;s&&t==1&&(Q=U+A,T(C,Q,F));let[tt,ht]=Ph(r,o);if(c.fill!=null||tt!=0){let ct=S.fill=new Path2D(C),gt=c.fillTo(r,o,c.min,c.max,tt),yt=I(gt);T(ct,Q,yt),T(ct,K,yt)}if(!c.spanGaps){let ct=[];ct.push(...Lh(u,h,a,l,V,D,i));let gt=c.width*Te/2,yt=e||t==1?gt:-gt,mt=e||t==-1?-gt:gt;ct.forEach(it=>{it[0]+=yt,it[1]+=mt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=Cl(ct,d.ori,m,p,y,E)}return ht!=0&&(S.band=ht==2?[is(r,o,a,l,C,-1),is(r,o,a,l,C,1)]:is(r,o,a,l,C,ht)),S})}function xf(n,t,e,i,s,r,o=Ie){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=on(n[l]-n[a]);u<c&&(c=u,o=on(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function Ox(n){n=n||Wo;const t=we(n.size,[.6,Ie,1]),e=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=he(s),o=1-t[0],a=we(t[1],Ie),l=we(t[2],1),c=we(n.disp,Wo),u=we(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,g,v,m)=>cr(f,g,(p,y,E,x,U,A,D,I,T,S,C)=>{let V=p.pxRound,F=e,W=i*Te,Z=a*Te,K=l*Te,Q,tt;x.ori==0?[Q,tt]=r(f,g):[tt,Q]=r(f,g);const ht=x.dir*(x.ori==0?1:-1);let ct=x.ori==0?Dl:Dh,gt=x.ori==0?u:($,et,St,vt,Tt,Jt,ft)=>{u($,et,St,Tt,vt,ft,Jt)},yt=we(f.bands,Eh).find($=>$.series[0]==g),mt=yt!=null?yt.dir:0,it=p.fillTo(f,g,p.min,p.max,mt),at=V(D(it,U,C,T)),_t,ot,zt,Gt=S,Nt=V(p.width*Te),pe=!1,te=null,me=null,H=null,nn=null;h!=null&&(Nt==0||d!=null)&&(pe=!0,te=h.values(f,g,v,m),me=new Map,new Set(te).forEach($=>{$!=null&&me.set($,new Path2D)}),Nt>0&&(H=d.values(f,g,v,m),nn=new Map,new Set(H).forEach($=>{$!=null&&nn.set($,new Path2D)})));let{x0:ne,size:se}=c;if(ne!=null&&se!=null){F=1,y=ne.values(f,g,v,m),ne.unit==2&&(y=y.map(St=>f.posToVal(I+St*S,x.key,!0)));let $=se.values(f,g,v,m);se.unit==2?ot=$[0]*S:ot=A($[0],x,S,I)-A(0,x,S,I),Gt=xf(y,E,A,x,S,I,Gt),zt=Gt-ot+W}else Gt=xf(y,E,A,x,S,I,Gt),zt=Gt*o+W,ot=Gt-zt;zt<1&&(zt=0),Nt>=ot/2&&(Nt=0),zt<5&&(V=wm);let Vt=zt>0,ve=Gt-zt-(Vt?Nt:0);ot=V(iu(ve,K,Z)),_t=(F==0?ot/2:F==ht?0:ot)-F*ht*((F==0?W/2:0)+(Vt?Nt/2:0));const Lt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=pe?null:new Path2D;let w=null;if(yt!=null)w=f.data[yt.series[1]];else{let{y0:$,y1:et}=c;$!=null&&et!=null&&(E=et.values(f,g,v,m),w=$.values(f,g,v,m))}let j=Q*ot,J=tt*ot;for(let $=ht==1?v:m;$>=v&&$<=m;$+=ht){let et=E[$];if(et==null)continue;if(w!=null){let kt=w[$]??0;if(et-kt==0)continue;at=D(kt,U,C,T)}let St=x.distr!=2||c!=null?y[$]:$,vt=A(St,x,S,I),Tt=D(we(et,it),U,C,T),Jt=V(vt-_t),ft=V(Nn(Tt,at)),xt=V(xi(Tt,at)),Ft=ft-xt;if(et!=null){let kt=et<0?J:j,bt=et<0?j:J;pe?(Nt>0&&H[$]!=null&&ct(nn.get(H[$]),Jt,xt+Jn(Nt/2),ot,Nn(0,Ft-Nt),kt,bt),te[$]!=null&&ct(me.get(te[$]),Jt,xt+Jn(Nt/2),ot,Nn(0,Ft-Nt),kt,bt)):ct(P,Jt,xt+Jn(Nt/2),ot,Nn(0,Ft-Nt),kt,bt),gt(f,g,$,Jt-Nt/2,xt,ot+Nt,Ft)}}return Nt>0?Lt.stroke=pe?nn:P:pe||(Lt._fill=p.width==0?p._fill:p._stroke??p._fill,Lt.width=0),Lt.fill=pe?me:P,Lt})}function kx(n,t){const e=we(t?.alignGaps,0);return(i,s,r,o)=>cr(i,s,(a,l,c,u,h,d,f,g,v,m,p)=>{[r,o]=El(c,r,o);let y=a.pxRound,E=Q=>y(d(Q,u,m,g)),x=Q=>y(f(Q,h,p,v)),U,A,D;u.ori==0?(U=Pl,D=uo,A=Km):(U=Ll,D=ho,A=Zm);const I=u.dir*(u.ori==0?1:-1);let T=E(l[I==1?r:o]),S=T,C=[],V=[];for(let Q=I==1?r:o;Q>=r&&Q<=o;Q+=I)if(c[Q]!=null){let ht=l[Q],ct=E(ht);C.push(S=ct),V.push(x(c[Q]))}const F={stroke:n(C,V,U,D,A,y),fill:null,clip:null,band:null,gaps:null,flags:eo},W=F.stroke;let[Z,K]=Ph(i,s);if(a.fill!=null||Z!=0){let Q=F.fill=new Path2D(W),tt=a.fillTo(i,s,a.min,a.max,Z),ht=x(tt);D(Q,S,ht),D(Q,T,ht)}if(!a.spanGaps){let Q=[];Q.push(...Lh(l,c,r,o,I,E,e)),F.gaps=Q=a.gaps(i,s,r,o,Q),F.clip=Cl(Q,u.ori,g,v,m,p)}return K!=0&&(F.band=K==2?[is(i,s,r,o,W,-1),is(i,s,r,o,W,1)]:is(i,s,r,o,W,K)),F})}function Bx(n){return kx(zx,n)}function zx(n,t,e,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}const au=new Set;function Mf(){for(let n of au)n.syncRect(!0)}co&&(er(Mv,$r,Mf),er(yv,$r,Mf,!0),er(ul,$r,()=>{yn.pxRatio=Te}));const Hx=tg(),Gx=Jm();function yf(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>lu(r,o,t,e))}function Vx(n,t){return n.map((e,i)=>i==0?{}:Qe({},t,e))}function lu(n,t,e,i){return Qe({},t==0?e:i,n)}function eg(n,t,e){return t==null?Qr:[t,e]}const Wx=eg;function $x(n,t,e){return t==null?Qr:hl(t,e,wh,!0)}function ng(n,t,e,i){return t==null?Qr:Tl(t,e,n.scales[i].log,!1)}const Xx=ng;function ig(n,t,e,i){return t==null?Qr:Sh(t,e,n.scales[i].log,!1)}const qx=ig;function Yx(n,t,e,i,s){let r=Nn(Jd(n),Jd(t)),o=t-n,a=vi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Rs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Sf(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=rn((e=+s)*Te))+"px"),[n,t,e]}function jx(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ue(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function yn(n,t,e){const i={mode:we(n.mode,1)},s=i.mode;function r(_,M,R,L){let O=M.valToPct(_);return L+R*(M.dir==-1?1-O:O)}function o(_,M,R,L){let O=M.valToPct(_);return L+R*(M.dir==-1?O:1-O)}function a(_,M,R,L){return M.ori==0?r(_,M,R,L):o(_,M,R,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=si(nv);if(n.id!=null&&(c.id=n.id),jn(c,n.class),n.title){let _=si(rv,c);_.textContent=n.title}const u=_i("canvas"),h=i.ctx=u.getContext("2d"),d=si(ov,c);er("click",d,_=>{_.target===g&&(Be!=vr||Xe!=xr)&&Mn.click(i,_)},!0);const f=i.under=si(av,d);d.appendChild(u);const g=i.over=si(lv,d);n=to(n);const v=+we(n.pxAlign,1),m=vf(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});const p=n.ms||.001,y=i.series=s==1?yf(n.series||[],hf,gf,!1):Vx(n.series||[null],mf),E=i.axes=yf(n.axes||[],uf,ff,!0),x=i.scales={},U=i.bands=n.bands||[];U.forEach(_=>{_.fill=he(_.fill||null),_.dir=we(_.dir,-1)});const A=s==2?y[1].facets[0].scale:y[0].scale,D={axes:c_,series:ti},I=(n.drawOrder||["axes","series"]).map(_=>D[_]);function T(_){const M=_.distr==3?R=>ns(R>0?R:_.clamp(i,R,_.min,_.max,_.key)):_.distr==4?R=>rc(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=M(R),{_min:O,_max:Y}=_,st=Y-O;return(L-O)/st}}function S(_){let M=x[_];if(M==null){let R=(n.scales||Wo)[_]||Wo;if(R.from!=null){S(R.from);let L=Qe({},x[R.from],R,{key:_});L.valToPct=T(L),x[_]=L}else{M=x[_]=Qe({},_==A?$m:Lx,R),M.key=_;let L=M.time,O=M.range,Y=ys(O);if((_!=A||s==2&&!L)&&(Y&&(O[0]==null||O[1]==null)&&(O={min:O[0]==null?jd:{mode:1,hard:O[0],soft:O[0]},max:O[1]==null?jd:{mode:1,hard:O[1],soft:O[1]}},Y=!1),!Y&&Rl(O))){let st=O;O=(lt,pt,Ct)=>pt==null?Qr:hl(pt,Ct,st)}M.range=he(O||(L?Wx:_==A?M.distr==3?Xx:M.distr==4?qx:eg:M.distr==3?ng:M.distr==4?ig:$x)),M.auto=he(Y?!1:M.auto),M.clamp=he(M.clamp||Px),M._min=M._max=null,M.valToPct=T(M)}}}S("x"),S("y"),s==1&&y.forEach(_=>{S(_.scale)}),E.forEach(_=>{S(_.scale)});for(let _ in n.scales)S(_);const C=x[A],V=C.distr;let F,W;C.ori==0?(jn(c,iv),F=r,W=o):(jn(c,sv),F=o,W=r);const Z={};for(let _ in x){let M=x[_];(M.min!=null||M.max!=null)&&(Z[_]={min:M.min,max:M.max},M.min=M.max=null)}const K=n.tzDate||(_=>new Date(rn(_/p))),Q=n.fmtDate||Th,tt=p==1?ix(K):ox(K),ht=af(K,of(p==1?nx:rx,Q)),ct=cf(K,lf(lx,Q)),gt=[],yt=i.legend=Qe({},hx,n.legend),mt=i.cursor=Qe({},_x,{drag:{y:s==2}},n.cursor),it=yt.show,at=mt.show,_t=yt.markers;yt.idxs=gt,_t.width=he(_t.width),_t.dash=he(_t.dash),_t.stroke=he(_t.stroke),_t.fill=he(_t.fill);let ot,zt,Gt,Nt=[],pe=[],te,me=!1,H={};if(yt.live){const _=y[1]?y[1].values:null;me=_!=null,te=me?_(i,1,0):{_:0};for(let M in te)H[M]=Mh}if(it)if(ot=_i("table",pv,c),Gt=_i("tbody",null,ot),yt.mount(i,ot),me){zt=_i("thead",null,ot,Gt);let _=_i("tr",null,zt);_i("th",null,_);for(var nn in te)_i("th",Fd,_).textContent=nn}else jn(ot,gv),yt.live&&jn(ot,mv);const ne={show:!0},se={show:!1};function Vt(_,M){if(M==0&&(me||!yt.live||s==2))return Qr;let R=[],L=_i("tr",_v,Gt,Gt.childNodes[M]);jn(L,_.class),_.show||jn(L,Ks);let O=_i("th",null,L);if(_t.show){let lt=si(vv,O);if(M>0){let pt=_t.width(i,M);pt&&(lt.style.border=pt+"px "+_t.dash(i,M)+" "+_t.stroke(i,M)),lt.style.background=_t.fill(i,M)}}let Y=si(Fd,O);_.label instanceof HTMLElement?Y.appendChild(_.label):Y.textContent=_.label,M>0&&(_t.show||(Y.style.color=_.width>0?_t.stroke(i,M):_t.fill(i,M)),Lt("click",O,lt=>{if(mt._lock)return;sn(lt);let pt=y.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=yt.isolate){let Ct=y.some((Pt,Dt)=>Dt>0&&Dt!=pt&&Pt.show);y.forEach((Pt,Dt)=>{Dt>0&&Ti(Dt,Ct?Dt==pt?ne:se:ne,!0,Ze.setSeries)})}else Ti(pt,{show:!_.show},!0,Ze.setSeries)},!1),Hi&&Lt(zd,O,lt=>{mt._lock||(sn(lt),Ti(y.indexOf(_),yr,!0,Ze.setSeries))},!1));for(var st in te){let lt=_i("td",xv,L);lt.textContent="--",R.push(lt)}return[L,R]}const ve=new Map;function Lt(_,M,R,L=!0){const O=ve.get(M)||{},Y=mt.bind[_](i,M,R,L);Y&&(er(_,M,O[_]=Y),ve.set(M,O))}function P(_,M,R){const L=ve.get(M)||{};for(let O in L)(_==null||O==_)&&(nu(O,M,L[O]),delete L[O]);_==null&&ve.delete(M)}let w=0,j=0,J=0,$=0,et=0,St=0,vt=et,Tt=St,Jt=J,ft=$,xt=0,Ft=0,kt=0,bt=0;i.bbox={};let ae=!1,jt=!1,xe=!1,B=!1,Mt=!1,nt=!1;function rt(_,M,R){(R||_!=i.width||M!=i.height)&&At(_,M),pr(!1),xe=!0,jt=!0,mr()}function At(_,M){i.width=w=J=_,i.height=j=$=M,et=St=0,dn(),be();let R=i.bbox;xt=R.left=Xs(et*Te,.5),Ft=R.top=Xs(St*Te,.5),kt=R.width=Xs(J*Te,.5),bt=R.height=Xs($*Te,.5)}const Rt=3;function ee(){let _=!1,M=0;for(;!_;){M++;let R=a_(M),L=l_(M);_=M==Rt||R&&L,_||(At(i.width,i.height),jt=!0)}}function We({width:_,height:M}){rt(_,M)}i.setSize=We;function dn(){let _=!1,M=!1,R=!1,L=!1;E.forEach((O,Y)=>{if(O.show&&O._show){let{side:st,_size:lt}=O,pt=st%2,Ct=O.label!=null?O.labelSize:0,Pt=lt+Ct;Pt>0&&(pt?(J-=Pt,st==3?(et+=Pt,L=!0):R=!0):($-=Pt,st==0?(St+=Pt,_=!0):M=!0))}}),wi[0]=_,wi[1]=R,wi[2]=M,wi[3]=L,J-=b[1]+b[3],et+=b[3],$-=b[2]+b[0],St+=b[0]}function be(){let _=et+J,M=St+$,R=et,L=St;function O(Y,st){switch(Y){case 1:return _+=st,_-st;case 2:return M+=st,M-st;case 3:return R-=st,R+st;case 0:return L-=st,L+st}}E.forEach((Y,st)=>{if(Y.show&&Y._show){let lt=Y.side;Y._pos=O(lt,Y._size),Y.label!=null&&(Y._lpos=O(lt,Y.labelSize))}})}if(mt.dataIdx==null){let _=mt.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let R=_.prox=he(_.prox),L=_.bias??=0;mt.dataIdx=(O,Y,st,lt)=>{if(Y==0)return st;let pt=st,Ct=R(O,Y,st,lt)??Ie,Pt=Ct>=0&&Ct<Ie,Dt=C.ori==0?J:$,Kt=mt.left,Ee=t[0],Se=t[Y];if(M.has(Se[st])){pt=null;let le=null,Xt=null,Ht;if(L==0||L==-1)for(Ht=st;le==null&&Ht-- >0;)M.has(Se[Ht])||(le=Ht);if(L==0||L==1)for(Ht=st;Xt==null&&Ht++<Se.length;)M.has(Se[Ht])||(Xt=Ht);if(le!=null||Xt!=null)if(Pt){let He=le==null?-1/0:F(Ee[le],C,Dt,0),Ye=Xt==null?1/0:F(Ee[Xt],C,Dt,0),_n=Kt-He,Pe=Ye-Kt;_n<=Pe?_n<=Ct&&(pt=le):Pe<=Ct&&(pt=Xt)}else pt=Xt==null?le:le==null?Xt:st-le<=Xt-st?le:Xt}else Pt&&on(Kt-F(Ee[st],C,Dt,0))>Ct&&(pt=null);return pt}}const sn=_=>{mt.event=_};mt.idxs=gt,mt._lock=!1;let Fe=mt.points;Fe.show=he(Fe.show),Fe.size=he(Fe.size),Fe.stroke=he(Fe.stroke),Fe.width=he(Fe.width),Fe.fill=he(Fe.fill);const Vn=i.focus=Qe({},n.focus||{alpha:.3},mt.focus),Hi=Vn.prox>=0,Fn=Hi&&Fe.one;let Sn=[],Gi=[],Vi=[];function Ds(_,M){let R=Fe.show(i,M);if(R instanceof HTMLElement)return jn(R,fv),jn(R,_.class),Pi(R,-10,-10,J,$),g.insertBefore(R,Sn[M]),R}function xo(_,M){if(s==1||M>0){let R=s==1&&x[_.scale].time,L=_.value;_.value=R?ef(L)?cf(K,lf(L,Q)):L||ct:L||Ax,_.label=_.label||(R?xx:vx)}if(Fn||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Hx||Lv,_.fillTo=he(_.fillTo||Dx),_.pxAlign=+we(_.pxAlign,v),_.pxRound=vf(_.pxAlign),_.stroke=he(_.stroke||null),_.fill=he(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=Rx(Nn(1,_.width),1),L=_.points=Qe({},{size:R,width:Nn(1,R*.2),stroke:_.stroke,space:R*2,paths:Gx,_stroke:null,_fill:null},_.points);L.show=he(L.show),L.filter=he(L.filter),L.fill=he(L.fill),L.stroke=he(L.stroke),L.paths=he(L.paths),L.pxAlign=_.pxAlign}if(it){let R=Vt(_,M);Nt.splice(M,0,R[0]),pe.splice(M,0,R[1]),yt.values.push(null)}if(at){gt.splice(M,0,null);let R=null;Fn?M==0&&(R=Ds(_,M)):M>0&&(R=Ds(_,M)),Sn.splice(M,0,R),Gi.splice(M,0,0),Vi.splice(M,0,0)}gn("addSeries",M)}function dr(_,M){M=M??y.length,_=s==1?lu(_,M,hf,gf):lu(_,M,{},mf),y.splice(M,0,_),xo(y[M],M)}i.addSeries=dr;function ia(_){if(y.splice(_,1),it){yt.values.splice(_,1),pe.splice(_,1);let M=Nt.splice(_,1)[0];P(null,M.firstChild),M.remove()}at&&(gt.splice(_,1),Sn.splice(_,1)[0].remove(),Gi.splice(_,1),Vi.splice(_,1)),gn("delSeries",_)}i.delSeries=ia;const wi=[!1,!1,!1,!1];function zl(_,M){if(_._show=_.show,_.show){let R=_.side%2,L=x[_.scale];L==null&&(_.scale=R?y[1].scale:A,L=x[_.scale]);let O=L.time;_.size=he(_.size),_.space=he(_.space),_.rotate=he(_.rotate),ys(_.incrs)&&_.incrs.forEach(st=>{!Rs.has(st)&&Rs.set(st,Tm(st))}),_.incrs=he(_.incrs||(L.distr==2?Qv:O?p==1?ex:sx:qs)),_.splits=he(_.splits||(O&&L.distr==1?tt:L.distr==3?su:L.distr==4?Sx:yx)),_.stroke=he(_.stroke),_.grid.stroke=he(_.grid.stroke),_.ticks.stroke=he(_.ticks.stroke),_.border.stroke=he(_.border.stroke);let Y=_.values;_.values=ys(Y)&&!ys(Y[0])?he(Y):O?ys(Y)?af(K,of(Y,Q)):ef(Y)?ax(K,Y):Y||ht:Y||Mx,_.filter=he(_.filter||(L.distr>=3&&L.log==10?Ex:L.distr==3&&L.log==2?Tx:bm)),_.font=Sf(_.font),_.labelFont=Sf(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(wi[M]=!0,_._el=si(cv,d))}}function Is(_,M,R,L){let[O,Y,st,lt]=R,pt=M%2,Ct=0;return pt==0&&(lt||Y)&&(Ct=M==0&&!O||M==2&&!st?rn(uf.size/3):0),pt==1&&(O||st)&&(Ct=M==1&&!Y||M==3&&!lt?rn(ff.size/2):0),Ct}const sa=i.padding=(n.padding||[Is,Is,Is,Is]).map(_=>he(we(_,Is))),b=i._padding=sa.map((_,M)=>_(i,M,wi,0));let k,X=null,q=null;const G=s==1?y[0].idxs:null;let ut=null,wt=!1;function Ot(_,M){if(t=_??[],i.data=i._data=t,s==2){k=0;for(let R=1;R<y.length;R++)k+=t[R][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ut=t[0],k=ut.length;let R=t;if(V==2){R=t.slice();let L=R[0]=Array(k);for(let O=0;O<k;O++)L[O]=O}i._data=t=R}if(pr(!0),gn("setData"),V==2&&(xe=!0),M!==!1){let R=C;R.auto(i,wt)?It():hs(A,R.min,R.max),B=B||mt.left>=0,nt=!0,mr()}}i.setData=Ot;function It(){wt=!0;let _,M;s==1&&(k>0?(X=G[0]=0,q=G[1]=k-1,_=t[0][X],M=t[0][q],V==2?(_=X,M=q):_==M&&(V==3?[_,M]=Tl(_,_,C.log,!1):V==4?[_,M]=Sh(_,_,C.log,!1):C.time?M=_+rn(86400/p):[_,M]=hl(_,M,wh,!0))):(X=G[0]=_=null,q=G[1]=M=null)),hs(A,_,M)}let $t,qt,Ut,ue,Ae,Ce,fn,ge,Bt,$e;function Me(_,M,R,L,O,Y){_??=kd,R??=Eh,L??="butt",O??=kd,Y??="round",_!=$t&&(h.strokeStyle=$t=_),O!=qt&&(h.fillStyle=qt=O),M!=Ut&&(h.lineWidth=Ut=M),Y!=Ae&&(h.lineJoin=Ae=Y),L!=Ce&&(h.lineCap=Ce=L),R!=ue&&h.setLineDash(ue=R)}function On(_,M,R,L){M!=qt&&(h.fillStyle=qt=M),_!=fn&&(h.font=fn=_),R!=ge&&(h.textAlign=ge=R),L!=Bt&&(h.textBaseline=Bt=L)}function bi(_,M,R,L,O=0){if(L.length>0&&_.auto(i,wt)&&(M==null||M.min==null)){let Y=we(X,0),st=we(q,L.length-1),lt=R.min==null?Ev(L,Y,st,O,_.distr==3):[R.min,R.max];_.min=xi(_.min,R.min=lt[0]),_.max=Nn(_.max,R.max=lt[1])}}const wn={min:null,max:null};function Us(){for(let L in x){let O=x[L];Z[L]==null&&(O.min==null||Z[A]!=null&&O.auto(i,wt))&&(Z[L]=wn)}for(let L in x){let O=x[L];Z[L]==null&&O.from!=null&&Z[O.from]!=null&&(Z[L]=wn)}Z[A]!=null&&pr(!0);let _={};for(let L in Z){let O=Z[L];if(O!=null){let Y=_[L]=to(x[L],Uv);if(O.min!=null)Qe(Y,O);else if(L!=A||s==2)if(k==0&&Y.from==null){let st=Y.range(i,null,null,L);Y.min=st[0],Y.max=st[1]}else Y.min=Ie,Y.max=-Ie}}if(k>0){y.forEach((L,O)=>{if(s==1){let Y=L.scale,st=Z[Y];if(st==null)return;let lt=_[Y];if(O==0){let pt=lt.range(i,lt.min,lt.max,Y);lt.min=pt[0],lt.max=pt[1],X=vi(lt.min,t[0]),q=vi(lt.max,t[0]),q-X>1&&(t[0][X]<lt.min&&X++,t[0][q]>lt.max&&q--),L.min=ut[X],L.max=ut[q]}else L.show&&L.auto&&bi(lt,st,L,t[O],L.sorted);L.idxs[0]=X,L.idxs[1]=q}else if(O>0&&L.show&&L.auto){let[Y,st]=L.facets,lt=Y.scale,pt=st.scale,[Ct,Pt]=t[O],Dt=_[lt],Kt=_[pt];Dt!=null&&bi(Dt,Z[lt],Y,Ct,Y.sorted),Kt!=null&&bi(Kt,Z[pt],st,Pt,st.sorted),L.min=st.min,L.max=st.max}});for(let L in _){let O=_[L],Y=Z[L];if(O.from==null&&(Y==null||Y.min==null)){let st=O.range(i,O.min==Ie?null:O.min,O.max==-Ie?null:O.max,L);O.min=st[0],O.max=st[1]}}}for(let L in _){let O=_[L];if(O.from!=null){let Y=_[O.from];if(Y.min==null)O.min=O.max=null;else{let st=O.range(i,Y.min,Y.max,L);O.min=st[0],O.max=st[1]}}}let M={},R=!1;for(let L in _){let O=_[L],Y=x[L];if(Y.min!=O.min||Y.max!=O.max){Y.min=O.min,Y.max=O.max;let st=Y.distr;Y._min=st==3?ns(Y.min):st==4?rc(Y.min,Y.asinh):st==100?Y.fwd(Y.min):Y.min,Y._max=st==3?ns(Y.max):st==4?rc(Y.max,Y.asinh):st==100?Y.fwd(Y.max):Y.max,M[L]=R=!0}}if(R){y.forEach((L,O)=>{s==2?O>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)xe=!0,gn("setScale",L);at&&mt.left>=0&&(B=nt=!0)}for(let L in Z)Z[L]=null}function De(_){let M=iu(X-1,0,k-1),R=iu(q+1,0,k-1);for(;_[M]==null&&M>0;)M--;for(;_[R]==null&&R<k-1;)R++;return[M,R]}function ti(){if(k>0){let _=y.some(M=>M._focus)&&$e!=Vn.alpha;_&&(h.globalAlpha=$e=Vn.alpha),y.forEach((M,R)=>{if(R>0&&M.show&&(cs(R,!1),cs(R,!0),M._paths==null)){let L=$e;$e!=M.alpha&&(h.globalAlpha=$e=M.alpha);let O=s==2?[0,t[R][0].length-1]:De(t[R]);M._paths=M.paths(i,R,O[0],O[1]),$e!=L&&(h.globalAlpha=$e=L)}}),y.forEach((M,R)=>{if(R>0&&M.show){let L=$e;$e!=M.alpha&&(h.globalAlpha=$e=M.alpha),M._paths!=null&&Cn(R,!1);{let O=M._paths!=null?M._paths.gaps:null,Y=M.points.show(i,R,X,q,O),st=M.points.filter(i,R,Y,O);(Y||st)&&(M.points._paths=M.points.paths(i,R,X,q,st),Cn(R,!0))}$e!=L&&(h.globalAlpha=$e=L),gn("drawSeries",R)}}),_&&(h.globalAlpha=$e=1)}}function cs(_,M){let R=M?y[_].points:y[_];R._stroke=R.stroke(i,_),R._fill=R.fill(i,_)}function Cn(_,M){let R=M?y[_].points:y[_],{stroke:L,fill:O,clip:Y,flags:st,_stroke:lt=R._stroke,_fill:pt=R._fill,_width:Ct=R.width}=R._paths;Ct=Ue(Ct*Te,3);let Pt=null,Dt=Ct%2/2;M&&pt==null&&(pt=Ct>0?"#fff":lt);let Kt=R.pxAlign==1&&Dt>0;if(Kt&&h.translate(Dt,Dt),!M){let Ee=xt-Ct/2,Se=Ft-Ct/2,le=kt+Ct,Xt=bt+Ct;Pt=new Path2D,Pt.rect(Ee,Se,le,Xt)}M?fr(lt,Ct,R.dash,R.cap,pt,L,O,st,Y):Ei(_,lt,Ct,R.dash,R.cap,pt,L,O,st,Pt,Y),Kt&&h.translate(-Dt,-Dt)}function Ei(_,M,R,L,O,Y,st,lt,pt,Ct,Pt){let Dt=!1;pt!=0&&U.forEach((Kt,Ee)=>{if(Kt.series[0]==_){let Se=y[Kt.series[1]],le=t[Kt.series[1]],Xt=(Se._paths||Wo).band;ys(Xt)&&(Xt=Kt.dir==1?Xt[0]:Xt[1]);let Ht,He=null;Se.show&&Xt&&Av(le,X,q)?(He=Kt.fill(i,Ee)||Y,Ht=Se._paths.clip):Xt=null,fr(M,R,L,O,He,st,lt,pt,Ct,Pt,Ht,Xt),Dt=!0}}),Dt||fr(M,R,L,O,Y,st,lt,pt,Ct,Pt)}const hi=eo|ou;function fr(_,M,R,L,O,Y,st,lt,pt,Ct,Pt,Dt){Me(_,M,R,L,O),(pt||Ct||Dt)&&(h.save(),pt&&h.clip(pt),Ct&&h.clip(Ct)),Dt?(lt&hi)==hi?(h.clip(Dt),Pt&&h.clip(Pt),oa(O,st),ra(_,Y,M)):lt&ou?(oa(O,st),h.clip(Dt),ra(_,Y,M)):lt&eo&&(h.save(),h.clip(Dt),Pt&&h.clip(Pt),oa(O,st),h.restore(),ra(_,Y,M)):(oa(O,st),ra(_,Y,M)),(pt||Ct||Dt)&&h.restore()}function ra(_,M,R){R>0&&(M instanceof Map?M.forEach((L,O)=>{h.strokeStyle=$t=O,h.stroke(L)}):M!=null&&_&&h.stroke(M))}function oa(_,M){M instanceof Map?M.forEach((R,L)=>{h.fillStyle=qt=L,h.fill(R)}):M!=null&&_&&h.fill(M)}function o_(_,M,R,L){let O=E[_],Y;if(L<=0)Y=[0,0];else{let st=O._space=O.space(i,_,M,R,L),lt=O._incrs=O.incrs(i,_,M,R,L,st);Y=Yx(M,R,lt,L,st)}return O._found=Y}function Hl(_,M,R,L,O,Y,st,lt,pt,Ct){let Pt=st%2/2;v==1&&h.translate(Pt,Pt),Me(lt,st,pt,Ct,lt),h.beginPath();let Dt,Kt,Ee,Se,le=O+(L==0||L==3?-Y:Y);R==0?(Kt=O,Se=le):(Dt=O,Ee=le);for(let Xt=0;Xt<_.length;Xt++)M[Xt]!=null&&(R==0?Dt=Ee=_[Xt]:Kt=Se=_[Xt],h.moveTo(Dt,Kt),h.lineTo(Ee,Se));h.stroke(),v==1&&h.translate(-Pt,-Pt)}function a_(_){let M=!0;return E.forEach((R,L)=>{if(!R.show)return;let O=x[R.scale];if(O.min==null){R._show&&(M=!1,R._show=!1,pr(!1));return}else R._show||(M=!1,R._show=!0,pr(!1));let Y=R.side,st=Y%2,{min:lt,max:pt}=O,[Ct,Pt]=o_(L,lt,pt,st==0?J:$);if(Pt==0)return;let Dt=O.distr==2,Kt=R._splits=R.splits(i,L,lt,pt,Ct,Pt,Dt),Ee=O.distr==2?Kt.map(Ht=>ut[Ht]):Kt,Se=O.distr==2?ut[Kt[1]]-ut[Kt[0]]:Ct,le=R._values=R.values(i,R.filter(i,Ee,L,Pt,Se),L,Pt,Se);R._rotate=Y==2?R.rotate(i,le,L,Pt):0;let Xt=R._size;R._size=oi(R.size(i,le,L,_)),Xt!=null&&R._size!=Xt&&(M=!1)}),M}function l_(_){let M=!0;return sa.forEach((R,L)=>{let O=R(i,L,wi,_);O!=b[L]&&(M=!1),b[L]=O}),M}function c_(){for(let _=0;_<E.length;_++){let M=E[_];if(!M.show||!M._show)continue;let R=M.side,L=R%2,O,Y,st=M.stroke(i,_),lt=R==0||R==3?-1:1,[pt,Ct]=M._found;if(M.label!=null){let Ln=M.labelGap*lt,Xn=rn((M._lpos+Ln)*Te);On(M.labelFont[0],st,"center",R==2?Eo:Od),h.save(),L==1?(O=Y=0,h.translate(Xn,rn(Ft+bt/2)),h.rotate((R==3?-Za:Za)/2)):(O=rn(xt+kt/2),Y=Xn);let Os=Sm(M.label)?M.label(i,_,pt,Ct):M.label;h.fillText(Os,O,Y),h.restore()}if(Ct==0)continue;let Pt=x[M.scale],Dt=L==0?kt:bt,Kt=L==0?xt:Ft,Ee=M._splits,Se=Pt.distr==2?Ee.map(Ln=>ut[Ln]):Ee,le=Pt.distr==2?ut[Ee[1]]-ut[Ee[0]]:pt,Xt=M.ticks,Ht=M.border,He=Xt.show?Xt.size:0,Ye=rn(He*Te),_n=rn((M.alignTo==2?M._size-He-M.gap:M.gap)*Te),Pe=M._rotate*-Za/180,je=m(M._pos*Te),Wn=(Ye+_n)*lt,Pn=je+Wn;Y=L==0?Pn:0,O=L==1?Pn:0;let ei=M.font[0],di=M.align==1?br:M.align==2?nc:Pe>0?br:Pe<0?nc:L==0?"center":R==3?nc:br,Ri=Pe||L==1?"middle":R==2?Eo:Od;On(ei,st,di,Ri);let $n=M.font[1]*M.lineGap,ni=Ee.map(Ln=>m(a(Ln,Pt,Dt,Kt))),fi=M._values;for(let Ln=0;Ln<fi.length;Ln++){let Xn=fi[Ln];if(Xn!=null){L==0?O=ni[Ln]:Y=ni[Ln],Xn=""+Xn;let Os=Xn.indexOf(`
`)==-1?[Xn]:Xn.split(/\n/gm);for(let Dn=0;Dn<Os.length;Dn++){let pd=Os[Dn];Pe?(h.save(),h.translate(O,Y+Dn*$n),h.rotate(Pe),h.fillText(pd,0,0),h.restore()):h.fillText(pd,O,Y+Dn*$n)}}}Xt.show&&Hl(ni,Xt.filter(i,Se,_,Ct,le),L,R,je,Ye,Ue(Xt.width*Te,3),Xt.stroke(i,_),Xt.dash,Xt.cap);let Ci=M.grid;Ci.show&&Hl(ni,Ci.filter(i,Se,_,Ct,le),L,L==0?2:1,L==0?Ft:xt,L==0?bt:kt,Ue(Ci.width*Te,3),Ci.stroke(i,_),Ci.dash,Ci.cap),Ht.show&&Hl([je],[1],L==0?1:0,L==0?1:2,L==1?Ft:xt,L==1?bt:kt,Ue(Ht.width*Te,3),Ht.stroke(i,_),Ht.dash,Ht.cap)}gn("drawAxes")}function pr(_){y.forEach((M,R)=>{R>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let aa=!1,Gl=!1,Mo=[];function u_(){Gl=!1;for(let _=0;_<Mo.length;_++)gn(...Mo[_]);Mo.length=0}function mr(){aa||(Hv(Kh),aa=!0)}function h_(_,M=!1){aa=!0,Gl=M,_(i),Kh(),M&&Mo.length>0&&queueMicrotask(u_)}i.batch=h_;function Kh(){if(ae&&(Us(),ae=!1),xe&&(ee(),xe=!1),jt){if(Ge(f,br,et),Ge(f,Eo,St),Ge(f,Oo,J),Ge(f,ko,$),Ge(g,br,et),Ge(g,Eo,St),Ge(g,Oo,J),Ge(g,ko,$),Ge(d,Oo,w),Ge(d,ko,j),u.width=rn(w*Te),u.height=rn(j*Te),E.forEach(({_el:_,_show:M,_size:R,_pos:L,side:O})=>{if(_!=null)if(M){let Y=O===3||O===0?R:0,st=O%2==1;Ge(_,st?"left":"top",L-Y),Ge(_,st?"width":"height",R),Ge(_,st?"top":"left",st?St:et),Ge(_,st?"height":"width",st?$:J),eu(_,Ks)}else jn(_,Ks)}),$t=qt=Ut=Ae=Ce=fn=ge=Bt=ue=null,$e=1,wo(!0),et!=vt||St!=Tt||J!=Jt||$!=ft){pr(!1);let _=J/Jt,M=$/ft;if(at&&!B&&mt.left>=0){mt.left*=_,mt.top*=M,gr&&Pi(gr,rn(mt.left),0,J,$),_r&&Pi(_r,0,rn(mt.top),J,$);for(let R=0;R<Sn.length;R++){let L=Sn[R];L!=null&&(Gi[R]*=_,Vi[R]*=M,Pi(L,oi(Gi[R]),oi(Vi[R]),J,$))}}if(ze.show&&!Mt&&ze.left>=0&&ze.width>0){ze.left*=_,ze.width*=_,ze.top*=M,ze.height*=M;for(let R in Yl)Ge(Mr,R,ze[R])}vt=et,Tt=St,Jt=J,ft=$}gn("setSize"),jt=!1}w>0&&j>0&&(h.clearRect(0,0,u.width,u.height),gn("drawClear"),I.forEach(_=>_()),gn("draw")),ze.show&&Mt&&(la(ze),Mt=!1),at&&B&&(Fs(null,!0,!1),B=!1),yt.show&&yt.live&&nt&&(Xl(),nt=!1),l||(l=!0,i.status=1,gn("ready")),wt=!1,aa=!1}i.redraw=(_,M)=>{xe=M||!1,_!==!1?hs(A,C.min,C.max):mr()};function Vl(_,M){let R=x[_];if(R.from==null){if(k==0){let L=R.range(i,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(k>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&R.distr==2&&k>0&&(M.min=vi(M.min,t[0]),M.max=vi(M.max,t[0]),M.min==M.max&&M.max++),Z[_]=M,ae=!0,mr()}}i.setScale=Vl;let Wl,$l,gr,_r,Zh,Jh,vr,xr,Qh,td,Be,Xe,us=!1;const Mn=mt.drag;let pn=Mn.x,mn=Mn.y;at&&(mt.x&&(Wl=si(hv,g)),mt.y&&($l=si(dv,g)),C.ori==0?(gr=Wl,_r=$l):(gr=$l,_r=Wl),Be=mt.left,Xe=mt.top);const ze=i.select=Qe({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Mr=ze.show?si(uv,ze.over?g:f):null;function la(_,M){if(ze.show){for(let R in _)ze[R]=_[R],R in Yl&&Ge(Mr,R,_[R]);M!==!1&&gn("setSelect")}}i.setSelect=la;function d_(_){if(y[_].show)it&&eu(Nt[_],Ks);else if(it&&jn(Nt[_],Ks),at){let R=Fn?Sn[0]:Sn[_];R!=null&&Pi(R,-10,-10,J,$)}}function hs(_,M,R){Vl(_,{min:M,max:R})}function Ti(_,M,R,L){M.focus!=null&&__(_),M.show!=null&&y.forEach((O,Y)=>{Y>0&&(_==Y||_==null)&&(O.show=M.show,d_(Y),s==2?(hs(O.facets[0].scale,null,null),hs(O.facets[1].scale,null,null)):hs(O.scale,null,null),mr())}),R!==!1&&gn("setSeries",_,M),L&&bo("setSeries",i,_,M)}i.setSeries=Ti;function f_(_,M){Qe(U[_],M)}function p_(_,M){_.fill=he(_.fill||null),_.dir=we(_.dir,-1),M=M??U.length,U.splice(M,0,_)}function m_(_){_==null?U.length=0:U.splice(_,1)}i.addBand=p_,i.setBand=f_,i.delBand=m_;function g_(_,M){y[_].alpha=M,at&&Sn[_]!=null&&(Sn[_].style.opacity=M),it&&Nt[_]&&(Nt[_].style.opacity=M)}let Wi,ds,Ns;const yr={focus:!0};function __(_){if(_!=Ns){let M=_==null,R=Vn.alpha!=1;y.forEach((L,O)=>{if(s==1||O>0){let Y=M||O==0||O==_;L._focus=M?null:Y,R&&g_(O,Y?1:Vn.alpha)}}),Ns=_,R&&mr()}}it&&Hi&&Lt(Hd,ot,_=>{mt._lock||(sn(_),Ns!=null&&Ti(null,yr,!0,Ze.setSeries))});function Ai(_,M,R){let L=x[M];R&&(_=_/Te-(L.ori==1?St:et));let O=J;L.ori==1&&(O=$,_=O-_),L.dir==-1&&(_=O-_);let Y=L._min,st=L._max,lt=_/O,pt=Y+(st-Y)*lt,Ct=L.distr;return Ct==3?Jr(10,pt):Ct==4?Cv(pt,L.asinh):Ct==100?L.bwd(pt):pt}function v_(_,M){let R=Ai(_,A,M);return vi(R,t[0],X,q)}i.valToIdx=_=>vi(_,t[0]),i.posToIdx=v_,i.posToVal=Ai,i.valToPos=(_,M,R)=>x[M].ori==0?r(_,x[M],R?kt:J,R?xt:0):o(_,x[M],R?bt:$,R?Ft:0),i.setCursor=(_,M,R)=>{Be=_.left,Xe=_.top,Fs(null,M,R)};function ed(_,M){Ge(Mr,br,ze.left=_),Ge(Mr,Oo,ze.width=M)}function nd(_,M){Ge(Mr,Eo,ze.top=_),Ge(Mr,ko,ze.height=M)}let yo=C.ori==0?ed:nd,So=C.ori==1?ed:nd;function x_(){if(it&&yt.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&me)continue;let M=yt.values[_],R=0;for(let L in M)pe[_][R++].firstChild.nodeValue=M[L]}}function Xl(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{gt[L]=R}):Iv(_.idx)||gt.fill(_.idx),yt.idx=gt[0]),it&&yt.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!me)&&M_(R,gt[R]);x_()}nt=!1,M!==!1&&gn("setLegend")}i.setLegend=Xl;function M_(_,M){let R=y[_],L=_==0&&V==2?ut:t[_],O;me?O=R.values(i,_,M)??H:(O=R.value(i,M==null?null:L[M],_,M),O=O==null?H:{_:O}),yt.values[_]=O}function Fs(_,M,R){Qh=Be,td=Xe,[Be,Xe]=mt.move(i,Be,Xe),mt.left=Be,mt.top=Xe,at&&(gr&&Pi(gr,rn(Be),0,J,$),_r&&Pi(_r,0,rn(Xe),J,$));let L,O=X>q;Wi=Ie,ds=null;let Y=C.ori==0?J:$,st=C.ori==1?J:$;if(Be<0||k==0||O){L=mt.idx=null;for(let lt=0;lt<y.length;lt++){let pt=Sn[lt];pt!=null&&Pi(pt,-10,-10,J,$)}Hi&&Ti(null,yr,!0,_==null&&Ze.setSeries),yt.live&&(gt.fill(L),nt=!0)}else{let lt,pt,Ct;s==1&&(lt=C.ori==0?Be:Xe,pt=Ai(lt,A),L=mt.idx=vi(pt,t[0],X,q),Ct=F(t[0][L],C,Y,0));let Pt=-10,Dt=-10,Kt=0,Ee=0,Se=!0,le="",Xt="";for(let Ht=s==2?1:0;Ht<y.length;Ht++){let He=y[Ht],Ye=gt[Ht],_n=Ye==null?null:s==1?t[Ht][Ye]:t[Ht][1][Ye],Pe=mt.dataIdx(i,Ht,L,pt),je=Pe==null?null:s==1?t[Ht][Pe]:t[Ht][1][Pe];if(nt=nt||je!=_n||Pe!=Ye,gt[Ht]=Pe,Ht>0&&He.show){let Wn=Pe==null?-10:Pe==L?Ct:F(s==1?t[0][Pe]:t[Ht][0][Pe],C,Y,0),Pn=je==null?-10:W(je,s==1?x[He.scale]:x[He.facets[1].scale],st,0);if(Hi&&je!=null){let ei=C.ori==1?Be:Xe,di=on(Vn.dist(i,Ht,Pe,Pn,ei));if(di<Wi){let Ri=Vn.bias;if(Ri!=0){let $n=Ai(ei,He.scale),ni=je>=0?1:-1,fi=$n>=0?1:-1;fi==ni&&(fi==1?Ri==1?je>=$n:je<=$n:Ri==1?je<=$n:je>=$n)&&(Wi=di,ds=Ht)}else Wi=di,ds=Ht}}if(nt||Fn){let ei,di;C.ori==0?(ei=Wn,di=Pn):(ei=Pn,di=Wn);let Ri,$n,ni,fi,Ci,Ln,Xn=!0,Os=Fe.bbox;if(Os!=null){Xn=!1;let Dn=Os(i,Ht);ni=Dn.left,fi=Dn.top,Ri=Dn.width,$n=Dn.height}else ni=ei,fi=di,Ri=$n=Fe.size(i,Ht);if(Ln=Fe.fill(i,Ht),Ci=Fe.stroke(i,Ht),Fn)Ht==ds&&Wi<=Vn.prox&&(Pt=ni,Dt=fi,Kt=Ri,Ee=$n,Se=Xn,le=Ln,Xt=Ci);else{let Dn=Sn[Ht];Dn!=null&&(Gi[Ht]=ni,Vi[Ht]=fi,Yd(Dn,Ri,$n,Xn),Xd(Dn,Ln,Ci),Pi(Dn,oi(ni),oi(fi),J,$))}}}}if(Fn){let Ht=Vn.prox,He=Ns==null?Wi<=Ht:Wi>Ht||ds!=Ns;if(nt||He){let Ye=Sn[0];Ye!=null&&(Gi[0]=Pt,Vi[0]=Dt,Yd(Ye,Kt,Ee,Se),Xd(Ye,le,Xt),Pi(Ye,oi(Pt),oi(Dt),J,$))}}}if(ze.show&&us)if(_!=null){let[lt,pt]=Ze.scales,[Ct,Pt]=Ze.match,[Dt,Kt]=_.cursor.sync.scales,Ee=_.cursor.drag;if(pn=Ee._x,mn=Ee._y,pn||mn){let{left:Se,top:le,width:Xt,height:Ht}=_.select,He=_.scales[Dt].ori,Ye=_.posToVal,_n,Pe,je,Wn,Pn,ei=lt!=null&&Ct(lt,Dt),di=pt!=null&&Pt(pt,Kt);ei&&pn?(He==0?(_n=Se,Pe=Xt):(_n=le,Pe=Ht),je=x[lt],Wn=F(Ye(_n,Dt),je,Y,0),Pn=F(Ye(_n+Pe,Dt),je,Y,0),yo(xi(Wn,Pn),on(Pn-Wn))):yo(0,Y),di&&mn?(He==1?(_n=Se,Pe=Xt):(_n=le,Pe=Ht),je=x[pt],Wn=W(Ye(_n,Kt),je,st,0),Pn=W(Ye(_n+Pe,Kt),je,st,0),So(xi(Wn,Pn),on(Pn-Wn))):So(0,st)}else jl()}else{let lt=on(Qh-Zh),pt=on(td-Jh);if(C.ori==1){let Kt=lt;lt=pt,pt=Kt}pn=Mn.x&&lt>=Mn.dist,mn=Mn.y&&pt>=Mn.dist;let Ct=Mn.uni;Ct!=null?pn&&mn&&(pn=lt>=Ct,mn=pt>=Ct,!pn&&!mn&&(pt>lt?mn=!0:pn=!0)):Mn.x&&Mn.y&&(pn||mn)&&(pn=mn=!0);let Pt,Dt;pn&&(C.ori==0?(Pt=vr,Dt=Be):(Pt=xr,Dt=Xe),yo(xi(Pt,Dt),on(Dt-Pt)),mn||So(0,st)),mn&&(C.ori==1?(Pt=vr,Dt=Be):(Pt=xr,Dt=Xe),So(xi(Pt,Dt),on(Dt-Pt)),pn||yo(0,Y)),!pn&&!mn&&(yo(0,0),So(0,0))}if(Mn._x=pn,Mn._y=mn,_==null){if(R){if(fd!=null){let[lt,pt]=Ze.scales;Ze.values[0]=lt!=null?Ai(C.ori==0?Be:Xe,lt):null,Ze.values[1]=pt!=null?Ai(C.ori==1?Be:Xe,pt):null}bo(ic,i,Be,Xe,J,$,L)}if(Hi){let lt=R&&Ze.setSeries,pt=Vn.prox;Ns==null?Wi<=pt&&Ti(ds,yr,!0,lt):Wi>pt?Ti(null,yr,!0,lt):ds!=Ns&&Ti(ds,yr,!0,lt)}}nt&&(yt.idx=L,Xl()),M!==!1&&gn("setCursor")}let fs=null;Object.defineProperty(i,"rect",{get(){return fs==null&&wo(!1),fs}});function wo(_=!1){_?fs=null:(fs=g.getBoundingClientRect(),gn("syncRect",fs))}function id(_,M,R,L,O,Y,st){mt._lock||us&&_!=null&&_.movementX==0&&_.movementY==0||(ql(_,M,R,L,O,Y,st,!1,_!=null),_!=null?Fs(null,!0,!0):Fs(M,!0,!1))}function ql(_,M,R,L,O,Y,st,lt,pt){if(fs==null&&wo(!1),sn(_),_!=null)R=_.clientX-fs.left,L=_.clientY-fs.top;else{if(R<0||L<0){Be=-10,Xe=-10;return}let[Ct,Pt]=Ze.scales,Dt=M.cursor.sync,[Kt,Ee]=Dt.values,[Se,le]=Dt.scales,[Xt,Ht]=Ze.match,He=M.axes[0].side%2==1,Ye=C.ori==0?J:$,_n=C.ori==1?J:$,Pe=He?Y:O,je=He?O:Y,Wn=He?L:R,Pn=He?R:L;if(Se!=null?R=Xt(Ct,Se)?a(Kt,x[Ct],Ye,0):-10:R=Ye*(Wn/Pe),le!=null?L=Ht(Pt,le)?a(Ee,x[Pt],_n,0):-10:L=_n*(Pn/je),C.ori==1){let ei=R;R=L,L=ei}}pt&&(M==null||M.cursor.event.type==ic)&&((R<=1||R>=J-1)&&(R=Xs(R,J)),(L<=1||L>=$-1)&&(L=Xs(L,$))),lt?(Zh=R,Jh=L,[vr,xr]=mt.move(i,R,L)):(Be=R,Xe=L)}const Yl={width:0,height:0,left:0,top:0};function jl(){la(Yl,!1)}let sd,rd,od,ad;function ld(_,M,R,L,O,Y,st){us=!0,pn=mn=Mn._x=Mn._y=!1,ql(_,M,R,L,O,Y,st,!0,!1),_!=null&&(Lt(sc,Qc,cd,!1),bo(Bd,i,vr,xr,J,$,null));let{left:lt,top:pt,width:Ct,height:Pt}=ze;sd=lt,rd=pt,od=Ct,ad=Pt}function cd(_,M,R,L,O,Y,st){us=Mn._x=Mn._y=!1,ql(_,M,R,L,O,Y,st,!1,!0);let{left:lt,top:pt,width:Ct,height:Pt}=ze,Dt=Ct>0||Pt>0,Kt=sd!=lt||rd!=pt||od!=Ct||ad!=Pt;if(Dt&&Kt&&la(ze),Mn.setScale&&Dt&&Kt){let Ee=lt,Se=Ct,le=pt,Xt=Pt;if(C.ori==1&&(Ee=pt,Se=Pt,le=lt,Xt=Ct),pn&&hs(A,Ai(Ee,A),Ai(Ee+Se,A)),mn)for(let Ht in x){let He=x[Ht];Ht!=A&&He.from==null&&He.min!=Ie&&hs(Ht,Ai(le+Xt,Ht),Ai(le,Ht))}jl()}else mt.lock&&(mt._lock=!mt._lock,Fs(M,!0,_!=null));_!=null&&(P(sc,Qc),bo(sc,i,Be,Xe,J,$,null))}function y_(_,M,R,L,O,Y,st){if(mt._lock)return;sn(_);let lt=us;if(us){let pt=!0,Ct=!0,Pt=10,Dt,Kt;C.ori==0?(Dt=pn,Kt=mn):(Dt=mn,Kt=pn),Dt&&Kt&&(pt=Be<=Pt||Be>=J-Pt,Ct=Xe<=Pt||Xe>=$-Pt),Dt&&pt&&(Be=Be<vr?0:J),Kt&&Ct&&(Xe=Xe<xr?0:$),Fs(null,!0,!0),us=!1}Be=-10,Xe=-10,gt.fill(null),Fs(null,!0,!0),lt&&(us=lt)}function ud(_,M,R,L,O,Y,st){mt._lock||(sn(_),It(),jl(),_!=null&&bo(Gd,i,Be,Xe,J,$,null))}function hd(){E.forEach(jx),rt(i.width,i.height,!0)}er(ul,$r,hd);const Sr={};Sr.mousedown=ld,Sr.mousemove=id,Sr.mouseup=cd,Sr.dblclick=ud,Sr.setSeries=(_,M,R,L)=>{let O=Ze.match[2];R=O(i,M,R),R!=-1&&Ti(R,L,!0,!1)},at&&(Lt(Bd,g,ld),Lt(ic,g,id),Lt(zd,g,_=>{sn(_),wo(!1)}),Lt(Hd,g,y_),Lt(Gd,g,ud),au.add(i),i.syncRect=wo);const ca=i.hooks=n.hooks||{};function gn(_,M,R){Gl?Mo.push([_,M,R]):_ in ca&&ca[_].forEach(L=>{L.call(null,i,M,R)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)ca[M]=(ca[M]||[]).concat(_.hooks[M])});const dd=(_,M,R)=>R,Ze=Qe({key:null,setSeries:!1,filters:{pub:Qd,sub:Qd},scales:[A,y[1]?y[1].scale:null],match:[tf,tf,dd],values:[null,null]},mt.sync);Ze.match.length==2&&Ze.match.push(dd),mt.sync=Ze;const fd=Ze.key,Kl=Xm(fd);function bo(_,M,R,L,O,Y,st){Ze.filters.pub(_,M,R,L,O,Y,st)&&Kl.pub(_,M,R,L,O,Y,st)}Kl.sub(i);function S_(_,M,R,L,O,Y,st){Ze.filters.sub(_,M,R,L,O,Y,st)&&Sr[_](null,M,R,L,O,Y,st)}i.pub=S_;function w_(){Kl.unsub(i),au.delete(i),ve.clear(),nu(ul,$r,hd),c.remove(),ot?.remove(),gn("destroy")}i.destroy=w_;function Zl(){gn("init",n,t),Ot(t||n.data,!1),Z[A]?Vl(A,Z[A]):It(),Mt=ze.show&&(ze.width>0||ze.height>0),B=nt=!0,rt(n.width,n.height)}return y.forEach(xo),E.forEach(zl),e?e instanceof HTMLElement?(e.appendChild(c),Zl()):e(i,Zl):Zl(),i}yn.assign=Qe;yn.fmtNum=bh;yn.rangeNum=hl;yn.rangeLog=Tl;yn.rangeAsinh=Sh;yn.orient=cr;yn.pxRatio=Te;yn.join=zv;yn.fmtDate=Th,yn.tzDate=Zv;yn.sync=Xm;{yn.addGap=Ix,yn.clipGaps=Cl;let n=yn.paths={points:Jm};n.linear=tg,n.stepped=Fx,n.bars=Ox,n.spline=Bx}const ps=n=>document.getElementById(n),Kx=["#7cc4ff","#56d6b0","#d59bf6","#ffb652","#f2f5f8","#ff7a5c"],[Zx,Jx]=["#ffb65238","#ffb652a0"],[Qx,tM]=[5.8,4.9],eM=3,[nM,iM]=[690,.78],sg=({curves:n},t)=>n[t].signal==="truth"&&n.some(e=>e.signal!=="truth")?"#f2f5f8":Kx[t];function wf(n){const t=10**Math.floor(Math.log10(n));return[8,6,5,4,3,2,1.5,1].map(e=>Number((e*t).toPrecision(2))).find(e=>e<=n*(1+1e-9))}function sM(n,t,e,i,s){const r=Math.round(yl(i)),o={stroke:"#a9b7c5",grid:{stroke:"#1b2733",width:1},ticks:{stroke:"#1b2733",size:4},font:`${r}px system-ui`},a={stroke:Jx,width:1,points:{show:!1}},l=n.curves.length+1,c=s?{}:{label:n.title,labelSize:r*1.35,labelFont:`${r}px system-ui`},u=n.centred&&s?{splits:(h,d,f,g)=>[-wf(g/1.1),0,wf(g/1.1)],values:(h,d)=>d.map(f=>f===0?"":String(f).replace("-","−"))}:{};return{width:t,height:e,legend:{show:!1},cursor:{show:!1},padding:[r*(n.names.length?1.2:.5),r*.5,0,0],hooks:{draw:[h=>oM(h,n,r)]},bands:[{series:[l,l+1],fill:Zx}],scales:{x:{time:!1},y:{range:(h,d,f)=>{if(!n.centred)return rM([d,f,...n.levels],n.least);const g=Math.max(Math.abs(d||0),Math.abs(f||0),n.least);return[-g*1.1,g*1.1]}}},axes:[{...o,size:r*1.7,gap:1,space:r*2.8},{...o,size:r*(s?2.8:3),gap:1,space:r*1.7,...u,...c}],series:[{},...n.curves.map((h,d)=>({stroke:sg(n,d),width:s?1.2:1.5,points:{show:!1}})),a,a]}}function rM(n,t){const e=n.filter(o=>Number.isFinite(o)),[i,s]=e.length?[Math.min(...e),Math.max(...e)]:[0,t],r=Math.max((s-i)*.06,(t-(s-i))/2);return[i-r,s+r]}function oM(n,t,e){const i=n.ctx,s=yn.pxRatio,{left:r,top:o,width:a}=n.bbox;i.save(),i.strokeStyle="#8aa4bd",i.lineWidth=s,i.setLineDash([3*s,3*s]);for(const c of t.levels){const u=n.valToPos(c,"y",!0);i.beginPath(),i.moveTo(r,u),i.lineTo(r+a,u),i.stroke()}i.font=`${e*s}px system-ui`,i.textBaseline="bottom",i.textAlign="right";let l=r+a-.4*e*s;for(let c=t.names.length-1;c>=0;c-=1)i.fillStyle=sg(t,c),i.fillText(t.names[c],l,o-.1*e*s),l-=i.measureText(t.names[c]).width+.9*e*s;i.restore()}class aM{constructor(t,e,i){if(Object.assign(this,{strip:t,window:e,beside:i,element:document.createElement("div"),place:document.createElement("div")}),this.element.classList.toggle("wide",!i),i){const s=document.createElement("span");s.textContent=t.title,this.element.append(s)}this.element.append(this.place)}size(){const t=parseFloat(getComputedStyle(document.documentElement).fontSize),e=Math.floor(this.element.clientWidth),i=Math.round((this.beside?tM:Qx)*t*(innerHeight<nM?iM:1));return this.reserved!==i&&(this.place.style.height=`${i}px`),this.reserved=i,{width:Math.max(e,60),height:i,rem:t}}show({t,curves:e,spread:i},s){const r=this.size();(!this.plot||this.width!==r.width||this.height!==r.height)&&(this.plot&&this.plot.destroy(),this.plot=new yn(sM(this.strip,r.width,r.height,r.rem,this.beside),[[],...e.map(()=>[]),[],[]],this.place),Object.assign(this,{width:r.width,height:r.height}));let o=t.length;if(s!==void 0)for(;o>0&&t[o-1]>s;)o-=1;let a=o;for(;a>0&&t[a-1]>(t[o-1]??0)-this.window;)a-=1;const l=u=>u.slice(a,o),c=l(i);this.plot.setData([l(t),...e.map(l),c,c.map(u=>u===null?null:-u)])}}class lM{constructor(){this.strips=[],addEventListener("resize",()=>this.strips.forEach(t=>t.size()))}setDisplay({charts:t}){ps("strips").hidden=!t,this.note=t?.note,this.strips=(t?.strips||[]).map(i=>new aM(i,t.window_s,t.columns>1&&!i.wide)),ps("charts").style.setProperty("--columns",t?.columns??1),ps("charts").replaceChildren(...this.strips.map(i=>i.element));for(const i of this.strips)i.size();ps("charts-title").textContent=t?.title||"";const e=[["line",t?.curve],["band",t?.band]].filter(([,i])=>i);ps("charts-key").hidden=e.length===0,ps("charts-key").replaceChildren(...e.map(([i,s])=>{const r=document.createElement("span");return r.className=i,r.textContent=s,r}))}blank({charts:t}){this.strips.forEach((e,i)=>e.show(t[i])),ps("charts-note").textContent=""}show(t,e,i){this.turn=!this.turn,this.strips.forEach((s,r)=>{(this.strips.length<=eM||s.plot===void 0||r%2===1===this.turn)&&s.show(t[r],i)}),this.note&&al(Zn(e,this.note)??["",!1],ps("charts-note"),"dim")}}const cM=.9;function uM([n,t]){const e=[n];for(;e[e.length-1]<t;)e.push(Math.min(2*e[e.length-1],t));return e}function hM({half_field:n,half_height_m:t},e,i){const s=uM(n),r=t/e,o=s.findIndex(l=>l>=r),a=o<0?s.length-1:o;return i===s[a+1]&&r>cM*s[a]?i:s[a]}const bf=n=>2*Math.atan(n)*180/Math.PI,Bs=n=>document.getElementById(n),dM=5e3,fM=["measured","predicted"],pM=(n,t)=>{const e=_e(n,t);return n>0&&Number(n.toFixed(t))!==0?`+${e}`:e};class mM{constructor(){this.height=0,new ResizeObserver(([t])=>{this.height=t.borderBoxSize[0].blockSize}).observe(Bs("digits"))}setDisplay(t){const e=t?.numbers;if(Bs("digits").hidden=!e,Object.assign(this,{cells:[],tan:void 0,changedAt:-1/0}),Oe(Bs("camera-field"),""),!e)return;const i=fM.filter(a=>e.rows.some(l=>[...l.place,...l.rate].some(c=>c.role===a)));Bs("digits").style.setProperty("--digits",i.length);const s=[],r=(a,l,c)=>i.map(u=>{const h=s[s.push(document.createElement("b"))-1];h.className=u;const d=a.find(f=>f.role===u);return h.textContent=d?N.unknown:"",d&&this.cells.push({cell:h,reading:d,digits:l,isSigned:c}),h}),o=(a,l="")=>{Object.assign(s[s.push(document.createElement("span"))-1],{textContent:a,className:l})};for(const a of[e.place_unit,e.rate_unit])["",...i.map((l,c)=>c?"":a)].forEach(l=>o(l,"unit"));for(const a of e.rows)o(a.label),r(a.place,e.place_digits,a.signed),o(a.rate_label),r(a.rate,e.rate_digits,a.signed&&!a.rate_label);Bs("digits").replaceChildren(...s)}show(t,e){for(const{cell:i,reading:s,digits:r,isSigned:o}of this.cells){const a=t?Rn(t,s.value):void 0;Oe(i,a===void 0?N.unknown:o?pM(a,r):_e(a,r)),i.classList.toggle("stale-value",!!e&&s.role==="measured")}}field(t){if(t===void 0)return;const e=performance.now();this.tan!==void 0&&t!==this.tan&&Object.assign(this,{changedAt:e,was:this.tan}),this.tan=t;const i=e-this.changedAt<dM,s=Yt(N.field,{deg:_e(bf(t),0)});Oe(Bs("camera-field"),i?`${s} ${Yt(N.field_was,{deg:_e(bf(this.was),0)})}`:s),Bs("camera-field").classList.toggle("news",i)}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Ih="170",gM=0,Ef=1,_M=2,rg=1,vM=2,Zi=3,Cs=0,zn=1,Di=2,bs=0,Xr=1,Tf=2,Af=3,Rf=4,xM=5,Zs=100,MM=101,yM=102,SM=103,wM=104,bM=200,EM=201,TM=202,AM=203,cu=204,uu=205,RM=206,CM=207,PM=208,LM=209,DM=210,IM=211,UM=212,NM=213,FM=214,hu=0,du=1,fu=2,no=3,pu=4,mu=5,gu=6,_u=7,Uh=0,OM=1,kM=2,Es=0,BM=1,zM=2,HM=3,GM=4,VM=5,WM=6,$M=7,og=300,io=301,so=302,vu=303,xu=304,Il=306,Mu=1e3,Qs=1001,yu=1002,Si=1003,XM=1004,ma=1005,Ni=1006,cc=1007,tr=1008,os=1009,ag=1010,lg=1011,Yo=1012,Nh=1013,or=1014,ts=1015,Jo=1016,Fh=1017,Oh=1018,ro=1020,cg=35902,ug=1021,hg=1022,Mi=1023,dg=1024,fg=1025,qr=1026,oo=1027,pg=1028,kh=1029,mg=1030,Bh=1031,zh=1033,Ja=33776,Qa=33777,tl=33778,el=33779,Su=35840,wu=35841,bu=35842,Eu=35843,Tu=36196,Au=37492,Ru=37496,Cu=37808,Pu=37809,Lu=37810,Du=37811,Iu=37812,Uu=37813,Nu=37814,Fu=37815,Ou=37816,ku=37817,Bu=37818,zu=37819,Hu=37820,Gu=37821,nl=36492,Vu=36494,Wu=36495,gg=36283,$u=36284,Xu=36285,qu=36286,qM=3200,YM=3201,_g=0,jM=1,Ss="",ai="srgb",ur="srgb-linear",Ul="linear",Le="srgb",Er=7680,Cf=519,KM=512,ZM=513,JM=514,vg=515,QM=516,ty=517,ey=518,ny=519,Pf=35044,Lf="300 es",es=2e3,fl=2001;class fo{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const i=this._listeners;return i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const i=this._listeners[t.type];if(i!==void 0){t.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],il=Math.PI/180,Yu=180/Math.PI;function Qo(){const n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(bn[n&255]+bn[n>>8&255]+bn[n>>16&255]+bn[n>>24&255]+"-"+bn[t&255]+bn[t>>8&255]+"-"+bn[t>>16&15|64]+bn[t>>24&255]+"-"+bn[e&63|128]+bn[e>>8&255]+"-"+bn[e>>16&255]+bn[e>>24&255]+bn[i&255]+bn[i>>8&255]+bn[i>>16&255]+bn[i>>24&255]).toLowerCase()}function Un(n,t,e){return Math.max(t,Math.min(e,n))}function iy(n,t){return(n%t+t)%t}function uc(n,t,e){return(1-e)*n+e*t}function Ao(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function kn(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}class fe{constructor(t=0,e=0){fe.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Un(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class ie{constructor(t,e,i,s,r,o,a,l,c){ie.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],g=i[8],v=s[0],m=s[3],p=s[6],y=s[1],E=s[4],x=s[7],U=s[2],A=s[5],D=s[8];return r[0]=o*v+a*y+l*U,r[3]=o*m+a*E+l*A,r[6]=o*p+a*x+l*D,r[1]=c*v+u*y+h*U,r[4]=c*m+u*E+h*A,r[7]=c*p+u*x+h*D,r[2]=d*v+f*y+g*U,r[5]=d*m+f*E+g*A,r[8]=d*p+f*x+g*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,g=e*h+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return t[0]=h*v,t[1]=(s*c-u*i)*v,t[2]=(a*i-s*o)*v,t[3]=d*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=f*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(hc.makeScale(t,e)),this}rotate(t){return this.premultiply(hc.makeRotation(-t)),this}translate(t,e){return this.premultiply(hc.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const hc=new ie;function xg(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function pl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function sy(){const n=pl("canvas");return n.style.display="block",n}const Df={};function zo(n){n in Df||(Df[n]=!0,console.warn(n))}function ry(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}function oy(n){const t=n.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function ay(n){const t=n.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const ye={enabled:!0,workingColorSpace:ur,spaces:{},convert:function(n,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Le&&(n.r=ss(n.r),n.g=ss(n.g),n.b=ss(n.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(n.applyMatrix3(this.spaces[t].toXYZ),n.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Le&&(n.r=Yr(n.r),n.g=Yr(n.g),n.b=Yr(n.b))),n},fromWorkingColorSpace:function(n,t){return this.convert(n,this.workingColorSpace,t)},toWorkingColorSpace:function(n,t){return this.convert(n,t,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===Ss?Ul:this.spaces[n].transfer},getLuminanceCoefficients:function(n,t=this.workingColorSpace){return n.fromArray(this.spaces[t].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,t,e){return n.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}};function ss(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Yr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}const If=[.64,.33,.3,.6,.15,.06],Uf=[.2126,.7152,.0722],Nf=[.3127,.329],Ff=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Of=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ye.define({[ur]:{primaries:If,whitePoint:Nf,transfer:Ul,toXYZ:Ff,fromXYZ:Of,luminanceCoefficients:Uf,workingColorSpaceConfig:{unpackColorSpace:ai},outputColorSpaceConfig:{drawingBufferColorSpace:ai}},[ai]:{primaries:If,whitePoint:Nf,transfer:Le,toXYZ:Ff,fromXYZ:Of,luminanceCoefficients:Uf,outputColorSpaceConfig:{drawingBufferColorSpace:ai}}});let Tr;class ly{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{Tr===void 0&&(Tr=pl("canvas")),Tr.width=t.width,Tr.height=t.height;const i=Tr.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),e=Tr}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=pl("canvas");e.width=t.width,e.height=t.height;const i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);const s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ss(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ss(e[i]/255)*255):e[i]=ss(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let cy=0;class Mg{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:cy++}),this.uuid=Qo(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(dc(s[o].image)):r.push(dc(s[o]))}else r=dc(s);i.url=r}return e||(t.images[this.uuid]=i),i}}function dc(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?ly.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let uy=0;class Hn extends fo{constructor(t=Hn.DEFAULT_IMAGE,e=Hn.DEFAULT_MAPPING,i=Qs,s=Qs,r=Ni,o=tr,a=Mi,l=os,c=Hn.DEFAULT_ANISOTROPY,u=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:uy++}),this.uuid=Qo(),this.name="",this.source=new Mg(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new fe(0,0),this.repeat=new fe(1,1),this.center=new fe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const i={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==og)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Mu:t.x=t.x-Math.floor(t.x);break;case Qs:t.x=t.x<0?0:1;break;case yu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Mu:t.y=t.y-Math.floor(t.y);break;case Qs:t.y=t.y<0?0:1;break;case yu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Hn.DEFAULT_IMAGE=null;Hn.DEFAULT_MAPPING=og;Hn.DEFAULT_ANISOTROPY=1;class qe{constructor(t=0,e=0,i=0,s=1){qe.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const E=(c+1)/2,x=(f+1)/2,U=(p+1)/2,A=(u+d)/4,D=(h+v)/4,I=(g+m)/4;return E>x&&E>U?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=A/i,r=D/i):x>U?x<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),i=A/s,r=I/s):U<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(U),i=D/r,s=I/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(d-u)*(d-u));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(h-v)/y,this.z=(d-u)/y,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class hy extends fo{constructor(t=1,e=1,i={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new qe(0,0,t,e),this.scissorTest=!1,this.viewport=new qe(0,0,t,e);const s={width:t,height:e,depth:1};i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ni,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},i);const r=new Hn(s,i.mapping,i.wrapS,i.wrapT,i.magFilter,i.minFilter,i.format,i.type,i.anisotropy,i.colorSpace);r.flipY=!1,r.generateMipmaps=i.generateMipmaps,r.internalFormat=i.internalFormat,this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.depthTexture=i.depthTexture,this.samples=i.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let i=0,s=t.textures.length;i<s;i++)this.textures[i]=t.textures[i].clone(),this.textures[i].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new Mg(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class ar extends hy{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}}class yg extends Hn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Si,this.minFilter=Si,this.wrapR=Qs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class dy extends Hn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Si,this.minFilter=Si,this.wrapR=Qs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class ls{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3];const d=r[o+0],f=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=d,t[e+1]=f,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==d||c!==f||u!==g){let m=1-a;const p=l*d+c*f+u*g+h*v,y=p>=0?1:-1,E=1-p*p;if(E>Number.EPSILON){const U=Math.sqrt(E),A=Math.atan2(U,p*y);m=Math.sin(m*A)/U,a=Math.sin(a*A)/U}const x=a*y;if(l=l*m+d*x,c=c*m+f*x,u=u*m+g*x,h=h*m+v*x,m===1-a){const U=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=U,c*=U,u*=U,h*=U}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*f-c*d,t[e+1]=l*g+u*d+c*h-a*f,t[e+2]=c*g+u*f+a*d-l*h,t[e+3]=u*g-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"YZX":this._x=d*u*h+c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h-d*f*g;break;case"XZY":this._x=d*u*h-c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h+d*f*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){const f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){const f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){const f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{const f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<Number.EPSILON?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Un(this.dot(t),-1,1)))}rotateTowards(t,e){const i=this.angleTo(t);if(i===0)return this;const s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const f=1-e;return this._w=f*o+e*this._w,this._x=f*i+e*this._x,this._y=f*s+e*this._y,this._z=f*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,d=Math.sin(e*u)/c;return this._w=o*h+this._w*d,this._x=i*h+this._x*d,this._y=s*h+this._y*d,this._z=r*h+this._z*d,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class z{constructor(t=0,e=0,i=0){z.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(kf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(kf.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return fc.copy(this).projectOnVector(t),this.sub(fc)}reflect(t){return this.sub(fc.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(Un(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){const s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const fc=new z,kf=new ls;class po{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const i=pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const i=t.geometry;if(i!==void 0){const r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,pi):pi.fromBufferAttribute(r,o),pi.applyMatrix4(t.matrixWorld),this.expandByPoint(pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ga.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ga.copy(i.boundingBox)),ga.applyMatrix4(t.matrixWorld),this.union(ga)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,pi),pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ro),_a.subVectors(this.max,Ro),Ar.subVectors(t.a,Ro),Rr.subVectors(t.b,Ro),Cr.subVectors(t.c,Ro),ms.subVectors(Rr,Ar),gs.subVectors(Cr,Rr),zs.subVectors(Ar,Cr);let e=[0,-ms.z,ms.y,0,-gs.z,gs.y,0,-zs.z,zs.y,ms.z,0,-ms.x,gs.z,0,-gs.x,zs.z,0,-zs.x,-ms.y,ms.x,0,-gs.y,gs.x,0,-zs.y,zs.x,0];return!pc(e,Ar,Rr,Cr,_a)||(e=[1,0,0,0,1,0,0,0,1],!pc(e,Ar,Rr,Cr,_a))?!1:(va.crossVectors(ms,gs),e=[va.x,va.y,va.z],pc(e,Ar,Rr,Cr,_a))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Xi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Xi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Xi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Xi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Xi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Xi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Xi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Xi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Xi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Xi=[new z,new z,new z,new z,new z,new z,new z,new z],pi=new z,ga=new po,Ar=new z,Rr=new z,Cr=new z,ms=new z,gs=new z,zs=new z,Ro=new z,_a=new z,va=new z,Hs=new z;function pc(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Hs.fromArray(n,r);const a=s.x*Math.abs(Hs.x)+s.y*Math.abs(Hs.y)+s.z*Math.abs(Hs.z),l=t.dot(Hs),c=e.dot(Hs),u=i.dot(Hs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const fy=new po,Co=new z,mc=new z;class ta{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const i=this.center;e!==void 0?i.copy(e):fy.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Co.subVectors(t,this.center);const e=Co.lengthSq();if(e>this.radius*this.radius){const i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Co,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(mc.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Co.copy(t.center).add(mc)),this.expandByPoint(Co.copy(t.center).sub(mc))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const qi=new z,gc=new z,xa=new z,_s=new z,_c=new z,Ma=new z,vc=new z;class Hh{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,qi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=qi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(qi.copy(this.origin).addScaledVector(this.direction,e),qi.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){gc.copy(t).add(e).multiplyScalar(.5),xa.copy(e).sub(t).normalize(),_s.copy(this.origin).sub(gc);const r=t.distanceTo(e)*.5,o=-this.direction.dot(xa),a=_s.dot(this.direction),l=-_s.dot(xa),c=_s.lengthSq(),u=Math.abs(1-o*o);let h,d,f,g;if(u>0)if(h=o*l-a,d=o*a-l,g=r*u,h>=0)if(d>=-g)if(d<=g){const v=1/u;h*=v,d*=v,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=g?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(gc).addScaledVector(xa,d),f}intersectSphere(t,e){qi.subVectors(t.center,this.origin);const i=qi.dot(this.direction),s=qi.dot(qi)-i*i,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){const i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,qi)!==null}intersectTriangle(t,e,i,s,r){_c.subVectors(e,t),Ma.subVectors(i,t),vc.crossVectors(_c,Ma);let o=this.direction.dot(vc),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;_s.subVectors(this.origin,t);const l=a*this.direction.dot(Ma.crossVectors(_s,Ma));if(l<0)return null;const c=a*this.direction.dot(_c.cross(_s));if(c<0||l+c>o)return null;const u=-a*_s.dot(vc);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class ke{constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,g,v,m){ke.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,g,v,m)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,g,v,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=d,p[3]=f,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new ke().fromArray(this.elements)}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){const e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,i=t.elements,s=1/Pr.setFromMatrixColumn(t,0).length(),r=1/Pr.setFromMatrixColumn(t,1).length(),o=1/Pr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const d=o*u,f=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+g*c,e[5]=d-v*c,e[9]=-a*l,e[2]=v-d*c,e[6]=g+f*c,e[10]=o*l}else if(t.order==="YXZ"){const d=l*u,f=l*h,g=c*u,v=c*h;e[0]=d+v*a,e[4]=g*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-g,e[6]=v+d*a,e[10]=o*l}else if(t.order==="ZXY"){const d=l*u,f=l*h,g=c*u,v=c*h;e[0]=d-v*a,e[4]=-o*h,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*u,e[9]=v-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const d=o*u,f=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-f,e[8]=d*c+v,e[1]=l*h,e[5]=v*c+d,e[9]=f*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const d=o*l,f=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-d*h,e[8]=g*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+g,e[10]=d-v*h}else if(t.order==="XZY"){const d=o*l,f=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+v,e[5]=o*u,e[9]=f*h-g,e[2]=g*h-f,e[6]=a*u,e[10]=v*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(py,t,my)}lookAt(t,e,i){const s=this.elements;return qn.subVectors(t,e),qn.lengthSq()===0&&(qn.z=1),qn.normalize(),vs.crossVectors(i,qn),vs.lengthSq()===0&&(Math.abs(i.z)===1?qn.x+=1e-4:qn.z+=1e-4,qn.normalize(),vs.crossVectors(i,qn)),vs.normalize(),ya.crossVectors(qn,vs),s[0]=vs.x,s[4]=ya.x,s[8]=qn.x,s[1]=vs.y,s[5]=ya.y,s[9]=qn.y,s[2]=vs.z,s[6]=ya.z,s[10]=qn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],g=i[2],v=i[6],m=i[10],p=i[14],y=i[3],E=i[7],x=i[11],U=i[15],A=s[0],D=s[4],I=s[8],T=s[12],S=s[1],C=s[5],V=s[9],F=s[13],W=s[2],Z=s[6],K=s[10],Q=s[14],tt=s[3],ht=s[7],ct=s[11],gt=s[15];return r[0]=o*A+a*S+l*W+c*tt,r[4]=o*D+a*C+l*Z+c*ht,r[8]=o*I+a*V+l*K+c*ct,r[12]=o*T+a*F+l*Q+c*gt,r[1]=u*A+h*S+d*W+f*tt,r[5]=u*D+h*C+d*Z+f*ht,r[9]=u*I+h*V+d*K+f*ct,r[13]=u*T+h*F+d*Q+f*gt,r[2]=g*A+v*S+m*W+p*tt,r[6]=g*D+v*C+m*Z+p*ht,r[10]=g*I+v*V+m*K+p*ct,r[14]=g*T+v*F+m*Q+p*gt,r[3]=y*A+E*S+x*W+U*tt,r[7]=y*D+E*C+x*Z+U*ht,r[11]=y*I+E*V+x*K+U*ct,r[15]=y*T+E*F+x*Q+U*gt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*d+i*c*d+s*a*f-i*l*f)+v*(+e*l*f-e*c*d+r*o*d-s*o*f+s*c*u-r*l*u)+m*(+e*c*h-e*a*f-r*o*h+i*o*f+r*a*u-i*c*u)+p*(-s*a*u-e*l*h+e*a*d+s*o*h-i*o*d+i*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],g=t[12],v=t[13],m=t[14],p=t[15],y=h*m*c-v*d*c+v*l*f-a*m*f-h*l*p+a*d*p,E=g*d*c-u*m*c-g*l*f+o*m*f+u*l*p-o*d*p,x=u*v*c-g*h*c+g*a*f-o*v*f-u*a*p+o*h*p,U=g*h*l-u*v*l-g*a*d+o*v*d+u*a*m-o*h*m,A=e*y+i*E+s*x+r*U;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/A;return t[0]=y*D,t[1]=(v*d*r-h*m*r-v*s*f+i*m*f+h*s*p-i*d*p)*D,t[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*p+i*l*p)*D,t[3]=(h*l*r-a*d*r-h*s*c+i*d*c+a*s*f-i*l*f)*D,t[4]=E*D,t[5]=(u*m*r-g*d*r+g*s*f-e*m*f-u*s*p+e*d*p)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*D,t[7]=(o*d*r-u*l*r+u*s*c-e*d*c-o*s*f+e*l*f)*D,t[8]=x*D,t[9]=(g*h*r-u*v*r-g*i*f+e*v*f+u*i*p-e*h*p)*D,t[10]=(o*v*r-g*a*r+g*i*c-e*v*c-o*i*p+e*a*p)*D,t[11]=(u*a*r-o*h*r-u*i*c+e*h*c+o*i*f-e*a*f)*D,t[12]=U*D,t[13]=(u*v*s-g*h*s+g*i*d-e*v*d-u*i*m+e*h*m)*D,t[14]=(g*a*s-o*v*s-g*i*l+e*v*l+o*i*m-e*a*m)*D,t[15]=(o*h*s-u*a*s+u*i*l-e*h*l-o*i*d+e*a*d)*D,this}scale(t){const e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,g=r*h,v=o*u,m=o*h,p=a*h,y=l*c,E=l*u,x=l*h,U=i.x,A=i.y,D=i.z;return s[0]=(1-(v+p))*U,s[1]=(f+x)*U,s[2]=(g-E)*U,s[3]=0,s[4]=(f-x)*A,s[5]=(1-(d+p))*A,s[6]=(m+y)*A,s[7]=0,s[8]=(g+E)*D,s[9]=(m-y)*D,s[10]=(1-(d+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){const s=this.elements;let r=Pr.set(s[0],s[1],s[2]).length();const o=Pr.set(s[4],s[5],s[6]).length(),a=Pr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],mi.copy(this);const c=1/r,u=1/o,h=1/a;return mi.elements[0]*=c,mi.elements[1]*=c,mi.elements[2]*=c,mi.elements[4]*=u,mi.elements[5]*=u,mi.elements[6]*=u,mi.elements[8]*=h,mi.elements[9]*=h,mi.elements[10]*=h,e.setFromRotationMatrix(mi),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=es){const l=this.elements,c=2*r/(e-t),u=2*r/(i-s),h=(e+t)/(e-t),d=(i+s)/(i-s);let f,g;if(a===es)f=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===fl)f=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=f,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=es){const l=this.elements,c=1/(e-t),u=1/(i-s),h=1/(o-r),d=(e+t)*c,f=(i+s)*u;let g,v;if(a===es)g=(o+r)*h,v=-2*h;else if(a===fl)g=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-d,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-f,l[2]=0,l[6]=0,l[10]=v,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}}const Pr=new z,mi=new ke,py=new z(0,0,0),my=new z(1,1,1),vs=new z,ya=new z,qn=new z,Bf=new ke,zf=new ls;class zi{constructor(t=0,e=0,i=0,s=zi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Un(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Un(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Un(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Un(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Un(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Un(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Bf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Bf,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return zf.setFromEuler(this),this.setFromQuaternion(zf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}zi.DEFAULT_ORDER="XYZ";class Sg{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let gy=0;const Hf=new z,Lr=new ls,Yi=new ke,Sa=new z,Po=new z,_y=new z,vy=new ls,Gf=new z(1,0,0),Vf=new z(0,1,0),Wf=new z(0,0,1),$f={type:"added"},xy={type:"removed"},Dr={type:"childadded",child:null},xc={type:"childremoved",child:null};class an extends fo{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:gy++}),this.uuid=Qo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=an.DEFAULT_UP.clone();const t=new z,e=new zi,i=new ls,s=new z(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ke},normalMatrix:{value:new ie}}),this.matrix=new ke,this.matrixWorld=new ke,this.matrixAutoUpdate=an.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=an.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Sg,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Lr.setFromAxisAngle(t,e),this.quaternion.multiply(Lr),this}rotateOnWorldAxis(t,e){return Lr.setFromAxisAngle(t,e),this.quaternion.premultiply(Lr),this}rotateX(t){return this.rotateOnAxis(Gf,t)}rotateY(t){return this.rotateOnAxis(Vf,t)}rotateZ(t){return this.rotateOnAxis(Wf,t)}translateOnAxis(t,e){return Hf.copy(t).applyQuaternion(this.quaternion),this.position.add(Hf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Gf,t)}translateY(t){return this.translateOnAxis(Vf,t)}translateZ(t){return this.translateOnAxis(Wf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Yi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Sa.copy(t):Sa.set(t,e,i);const s=this.parent;this.updateWorldMatrix(!0,!1),Po.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Yi.lookAt(Po,Sa,this.up):Yi.lookAt(Sa,Po,this.up),this.quaternion.setFromRotationMatrix(Yi),s&&(Yi.extractRotation(s.matrixWorld),Lr.setFromRotationMatrix(Yi),this.quaternion.premultiply(Lr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent($f),Dr.child=t,this.dispatchEvent(Dr),Dr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(xy),xc.child=t,this.dispatchEvent(xc),xc.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Yi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Yi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Yi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent($f),Dr.child=t,this.dispatchEvent(Dr),Dr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Po,t,_y),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Po,vy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){const i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){const s=t.children[i];this.add(s.clone())}return this}}an.DEFAULT_UP=new z(0,1,0);an.DEFAULT_MATRIX_AUTO_UPDATE=!0;an.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const gi=new z,ji=new z,Mc=new z,Ki=new z,Ir=new z,Ur=new z,Xf=new z,yc=new z,Sc=new z,wc=new z,bc=new qe,Ec=new qe,Tc=new qe;class li{constructor(t=new z,e=new z,i=new z){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),gi.subVectors(t,e),s.cross(gi);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){gi.subVectors(s,e),ji.subVectors(i,e),Mc.subVectors(t,e);const o=gi.dot(gi),a=gi.dot(ji),l=gi.dot(Mc),c=ji.dot(ji),u=ji.dot(Mc),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const d=1/h,f=(c*l-a*u)*d,g=(o*u-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Ki)===null?!1:Ki.x>=0&&Ki.y>=0&&Ki.x+Ki.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Ki)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ki.x),l.addScaledVector(o,Ki.y),l.addScaledVector(a,Ki.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return bc.setScalar(0),Ec.setScalar(0),Tc.setScalar(0),bc.fromBufferAttribute(t,e),Ec.fromBufferAttribute(t,i),Tc.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(bc,r.x),o.addScaledVector(Ec,r.y),o.addScaledVector(Tc,r.z),o}static isFrontFacing(t,e,i,s){return gi.subVectors(i,e),ji.subVectors(t,e),gi.cross(ji).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return gi.subVectors(this.c,this.b),ji.subVectors(this.a,this.b),gi.cross(ji).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return li.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return li.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return li.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return li.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return li.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const i=this.a,s=this.b,r=this.c;let o,a;Ir.subVectors(s,i),Ur.subVectors(r,i),yc.subVectors(t,i);const l=Ir.dot(yc),c=Ur.dot(yc);if(l<=0&&c<=0)return e.copy(i);Sc.subVectors(t,s);const u=Ir.dot(Sc),h=Ur.dot(Sc);if(u>=0&&h<=u)return e.copy(s);const d=l*h-u*c;if(d<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(i).addScaledVector(Ir,o);wc.subVectors(t,r);const f=Ir.dot(wc),g=Ur.dot(wc);if(g>=0&&f<=g)return e.copy(r);const v=f*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(Ur,a);const m=u*g-f*h;if(m<=0&&h-u>=0&&f-g>=0)return Xf.subVectors(r,s),a=(h-u)/(h-u+(f-g)),e.copy(s).addScaledVector(Xf,a);const p=1/(m+v+d);return o=v*p,a=d*p,e.copy(i).addScaledVector(Ir,o).addScaledVector(Ur,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const wg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},xs={h:0,s:0,l:0},wa={h:0,s:0,l:0};function Ac(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}class de{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ai){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.toWorkingColorSpace(this,e),this}setRGB(t,e,i,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=i,ye.toWorkingColorSpace(this,s),this}setHSL(t,e,i,s=ye.workingColorSpace){if(t=iy(t,1),e=Un(e,0,1),i=Un(i,0,1),e===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Ac(o,r,t+1/3),this.g=Ac(o,r,t),this.b=Ac(o,r,t-1/3)}return ye.toWorkingColorSpace(this,s),this}setStyle(t,e=ai){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ai){const i=wg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ss(t.r),this.g=ss(t.g),this.b=ss(t.b),this}copyLinearToSRGB(t){return this.r=Yr(t.r),this.g=Yr(t.g),this.b=Yr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ai){return ye.fromWorkingColorSpace(En.copy(this),t),Math.round(Un(En.r*255,0,255))*65536+Math.round(Un(En.g*255,0,255))*256+Math.round(Un(En.b*255,0,255))}getHexString(t=ai){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.fromWorkingColorSpace(En.copy(this),e);const i=En.r,s=En.g,r=En.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ye.workingColorSpace){return ye.fromWorkingColorSpace(En.copy(this),e),t.r=En.r,t.g=En.g,t.b=En.b,t}getStyle(t=ai){ye.fromWorkingColorSpace(En.copy(this),t);const e=En.r,i=En.g,s=En.b;return t!==ai?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(xs),this.setHSL(xs.h+t,xs.s+e,xs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(xs),t.getHSL(wa);const i=uc(xs.h,wa.h,e),s=uc(xs.s,wa.s,e),r=uc(xs.l,wa.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const En=new de;de.NAMES=wg;let My=0;class hr extends fo{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:My++}),this.uuid=Qo(),this.name="",this.blending=Xr,this.side=Cs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=cu,this.blendDst=uu,this.blendEquation=Zs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new de(0,0,0),this.blendAlpha=0,this.depthFunc=no,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Cf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Er,this.stencilZFail=Er,this.stencilZPass=Er,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const i={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Xr&&(i.blending=this.blending),this.side!==Cs&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==cu&&(i.blendSrc=this.blendSrc),this.blendDst!==uu&&(i.blendDst=this.blendDst),this.blendEquation!==Zs&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==no&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Cf&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Er&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Er&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Er&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let i=null;if(e!==null){const s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class mo extends hr{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new de(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new zi,this.combine=Uh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const Je=new z,ba=new fe;class Gn{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Pf,this.updateRanges=[],this.gpuType=ts,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)ba.fromBufferAttribute(this,e),ba.applyMatrix3(t),this.setXY(e,ba.x,ba.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Je.fromBufferAttribute(this,e),Je.applyMatrix3(t),this.setXYZ(e,Je.x,Je.y,Je.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Je.fromBufferAttribute(this,e),Je.applyMatrix4(t),this.setXYZ(e,Je.x,Je.y,Je.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Je.fromBufferAttribute(this,e),Je.applyNormalMatrix(t),this.setXYZ(e,Je.x,Je.y,Je.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Je.fromBufferAttribute(this,e),Je.transformDirection(t),this.setXYZ(e,Je.x,Je.y,Je.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=Ao(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=kn(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Ao(e,this.array)),e}setX(t,e){return this.normalized&&(e=kn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Ao(e,this.array)),e}setY(t,e){return this.normalized&&(e=kn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Ao(e,this.array)),e}setZ(t,e){return this.normalized&&(e=kn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Ao(e,this.array)),e}setW(t,e){return this.normalized&&(e=kn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=kn(e,this.array),i=kn(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=kn(e,this.array),i=kn(i,this.array),s=kn(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=kn(e,this.array),i=kn(i,this.array),s=kn(s,this.array),r=kn(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Pf&&(t.usage=this.usage),t}}class bg extends Gn{constructor(t,e,i){super(new Uint16Array(t),e,i)}}class Eg extends Gn{constructor(t,e,i){super(new Uint32Array(t),e,i)}}class Ve extends Gn{constructor(t,e,i){super(new Float32Array(t),e,i)}}let yy=0;const ii=new ke,Rc=new an,Nr=new z,Yn=new po,Lo=new po,vn=new z;class hn extends fo{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:yy++}),this.uuid=Qo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(xg(t)?Eg:bg)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new ie().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return ii.makeRotationFromQuaternion(t),this.applyMatrix4(ii),this}rotateX(t){return ii.makeRotationX(t),this.applyMatrix4(ii),this}rotateY(t){return ii.makeRotationY(t),this.applyMatrix4(ii),this}rotateZ(t){return ii.makeRotationZ(t),this.applyMatrix4(ii),this}translate(t,e,i){return ii.makeTranslation(t,e,i),this.applyMatrix4(ii),this}scale(t,e,i){return ii.makeScale(t,e,i),this.applyMatrix4(ii),this}lookAt(t){return Rc.lookAt(t),Rc.updateMatrix(),this.applyMatrix4(Rc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Nr).negate(),this.translate(Nr.x,Nr.y,Nr.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const i=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ve(i,3))}else{for(let i=0,s=e.count;i<s;i++){const r=t[i];e.setXYZ(i,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new po);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){const r=e[i];Yn.setFromBufferAttribute(r),this.morphTargetsRelative?(vn.addVectors(this.boundingBox.min,Yn.min),this.boundingBox.expandByPoint(vn),vn.addVectors(this.boundingBox.max,Yn.max),this.boundingBox.expandByPoint(vn)):(this.boundingBox.expandByPoint(Yn.min),this.boundingBox.expandByPoint(Yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ta);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){const i=this.boundingSphere.center;if(Yn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];Lo.setFromBufferAttribute(a),this.morphTargetsRelative?(vn.addVectors(Yn.min,Lo.min),Yn.expandByPoint(vn),vn.addVectors(Yn.max,Lo.max),Yn.expandByPoint(vn)):(Yn.expandByPoint(Lo.min),Yn.expandByPoint(Lo.max))}Yn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)vn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(vn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)vn.fromBufferAttribute(a,c),l&&(Nr.fromBufferAttribute(t,c),vn.add(Nr)),s=Math.max(s,i.distanceToSquared(vn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Gn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let I=0;I<i.count;I++)a[I]=new z,l[I]=new z;const c=new z,u=new z,h=new z,d=new fe,f=new fe,g=new fe,v=new z,m=new z;function p(I,T,S){c.fromBufferAttribute(i,I),u.fromBufferAttribute(i,T),h.fromBufferAttribute(i,S),d.fromBufferAttribute(r,I),f.fromBufferAttribute(r,T),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),f.sub(d),g.sub(d);const C=1/(f.x*g.y-g.x*f.y);isFinite(C)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-f.y).multiplyScalar(C),m.copy(h).multiplyScalar(f.x).addScaledVector(u,-g.x).multiplyScalar(C),a[I].add(v),a[T].add(v),a[S].add(v),l[I].add(m),l[T].add(m),l[S].add(m))}let y=this.groups;y.length===0&&(y=[{start:0,count:t.count}]);for(let I=0,T=y.length;I<T;++I){const S=y[I],C=S.start,V=S.count;for(let F=C,W=C+V;F<W;F+=3)p(t.getX(F+0),t.getX(F+1),t.getX(F+2))}const E=new z,x=new z,U=new z,A=new z;function D(I){U.fromBufferAttribute(s,I),A.copy(U);const T=a[I];E.copy(T),E.sub(U.multiplyScalar(U.dot(T))).normalize(),x.crossVectors(A,T);const C=x.dot(l[I])<0?-1:1;o.setXYZW(I,E.x,E.y,E.z,C)}for(let I=0,T=y.length;I<T;++I){const S=y[I],C=S.start,V=S.count;for(let F=C,W=C+V;F<W;F+=3)D(t.getX(F+0)),D(t.getX(F+1)),D(t.getX(F+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Gn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);const s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let d=0,f=t.count;d<f;d+=3){const g=t.getX(d+0),v=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)vn.fromBufferAttribute(t,e),vn.normalize(),t.setXYZ(e,vn.x,vn.y,vn.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u);let f=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*u;for(let p=0;p<u;p++)d[g++]=c[f++]}return new Gn(d,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new hn,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,i);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const i=this.attributes;for(const l in i){const c=i[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){const f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const i=t.index;i!==null&&this.setIndex(i.clone(e));const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const qf=new ke,Gs=new Hh,Ea=new ta,Yf=new z,Ta=new z,Aa=new z,Ra=new z,Cc=new z,Ca=new z,jf=new z,Pa=new z;class An extends an{constructor(t=new hn,e=new mo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){Ca.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(Cc.fromBufferAttribute(h,t),o?Ca.addScaledVector(Cc,u):Ca.addScaledVector(Cc.sub(e),u))}e.add(Ca)}return e}raycast(t,e){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ea.copy(i.boundingSphere),Ea.applyMatrix4(r),Gs.copy(t.ray).recast(t.near),!(Ea.containsPoint(Gs.origin)===!1&&(Gs.intersectSphere(Ea,Yf)===null||Gs.origin.distanceToSquared(Yf)>(t.far-t.near)**2))&&(qf.copy(r).invert(),Gs.copy(t.ray).applyMatrix4(qf),!(i.boundingBox!==null&&Gs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Gs)))}_computeIntersections(t,e,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){const m=d[g],p=o[m.materialIndex],y=Math.max(m.start,f.start),E=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let x=y,U=E;x<U;x+=3){const A=a.getX(x),D=a.getX(x+1),I=a.getX(x+2);s=La(this,p,t,i,c,u,h,A,D,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){const y=a.getX(m),E=a.getX(m+1),x=a.getX(m+2);s=La(this,o,t,i,c,u,h,y,E,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){const m=d[g],p=o[m.materialIndex],y=Math.max(m.start,f.start),E=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let x=y,U=E;x<U;x+=3){const A=x,D=x+1,I=x+2;s=La(this,p,t,i,c,u,h,A,D,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){const y=m,E=m+1,x=m+2;s=La(this,o,t,i,c,u,h,y,E,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function Sy(n,t,e,i,s,r,o,a){let l;if(t.side===zn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Cs,a),l===null)return null;Pa.copy(a),Pa.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(Pa);return c<e.near||c>e.far?null:{distance:c,point:Pa.clone(),object:n}}function La(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Ta),n.getVertexPosition(l,Aa),n.getVertexPosition(c,Ra);const u=Sy(n,t,e,i,Ta,Aa,Ra,jf);if(u){const h=new z;li.getBarycoord(jf,Ta,Aa,Ra,h),s&&(u.uv=li.getInterpolatedAttribute(s,a,l,c,h,new fe)),r&&(u.uv1=li.getInterpolatedAttribute(r,a,l,c,h,new fe)),o&&(u.normal=li.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const d={a,b:l,c,normal:new z,materialIndex:0};li.getNormal(Ta,Aa,Ra,d.normal),u.face=d,u.barycoord=h}return u}class go extends hn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let d=0,f=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ve(c,3)),this.setAttribute("normal",new Ve(u,3)),this.setAttribute("uv",new Ve(h,2));function g(v,m,p,y,E,x,U,A,D,I,T){const S=x/D,C=U/I,V=x/2,F=U/2,W=A/2,Z=D+1,K=I+1;let Q=0,tt=0;const ht=new z;for(let ct=0;ct<K;ct++){const gt=ct*C-F;for(let yt=0;yt<Z;yt++){const mt=yt*S-V;ht[v]=mt*y,ht[m]=gt*E,ht[p]=W,c.push(ht.x,ht.y,ht.z),ht[v]=0,ht[m]=0,ht[p]=A>0?1:-1,u.push(ht.x,ht.y,ht.z),h.push(yt/D),h.push(1-ct/I),Q+=1}}for(let ct=0;ct<I;ct++)for(let gt=0;gt<D;gt++){const yt=d+gt+Z*ct,mt=d+gt+Z*(ct+1),it=d+(gt+1)+Z*(ct+1),at=d+(gt+1)+Z*ct;l.push(yt,mt,at),l.push(mt,it,at),tt+=6}a.addGroup(f,tt,T),f+=tt,d+=Q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new go(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function ao(n){const t={};for(const e in n){t[e]={};for(const i in n[e]){const s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function In(n){const t={};for(let e=0;e<n.length;e++){const i=ao(n[e]);for(const s in i)t[s]=i[s]}return t}function wy(n){const t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Tg(n){const t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}const by={clone:ao,merge:In};var Ey=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ty=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Ps extends hr{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ey,this.fragmentShader=Ty,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ao(t.uniforms),this.uniformsGroups=wy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}}class Ag extends an{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ke,this.projectionMatrix=new ke,this.projectionMatrixInverse=new ke,this.coordinateSystem=es}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const Ms=new z,Kf=new fe,Zf=new fe;class Kn extends Ag{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=Yu*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(il*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Yu*2*Math.atan(Math.tan(il*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ms.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ms.x,Ms.y).multiplyScalar(-t/Ms.z),Ms.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ms.x,Ms.y).multiplyScalar(-t/Ms.z)}getViewSize(t,e){return this.getViewBounds(t,Kf,Zf),e.subVectors(Zf,Kf)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(il*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const Fr=-90,Or=1;class Ay extends an{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Kn(Fr,Or,t,e);s.layers=this.layers,this.add(s);const r=new Kn(Fr,Or,t,e);r.layers=this.layers,this.add(r);const o=new Kn(Fr,Or,t,e);o.layers=this.layers,this.add(o);const a=new Kn(Fr,Or,t,e);a.layers=this.layers,this.add(a);const l=new Kn(Fr,Or,t,e);l.layers=this.layers,this.add(l);const c=new Kn(Fr,Or,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===es)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===fl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;const v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=v,t.setRenderTarget(i,5,s),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}}class Rg extends Hn{constructor(t,e,i,s,r,o,a,l,c,u){t=t!==void 0?t:[],e=e!==void 0?e:io,super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class Ry extends ar{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Rg(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Ni}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new go(5,5,5),r=new Ps({name:"CubemapFromEquirect",uniforms:ao(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:zn,blending:bs});r.uniforms.tEquirect.value=e;const o=new An(s,r),a=e.minFilter;return e.minFilter===tr&&(e.minFilter=Ni),new Ay(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,i,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}}const Pc=new z,Cy=new z,Py=new ie;class Ys{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){const s=Pc.subVectors(i,e).cross(Cy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const i=t.delta(Pc),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const i=e||Py.getNormalMatrix(t),s=this.coplanarPoint(Pc).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Vs=new ta,Da=new z;class Gh{constructor(t=new Ys,e=new Ys,i=new Ys,s=new Ys,r=new Ys,o=new Ys){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=es){const i=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],d=s[7],f=s[8],g=s[9],v=s[10],m=s[11],p=s[12],y=s[13],E=s[14],x=s[15];if(i[0].setComponents(l-r,d-c,m-f,x-p).normalize(),i[1].setComponents(l+r,d+c,m+f,x+p).normalize(),i[2].setComponents(l+o,d+u,m+g,x+y).normalize(),i[3].setComponents(l-o,d-u,m-g,x-y).normalize(),i[4].setComponents(l-a,d-h,m-v,x-E).normalize(),e===es)i[5].setComponents(l+a,d+h,m+v,x+E).normalize();else if(e===fl)i[5].setComponents(a,h,v,E).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Vs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Vs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Vs)}intersectsSprite(t){return Vs.center.set(0,0,0),Vs.radius=.7071067811865476,Vs.applyMatrix4(t.matrixWorld),this.intersectsSphere(Vs)}intersectsSphere(t){const e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let i=0;i<6;i++){const s=e[i];if(Da.x=s.normal.x>0?t.max.x:t.min.x,Da.y=s.normal.y>0?t.max.y:t.min.y,Da.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Da)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Cg(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Ly(n){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){const u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){const g=h[d],v=h[f];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++d,h[d]=v)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){const v=h[f];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class Nl extends hn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],g=[],v=[],m=[];for(let p=0;p<u;p++){const y=p*d-o;for(let E=0;E<c;E++){const x=E*h-r;g.push(x,-y,0),v.push(0,0,1),m.push(E/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){const E=y+c*p,x=y+c*(p+1),U=y+1+c*(p+1),A=y+1+c*p;f.push(E,x,A),f.push(x,U,A)}this.setIndex(f),this.setAttribute("position",new Ve(g,3)),this.setAttribute("normal",new Ve(v,3)),this.setAttribute("uv",new Ve(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Nl(t.width,t.height,t.widthSegments,t.heightSegments)}}var Dy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Iy=`#ifdef USE_ALPHAHASH
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
#endif`,Uy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ny=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Fy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Oy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ky=`#ifdef USE_AOMAP
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
#endif`,By=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,zy=`#ifdef USE_BATCHING
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
#endif`,Hy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Gy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Vy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Wy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,$y=`#ifdef USE_IRIDESCENCE
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
#endif`,Xy=`#ifdef USE_BUMPMAP
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
#endif`,qy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Yy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ky=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Zy=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Jy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Qy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,tS=`#if defined( USE_COLOR_ALPHA )
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
#endif`,eS=`#define PI 3.141592653589793
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
} // validated`,nS=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,iS=`vec3 transformedNormal = objectNormal;
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
#endif`,sS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,rS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,oS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,aS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,lS="gl_FragColor = linearToOutputTexel( gl_FragColor );",cS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,uS=`#ifdef USE_ENVMAP
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
#endif`,hS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,dS=`#ifdef USE_ENVMAP
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
#endif`,fS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,pS=`#ifdef USE_ENVMAP
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
#endif`,mS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,gS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,_S=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,vS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,xS=`#ifdef USE_GRADIENTMAP
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
}`,MS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,yS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,SS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,wS=`uniform bool receiveShadow;
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
#endif`,bS=`#ifdef USE_ENVMAP
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
#endif`,ES=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,TS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,AS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,RS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,CS=`PhysicalMaterial material;
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
#endif`,PS=`struct PhysicalMaterial {
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
}`,LS=`
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
#endif`,DS=`#if defined( RE_IndirectDiffuse )
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
#endif`,IS=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,US=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,NS=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,FS=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,OS=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,kS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,BS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,zS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,HS=`#if defined( USE_POINTS_UV )
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
#endif`,GS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,VS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,WS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,$S=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,XS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qS=`#ifdef USE_MORPHTARGETS
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
#endif`,YS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,KS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,ZS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,JS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,QS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,tw=`#ifdef USE_NORMALMAP
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
#endif`,ew=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,nw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,iw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,sw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,rw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ow=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,aw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,lw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,cw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,uw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,dw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,fw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,pw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,mw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,gw=`float getShadowMask() {
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
}`,_w=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,vw=`#ifdef USE_SKINNING
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
#endif`,xw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Mw=`#ifdef USE_SKINNING
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
#endif`,yw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Sw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ww=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,bw=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Ew=`#ifdef USE_TRANSMISSION
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
#endif`,Tw=`#ifdef USE_TRANSMISSION
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
#endif`,Aw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Rw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Cw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Pw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const Lw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Dw=`uniform sampler2D t2D;
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
}`,Iw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Uw=`#ifdef ENVMAP_TYPE_CUBE
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
}`,Nw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Fw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ow=`#include <common>
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
}`,kw=`#if DEPTH_PACKING == 3200
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
}`,Bw=`#define DISTANCE
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
}`,zw=`#define DISTANCE
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
}`,Hw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Gw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vw=`uniform float scale;
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
}`,Ww=`uniform vec3 diffuse;
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
}`,$w=`#include <common>
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
}`,Xw=`uniform vec3 diffuse;
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
}`,qw=`#define LAMBERT
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
}`,Yw=`#define LAMBERT
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
}`,jw=`#define MATCAP
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
}`,Kw=`#define MATCAP
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
}`,Zw=`#define NORMAL
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
}`,Jw=`#define NORMAL
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
}`,Qw=`#define PHONG
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
}`,tb=`#define PHONG
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
}`,eb=`#define STANDARD
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
}`,nb=`#define STANDARD
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
}`,ib=`#define TOON
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
}`,sb=`#define TOON
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
}`,rb=`uniform float size;
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
}`,ob=`uniform vec3 diffuse;
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
}`,ab=`#include <common>
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
}`,lb=`uniform vec3 color;
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
}`,cb=`uniform float rotation;
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
}`,ub=`uniform vec3 diffuse;
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
}`,re={alphahash_fragment:Dy,alphahash_pars_fragment:Iy,alphamap_fragment:Uy,alphamap_pars_fragment:Ny,alphatest_fragment:Fy,alphatest_pars_fragment:Oy,aomap_fragment:ky,aomap_pars_fragment:By,batching_pars_vertex:zy,batching_vertex:Hy,begin_vertex:Gy,beginnormal_vertex:Vy,bsdfs:Wy,iridescence_fragment:$y,bumpmap_pars_fragment:Xy,clipping_planes_fragment:qy,clipping_planes_pars_fragment:Yy,clipping_planes_pars_vertex:jy,clipping_planes_vertex:Ky,color_fragment:Zy,color_pars_fragment:Jy,color_pars_vertex:Qy,color_vertex:tS,common:eS,cube_uv_reflection_fragment:nS,defaultnormal_vertex:iS,displacementmap_pars_vertex:sS,displacementmap_vertex:rS,emissivemap_fragment:oS,emissivemap_pars_fragment:aS,colorspace_fragment:lS,colorspace_pars_fragment:cS,envmap_fragment:uS,envmap_common_pars_fragment:hS,envmap_pars_fragment:dS,envmap_pars_vertex:fS,envmap_physical_pars_fragment:bS,envmap_vertex:pS,fog_vertex:mS,fog_pars_vertex:gS,fog_fragment:_S,fog_pars_fragment:vS,gradientmap_pars_fragment:xS,lightmap_pars_fragment:MS,lights_lambert_fragment:yS,lights_lambert_pars_fragment:SS,lights_pars_begin:wS,lights_toon_fragment:ES,lights_toon_pars_fragment:TS,lights_phong_fragment:AS,lights_phong_pars_fragment:RS,lights_physical_fragment:CS,lights_physical_pars_fragment:PS,lights_fragment_begin:LS,lights_fragment_maps:DS,lights_fragment_end:IS,logdepthbuf_fragment:US,logdepthbuf_pars_fragment:NS,logdepthbuf_pars_vertex:FS,logdepthbuf_vertex:OS,map_fragment:kS,map_pars_fragment:BS,map_particle_fragment:zS,map_particle_pars_fragment:HS,metalnessmap_fragment:GS,metalnessmap_pars_fragment:VS,morphinstance_vertex:WS,morphcolor_vertex:$S,morphnormal_vertex:XS,morphtarget_pars_vertex:qS,morphtarget_vertex:YS,normal_fragment_begin:jS,normal_fragment_maps:KS,normal_pars_fragment:ZS,normal_pars_vertex:JS,normal_vertex:QS,normalmap_pars_fragment:tw,clearcoat_normal_fragment_begin:ew,clearcoat_normal_fragment_maps:nw,clearcoat_pars_fragment:iw,iridescence_pars_fragment:sw,opaque_fragment:rw,packing:ow,premultiplied_alpha_fragment:aw,project_vertex:lw,dithering_fragment:cw,dithering_pars_fragment:uw,roughnessmap_fragment:hw,roughnessmap_pars_fragment:dw,shadowmap_pars_fragment:fw,shadowmap_pars_vertex:pw,shadowmap_vertex:mw,shadowmask_pars_fragment:gw,skinbase_vertex:_w,skinning_pars_vertex:vw,skinning_vertex:xw,skinnormal_vertex:Mw,specularmap_fragment:yw,specularmap_pars_fragment:Sw,tonemapping_fragment:ww,tonemapping_pars_fragment:bw,transmission_fragment:Ew,transmission_pars_fragment:Tw,uv_pars_fragment:Aw,uv_pars_vertex:Rw,uv_vertex:Cw,worldpos_vertex:Pw,background_vert:Lw,background_frag:Dw,backgroundCube_vert:Iw,backgroundCube_frag:Uw,cube_vert:Nw,cube_frag:Fw,depth_vert:Ow,depth_frag:kw,distanceRGBA_vert:Bw,distanceRGBA_frag:zw,equirect_vert:Hw,equirect_frag:Gw,linedashed_vert:Vw,linedashed_frag:Ww,meshbasic_vert:$w,meshbasic_frag:Xw,meshlambert_vert:qw,meshlambert_frag:Yw,meshmatcap_vert:jw,meshmatcap_frag:Kw,meshnormal_vert:Zw,meshnormal_frag:Jw,meshphong_vert:Qw,meshphong_frag:tb,meshphysical_vert:eb,meshphysical_frag:nb,meshtoon_vert:ib,meshtoon_frag:sb,points_vert:rb,points_frag:ob,shadow_vert:ab,shadow_frag:lb,sprite_vert:cb,sprite_frag:ub},Et={common:{diffuse:{value:new de(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new fe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new de(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new de(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new de(16777215)},opacity:{value:1},center:{value:new fe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},Li={basic:{uniforms:In([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.fog]),vertexShader:re.meshbasic_vert,fragmentShader:re.meshbasic_frag},lambert:{uniforms:In([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,Et.lights,{emissive:{value:new de(0)}}]),vertexShader:re.meshlambert_vert,fragmentShader:re.meshlambert_frag},phong:{uniforms:In([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,Et.lights,{emissive:{value:new de(0)},specular:{value:new de(1118481)},shininess:{value:30}}]),vertexShader:re.meshphong_vert,fragmentShader:re.meshphong_frag},standard:{uniforms:In([Et.common,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.roughnessmap,Et.metalnessmap,Et.fog,Et.lights,{emissive:{value:new de(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag},toon:{uniforms:In([Et.common,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.gradientmap,Et.fog,Et.lights,{emissive:{value:new de(0)}}]),vertexShader:re.meshtoon_vert,fragmentShader:re.meshtoon_frag},matcap:{uniforms:In([Et.common,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,{matcap:{value:null}}]),vertexShader:re.meshmatcap_vert,fragmentShader:re.meshmatcap_frag},points:{uniforms:In([Et.points,Et.fog]),vertexShader:re.points_vert,fragmentShader:re.points_frag},dashed:{uniforms:In([Et.common,Et.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:re.linedashed_vert,fragmentShader:re.linedashed_frag},depth:{uniforms:In([Et.common,Et.displacementmap]),vertexShader:re.depth_vert,fragmentShader:re.depth_frag},normal:{uniforms:In([Et.common,Et.bumpmap,Et.normalmap,Et.displacementmap,{opacity:{value:1}}]),vertexShader:re.meshnormal_vert,fragmentShader:re.meshnormal_frag},sprite:{uniforms:In([Et.sprite,Et.fog]),vertexShader:re.sprite_vert,fragmentShader:re.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:re.background_vert,fragmentShader:re.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:re.backgroundCube_vert,fragmentShader:re.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:re.cube_vert,fragmentShader:re.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:re.equirect_vert,fragmentShader:re.equirect_frag},distanceRGBA:{uniforms:In([Et.common,Et.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:re.distanceRGBA_vert,fragmentShader:re.distanceRGBA_frag},shadow:{uniforms:In([Et.lights,Et.fog,{color:{value:new de(0)},opacity:{value:1}}]),vertexShader:re.shadow_vert,fragmentShader:re.shadow_frag}};Li.physical={uniforms:In([Li.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new fe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new de(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new fe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new de(0)},specularColor:{value:new de(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new fe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag};const Ia={r:0,b:0,g:0},Ws=new zi,hb=new ke;function db(n,t,e,i,s,r,o){const a=new de(0);let l=r===!0?0:1,c,u,h=null,d=0,f=null;function g(y){let E=y.isScene===!0?y.background:null;return E&&E.isTexture&&(E=(y.backgroundBlurriness>0?e:t).get(E)),E}function v(y){let E=!1;const x=g(y);x===null?p(a,l):x&&x.isColor&&(p(x,1),E=!0);const U=n.xr.getEnvironmentBlendMode();U==="additive"?i.buffers.color.setClear(0,0,0,1,o):U==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||E)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(y,E){const x=g(E);x&&(x.isCubeTexture||x.mapping===Il)?(u===void 0&&(u=new An(new go(1,1,1),new Ps({name:"BackgroundCubeMaterial",uniforms:ao(Li.backgroundCube.uniforms),vertexShader:Li.backgroundCube.vertexShader,fragmentShader:Li.backgroundCube.fragmentShader,side:zn,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(U,A,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Ws.copy(E.backgroundRotation),Ws.x*=-1,Ws.y*=-1,Ws.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(Ws.y*=-1,Ws.z*=-1),u.material.uniforms.envMap.value=x,u.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(hb.makeRotationFromEuler(Ws)),u.material.toneMapped=ye.getTransfer(x.colorSpace)!==Le,(h!==x||d!==x.version||f!==n.toneMapping)&&(u.material.needsUpdate=!0,h=x,d=x.version,f=n.toneMapping),u.layers.enableAll(),y.unshift(u,u.geometry,u.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new An(new Nl(2,2),new Ps({name:"BackgroundMaterial",uniforms:ao(Li.background.uniforms),vertexShader:Li.background.vertexShader,fragmentShader:Li.background.fragmentShader,side:Cs,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.toneMapped=ye.getTransfer(x.colorSpace)!==Le,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||d!==x.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,h=x,d=x.version,f=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function p(y,E){y.getRGB(Ia,Tg(n)),i.buffers.color.setClear(Ia.r,Ia.g,Ia.b,E,o)}return{getClearColor:function(){return a},setClearColor:function(y,E=1){a.set(y),l=E,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(y){l=y,p(a,l)},render:v,addToRenderList:m}}function fb(n,t){const e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null);let r=s,o=!1;function a(S,C,V,F,W){let Z=!1;const K=h(F,V,C);r!==K&&(r=K,c(r.object)),Z=f(S,F,V,W),Z&&g(S,F,V,W),W!==null&&t.update(W,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,x(S,C,V,F),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return n.createVertexArray()}function c(S){return n.bindVertexArray(S)}function u(S){return n.deleteVertexArray(S)}function h(S,C,V){const F=V.wireframe===!0;let W=i[S.id];W===void 0&&(W={},i[S.id]=W);let Z=W[C.id];Z===void 0&&(Z={},W[C.id]=Z);let K=Z[F];return K===void 0&&(K=d(l()),Z[F]=K),K}function d(S){const C=[],V=[],F=[];for(let W=0;W<e;W++)C[W]=0,V[W]=0,F[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:V,attributeDivisors:F,object:S,attributes:{},index:null}}function f(S,C,V,F){const W=r.attributes,Z=C.attributes;let K=0;const Q=V.getAttributes();for(const tt in Q)if(Q[tt].location>=0){const ct=W[tt];let gt=Z[tt];if(gt===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(gt=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(gt=S.instanceColor)),ct===void 0||ct.attribute!==gt||gt&&ct.data!==gt.data)return!0;K++}return r.attributesNum!==K||r.index!==F}function g(S,C,V,F){const W={},Z=C.attributes;let K=0;const Q=V.getAttributes();for(const tt in Q)if(Q[tt].location>=0){let ct=Z[tt];ct===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const gt={};gt.attribute=ct,ct&&ct.data&&(gt.data=ct.data),W[tt]=gt,K++}r.attributes=W,r.attributesNum=K,r.index=F}function v(){const S=r.newAttributes;for(let C=0,V=S.length;C<V;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){const V=r.newAttributes,F=r.enabledAttributes,W=r.attributeDivisors;V[S]=1,F[S]===0&&(n.enableVertexAttribArray(S),F[S]=1),W[S]!==C&&(n.vertexAttribDivisor(S,C),W[S]=C)}function y(){const S=r.newAttributes,C=r.enabledAttributes;for(let V=0,F=C.length;V<F;V++)C[V]!==S[V]&&(n.disableVertexAttribArray(V),C[V]=0)}function E(S,C,V,F,W,Z,K){K===!0?n.vertexAttribIPointer(S,C,V,W,Z):n.vertexAttribPointer(S,C,V,F,W,Z)}function x(S,C,V,F){v();const W=F.attributes,Z=V.getAttributes(),K=C.defaultAttributeValues;for(const Q in Z){const tt=Z[Q];if(tt.location>=0){let ht=W[Q];if(ht===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ht=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ht=S.instanceColor)),ht!==void 0){const ct=ht.normalized,gt=ht.itemSize,yt=t.get(ht);if(yt===void 0)continue;const mt=yt.buffer,it=yt.type,at=yt.bytesPerElement,_t=it===n.INT||it===n.UNSIGNED_INT||ht.gpuType===Nh;if(ht.isInterleavedBufferAttribute){const ot=ht.data,zt=ot.stride,Gt=ht.offset;if(ot.isInstancedInterleavedBuffer){for(let Nt=0;Nt<tt.locationSize;Nt++)p(tt.location+Nt,ot.meshPerAttribute);S.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let Nt=0;Nt<tt.locationSize;Nt++)m(tt.location+Nt);n.bindBuffer(n.ARRAY_BUFFER,mt);for(let Nt=0;Nt<tt.locationSize;Nt++)E(tt.location+Nt,gt/tt.locationSize,it,ct,zt*at,(Gt+gt/tt.locationSize*Nt)*at,_t)}else{if(ht.isInstancedBufferAttribute){for(let ot=0;ot<tt.locationSize;ot++)p(tt.location+ot,ht.meshPerAttribute);S.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ot=0;ot<tt.locationSize;ot++)m(tt.location+ot);n.bindBuffer(n.ARRAY_BUFFER,mt);for(let ot=0;ot<tt.locationSize;ot++)E(tt.location+ot,gt/tt.locationSize,it,ct,gt*at,gt/tt.locationSize*ot*at,_t)}}else if(K!==void 0){const ct=K[Q];if(ct!==void 0)switch(ct.length){case 2:n.vertexAttrib2fv(tt.location,ct);break;case 3:n.vertexAttrib3fv(tt.location,ct);break;case 4:n.vertexAttrib4fv(tt.location,ct);break;default:n.vertexAttrib1fv(tt.location,ct)}}}}y()}function U(){I();for(const S in i){const C=i[S];for(const V in C){const F=C[V];for(const W in F)u(F[W].object),delete F[W];delete C[V]}delete i[S]}}function A(S){if(i[S.id]===void 0)return;const C=i[S.id];for(const V in C){const F=C[V];for(const W in F)u(F[W].object),delete F[W];delete C[V]}delete i[S.id]}function D(S){for(const C in i){const V=i[C];if(V[S.id]===void 0)continue;const F=V[S.id];for(const W in F)u(F[W].object),delete F[W];delete V[S.id]}}function I(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:T,dispose:U,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function pb(n,t,e){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),e.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),e.update(u,i,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let f=0;for(let g=0;g<h;g++)f+=u[g];e.update(f,i,1)}function l(c,u,h,d){if(h===0)return;const f=t.get("WEBGL_multi_draw");if(f===null)for(let g=0;g<c.length;g++)o(c[g],u[g],d[g]);else{f.multiDrawArraysInstancedWEBGL(i,c,0,u,0,d,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*d[v];e.update(g,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function mb(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==Mi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const I=D===Jo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==os&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==ts&&!I)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,d=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),U=g>0,A=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:E,maxFragmentUniforms:x,vertexTextures:U,maxSamples:A}}function gb(n){const t=this;let e=null,i=0,s=!1,r=!1;const o=new Ys,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){const f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){const g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{const y=r?0:i,E=y*4;let x=p.clippingState||null;l.value=x,x=u(g,d,E,f);for(let U=0;U!==E;++U)x[U]=e[U];p.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,g){const v=h!==null?h.length:0;let m=null;if(v!==0){if(m=l.value,g!==!0||m===null){const p=f+v*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let E=0,x=f;E!==v;++E,x+=4)o.copy(h[E]).applyMatrix4(y,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function _b(n){let t=new WeakMap;function e(o,a){return a===vu?o.mapping=io:a===xu&&(o.mapping=so),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===vu||a===xu)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new Ry(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}class Vh extends Ag{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const zr=4,Jf=[.125,.215,.35,.446,.526,.582],Js=20,Lc=new Vh,Qf=new de;let Dc=null,Ic=0,Uc=0,Nc=!1;const js=(1+Math.sqrt(5))/2,kr=1/js,tp=[new z(-js,kr,0),new z(js,kr,0),new z(-kr,0,js),new z(kr,0,js),new z(0,js,-kr),new z(0,js,kr),new z(-1,1,-1),new z(1,1,-1),new z(-1,1,1),new z(1,1,1)];class ep{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100){Dc=this._renderer.getRenderTarget(),Ic=this._renderer.getActiveCubeFace(),Uc=this._renderer.getActiveMipmapLevel(),Nc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,i,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=sp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ip(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Dc,Ic,Uc),this._renderer.xr.enabled=Nc,t.scissorTest=!1,Ua(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===io||t.mapping===so?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Dc=this._renderer.getRenderTarget(),Ic=this._renderer.getActiveCubeFace(),Uc=this._renderer.getActiveMipmapLevel(),Nc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Ni,minFilter:Ni,generateMipmaps:!1,type:Jo,format:Mi,colorSpace:ur,depthBuffer:!1},s=np(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=np(t,e,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=vb(r)),this._blurMaterial=xb(r,t,e)}return s}_compileMaterial(t){const e=new An(this._lodPlanes[0],t);this._renderer.compile(e,Lc)}_sceneToCubeUV(t,e,i,s){const a=new Kn(90,1,e,i),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,d=u.toneMapping;u.getClearColor(Qf),u.toneMapping=Es,u.autoClear=!1;const f=new mo({name:"PMREM.Background",side:zn,depthWrite:!1,depthTest:!1}),g=new An(new go,f);let v=!1;const m=t.background;m?m.isColor&&(f.color.copy(m),t.background=null,v=!0):(f.color.copy(Qf),v=!0);for(let p=0;p<6;p++){const y=p%3;y===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):y===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));const E=this._cubeSize;Ua(s,y*E,p>2?E:0,E,E),u.setRenderTarget(s),v&&u.render(g,a),u.render(t,a)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=d,u.autoClear=h,t.background=m}_textureToCubeUV(t,e){const i=this._renderer,s=t.mapping===io||t.mapping===so;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=sp()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=ip());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new An(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;Ua(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,Lc)}_applyPMREM(t){const e=this._renderer,i=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=tp[(s-r-1)%tp.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new An(this._lodPlanes[s],c),d=c.uniforms,f=this._sizeLods[i]-1,g=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*Js-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):Js;m>Js&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Js}`);const p=[];let y=0;for(let D=0;D<Js;++D){const I=D/v,T=Math.exp(-I*I/2);p.push(T),D===0?y+=T:D<m&&(y+=2*T)}for(let D=0;D<p.length;D++)p[D]=p[D]/y;d.envMap.value=t.texture,d.samples.value=m,d.weights.value=p,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);const{_lodMax:E}=this;d.dTheta.value=g,d.mipInt.value=E-i;const x=this._sizeLods[s],U=3*x*(s>E-zr?s-E+zr:0),A=4*(this._cubeSize-x);Ua(e,U,A,3*x,2*x),l.setRenderTarget(e),l.render(h,Lc)}}function vb(n){const t=[],e=[],i=[];let s=n;const r=n-zr+1+Jf.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>n-zr?l=Jf[o-n+zr-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),u=-c,h=1+c,d=[u,u,h,u,h,h,u,u,h,h,u,h],f=6,g=6,v=3,m=2,p=1,y=new Float32Array(v*g*f),E=new Float32Array(m*g*f),x=new Float32Array(p*g*f);for(let A=0;A<f;A++){const D=A%3*2/3-1,I=A>2?0:-1,T=[D,I,0,D+2/3,I,0,D+2/3,I+1,0,D,I,0,D+2/3,I+1,0,D,I+1,0];y.set(T,v*g*A),E.set(d,m*g*A);const S=[A,A,A,A,A,A];x.set(S,p*g*A)}const U=new hn;U.setAttribute("position",new Gn(y,v)),U.setAttribute("uv",new Gn(E,m)),U.setAttribute("faceIndex",new Gn(x,p)),t.push(U),s>zr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function np(n,t,e){const i=new ar(n,t,e);return i.texture.mapping=Il,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Ua(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function xb(n,t,e){const i=new Float32Array(Js),s=new z(0,1,0);return new Ps({name:"SphericalGaussianBlur",defines:{n:Js,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Wh(),fragmentShader:`

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
		`,blending:bs,depthTest:!1,depthWrite:!1})}function ip(){return new Ps({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Wh(),fragmentShader:`

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
		`,blending:bs,depthTest:!1,depthWrite:!1})}function sp(){return new Ps({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Wh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:bs,depthTest:!1,depthWrite:!1})}function Wh(){return`

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
	`}function Mb(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===vu||l===xu,u=l===io||l===so;if(c||u){let h=t.get(a);const d=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return e===null&&(e=new ep(n)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const f=a.image;return c&&f&&f.height>0||u&&f&&s(f)?(e===null&&(e=new ep(n)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function yb(n){const t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){const s=e(i);return s===null&&zo("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function Sb(n,t,e,i){const s={},r=new WeakMap;function o(h){const d=h.target;d.index!==null&&t.remove(d.index);for(const g in d.attributes)t.remove(d.attributes[g]);for(const g in d.morphAttributes){const v=d.morphAttributes[g];for(let m=0,p=v.length;m<p;m++)t.remove(v[m])}d.removeEventListener("dispose",o),delete s[d.id];const f=r.get(d);f&&(t.remove(f),r.delete(d)),i.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,e.memory.geometries--}function a(h,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,e.memory.geometries++),d}function l(h){const d=h.attributes;for(const g in d)t.update(d[g],n.ARRAY_BUFFER);const f=h.morphAttributes;for(const g in f){const v=f[g];for(let m=0,p=v.length;m<p;m++)t.update(v[m],n.ARRAY_BUFFER)}}function c(h){const d=[],f=h.index,g=h.attributes.position;let v=0;if(f!==null){const y=f.array;v=f.version;for(let E=0,x=y.length;E<x;E+=3){const U=y[E+0],A=y[E+1],D=y[E+2];d.push(U,A,A,D,D,U)}}else if(g!==void 0){const y=g.array;v=g.version;for(let E=0,x=y.length/3-1;E<x;E+=3){const U=E+0,A=E+1,D=E+2;d.push(U,A,A,D,D,U)}}else return;const m=new(xg(d)?Eg:bg)(d,1);m.version=v;const p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){const d=r.get(h);if(d){const f=h.index;f!==null&&d.version<f.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function wb(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,f){n.drawElements(i,f,r,d*o),e.update(f,i,1)}function c(d,f,g){g!==0&&(n.drawElementsInstanced(i,f,r,d*o,g),e.update(f,i,g))}function u(d,f,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,d,0,g);let m=0;for(let p=0;p<g;p++)m+=f[p];e.update(m,i,1)}function h(d,f,g,v){if(g===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<d.length;p++)c(d[p]/o,f[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(i,f,0,r,d,0,v,0,g);let p=0;for(let y=0;y<g;y++)p+=f[y]*v[y];e.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function bb(n){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Eb(n,t,e){const i=new WeakMap,s=new qe;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let d=i.get(a);if(d===void 0||d.count!==h){let T=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",T)};d!==void 0&&d.texture.dispose();const f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[];let E=0;f===!0&&(E=1),g===!0&&(E=2),v===!0&&(E=3);let x=a.attributes.position.count*E,U=1;x>t.maxTextureSize&&(U=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);const A=new Float32Array(x*U*4*h),D=new yg(A,x,U,h);D.type=ts,D.needsUpdate=!0;const I=E*4;for(let S=0;S<h;S++){const C=m[S],V=p[S],F=y[S],W=x*U*4*S;for(let Z=0;Z<C.count;Z++){const K=Z*I;f===!0&&(s.fromBufferAttribute(C,Z),A[W+K+0]=s.x,A[W+K+1]=s.y,A[W+K+2]=s.z,A[W+K+3]=0),g===!0&&(s.fromBufferAttribute(V,Z),A[W+K+4]=s.x,A[W+K+5]=s.y,A[W+K+6]=s.z,A[W+K+7]=0),v===!0&&(s.fromBufferAttribute(F,Z),A[W+K+8]=s.x,A[W+K+9]=s.y,A[W+K+10]=s.z,A[W+K+11]=F.itemSize===4?s.w:1)}}d={count:h,texture:D,size:new fe(x,U)},i.set(a,d),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];const g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function Tb(n,t,e,i){let s=new WeakMap;function r(l){const c=i.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class Pg extends Hn{constructor(t,e,i,s,r,o,a,l,c,u=qr){if(u!==qr&&u!==oo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");i===void 0&&u===qr&&(i=or),i===void 0&&u===oo&&(i=ro),super(null,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:Si,this.minFilter=l!==void 0?l:Si,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const Lg=new Hn,rp=new Pg(1,1),Dg=new yg,Ig=new dy,Ug=new Rg,op=[],ap=[],lp=new Float32Array(16),cp=new Float32Array(9),up=new Float32Array(4);function _o(n,t,e){const i=n[0];if(i<=0||i>0)return n;const s=t*e;let r=op[s];if(r===void 0&&(r=new Float32Array(s),op[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function ln(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function cn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Fl(n,t){let e=ap[t];e===void 0&&(e=new Int32Array(t),ap[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function Ab(n,t){const e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Rb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ln(e,t))return;n.uniform2fv(this.addr,t),cn(e,t)}}function Cb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(ln(e,t))return;n.uniform3fv(this.addr,t),cn(e,t)}}function Pb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ln(e,t))return;n.uniform4fv(this.addr,t),cn(e,t)}}function Lb(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(ln(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),cn(e,t)}else{if(ln(e,i))return;up.set(i),n.uniformMatrix2fv(this.addr,!1,up),cn(e,i)}}function Db(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(ln(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),cn(e,t)}else{if(ln(e,i))return;cp.set(i),n.uniformMatrix3fv(this.addr,!1,cp),cn(e,i)}}function Ib(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(ln(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),cn(e,t)}else{if(ln(e,i))return;lp.set(i),n.uniformMatrix4fv(this.addr,!1,lp),cn(e,i)}}function Ub(n,t){const e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function Nb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ln(e,t))return;n.uniform2iv(this.addr,t),cn(e,t)}}function Fb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ln(e,t))return;n.uniform3iv(this.addr,t),cn(e,t)}}function Ob(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ln(e,t))return;n.uniform4iv(this.addr,t),cn(e,t)}}function kb(n,t){const e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Bb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ln(e,t))return;n.uniform2uiv(this.addr,t),cn(e,t)}}function zb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ln(e,t))return;n.uniform3uiv(this.addr,t),cn(e,t)}}function Hb(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ln(e,t))return;n.uniform4uiv(this.addr,t),cn(e,t)}}function Gb(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(rp.compareFunction=vg,r=rp):r=Lg,e.setTexture2D(t||r,s)}function Vb(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Ig,s)}function Wb(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||Ug,s)}function $b(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Dg,s)}function Xb(n){switch(n){case 5126:return Ab;case 35664:return Rb;case 35665:return Cb;case 35666:return Pb;case 35674:return Lb;case 35675:return Db;case 35676:return Ib;case 5124:case 35670:return Ub;case 35667:case 35671:return Nb;case 35668:case 35672:return Fb;case 35669:case 35673:return Ob;case 5125:return kb;case 36294:return Bb;case 36295:return zb;case 36296:return Hb;case 35678:case 36198:case 36298:case 36306:case 35682:return Gb;case 35679:case 36299:case 36307:return Vb;case 35680:case 36300:case 36308:case 36293:return Wb;case 36289:case 36303:case 36311:case 36292:return $b}}function qb(n,t){n.uniform1fv(this.addr,t)}function Yb(n,t){const e=_o(t,this.size,2);n.uniform2fv(this.addr,e)}function jb(n,t){const e=_o(t,this.size,3);n.uniform3fv(this.addr,e)}function Kb(n,t){const e=_o(t,this.size,4);n.uniform4fv(this.addr,e)}function Zb(n,t){const e=_o(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Jb(n,t){const e=_o(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Qb(n,t){const e=_o(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function tE(n,t){n.uniform1iv(this.addr,t)}function eE(n,t){n.uniform2iv(this.addr,t)}function nE(n,t){n.uniform3iv(this.addr,t)}function iE(n,t){n.uniform4iv(this.addr,t)}function sE(n,t){n.uniform1uiv(this.addr,t)}function rE(n,t){n.uniform2uiv(this.addr,t)}function oE(n,t){n.uniform3uiv(this.addr,t)}function aE(n,t){n.uniform4uiv(this.addr,t)}function lE(n,t,e){const i=this.cache,s=t.length,r=Fl(e,s);ln(i,r)||(n.uniform1iv(this.addr,r),cn(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Lg,r[o])}function cE(n,t,e){const i=this.cache,s=t.length,r=Fl(e,s);ln(i,r)||(n.uniform1iv(this.addr,r),cn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Ig,r[o])}function uE(n,t,e){const i=this.cache,s=t.length,r=Fl(e,s);ln(i,r)||(n.uniform1iv(this.addr,r),cn(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Ug,r[o])}function hE(n,t,e){const i=this.cache,s=t.length,r=Fl(e,s);ln(i,r)||(n.uniform1iv(this.addr,r),cn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Dg,r[o])}function dE(n){switch(n){case 5126:return qb;case 35664:return Yb;case 35665:return jb;case 35666:return Kb;case 35674:return Zb;case 35675:return Jb;case 35676:return Qb;case 5124:case 35670:return tE;case 35667:case 35671:return eE;case 35668:case 35672:return nE;case 35669:case 35673:return iE;case 5125:return sE;case 36294:return rE;case 36295:return oE;case 36296:return aE;case 35678:case 36198:case 36298:case 36306:case 35682:return lE;case 35679:case 36299:case 36307:return cE;case 35680:case 36300:case 36308:case 36293:return uE;case 36289:case 36303:case 36311:case 36292:return hE}}class fE{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Xb(e.type)}}class pE{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=dE(e.type)}}class mE{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],i)}}}const Fc=/(\w+)(\])?(\[|\.)?/g;function hp(n,t){n.seq.push(t),n.map[t.id]=t}function gE(n,t,e){const i=n.name,s=i.length;for(Fc.lastIndex=0;;){const r=Fc.exec(i),o=Fc.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){hp(e,c===void 0?new fE(a,n,t):new pE(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new mE(a),hp(e,h)),e=h}}}class sl{constructor(t,e){this.seq=[],this.map={};const i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);gE(r,o,this)}}setValue(t,e,i,s){const r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){const s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const i=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&i.push(o)}return i}}function dp(n,t,e){const i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}const _E=37297;let vE=0;function xE(n,t){const e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}const fp=new ie;function ME(n){ye._getMatrix(fp,ye.workingColorSpace,n);const t=`mat3( ${fp.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(n)){case Ul:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function pp(n,t,e){const i=n.getShaderParameter(t,n.COMPILE_STATUS),s=n.getShaderInfoLog(t).trim();if(i&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+xE(n.getShaderSource(t),o)}else return s}function yE(n,t){const e=ME(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function SE(n,t){let e;switch(t){case BM:e="Linear";break;case zM:e="Reinhard";break;case HM:e="Cineon";break;case GM:e="ACESFilmic";break;case WM:e="AgX";break;case $M:e="Neutral";break;case VM:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const Na=new z;function wE(){ye.getLuminanceCoefficients(Na);const n=Na.x.toFixed(4),t=Na.y.toFixed(4),e=Na.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function bE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ho).join(`
`)}function EE(n){const t=[];for(const e in n){const i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function TE(n,t){const e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(t,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ho(n){return n!==""}function mp(n,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function gp(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const AE=/^[ \t]*#include +<([\w\d./]+)>/gm;function ju(n){return n.replace(AE,CE)}const RE=new Map;function CE(n,t){let e=re[t];if(e===void 0){const i=RE.get(t);if(i!==void 0)e=re[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return ju(e)}const PE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function _p(n){return n.replace(PE,LE)}function LE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function vp(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}function DE(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===rg?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===vM?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===Zi&&(t="SHADOWMAP_TYPE_VSM"),t}function IE(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case io:case so:t="ENVMAP_TYPE_CUBE";break;case Il:t="ENVMAP_TYPE_CUBE_UV";break}return t}function UE(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case so:t="ENVMAP_MODE_REFRACTION";break}return t}function NE(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case Uh:t="ENVMAP_BLENDING_MULTIPLY";break;case OM:t="ENVMAP_BLENDING_MIX";break;case kM:t="ENVMAP_BLENDING_ADD";break}return t}function FE(n){const t=n.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function OE(n,t,e,i){const s=n.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=DE(e),c=IE(e),u=UE(e),h=NE(e),d=FE(e),f=bE(e),g=EE(r),v=s.createProgram();let m,p,y=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Ho).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Ho).join(`
`),p.length>0&&(p+=`
`)):(m=[vp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ho).join(`
`),p=[vp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Es?"#define TONE_MAPPING":"",e.toneMapping!==Es?re.tonemapping_pars_fragment:"",e.toneMapping!==Es?SE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",re.colorspace_pars_fragment,yE("linearToOutputTexel",e.outputColorSpace),wE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ho).join(`
`)),o=ju(o),o=mp(o,e),o=gp(o,e),a=ju(a),a=mp(a,e),a=gp(a,e),o=_p(o),a=_p(a),e.isRawShaderMaterial!==!0&&(y=`#version 300 es
`,m=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===Lf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Lf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const E=y+m+o,x=y+p+a,U=dp(s,s.VERTEX_SHADER,E),A=dp(s,s.FRAGMENT_SHADER,x);s.attachShader(v,U),s.attachShader(v,A),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(n.debug.checkShaderErrors){const V=s.getProgramInfoLog(v).trim(),F=s.getShaderInfoLog(U).trim(),W=s.getShaderInfoLog(A).trim();let Z=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(Z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,U,A);else{const Q=pp(s,U,"vertex"),tt=pp(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+V+`
`+Q+`
`+tt)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(F===""||W==="")&&(K=!1);K&&(C.diagnostics={runnable:Z,programLog:V,vertexShader:{log:F,prefix:m},fragmentShader:{log:W,prefix:p}})}s.deleteShader(U),s.deleteShader(A),I=new sl(s,v),T=TE(s,v)}let I;this.getUniforms=function(){return I===void 0&&D(this),I};let T;this.getAttributes=function(){return T===void 0&&D(this),T};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,_E)),S},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=vE++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=U,this.fragmentShader=A,this}let kE=0;class BE{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){const e=this.shaderCache;let i=e.get(t);return i===void 0&&(i=new zE(t),e.set(t,i)),i}}class zE{constructor(t){this.id=kE++,this.code=t,this.usedTimes=0}}function HE(n,t,e,i,s,r,o){const a=new Sg,l=new BE,c=new Set,u=[],h=s.logarithmicDepthBuffer,d=s.vertexTextures;let f=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,S,C,V,F){const W=V.fog,Z=F.geometry,K=T.isMeshStandardMaterial?V.environment:null,Q=(T.isMeshStandardMaterial?e:t).get(T.envMap||K),tt=Q&&Q.mapping===Il?Q.image.height:null,ht=g[T.type];T.precision!==null&&(f=s.getMaxPrecision(T.precision),f!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",f,"instead."));const ct=Z.morphAttributes.position||Z.morphAttributes.normal||Z.morphAttributes.color,gt=ct!==void 0?ct.length:0;let yt=0;Z.morphAttributes.position!==void 0&&(yt=1),Z.morphAttributes.normal!==void 0&&(yt=2),Z.morphAttributes.color!==void 0&&(yt=3);let mt,it,at,_t;if(ht){const be=Li[ht];mt=be.vertexShader,it=be.fragmentShader}else mt=T.vertexShader,it=T.fragmentShader,l.update(T),at=l.getVertexShaderID(T),_t=l.getFragmentShaderID(T);const ot=n.getRenderTarget(),zt=n.state.buffers.depth.getReversed(),Gt=F.isInstancedMesh===!0,Nt=F.isBatchedMesh===!0,pe=!!T.map,te=!!T.matcap,me=!!Q,H=!!T.aoMap,nn=!!T.lightMap,ne=!!T.bumpMap,se=!!T.normalMap,Vt=!!T.displacementMap,ve=!!T.emissiveMap,Lt=!!T.metalnessMap,P=!!T.roughnessMap,w=T.anisotropy>0,j=T.clearcoat>0,J=T.dispersion>0,$=T.iridescence>0,et=T.sheen>0,St=T.transmission>0,vt=w&&!!T.anisotropyMap,Tt=j&&!!T.clearcoatMap,Jt=j&&!!T.clearcoatNormalMap,ft=j&&!!T.clearcoatRoughnessMap,xt=$&&!!T.iridescenceMap,Ft=$&&!!T.iridescenceThicknessMap,kt=et&&!!T.sheenColorMap,bt=et&&!!T.sheenRoughnessMap,ae=!!T.specularMap,jt=!!T.specularColorMap,xe=!!T.specularIntensityMap,B=St&&!!T.transmissionMap,Mt=St&&!!T.thicknessMap,nt=!!T.gradientMap,rt=!!T.alphaMap,At=T.alphaTest>0,Rt=!!T.alphaHash,ee=!!T.extensions;let We=Es;T.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(We=n.toneMapping);const dn={shaderID:ht,shaderType:T.type,shaderName:T.name,vertexShader:mt,fragmentShader:it,defines:T.defines,customVertexShaderID:at,customFragmentShaderID:_t,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:f,batching:Nt,batchingColor:Nt&&F._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&F.instanceColor!==null,instancingMorph:Gt&&F.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ot===null?n.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:ur,alphaToCoverage:!!T.alphaToCoverage,map:pe,matcap:te,envMap:me,envMapMode:me&&Q.mapping,envMapCubeUVHeight:tt,aoMap:H,lightMap:nn,bumpMap:ne,normalMap:se,displacementMap:d&&Vt,emissiveMap:ve,normalMapObjectSpace:se&&T.normalMapType===jM,normalMapTangentSpace:se&&T.normalMapType===_g,metalnessMap:Lt,roughnessMap:P,anisotropy:w,anisotropyMap:vt,clearcoat:j,clearcoatMap:Tt,clearcoatNormalMap:Jt,clearcoatRoughnessMap:ft,dispersion:J,iridescence:$,iridescenceMap:xt,iridescenceThicknessMap:Ft,sheen:et,sheenColorMap:kt,sheenRoughnessMap:bt,specularMap:ae,specularColorMap:jt,specularIntensityMap:xe,transmission:St,transmissionMap:B,thicknessMap:Mt,gradientMap:nt,opaque:T.transparent===!1&&T.blending===Xr&&T.alphaToCoverage===!1,alphaMap:rt,alphaTest:At,alphaHash:Rt,combine:T.combine,mapUv:pe&&v(T.map.channel),aoMapUv:H&&v(T.aoMap.channel),lightMapUv:nn&&v(T.lightMap.channel),bumpMapUv:ne&&v(T.bumpMap.channel),normalMapUv:se&&v(T.normalMap.channel),displacementMapUv:Vt&&v(T.displacementMap.channel),emissiveMapUv:ve&&v(T.emissiveMap.channel),metalnessMapUv:Lt&&v(T.metalnessMap.channel),roughnessMapUv:P&&v(T.roughnessMap.channel),anisotropyMapUv:vt&&v(T.anisotropyMap.channel),clearcoatMapUv:Tt&&v(T.clearcoatMap.channel),clearcoatNormalMapUv:Jt&&v(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&v(T.clearcoatRoughnessMap.channel),iridescenceMapUv:xt&&v(T.iridescenceMap.channel),iridescenceThicknessMapUv:Ft&&v(T.iridescenceThicknessMap.channel),sheenColorMapUv:kt&&v(T.sheenColorMap.channel),sheenRoughnessMapUv:bt&&v(T.sheenRoughnessMap.channel),specularMapUv:ae&&v(T.specularMap.channel),specularColorMapUv:jt&&v(T.specularColorMap.channel),specularIntensityMapUv:xe&&v(T.specularIntensityMap.channel),transmissionMapUv:B&&v(T.transmissionMap.channel),thicknessMapUv:Mt&&v(T.thicknessMap.channel),alphaMapUv:rt&&v(T.alphaMap.channel),vertexTangents:!!Z.attributes.tangent&&(se||w),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!Z.attributes.color&&Z.attributes.color.itemSize===4,pointsUvs:F.isPoints===!0&&!!Z.attributes.uv&&(pe||rt),fog:!!W,useFog:T.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:T.flatShading===!0,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:zt,skinning:F.isSkinnedMesh===!0,morphTargets:Z.morphAttributes.position!==void 0,morphNormals:Z.morphAttributes.normal!==void 0,morphColors:Z.morphAttributes.color!==void 0,morphTargetsCount:gt,morphTextureStride:yt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:We,decodeVideoTexture:pe&&T.map.isVideoTexture===!0&&ye.getTransfer(T.map.colorSpace)===Le,decodeVideoTextureEmissive:ve&&T.emissiveMap.isVideoTexture===!0&&ye.getTransfer(T.emissiveMap.colorSpace)===Le,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===Di,flipSided:T.side===zn,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:ee&&T.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&T.extensions.multiDraw===!0||Nt)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return dn.vertexUv1s=c.has(1),dn.vertexUv2s=c.has(2),dn.vertexUv3s=c.has(3),c.clear(),dn}function p(T){const S=[];if(T.shaderID?S.push(T.shaderID):(S.push(T.customVertexShaderID),S.push(T.customFragmentShaderID)),T.defines!==void 0)for(const C in T.defines)S.push(C),S.push(T.defines[C]);return T.isRawShaderMaterial===!1&&(y(S,T),E(S,T),S.push(n.outputColorSpace)),S.push(T.customProgramCacheKey),S.join()}function y(T,S){T.push(S.precision),T.push(S.outputColorSpace),T.push(S.envMapMode),T.push(S.envMapCubeUVHeight),T.push(S.mapUv),T.push(S.alphaMapUv),T.push(S.lightMapUv),T.push(S.aoMapUv),T.push(S.bumpMapUv),T.push(S.normalMapUv),T.push(S.displacementMapUv),T.push(S.emissiveMapUv),T.push(S.metalnessMapUv),T.push(S.roughnessMapUv),T.push(S.anisotropyMapUv),T.push(S.clearcoatMapUv),T.push(S.clearcoatNormalMapUv),T.push(S.clearcoatRoughnessMapUv),T.push(S.iridescenceMapUv),T.push(S.iridescenceThicknessMapUv),T.push(S.sheenColorMapUv),T.push(S.sheenRoughnessMapUv),T.push(S.specularMapUv),T.push(S.specularColorMapUv),T.push(S.specularIntensityMapUv),T.push(S.transmissionMapUv),T.push(S.thicknessMapUv),T.push(S.combine),T.push(S.fogExp2),T.push(S.sizeAttenuation),T.push(S.morphTargetsCount),T.push(S.morphAttributeCount),T.push(S.numDirLights),T.push(S.numPointLights),T.push(S.numSpotLights),T.push(S.numSpotLightMaps),T.push(S.numHemiLights),T.push(S.numRectAreaLights),T.push(S.numDirLightShadows),T.push(S.numPointLightShadows),T.push(S.numSpotLightShadows),T.push(S.numSpotLightShadowsWithMaps),T.push(S.numLightProbes),T.push(S.shadowMapType),T.push(S.toneMapping),T.push(S.numClippingPlanes),T.push(S.numClipIntersection),T.push(S.depthPacking)}function E(T,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),T.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),T.push(a.mask)}function x(T){const S=g[T.type];let C;if(S){const V=Li[S];C=by.clone(V.uniforms)}else C=T.uniforms;return C}function U(T,S){let C;for(let V=0,F=u.length;V<F;V++){const W=u[V];if(W.cacheKey===S){C=W,++C.usedTimes;break}}return C===void 0&&(C=new OE(n,S,T,r),u.push(C)),C}function A(T){if(--T.usedTimes===0){const S=u.indexOf(T);u[S]=u[u.length-1],u.pop(),T.destroy()}}function D(T){l.remove(T)}function I(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:x,acquireProgram:U,releaseProgram:A,releaseShaderCache:D,programs:u,dispose:I}}function GE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function VE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function xp(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Mp(){const n=[];let t=0;const e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h,d,f,g,v,m){let p=n[t];return p===void 0?(p={id:h.id,object:h,geometry:d,material:f,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},n[t]=p):(p.id=h.id,p.object=h,p.geometry=d,p.material=f,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,d,f,g,v,m){const p=o(h,d,f,g,v,m);f.transmission>0?i.push(p):f.transparent===!0?s.push(p):e.push(p)}function l(h,d,f,g,v,m){const p=o(h,d,f,g,v,m);f.transmission>0?i.unshift(p):f.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,d){e.length>1&&e.sort(h||VE),i.length>1&&i.sort(d||xp),s.length>1&&s.sort(d||xp)}function u(){for(let h=t,d=n.length;h<d;h++){const f=n[h];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function WE(){let n=new WeakMap;function t(i,s){const r=n.get(i);let o;return r===void 0?(o=new Mp,n.set(i,[o])):s>=r.length?(o=new Mp,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function $E(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new z,color:new de};break;case"SpotLight":e={position:new z,direction:new z,color:new de,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new de,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new de,groundColor:new de};break;case"RectAreaLight":e={color:new de,position:new z,halfWidth:new z,halfHeight:new z};break}return n[t.id]=e,e}}}function XE(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new fe};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new fe};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new fe,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}let qE=0;function YE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function jE(n){const t=new $E,e=XE(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);const s=new z,r=new ke,o=new ke;function a(c){let u=0,h=0,d=0;for(let T=0;T<9;T++)i.probe[T].set(0,0,0);let f=0,g=0,v=0,m=0,p=0,y=0,E=0,x=0,U=0,A=0,D=0;c.sort(YE);for(let T=0,S=c.length;T<S;T++){const C=c[T],V=C.color,F=C.intensity,W=C.distance,Z=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=V.r*F,h+=V.g*F,d+=V.b*F;else if(C.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(C.sh.coefficients[K],F);D++}else if(C.isDirectionalLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.directionalShadow[f]=tt,i.directionalShadowMap[f]=Z,i.directionalShadowMatrix[f]=C.shadow.matrix,y++}i.directional[f]=K,f++}else if(C.isSpotLight){const K=t.get(C);K.position.setFromMatrixPosition(C.matrixWorld),K.color.copy(V).multiplyScalar(F),K.distance=W,K.coneCos=Math.cos(C.angle),K.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),K.decay=C.decay,i.spot[v]=K;const Q=C.shadow;if(C.map&&(i.spotLightMap[U]=C.map,U++,Q.updateMatrices(C),C.castShadow&&A++),i.spotLightMatrix[v]=Q.matrix,C.castShadow){const tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.spotShadow[v]=tt,i.spotShadowMap[v]=Z,x++}v++}else if(C.isRectAreaLight){const K=t.get(C);K.color.copy(V).multiplyScalar(F),K.halfWidth.set(C.width*.5,0,0),K.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=K,m++}else if(C.isPointLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),K.distance=C.distance,K.decay=C.decay,C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,i.pointShadow[g]=tt,i.pointShadowMap[g]=Z,i.pointShadowMatrix[g]=C.shadow.matrix,E++}i.point[g]=K,g++}else if(C.isHemisphereLight){const K=t.get(C);K.skyColor.copy(C.color).multiplyScalar(F),K.groundColor.copy(C.groundColor).multiplyScalar(F),i.hemi[p]=K,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Et.LTC_FLOAT_1,i.rectAreaLTC2=Et.LTC_FLOAT_2):(i.rectAreaLTC1=Et.LTC_HALF_1,i.rectAreaLTC2=Et.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;const I=i.hash;(I.directionalLength!==f||I.pointLength!==g||I.spotLength!==v||I.rectAreaLength!==m||I.hemiLength!==p||I.numDirectionalShadows!==y||I.numPointShadows!==E||I.numSpotShadows!==x||I.numSpotMaps!==U||I.numLightProbes!==D)&&(i.directional.length=f,i.spot.length=v,i.rectArea.length=m,i.point.length=g,i.hemi.length=p,i.directionalShadow.length=y,i.directionalShadowMap.length=y,i.pointShadow.length=E,i.pointShadowMap.length=E,i.spotShadow.length=x,i.spotShadowMap.length=x,i.directionalShadowMatrix.length=y,i.pointShadowMatrix.length=E,i.spotLightMatrix.length=x+U-A,i.spotLightMap.length=U,i.numSpotLightShadowsWithMaps=A,i.numLightProbes=D,I.directionalLength=f,I.pointLength=g,I.spotLength=v,I.rectAreaLength=m,I.hemiLength=p,I.numDirectionalShadows=y,I.numPointShadows=E,I.numSpotShadows=x,I.numSpotMaps=U,I.numLightProbes=D,i.version=qE++)}function l(c,u){let h=0,d=0,f=0,g=0,v=0;const m=u.matrixWorldInverse;for(let p=0,y=c.length;p<y;p++){const E=c[p];if(E.isDirectionalLight){const x=i.directional[h];x.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),h++}else if(E.isSpotLight){const x=i.spot[f];x.position.setFromMatrixPosition(E.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),f++}else if(E.isRectAreaLight){const x=i.rectArea[g];x.position.setFromMatrixPosition(E.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(E.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(E.width*.5,0,0),x.halfHeight.set(0,E.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),g++}else if(E.isPointLight){const x=i.point[d];x.position.setFromMatrixPosition(E.matrixWorld),x.position.applyMatrix4(m),d++}else if(E.isHemisphereLight){const x=i.hemi[v];x.direction.setFromMatrixPosition(E.matrixWorld),x.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function yp(n){const t=new jE(n),e=[],i=[];function s(u){c.camera=u,e.length=0,i.length=0}function r(u){e.push(u)}function o(u){i.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function KE(n){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new yp(n),t.set(s,[a])):r>=o.length?(a=new yp(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}class ZE extends hr{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=qM,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class JE extends hr{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const QE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,tT=`uniform sampler2D shadow_pass;
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
}`;function eT(n,t,e){let i=new Gh;const s=new fe,r=new fe,o=new qe,a=new ZE({depthPacking:YM}),l=new JE,c={},u=e.maxTextureSize,h={[Cs]:zn,[zn]:Cs,[Di]:Di},d=new Ps({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new fe},radius:{value:4}},vertexShader:QE,fragmentShader:tT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;const g=new hn;g.setAttribute("position",new Gn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new An(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=rg;let p=this.type;this.render=function(A,D,I){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;const T=n.getRenderTarget(),S=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),V=n.state;V.setBlending(bs),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const F=p!==Zi&&this.type===Zi,W=p===Zi&&this.type!==Zi;for(let Z=0,K=A.length;Z<K;Z++){const Q=A[Z],tt=Q.shadow;if(tt===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(tt.autoUpdate===!1&&tt.needsUpdate===!1)continue;s.copy(tt.mapSize);const ht=tt.getFrameExtents();if(s.multiply(ht),r.copy(tt.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,tt.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,tt.mapSize.y=r.y)),tt.map===null||F===!0||W===!0){const gt=this.type!==Zi?{minFilter:Si,magFilter:Si}:{};tt.map!==null&&tt.map.dispose(),tt.map=new ar(s.x,s.y,gt),tt.map.texture.name=Q.name+".shadowMap",tt.camera.updateProjectionMatrix()}n.setRenderTarget(tt.map),n.clear();const ct=tt.getViewportCount();for(let gt=0;gt<ct;gt++){const yt=tt.getViewport(gt);o.set(r.x*yt.x,r.y*yt.y,r.x*yt.z,r.y*yt.w),V.viewport(o),tt.updateMatrices(Q,gt),i=tt.getFrustum(),x(D,I,tt.camera,Q,this.type)}tt.isPointLightShadow!==!0&&this.type===Zi&&y(tt,I),tt.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(T,S,C)};function y(A,D){const I=t.update(v);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new ar(s.x,s.y)),d.uniforms.shadow_pass.value=A.map.texture,d.uniforms.resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(D,null,I,d,v,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(D,null,I,f,v,null)}function E(A,D,I,T){let S=null;const C=I.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)S=C;else if(S=I.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const V=S.uuid,F=D.uuid;let W=c[V];W===void 0&&(W={},c[V]=W);let Z=W[F];Z===void 0&&(Z=S.clone(),W[F]=Z,D.addEventListener("dispose",U)),S=Z}if(S.visible=D.visible,S.wireframe=D.wireframe,T===Zi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:h[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,I.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const V=n.properties.get(S);V.light=I}return S}function x(A,D,I,T,S){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&S===Zi)&&(!A.frustumCulled||i.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(I.matrixWorldInverse,A.matrixWorld);const F=t.update(A),W=A.material;if(Array.isArray(W)){const Z=F.groups;for(let K=0,Q=Z.length;K<Q;K++){const tt=Z[K],ht=W[tt.materialIndex];if(ht&&ht.visible){const ct=E(A,ht,T,S);A.onBeforeShadow(n,A,D,I,F,ct,tt),n.renderBufferDirect(I,null,F,ct,A,tt),A.onAfterShadow(n,A,D,I,F,ct,tt)}}}else if(W.visible){const Z=E(A,W,T,S);A.onBeforeShadow(n,A,D,I,F,Z,null),n.renderBufferDirect(I,null,F,Z,A,null),A.onAfterShadow(n,A,D,I,F,Z,null)}}const V=A.children;for(let F=0,W=V.length;F<W;F++)x(V[F],D,I,T,S)}function U(A){A.target.removeEventListener("dispose",U);for(const I in c){const T=c[I],S=A.target.uuid;S in T&&(T[S].dispose(),delete T[S])}}}const nT={[hu]:du,[fu]:gu,[pu]:_u,[no]:mu,[du]:hu,[gu]:fu,[_u]:pu,[mu]:no};function iT(n,t){function e(){let B=!1;const Mt=new qe;let nt=null;const rt=new qe(0,0,0,0);return{setMask:function(At){nt!==At&&!B&&(n.colorMask(At,At,At,At),nt=At)},setLocked:function(At){B=At},setClear:function(At,Rt,ee,We,dn){dn===!0&&(At*=We,Rt*=We,ee*=We),Mt.set(At,Rt,ee,We),rt.equals(Mt)===!1&&(n.clearColor(At,Rt,ee,We),rt.copy(Mt))},reset:function(){B=!1,nt=null,rt.set(-1,0,0,0)}}}function i(){let B=!1,Mt=!1,nt=null,rt=null,At=null;return{setReversed:function(Rt){if(Mt!==Rt){const ee=t.get("EXT_clip_control");Mt?ee.clipControlEXT(ee.LOWER_LEFT_EXT,ee.ZERO_TO_ONE_EXT):ee.clipControlEXT(ee.LOWER_LEFT_EXT,ee.NEGATIVE_ONE_TO_ONE_EXT);const We=At;At=null,this.setClear(We)}Mt=Rt},getReversed:function(){return Mt},setTest:function(Rt){Rt?ot(n.DEPTH_TEST):zt(n.DEPTH_TEST)},setMask:function(Rt){nt!==Rt&&!B&&(n.depthMask(Rt),nt=Rt)},setFunc:function(Rt){if(Mt&&(Rt=nT[Rt]),rt!==Rt){switch(Rt){case hu:n.depthFunc(n.NEVER);break;case du:n.depthFunc(n.ALWAYS);break;case fu:n.depthFunc(n.LESS);break;case no:n.depthFunc(n.LEQUAL);break;case pu:n.depthFunc(n.EQUAL);break;case mu:n.depthFunc(n.GEQUAL);break;case gu:n.depthFunc(n.GREATER);break;case _u:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}rt=Rt}},setLocked:function(Rt){B=Rt},setClear:function(Rt){At!==Rt&&(Mt&&(Rt=1-Rt),n.clearDepth(Rt),At=Rt)},reset:function(){B=!1,nt=null,rt=null,At=null,Mt=!1}}}function s(){let B=!1,Mt=null,nt=null,rt=null,At=null,Rt=null,ee=null,We=null,dn=null;return{setTest:function(be){B||(be?ot(n.STENCIL_TEST):zt(n.STENCIL_TEST))},setMask:function(be){Mt!==be&&!B&&(n.stencilMask(be),Mt=be)},setFunc:function(be,sn,Fe){(nt!==be||rt!==sn||At!==Fe)&&(n.stencilFunc(be,sn,Fe),nt=be,rt=sn,At=Fe)},setOp:function(be,sn,Fe){(Rt!==be||ee!==sn||We!==Fe)&&(n.stencilOp(be,sn,Fe),Rt=be,ee=sn,We=Fe)},setLocked:function(be){B=be},setClear:function(be){dn!==be&&(n.clearStencil(be),dn=be)},reset:function(){B=!1,Mt=null,nt=null,rt=null,At=null,Rt=null,ee=null,We=null,dn=null}}}const r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},d=new WeakMap,f=[],g=null,v=!1,m=null,p=null,y=null,E=null,x=null,U=null,A=null,D=new de(0,0,0),I=0,T=!1,S=null,C=null,V=null,F=null,W=null;const Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let K=!1,Q=0;const tt=n.getParameter(n.VERSION);tt.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(tt)[1]),K=Q>=1):tt.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(tt)[1]),K=Q>=2);let ht=null,ct={};const gt=n.getParameter(n.SCISSOR_BOX),yt=n.getParameter(n.VIEWPORT),mt=new qe().fromArray(gt),it=new qe().fromArray(yt);function at(B,Mt,nt,rt){const At=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(B,Rt),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let ee=0;ee<nt;ee++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(Mt,0,n.RGBA,1,1,rt,0,n.RGBA,n.UNSIGNED_BYTE,At):n.texImage2D(Mt+ee,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,At);return Rt}const _t={};_t[n.TEXTURE_2D]=at(n.TEXTURE_2D,n.TEXTURE_2D,1),_t[n.TEXTURE_CUBE_MAP]=at(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),_t[n.TEXTURE_2D_ARRAY]=at(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),_t[n.TEXTURE_3D]=at(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(n.DEPTH_TEST),o.setFunc(no),ne(!1),se(Ef),ot(n.CULL_FACE),H(bs);function ot(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function zt(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function Gt(B,Mt){return h[B]!==Mt?(n.bindFramebuffer(B,Mt),h[B]=Mt,B===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=Mt),B===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=Mt),!0):!1}function Nt(B,Mt){let nt=f,rt=!1;if(B){nt=d.get(Mt),nt===void 0&&(nt=[],d.set(Mt,nt));const At=B.textures;if(nt.length!==At.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,ee=At.length;Rt<ee;Rt++)nt[Rt]=n.COLOR_ATTACHMENT0+Rt;nt.length=At.length,rt=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,rt=!0);rt&&n.drawBuffers(nt)}function pe(B){return g!==B?(n.useProgram(B),g=B,!0):!1}const te={[Zs]:n.FUNC_ADD,[MM]:n.FUNC_SUBTRACT,[yM]:n.FUNC_REVERSE_SUBTRACT};te[SM]=n.MIN,te[wM]=n.MAX;const me={[bM]:n.ZERO,[EM]:n.ONE,[TM]:n.SRC_COLOR,[cu]:n.SRC_ALPHA,[DM]:n.SRC_ALPHA_SATURATE,[PM]:n.DST_COLOR,[RM]:n.DST_ALPHA,[AM]:n.ONE_MINUS_SRC_COLOR,[uu]:n.ONE_MINUS_SRC_ALPHA,[LM]:n.ONE_MINUS_DST_COLOR,[CM]:n.ONE_MINUS_DST_ALPHA,[IM]:n.CONSTANT_COLOR,[UM]:n.ONE_MINUS_CONSTANT_COLOR,[NM]:n.CONSTANT_ALPHA,[FM]:n.ONE_MINUS_CONSTANT_ALPHA};function H(B,Mt,nt,rt,At,Rt,ee,We,dn,be){if(B===bs){v===!0&&(zt(n.BLEND),v=!1);return}if(v===!1&&(ot(n.BLEND),v=!0),B!==xM){if(B!==m||be!==T){if((p!==Zs||x!==Zs)&&(n.blendEquation(n.FUNC_ADD),p=Zs,x=Zs),be)switch(B){case Xr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Tf:n.blendFunc(n.ONE,n.ONE);break;case Af:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Rf:n.blendFuncSeparate(n.ZERO,n.SRC_COLOR,n.ZERO,n.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}else switch(B){case Xr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Tf:n.blendFunc(n.SRC_ALPHA,n.ONE);break;case Af:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Rf:n.blendFunc(n.ZERO,n.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}y=null,E=null,U=null,A=null,D.set(0,0,0),I=0,m=B,T=be}return}At=At||Mt,Rt=Rt||nt,ee=ee||rt,(Mt!==p||At!==x)&&(n.blendEquationSeparate(te[Mt],te[At]),p=Mt,x=At),(nt!==y||rt!==E||Rt!==U||ee!==A)&&(n.blendFuncSeparate(me[nt],me[rt],me[Rt],me[ee]),y=nt,E=rt,U=Rt,A=ee),(We.equals(D)===!1||dn!==I)&&(n.blendColor(We.r,We.g,We.b,dn),D.copy(We),I=dn),m=B,T=!1}function nn(B,Mt){B.side===Di?zt(n.CULL_FACE):ot(n.CULL_FACE);let nt=B.side===zn;Mt&&(nt=!nt),ne(nt),B.blending===Xr&&B.transparent===!1?H(bs):H(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);const rt=B.stencilWrite;a.setTest(rt),rt&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),ve(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?ot(n.SAMPLE_ALPHA_TO_COVERAGE):zt(n.SAMPLE_ALPHA_TO_COVERAGE)}function ne(B){S!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),S=B)}function se(B){B!==gM?(ot(n.CULL_FACE),B!==C&&(B===Ef?n.cullFace(n.BACK):B===_M?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):zt(n.CULL_FACE),C=B}function Vt(B){B!==V&&(K&&n.lineWidth(B),V=B)}function ve(B,Mt,nt){B?(ot(n.POLYGON_OFFSET_FILL),(F!==Mt||W!==nt)&&(n.polygonOffset(Mt,nt),F=Mt,W=nt)):zt(n.POLYGON_OFFSET_FILL)}function Lt(B){B?ot(n.SCISSOR_TEST):zt(n.SCISSOR_TEST)}function P(B){B===void 0&&(B=n.TEXTURE0+Z-1),ht!==B&&(n.activeTexture(B),ht=B)}function w(B,Mt,nt){nt===void 0&&(ht===null?nt=n.TEXTURE0+Z-1:nt=ht);let rt=ct[nt];rt===void 0&&(rt={type:void 0,texture:void 0},ct[nt]=rt),(rt.type!==B||rt.texture!==Mt)&&(ht!==nt&&(n.activeTexture(nt),ht=nt),n.bindTexture(B,Mt||_t[B]),rt.type=B,rt.texture=Mt)}function j(){const B=ct[ht];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function J(){try{n.compressedTexImage2D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function $(){try{n.compressedTexImage3D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function et(){try{n.texSubImage2D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function St(){try{n.texSubImage3D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function vt(){try{n.compressedTexSubImage2D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Tt(){try{n.compressedTexSubImage3D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Jt(){try{n.texStorage2D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function ft(){try{n.texStorage3D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function xt(){try{n.texImage2D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Ft(){try{n.texImage3D.apply(n,arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function kt(B){mt.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),mt.copy(B))}function bt(B){it.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),it.copy(B))}function ae(B,Mt){let nt=c.get(Mt);nt===void 0&&(nt=new WeakMap,c.set(Mt,nt));let rt=nt.get(B);rt===void 0&&(rt=n.getUniformBlockIndex(Mt,B.name),nt.set(B,rt))}function jt(B,Mt){const rt=c.get(Mt).get(B);l.get(Mt)!==rt&&(n.uniformBlockBinding(Mt,rt,B.__bindingPointIndex),l.set(Mt,rt))}function xe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},ht=null,ct={},h={},d=new WeakMap,f=[],g=null,v=!1,m=null,p=null,y=null,E=null,x=null,U=null,A=null,D=new de(0,0,0),I=0,T=!1,S=null,C=null,V=null,F=null,W=null,mt.set(0,0,n.canvas.width,n.canvas.height),it.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:zt,bindFramebuffer:Gt,drawBuffers:Nt,useProgram:pe,setBlending:H,setMaterial:nn,setFlipSided:ne,setCullFace:se,setLineWidth:Vt,setPolygonOffset:ve,setScissorTest:Lt,activeTexture:P,bindTexture:w,unbindTexture:j,compressedTexImage2D:J,compressedTexImage3D:$,texImage2D:xt,texImage3D:Ft,updateUBOMapping:ae,uniformBlockBinding:jt,texStorage2D:Jt,texStorage3D:ft,texSubImage2D:et,texSubImage3D:St,compressedTexSubImage2D:vt,compressedTexSubImage3D:Tt,scissor:kt,viewport:bt,reset:xe}}function Sp(n,t,e,i){const s=sT(i);switch(e){case ug:return n*t;case dg:return n*t;case fg:return n*t*2;case pg:return n*t/s.components*s.byteLength;case kh:return n*t/s.components*s.byteLength;case mg:return n*t*2/s.components*s.byteLength;case Bh:return n*t*2/s.components*s.byteLength;case hg:return n*t*3/s.components*s.byteLength;case Mi:return n*t*4/s.components*s.byteLength;case zh:return n*t*4/s.components*s.byteLength;case Ja:case Qa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case tl:case el:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case wu:case Eu:return Math.max(n,16)*Math.max(t,8)/4;case Su:case bu:return Math.max(n,8)*Math.max(t,8)/2;case Tu:case Au:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ru:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Cu:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Pu:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Lu:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Du:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Iu:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Uu:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Nu:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Fu:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Ou:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case ku:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Bu:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case zu:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Hu:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Gu:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case nl:case Vu:case Wu:return Math.ceil(n/4)*Math.ceil(t/4)*16;case gg:case $u:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Xu:case qu:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function sT(n){switch(n){case os:case ag:return{byteLength:1,components:1};case Yo:case lg:case Jo:return{byteLength:2,components:1};case Fh:case Oh:return{byteLength:2,components:4};case or:case Nh:case ts:return{byteLength:4,components:1};case cg:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}function rT(n,t,e,i,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new fe,u=new WeakMap;let h;const d=new WeakMap;let f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,w){return f?new OffscreenCanvas(P,w):pl("canvas")}function v(P,w,j){let J=1;const $=Lt(P);if(($.width>j||$.height>j)&&(J=j/Math.max($.width,$.height)),J<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){const et=Math.floor(J*$.width),St=Math.floor(J*$.height);h===void 0&&(h=g(et,St));const vt=w?g(et,St):h;return vt.width=et,vt.height=St,vt.getContext("2d").drawImage(P,0,0,et,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+$.width+"x"+$.height+") to ("+et+"x"+St+")."),vt}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+$.width+"x"+$.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){n.generateMipmap(P)}function y(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(P,w,j,J,$=!1){if(P!==null){if(n[P]!==void 0)return n[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=w;if(w===n.RED&&(j===n.FLOAT&&(et=n.R32F),j===n.HALF_FLOAT&&(et=n.R16F),j===n.UNSIGNED_BYTE&&(et=n.R8)),w===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.R8UI),j===n.UNSIGNED_SHORT&&(et=n.R16UI),j===n.UNSIGNED_INT&&(et=n.R32UI),j===n.BYTE&&(et=n.R8I),j===n.SHORT&&(et=n.R16I),j===n.INT&&(et=n.R32I)),w===n.RG&&(j===n.FLOAT&&(et=n.RG32F),j===n.HALF_FLOAT&&(et=n.RG16F),j===n.UNSIGNED_BYTE&&(et=n.RG8)),w===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.RG8UI),j===n.UNSIGNED_SHORT&&(et=n.RG16UI),j===n.UNSIGNED_INT&&(et=n.RG32UI),j===n.BYTE&&(et=n.RG8I),j===n.SHORT&&(et=n.RG16I),j===n.INT&&(et=n.RG32I)),w===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.RGB8UI),j===n.UNSIGNED_SHORT&&(et=n.RGB16UI),j===n.UNSIGNED_INT&&(et=n.RGB32UI),j===n.BYTE&&(et=n.RGB8I),j===n.SHORT&&(et=n.RGB16I),j===n.INT&&(et=n.RGB32I)),w===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),j===n.UNSIGNED_INT&&(et=n.RGBA32UI),j===n.BYTE&&(et=n.RGBA8I),j===n.SHORT&&(et=n.RGBA16I),j===n.INT&&(et=n.RGBA32I)),w===n.RGB&&j===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),w===n.RGBA){const St=$?Ul:ye.getTransfer(J);j===n.FLOAT&&(et=n.RGBA32F),j===n.HALF_FLOAT&&(et=n.RGBA16F),j===n.UNSIGNED_BYTE&&(et=St===Le?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(P,w){let j;return P?w===null||w===or||w===ro?j=n.DEPTH24_STENCIL8:w===ts?j=n.DEPTH32F_STENCIL8:w===Yo&&(j=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===or||w===ro?j=n.DEPTH_COMPONENT24:w===ts?j=n.DEPTH_COMPONENT32F:w===Yo&&(j=n.DEPTH_COMPONENT16),j}function U(P,w){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==Si&&P.minFilter!==Ni?Math.log2(Math.max(w.width,w.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?w.mipmaps.length:1}function A(P){const w=P.target;w.removeEventListener("dispose",A),I(w),w.isVideoTexture&&u.delete(w)}function D(P){const w=P.target;w.removeEventListener("dispose",D),S(w)}function I(P){const w=i.get(P);if(w.__webglInit===void 0)return;const j=P.source,J=d.get(j);if(J){const $=J[w.__cacheKey];$.usedTimes--,$.usedTimes===0&&T(P),Object.keys(J).length===0&&d.delete(j)}i.remove(P)}function T(P){const w=i.get(P);n.deleteTexture(w.__webglTexture);const j=P.source,J=d.get(j);delete J[w.__cacheKey],o.memory.textures--}function S(P){const w=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(w.__webglFramebuffer[J]))for(let $=0;$<w.__webglFramebuffer[J].length;$++)n.deleteFramebuffer(w.__webglFramebuffer[J][$]);else n.deleteFramebuffer(w.__webglFramebuffer[J]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[J])}else{if(Array.isArray(w.__webglFramebuffer))for(let J=0;J<w.__webglFramebuffer.length;J++)n.deleteFramebuffer(w.__webglFramebuffer[J]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let J=0;J<w.__webglColorRenderbuffer.length;J++)w.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[J]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}const j=P.textures;for(let J=0,$=j.length;J<$;J++){const et=i.get(j[J]);et.__webglTexture&&(n.deleteTexture(et.__webglTexture),o.memory.textures--),i.remove(j[J])}i.remove(P)}let C=0;function V(){C=0}function F(){const P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function W(P){const w=[];return w.push(P.wrapS),w.push(P.wrapT),w.push(P.wrapR||0),w.push(P.magFilter),w.push(P.minFilter),w.push(P.anisotropy),w.push(P.internalFormat),w.push(P.format),w.push(P.type),w.push(P.generateMipmaps),w.push(P.premultiplyAlpha),w.push(P.flipY),w.push(P.unpackAlignment),w.push(P.colorSpace),w.join()}function Z(P,w){const j=i.get(P);if(P.isVideoTexture&&Vt(P),P.isRenderTargetTexture===!1&&P.version>0&&j.__version!==P.version){const J=P.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{it(j,P,w);return}}e.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+w)}function K(P,w){const j=i.get(P);if(P.version>0&&j.__version!==P.version){it(j,P,w);return}e.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+w)}function Q(P,w){const j=i.get(P);if(P.version>0&&j.__version!==P.version){it(j,P,w);return}e.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+w)}function tt(P,w){const j=i.get(P);if(P.version>0&&j.__version!==P.version){at(j,P,w);return}e.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+w)}const ht={[Mu]:n.REPEAT,[Qs]:n.CLAMP_TO_EDGE,[yu]:n.MIRRORED_REPEAT},ct={[Si]:n.NEAREST,[XM]:n.NEAREST_MIPMAP_NEAREST,[ma]:n.NEAREST_MIPMAP_LINEAR,[Ni]:n.LINEAR,[cc]:n.LINEAR_MIPMAP_NEAREST,[tr]:n.LINEAR_MIPMAP_LINEAR},gt={[KM]:n.NEVER,[ny]:n.ALWAYS,[ZM]:n.LESS,[vg]:n.LEQUAL,[JM]:n.EQUAL,[ey]:n.GEQUAL,[QM]:n.GREATER,[ty]:n.NOTEQUAL};function yt(P,w){if(w.type===ts&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===Ni||w.magFilter===cc||w.magFilter===ma||w.magFilter===tr||w.minFilter===Ni||w.minFilter===cc||w.minFilter===ma||w.minFilter===tr)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ht[w.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ht[w.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ht[w.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ct[w.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ct[w.minFilter]),w.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,gt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Si||w.minFilter!==ma&&w.minFilter!==tr||w.type===ts&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){const j=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function mt(P,w){let j=!1;P.__webglInit===void 0&&(P.__webglInit=!0,w.addEventListener("dispose",A));const J=w.source;let $=d.get(J);$===void 0&&($={},d.set(J,$));const et=W(w);if(et!==P.__cacheKey){$[et]===void 0&&($[et]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),$[et].usedTimes++;const St=$[P.__cacheKey];St!==void 0&&($[P.__cacheKey].usedTimes--,St.usedTimes===0&&T(w)),P.__cacheKey=et,P.__webglTexture=$[et].texture}return j}function it(P,w,j){let J=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(J=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(J=n.TEXTURE_3D);const $=mt(P,w),et=w.source;e.bindTexture(J,P.__webglTexture,n.TEXTURE0+j);const St=i.get(et);if(et.version!==St.__version||$===!0){e.activeTexture(n.TEXTURE0+j);const vt=ye.getPrimaries(ye.workingColorSpace),Tt=w.colorSpace===Ss?null:ye.getPrimaries(w.colorSpace),Jt=w.colorSpace===Ss||vt===Tt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Jt);let ft=v(w.image,!1,s.maxTextureSize);ft=ve(w,ft);const xt=r.convert(w.format,w.colorSpace),Ft=r.convert(w.type);let kt=E(w.internalFormat,xt,Ft,w.colorSpace,w.isVideoTexture);yt(J,w);let bt;const ae=w.mipmaps,jt=w.isVideoTexture!==!0,xe=St.__version===void 0||$===!0,B=et.dataReady,Mt=U(w,ft);if(w.isDepthTexture)kt=x(w.format===oo,w.type),xe&&(jt?e.texStorage2D(n.TEXTURE_2D,1,kt,ft.width,ft.height):e.texImage2D(n.TEXTURE_2D,0,kt,ft.width,ft.height,0,xt,Ft,null));else if(w.isDataTexture)if(ae.length>0){jt&&xe&&e.texStorage2D(n.TEXTURE_2D,Mt,kt,ae[0].width,ae[0].height);for(let nt=0,rt=ae.length;nt<rt;nt++)bt=ae[nt],jt?B&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,bt.width,bt.height,xt,Ft,bt.data):e.texImage2D(n.TEXTURE_2D,nt,kt,bt.width,bt.height,0,xt,Ft,bt.data);w.generateMipmaps=!1}else jt?(xe&&e.texStorage2D(n.TEXTURE_2D,Mt,kt,ft.width,ft.height),B&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ft.width,ft.height,xt,Ft,ft.data)):e.texImage2D(n.TEXTURE_2D,0,kt,ft.width,ft.height,0,xt,Ft,ft.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){jt&&xe&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Mt,kt,ae[0].width,ae[0].height,ft.depth);for(let nt=0,rt=ae.length;nt<rt;nt++)if(bt=ae[nt],w.format!==Mi)if(xt!==null)if(jt){if(B)if(w.layerUpdates.size>0){const At=Sp(bt.width,bt.height,w.format,w.type);for(const Rt of w.layerUpdates){const ee=bt.data.subarray(Rt*At/bt.data.BYTES_PER_ELEMENT,(Rt+1)*At/bt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,Rt,bt.width,bt.height,1,xt,ee)}w.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,bt.width,bt.height,ft.depth,xt,bt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,nt,kt,bt.width,bt.height,ft.depth,0,bt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else jt?B&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,nt,0,0,0,bt.width,bt.height,ft.depth,xt,Ft,bt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,nt,kt,bt.width,bt.height,ft.depth,0,xt,Ft,bt.data)}else{jt&&xe&&e.texStorage2D(n.TEXTURE_2D,Mt,kt,ae[0].width,ae[0].height);for(let nt=0,rt=ae.length;nt<rt;nt++)bt=ae[nt],w.format!==Mi?xt!==null?jt?B&&e.compressedTexSubImage2D(n.TEXTURE_2D,nt,0,0,bt.width,bt.height,xt,bt.data):e.compressedTexImage2D(n.TEXTURE_2D,nt,kt,bt.width,bt.height,0,bt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):jt?B&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,bt.width,bt.height,xt,Ft,bt.data):e.texImage2D(n.TEXTURE_2D,nt,kt,bt.width,bt.height,0,xt,Ft,bt.data)}else if(w.isDataArrayTexture)if(jt){if(xe&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Mt,kt,ft.width,ft.height,ft.depth),B)if(w.layerUpdates.size>0){const nt=Sp(ft.width,ft.height,w.format,w.type);for(const rt of w.layerUpdates){const At=ft.data.subarray(rt*nt/ft.data.BYTES_PER_ELEMENT,(rt+1)*nt/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,xt,Ft,At)}w.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,xt,Ft,ft.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,kt,ft.width,ft.height,ft.depth,0,xt,Ft,ft.data);else if(w.isData3DTexture)jt?(xe&&e.texStorage3D(n.TEXTURE_3D,Mt,kt,ft.width,ft.height,ft.depth),B&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,xt,Ft,ft.data)):e.texImage3D(n.TEXTURE_3D,0,kt,ft.width,ft.height,ft.depth,0,xt,Ft,ft.data);else if(w.isFramebufferTexture){if(xe)if(jt)e.texStorage2D(n.TEXTURE_2D,Mt,kt,ft.width,ft.height);else{let nt=ft.width,rt=ft.height;for(let At=0;At<Mt;At++)e.texImage2D(n.TEXTURE_2D,At,kt,nt,rt,0,xt,Ft,null),nt>>=1,rt>>=1}}else if(ae.length>0){if(jt&&xe){const nt=Lt(ae[0]);e.texStorage2D(n.TEXTURE_2D,Mt,kt,nt.width,nt.height)}for(let nt=0,rt=ae.length;nt<rt;nt++)bt=ae[nt],jt?B&&e.texSubImage2D(n.TEXTURE_2D,nt,0,0,xt,Ft,bt):e.texImage2D(n.TEXTURE_2D,nt,kt,xt,Ft,bt);w.generateMipmaps=!1}else if(jt){if(xe){const nt=Lt(ft);e.texStorage2D(n.TEXTURE_2D,Mt,kt,nt.width,nt.height)}B&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,xt,Ft,ft)}else e.texImage2D(n.TEXTURE_2D,0,kt,xt,Ft,ft);m(w)&&p(J),St.__version=et.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function at(P,w,j){if(w.image.length!==6)return;const J=mt(P,w),$=w.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+j);const et=i.get($);if($.version!==et.__version||J===!0){e.activeTexture(n.TEXTURE0+j);const St=ye.getPrimaries(ye.workingColorSpace),vt=w.colorSpace===Ss?null:ye.getPrimaries(w.colorSpace),Tt=w.colorSpace===Ss||St===vt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Tt);const Jt=w.isCompressedTexture||w.image[0].isCompressedTexture,ft=w.image[0]&&w.image[0].isDataTexture,xt=[];for(let rt=0;rt<6;rt++)!Jt&&!ft?xt[rt]=v(w.image[rt],!0,s.maxCubemapSize):xt[rt]=ft?w.image[rt].image:w.image[rt],xt[rt]=ve(w,xt[rt]);const Ft=xt[0],kt=r.convert(w.format,w.colorSpace),bt=r.convert(w.type),ae=E(w.internalFormat,kt,bt,w.colorSpace),jt=w.isVideoTexture!==!0,xe=et.__version===void 0||J===!0,B=$.dataReady;let Mt=U(w,Ft);yt(n.TEXTURE_CUBE_MAP,w);let nt;if(Jt){jt&&xe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Mt,ae,Ft.width,Ft.height);for(let rt=0;rt<6;rt++){nt=xt[rt].mipmaps;for(let At=0;At<nt.length;At++){const Rt=nt[At];w.format!==Mi?kt!==null?jt?B&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,0,0,Rt.width,Rt.height,kt,Rt.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,ae,Rt.width,Rt.height,0,Rt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):jt?B&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,0,0,Rt.width,Rt.height,kt,bt,Rt.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,ae,Rt.width,Rt.height,0,kt,bt,Rt.data)}}}else{if(nt=w.mipmaps,jt&&xe){nt.length>0&&Mt++;const rt=Lt(xt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Mt,ae,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){jt?B&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,xt[rt].width,xt[rt].height,kt,bt,xt[rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ae,xt[rt].width,xt[rt].height,0,kt,bt,xt[rt].data);for(let At=0;At<nt.length;At++){const ee=nt[At].image[rt].image;jt?B&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,0,0,ee.width,ee.height,kt,bt,ee.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,ae,ee.width,ee.height,0,kt,bt,ee.data)}}else{jt?B&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,kt,bt,xt[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ae,kt,bt,xt[rt]);for(let At=0;At<nt.length;At++){const Rt=nt[At];jt?B&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,0,0,kt,bt,Rt.image[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,ae,kt,bt,Rt.image[rt])}}}m(w)&&p(n.TEXTURE_CUBE_MAP),et.__version=$.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function _t(P,w,j,J,$,et){const St=r.convert(j.format,j.colorSpace),vt=r.convert(j.type),Tt=E(j.internalFormat,St,vt,j.colorSpace),Jt=i.get(w),ft=i.get(j);if(ft.__renderTarget=w,!Jt.__hasExternalTextures){const xt=Math.max(1,w.width>>et),Ft=Math.max(1,w.height>>et);$===n.TEXTURE_3D||$===n.TEXTURE_2D_ARRAY?e.texImage3D($,et,Tt,xt,Ft,w.depth,0,St,vt,null):e.texImage2D($,et,Tt,xt,Ft,0,St,vt,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),se(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,J,$,ft.__webglTexture,0,ne(w)):($===n.TEXTURE_2D||$>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&$<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,J,$,ft.__webglTexture,et),e.bindFramebuffer(n.FRAMEBUFFER,null)}function ot(P,w,j){if(n.bindRenderbuffer(n.RENDERBUFFER,P),w.depthBuffer){const J=w.depthTexture,$=J&&J.isDepthTexture?J.type:null,et=x(w.stencilBuffer,$),St=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=ne(w);se(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,vt,et,w.width,w.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,vt,et,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,et,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,P)}else{const J=w.textures;for(let $=0;$<J.length;$++){const et=J[$],St=r.convert(et.format,et.colorSpace),vt=r.convert(et.type),Tt=E(et.internalFormat,St,vt,et.colorSpace),Jt=ne(w);j&&se(w)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Jt,Tt,w.width,w.height):se(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Jt,Tt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,Tt,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function zt(P,w){if(w&&w.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const J=i.get(w.depthTexture);J.__renderTarget=w,(!J.__webglTexture||w.depthTexture.image.width!==w.width||w.depthTexture.image.height!==w.height)&&(w.depthTexture.image.width=w.width,w.depthTexture.image.height=w.height,w.depthTexture.needsUpdate=!0),Z(w.depthTexture,0);const $=J.__webglTexture,et=ne(w);if(w.depthTexture.format===qr)se(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,$,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,$,0);else if(w.depthTexture.format===oo)se(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,$,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,$,0);else throw new Error("Unknown depthTexture format")}function Gt(P){const w=i.get(P),j=P.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==P.depthTexture){const J=P.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),J){const $=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,J.removeEventListener("dispose",$)};J.addEventListener("dispose",$),w.__depthDisposeCallback=$}w.__boundDepthTexture=J}if(P.depthTexture&&!w.__autoAllocateDepthBuffer){if(j)throw new Error("target.depthTexture not supported in Cube render targets");zt(w.__webglFramebuffer,P)}else if(j){w.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[J]),w.__webglDepthbuffer[J]===void 0)w.__webglDepthbuffer[J]=n.createRenderbuffer(),ot(w.__webglDepthbuffer[J],P,!1);else{const $=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,et=w.__webglDepthbuffer[J];n.bindRenderbuffer(n.RENDERBUFFER,et),n.framebufferRenderbuffer(n.FRAMEBUFFER,$,n.RENDERBUFFER,et)}}else if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),ot(w.__webglDepthbuffer,P,!1);else{const J=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,$=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,$),n.framebufferRenderbuffer(n.FRAMEBUFFER,J,n.RENDERBUFFER,$)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Nt(P,w,j){const J=i.get(P);w!==void 0&&_t(J.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&Gt(P)}function pe(P){const w=P.texture,j=i.get(P),J=i.get(w);P.addEventListener("dispose",D);const $=P.textures,et=P.isWebGLCubeRenderTarget===!0,St=$.length>1;if(St||(J.__webglTexture===void 0&&(J.__webglTexture=n.createTexture()),J.__version=w.version,o.memory.textures++),et){j.__webglFramebuffer=[];for(let vt=0;vt<6;vt++)if(w.mipmaps&&w.mipmaps.length>0){j.__webglFramebuffer[vt]=[];for(let Tt=0;Tt<w.mipmaps.length;Tt++)j.__webglFramebuffer[vt][Tt]=n.createFramebuffer()}else j.__webglFramebuffer[vt]=n.createFramebuffer()}else{if(w.mipmaps&&w.mipmaps.length>0){j.__webglFramebuffer=[];for(let vt=0;vt<w.mipmaps.length;vt++)j.__webglFramebuffer[vt]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(St)for(let vt=0,Tt=$.length;vt<Tt;vt++){const Jt=i.get($[vt]);Jt.__webglTexture===void 0&&(Jt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&se(P)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let vt=0;vt<$.length;vt++){const Tt=$[vt];j.__webglColorRenderbuffer[vt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[vt]);const Jt=r.convert(Tt.format,Tt.colorSpace),ft=r.convert(Tt.type),xt=E(Tt.internalFormat,Jt,ft,Tt.colorSpace,P.isXRRenderTarget===!0),Ft=ne(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,Ft,xt,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,j.__webglColorRenderbuffer[vt])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),ot(j.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(et){e.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture),yt(n.TEXTURE_CUBE_MAP,w);for(let vt=0;vt<6;vt++)if(w.mipmaps&&w.mipmaps.length>0)for(let Tt=0;Tt<w.mipmaps.length;Tt++)_t(j.__webglFramebuffer[vt][Tt],P,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+vt,Tt);else _t(j.__webglFramebuffer[vt],P,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+vt,0);m(w)&&p(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let vt=0,Tt=$.length;vt<Tt;vt++){const Jt=$[vt],ft=i.get(Jt);e.bindTexture(n.TEXTURE_2D,ft.__webglTexture),yt(n.TEXTURE_2D,Jt),_t(j.__webglFramebuffer,P,Jt,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,0),m(Jt)&&p(n.TEXTURE_2D)}e.unbindTexture()}else{let vt=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(vt=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(vt,J.__webglTexture),yt(vt,w),w.mipmaps&&w.mipmaps.length>0)for(let Tt=0;Tt<w.mipmaps.length;Tt++)_t(j.__webglFramebuffer[Tt],P,w,n.COLOR_ATTACHMENT0,vt,Tt);else _t(j.__webglFramebuffer,P,w,n.COLOR_ATTACHMENT0,vt,0);m(w)&&p(vt),e.unbindTexture()}P.depthBuffer&&Gt(P)}function te(P){const w=P.textures;for(let j=0,J=w.length;j<J;j++){const $=w[j];if(m($)){const et=y(P),St=i.get($).__webglTexture;e.bindTexture(et,St),p(et),e.unbindTexture()}}}const me=[],H=[];function nn(P){if(P.samples>0){if(se(P)===!1){const w=P.textures,j=P.width,J=P.height;let $=n.COLOR_BUFFER_BIT;const et=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(P),vt=w.length>1;if(vt)for(let Tt=0;Tt<w.length;Tt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let Tt=0;Tt<w.length;Tt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&($|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&($|=n.STENCIL_BUFFER_BIT)),vt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const Jt=i.get(w[Tt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,Jt,0)}n.blitFramebuffer(0,0,j,J,0,0,j,J,$,n.NEAREST),l===!0&&(me.length=0,H.length=0,me.push(n.COLOR_ATTACHMENT0+Tt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(me.push(et),H.push(et),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,H)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,me))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),vt)for(let Tt=0;Tt<w.length;Tt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const Jt=i.get(w[Tt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.TEXTURE_2D,Jt,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){const w=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function ne(P){return Math.min(s.maxSamples,P.samples)}function se(P){const w=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Vt(P){const w=o.render.frame;u.get(P)!==w&&(u.set(P,w),P.update())}function ve(P,w){const j=P.colorSpace,J=P.format,$=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||j!==ur&&j!==Ss&&(ye.getTransfer(j)===Le?(J!==Mi||$!==os)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",j)),w}function Lt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=F,this.resetTextureUnits=V,this.setTexture2D=Z,this.setTexture2DArray=K,this.setTexture3D=Q,this.setTextureCube=tt,this.rebindTextures=Nt,this.setupRenderTarget=pe,this.updateRenderTargetMipmap=te,this.updateMultisampleRenderTarget=nn,this.setupDepthRenderbuffer=Gt,this.setupFrameBufferTexture=_t,this.useMultisampledRTT=se}function oT(n,t){function e(i,s=Ss){let r;const o=ye.getTransfer(s);if(i===os)return n.UNSIGNED_BYTE;if(i===Fh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Oh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===cg)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ag)return n.BYTE;if(i===lg)return n.SHORT;if(i===Yo)return n.UNSIGNED_SHORT;if(i===Nh)return n.INT;if(i===or)return n.UNSIGNED_INT;if(i===ts)return n.FLOAT;if(i===Jo)return n.HALF_FLOAT;if(i===ug)return n.ALPHA;if(i===hg)return n.RGB;if(i===Mi)return n.RGBA;if(i===dg)return n.LUMINANCE;if(i===fg)return n.LUMINANCE_ALPHA;if(i===qr)return n.DEPTH_COMPONENT;if(i===oo)return n.DEPTH_STENCIL;if(i===pg)return n.RED;if(i===kh)return n.RED_INTEGER;if(i===mg)return n.RG;if(i===Bh)return n.RG_INTEGER;if(i===zh)return n.RGBA_INTEGER;if(i===Ja||i===Qa||i===tl||i===el)if(o===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ja)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===el)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ja)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Qa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===el)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Su||i===wu||i===bu||i===Eu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Su)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===wu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===bu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Eu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Tu||i===Au||i===Ru)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Tu||i===Au)return o===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ru)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Cu||i===Pu||i===Lu||i===Du||i===Iu||i===Uu||i===Nu||i===Fu||i===Ou||i===ku||i===Bu||i===zu||i===Hu||i===Gu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Cu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Pu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Lu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Du)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Iu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Uu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Nu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Fu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ou)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ku)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Bu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===zu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Hu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Gu)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===nl||i===Vu||i===Wu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===nl)return o===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Vu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Wu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===gg||i===$u||i===Xu||i===qu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===nl)return r.COMPRESSED_RED_RGTC1_EXT;if(i===$u)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Xu)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===qu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ro?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}class aT extends Kn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class Fi extends an{constructor(){super(),this.isGroup=!0,this.type="Group"}}const lT={type:"move"};class Oc{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(lT)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const i=new Fi;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}}const cT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,uT=`
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

}`;class hT{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,i){if(this.texture===null){const s=new Hn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=i.depthNear||e.depthFar!=i.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,i=new Ps({vertexShader:cT,fragmentShader:uT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new An(new Nl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class dT extends fo{constructor(t,e){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,g=null;const v=new hT,m=e.getContextAttributes();let p=null,y=null;const E=[],x=[],U=new fe;let A=null;const D=new Kn;D.viewport=new qe;const I=new Kn;I.viewport=new qe;const T=[D,I],S=new aT;let C=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let at=E[it];return at===void 0&&(at=new Oc,E[it]=at),at.getTargetRaySpace()},this.getControllerGrip=function(it){let at=E[it];return at===void 0&&(at=new Oc,E[it]=at),at.getGripSpace()},this.getHand=function(it){let at=E[it];return at===void 0&&(at=new Oc,E[it]=at),at.getHandSpace()};function F(it){const at=x.indexOf(it.inputSource);if(at===-1)return;const _t=E[at];_t!==void 0&&(_t.update(it.inputSource,it.frame,c||o),_t.dispatchEvent({type:it.type,data:it.inputSource}))}function W(){s.removeEventListener("select",F),s.removeEventListener("selectstart",F),s.removeEventListener("selectend",F),s.removeEventListener("squeeze",F),s.removeEventListener("squeezestart",F),s.removeEventListener("squeezeend",F),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",Z);for(let it=0;it<E.length;it++){const at=x[it];at!==null&&(x[it]=null,E[it].disconnect(at))}C=null,V=null,v.reset(),t.setRenderTarget(p),f=null,d=null,h=null,s=null,y=null,mt.stop(),i.isPresenting=!1,t.setPixelRatio(A),t.setSize(U.width,U.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",F),s.addEventListener("selectstart",F),s.addEventListener("selectend",F),s.addEventListener("squeeze",F),s.addEventListener("squeezestart",F),s.addEventListener("squeezeend",F),s.addEventListener("end",W),s.addEventListener("inputsourceschange",Z),m.xrCompatible!==!0&&await e.makeXRCompatible(),A=t.getPixelRatio(),t.getSize(U),s.renderState.layers===void 0){const at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new ar(f.framebufferWidth,f.framebufferHeight,{format:Mi,type:os,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,_t=null,ot=null;m.depth&&(ot=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?oo:qr,_t=m.stencil?ro:or);const zt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};h=new XRWebGLBinding(s,e),d=h.createProjectionLayer(zt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),y=new ar(d.textureWidth,d.textureHeight,{format:Mi,type:os,depthTexture:new Pg(d.textureWidth,d.textureHeight,_t,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),mt.setContext(s),mt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function Z(it){for(let at=0;at<it.removed.length;at++){const _t=it.removed[at],ot=x.indexOf(_t);ot>=0&&(x[ot]=null,E[ot].disconnect(_t))}for(let at=0;at<it.added.length;at++){const _t=it.added[at];let ot=x.indexOf(_t);if(ot===-1){for(let Gt=0;Gt<E.length;Gt++)if(Gt>=x.length){x.push(_t),ot=Gt;break}else if(x[Gt]===null){x[Gt]=_t,ot=Gt;break}if(ot===-1)break}const zt=E[ot];zt&&zt.connect(_t)}}const K=new z,Q=new z;function tt(it,at,_t){K.setFromMatrixPosition(at.matrixWorld),Q.setFromMatrixPosition(_t.matrixWorld);const ot=K.distanceTo(Q),zt=at.projectionMatrix.elements,Gt=_t.projectionMatrix.elements,Nt=zt[14]/(zt[10]-1),pe=zt[14]/(zt[10]+1),te=(zt[9]+1)/zt[5],me=(zt[9]-1)/zt[5],H=(zt[8]-1)/zt[0],nn=(Gt[8]+1)/Gt[0],ne=Nt*H,se=Nt*nn,Vt=ot/(-H+nn),ve=Vt*-H;if(at.matrixWorld.decompose(it.position,it.quaternion,it.scale),it.translateX(ve),it.translateZ(Vt),it.matrixWorld.compose(it.position,it.quaternion,it.scale),it.matrixWorldInverse.copy(it.matrixWorld).invert(),zt[10]===-1)it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Lt=Nt+Vt,P=pe+Vt,w=ne-ve,j=se+(ot-ve),J=te*pe/P*Lt,$=me*pe/P*Lt;it.projectionMatrix.makePerspective(w,j,J,$,Lt,P),it.projectionMatrixInverse.copy(it.projectionMatrix).invert()}}function ht(it,at){at===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(at.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let at=it.near,_t=it.far;v.texture!==null&&(v.depthNear>0&&(at=v.depthNear),v.depthFar>0&&(_t=v.depthFar)),S.near=I.near=D.near=at,S.far=I.far=D.far=_t,(C!==S.near||V!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,V=S.far),D.layers.mask=it.layers.mask|2,I.layers.mask=it.layers.mask|4,S.layers.mask=D.layers.mask|I.layers.mask;const ot=it.parent,zt=S.cameras;ht(S,ot);for(let Gt=0;Gt<zt.length;Gt++)ht(zt[Gt],ot);zt.length===2?tt(S,D,I):S.projectionMatrix.copy(D.projectionMatrix),ct(it,S,ot)};function ct(it,at,_t){_t===null?it.matrix.copy(at.matrixWorld):(it.matrix.copy(_t.matrixWorld),it.matrix.invert(),it.matrix.multiply(at.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=Yu*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(it){l=it,d!==null&&(d.fixedFoveation=it),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=it)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let gt=null;function yt(it,at){if(u=at.getViewerPose(c||o),g=at,u!==null){const _t=u.views;f!==null&&(t.setRenderTargetFramebuffer(y,f.framebuffer),t.setRenderTarget(y));let ot=!1;_t.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Gt=0;Gt<_t.length;Gt++){const Nt=_t[Gt];let pe=null;if(f!==null)pe=f.getViewport(Nt);else{const me=h.getViewSubImage(d,Nt);pe=me.viewport,Gt===0&&(t.setRenderTargetTextures(y,me.colorTexture,d.ignoreDepthValues?void 0:me.depthStencilTexture),t.setRenderTarget(y))}let te=T[Gt];te===void 0&&(te=new Kn,te.layers.enable(Gt),te.viewport=new qe,T[Gt]=te),te.matrix.fromArray(Nt.transform.matrix),te.matrix.decompose(te.position,te.quaternion,te.scale),te.projectionMatrix.fromArray(Nt.projectionMatrix),te.projectionMatrixInverse.copy(te.projectionMatrix).invert(),te.viewport.set(pe.x,pe.y,pe.width,pe.height),Gt===0&&(S.matrix.copy(te.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(te)}const zt=s.enabledFeatures;if(zt&&zt.includes("depth-sensing")){const Gt=h.getDepthInformation(_t[0]);Gt&&Gt.isValid&&Gt.texture&&v.init(t,Gt,s.renderState)}}for(let _t=0;_t<E.length;_t++){const ot=x[_t],zt=E[_t];ot!==null&&zt!==void 0&&zt.update(ot,at,c||o)}gt&&gt(it,at),at.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:at}),g=null}const mt=new Cg;mt.setAnimationLoop(yt),this.setAnimationLoop=function(it){gt=it},this.dispose=function(){}}}const $s=new zi,fT=new ke;function pT(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Tg(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,E,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,x)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,E):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===zn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===zn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const y=t.get(p),E=y.envMap,x=y.envMapRotation;E&&(m.envMap.value=E,$s.copy(x),$s.x*=-1,$s.y*=-1,$s.z*=-1,E.isCubeTexture&&E.isRenderTargetTexture===!1&&($s.y*=-1,$s.z*=-1),m.envMapRotation.value.setFromMatrix4(fT.makeRotationFromEuler($s)),m.flipEnvMap.value=E.isCubeTexture&&E.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,E){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=E*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,y){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===zn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const y=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function mT(n,t,e,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(y,E){const x=E.program;i.uniformBlockBinding(y,x)}function c(y,E){let x=s[y.id];x===void 0&&(g(y),x=u(y),s[y.id]=x,y.addEventListener("dispose",m));const U=E.program;i.updateUBOMapping(y,U);const A=t.render.frame;r[y.id]!==A&&(d(y),r[y.id]=A)}function u(y){const E=h();y.__bindingPointIndex=E;const x=n.createBuffer(),U=y.__size,A=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,x),n.bufferData(n.UNIFORM_BUFFER,U,A),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,E,x),x}function h(){for(let y=0;y<a;y++)if(o.indexOf(y)===-1)return o.push(y),y;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(y){const E=s[y.id],x=y.uniforms,U=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let A=0,D=x.length;A<D;A++){const I=Array.isArray(x[A])?x[A]:[x[A]];for(let T=0,S=I.length;T<S;T++){const C=I[T];if(f(C,A,T,U)===!0){const V=C.__offset,F=Array.isArray(C.value)?C.value:[C.value];let W=0;for(let Z=0;Z<F.length;Z++){const K=F[Z],Q=v(K);typeof K=="number"||typeof K=="boolean"?(C.__data[0]=K,n.bufferSubData(n.UNIFORM_BUFFER,V+W,C.__data)):K.isMatrix3?(C.__data[0]=K.elements[0],C.__data[1]=K.elements[1],C.__data[2]=K.elements[2],C.__data[3]=0,C.__data[4]=K.elements[3],C.__data[5]=K.elements[4],C.__data[6]=K.elements[5],C.__data[7]=0,C.__data[8]=K.elements[6],C.__data[9]=K.elements[7],C.__data[10]=K.elements[8],C.__data[11]=0):(K.toArray(C.__data,W),W+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,V,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function f(y,E,x,U){const A=y.value,D=E+"_"+x;if(U[D]===void 0)return typeof A=="number"||typeof A=="boolean"?U[D]=A:U[D]=A.clone(),!0;{const I=U[D];if(typeof A=="number"||typeof A=="boolean"){if(I!==A)return U[D]=A,!0}else if(I.equals(A)===!1)return I.copy(A),!0}return!1}function g(y){const E=y.uniforms;let x=0;const U=16;for(let D=0,I=E.length;D<I;D++){const T=Array.isArray(E[D])?E[D]:[E[D]];for(let S=0,C=T.length;S<C;S++){const V=T[S],F=Array.isArray(V.value)?V.value:[V.value];for(let W=0,Z=F.length;W<Z;W++){const K=F[W],Q=v(K),tt=x%U,ht=tt%Q.boundary,ct=tt+ht;x+=ht,ct!==0&&U-ct<Q.storage&&(x+=U-ct),V.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=x,x+=Q.storage}}}const A=x%U;return A>0&&(x+=U-A),y.__size=x,y.__cache={},this}function v(y){const E={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(E.boundary=4,E.storage=4):y.isVector2?(E.boundary=8,E.storage=8):y.isVector3||y.isColor?(E.boundary=16,E.storage=12):y.isVector4?(E.boundary=16,E.storage=16):y.isMatrix3?(E.boundary=48,E.storage=48):y.isMatrix4?(E.boundary=64,E.storage=64):y.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",y),E}function m(y){const E=y.target;E.removeEventListener("dispose",m);const x=o.indexOf(E.__bindingPointIndex);o.splice(x,1),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function p(){for(const y in s)n.deleteBuffer(s[y]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class gT{constructor(t={}){const{canvas:e=sy(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:d=!1}=t;this.isWebGLRenderer=!0;let f;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=i.getContextAttributes().alpha}else f=o;const g=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const y=[],E=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=ai,this.toneMapping=Es,this.toneMappingExposure=1;const x=this;let U=!1,A=0,D=0,I=null,T=-1,S=null;const C=new qe,V=new qe;let F=null;const W=new de(0);let Z=0,K=e.width,Q=e.height,tt=1,ht=null,ct=null;const gt=new qe(0,0,K,Q),yt=new qe(0,0,K,Q);let mt=!1;const it=new Gh;let at=!1,_t=!1;const ot=new ke,zt=new ke,Gt=new z,Nt=new qe,pe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let te=!1;function me(){return I===null?tt:1}let H=i;function nn(b,k){return e.getContext(b,k)}try{const b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Ih}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",At,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),H===null){const k="webgl2";if(H=nn(k,b),H===null)throw nn(k)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(b){throw console.error("THREE.WebGLRenderer: "+b.message),b}let ne,se,Vt,ve,Lt,P,w,j,J,$,et,St,vt,Tt,Jt,ft,xt,Ft,kt,bt,ae,jt,xe,B;function Mt(){ne=new yb(H),ne.init(),jt=new oT(H,ne),se=new mb(H,ne,t,jt),Vt=new iT(H,ne),se.reverseDepthBuffer&&d&&Vt.buffers.depth.setReversed(!0),ve=new bb(H),Lt=new GE,P=new rT(H,ne,Vt,Lt,se,jt,ve),w=new _b(x),j=new Mb(x),J=new Ly(H),xe=new fb(H,J),$=new Sb(H,J,ve,xe),et=new Tb(H,$,J,ve),kt=new Eb(H,se,P),ft=new gb(Lt),St=new HE(x,w,j,ne,se,xe,ft),vt=new pT(x,Lt),Tt=new WE,Jt=new KE(ne),Ft=new db(x,w,j,Vt,et,f,l),xt=new eT(x,et,se),B=new mT(H,ve,se,Vt),bt=new pb(H,ne,ve),ae=new wb(H,ne,ve),ve.programs=St.programs,x.capabilities=se,x.extensions=ne,x.properties=Lt,x.renderLists=Tt,x.shadowMap=xt,x.state=Vt,x.info=ve}Mt();const nt=new dT(x,H);this.xr=nt,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){const b=ne.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=ne.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return tt},this.setPixelRatio=function(b){b!==void 0&&(tt=b,this.setSize(K,Q,!1))},this.getSize=function(b){return b.set(K,Q)},this.setSize=function(b,k,X=!0){if(nt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=b,Q=k,e.width=Math.floor(b*tt),e.height=Math.floor(k*tt),X===!0&&(e.style.width=b+"px",e.style.height=k+"px"),this.setViewport(0,0,b,k)},this.getDrawingBufferSize=function(b){return b.set(K*tt,Q*tt).floor()},this.setDrawingBufferSize=function(b,k,X){K=b,Q=k,tt=X,e.width=Math.floor(b*X),e.height=Math.floor(k*X),this.setViewport(0,0,b,k)},this.getCurrentViewport=function(b){return b.copy(C)},this.getViewport=function(b){return b.copy(gt)},this.setViewport=function(b,k,X,q){b.isVector4?gt.set(b.x,b.y,b.z,b.w):gt.set(b,k,X,q),Vt.viewport(C.copy(gt).multiplyScalar(tt).round())},this.getScissor=function(b){return b.copy(yt)},this.setScissor=function(b,k,X,q){b.isVector4?yt.set(b.x,b.y,b.z,b.w):yt.set(b,k,X,q),Vt.scissor(V.copy(yt).multiplyScalar(tt).round())},this.getScissorTest=function(){return mt},this.setScissorTest=function(b){Vt.setScissorTest(mt=b)},this.setOpaqueSort=function(b){ht=b},this.setTransparentSort=function(b){ct=b},this.getClearColor=function(b){return b.copy(Ft.getClearColor())},this.setClearColor=function(){Ft.setClearColor.apply(Ft,arguments)},this.getClearAlpha=function(){return Ft.getClearAlpha()},this.setClearAlpha=function(){Ft.setClearAlpha.apply(Ft,arguments)},this.clear=function(b=!0,k=!0,X=!0){let q=0;if(b){let G=!1;if(I!==null){const ut=I.texture.format;G=ut===zh||ut===Bh||ut===kh}if(G){const ut=I.texture.type,wt=ut===os||ut===or||ut===Yo||ut===ro||ut===Fh||ut===Oh,Ot=Ft.getClearColor(),It=Ft.getClearAlpha(),$t=Ot.r,qt=Ot.g,Ut=Ot.b;wt?(g[0]=$t,g[1]=qt,g[2]=Ut,g[3]=It,H.clearBufferuiv(H.COLOR,0,g)):(v[0]=$t,v[1]=qt,v[2]=Ut,v[3]=It,H.clearBufferiv(H.COLOR,0,v))}else q|=H.COLOR_BUFFER_BIT}k&&(q|=H.DEPTH_BUFFER_BIT),X&&(q|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",At,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),Tt.dispose(),Jt.dispose(),Lt.dispose(),w.dispose(),j.dispose(),et.dispose(),xe.dispose(),B.dispose(),St.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Vn),nt.removeEventListener("sessionend",Hi),Fn.stop()};function rt(b){b.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),U=!0}function At(){console.log("THREE.WebGLRenderer: Context Restored."),U=!1;const b=ve.autoReset,k=xt.enabled,X=xt.autoUpdate,q=xt.needsUpdate,G=xt.type;Mt(),ve.autoReset=b,xt.enabled=k,xt.autoUpdate=X,xt.needsUpdate=q,xt.type=G}function Rt(b){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function ee(b){const k=b.target;k.removeEventListener("dispose",ee),We(k)}function We(b){dn(b),Lt.remove(b)}function dn(b){const k=Lt.get(b).programs;k!==void 0&&(k.forEach(function(X){St.releaseProgram(X)}),b.isShaderMaterial&&St.releaseShaderCache(b))}this.renderBufferDirect=function(b,k,X,q,G,ut){k===null&&(k=pe);const wt=G.isMesh&&G.matrixWorld.determinant()<0,Ot=zl(b,k,X,q,G);Vt.setMaterial(q,wt);let It=X.index,$t=1;if(q.wireframe===!0){if(It=$.getWireframeAttribute(X),It===void 0)return;$t=2}const qt=X.drawRange,Ut=X.attributes.position;let ue=qt.start*$t,Ae=(qt.start+qt.count)*$t;ut!==null&&(ue=Math.max(ue,ut.start*$t),Ae=Math.min(Ae,(ut.start+ut.count)*$t)),It!==null?(ue=Math.max(ue,0),Ae=Math.min(Ae,It.count)):Ut!=null&&(ue=Math.max(ue,0),Ae=Math.min(Ae,Ut.count));const Ce=Ae-ue;if(Ce<0||Ce===1/0)return;xe.setup(G,q,Ot,X,It);let fn,ge=bt;if(It!==null&&(fn=J.get(It),ge=ae,ge.setIndex(fn)),G.isMesh)q.wireframe===!0?(Vt.setLineWidth(q.wireframeLinewidth*me()),ge.setMode(H.LINES)):ge.setMode(H.TRIANGLES);else if(G.isLine){let Bt=q.linewidth;Bt===void 0&&(Bt=1),Vt.setLineWidth(Bt*me()),G.isLineSegments?ge.setMode(H.LINES):G.isLineLoop?ge.setMode(H.LINE_LOOP):ge.setMode(H.LINE_STRIP)}else G.isPoints?ge.setMode(H.POINTS):G.isSprite&&ge.setMode(H.TRIANGLES);if(G.isBatchedMesh)if(G._multiDrawInstances!==null)ge.renderMultiDrawInstances(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount,G._multiDrawInstances);else if(ne.get("WEBGL_multi_draw"))ge.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{const Bt=G._multiDrawStarts,$e=G._multiDrawCounts,Me=G._multiDrawCount,On=It?J.get(It).bytesPerElement:1,bi=Lt.get(q).currentProgram.getUniforms();for(let wn=0;wn<Me;wn++)bi.setValue(H,"_gl_DrawID",wn),ge.render(Bt[wn]/On,$e[wn])}else if(G.isInstancedMesh)ge.renderInstances(ue,Ce,G.count);else if(X.isInstancedBufferGeometry){const Bt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,$e=Math.min(X.instanceCount,Bt);ge.renderInstances(ue,Ce,$e)}else ge.render(ue,Ce)};function be(b,k,X){b.transparent===!0&&b.side===Di&&b.forceSinglePass===!1?(b.side=zn,b.needsUpdate=!0,dr(b,k,X),b.side=Cs,b.needsUpdate=!0,dr(b,k,X),b.side=Di):dr(b,k,X)}this.compile=function(b,k,X=null){X===null&&(X=b),p=Jt.get(X),p.init(k),E.push(p),X.traverseVisible(function(G){G.isLight&&G.layers.test(k.layers)&&(p.pushLight(G),G.castShadow&&p.pushShadow(G))}),b!==X&&b.traverseVisible(function(G){G.isLight&&G.layers.test(k.layers)&&(p.pushLight(G),G.castShadow&&p.pushShadow(G))}),p.setupLights();const q=new Set;return b.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;const ut=G.material;if(ut)if(Array.isArray(ut))for(let wt=0;wt<ut.length;wt++){const Ot=ut[wt];be(Ot,X,G),q.add(Ot)}else be(ut,X,G),q.add(ut)}),E.pop(),p=null,q},this.compileAsync=function(b,k,X=null){const q=this.compile(b,k,X);return new Promise(G=>{function ut(){if(q.forEach(function(wt){Lt.get(wt).currentProgram.isReady()&&q.delete(wt)}),q.size===0){G(b);return}setTimeout(ut,10)}ne.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let sn=null;function Fe(b){sn&&sn(b)}function Vn(){Fn.stop()}function Hi(){Fn.start()}const Fn=new Cg;Fn.setAnimationLoop(Fe),typeof self<"u"&&Fn.setContext(self),this.setAnimationLoop=function(b){sn=b,nt.setAnimationLoop(b),b===null?Fn.stop():Fn.start()},nt.addEventListener("sessionstart",Vn),nt.addEventListener("sessionend",Hi),this.render=function(b,k){if(k!==void 0&&k.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(k),k=nt.getCamera()),b.isScene===!0&&b.onBeforeRender(x,b,k,I),p=Jt.get(b,E.length),p.init(k),E.push(p),zt.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),it.setFromProjectionMatrix(zt),_t=this.localClippingEnabled,at=ft.init(this.clippingPlanes,_t),m=Tt.get(b,y.length),m.init(),y.push(m),nt.enabled===!0&&nt.isPresenting===!0){const ut=x.xr.getDepthSensingMesh();ut!==null&&Sn(ut,k,-1/0,x.sortObjects)}Sn(b,k,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(ht,ct),te=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,te&&Ft.addToRenderList(m,b),this.info.render.frame++,at===!0&&ft.beginShadows();const X=p.state.shadowsArray;xt.render(X,b,k),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const q=m.opaque,G=m.transmissive;if(p.setupLights(),k.isArrayCamera){const ut=k.cameras;if(G.length>0)for(let wt=0,Ot=ut.length;wt<Ot;wt++){const It=ut[wt];Vi(q,G,b,It)}te&&Ft.render(b);for(let wt=0,Ot=ut.length;wt<Ot;wt++){const It=ut[wt];Gi(m,b,It,It.viewport)}}else G.length>0&&Vi(q,G,b,k),te&&Ft.render(b),Gi(m,b,k);I!==null&&(P.updateMultisampleRenderTarget(I),P.updateRenderTargetMipmap(I)),b.isScene===!0&&b.onAfterRender(x,b,k),xe.resetDefaultState(),T=-1,S=null,E.pop(),E.length>0?(p=E[E.length-1],at===!0&&ft.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,y.pop(),y.length>0?m=y[y.length-1]:m=null};function Sn(b,k,X,q){if(b.visible===!1)return;if(b.layers.test(k.layers)){if(b.isGroup)X=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(k);else if(b.isLight)p.pushLight(b),b.castShadow&&p.pushShadow(b);else if(b.isSprite){if(!b.frustumCulled||it.intersectsSprite(b)){q&&Nt.setFromMatrixPosition(b.matrixWorld).applyMatrix4(zt);const wt=et.update(b),Ot=b.material;Ot.visible&&m.push(b,wt,Ot,X,Nt.z,null)}}else if((b.isMesh||b.isLine||b.isPoints)&&(!b.frustumCulled||it.intersectsObject(b))){const wt=et.update(b),Ot=b.material;if(q&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),Nt.copy(b.boundingSphere.center)):(wt.boundingSphere===null&&wt.computeBoundingSphere(),Nt.copy(wt.boundingSphere.center)),Nt.applyMatrix4(b.matrixWorld).applyMatrix4(zt)),Array.isArray(Ot)){const It=wt.groups;for(let $t=0,qt=It.length;$t<qt;$t++){const Ut=It[$t],ue=Ot[Ut.materialIndex];ue&&ue.visible&&m.push(b,wt,ue,X,Nt.z,Ut)}}else Ot.visible&&m.push(b,wt,Ot,X,Nt.z,null)}}const ut=b.children;for(let wt=0,Ot=ut.length;wt<Ot;wt++)Sn(ut[wt],k,X,q)}function Gi(b,k,X,q){const G=b.opaque,ut=b.transmissive,wt=b.transparent;p.setupLightsView(X),at===!0&&ft.setGlobalState(x.clippingPlanes,X),q&&Vt.viewport(C.copy(q)),G.length>0&&Ds(G,k,X),ut.length>0&&Ds(ut,k,X),wt.length>0&&Ds(wt,k,X),Vt.buffers.depth.setTest(!0),Vt.buffers.depth.setMask(!0),Vt.buffers.color.setMask(!0),Vt.setPolygonOffset(!1)}function Vi(b,k,X,q){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[q.id]===void 0&&(p.state.transmissionRenderTarget[q.id]=new ar(1,1,{generateMipmaps:!0,type:ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float")?Jo:os,minFilter:tr,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ye.workingColorSpace}));const ut=p.state.transmissionRenderTarget[q.id],wt=q.viewport||C;ut.setSize(wt.z,wt.w);const Ot=x.getRenderTarget();x.setRenderTarget(ut),x.getClearColor(W),Z=x.getClearAlpha(),Z<1&&x.setClearColor(16777215,.5),x.clear(),te&&Ft.render(X);const It=x.toneMapping;x.toneMapping=Es;const $t=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),p.setupLightsView(q),at===!0&&ft.setGlobalState(x.clippingPlanes,q),Ds(b,X,q),P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut),ne.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ut=0,ue=k.length;Ut<ue;Ut++){const Ae=k[Ut],Ce=Ae.object,fn=Ae.geometry,ge=Ae.material,Bt=Ae.group;if(ge.side===Di&&Ce.layers.test(q.layers)){const $e=ge.side;ge.side=zn,ge.needsUpdate=!0,xo(Ce,X,q,fn,ge,Bt),ge.side=$e,ge.needsUpdate=!0,qt=!0}}qt===!0&&(P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut))}x.setRenderTarget(Ot),x.setClearColor(W,Z),$t!==void 0&&(q.viewport=$t),x.toneMapping=It}function Ds(b,k,X){const q=k.isScene===!0?k.overrideMaterial:null;for(let G=0,ut=b.length;G<ut;G++){const wt=b[G],Ot=wt.object,It=wt.geometry,$t=q===null?wt.material:q,qt=wt.group;Ot.layers.test(X.layers)&&xo(Ot,k,X,It,$t,qt)}}function xo(b,k,X,q,G,ut){b.onBeforeRender(x,k,X,q,G,ut),b.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),G.onBeforeRender(x,k,X,q,b,ut),G.transparent===!0&&G.side===Di&&G.forceSinglePass===!1?(G.side=zn,G.needsUpdate=!0,x.renderBufferDirect(X,k,q,G,b,ut),G.side=Cs,G.needsUpdate=!0,x.renderBufferDirect(X,k,q,G,b,ut),G.side=Di):x.renderBufferDirect(X,k,q,G,b,ut),b.onAfterRender(x,k,X,q,G,ut)}function dr(b,k,X){k.isScene!==!0&&(k=pe);const q=Lt.get(b),G=p.state.lights,ut=p.state.shadowsArray,wt=G.state.version,Ot=St.getParameters(b,G.state,ut,k,X),It=St.getProgramCacheKey(Ot);let $t=q.programs;q.environment=b.isMeshStandardMaterial?k.environment:null,q.fog=k.fog,q.envMap=(b.isMeshStandardMaterial?j:w).get(b.envMap||q.environment),q.envMapRotation=q.environment!==null&&b.envMap===null?k.environmentRotation:b.envMapRotation,$t===void 0&&(b.addEventListener("dispose",ee),$t=new Map,q.programs=$t);let qt=$t.get(It);if(qt!==void 0){if(q.currentProgram===qt&&q.lightsStateVersion===wt)return wi(b,Ot),qt}else Ot.uniforms=St.getUniforms(b),b.onBeforeCompile(Ot,x),qt=St.acquireProgram(Ot,It),$t.set(It,qt),q.uniforms=Ot.uniforms;const Ut=q.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(Ut.clippingPlanes=ft.uniform),wi(b,Ot),q.needsLights=sa(b),q.lightsStateVersion=wt,q.needsLights&&(Ut.ambientLightColor.value=G.state.ambient,Ut.lightProbe.value=G.state.probe,Ut.directionalLights.value=G.state.directional,Ut.directionalLightShadows.value=G.state.directionalShadow,Ut.spotLights.value=G.state.spot,Ut.spotLightShadows.value=G.state.spotShadow,Ut.rectAreaLights.value=G.state.rectArea,Ut.ltc_1.value=G.state.rectAreaLTC1,Ut.ltc_2.value=G.state.rectAreaLTC2,Ut.pointLights.value=G.state.point,Ut.pointLightShadows.value=G.state.pointShadow,Ut.hemisphereLights.value=G.state.hemi,Ut.directionalShadowMap.value=G.state.directionalShadowMap,Ut.directionalShadowMatrix.value=G.state.directionalShadowMatrix,Ut.spotShadowMap.value=G.state.spotShadowMap,Ut.spotLightMatrix.value=G.state.spotLightMatrix,Ut.spotLightMap.value=G.state.spotLightMap,Ut.pointShadowMap.value=G.state.pointShadowMap,Ut.pointShadowMatrix.value=G.state.pointShadowMatrix),q.currentProgram=qt,q.uniformsList=null,qt}function ia(b){if(b.uniformsList===null){const k=b.currentProgram.getUniforms();b.uniformsList=sl.seqWithValue(k.seq,b.uniforms)}return b.uniformsList}function wi(b,k){const X=Lt.get(b);X.outputColorSpace=k.outputColorSpace,X.batching=k.batching,X.batchingColor=k.batchingColor,X.instancing=k.instancing,X.instancingColor=k.instancingColor,X.instancingMorph=k.instancingMorph,X.skinning=k.skinning,X.morphTargets=k.morphTargets,X.morphNormals=k.morphNormals,X.morphColors=k.morphColors,X.morphTargetsCount=k.morphTargetsCount,X.numClippingPlanes=k.numClippingPlanes,X.numIntersection=k.numClipIntersection,X.vertexAlphas=k.vertexAlphas,X.vertexTangents=k.vertexTangents,X.toneMapping=k.toneMapping}function zl(b,k,X,q,G){k.isScene!==!0&&(k=pe),P.resetTextureUnits();const ut=k.fog,wt=q.isMeshStandardMaterial?k.environment:null,Ot=I===null?x.outputColorSpace:I.isXRRenderTarget===!0?I.texture.colorSpace:ur,It=(q.isMeshStandardMaterial?j:w).get(q.envMap||wt),$t=q.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,qt=!!X.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ut=!!X.morphAttributes.position,ue=!!X.morphAttributes.normal,Ae=!!X.morphAttributes.color;let Ce=Es;q.toneMapped&&(I===null||I.isXRRenderTarget===!0)&&(Ce=x.toneMapping);const fn=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,ge=fn!==void 0?fn.length:0,Bt=Lt.get(q),$e=p.state.lights;if(at===!0&&(_t===!0||b!==S)){const Cn=b===S&&q.id===T;ft.setState(q,b,Cn)}let Me=!1;q.version===Bt.__version?(Bt.needsLights&&Bt.lightsStateVersion!==$e.state.version||Bt.outputColorSpace!==Ot||G.isBatchedMesh&&Bt.batching===!1||!G.isBatchedMesh&&Bt.batching===!0||G.isBatchedMesh&&Bt.batchingColor===!0&&G.colorTexture===null||G.isBatchedMesh&&Bt.batchingColor===!1&&G.colorTexture!==null||G.isInstancedMesh&&Bt.instancing===!1||!G.isInstancedMesh&&Bt.instancing===!0||G.isSkinnedMesh&&Bt.skinning===!1||!G.isSkinnedMesh&&Bt.skinning===!0||G.isInstancedMesh&&Bt.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&Bt.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&Bt.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&Bt.instancingMorph===!1&&G.morphTexture!==null||Bt.envMap!==It||q.fog===!0&&Bt.fog!==ut||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==ft.numPlanes||Bt.numIntersection!==ft.numIntersection)||Bt.vertexAlphas!==$t||Bt.vertexTangents!==qt||Bt.morphTargets!==Ut||Bt.morphNormals!==ue||Bt.morphColors!==Ae||Bt.toneMapping!==Ce||Bt.morphTargetsCount!==ge)&&(Me=!0):(Me=!0,Bt.__version=q.version);let On=Bt.currentProgram;Me===!0&&(On=dr(q,k,G));let bi=!1,wn=!1,Us=!1;const De=On.getUniforms(),ti=Bt.uniforms;if(Vt.useProgram(On.program)&&(bi=!0,wn=!0,Us=!0),q.id!==T&&(T=q.id,wn=!0),bi||S!==b){Vt.buffers.depth.getReversed()?(ot.copy(b.projectionMatrix),oy(ot),ay(ot),De.setValue(H,"projectionMatrix",ot)):De.setValue(H,"projectionMatrix",b.projectionMatrix),De.setValue(H,"viewMatrix",b.matrixWorldInverse);const Ei=De.map.cameraPosition;Ei!==void 0&&Ei.setValue(H,Gt.setFromMatrixPosition(b.matrixWorld)),se.logarithmicDepthBuffer&&De.setValue(H,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&De.setValue(H,"isOrthographic",b.isOrthographicCamera===!0),S!==b&&(S=b,wn=!0,Us=!0)}if(G.isSkinnedMesh){De.setOptional(H,G,"bindMatrix"),De.setOptional(H,G,"bindMatrixInverse");const Cn=G.skeleton;Cn&&(Cn.boneTexture===null&&Cn.computeBoneTexture(),De.setValue(H,"boneTexture",Cn.boneTexture,P))}G.isBatchedMesh&&(De.setOptional(H,G,"batchingTexture"),De.setValue(H,"batchingTexture",G._matricesTexture,P),De.setOptional(H,G,"batchingIdTexture"),De.setValue(H,"batchingIdTexture",G._indirectTexture,P),De.setOptional(H,G,"batchingColorTexture"),G._colorsTexture!==null&&De.setValue(H,"batchingColorTexture",G._colorsTexture,P));const cs=X.morphAttributes;if((cs.position!==void 0||cs.normal!==void 0||cs.color!==void 0)&&kt.update(G,X,On),(wn||Bt.receiveShadow!==G.receiveShadow)&&(Bt.receiveShadow=G.receiveShadow,De.setValue(H,"receiveShadow",G.receiveShadow)),q.isMeshGouraudMaterial&&q.envMap!==null&&(ti.envMap.value=It,ti.flipEnvMap.value=It.isCubeTexture&&It.isRenderTargetTexture===!1?-1:1),q.isMeshStandardMaterial&&q.envMap===null&&k.environment!==null&&(ti.envMapIntensity.value=k.environmentIntensity),wn&&(De.setValue(H,"toneMappingExposure",x.toneMappingExposure),Bt.needsLights&&Is(ti,Us),ut&&q.fog===!0&&vt.refreshFogUniforms(ti,ut),vt.refreshMaterialUniforms(ti,q,tt,Q,p.state.transmissionRenderTarget[b.id]),sl.upload(H,ia(Bt),ti,P)),q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(sl.upload(H,ia(Bt),ti,P),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&De.setValue(H,"center",G.center),De.setValue(H,"modelViewMatrix",G.modelViewMatrix),De.setValue(H,"normalMatrix",G.normalMatrix),De.setValue(H,"modelMatrix",G.matrixWorld),q.isShaderMaterial||q.isRawShaderMaterial){const Cn=q.uniformsGroups;for(let Ei=0,hi=Cn.length;Ei<hi;Ei++){const fr=Cn[Ei];B.update(fr,On),B.bind(fr,On)}}return On}function Is(b,k){b.ambientLightColor.needsUpdate=k,b.lightProbe.needsUpdate=k,b.directionalLights.needsUpdate=k,b.directionalLightShadows.needsUpdate=k,b.pointLights.needsUpdate=k,b.pointLightShadows.needsUpdate=k,b.spotLights.needsUpdate=k,b.spotLightShadows.needsUpdate=k,b.rectAreaLights.needsUpdate=k,b.hemisphereLights.needsUpdate=k}function sa(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return I},this.setRenderTargetTextures=function(b,k,X){Lt.get(b.texture).__webglTexture=k,Lt.get(b.depthTexture).__webglTexture=X;const q=Lt.get(b);q.__hasExternalTextures=!0,q.__autoAllocateDepthBuffer=X===void 0,q.__autoAllocateDepthBuffer||ne.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),q.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(b,k){const X=Lt.get(b);X.__webglFramebuffer=k,X.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(b,k=0,X=0){I=b,A=k,D=X;let q=!0,G=null,ut=!1,wt=!1;if(b){const It=Lt.get(b);if(It.__useDefaultFramebuffer!==void 0)Vt.bindFramebuffer(H.FRAMEBUFFER,null),q=!1;else if(It.__webglFramebuffer===void 0)P.setupRenderTarget(b);else if(It.__hasExternalTextures)P.rebindTextures(b,Lt.get(b.texture).__webglTexture,Lt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const Ut=b.depthTexture;if(It.__boundDepthTexture!==Ut){if(Ut!==null&&Lt.has(Ut)&&(b.width!==Ut.image.width||b.height!==Ut.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(b)}}const $t=b.texture;($t.isData3DTexture||$t.isDataArrayTexture||$t.isCompressedArrayTexture)&&(wt=!0);const qt=Lt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(qt[k])?G=qt[k][X]:G=qt[k],ut=!0):b.samples>0&&P.useMultisampledRTT(b)===!1?G=Lt.get(b).__webglMultisampledFramebuffer:Array.isArray(qt)?G=qt[X]:G=qt,C.copy(b.viewport),V.copy(b.scissor),F=b.scissorTest}else C.copy(gt).multiplyScalar(tt).floor(),V.copy(yt).multiplyScalar(tt).floor(),F=mt;if(Vt.bindFramebuffer(H.FRAMEBUFFER,G)&&q&&Vt.drawBuffers(b,G),Vt.viewport(C),Vt.scissor(V),Vt.setScissorTest(F),ut){const It=Lt.get(b.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+k,It.__webglTexture,X)}else if(wt){const It=Lt.get(b.texture),$t=k||0;H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,It.__webglTexture,X||0,$t)}T=-1},this.readRenderTargetPixels=function(b,k,X,q,G,ut,wt){if(!(b&&b.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ot=Lt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&wt!==void 0&&(Ot=Ot[wt]),Ot){Vt.bindFramebuffer(H.FRAMEBUFFER,Ot);try{const It=b.texture,$t=It.format,qt=It.type;if(!se.textureFormatReadable($t)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!se.textureTypeReadable(qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=b.width-q&&X>=0&&X<=b.height-G&&H.readPixels(k,X,q,G,jt.convert($t),jt.convert(qt),ut)}finally{const It=I!==null?Lt.get(I).__webglFramebuffer:null;Vt.bindFramebuffer(H.FRAMEBUFFER,It)}}},this.readRenderTargetPixelsAsync=async function(b,k,X,q,G,ut,wt){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ot=Lt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&wt!==void 0&&(Ot=Ot[wt]),Ot){const It=b.texture,$t=It.format,qt=It.type;if(!se.textureFormatReadable($t))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!se.textureTypeReadable(qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(k>=0&&k<=b.width-q&&X>=0&&X<=b.height-G){Vt.bindFramebuffer(H.FRAMEBUFFER,Ot);const Ut=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,Ut),H.bufferData(H.PIXEL_PACK_BUFFER,ut.byteLength,H.STREAM_READ),H.readPixels(k,X,q,G,jt.convert($t),jt.convert(qt),0);const ue=I!==null?Lt.get(I).__webglFramebuffer:null;Vt.bindFramebuffer(H.FRAMEBUFFER,ue);const Ae=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await ry(H,Ae,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,Ut),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,ut),H.deleteBuffer(Ut),H.deleteSync(Ae),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(b,k=null,X=0){b.isTexture!==!0&&(zo("WebGLRenderer: copyFramebufferToTexture function signature has changed."),k=arguments[0]||null,b=arguments[1]);const q=Math.pow(2,-X),G=Math.floor(b.image.width*q),ut=Math.floor(b.image.height*q),wt=k!==null?k.x:0,Ot=k!==null?k.y:0;P.setTexture2D(b,0),H.copyTexSubImage2D(H.TEXTURE_2D,X,0,0,wt,Ot,G,ut),Vt.unbindTexture()},this.copyTextureToTexture=function(b,k,X=null,q=null,G=0){b.isTexture!==!0&&(zo("WebGLRenderer: copyTextureToTexture function signature has changed."),q=arguments[0]||null,b=arguments[1],k=arguments[2],G=arguments[3]||0,X=null);let ut,wt,Ot,It,$t,qt,Ut,ue,Ae;const Ce=b.isCompressedTexture?b.mipmaps[G]:b.image;X!==null?(ut=X.max.x-X.min.x,wt=X.max.y-X.min.y,Ot=X.isBox3?X.max.z-X.min.z:1,It=X.min.x,$t=X.min.y,qt=X.isBox3?X.min.z:0):(ut=Ce.width,wt=Ce.height,Ot=Ce.depth||1,It=0,$t=0,qt=0),q!==null?(Ut=q.x,ue=q.y,Ae=q.z):(Ut=0,ue=0,Ae=0);const fn=jt.convert(k.format),ge=jt.convert(k.type);let Bt;k.isData3DTexture?(P.setTexture3D(k,0),Bt=H.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(P.setTexture2DArray(k,0),Bt=H.TEXTURE_2D_ARRAY):(P.setTexture2D(k,0),Bt=H.TEXTURE_2D),H.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,k.flipY),H.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),H.pixelStorei(H.UNPACK_ALIGNMENT,k.unpackAlignment);const $e=H.getParameter(H.UNPACK_ROW_LENGTH),Me=H.getParameter(H.UNPACK_IMAGE_HEIGHT),On=H.getParameter(H.UNPACK_SKIP_PIXELS),bi=H.getParameter(H.UNPACK_SKIP_ROWS),wn=H.getParameter(H.UNPACK_SKIP_IMAGES);H.pixelStorei(H.UNPACK_ROW_LENGTH,Ce.width),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Ce.height),H.pixelStorei(H.UNPACK_SKIP_PIXELS,It),H.pixelStorei(H.UNPACK_SKIP_ROWS,$t),H.pixelStorei(H.UNPACK_SKIP_IMAGES,qt);const Us=b.isDataArrayTexture||b.isData3DTexture,De=k.isDataArrayTexture||k.isData3DTexture;if(b.isRenderTargetTexture||b.isDepthTexture){const ti=Lt.get(b),cs=Lt.get(k),Cn=Lt.get(ti.__renderTarget),Ei=Lt.get(cs.__renderTarget);Vt.bindFramebuffer(H.READ_FRAMEBUFFER,Cn.__webglFramebuffer),Vt.bindFramebuffer(H.DRAW_FRAMEBUFFER,Ei.__webglFramebuffer);for(let hi=0;hi<Ot;hi++)Us&&H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,Lt.get(b).__webglTexture,G,qt+hi),b.isDepthTexture?(De&&H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,Lt.get(k).__webglTexture,G,Ae+hi),H.blitFramebuffer(It,$t,ut,wt,Ut,ue,ut,wt,H.DEPTH_BUFFER_BIT,H.NEAREST)):De?H.copyTexSubImage3D(Bt,G,Ut,ue,Ae+hi,It,$t,ut,wt):H.copyTexSubImage2D(Bt,G,Ut,ue,Ae+hi,It,$t,ut,wt);Vt.bindFramebuffer(H.READ_FRAMEBUFFER,null),Vt.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else De?b.isDataTexture||b.isData3DTexture?H.texSubImage3D(Bt,G,Ut,ue,Ae,ut,wt,Ot,fn,ge,Ce.data):k.isCompressedArrayTexture?H.compressedTexSubImage3D(Bt,G,Ut,ue,Ae,ut,wt,Ot,fn,Ce.data):H.texSubImage3D(Bt,G,Ut,ue,Ae,ut,wt,Ot,fn,ge,Ce):b.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,G,Ut,ue,ut,wt,fn,ge,Ce.data):b.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,G,Ut,ue,Ce.width,Ce.height,fn,Ce.data):H.texSubImage2D(H.TEXTURE_2D,G,Ut,ue,ut,wt,fn,ge,Ce);H.pixelStorei(H.UNPACK_ROW_LENGTH,$e),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Me),H.pixelStorei(H.UNPACK_SKIP_PIXELS,On),H.pixelStorei(H.UNPACK_SKIP_ROWS,bi),H.pixelStorei(H.UNPACK_SKIP_IMAGES,wn),G===0&&k.generateMipmaps&&H.generateMipmap(Bt),Vt.unbindTexture()},this.copyTextureToTexture3D=function(b,k,X=null,q=null,G=0){return b.isTexture!==!0&&(zo("WebGLRenderer: copyTextureToTexture3D function signature has changed."),X=arguments[0]||null,q=arguments[1]||null,b=arguments[2],k=arguments[3],G=arguments[4]||0),zo('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(b,k,X,q,G)},this.initRenderTarget=function(b){Lt.get(b).__webglFramebuffer===void 0&&P.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?P.setTextureCube(b,0):b.isData3DTexture?P.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?P.setTexture2DArray(b,0):P.setTexture2D(b,0),Vt.unbindTexture()},this.resetState=function(){A=0,D=0,I=null,Vt.reset(),xe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return es}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}}let wp=class extends an{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new zi,this.environmentIntensity=1,this.environmentRotation=new zi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};class ea extends hr{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new de(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const ml=new z,gl=new z,bp=new ke,Do=new Hh,Fa=new ta,kc=new z,Ep=new z;let Ng=class extends an{constructor(t=new hn,e=new ea){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)ml.fromBufferAttribute(e,s-1),gl.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=ml.distanceTo(gl);t.setAttribute("lineDistance",new Ve(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Fa.copy(i.boundingSphere),Fa.applyMatrix4(s),Fa.radius+=r,t.ray.intersectsSphere(Fa)===!1)return;bp.copy(s).invert(),Do.copy(t.ray).applyMatrix4(bp);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){const f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){const p=u.getX(v),y=u.getX(v+1),E=Oa(this,t,Do,l,p,y);E&&e.push(E)}if(this.isLineLoop){const v=u.getX(g-1),m=u.getX(f),p=Oa(this,t,Do,l,v,m);p&&e.push(p)}}else{const f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){const p=Oa(this,t,Do,l,v,v+1);p&&e.push(p)}if(this.isLineLoop){const v=Oa(this,t,Do,l,g-1,f);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Oa(n,t,e,i,s,r){const o=n.geometry.attributes.position;if(ml.fromBufferAttribute(o,s),gl.fromBufferAttribute(o,r),e.distanceSqToSegment(ml,gl,kc,Ep)>i)return;kc.applyMatrix4(n.matrixWorld);const l=t.ray.origin.distanceTo(kc);if(!(l<t.near||l>t.far))return{distance:l,point:Ep.clone().applyMatrix4(n.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:n}}const Tp=new z,Ap=new z;class Fg extends Ng{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Tp.fromBufferAttribute(e,s),Ap.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Tp.distanceTo(Ap);t.setAttribute("lineDistance",new Ve(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class Og extends hr{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new de(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const Rp=new ke,Ku=new Hh,ka=new ta,Ba=new z;class _T extends an{constructor(t=new hn,e=new Og){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ka.copy(i.boundingSphere),ka.applyMatrix4(s),ka.radius+=r,t.ray.intersectsSphere(ka)===!1)return;Rp.copy(s).invert(),Ku.copy(t.ray).applyMatrix4(Rp);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){const d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=d,v=f;g<v;g++){const m=c.getX(g);Ba.fromBufferAttribute(h,m),Cp(Ba,m,l,s,t,e,this)}}else{const d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let g=d,v=f;g<v;g++)Ba.fromBufferAttribute(h,g),Cp(Ba,g,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Cp(n,t,e,i,s,r,o){const a=Ku.distanceSqToPoint(n);if(a<e){const l=new z;Ku.closestPointToPoint(n,l),l.applyMatrix4(i);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class $h extends hn{constructor(t=[new fe(0,-.5),new fe(.5,0),new fe(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Un(s,0,Math.PI*2);const r=[],o=[],a=[],l=[],c=[],u=1/e,h=new z,d=new fe,f=new z,g=new z,v=new z;let m=0,p=0;for(let y=0;y<=t.length-1;y++)switch(y){case 0:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,f.x=p*1,f.y=-m,f.z=p*0,v.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:l.push(v.x,v.y,v.z);break;default:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,f.x=p*1,f.y=-m,f.z=p*0,g.copy(f),f.x+=v.x,f.y+=v.y,f.z+=v.z,f.normalize(),l.push(f.x,f.y,f.z),v.copy(g)}for(let y=0;y<=e;y++){const E=i+y*u*s,x=Math.sin(E),U=Math.cos(E);for(let A=0;A<=t.length-1;A++){h.x=t[A].x*x,h.y=t[A].y,h.z=t[A].x*U,o.push(h.x,h.y,h.z),d.x=y/e,d.y=A/(t.length-1),a.push(d.x,d.y);const D=l[3*A+0]*x,I=l[3*A+1],T=l[3*A+0]*U;c.push(D,I,T)}}for(let y=0;y<e;y++)for(let E=0;E<t.length-1;E++){const x=E+y*t.length,U=x,A=x+t.length,D=x+t.length+1,I=x+1;r.push(U,A,I),r.push(D,I,A)}this.setIndex(r),this.setAttribute("position",new Ve(o,3)),this.setAttribute("uv",new Ve(a,2)),this.setAttribute("normal",new Ve(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new $h(t.points,t.segments,t.phiStart,t.phiLength)}}class Xh extends hn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],d=[],f=[];let g=0;const v=[],m=i/2;let p=0;y(),o===!1&&(t>0&&E(!0),e>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new Ve(h,3)),this.setAttribute("normal",new Ve(d,3)),this.setAttribute("uv",new Ve(f,2));function y(){const x=new z,U=new z;let A=0;const D=(e-t)/i;for(let I=0;I<=r;I++){const T=[],S=I/r,C=S*(e-t)+t;for(let V=0;V<=s;V++){const F=V/s,W=F*l+a,Z=Math.sin(W),K=Math.cos(W);U.x=C*Z,U.y=-S*i+m,U.z=C*K,h.push(U.x,U.y,U.z),x.set(Z,D,K).normalize(),d.push(x.x,x.y,x.z),f.push(F,1-S),T.push(g++)}v.push(T)}for(let I=0;I<s;I++)for(let T=0;T<r;T++){const S=v[T][I],C=v[T+1][I],V=v[T+1][I+1],F=v[T][I+1];(t>0||T!==0)&&(u.push(S,C,F),A+=3),(e>0||T!==r-1)&&(u.push(C,V,F),A+=3)}c.addGroup(p,A,0),p+=A}function E(x){const U=g,A=new fe,D=new z;let I=0;const T=x===!0?t:e,S=x===!0?1:-1;for(let V=1;V<=s;V++)h.push(0,m*S,0),d.push(0,S,0),f.push(.5,.5),g++;const C=g;for(let V=0;V<=s;V++){const W=V/s*l+a,Z=Math.cos(W),K=Math.sin(W);D.x=T*K,D.y=m*S,D.z=T*Z,h.push(D.x,D.y,D.z),d.push(0,S,0),A.x=Z*.5+.5,A.y=K*.5*S+.5,f.push(A.x,A.y),g++}for(let V=0;V<s;V++){const F=U+V,W=C+V;x===!0?u.push(W,W+1,F):u.push(W+1,W,F),I+=3}c.addGroup(p,I,x===!0?1:2),p+=I}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Xh(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}const za=new z,Ha=new z,Bc=new z,Ga=new li;class kg extends hn{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){const s=Math.pow(10,4),r=Math.cos(il*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),d={},f=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);const{a:v,b:m,c:p}=Ga;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),Ga.getNormal(Bc),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){const E=(y+1)%3,x=h[y],U=h[E],A=Ga[u[y]],D=Ga[u[E]],I=`${x}_${U}`,T=`${U}_${x}`;T in d&&d[T]?(Bc.dot(d[T].normal)<=r&&(f.push(A.x,A.y,A.z),f.push(D.x,D.y,D.z)),d[T]=null):I in d||(d[I]={index0:c[y],index1:c[E],normal:Bc.clone()})}}for(const g in d)if(d[g]){const{index0:v,index1:m}=d[g];za.fromBufferAttribute(a,v),Ha.fromBufferAttribute(a,m),f.push(za.x,za.y,za.z),f.push(Ha.x,Ha.y,Ha.z)}this.setAttribute("position",new Ve(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}}class Ol extends hn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const u=[],h=new z,d=new z,f=[],g=[],v=[],m=[];for(let p=0;p<=i;p++){const y=[],E=p/i;let x=0;p===0&&o===0?x=.5/e:p===i&&l===Math.PI&&(x=-.5/e);for(let U=0;U<=e;U++){const A=U/e;h.x=-t*Math.cos(s+A*r)*Math.sin(o+E*a),h.y=t*Math.cos(o+E*a),h.z=t*Math.sin(s+A*r)*Math.sin(o+E*a),g.push(h.x,h.y,h.z),d.copy(h).normalize(),v.push(d.x,d.y,d.z),m.push(A+x,1-E),y.push(c++)}u.push(y)}for(let p=0;p<i;p++)for(let y=0;y<e;y++){const E=u[p][y+1],x=u[p][y],U=u[p+1][y],A=u[p+1][y+1];(p!==0||o>0)&&f.push(E,x,A),(p!==i-1||l<Math.PI)&&f.push(x,U,A)}this.setIndex(f),this.setAttribute("position",new Ve(g,3)),this.setAttribute("normal",new Ve(v,3)),this.setAttribute("uv",new Ve(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Ol(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}}class qh extends hn{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new z,h=new z,d=new z;for(let f=0;f<=i;f++)for(let g=0;g<=s;g++){const v=g/s*r,m=f/i*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),d.subVectors(h,u).normalize(),l.push(d.x,d.y,d.z),c.push(g/s),c.push(f/i)}for(let f=1;f<=i;f++)for(let g=1;g<=s;g++){const v=(s+1)*f+g-1,m=(s+1)*(f-1)+g-1,p=(s+1)*(f-1)+g,y=(s+1)*f+g;o.push(v,m,y),o.push(m,p,y)}this.setIndex(o),this.setAttribute("position",new Ve(a,3)),this.setAttribute("normal",new Ve(l,3)),this.setAttribute("uv",new Ve(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new qh(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class vT extends hr{static get type(){return"MeshLambertMaterial"}constructor(t){super(),this.isMeshLambertMaterial=!0,this.color=new de(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new de(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=_g,this.normalScale=new fe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new zi,this.combine=Uh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class Bg extends ea{static get type(){return"LineDashedMaterial"}constructor(t){super(),this.isLineDashedMaterial=!0,this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}}class zg extends an{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new de(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class xT extends zg{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(an.DEFAULT_UP),this.updateMatrix(),this.groundColor=new de(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const zc=new ke,Pp=new z,Lp=new z;class MT{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new fe(512,512),this.map=null,this.mapPass=null,this.matrix=new ke,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gh,this._frameExtents=new fe(1,1),this._viewportCount=1,this._viewports=[new qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,i=this.matrix;Pp.setFromMatrixPosition(t.matrixWorld),e.position.copy(Pp),Lp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Lp),e.updateMatrixWorld(),zc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(zc),i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(zc)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class yT extends MT{constructor(){super(new Vh(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class ST extends zg{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(an.DEFAULT_UP),this.updateMatrix(),this.target=new an,this.shadow=new yT}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Ih}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Ih);function _l(n,t=!1){const e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new hn;let c=0;for(let u=0;u<n.length;++u){const h=n[u];let d=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(const f in h.attributes){if(!i.has(f))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+f+'" attribute exists among all geometries, or in none of them.'),null;r[f]===void 0&&(r[f]=[]),r[f].push(h.attributes[f]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(const f in h.morphAttributes){if(!s.has(f))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;o[f]===void 0&&(o[f]=[]),o[f].push(h.morphAttributes[f])}if(t){let f;if(e)f=h.index.count;else if(h.attributes.position!==void 0)f=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,f,u),c+=f}}if(e){let u=0;const h=[];for(let d=0;d<n.length;++d){const f=n[d].index;for(let g=0;g<f.count;++g)h.push(f.getX(g)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(const u in r){const h=Dp(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(const u in o){const h=o[u][0].length;if(h===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){const f=[];for(let v=0;v<o[u].length;++v)f.push(o[u][v][d]);const g=Dp(f);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(g)}}return l}function Dp(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){const u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}const o=new t(r),a=new Gn(o,e,i);let l=0;for(let c=0;c<n.length;++c){const u=n[c];if(u.isInterleavedBufferAttribute){const h=l/e;for(let d=0,f=u.count;d<f;d++)for(let g=0;g<e;g++){const v=u.getComponent(d,g);a.setComponent(d+h,g,v)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}const wT={...Wt,limit:"#6f8aa5"},lr=n=>wT[n],Hg={x:new z(1,0,0),y:new z(0,1,0),z:new z(0,0,1)},Oi=n=>Ml?Math.ceil(n/2):n,bT=n=>new z(...lo[n]),Gg=(n,t)=>new ls().setFromUnitVectors(Hg[n],bT(t));function Hc(n,{colour:t,centre_m:e,along:i},s){n.deleteAttribute("uv");const r=new de(t),o=new Float32Array(n.attributes.position.count*3);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return n.setAttribute("color",new Gn(o,3)),i&&n.applyQuaternion(Gg(s,i)),n.translate(...e)}const ET={box:n=>Hc(new go(...n.size_m),n),cylinder:n=>Hc(new Xh(n.radius_m,n.other_radius_m??n.radius_m,n.length_m,Oi(32)),n,"y"),torus:n=>Hc(new qh(n.radius_m,n.thickness_m,Oi(8),Oi(72)),n,"z")},Zu=n=>n.map(t=>ET[t.kind](t));function TT(n){const t=new Fi,e=n.role==="predicted"||n.role==="truth";t.inner=e?RT(n):AT(n),t.add(t.inner);const{min:i,max:s}=new po().setFromObject(t.inner);return t.reach="xyz".split("").map(r=>Math.max(-i[r],s[r])),t}function AT({shape:n}){const t=new Fi,e=n.filter(s=>s.lit),i=n.filter(s=>!s.lit);return e.length&&(t.lit=new vT({vertexColors:!0}),t.add(new An(_l(Zu(e)),t.lit))),i.length&&t.add(new An(_l(Zu(i)),new mo({vertexColors:!0}))),t}function RT({role:n,shape:t}){const e=Zu(t),i=lr(n),s=new An(_l(e),new mo({color:i,transparent:!0,opacity:.16,depthWrite:!1}));return s.add(new Fg(_l(e.map(r=>new kg(r,40))),new ea({color:i,transparent:!0,opacity:.75}))),s}function Ju(n,t){const e=Oi(64);return Array.from({length:e+1},(i,s)=>{const r=s/e*2*Math.PI;return new z(n,t*Math.cos(r),t*Math.sin(r))})}function Ip(n,t,e){return Array.from({length:e},(i,s)=>{const r=s/e*2*Math.PI;return n.map((o,a)=>new z(o,t[a]*Math.cos(r),t[a]*Math.sin(r)))})}function Qu(n,t){const[e,i]=[[],[]];for(const r of n){let o=0;for(let a=1;a<r.length;a+=1)e.push(r[a-1],r[a]),i.push(o,o+=r[a].distanceTo(r[a-1]))}const s=new hn().setFromPoints(e);return s.setAttribute("lineDistance",new Ve(i,1)),new Fg(s,t)}const Yh=(n,t)=>new mo({color:lr(n),transparent:!0,opacity:t,side:Di,forceSinglePass:!0,depthWrite:!1}),th=(n,t)=>new ea({color:lr(n),transparent:!0,opacity:t});function CT(n){const{stations_m:t,radii_m:e}=n,i=new Fi;if(n.skin){const a=new An(new $h(t.map((l,c)=>new fe(e[c],l)),Oi(48)),Yh(n.role,.05));a.rotation.z=-Math.PI/2,i.add(a)}const s=[...Ip(t,e,n.meridians),...n.rings.map(([a,l])=>Ju(a,l))],r=[...Ip(t,e,n.faint_meridians),...n.faint_rings.map(([a,l])=>Ju(a,l))];n.axis&&r.push([t[0],t[t.length-1]].map(a=>new z(a,0,0)));const o=()=>new Bg({color:lr(n.role),dashSize:.35,gapSize:.22,transparent:!0,opacity:.85});return s.length&&i.add(Qu(s,n.dashed?o():th(n.role,.8))),r.length&&i.add(Qu(r,th(n.role,.38))),i.quaternion.copy(Gg("x",n.along)),i.position.set(...n.origin_m),i}function PT({role:n,radius_m:t}){const e=new Fi,i=([r,o,a])=>[new z(r,o,a),new z(o,r,a),new z(a,o,r)],s=Ju(0,t).map(r=>i(r.toArray()));return e.add(new An(new Ol(t,Oi(32),Oi(20)),Yh(n,.1)),Qu([0,1,2].map(r=>s.map(o=>o[r])),th(n,.7))),e}const LT=n=>n.kind==="sphere"?PT(n):CT(n);function DT(){const n=[];let t=7;const e=()=>(t=t*16807%2147483647,t/2147483647);for(let s=0;s<Oi(1400);s+=1){const r=2*e()-1,o=2*Math.PI*e(),a=Math.sqrt(1-r*r);n.push(900*a*Math.cos(o),900*r,900*a*Math.sin(o))}const i=new hn;return i.setAttribute("position",new Ve(n,3)),new _T(i,new Og({color:9413562,size:1.3,sizeAttenuation:!1,transparent:!0,opacity:.7}))}function IT({direction:n,half_angle_rad:t,colour:e}){const i=new z(...n).normalize(),s=Math.PI/2-t,r=new Ol(500*Math.sin(t),Oi(96),Oi(16),0,2*Math.PI,0,1.05*s);r.applyQuaternion(new ls().setFromUnitVectors(Hg.y,i.clone().negate()));const o=r.attributes.position,a=new de().setStyle(e,ur),l=[],c=new z;for(let h=0;h<o.count;h+=1){c.fromBufferAttribute(o,h).normalize();const d=Math.sin(23*c.x+5*Math.sin(17*c.z))*Math.sin(19*c.z+4*Math.sin(13*c.x)),g=Math.max(.15,c.x*-.35+c.y*.75+c.z*.35)*(.124+.024*d);l.push(g*a.r,g*a.g,g*a.b)}r.setAttribute("color",new Ve(l,3));const u=new An(r,new mo({vertexColors:!0}));return u.position.copy(i).multiplyScalar(500),u}function UT(n){const t=new Fi;n.stars&&t.add(DT());for(const e of n.sky)t.add(IT(e));return t}class NT{constructor(t,e=24,i=10){this.stations=e,this.sides=i,this.places=new Float32Array(e*i*3);const s=[];for(let o=0;o<e-1;o+=1)for(let a=0;a<i;a+=1){const l=o*i+a,c=o*i+(a+1)%i;s.push(l,c,l+i,c,c+i,l+i)}const r=new hn;r.setAttribute("position",new Gn(this.places,3)),r.setIndex(s),this.mesh=new An(r,Yh(t,.22)),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set({rows:t,at:e,n:i}){if(this.mesh.visible=i>1,!!this.mesh.visible){for(let s=0;s<this.stations;s+=1){const r=s/(this.stations-1)*(i-1),o=Math.min(Math.floor(r),i-2),a=r-o,l=u=>t[o][e+u]+(t[o+1][e+u]-t[o][e+u])*a,c=l(3);for(let u=0;u<this.sides;u+=1){const h=u/this.sides*2*Math.PI,d=(s*this.sides+u)*3;this.places[d]=l(0),this.places[d+1]=l(1)+c*Math.cos(h),this.places[d+2]=l(2)+c*Math.sin(h)}}this.mesh.geometry.attributes.position.needsUpdate=!0}}}class FT{constructor(t,e,i){this.most=e,this.places=new Float32Array(e*3);const s=new hn;s.setAttribute("position",new Gn(this.places,3));const r=i?new Bg({color:lr(t),dashSize:.25,gapSize:.2}):new ea({color:lr(t)});this.dashed=i,this.line=new Ng(s,r),this.line.frustumCulled=!1,this.line.visible=!1}set({rows:t,at:e,n:i}){const s=i>0?t[i-1]:null;if(t===this.rows&&i===this.count&&s===this.last)return;Object.assign(this,{rows:t,count:i,last:s});const r=Math.max(1,Math.ceil(i/this.most));let o=0;for(let a=0;a<i&&o<this.most;a+=r,o+=1){const l=t[a];this.places[o*3]=l[e],this.places[o*3+1]=l[e+1],this.places[o*3+2]=l[e+2]}this.line.geometry.setDrawRange(0,o),this.line.geometry.attributes.position.needsUpdate=!0,this.dashed&&this.line.computeLineDistances(),this.line.visible=o>1}}const OT=.5,kT=25,BT=[5,4],Gc=new WeakMap,[Vc,Hr,Gr]=[new ke,new qe,new qe];function zT(n){return Gc.has(n)||Gc.set(n,new kg(n,kT)),Gc.get(n)}class Up{constructor(t){Object.assign(this,{canvas:t,pen:t.getContext("2d",{willReadFrequently:!0}),ratio:1,cut:!1,colour:"#000"}),this.at={left:0,top:0,width:0,height:0}}setPixelRatio(t){this.ratio=t}setSize(t,e){this.size={width:t,height:e},this.canvas.width=Math.max(1,Math.round(t*this.ratio)),this.canvas.height=Math.max(1,Math.round(e*this.ratio))}setScissorTest(t){this.cut=t}setScissor(){}setViewport(t,e,i,s){this.at={left:t,top:this.size.height-e-s,width:i,height:s}}setClearColor(t){this.colour=`#${t.toString(16).padStart(6,"0")}`}clear(){const{left:t,top:e,width:i,height:s}=this.cut?this.at:{left:0,top:0,...this.size};this.pen.setTransform(this.ratio,0,0,this.ratio,0,0),this.pen.fillStyle=this.colour,this.pen.fillRect(t,e,i,s)}clearDepth(){}dispose(){}render(t,e){const{pen:i,at:s}=this;t.updateMatrixWorld(),e.updateMatrixWorld(),i.save(),i.beginPath(),i.rect(s.left,s.top,s.width,s.height),i.clip();const r=new ke().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);t.traverseVisible(o=>{o.layers.test(e.layers)&&(o.isLine?this.lines(o,o.geometry,o.isLineSegments?2:1,r,`#${o.material.color.getHexString()}`):o.isMesh&&o.material.opacity>OT&&this.lines(o,zT(o.geometry),2,r,Wt.plain))}),i.restore()}lines({matrixWorld:t,material:e},i,s,r,o){const{pen:a}=this,{position:l}=i.attributes,c=Math.min(l.count,i.drawRange.count);Vc.multiplyMatrices(r,t),a.strokeStyle=o,a.globalAlpha=e.transparent?e.opacity:1,a.lineWidth=1,a.setLineDash(e.isLineDashedMaterial?BT:[]),a.beginPath();for(let u=0;u+1<c;u+=s)Hr.fromBufferAttribute(l,u).setW(1).applyMatrix4(Vc),Gr.fromBufferAttribute(l,u+1).setW(1).applyMatrix4(Vc),HT()&&(a.moveTo(...this.place(Hr)),a.lineTo(...this.place(Gr)));a.stroke(),a.globalAlpha=1}place(t){const{left:e,top:i,width:s,height:r}=this.at;return[e+(t.x/t.w+1)/2*s,i+(1-t.y/t.w)/2*r]}pixels(){return this.pen.getImageData(0,0,this.canvas.width,this.canvas.height).data}}function HT(){const[n,t]=[Hr.z+Hr.w,Gr.z+Gr.w];return n<=0&&t<=0?!1:(n<=0?Hr.lerp(Gr,(1e-6-n)/(t-n)):t<=0&&Gr.lerp(Hr,(1e-6-t)/(n-t)),!0)}const Va=1,GT=22e5,[VT,WT,Np]=[60,38,.35],Wc=Ml?.5:1,$T=1e3,Fp=24,XT=64,[qT,YT]=[860723,3159354],Wa=n=>new z(...lo[n]);class jT{constructor(t,e,i,s){this.elements={view:e,camera:i,labels:s},this.canvas=t;const r={antialias:!Ml,alpha:!1,powerPreference:"high-performance",preserveDrawingBuffer:!0},o=t.getContext("webgl2",r);this.webgl=o!==null,this.webgl?(this.renderer=new gT({canvas:t,context:o,...r}),this.renderer.autoClear=!1,t.addEventListener("webglcontextlost",()=>this.outline())):this.renderer=new Up(t),this.scene=new wp,this.scene.add(new xT(14674431,2763306,.9));const a=new ST(16777215,2.3);a.position.set(-6,9,5),this.scene.add(a),this.far=new wp,this.perspective=new Kn(32,1,.1,2e3),this.ortho=new Vh(-1,1,1,-1,-100,200),this.onboard=new Kn(20,1,.02,2e3);for(const c of[this.perspective,this.ortho])c.layers.enable(Va);Object.assign(this,{display:null,world:null,items:new Map,bodies:[],eyes:[],chosen:0}),Object.assign(this,{enabled:!0,drawn:0,quality:Wc,adaptive:!0,pace:33,since:0}),this.marks=new Map,this.follow(e),this.resize();const l=new ResizeObserver(()=>this.resize());for(const c of[e,i])l.observe(c);addEventListener("resize",()=>this.resize())}outline(){const t=this.canvas.cloneNode(!1);this.canvas.replaceWith(t),this.renderer.dispose(),Object.assign(this,{canvas:t,webgl:!1,renderer:new Up(t)}),this.resize()}adapt(t){if(!this.adaptive)return;this.pace=this.pace*.8+Math.min(t,400)*.2,this.since+=1;const e=this.pace>VT&&this.quality>Np,i=this.pace<WT&&this.quality<Wc;this.since<(i?150:6)||!(e||i)||(this.quality=Math.max(Np,Math.min(Wc,this.quality*(e?.7:1.25))),this.since=0,this.resize())}setDisplay(t){for(const e of[this.world,...this.far.children])ZT(e);this.far.clear(),this.far.add(UT(t)),this.world=new Fi,this.scene.add(this.world),this.items.clear(),this.bodies=t.bodies.map(e=>this.add(e,TT(e),!Array.isArray(e.place))),this.moving=this.bodies.filter(({moves:e})=>e);for(const e of t.surfaces){const i=this.add(e,LT(e),e.kind==="sphere"&&!Array.isArray(e.place));i.moves?this.moving.push(i):e.kind==="sphere"&&i.object.position.set(...e.place)}this.lines=t.lines.map(e=>this.addLine(e)),this.eyes=t.views.map(e=>({azimuth:e.azimuth_rad,height:e.height_rad,zoom:1,focus:e.kind==="perspective"?new z(...Op(e,null)):null})),(this.display===null||this.chosen>=t.views.length)&&(this.chosen=0),this.display=t,this.cameraTan=void 0,this.frame=null,this.shot=[]}add(t,e,i){const s={item:t,object:e,moves:i};return i?(e.visible=!1,e.traverse(r=>r.layers.set(Va))):t.kind==="body"&&e.position.set(...t.place),this.items.set(t.name,e),this.world.add(e),s}addLine(t){const e=Array.isArray(t.points),i=e?t.points.length:t.kind==="line"?XT:t.since?Fp+3:$T,s=new FT(t.role,i,t.dashed);e?s.set({rows:t.points,at:0,n:i}):s.line.layers.set(Va),this.items.set(t.name,s.line),this.world.add(s.line);const r=t.spread?new NT(t.role):null;return r&&(r.mesh.layers.set(Va),this.world.add(r.mesh)),{line:t,path:s,tube:r,stands:e}}place(t,e,i,s){this.frame=t;for(const{item:r,object:o}of this.moving){const a=yi(t,r.place,r.axes);o.visible=!!a,a&&o.position.set(...a);const l=a&&r.attitude?Zn(t,r.attitude):void 0;l&&o.inner.quaternion.set(...l),r.role==="measured"&&o.inner?.lit&&o.inner.lit.emissive.setHex(s?YT:qT)}for(const{line:r,path:o,tube:a,stands:l}of this.lines)if(!l)if(r.kind==="line"){const c=Zn(t,r.points)||[];o.set({rows:c,at:0,n:c.length})}else{const c=T_(r,e?.trails.get(r.name)||[],t,i,Fp);o.set(c),a?.set(c)}}known(t){for(const e of t){const{item:i}=this.bodies.find(r=>r.item.name===e),s=yi(this.frame,i.place,i.axes);if(s)return{item:i,at:s,turn:i.attitude?Zn(this.frame,i.attitude):void 0}}return null}resize(){const t=[this.elements.view,this.elements.camera].map(u=>u.getBoundingClientRect()),e=t.filter(u=>u.width>0),i=Math.min(...e.map(u=>u.left)),s=Math.min(...e.map(u=>u.top)),r=Math.max(...e.map(u=>u.right))-i,o=Math.max(...e.map(u=>u.bottom))-s,a=u=>({left:u.left-i,bottom:s+o-u.bottom,width:u.width,height:u.height});this.places={view:a(t[0]),camera:a(t[1])};const{canvas:l}=this;Object.assign(l.style,{left:`${i+scrollX}px`,top:`${s+scrollY}px`,width:`${r}px`,height:`${o}px`});const c=Math.min(devicePixelRatio||1,Math.sqrt(GT/Math.max(r*o,1)));this.renderer.setPixelRatio(c*this.quality),this.renderer.setSize(r,o,!1),this.renderer.setScissorTest(!1),this.renderer.setClearColor(527378,1),this.renderer.clear(),this.renderer.setScissorTest(!0),this.shot=[],this.tall=parseFloat(getComputedStyle(this.elements.labels).fontSize)}follow(t){let e=null;t.addEventListener("pointerdown",i=>{i.target.closest("button")||(e=[i.clientX,i.clientY],t.setPointerCapture(i.pointerId))}),t.addEventListener("pointermove",i=>{e&&(this.turn((i.clientX-e[0])*.005,(i.clientY-e[1])*.005),e=[i.clientX,i.clientY])}),t.addEventListener("pointerup",()=>{e=null}),t.addEventListener("wheel",i=>{i.preventDefault(),this.zoom(Math.exp(i.deltaY*.001))},{passive:!1})}turn(t,e){const i=this.eyes[this.chosen];i?.focus&&(i.azimuth+=t,i.height=Math.max(-1.4,Math.min(1.4,i.height+e)))}zoom(t){const e=this.eyes[this.chosen];e&&(e.zoom=Math.max(.15,Math.min(4,e.zoom*t)))}draw(){if(!this.enabled||!this.display)return;this.drawn+=1;const{view:t,camera:e}=this.places,i=this.display.views[this.chosen],s=i.kind==="flat";if(s)for(const{object:u}of this.bodies)u.scale.setComponent("xyz".indexOf(i.up[1]),1/i.stretch);const r=s?this.flat(i,t):this.orbit(i,t);if(this.lens=r,this.into(t,r,!s),this.label(r,t,s?i:null),s)for(const{object:u}of this.bodies)u.scale.set(1,1,1);if(!this.display.camera||e.height<=20)return;const o=this.known(this.display.camera.carried_by);if(!o){this.shot!==null&&this.blank(e),this.shot=null;return}const{at:a,turn:l}=KT(this.display.camera,o),c=[...a,...l];this.shot??=[],c.some((u,h)=>u!==this.shot[h])&&(this.shot=c,this.aim(this.display.camera,a,l,e),this.into(e,this.onboard,!0))}orbit(t,e){const i=this.perspective,s=e.width/Math.max(e.height,1),r=this.eyes[this.chosen],{focus:o}=r;o.lerp(new z(...Op(t,this.known(t.follow)?.at)),.08);const a=o.distanceTo(new z(...t.centre_m)),l=r.zoom*(t.distance_m+t.growth*a)*Math.max(1,1.45/s),c=Math.cos(r.height);return i.position.set(o.x+l*c*Math.cos(r.azimuth),o.y+l*Math.sin(r.height),o.z+l*c*Math.sin(r.azimuth)),i.lookAt(o),i.aspect=s,i.updateProjectionMatrix(),i}flat(t,e){const i=this.ortho,s=t.span_m/2*this.eyes[this.chosen].zoom,r=s/(e.width/Math.max(e.height,1))/t.stretch;Object.assign(i,{left:-s,right:s,top:r,bottom:-r});const o=new z(...t.centre_m);return i.up.copy(Wa(t.up)),i.position.copy(Wa(t.right)).cross(i.up).multiplyScalar(50).add(o),i.lookAt(o),i.updateProjectionMatrix(),i}aim(t,e,i,s){const r=this.onboard,o=new ls(...i);r.up.copy(Wa(t.up).applyQuaternion(o)),r.position.set(...e),r.lookAt(r.position.clone().add(Wa(t.look).applyQuaternion(o)));const a=Math.max(Ii(t.look,t.aim_m)-Ii(t.look,e),.4);this.cameraTan=hM(t,a,this.cameraTan),r.fov=2*Math.atan(this.cameraTan)*180/Math.PI,r.aspect=s.width/Math.max(s.height,1),r.updateProjectionMatrix(),r.updateMatrixWorld()}blank(t){this.renderer.setViewport(t.left,t.bottom,t.width,t.height),this.renderer.setScissor(t.left,t.bottom,t.width,t.height),this.renderer.setClearColor(329740,1),this.renderer.clear(!0,!0)}into(t,e,i){if(this.blank(t),i){const s=e.position.clone();e.position.set(0,0,0),e.updateMatrixWorld(),this.renderer.render(this.far,e),e.position.copy(s),e.updateMatrixWorld(),this.renderer.clearDepth()}this.renderer.render(this.scene,e)}label(t,e,i){const s=i?i.up:"+y",r=i?i.stretch:1,o=new Map;for(const{text:l,at_m:c}of this.display.labels)o.set(l,{text:l,at:c,drop:1});for(const{item:l,object:c}of this.bodies){const u=l.label?yi(this.frame,l.place,l.axes):void 0;if(!u)continue;const h=u.map((d,f)=>d+lo[s][f]*c.reach[f]/r);o.set(`body ${l.name}`,{text:l.label,at:h,role:l.role})}for(const[l,c]of this.marks)o.has(l)||(c.remove(),this.marks.delete(l));t.updateMatrixWorld();const a=[];for(const[l,{text:c,at:u,role:h,drop:d}]of o){let f=this.marks.get(l);f||(f=document.createElement("span"),f.textContent=c,h&&(f.className="body",f.style.color=lr(h)),this.elements.labels.append(f),this.marks.set(l,f));const g=new z(u[0],u[1],u[2]).project(t),v=Math.abs(g.x)<.98&&Math.abs(g.y)<.96&&g.z<1;f.style.display=v?"":"none";const m=Math.round((g.x+1)/2*e.width);let p=Math.round((1-g.y)/2*e.height)+(d?14:0);if(h){const y=([E,x])=>Math.abs(E-m)<5*this.tall&&Math.abs(x-p)<this.tall;for(;a.some(y);)p-=2;a.push([m,p])}f.style.left=`${m}px`,f.style.top=`${p}px`}}onView(t){if(!this.lens)return null;const e=new z(...t).project(this.lens);return e.z>1?null:[(e.x+1)/2*this.places.view.width,(1-e.y)/2*this.places.view.height]}onCamera(t){const e=new z(...t).project(this.onboard);return e.z>1?null:[e.x,e.y]}covers(t){const e=this.items.get(t),i=e.visible,s=[i,!1].map(o=>{if(e.visible=o,this.draw(),!this.webgl)return this.renderer.pixels();const a=this.renderer.getContext(),l=new Uint8Array(a.drawingBufferWidth*a.drawingBufferHeight*4);return a.readPixels(0,0,a.drawingBufferWidth,a.drawingBufferHeight,a.RGBA,a.UNSIGNED_BYTE,l),l});e.visible=i;let r=0;for(let o=0;o<s[0].length;o+=4)(s[0][o]!==s[1][o]||s[0][o+1]!==s[1][o+1])&&(r+=1);return r}}function KT(n,t){const e=n.turns&&t.turn||[0,0,0,1],i=new z(...n.at_m).applyQuaternion(new ls(...e));return{at:[t.at[0]+i.x,t.at[1]+i.y,t.at[2]+i.z],turn:e}}function ZT(n){n?.traverse(t=>{t.geometry?.dispose(),t.material?.dispose()}),n?.removeFromParent()}function Op(n,t){if(!n.follow.length)return n.centre_m;const e=t?Ii(n.along,t)-Ii(n.along,n.centre_m):n.start_m,i=n.share*Math.sign(n.start_m)*Math.max(n.least_m,e*Math.sign(n.start_m));return n.centre_m.map((s,r)=>s+i*lo[n.along][r])}function JT(n){return n.kind==="flat"&&n.stretch!==1?Yt(N.exaggerated,{axis:n.up[1],n:n.stretch}):""}const xn=n=>document.getElementById(n),QT=["section","lights","ladder","reticle","ball","dial"],tA=250,eA=n=>Yt(n<0?N.before:N.ahead,{s:_e(Math.abs(n),1)});class nA{constructor(t,e){Object.assign(this,{scene:t,choose:e}),this.instruments=new o0,this.commands=new c0,this.charts=new lM,this.digits=new mM,this.chartsAt=0,this.text=""}setDisplay(t){const e=JSON.stringify(t);if(e===this.text){this.scene.place(null,null,0,!1);return}this.text=e,this.display=t,this.instruments.setDisplay(t),this.commands.setDisplay(t),this.charts.setDisplay(t),this.digits.setDisplay(t.camera),a0(t.section),J_(t.attitude),e0(t.lamps);for(const i of["trip","ladder-panel"])xn(i).hidden=!t.link;xn("clock-rx").parentElement.hidden=!t.link,xn("camera").hidden=!t.camera,xn("clock-pred").parentElement.hidden=!t.predicted,t.camera&&(xn("camera").setAttribute("aria-label",t.camera.title),xn("camera-tag").textContent=t.camera.title),y0(t,this.choose),xn("legend").replaceChildren(...t.legend.map(({role:i,words:s,dashed:r})=>{const o=document.createElement("span");return o.className=r?"dash":"",o.style.color=Wt[i],o.textContent=s,o})),this.scene.setDisplay(t);for(const i of QT)Ts(xn(i));xn("views").replaceChildren(...t.views.map((i,s)=>{const r=document.createElement("button");return r.textContent=i.label,r.dataset.view=i.label.toLowerCase(),r.onclick=()=>this.setView(s),r})),xn("views").hidden=t.views.length<2,this.setView(this.scene.chosen)}setView(t){this.scene.chosen=t,[...xn("views").children].forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),xn("scale").textContent=JT(this.display.views[t])}nextView(){this.display&&this.setView((this.scene.chosen+1)%this.display.views.length)}clocks(t,e,i,s,r){const o=Bn(t,this.display.measured),a=Bn(t,this.display.predicted);Ql("gen",o?.t,i,r),Ql("rx",o?.received,s,r),Ql("pred",a?.t,a?eA(a.t-e):"",r)}show({run:t,frame:e,rungs:i,history:s,now:r,stale:o,until:a}){const{display:l}=this,c=Bn(e,l.measured);this.instruments.show(e,o),l.section&&bd(l.section,e),l.attitude&&Sd(l.attitude,e),l.lamps&&wd(l.lamps,e),this.commands.show(e),this.digits.show(e,o),l.link&&this.showLink(t,e,c,i,r),this.scene.place(e,s,r,o),performance.now()-this.chartsAt>tA&&(this.chartsAt=performance.now(),this.charts.show(s.charts,e,a))}blank(){const{display:t}=this;if(!t)return;const e={signals:{}};this.clocks(e,0,"","",!1);for(const i of[this.instruments,this.commands,this.digits])i.show(e,!1);t.section&&bd(t.section,e),t.attitude&&Sd(t.attitude,e),t.lamps&&wd(t.lamps,e);for(const i of["dial","ladder"])Ts(xn(i));for(const i of["ladder-counts","link-counts"])xn(i).textContent="";this.charts.blank(new ah(t,0)),this.scene.place(null,null,0,!1),this.showReticle(e)}showLink(t,e,i,s,r){u0(xn("dial"),t,e.round_trip,i?.transit),h0(e,i,t.step_s,r),I0(xn("ladder"),t,this.display.commands.axes,s,r),Oe(xn("ladder-counts"),N0(s,t.acknowledged))}showReticle(t){!this.display?.camera||!t||(d0(xn("reticle"),this.scene,this.display.camera,t,this.digits.height),this.digits.field(this.scene.cameraTan))}}const ki=n=>document.getElementById(n),$a=2,[kp,$c,iA]=[1280,66,4e6],Bp=1e3,[sA,rA,zp,oA]=[150,1e3,2e4,3],aA=["video/webm;codecs=vp8","video/webm;codecs=vp9","video/webm"],lA=6e4,[cA,uA,eh]=[15,25,1.5],Hp=.3,hA=16;function Xc(n,t,e){const i=t instanceof Blob?t:new Blob([t],{type:e}),s=document.createElement("a");s.href=URL.createObjectURL(i),s.download=n,s.click(),setTimeout(()=>URL.revokeObjectURL(s.href),lA)}const Gp=n=>/[",\n]/.test(n)?`"${n.replaceAll('"','""')}"`:n,Vp=(n,t,e)=>`${[n,t==="plain"?"":t].filter(Boolean).join(" ")}${e?` [${e}]`:""}`;function dA({display:n,frames:t}){const e=[];for(const a of n.instruments?.rows||[])for(const{role:l,value:c}of a.readings)e.push([Vp(a.label,l,a.unit),u=>Rn(u,c)]);const{axes:i,rows:s,unit:r}=n.commands;for(const{label:a,value:l}of s)i.forEach((c,u)=>e.push([Vp(`${a} ${c.name}`,"",r),h=>h.signals[l.signal]?.parts[l.part]?.[u]]));const o=new Map;for(const a of t)for(const[l,c]of Object.entries(Bn(a,"truth")?.parts||{}))!o.has(l)&&qc(c)&&o.set(l,qc(c).length);for(const[a,l]of o)for(let c=0;c<l;c+=1)e.push([`truth ${a}${l>1?` ${c}`:""}`,u=>qc(Bn(u,"truth")?.parts[a])?.[c]]);return e}function qc(n){const t=Array.isArray(n)?n:[n];return t.length&&t.length<=hA&&t.every(e=>typeof e=="number"||e===null)?t:void 0}function fA(n){const t=dA(n),e=s=>Number.isFinite(s)?String(Number(s.toFixed(6))):"",i=[[...X_,...t.map(([s])=>s)].map(Gp)];for(const s of n.frames)i.push([e(s.t),e(s.k),Gp(s.mode||""),...t.map(([,r])=>e(r(s)))]);return`${i.map(s=>s.join(",")).join(`
`)}
`}function Vg(n){const t=p=>ki(p).getBoundingClientRect(),e=parseFloat(getComputedStyle(document.documentElement).fontSize),[i,s,r]=[t("view"),1.9*e,.5*e],o=[];let a=i.width;const[l,c,u,h]=["camera","section","ladder","instruments-rows"].map(t);if(l.width){const p=Math.min(l.width/l.height*i.height,i.width);o.push({draw:pA,x:a+r,y:s,width:p,height:p*l.height/l.width}),a+=r+p}const[d,f]=[s+i.height+r,Math.max(eh*e*ki("instruments-rows").children.length,cA*e)];let g=0;const v=(p,y,E=f)=>{o.push({draw:p,x:g,y:d+(f-E)/2,width:y,height:E}),g+=y+2*r};c.width&&v(mA,f),h.width&&v(vA,Math.min(uA*e,a-g),eh*e*ki("instruments-rows").children.length);const m=a-g;return u.width&&m>u.width/3&&v(gA,Math.min(m,u.width),Math.min(m,u.width)*u.height/u.width),{rem:e,head:s,parts:o,view:i,panels:n,width:a,height:o.some(({y:p})=>p>s)?d+f+r:s+i.height}}function nh(n,{rem:t,head:e,parts:i,view:s,panels:r,width:o},a){const l=n.getContext("2d"),c=n.width/o;l.setTransform(c,0,0,c,0,0),l.fillStyle="#080c12",l.fillRect(0,0,o,n.height/c),l.font=`600 ${.9*t}px system-ui, sans-serif`,l.fillStyle=Wt.text,l.textBaseline="middle",l.textAlign="left",l.fillText(a,.5*t,e/2,o-t),$g(l,r.scene,"view",{x:0,y:e,width:s.width,height:s.height}),_A(l,s,e,t);for(const u of i)u.draw(l,u,t,r)}const Wg=(n,t,{x:e,y:i,width:s,height:r})=>n.drawImage(ki(t),e,i,s,r);function pA(n,t,e,i){$g(n,i.scene,"camera",t),Wg(n,"reticle",t),n.font=`${.76*e}px system-ui, sans-serif`,Ne(n,ki("camera-tag").textContent,t.x+.6*e,t.y+.9*e,Wt.measured)}function mA(n,{x:t,y:e,width:i,height:s}){const r=ki("section"),o=Math.min(r.height,r.width*s/i),a=Math.min(r.width,r.height*i/s);n.drawImage(r,(r.width-a)/2,(r.height-o)/2,a,o,t,e,i,s)}const gA=(n,t)=>Wg(n,"ladder",t);function $g(n,t,e,i){const{left:s,bottom:r,width:o,height:a}=t.places[e],{canvas:l}=t,c=l.width/parseFloat(l.style.width);o>0&&a>0&&n.drawImage(l,s*c,l.height-(r+a)*c,o*c,a*c,i.x,i.y,i.width,i.height)}function _A(n,t,e,i){n.save(),n.beginPath(),n.rect(0,e,t.width,t.height),n.clip();for(const s of ki("labels").children){if(s.style.display==="none")continue;const r=s.className==="body";n.font=`${r?600:400} ${.72*i}px system-ui, sans-serif`,Ne(n,s.textContent,parseFloat(s.style.left),e+parseFloat(s.style.top)-(r?1.15*i:0),s.style.color||"#93a7ba","center")}n.font=`${.76*i}px system-ui, sans-serif`;for(const s of ki("legend").children){const r=s.getBoundingClientRect(),[o,a]=[r.left-t.left,e+r.top-t.top+r.height/2];n.fillStyle=s.style.color;for(const[l,c]of s.className==="dash"?[[0,.22],[.36,.58],[.72,.9]]:[[0,.9]])n.fillRect(o+l*i,a-.1*i,(c-l)*i,.2*i);Ne(n,s.textContent,o+1.25*i,a,s.style.color)}Ne(n,ki("scale").textContent,t.width-.7*i,e+t.height-i,Wt.dim,"right"),n.restore()}function vA(n,{x:t,y:e,width:i},s){[...ki("instruments-rows").children].forEach((r,o)=>{const a=[...r.children],l=i*(1-Hp)/Math.max(a.length-1,1);a.forEach((c,u)=>{n.font=`${c.tagName==="B"?600:400} ${.8*s}px system-ui, sans-serif`,Ne(n,c.textContent,u?t+i*Hp+l*u:t,e+eh*s*(o+.5),getComputedStyle(c).color,u?"right":"left")})})}function xA(n,t,e){const{scene:i}=n,{adaptive:s,quality:r}=i;Object.assign(i,{adaptive:!1,quality:$a}),i.resize();const o=document.createElement("canvas");return F_($a,()=>{e(),i.draw();const a=Vg(n);Object.assign(o,{width:Math.round(a.width*$a),height:Math.round(a.height*$a)}),nh(o,a,t)}),Object.assign(i,{adaptive:s,quality:r}),i.resize(),e(),i.draw(),o}class jr{static kind=aA.find(t=>globalThis.MediaRecorder?.isTypeSupported(t));static get possible(){return jr.kind!==void 0&&!!HTMLCanvasElement.prototype.captureStream}constructor(t,e,i,s){const r=Vg(t),o=document.createElement("canvas");Object.assign(o,{width:kp,height:(c=>2*Math.round(c/2))(kp*r.height/r.width)}),Object.assign(this,{parts:[],bytes:0,heard:1/0,slowest:0,ending:1/0,done:s});const l=o.captureStream(1e3/$c);nh(o,r,e()),this.recorder=new MediaRecorder(l,{mimeType:jr.kind,videoBitsPerSecond:iA}),this.recorder.ondataavailable=({data:c})=>{this.parts.push(c),this.bytes+=c.size;const u=performance.now();this.slowest=Math.max(this.slowest,u-this.heard),this.heard=u},this.recorder.onerror=c=>{this.problem=c.error},this.recorder.onstop=()=>this.over(),this.recorder.start(1),this.timer=setInterval(()=>{this.ending===1/0&&!i($c)&&this.stop();const c=performance.now()-this.ending;c>zp||c>sA&&this.bytes>Bp?this.drain(c):nh(o,r,e())},$c)}drain(t){const i=performance.now()-Math.max(this.heard,this.ending)>Math.max(rA,oA*this.slowest);this.recorder.state!=="inactive"&&(i||t>zp)&&this.recorder.stop()}stop(){this.ending===1/0&&(this.ending=performance.now())}over(){clearInterval(this.timer);const t=this.problem??(this.bytes>Bp?void 0:new Error(q_));this.done(new Blob(this.parts,{type:"video/webm"}),t)}}const MA=2e3,{escape:Ji}=E0,Xa=n=>String(n).padStart(2,"0");let Kr=null,Yc=0;function yA(n){if(!Number.isFinite(n))return N.unknown;const t=new Date(n*1e3);return`${t.getFullYear()}-${Xa(t.getMonth()+1)}-${Xa(t.getDate())} ${Xa(t.getHours())}:${Xa(t.getMinutes())}`}function SA(n){if(!wl()){const t=n.warning();Ls(`<h3 id="runs">${N.review_title}</h3><p class="dim">${N.review_truth}</p>
      ${t?`<p class="alarm" id="review-warning">${Ji(t)}</p>`:""}<div id="runs-table"></div><p id="review-error" class="alarm" role="alert"></p>
      <div class="buttons">${Ko}</div>`,e=>{e.classList.add("wide"),e.onclose=()=>e.classList.remove("wide")})}qg(n),Xg(n,document.getElementById("runs"))}async function Xg(n,t){clearTimeout(Yc);const e=()=>t.isConnected&&wl();try{const i=await n.link.get("api/runs"),s=JSON.stringify(i)===JSON.stringify(Kr);Kr=i,e()&&!s&&qg(n)}catch(i){if(!e())return;document.getElementById("review-error").textContent=i.message,Kr===null&&(document.getElementById("runs-table").textContent="")}clearTimeout(Yc),e()&&(Yc=setTimeout(()=>Xg(n,t),MA))}function qg(n){const t=document.getElementById("runs-table"),e=document.activeElement?.dataset.run,i=wA(n.store);if(Kr===null&&!i){t.innerHTML=`<p>${N.runs_loading}</p>`;return}const s=(Kr||[]).filter(l=>l.name!==i?.name),r=s.map((l,c)=>EA(l,c,n.store.display));i&&r.unshift(`<tr class="dim"><td></td><td>${Ji(i.name)}</td><td colspan="6">${Ji(i.words)}</td><td></td></tr>`);const o=N.runs_columns.map(l=>`<th scope="col">${l}</th>`).join("");t.innerHTML=r.length?`<table class="runs"><tr>${o}<th></th></tr>${r.join("")}</table>`:`<p>${Kr===null?N.runs_loading:N.review_none}</p>`;const a=document.getElementById("review-error");for(const l of t.querySelectorAll("[data-run]"))l.onclick=()=>n.open(s[l.dataset.row],a);for(const l of t.querySelectorAll("[data-report]"))l.onclick=()=>n.report(l.dataset.report,a);e&&[...t.querySelectorAll("[data-run]")].find(l=>l.dataset.run===e)?.focus()}function wA({status:n}){return!n.run||!["starting","flying","closing"].includes(n.phase)?null:{name:n.run,words:n.phase==="closing"?N.runs_closing:N.runs_flying}}function bA({mode:n,modes:t},e){const i=Object.entries(t||{});if(i.length<2)return n?ir(e,n):"";const s=r=>r<.01?"< 1":_e(100*r,0);return i.map(([r,o])=>`${ir(e,r)} ${s(o)} %`).join(" · ")}function EA(n,t,e){const i=o=>`<td>${Ji(o??"")}</td>`,s=sr(String(n.reason??"").replaceAll("_"," ")),r=n.report?`title="${Ji(Yt(N.runs_report,{name:n.name}))}"`:`disabled title="${N.runs_no_report}"`;return`<tr>${i(yA(n.ended))}${i(n.name)}${i(n.scenario)}${i(bA(n,e))}
    ${i(n.operator)}${i(n.seed)}<td class="num">${_e(n.duration_s,1)} s</td>
    <td class="${n.success===!0?"ok":""}">${n.success===!0?"✓":"✗"} ${Ji(s)}</td>
    <td class="acts"><button data-run="${Ji(n.name)}" data-row="${t}" title="${Ji(Yt(N.runs_open,{name:n.name}))}">${N.review_open}</button>
    <button data-report="${Ji(n.name)}" ${r}>${N.review_report}</button></td></tr>`}const Qt=n=>document.getElementById(n),qa=[.25,.5,1,2,4,8,16],Wp=4,TA=5,AA=new Set(["KeyM","KeyP","KeyT"]);class RA{constructor(t,e,i,s,r=()=>""){Object.assign(this,{link:t,panels:e,store:i,back:s,warning:r,on:!1,run:null,at:0,playing:!1,speed:Wp,film:null});const o={"review-close":()=>this.leave(),"review-play":()=>this.play(!this.playing),"review-step-back":()=>this.step(-1),"review-step-on":()=>this.step(1),"review-event-back":()=>this.jump(-1),"review-event-on":()=>this.jump(1),"review-report":()=>this.report(this.run.name,Qt("review-now")),"review-png":()=>this.saveFigure(),"review-csv":()=>Xc(`${this.file()}.csv`,fA(this.run),"text/csv"),"review-webm":()=>this.record()};for(const[a,l]of Object.entries(o))Qt(a).onclick=l;for(const a of["report","png","csv","webm"])Qt(`review-${a}`).title=N[`review_${a}_hint`];Qt("review-webm").disabled=!jr.possible,jr.possible||(Qt("review-webm").title=N.review_webm_none),Qt("review-time").oninput=()=>this.seek(Number(Qt("review-time").value)),Qt("review-speed").replaceChildren(...qa.map(a=>new Option(Yt(N.review_times,{n:a}),a))),Qt("review-speed").value=Wp,Qt("review-speed").onchange=()=>{this.setSpeed(Number(Qt("review-speed").value)),Qt("review-time").focus()},Qt("review-events").onchange=()=>{this.toEvent(this.run.events[Number(Qt("review-events").value)]),Qt("review-events").value="",Qt("review-time").focus()},addEventListener("keydown",a=>this.key(a),!0)}list(){SA(this)}async open(t,e){e.textContent=N.review_loading;try{this.run=await this.link.get(`api/runs/${$p(t.name)}`)}catch(i){e.textContent=i.message;return}this.row=t,$o(),this.on&&this.end(),this.start()}async report(t,e){const i=window.open("","_blank");if(!i){e.textContent=N.review_no_tab;return}i.opener=null;try{const{url:s}=await this.link.get(`api/reports/${$p(t)}`);i.location.replace(new URL(s,location.href))}catch(s){i.close(),e.textContent=s.message}}start(){const{run:t}=this;this.on=!0,this.history=new ah(t.display,1/0);for(const e of t.frames)this.history.add(e);this.rungs=t.ladder.map(mm),this.shownRungs={k:-1,rungs:[]},Qt("scrubber").hidden=!1,Qt("bottom").hidden=!0,document.body.classList.add("reviewing"),document.body.classList.remove("stale"),Qt("review-time").max=String(t.frames.length-1),this.panels.setDisplay(t.display),t.display.camera&&(Qt("camera-tag").textContent=t.display.camera.review_title),Qt("run-name").textContent=[Yt(N.review_of,{name:t.name}),...this.facts()].join(" · "),Qt("run-name").title=Qt("run-name").textContent,this.marks(),this.play(!1),this.go(t.frames.length-1),Qt("review-time").focus()}facts(){const{run:t}=this;return[t.display.modes.length?Yt(N.review_flown,{mode:ir(t.display,t.mode)}):"",t.display.link?`${t.forward_s} s + ${t.back_s} s`:"",Yt(N.review_seed,{n:t.seed})].filter(Boolean)}end(){this.film?.stop(),this.on=!1,this.playing=!1}leave(){this.end(),Qt("scrubber").hidden=!0,Qt("bottom").hidden=!1,document.body.classList.remove("reviewing"),Qt("run-name").textContent="",Qt("run-name").title="",Qt("camera-tag").textContent=this.run.display.camera?.title||"",Ke(""),this.panels.blank(),this.back(),document.activeElement?.blur()}key(t){if(!this.on||Qt("dialog").open||t.ctrlKey||t.metaKey||t.altKey||t.code!=="Escape"&&vh(t.target))return;if(t.code==="Space"&&t.target instanceof HTMLButtonElement){t.stopImmediatePropagation();return}const e={Escape:()=>this.leave(),Space:()=>t.repeat||this.play(!this.playing),ArrowLeft:()=>t.shiftKey?this.jump(-1):this.step(-1),ArrowRight:()=>t.shiftKey?this.jump(1):this.step(1),ArrowUp:()=>this.faster(1),ArrowDown:()=>this.faster(-1),Home:()=>this.seek(0),End:()=>this.seek(this.run.frames.length-1)}[t.code];!e&&!AA.has(t.code)||(t.preventDefault(),t.stopImmediatePropagation(),e?.())}play(t){this.playing=t,Qt("review-play").textContent=t?N.stop_play:N.play,t&&this.at>=this.run.frames.length-1&&this.go(0),this.rebase()}rebase(){this.playedAt=performance.now(),this.playedFrom=this.run.frames[this.at].t,this.filmed=0}setSpeed(t){this.speed=t,Qt("review-speed").value=String(t),this.on&&this.rebase()}faster(t){this.setSpeed(qa[Math.max(0,Math.min(qa.length-1,qa.indexOf(this.speed)+t))])}step(t){this.play(!1),this.go(this.at+t)}jump(t){const e=this.stops.filter(i=>t>0?i>this.at:i<this.at);e.length&&(this.play(!1),this.go(t>0?Math.min(...e):Math.max(...e)))}toEvent(t){t&&(this.play(!1),this.go(this.pictureOf(t)))}pictureOf({t}){const e=this.run.frames.findIndex(i=>i.t>=t-1e-9);return e<0?this.run.frames.length-1:e}go(t){this.at=Math.max(0,Math.min(this.run.frames.length-1,t)),Qt("review-time").value=String(this.at);const e=this.run.frames[this.at].t,i=this.run.events.findLast(r=>r.t<=e),s=`${_e(e,1)} s${i&&e-i.t<TA?` · ${this.eventWords(i)}`:""}`;Qt("review-now").textContent=s,Qt("review-now").title=s,Qt("review-time").setAttribute("aria-valuetext",s)}seek(t){this.go(t),this.rebase()}eventWords({code:t,text:e}){return this.run.operator==="console"&&N.stick_events[t]||e}advance(){this.playing&&!this.film&&this.playTo(performance.now()-this.playedAt)}playTo(t){const e=this.playedFrom+this.speed*t/1e3;let i=this.at;for(;i<this.run.frames.length-1&&this.run.frames[i].t<e;)i+=1;i!==this.at&&this.go(i),i>=this.run.frames.length-1&&this.play(!1)}filmOn(t){return this.filmed+=t,this.on&&this.playing&&this.playTo(this.filmed),this.on&&this.playing}marks(){const{events:t,frames:e}=this.run,i=Math.max(e.length-1,1);this.stops=[...new Set(t.map(r=>this.pictureOf(r)))],Qt("review-marks").replaceChildren(...this.stops.map(r=>{const o=document.createElement("i");return o.style.left=`${r/i*100}%`,o}));const s=t.length?Yt(N.review_events_some,{n:t.length}):N.review_events_none;Qt("review-events").disabled=!t.length,Qt("review-events").replaceChildren(new Option(s,""),...t.map((r,o)=>new Option(`${_e(r.t,1)} s · ${this.eventWords(r)}`,o)))}frame(){return this.run.frames[this.at]}show(){this.advance();const{run:t}=this,e=this.frame(),i=Bn(e,t.display.measured),s=this.ladderAt(e.k);this.say(s),am(t.display,e,e.mode,!1),this.panels.clocks(e,e.t,i?Yt(N.age,{s:_e(e.t-i.t,1)}):"","",!1),this.panels.show({run:t,frame:e,history:this.history,now:e.t,stale:!1,until:e.t,rungs:s})}ladderAt(t){if(this.shownRungs.k!==t){const e=this.rungs.findIndex(i=>i.sent>t);this.shownRungs={k:t,rungs:this.rungs.slice(0,e<0?this.rungs.length:e).map(i=>L0(i,t))}}return this.shownRungs.rungs}say(t){const{run:e,row:i}=this;if(this.at===e.frames.length-1){const s=e.verdict?.words??(i?.reason?String(i.reason).replaceAll("_"," "):"");Ke(s&&sr(s),"",!(e.verdict?.success??i?.success))}else if(t.some(_h)){const s=e.display.abort;Ke(s?Yt(N.aborted_so,{does:s}):N.aborted,"",!0)}else Ke("")}file(){return this.run.name.replaceAll(/[^\w.-]+/g,"_")}caption(){return[this.run.name,...this.facts(),Qt("review-now").textContent,Qt("banner").textContent].filter(Boolean).join(" · ")}async saveFigure(){const t=xA(this.panels,this.caption(),()=>{this.show(),this.panels.showReticle(this.frame())}),e=await new Promise(i=>{t.toBlob(i,"image/png")});e&&Xc(`${this.file()}-${_e(this.frame().t,1)}s.png`,e)}record(){if(this.film){this.film.stop();return}this.play(!0),Qt("review-webm").textContent=N.review_webm_stop,this.film=new jr(this.panels,()=>this.caption(),t=>this.filmOn(t),(t,e)=>{this.film=null,Qt("review-webm").textContent=N.review_webm,e?Qt("review-now").textContent=Yt(N.review_failed,{why:e.message}):Xc(`${this.file()}.webm`,t)})}}const $p=n=>n.split("/").map(encodeURIComponent).join("/"),Xp={opening:[N.connecting,""],none:[N.no_token_title,N.no_page_token],stranger:[N.wrong_token,N.wrong_token_text],full:[N.line_full,N.line_again]};class CA{constructor(){this.state="opening",this.heardAt=performance.now(),this.wasOpen=!1}take(t){if(t.type||!t.link){this.heardAt=performance.now();return}this.state=t.link,this.wasOpen||=t.link==="open",t.link==="open"&&(this.heardAt=performance.now()),t.since!==void 0&&this.wasOpen&&(this.heardAt=performance.now()-t.since)}get up(){return this.state==="open"}get dead(){return this.wasOpen&&!this.up}age(){return(performance.now()-this.heardAt)/1e3}words(){if(this.up)return null;if(this.state in Xp)return Xp[this.state];const t=this.age().toFixed(0);return this.state==="silent"?[Yt(N.line_silent,{s:t}),N.line_old]:[Yt(N.line_lost,{s:t}),this.wasOpen?N.line_again_old:N.line_again]}get short(){return N.line[this.state]}}const PA=6e3,LA=.8;class DA{constructor(){this.status={phase:"idle",lease:"free",pages:0,note:""},this.can={fly:!1,desk:!1,steer:!0},this.line=new CA,this.display=null,this.asked="",this.reset(null)}reset(t){this.run=t,this.frame=null,this.frameAt=0,this.verdict=null,this.ladder=new Map,this.events=[],this.abortAt=null,this.display=t?.display??this.display,this.history=new ah(this.display,PA),t&&(this.history.begin(t.trails),this.rungs(t.ladder||[]))}get connected(){return this.line.up}take(t){switch(this.line.take(t),t.type){case"hello":this.can=t.can,this.asked=t.mode||"",t.display&&!this.display&&(this.display=t.display),(!this.run||!t.flown)&&this.reset(null);break;case"run":this.reset(t);break;case"status":this.status=t;break;case"frame":this.takeFrame(t);break;case"ladder":this.rungs(t.ladder);break;case"verdict":this.verdict=t;break;case"event":this.events.push(t);break}}takeFrame(t){if(this.frame=t,this.frameAt=performance.now(),this.rungs(t.ladder),this.history.add(t),this.sent?.parts.kind===Wr&&this.abortAt===null){const e=[...this.ladder.values()].find(i=>i.kind===Wr);this.abortAt=(e?.sent??t.k)*this.run.step_s}}get measured(){return Bn(this.frame,this.display?.measured)}get predicted(){return Bn(this.frame,this.display?.predicted)}get sent(){return this.frame?.signals[this.display.commands.sent]}rungs(t){for(const e of t)this.ladder.set(e[0],mm(e));for(;this.ladder.size>700;)this.ladder.delete(this.ladder.keys().next().value)}get inFlight(){return this.frame!==null&&!this.verdict&&this.status.phase==="flying"}now(){if(!this.frame)return 0;const t=Math.max(this.frame.t,this.measured?.received??0);return this.frame.paused||!this.inFlight?t:t+Math.min(this.sinceFrame(),this.run.step_s)}clock(){const t=this.frame&&this.dead()&&this.inFlight&&!this.frame.paused;return this.now()+(t?Math.max(this.sinceFrame()-this.run.step_s,0):0)}sinceFrame(){return(performance.now()-this.frameAt)/1e3*this.run.pace}silence(){if(!this.inFlight||this.frame.paused)return 0;const t=(performance.now()-this.frameAt)/1e3;return t>LA+this.run.step_s/this.run.pace?t:0}dead(){return this.line.dead||this.silence()>0}}const oe=n=>document.getElementById(n),IA=1e3/30,[UA,NA]=[60,120],Yg=1,ih=2e3,FA=1e3,OA=5e3;for(const n of document.querySelectorAll("[data-s]"))n.textContent=N[n.dataset.s];for(const n of document.querySelectorAll("[data-a]"))n.setAttribute("aria-label",N[n.dataset.a]);const dt=new DA,ci=new jT(oe("gl"),oe("view"),oe("camera"),oe("labels")),as=new nA(ci,n=>jh(n));ci.enabled=!new URLSearchParams(location.search).has("plain");let rl=-1/0,jc=0,qp=0,Yp=null,jp=0,Kp=null;const Tn=new q0((n,t)=>{jg.heard(n),ui?.stick(n,t)},()=>na()),jo=new C0(ui),vo=new W0(ui,dt),tn=new RA(ui,as,dt,()=>{Kg(),s_()},()=>dt.inFlight?N.review_in_flight:""),Zp=new B0(()=>tn.leave()),vl=new g0(dt);F0(ci);const jg=new A0(dt,ci,Tn);function Jp(n){if(n.type==="desk"){jo.show(n,dt.status.lease==="you"),Zg();return}const{phase:t,lease:e}=dt.status;dt.take(n),(n.type==="run"||n.type==="hello")&&!tn.on&&Kg(),n.type==="status"&&(n.phase==="starting"&&t!=="starting"&&($o(),tn.on&&n.lease==="you"&&tn.leave()),n.phase==="refused"&&t!=="refused"&&n.lease==="you"&&xl(n.note),n.phase!==t&&wl()&&tn.list(),n.lease==="you"&&e!=="you"&&Tn.taken(),rh(),jo.lease(n.lease==="you")),n.type==="verdict"&&dt.frame&&Kp!==n&&!tn.on&&!dt.can.desk&&(Kp=n,dm(n,dt.can.fly&&dt.status.lease==="you",()=>xl())),n.type==="event"&&(oe("event").textContent=`${_e(n.t,1)} s · ${kA(n)}`),n.type==="reply"&&!n.ok&&(oe("event").textContent=n.code?Zo(n.code):n.text),n.type||(rh(),i_())}function kA({code:n,text:t}){return dt.run?.operator==="console"&&N.stick_events[n]||t}function na(){return dt.inFlight?lm()||(tn.on?N.review:""):""}function Kg(){const{display:n}=dt;n&&(as.setDisplay(n),Tn.setController(n.controller),jo.task={hint:n.hint,goal:n.goal,display:n},dt.run||as.blank(),Zg())}function Zg(){const{run:n,display:t}=dt,e=dt.can.desk?jo.title():n?.name||"";oe("run-name").textContent=n&&t.link?`${e} · ${n.forward_s} s + ${n.back_s} s`:e,oe("run-name").title=oe("run-name").textContent}async function Jg(){await ui.ask({do:dt.status.lease==="you"?"drop":"take"})}function jh(n){dt.frame&&vo.steer({do:"mode",mode:n})}function Qg(){dt.frame&&vo.steer({do:dt.frame.paused?"resume":"pause"})}function t_(){if(!dt.can.steer)return;const n=performance.now();n-rl<ih?(rl=-1/0,vo.abort()):rl=n,sh(),setTimeout(sh,ih+50)}function sh(){const n=performance.now()-rl<ih;oe("abort").classList.toggle("armed",n),oe("abort").disabled=!dt.can.steer,oe("abort").querySelector("small").textContent=dt.can.steer?n?N.abort_armed:N.abort_hint:N.abort_watch}const e_=()=>vo.steer({do:"stop"});function xl(n=""){if(!dt.can.steer){Sl(N.new_run,Zo("WATCH"));return}if(dt.can.desk){jo.reopen();return}dt.status.lease!=="you"&&ui.ask({do:"take"}),hm(dt,t=>ui.ask(t,OA),n,dt.status.phase==="flying"?e_:null)}function BA(){const n=om(dt.display).map(t=>t.name);n.length&&jh(n[(n.indexOf(dt.frame?.mode)+1)%n.length])}const Qp={KeyT:Jg,KeyP:Qg,KeyX:t_,KeyN:()=>xl(),KeyV:()=>as.nextView(),KeyL:()=>tn.list(),KeyG:()=>_m(Tn,dt.display),Slash:()=>dh(dt.display),KeyM:()=>{tn.on||BA()},KeyK:()=>vl.acknowledge(),KeyO:()=>vl.toggleSound(),Equal:()=>ci.zoom(.85),Minus:()=>ci.zoom(1.18),BracketLeft:()=>ci.turn(.15,0),BracketRight:()=>ci.turn(-.15,0)};addEventListener("keydown",n=>{if(n.repeat||n.ctrlKey||n.metaKey||n.altKey||vh(n.target)||!["KeyX","KeyK","KeyO"].includes(n.code)&&cm(n.code))return;const t=M0(dt.display,n.code);Qp[n.code]&&ui?Qp[n.code]():t&&ui&&!tn.on&&jh(t.name)});oe("lease").onclick=Jg;oe("pause").onclick=Qg;oe("abort").onclick=t_;oe("end-run").onclick=e_;oe("restart").onclick=()=>xl();oe("open-review").onclick=()=>tn.list();oe("open-settings").onclick=()=>_m(Tn,dt.display);oe("open-help").onclick=()=>dh(dt.display);function rh(){const{status:n}=dt,t=n.lease==="you";oe("lease").textContent=dt.can.steer?t?N.drop:n.lease==="other"?N.taken:N.take:N.watch_only,oe("lease").disabled=n.lease==="other"||!dt.can.steer||!dt.connected,oe("lease").classList.toggle("primary",n.lease==="free"&&!oe("lease").disabled),oe("pages").textContent=n.pages===1?N.pages_one:Yt(N.pages,{n:n.pages}),oe("socket-state").textContent=dt.line.short,oe("socket-state").className=dt.connected?"ok":"alarm";for(const e of["pause","restart"])oe(e).disabled=!t||!dt.connected;dt.can.desk&&(oe("pause").disabled=!0,oe("restart").textContent=N.desk.open),sh()}function zA(n){const{status:t,frame:e,run:i,verdict:s}=dt,r=vo.words(),o=dt.line.words();if(r)Ke(...r,!0);else if(o)Ke(...o,dt.line.state!=="opening");else if(t.phase==="idle")Ke(N.idle,dt.can.desk?N.desk.idle:N.idle_text);else if(t.phase==="starting"||t.phase==="flying"&&!e)Ke(N.starting,t.progress||t.run||"");else if(t.phase==="refused")Ke(N.run_refused,t.note,!0);else if(t.note?.startsWith("failed"))Ke(N.run_failed,t.note.slice(7),!0);else if(t.phase==="ended"&&!s&&t.note)Ke(sr(t.note),"");else if(n)Ke(Yt(N.stale_frames,{s:n.toFixed(0)}),"",!0);else if(dt.abortAt!==null&&!s&&e){const a=!dt.display.link||[...dt.ladder.values()].some(_h),l=dt.display.abort,c=e.t-dt.abortAt,u=c>i.forward_s+i.back_s+2*i.step_s+Yg;a?Ke(l?Yt(N.aborted_so,{does:l}):N.aborted,"",!0):u?Ke(N.abort_untold,Yt(N.abort_untold_hint,{s:c.toFixed(0)}),!0):Ke(Yt(N.abort_sent,{s:Math.max(0,i.forward_s-c).toFixed(0)}),"",!0)}else t.pilot_lost?Ke(Go(N.pilot_lost,kl()),"",!0):na()&&t.lease==="you"?Ke(Bl(),n_(),!0):e?.paused?Ke(N.paused,""):e&&!dt.measured&&t.phase==="flying"?Ke(N.no_telemetry,Yt(N.first_in,{s:Math.max(0,i.back_s-e.t).toFixed(0)})):s?Ke(sr(s.words),"",!s.success):Ke("")}function kl(){return dt.inFlight&&!dt.dead()?ch(dt.display,dt.frame):null}function Bl(){return Go(Yt(N.stick_released,{what:na()}),kl())}const n_=()=>dt.abortAt===null?N.stick_back:"";function HA(n,t){if(!Tn.axes.length)return N.stick_none;if(!dt.connected)return N.stick_unheard;const e=kl();return na()?Bl():Tn.gone()?Go(N.stick_gone,e):t.length?Yt(N.stick_stuck,{axes:t.join(", ")}):Go(n?`${N.stick_held} · ${N[Tn.source]}`:document.hasFocus()?N.stick_open:N.stick_away,e)}function GA(){const n=dt.status.lease==="you",t=Tn.state().held,e=Tn.stuck(),i=t&&!e.length&&dt.connected;Oe(oe("stick-state"),n?HA(t,e):N.stick_watch),oe("stick-state").className=n?i?"ok":"alarm":"dim";const s=dt.display?.controller?.step_name;Oe(oe("step"),n&&Tn.source==="keyboard"&&Tn.deflections.length>1?`${s} ${Tn.step}`:"")}function VA(){const n=[ci.webgl?"":N.no_webgl,tm?"":N.no_storage,Tn.axes.length?N.pad_notes[Tn.lacks()]:""];Oe(oe("notes"),n.filter(Boolean).join(" · ")),oe("notes").title=oe("notes").textContent}function WA(n,t){const{run:e,measured:i}=dt,s=i?dt.clock()-i.t:null,r=s!==null&&s>e.back_s+Yg*Math.max(e.pace,1);return as.clocks(n,dt.clock(),s===null?"":Yt(N.age,{s:_e(s,1)}),i?Yt(N.ago,{s:_e(Math.max(dt.clock()-i.received,0),1)}):"",r),r}function $A(){const{frame:n,run:t,history:e}=dt,i=dt.silence();zA(i);const s=na()&&dt.status.lease==="you"?`${Bl()}. ${n_()}`:"";if(um([vl.words(),s].filter(Boolean).join(" · ")),GA(),VA(),oe("end-run").hidden=!(dt.abortAt!==null&&dt.status.phase==="flying"&&dt.status.lease==="you"&&!dt.verdict),Oe(oe("pause"),n?.paused?N.resume:N.pause),am(dt.display,n,n?.mode||t?.mode,dt.status.lease==="you"&&!dt.can.desk),!t&&dt.display&&performance.now()-jp>FA&&(jp=performance.now(),as.blank()),!t||!n)return;const r=dt.now(),o=WA(n)||dt.dead();as.show({run:t,frame:n,history:e,rungs:[...dt.ladder.values()],now:r,stale:o}),dt.dead()&&Oe(oe("why"),N.unknown)}function i_(){document.body.classList.toggle("dead",dt.dead()&&!tn.on)}function s_(){if(!tn.on||!dt.inFlight){Zp.hide();return}const n=kl();Zp.show(dt,[dt.line.words()?.slice(0,1).concat(!0)??[vo.words()?.[0],!0],dt.status.lease==="you"?[Bl(),!0]:[n?lh(n):"",n?.alarm],[dt.frame.paused?N.paused:"",!1],[dt.silence()?Yt(N.stale_frames,{s:dt.silence().toFixed(0)}):"",!0]])}function r_(n){if(requestAnimationFrame(r_),n-jc<IA-2)return;ci.adapt(n-jc),jc=n;const t=n-qp>(dt.frame===Yp&&!tn.on?NA:UA);t&&(qp=n,Yp=dt.frame,i_(),tn.on?tn.show():$A(),s_()),ci.draw(),t&&jg.show(tn.on),t&&as.showReticle(tn.on?tn.frame():dt.frame)}rh();ui?ui.listen(Jp):(Jp({link:"none"}),Sl(N.no_token_title,N.no_page_token));requestAnimationFrame(r_);window.rvd={store:dt,scene:ci,stick:Tn,review:tn,link:ui,panels:as,alarms:vl};
