var cS=Object.create;var dg=Object.defineProperty;var uS=Object.getOwnPropertyDescriptor;var hS=Object.getOwnPropertyNames;var fS=Object.getPrototypeOf,dS=Object.prototype.hasOwnProperty;var pS=(n,e)=>()=>{try{return e||n((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var mS=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of hS(e))!dS.call(n,s)&&s!==t&&dg(n,s,{get:()=>e[s],enumerable:!(i=uS(e,s))||i.enumerable});return n};var gS=(n,e,t)=>(t=n!=null?cS(fS(n)):{},mS(e||!n||!n.__esModule?dg(t,"default",{value:n,enumerable:!0}):t,n));var G_=pS(Hd=>{var D_=Object.defineProperty,Kw=n=>D_(n,"__esModule",{value:!0}),Zw=(n,e)=>{for(var t in e)D_(n,t,{get:e[t],enumerable:!0})};Kw(Hd);Zw(Hd,{GIFEncoder:()=>z_,applyPalette:()=>r1,default:()=>m1,nearestColor:()=>c1,nearestColorIndex:()=>k_,nearestColorIndexWithDistance:()=>B_,prequantize:()=>s1,quantize:()=>n1,snapColorsToPalette:()=>l1});var Jw={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};function N_(n=256){let e=0,t=new Uint8Array(n);return{get buffer(){return t.buffer},reset(){e=0},bytesView(){return t.subarray(0,e)},bytes(){return t.slice(0,e)},writeByte(s){i(e+1),t[e]=s,e++},writeBytes(s,r=0,o=s.length){i(e+o);for(let a=0;a<o;a++)t[e++]=s[a+r]},writeBytesView(s,r=0,o=s.byteLength){i(e+o),t.set(s.subarray(r,r+o),e),e+=o}};function i(s){var r=t.length;if(r>=s)return;var o=1024*1024;s=Math.max(s,r*(r<o?2:1.125)>>>0),r!=0&&(s=Math.max(s,256));let a=t;t=new Uint8Array(s),e>0&&t.set(a.subarray(0,e),0)}}var zd=12,P_=5003,jw=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Qw(n,e,t,i,s=N_(512),r=new Uint8Array(256),o=new Int32Array(P_),a=new Int32Array(P_)){let l=o.length,c=Math.max(2,i);r.fill(0),a.fill(0),o.fill(-1);let u=0,h=0,f=c+1,p=f,_=!1,b=p,g=(1<<b)-1,m=1<<f-1,x=m+1,A=m+2,S=0,P=t[0],C=0;for(let k=l;k<65536;k*=2)++C;C=8-C,s.writeByte(c),E(m);let v=t.length;for(let k=1;k<v;k++)e:{let N=t[k],L=(N<<zd)+P,B=N<<C^P;if(o[B]===L){P=a[B];break e}let V=B===0?1:l-B;for(;o[B]>=0;)if(B-=V,B<0&&(B+=l),o[B]===L){P=a[B];break e}E(P),P=N,A<1<<zd?(a[B]=A++,o[B]=L):(o.fill(-1),A=m+2,_=!0,E(m))}return E(P),E(x),s.writeByte(0),s.bytesView();function E(k){for(u&=jw[h],h>0?u|=k<<h:u=k,h+=b;h>=8;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,h-=8;if((A>g||_)&&(_?(b=p,g=(1<<b)-1,_=!1):(++b,g=b===zd?1<<b:(1<<b)-1)),k==x){for(;h>0;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,h-=8;S>0&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0)}}}var e1=Qw;function U_(n,e,t){return n<<8&63488|e<<2&992|t>>3}function F_(n,e,t,i){return n>>4|e&240|(t&240)<<4|(i&240)<<8}function O_(n,e,t){return n>>4<<8|e&240|t>>4}function Kc(n,e,t){return n<e?e:n>t?t:n}function cl(n){return n*n}function I_(n,e,t){var i=0,s=1e100;let r=n[e],o=r.cnt,a=r.ac,l=r.rc,c=r.gc,u=r.bc;for(var h=r.fw;h!=0;h=n[h].fw){let p=n[h],_=p.cnt,b=o*_/(o+_);if(!(b>=s)){var f=0;t&&(f+=b*cl(p.ac-a),f>=s)||(f+=b*cl(p.rc-l),!(f>=s)&&(f+=b*cl(p.gc-c),!(f>=s)&&(f+=b*cl(p.bc-u),!(f>=s)&&(s=f,i=h))))}}r.err=s,r.nn=i}function Vd(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function t1(n,e){let t=e==="rgb444"?4096:65536,i=new Array(t),s=n.length;if(e==="rgba4444")for(let r=0;r<s;++r){let o=n[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255,h=F_(u,c,l,a),f=h in i?i[h]:i[h]=Vd();f.rc+=u,f.gc+=c,f.bc+=l,f.ac+=a,f.cnt++}else if(e==="rgb444")for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=O_(c,l,a),h=u in i?i[u]:i[u]=Vd();h.rc+=c,h.gc+=l,h.bc+=a,h.cnt++}else for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=U_(c,l,a),h=u in i?i[u]:i[u]=Vd();h.rc+=c,h.gc+=l,h.bc+=a,h.cnt++}return i}function n1(n,e,t={}){let{format:i="rgb565",clearAlpha:s=!0,clearAlphaColor:r=0,clearAlphaThreshold:o=0,oneBitAlpha:a=!1}=t;if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(n.buffer),c=t.useSqrt!==!1,u=i==="rgba4444",h=t1(l,i),f=h.length,p=f-1,_=new Uint32Array(f+1);for(var b=0,m=0;m<f;++m){let H=h[m];if(H!=null){var g=1/H.cnt;u&&(H.ac*=g),H.rc*=g,H.gc*=g,H.bc*=g,h[b++]=H}}cl(e)/b<.022&&(c=!1);for(var m=0;m<b-1;++m)h[m].fw=m+1,h[m+1].bk=m,c&&(h[m].cnt=Math.sqrt(h[m].cnt));c&&(h[m].cnt=Math.sqrt(h[m].cnt));var x,A,S;for(m=0;m<b;++m){I_(h,m,!1);var P=h[m].err;for(A=++_[0];A>1&&(S=A>>1,!(h[x=_[S]].err<=P));A=S)_[A]=x;_[A]=m}var C=b-e;for(m=0;m<C;){for(var v;;){var E=_[1];if(v=h[E],v.tm>=v.mtm&&h[v.nn].mtm<=v.tm)break;v.mtm==p?E=_[1]=_[_[0]--]:(I_(h,E,!1),v.tm=m);var P=h[E].err;for(A=1;(S=A+A)<=_[0]&&(S<_[0]&&h[_[S]].err>h[_[S+1]].err&&S++,!(P<=h[x=_[S]].err));A=S)_[A]=x;_[A]=E}var k=h[v.nn],N=v.cnt,L=k.cnt,g=1/(N+L);u&&(v.ac=g*(N*v.ac+L*k.ac)),v.rc=g*(N*v.rc+L*k.rc),v.gc=g*(N*v.gc+L*k.gc),v.bc=g*(N*v.bc+L*k.bc),v.cnt+=k.cnt,v.mtm=++m,h[k.bk].fw=k.fw,h[k.fw].bk=k.bk,k.mtm=p}let B=[];var V=0;for(m=0;;++V){let U=Kc(Math.round(h[m].rc),0,255),H=Kc(Math.round(h[m].gc),0,255),Y=Kc(Math.round(h[m].bc),0,255),G=255;u&&(G=Kc(Math.round(h[m].ac),0,255),a&&(G=G<=(typeof a=="number"?a:127)?0:255),s&&G<=o&&(U=H=Y=r,G=0));let le=u?[U,H,Y,G]:[U,H,Y];if(i1(B,le)||B.push(le),(m=h[m].fw)==0)break}return B}function i1(n,e){for(let t=0;t<n.length;t++){let i=n[t],s=i[0]===e[0]&&i[1]===e[1]&&i[2]===e[2],r=i.length>=4&&e.length>=4?i[3]===e[3]:!0;if(s&&r)return!0}return!1}function Jc(n,e){var t=0,i;for(i=0;i<n.length;i++){let s=n[i]-e[i];t+=s*s}return t}function Zc(n,e){return e>1?Math.round(n/e)*e:n}function s1(n,{roundRGB:e=5,roundAlpha:t=10,oneBitAlpha:i=null}={}){let s=new Uint32Array(n.buffer);for(let r=0;r<s.length;r++){let o=s[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255;a=Zc(a,t),i&&(a=a<=(typeof i=="number"?i:127)?0:255),u=Zc(u,e),c=Zc(c,e),l=Zc(l,e),s[r]=a<<24|l<<16|c<<8|u<<0}}function r1(n,e,t="rgb565"){if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let i=new Uint32Array(n.buffer),s=i.length,r=t==="rgb444"?4096:65536,o=new Uint8Array(s),a=new Array(r),l=t==="rgba4444";if(t==="rgba4444")for(let c=0;c<s;c++){let u=i[c],h=u>>24&255,f=u>>16&255,p=u>>8&255,_=u&255,b=F_(_,p,f,h),g=b in a?a[b]:a[b]=o1(_,p,f,h,e);o[c]=g}else{let c=t==="rgb444"?O_:U_;for(let u=0;u<s;u++){let h=i[u],f=h>>16&255,p=h>>8&255,_=h&255,b=c(_,p,f),g=b in a?a[b]:a[b]=a1(_,p,f,e);o[u]=g}}return o}function o1(n,e,t,i,s){let r=0,o=1e100;for(let a=0;a<s.length;a++){let l=s[a],c=l[3],u=$r(c-i);if(u>o)continue;let h=l[0];if(u+=$r(h-n),u>o)continue;let f=l[1];if(u+=$r(f-e),u>o)continue;let p=l[2];u+=$r(p-t),!(u>o)&&(o=u,r=a)}return r}function a1(n,e,t,i){let s=0,r=1e100;for(let o=0;o<i.length;o++){let a=i[o],l=a[0],c=$r(l-n);if(c>r)continue;let u=a[1];if(c+=$r(u-e),c>r)continue;let h=a[2];c+=$r(h-t),!(c>r)&&(r=c,s=o)}return s}function l1(n,e,t=5){if(!n.length||!e.length)return;let i=n.map(o=>o.slice(0,3)),s=t*t,r=n[0].length;for(let o=0;o<e.length;o++){let a=e[o];a.length<r?a=[a[0],a[1],a[2],255]:a.length>r?a=a.slice(0,3):a=a.slice();let l=B_(i,a.slice(0,3),Jc),c=l[0],u=l[1];u>0&&u<=s&&(n[c]=a)}}function $r(n){return n*n}function k_(n,e,t=Jc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return s}function B_(n,e,t=Jc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return[s,i]}function c1(n,e,t=Jc){return n[k_(n,e,t)]}function z_(n={}){let{initialCapacity:e=4096,auto:t=!0}=n,i=N_(e),s=5003,r=new Uint8Array(256),o=new Int32Array(s),a=new Int32Array(s),l=!1;return{reset(){i.reset(),l=!1},finish(){i.writeByte(Jw.trailer)},bytes(){return i.bytes()},bytesView(){return i.bytesView()},get buffer(){return i.buffer},get stream(){return i},writeHeader:c,writeFrame(u,h,f,p={}){let{transparent:_=!1,transparentIndex:b=0,delay:g=0,palette:m=null,repeat:x=0,colorDepth:A=8,dispose:S=-1}=p,P=!1;if(t?l||(P=!0,c(),l=!0):P=!!p.first,h=Math.max(0,Math.floor(h)),f=Math.max(0,Math.floor(f)),P){if(!m)throw new Error("First frame must include a { palette } option");h1(i,h,f,m,A),L_(i,m),x>=0&&f1(i,x)}let C=Math.round(g/10);u1(i,S,C,_,b);let v=!!m&&!P;d1(i,h,f,v?m:null),v&&L_(i,m),p1(i,u,h,f,A,r,o,a)}};function c(){V_(i,"GIF89a")}}function u1(n,e,t,i,s){n.writeByte(33),n.writeByte(249),n.writeByte(4),s<0&&(s=0,i=!1);var r,o;i?(r=1,o=2):(r=0,o=0),e>=0&&(o=e&7),o<<=2,n.writeByte(0|o|0|r),dr(n,t),n.writeByte(s||0),n.writeByte(0)}function h1(n,e,t,i,s=8){let a=Gd(i.length)-1,l=128|s-1<<4|0|a,c=0,u=0;dr(n,e),dr(n,t),n.writeBytes([l,c,u])}function f1(n,e){n.writeByte(33),n.writeByte(255),n.writeByte(11),V_(n,"NETSCAPE2.0"),n.writeByte(3),n.writeByte(1),dr(n,e),n.writeByte(0)}function L_(n,e){let t=1<<Gd(e.length);for(let i=0;i<t;i++){let s=[0,0,0];i<e.length&&(s=e[i]),n.writeByte(s[0]),n.writeByte(s[1]),n.writeByte(s[2])}}function d1(n,e,t,i){if(n.writeByte(44),dr(n,0),dr(n,0),dr(n,e),dr(n,t),i){let o=Gd(i.length)-1;n.writeByte(128|o)}else n.writeByte(0)}function p1(n,e,t,i,s=8,r,o,a){e1(t,i,e,s,n,r,o,a)}function dr(n,e){n.writeByte(e&255),n.writeByte(e>>8&255)}function V_(n,e){for(var t=0;t<e.length;t++)n.writeByte(e.charCodeAt(t))}function Gd(n){return Math.max(Math.ceil(Math.log2(n)),1)}var m1=z_});var Mt,gg,Xf,sr,Wf,dc,_g,hc,vg,$f,qf,_S,qa=Symbol.for("pv"),pc={},mc=[],vS=/^m(i|n|o|s|text|space)$/,Yf=Array.isArray,Kf=mc.slice,Br=Object.assign;function kr(n){n&&n.parentNode&&n.remove()}function yg(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Kf.call(arguments,2):t),Wa(n,o,i,s,null)}function Wa(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:qa,__v:s||++gg,__i:-1,__u:0};return!s&&Mt.vnode&&Mt.vnode(r),r}function wt(n){return n.children}function Ao(n,e){this.props=n,this.context=e,this.__g=0}function rr(n,e){if(e==null)return n.__&&rr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:rr(n)}function yS(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Br({constructor:qa},t)).__v=t.__v+1,Mt.vnode&&Mt.vnode(e),Zf(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||rr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Tg(s,e,r),t.__=t.__e=null,e.__e!=i&&xg(e))}function xg(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),xg(n)}function pg(n){(8&n.__g||(n.__g|=8,sr.push(n),dc++))&&Wf==Mt.debounceRendering||((Wf=Mt.debounceRendering)||queueMicrotask)(bg)}function bg(){try{for(var n,e=1;sr.length;)sr.length>e&&sr.sort(_g),n=sr.shift(),e=sr.length,8&n.__g&&yS(n)}finally{(dc=sr.length)&&(Wf||queueMicrotask)(bg)}}function Sg(n,e,t,i,s,r,o,a,l,c,u){var h,f,p,_,b,g,m=i.__k||mc,x=e.length;for(l=xS(t,e,m,l,x),h=0;h<x;h++)(p=t.__k[h])!=null&&(f=~p.__i&&m[p.__i]||pc,p.__i=h,g=Zf(n,p,f,s,r,o,a,l,c,u),_=p.__e,(f.ref!=p.ref||8&f.__u)&&(f.ref&&Jf(f.ref,null,p,f),p.ref&&u.push(p.ref,p.__c||_,p)),b=b||_,4&p.__u?(l=Mg(p,l,n,!f.__v),f.__e&&(f.__e=null)):typeof p.type=="function"&&g!==void 0?l=g:_&&(l=_.nextSibling),p.__u&=-21);return t.__e=b,l}function xS(n,e,t,i,s){var r,o,a,l,c,u,h,f,p,_=t.length,b=_,g=0,m=0,x=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=x[r]=Wa(null,o):Yf(o)?o=x[r]=Wa(wt,{children:o}):o.constructor===qa&&o.__b?o=x[r]=Wa(o.type,o.props,o.key,o.ref,o.__v):x[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=bS(o,t,l,b))&&(b--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,m=1)):(~c||(s>_?g--:s<_&&g++),typeof o.type!="function"&&(o.__u|=4))):x[r]=null;if(m){for(u=[],h=[],r=0;r<s;r++)if((o=x[r])&&16&o.__u){for(g=0,f=u.length;g<f;)u[p=g+f>>1]<o.__i?g=p+1:f=p;u[g]=o.__i,h[r]=g+1}for(g=u.length;r--;)h[r]&&(h[r]==g?g--:x[r].__u|=4)}if(b)for(r=0;r<_;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=rr(a)),jf(a,a));return i}function Mg(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Mg(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=rr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function bS(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function mg(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function uc(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||mg(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||mg(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=qf[e]||(qf[e]=SS(e)),(n.__a||(n.__a={}))[e]=$f,r=e!=(e=e.replace(vg,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function SS(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[hc]==null)e[hc]=$f++;else if(e[hc]<this.__a[n])return;return t(Mt.event?Mt.event(e):e)}}}function Zf(n,e,t,i,s,r,o,a,l,c){var u,h,f,p,_,b,g,m,x,A,S,P,C,v,E,k,N,L,B=e.type;if(e.constructor!==qa)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=fc(u,r):r.push(u),a=r[0]||a),(u=Mt.__b)&&u(e);e:if(typeof B=="function"){f=o.length;try{if(m=e.props,x=(u=B.prototype)&&u.render,A=(u=B.contextType)&&i[u.__c],S=u?A?A.props.value:u.__:i,(p=t.__c)?(e.__c=p,2&p.__g&&(p.__g|=1)):(x?e.__c=p=new B(m,S):(e.__c=p=new Ao(m,S),p.constructor=B,p.render=wS),A&&A.sub(p),p.state||(p.state={}),p.__n=i,p.__g|=8,p.__h=[],p.__k=[]),x&&(p.__s||(p.__s=p.state),B.getDerivedStateFromProps&&(p.__s==p.state&&(p.__s=Br({},p.__s)),Br(p.__s,B.getDerivedStateFromProps(m,p.__s)))),_=p.props,b=p.state,p.__v=e,t.__c){if(m!==_&&x&&!B.getDerivedStateFromProps&&p.componentWillReceiveProps&&p.componentWillReceiveProps(m,S),e.__v==t.__v&&!(8&p.__g)||!(4&p.__g)&&p.shouldComponentUpdate&&p.shouldComponentUpdate(m,p.__s,S)===!1){e.__v!=t.__v&&(p.props=m,p.state=p.__s,p.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),mc.push.apply(p.__h,p.__k),p.__k=[],p.__h.length&&o.push(p),a=rr(t);break e}p.componentWillUpdate&&p.componentWillUpdate(m,p.__s,S),x&&p.componentDidUpdate&&p.__h.push(function(){p.componentDidUpdate(_,b,g)})}else x&&!B.getDerivedStateFromProps&&p.componentWillMount&&p.componentWillMount(),x&&p.componentDidMount&&p.__h.push(p.componentDidMount);p.context=S,p.props=m,p.__P=n,p.__g&=-5,P=Mt.__r,C=x?25:0;do p.__g&=-9,P&&P(e),u=p.render(p.props,p.state=p.__s,p.context);while(8&p.__g&&++C<25);x&&(mc.push.apply(p.__h,p.__k),p.__k=[]),p.state=p.__s,p.getChildContext&&(i=Br({},i,p.getChildContext())),x&&t.__c&&p.getSnapshotBeforeUpdate&&(g=p.getSnapshotBeforeUpdate(_,b)),v=u&&u.type===wt&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&jf(V,V)}),t.__k=null),a=t.__k?rr(t,0):null),a=Sg(n,Yf(v)?v:[v],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(kr),p.__h.length&&o.push(p),1&p.__g&&(p.__g&=-4)}catch(V){if(o.length=f,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(N=r.indexOf(a||void 0))||(N=r.length);(L=r[N-1])&&L.nodeType==8;)N--;for(;N<r.length;N++)if(L=r[N])if(r[N]=null,E){if(L==k)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(k=fc(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=fc(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(kr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||wg(e),Mt.__e(V,e,t)}}else a=e.__e=MS(t.__e,e,t,i,s,r,o,l,c,n);return(u=Mt.diffed)&&u(e),a}function fc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function wg(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(wg))}function Tg(n,e,t){for(var i=0;i<t.length;)Jf(t[i++],t[i++],t[i++]);Mt.__c&&Mt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Mt.__e(r,s.__v)}})}function MS(n,e,t,i,s,r,o,a,l,c){var u,h,f,p,_,b,g,m,x=t.props||pc,A=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((_=r[u])&&(S?_.localName==S:_.nodeType==3)){n=_,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!S)return m.createTextNode(A);n=m.createElementNS(s,S,A.is?A:c),a&&(Mt.__m&&Mt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&A.defaultValue!=null?null:r&&Kf.call(c.childNodes),!a&&r)for(x={},u=0;u<n.attributes.length;u++)x[(_=n.attributes[u]).name]=_.value;for(u in x)_=x[u],u=="dangerouslySetInnerHTML"?f=_:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||uc(n,u,null,_,s);for(u in A)_=A[u],u=="children"?p=_:u=="dangerouslySetInnerHTML"?h=_:u=="value"?b=_:u=="checked"?g=_:a&&typeof _!="function"||x[u]===_||uc(n,u,_,x[u],s);h?(a||f&&(h.__html==f.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(f&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&vS.test(S))&&(s="http://www.w3.org/1999/xhtml"),Sg(c,Yf(p)?p:[p],e,t,i,s,r,o,r?r[0]:t.__k&&rr(t,0),a,l),r&&r.some(kr)),a&&S!="textarea"||(u="value",S=="progress"&&b==null?n.removeAttribute(u):b==null||b===n[u]&&(S!="progress"||b)||uc(n,u,b,x[u],s),u="checked",g!=null&&g!=n[u]&&uc(n,u,g,x[u],s))}else x===A||a&&n.data==A||(n.data=A);return n}function Jf(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Mt.__e(s,t)}}function jf(n,e,t){var i,s,r,o;if(Mt.unmount&&Mt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Jf(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Mt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&jf(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=fc(i,r=[]))&&(i==n.__e&&r.some(kr),kr(s),kr(i)),t||kr(n.__e),n.__e=n.__c=n.__=null}function wS(n,e,t){return this.constructor(n,t)}function Xa(n,e){var t,i,s,r;Mt.__&&Mt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Wa(wt,{children:[n]}),s=[],r=[],Zf(e,e.__k,i||pc,pc,e.namespaceURI,i?null:e.firstChild?Kf.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Tg(s,e.__k,r),e.__k.props.children=null}Mt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw dc=0,n}},gg=0,Xf=function(n){return n!=null&&n.constructor===qa},Ao.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Br({},this.state)),typeof n=="function"&&(n=n(Br({},t),this.props)),n&&(Br(t,n),this.__v&&(e&&this.__k.push(e),pg(this)))},Ao.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),pg(this))},Ao.prototype.render=wt,sr=[],dc=0,_g=function(n,e){return n.__v.__b-e.__v.__b},hc=Symbol(),vg=/(PointerCapture)$|Capture$/i,$f=0,qf={},_S=0;var Ya,An,Qf,Eg,ed=Object.is,gc=0,Ug=[],td=[],Sn=Mt,Ag=Sn.__b,Cg=Sn.__r,Rg=Sn.diffed,Pg=Sn.__c,Ig=Sn.unmount,Lg=Sn.__;function id(n,e){Sn.__h&&Sn.__h(An,n,gc||e),gc=0;var t=An.__H||(An.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Ft(n){return gc=1,TS(Og,n)}function TS(n,e,t){var i=id(Ya++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Og(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);ed(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=An,!An.__f)){An.__f=!0;var s=An.shouldComponentUpdate;An.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(f){f.__N&&(c=!0,ed(f.__[0],f.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function Bt(n,e){var t=id(Ya++,3);!Sn.__s&&Fg(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,An.__H.__h.push(t))}function Et(n){return gc=5,$n(function(){return{current:n}},[])}function $n(n,e){var t=id(Ya++,7);return Fg(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function ES(){var n;do{for(;n=td.shift();)try{$a(n)}catch(t){Sn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Ug.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some($a),e.__h.some(nd),e.__h=[]}catch(t){e.__h=[],Sn.__e(t,n.__v)}}}while(td.length)}Sn.__b=function(n){An=null,Ag&&Ag(n)},Sn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Lg&&Lg(n,e)},Sn.__r=function(n){Cg&&Cg(n),Ya=0;var e=(An=n.__c).__H;e&&(Qf==An?An.__h=[]:(e.__h.some($a),e.__h.some(nd),Ya=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Qf=An},Sn.diffed=function(n){Rg&&Rg(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Ng(Ug.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Qf=An=null},Sn.__c=function(n,e){e.some(function(t){try{t.__h.some($a),t.__h=t.__h.filter(function(i){return!i.__||nd(i)})}catch(i){t.__h=[function(){throw i}]}}),Pg&&Pg(n,e)},Sn.unmount=function(n){Ig&&Ig(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Ng(td.push(s))}else $a(s)}catch(r){e=r}}),i.__H=void 0,e&&Sn.__e(e,i.__v))};var Dg=typeof requestAnimationFrame=="function";function AS(n){var e,t=function(){clearTimeout(i),Dg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Dg&&(e=requestAnimationFrame(t))}function Ng(n){n!=1&&Eg==Sn.requestAnimationFrame||((Eg=Sn.requestAnimationFrame)||AS)(ES)}function $a(n){var e=An,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),An=e}function nd(n){var e=An;n.__c=n.__(),An=e}function Fg(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!ed(t,n[i])})}function Og(n,e){return typeof e=="function"?e(n):e}var CS=Symbol.for("preact-signals");function xc(){if(Ls>1)Ls--;else{var n,e=!1;for((function(){var s=vc;for(vc=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();Za!==void 0;){var t=Za;for(Za=void 0,_c++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&Bg(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(_c=0,Ls--,e)throw n}}function bc(n){if(Ls>0)return n();sd=++RS,Ls++;try{return n()}finally{xc()}}var Ka,en=void 0;function Ja(n){var e=en,t=Ka;en=void 0,Ka=void 0;try{return n()}finally{en=e,Ka=t}}var Za=void 0,Ls=0,_c=0,RS=0,sd=0,vc=void 0,yc=0;function kg(n){if(en!==void 0){var e=n.n;if(e===void 0||e.t!==en)return e={i:0,S:n,p:en.s,n:void 0,t:en,e:void 0,x:void 0,r:e},en.s!==void 0&&(en.s.n=e),en.s=e,n.n=e,32&en.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=en.s,e.n=void 0,en.s.n=e,en.s=e),e}}function Cn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Cn.prototype.brand=CS;Cn.prototype.h=function(){return!0};Cn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:Ja(function(){var i;(i=e.W)==null||i.call(e)}))};Cn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&Ja(function(){var s;(s=e.Z)==null||s.call(e)}))}};Cn.prototype.subscribe=function(n){var e=this;return lt(function(){var t=e.value;Ja(function(){return n(t)})},{name:"sub"})};Cn.prototype.valueOf=function(){return this.value};Cn.prototype.toString=function(){return this.value+""};Cn.prototype.toJSON=function(){return this.value};Cn.prototype.peek=function(){var n=this;return Ja(function(){return n.value})};Object.defineProperty(Cn.prototype,"value",{get:function(){var n=kg(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(_c>100)throw new Error("Cycle detected");(function(t){Ls!==0&&_c===0&&t.l!==sd&&(t.l=sd,vc={S:t,v:t.v,i:t.i,o:vc})})(this),this.v=n,this.i++,yc++,Ls++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{xc()}}}});function De(n,e){return new Cn(n,e)}function Bg(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function zg(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function Vg(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function zr(n,e){Cn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=yc-1,this.f=4}zr.prototype=new Cn;zr.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===yc))return!0;if(this.g=yc,this.f|=1,this.i>0&&!Bg(this))return this.f&=-2,!0;var n=en;try{zg(this),en=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return en=n,Vg(this),this.f&=-2,!0};zr.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Cn.prototype.S.call(this,n)};zr.prototype.U=function(n){if(this.t!==void 0&&(Cn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};zr.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(zr.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=kg(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function Wt(n,e){return new zr(n,e)}function Gg(n){var e=n.j;if(n.j=void 0,typeof e=="function"){Ls++;var t=en;en=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,rd(n),i}finally{en=t,xc()}}}function rd(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,Gg(n)}function PS(n){if(en!==this)throw new Error("Out-of-order effect");Vg(this),en=n,this.f&=-2;try{8&this.f&&rd(this)}finally{xc()}}function Co(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,Ka&&Ka.push(this)}Co.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Co.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,Gg(this),zg(this),Ls++;var n=en;return en=this,PS.bind(this,n)};Co.prototype.N=function(){2&this.f||(this.f|=2,this.u=Za,Za=this)};Co.prototype.d=function(){this.f|=8,1&this.f||rd(this)};Co.prototype.dispose=function(){this.d()};function lt(n,e){var t=new Co(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var od,Qa,Sc,IS=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,Hg=[],Wg=[];lt(function(){od=this.N})();function Ro(n,e){Mt[n]=e.bind(null,Mt[n]||function(){})}function ja(n){if(Sc){var e=Sc;Sc=void 0,e()}Sc=n&&n.S()}function qg(n){var e=this,t=n.data,i=DS(t);i.name="ReactiveDom",i.value=t;var s=$n(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=Wt(function(){var p=i.value.value;return p===0?0:p===!0?"":p||""}),u=Wt(function(){return!Array.isArray(c.value)&&!Xf(c.value)}),h=lt(function(){if(this.N=Xg,u.value){var p=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=p)}}),f=e.__$u.d;return e.__$u.d=function(){h(),f.call(this)},[u,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}qg.displayName="ReactiveTextNode";Object.defineProperties(Cn.prototype,{constructor:{configurable:!0,value:yg(wt,null).constructor},type:{configurable:!0,value:qg},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});Ro("__b",function(n,e){if(ja(),Qa=void 0,typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Cn&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});Ro("__r",function(n,e){if(n(e),e.type!==wt){ja();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return lt(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;IS&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),Qa=i,ja(t)}});Ro("__e",function(n,e,t,i){ja(),Qa=void 0,n(e,t,i)});Ro("diffed",function(n,e){ja(),Qa=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=LS(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function LS(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=De(t);return{o:function(o,a){r.value=o,i=a},d:lt(function(){this.N=Xg;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}Ro("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});Ro("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});Ao.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function DS(n,e){return $n(function(){return De(n,e)},[])}var NS=typeof requestAnimationFrame>"u"?setTimeout:function(n){var e=function(){clearTimeout(t),cancelAnimationFrame(i),n()},t=setTimeout(e,35),i=requestAnimationFrame(e)},US=function(n){queueMicrotask(function(){queueMicrotask(n)})};function FS(){bc(function(){for(var n;n=Hg.shift();)od.call(n)})}function OS(){Hg.push(this)===1&&(Mt.requestAnimationFrame||NS)(FS)}function kS(){bc(function(){for(var n;n=Wg.shift();)od.call(n)})}function Xg(){Wg.push(this)===1&&(Mt.requestAnimationFrame||US)(kS)}function $g(n,e){var t=Et(n);t.current=n;var i=Qa;Bt(function(){return lt(function(){if(this.N=OS,!(i&&8&i.__$f))return t.current()},e)},[])}var Po=De([]);function el(n,e){let t={title:n,keys:e};return Po.value=[...Po.peek(),t],()=>Po.value=Po.peek().filter(i=>i!==t)}var BS="input, textarea, select",zS="button, summary, a";function or(n,e){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return;let t=n.target;if(t.closest(BS)!==null||n.key===" "&&t.closest(zS)!==null)return;let i=e.map(s=>s.actions[n.key]).find(s=>s!==void 0);i!==void 0&&(n.preventDefault(),i(n))}var Yg=8,VS={"<f8":Float64Array,"<f4":Float32Array,"<i4":Int32Array,"<i2":Int16Array,"|i1":Int8Array},Mc=class n{constructor(e,t,i){this.header=e;this.content=t;this.front=i}header;content;front;static read(e){let t=new DataView(e).getUint32(0,!0),i=new TextDecoder().decode(new Uint8Array(e,4,t)),s=Math.ceil((4+t)/Yg)*Yg;return new n(JSON.parse(i),e,s)}has(e){return e in this.header.variables}values(e){let{type:t,start:i,shape:s}=this.described(e);if(t===void 0||i===void 0)throw new Error(`${e} has no numbers`);let r=s.reduce((o,a)=>o*a,1);return new VS[t](this.content,this.front+i,r)}scale(e){return this.described(e).scale??1}texts(e){return this.described(e).texts??[]}shape(e){return this.described(e).shape}unit(e){return this.described(e).attrs.units??""}title(e){return this.described(e).attrs.long_name??e}parsed(e){return JSON.parse(String(this.header.attrs[e]))}described(e){let t=this.header.variables[e];if(t===void 0)throw new Error(`the dataset has no variable ${e}`);return t}};var GS=Symbol.for("pv"),HS=0;function d(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:GS,__v:--HS,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Mt.vnode&&Mt.vnode(c),c}function wc({title:n,units:e,unit:t}){return d("label",{children:[n," ",d("select",{value:t.value.name,onChange:({currentTarget:i})=>t.value=e[i.selectedIndex]??t.value,children:e.map(({name:i})=>d("option",{children:i}))})]})}function Tc({playing:n}){return d("button",{type:"button",onClick:()=>n.value=!n.value,children:n.value?"Stop":"Move"})}function Ec({pace:n}){return d("label",{children:["pace, cycles per second: ",n.value.toFixed(1),d("input",{type:"range",min:"0.1",max:"3",step:"0.1",value:n.value,onInput:e=>n.value=Number(e.currentTarget.value)})]})}var tl=n=>String(n.header.attrs.origin??"simulated");function Io({name:n,data:e,keys:t,foot:i,children:s}){Bt(()=>el(e.header.title,t),[e,t]);let r=e.header.extra.summary??[];return d("div",{class:n,onKeyDown:o=>or(o,t),children:[d("header",{children:[d("h1",{children:e.header.title}),d("p",{class:"origin",children:tl(e)}),r.map(o=>d("p",{children:o}))]}),s,d("footer",{children:d("p",{children:["haptonic ",String(e.header.attrs.haptonic_version??""),". ",i]})})]})}function Lo(n){return[{keys:"t",effect:"tables",actions:{t:()=>ad(n,"table")}},{keys:"?",effect:"this list",actions:{"?":()=>ad(n,"keys")}}]}function ad(n,e){n.value=n.value===e?"none":e}function Do({listing:n,keys:e,children:t}){let i=Et(null);return $g(()=>{n.value!=="none"&&i.current?.focus()}),d("section",{"aria-label":"Tables and keys",children:[d("p",{class:"opened",children:[["table","Tables"],["keys","Keys"]].map(([r,o])=>d("button",{type:"button","aria-expanded":n.value===r,onClick:()=>ad(n,r),children:o}))}),d("div",{ref:i,tabIndex:-1,children:[n.value==="table"&&t,n.value==="keys"&&d(ld,{title:"Keys",keys:e})]})]})}function ld({title:n,keys:e}){return d("table",{children:[d("caption",{children:n}),d("tbody",{children:e.map(({keys:t,effect:i})=>d("tr",{children:[d("th",{scope:"row",children:d("kbd",{children:t})}),d("td",{children:i})]}))})]})}function ar(n,e){if(!(Number.isFinite(e)&&e>0))return n.toFixed(3);e=Math.max(e,10**-6);let t=Math.floor(Math.log10(e)+1e-9);e<2*10**t&&(t-=1);let i=Math.ceil(e/10**t-1e-9);i===10&&([i,t]=[1,t+1]);let s=Math.min(Math.max(-t,0),6);return`${n.toFixed(s)} ± ${(i*10**t).toFixed(s)}`}var Kg=[{name:"Hz",factor:1},{name:"kHz",factor:1e3},{name:"MHz",factor:1e6}],WS=1e4;function Ac(n){let{pitch_m:e,shear_speed_m_per_s:t}=n.header.attrs;return typeof e!="number"||typeof t!="number"?Kg:[...Kg,{name:"ωa/(2πcₜ)",factor:t/e,relative:!0}]}function Cc(n,e){return n.find(({factor:i,relative:s})=>!s&&e<WS*i)??n[0]}function Rc(n,{name:e,relative:t}){return t?`${e} = ${n}`:`${n} ${e}`}function lr(n,{name:e,relative:t}){return t?e:`${n} / ${e.includes("/")?`(${e})`:e}`}function Zg(n){return`${Number(n.toPrecision(6))}`}var qS="uplot",XS="u-hz",$S="u-vt",YS="u-title",KS="u-wrap",ZS="u-under",JS="u-over",jS="u-axis",Hr="u-off",QS="u-select",eM="u-cursor-x",tM="u-cursor-y",nM="u-cursor-pt",iM="u-legend",sM="u-live",rM="u-inline",oM="u-series",aM="u-marker",Jg="u-label",lM="u-value",il="width",sl="height";var jg="bottom",No="left",cd="right",Ed="#000",Qg=Ed+"0",ud="mousemove",e0="mousedown",hd="mouseup",t0="mouseenter",n0="mouseleave",i0="dblclick",cM="resize",uM="scroll",s0="change",Nc="dppxchange",Ad="--",Vo=typeof window<"u",gd=Vo?document:null,Fo=Vo?window:null,hM=Vo?navigator:null,Rt,Pc;function _d(){let n=devicePixelRatio;Rt!=n&&(Rt=n,Pc&&yd(s0,Pc,_d),Pc=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),Wr(s0,Pc,_d),Fo.dispatchEvent(new CustomEvent(Nc)))}function gi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function vd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Zt(n,e,t){n.style[e]=t+"px"}function Wi(n,e,t,i){let s=gd.createElement(n);return e!=null&&gi(s,e),t?.insertBefore(s,i),s}function Ii(n,e){return Wi("div",n,e)}var r0=new WeakMap;function ps(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=r0.get(n);r!=o&&(n.style.transform=r,r0.set(n,r),e<0||t<0||e>i||t>s?gi(n,Hr):vd(n,Hr))}var o0=new WeakMap;function a0(n,e,t){let i=e+t,s=o0.get(n);i!=s&&(o0.set(n,i),n.style.background=e,n.style.borderColor=t)}var l0=new WeakMap;function c0(n,e,t,i){let s=e+""+t,r=l0.get(n);s!=r&&(l0.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Cd={passive:!0},fM={...Cd,capture:!0};function Wr(n,e,t,i){e.addEventListener(n,t,i?fM:Cd)}function yd(n,e,t,i){e.removeEventListener(n,t,Cd)}Vo&&_d();function qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:_i((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function O0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var k0=n=>n!=null,B0=n=>n!=null&&n>0,Oc=O0(k0),dM=O0(B0);function pM(n,e,t,i=0,s=!1){let r=s?dM:Oc,o=s?B0:k0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function kc(n,e,t,i){let s=f0(n),r=f0(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ds:z0,a=s==1?_i:Li,l=r==1?Li:_i,c=a(o(Pn(n))),u=l(o(Pn(e))),h=Oo(t,c),f=Oo(t,u);return t==10&&(c<0&&(h=Gt(h,-c)),u<0&&(f=Gt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=W0(n,h),e=Bc(e,f)),[n,e]}function Rd(n,e,t,i){let s=kc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Pd=.1,u0={mode:3,pad:Pd},ol={pad:0,soft:null,mode:0},mM={min:ol,max:ol};function Uc(n,e,t,i){return zc(t)?h0(n,e,t):(ol.pad=t,ol.soft=i?0:null,ol.mode=i?3:0,h0(n,e,mM))}function At(n,e){return n??e}function gM(n,e,t){for(e=At(e,0),t=At(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function h0(n,e,t){let i=t.min,s=t.max,r=At(i.pad,0),o=At(s.pad,0),a=At(i.hard,-Vt),l=At(s.hard,Vt),c=At(i.soft,Vt),u=At(s.soft,-Vt),h=At(i.mode,0),f=At(s.mode,0),p=e-n,_=Ds(p),b=ii(Pn(n),Pn(e)),g=Ds(b),m=Pn(g-_);(p<1e-24||m>10)&&(p=0,(n==0||e==0)&&(p=1e-24,h==2&&c!=Vt&&(r=0),f==2&&u!=-Vt&&(o=0)));let x=p||b||1e3,A=Ds(x),S=Oo(10,_i(A)),P=x*(p==0?n==0?.1:1:r),C=Gt(W0(n-P,S/10),24),v=n>=c&&(h==1||h==3&&C<=c||h==2&&C>=c)?c:Vt,E=ii(a,C<v&&n>=v?v:Xi(v,C)),k=x*(p==0?e==0?.1:1:o),N=Gt(Bc(e+k,S/10),24),L=e<=u&&(f==1||f==3&&N>=u||f==2&&N<=u)?u:-Vt,B=Xi(l,N>L&&e<=L?L:ii(L,N));return E==B&&E==0&&(B=100),[E,B]}var _M=new Intl.NumberFormat(Vo?hM.language:"en-US"),Id=n=>_M.format(n),vi=Math,Dc=vi.PI,Pn=vi.abs,_i=vi.floor,Rn=vi.round,Li=vi.ceil,Xi=vi.min,ii=vi.max,Oo=vi.pow,f0=vi.sign,Ds=vi.log10,z0=vi.log2,vM=(n,e=1)=>vi.sinh(n)*e,fd=(n,e=1)=>vi.asinh(n/e),Vt=1/0;function d0(n){return(Ds((n^n>>31)-(n>>31))|0)+1}function xd(n,e,t){return Xi(ii(n,e),t)}function V0(n){return typeof n=="function"}function vt(n){return V0(n)?n:()=>n}var yM=()=>{},G0=n=>n,H0=(n,e)=>e,xM=n=>null,p0=n=>!0,m0=(n,e)=>n==e,bM=/\.\d*?(?=9{6,}|0{6,})/gm,qr=n=>{if(X0(n)||ur.has(n))return n;let e=`${n}`,t=e.match(bM);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${qr(s)}e${r}`}return Gt(n,i)};function Vr(n,e){return qr(Gt(qr(n/e))*e)}function Bc(n,e){return qr(Li(qr(n/e))*e)}function W0(n,e){return qr(_i(qr(n/e))*e)}function Gt(n,e=0){if(X0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Rn(i)/t}var ur=new Map;function q0(n){return((""+n).split(".")[1]||"").length}function ll(n,e,t,i){let s=[],r=i.map(q0);for(let o=e;o<t;o++){let a=Pn(o),l=Gt(Oo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Gt(u,h);s.push(f),ur.set(f,h)}}return s}var al={},Ld=[],ko=[null,null],cr=Array.isArray,X0=Number.isInteger,SM=n=>n===void 0;function g0(n){return typeof n=="string"}function zc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function MM(n){return n!=null&&typeof n=="object"}var wM=Object.getPrototypeOf(Uint8Array),$0="__proto__";function Bo(n,e=zc){let t;if(cr(n)){let i=n.find(s=>s!=null);if(cr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Bo(n[s],e)}else t=n.slice()}else if(n instanceof wM)t=n.slice();else if(e(n)){t={};for(let i in n)i!=$0&&(t[i]=Bo(n[i],e))}else t=n;return t}function Mn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=$0&&(zc(n[s])?Mn(n[s],Bo(i[s])):n[s]=Bo(i[s]))}return n}var TM=0,EM=1,AM=2;function CM(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function RM(n,e){if(LM(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return DM(o[0])||(o=IM(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:EM,p=[];for(let _=0;_<u.length;_++){let b=u[_],g=r.get(l[_]);b===null?f!=TM&&(h[g]=b,f==AM&&p.push(g)):h[g]=b}CM(h,p,s),i.push(h)}}return i}var PM=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function IM(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function LM(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function DM(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ii(1,_i((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Y0=["January","February","March","April","May","June","July","August","September","October","November","December"],K0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Z0(n){return n.slice(0,3)}var NM=K0.map(Z0),UM=Y0.map(Z0),FM={MMMM:Y0,MMM:UM,WWWW:K0,WWW:NM};function nl(n){return(n<10?"0":"")+n}function OM(n){return(n<10?"00":n<100?"0":"")+n}var kM={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>nl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>nl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>nl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>nl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>nl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>OM(n.getMilliseconds())};function Dd(n,e){e=e||FM;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?kM[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var BM=new Intl.DateTimeFormat().resolvedOptions().timeZone;function zM(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==BM?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var J0=n=>n%1==0,Fc=[1,2,2.5,5],VM=ll(10,-32,0,Fc),j0=ll(10,0,32,Fc),GM=j0.filter(J0),Gr=VM.concat(j0),Nd=`
`,Q0="{YYYY}",_0=Nd+Q0,e_="{M}/{D}",rl=Nd+e_,Ic=rl+"/{YY}",t_="{aa}",HM="{h}:{mm}",Uo=HM+t_,v0=Nd+Uo,y0=":{ss}",It=null;function n_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?ll(10,0,3,Fc).filter(J0):ll(10,-3,0,Fc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Q0,It,It,It,It,It,It,1],[s*28,"{MMM}",_0,It,It,It,It,It,1],[s,e_,_0,It,It,It,It,It,1],[i,"{h}"+t_,Ic,It,rl,It,It,It,1],[t,Uo,Ic,It,rl,It,It,It,1],[e,y0,Ic+" "+Uo,It,rl+" "+Uo,It,v0,It,1],[n,y0+".{fff}",Ic+" "+Uo,It,rl+" "+Uo,It,v0,It,1]];function u(h){return(f,p,_,b,g,m)=>{let x=[],A=g>=o,S=g>=r&&g<o,P=h(_),C=Gt(P*n,3),v=dd(P.getFullYear(),A?0:P.getMonth(),S||A?1:P.getDate()),E=Gt(v*n,3);if(S||A){let k=S?g/r:0,N=A?g/o:0,L=C==E?C:Gt(dd(v.getFullYear()+N,v.getMonth()+k,1)*n,3),B=new Date(Rn(L/n)),V=B.getFullYear(),U=B.getMonth();for(let H=0;L<=b;H++){let Y=dd(V+N*H,U+k*H,1),G=Y-h(Gt(Y*n,3));L=Gt((+Y+G)*n,3),L<=b&&x.push(L)}}else{let k=g>=s?s:g,N=_i(_)-_i(C),L=E+N+Bc(C-E,k);x.push(L);let B=h(L),V=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,U=g/i,H=f.axes[p]._space,Y=m/H;for(;L=Gt(L+g,n==1?0:3),!(L>b);)if(U>1){let G=_i(Gt(V+U,6))%24,Q=h(L).getHours()-G;Q>1&&(Q=-1),L-=Q*i,V=(V+U)%24;let se=x[x.length-1];Gt((L-se)/g,3)*Y>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,u]}var[WM,qM,XM]=n_(1),[$M,YM,KM]=n_(.001);ll(2,-53,53,[1]);function x0(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function b0(n,e){return(t,i,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,h,f,p;return i.map(_=>{let b=n(_),g=b.getFullYear(),m=b.getMonth(),x=b.getDate(),A=b.getHours(),S=b.getMinutes(),P=b.getSeconds(),C=g!=l&&a[2]||m!=c&&a[3]||x!=u&&a[4]||A!=h&&a[5]||S!=f&&a[6]||P!=p&&a[7]||a[1];return l=g,c=m,u=x,h=A,f=S,p=P,C(b)})}}function ZM(n,e){let t=Dd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function dd(n,e,t){return new Date(n,e,t)}function S0(n,e){return e(n)}var JM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function M0(n,e){return(t,i,s,r)=>r==null?Ad:e(n(i))}function jM(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function QM(n,e){return n.series[e].fill(n,e)}var ew={show:!0,live:!0,isolate:!1,mount:yM,markers:{show:!0,width:2,stroke:jM,fill:QM,dash:"solid"},idx:null,idxs:null,values:[]};function tw(n,e){let t=n.cursor.points,i=Ii(),s=t.size(n,e);Zt(i,il,s),Zt(i,sl,s);let r=s/-2;Zt(i,"marginLeft",r),Zt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Zt(i,"borderWidth",o),i}function nw(n,e){let t=n.series[e].points;return t._fill||t._stroke}function iw(n,e){let t=n.series[e].points;return t._stroke||t._fill}function sw(n,e){return n.series[e].points.size}var pd=[0,0];function rw(n,e,t){return pd[0]=e,pd[1]=t,pd}function Lc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function md(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var ow={show:!0,x:!0,y:!0,lock:!1,move:rw,points:{one:!1,show:tw,size:sw,width:0,stroke:iw,fill:nw},bind:{mousedown:Lc,mouseup:Lc,click:Lc,dblclick:Lc,mousemove:md,mouseleave:md,mouseenter:md},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},i_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ud=Mn({},i_,{filter:H0}),s_=Mn({},Ud,{size:10}),r_=Mn({},i_,{show:!1}),Fd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',o_="bold "+Fd,a_=1.5,w0={show:!0,scale:"x",stroke:Ed,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:o_,side:2,grid:Ud,ticks:s_,border:r_,font:Fd,lineGap:a_,rotate:0},aw="Value",lw="Time",T0={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function cw(n,e,t,i,s){return e.map(r=>r==null?"":Id(r))}function uw(n,e,t,i,s,r,o){let a=[],l=ur.get(s)||0;t=o?t:Gt(Bc(t,s),l);for(let c=t;c<=i;c=Gt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function bd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ds:z0,u=_i(c(t));s=Oo(l,u),l==10&&(s=Gr[qi(s,Gr)]);let h=t,f=s*l;l==10&&(f=Gr[qi(f,Gr)]);do a.push(h),h=h+s,l==10&&!ur.has(h)&&(h=Gt(h,ur.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Gr[qi(f,Gr)]));while(h<=i);return a}function hw(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?bd(n,e,ii(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?bd(n,e,ii(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var l_=/./,fw=/[12357]/,dw=/[125]/,E0=/1/,Sd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function pw(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?l_:l(7,o)-u>=c?fw:l(5,o)-u>=c?dw:E0;if(h==E0){let f=Pn(l(1,o)-u);if(f<c)return Sd(e.slice().reverse(),a.distr,h,Li(c/f)).reverse()}return Sd(e,a.distr,h,1)}function mw(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Pn(l(1,o)-l(2,o));return c<a?Sd(e.slice().reverse(),3,l_,Li(a/c)).reverse():e}function gw(n,e,t,i){return i==null?Ad:e==null?"":Id(e)}var A0={show:!0,scale:"y",stroke:Ed,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:o_,side:3,grid:Ud,ticks:s_,border:r_,font:Fd,lineGap:a_,rotate:0};function _w(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function vw(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Pn(o-r),l=n.series[e],c=a/(l.points.space*Rt);return i[1]-i[0]<=c}var C0={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},c_=(n,e,t,i,s)=>s,R0={show:!0,auto:!0,sorted:0,gaps:c_,alpha:1,facets:[Mn({},C0,{scale:"x"}),Mn({},C0,{scale:"y"})]},P0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:c_,alpha:1,points:{show:vw,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function yw(n,e,t,i,s){return t/10}var u_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},xw=Mn({},u_,{time:!1,ori:1}),I0={};function h_(n,e){let t=I0[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(I0[n]=t)),t}var zo=1,Md=2;function Xr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,_=a.width,b=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,g,m,f,p,_,b,Gc,Go,Wc,d_,m_):t(s,l,c,u,h,m,g,p,f,b,_,Hc,Ho,Bd,p_,g_)}function Od(n,e){let t=0,i=0,s=At(n.bands,Ld);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function bw(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ns(n,e,t,i,s,r){return Xr(n,e,(o,a,l,c,u,h,f,p,_,b,g)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),A=c.ori==0?Go:Ho,S,P;x==1?(S=t,P=i):(S=i,P=t);let C=m(h(a[S],c,b,p)),v=m(f(l[S],u,g,_)),E=m(h(a[P],c,b,p)),k=m(f(r==1?u.max:u.min,u,g,_)),N=new Path2D(s);return A(N,E,k),A(N,C,k),A(N,C,v),N})}function Vc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Wc:Bd,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Sw(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function kd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=r(n[h]),_=f==h?p:r(n[f]),b=h-s;p=o<=0&&b>=0&&b<l?r(n[b]):p;let m=f+s;_=o>=0&&m>=0&&m<l?r(n[m]):_,_>=p&&a.push([p,_])}return a}function L0(n){return n==0?G0:n==1?Rn:e=>Vr(e,n)}function f_(n){let e=n==0?Gc:Hc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Xi(c,a/2,l/2),u=Xi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Gc=(n,e,t)=>{n.moveTo(e,t)},Hc=(n,e,t)=>{n.moveTo(t,e)},Go=(n,e,t)=>{n.lineTo(e,t)},Ho=(n,e,t)=>{n.lineTo(t,e)},Wc=f_(0),Bd=f_(1),d_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},p_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},m_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},g_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function __(n){return(e,t,i,s,r)=>Xr(e,t,(o,a,l,c,u,h,f,p,_,b,g)=>{let{pxRound:m,points:x}=o,A,S;c.ori==0?(A=Gc,S=d_):(A=Hc,S=p_);let P=Gt(x.width*Rt,3),C=(x.size-x.width)/2*Rt,v=Gt(C*2,3),E=new Path2D,k=new Path2D,{left:N,top:L,width:B,height:V}=e.bbox;Wc(k,N-v,L-v,B+v*2,V+v*2);let U=H=>{if(l[H]!=null){let Y=m(h(a[H],c,b,p)),G=m(f(l[H],u,g,_));A(E,Y+C,G),S(E,Y,G,C,0,Dc*2)}};if(r)r.forEach(U);else for(let H=i;H<=s;H++)U(H);return{stroke:P>0?E:null,fill:E,clip:k,flags:zo|Md}})}function v_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Mw=v_(Go),ww=v_(Ho);function y_(n){let e=At(n?.alignGaps,0);return(t,i,s,r)=>Xr(t,i,(o,a,l,c,u,h,f,p,_,b,g)=>{[s,r]=Oc(l,s,r);let m=o.pxRound,x=V=>m(h(V,c,b,p)),A=V=>m(f(V,u,g,_)),S,P;c.ori==0?(S=Go,P=Mw):(S=Ho,P=ww);let C=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zo},E=v.stroke,k=!1;if(r-s>=b*4){let V=he=>t.posToVal(he,c.key,!0),U=null,H=null,Y,G,le,J=x(a[C==1?s:r]),Q=x(a[s]),se=x(a[r]),fe=V(C==1?Q+1:se-1);for(let he=C==1?s:r;he>=s&&he<=r;he+=C){let ee=a[he],ve=(C==1?ee<fe:ee>fe)?J:x(ee),Ae=l[he];ve==J?Ae!=null?(G=Ae,U==null?(S(E,ve,A(G)),Y=U=H=G):G<U?U=G:G>H&&(H=G)):Ae===null&&(k=!0):(U!=null&&P(E,J,A(U),A(H),A(Y),A(G)),Ae!=null?(G=Ae,S(E,ve,A(G)),U=H=Y=G):(U=H=null,Ae===null&&(k=!0)),J=ve,fe=V(J+C))}U!=null&&U!=H&&le!=J&&P(E,J,A(U),A(H),A(Y),A(G))}else for(let V=C==1?s:r;V>=s&&V<=r;V+=C){let U=l[V];U===null?k=!0:U!=null&&S(E,x(a[V]),A(U))}let[L,B]=Od(t,i);if(o.fill!=null||L!=0){let V=v.fill=new Path2D(E),U=o.fillTo(t,i,o.min,o.max,L),H=A(U),Y=x(a[s]),G=x(a[r]);C==-1&&([G,Y]=[Y,G]),S(V,G,H),S(V,Y,H)}if(!o.spanGaps){let V=[];k&&V.push(...kd(a,l,s,r,C,x,e)),v.gaps=V=o.gaps(t,i,s,r,V),v.clip=Vc(V,c.ori,p,_,b,g)}return B!=0&&(v.band=B==2?[Ns(t,i,s,r,E,-1),Ns(t,i,s,r,E,1)]:Ns(t,i,s,r,E,B)),v})}function Tw(n){let e=At(n.align,1),t=At(n.ascDesc,!1),i=At(n.alignGaps,0),s=At(n.extend,!1);return(r,o,a,l)=>Xr(r,o,(c,u,h,f,p,_,b,g,m,x,A)=>{[a,l]=Oc(h,a,l);let S=c.pxRound,{left:P,width:C}=r.bbox,v=Q=>S(_(Q,f,x,g)),E=Q=>S(b(Q,p,A,m)),k=f.ori==0?Go:Ho,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zo},L=N.stroke,B=f.dir*(f.ori==0?1:-1),V=E(h[B==1?a:l]),U=v(u[B==1?a:l]),H=U,Y=U;s&&e==-1&&(Y=P,k(L,Y,V)),k(L,U,V);for(let Q=B==1?a:l;Q>=a&&Q<=l;Q+=B){let se=h[Q];if(se==null)continue;let fe=v(u[Q]),he=E(se);e==1?k(L,fe,V):k(L,H,he),k(L,fe,he),V=he,H=fe}let G=H;s&&e==1&&(G=P+C,k(L,G,V));let[le,J]=Od(r,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(L),se=c.fillTo(r,o,c.min,c.max,le),fe=E(se);k(Q,G,fe),k(Q,Y,fe)}if(!c.spanGaps){let Q=[];Q.push(...kd(u,h,a,l,B,v,i));let se=c.width*Rt/2,fe=t||e==1?se:-se,he=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=Vc(Q,f.ori,g,m,x,A)}return J!=0&&(N.band=J==2?[Ns(r,o,a,l,L,-1),Ns(r,o,a,l,L,1)]:Ns(r,o,a,l,L,J)),N})}function D0(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Pn(n[l]-n[a]);u<c&&(c=u,o=Pn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Ew(n){n=n||al;let e=At(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=At(e[1],Vt),l=At(e[2],1),c=At(n.disp,al),u=At(n.each,p=>{}),{fill:h,stroke:f}=c;return(p,_,b,g)=>Xr(p,_,(m,x,A,S,P,C,v,E,k,N,L)=>{let B=m.pxRound,V=t,U=i*Rt,H=a*Rt,Y=l*Rt,G,le;S.ori==0?[G,le]=r(p,_):[le,G]=r(p,_);let J=S.dir*(S.ori==0?1:-1),Q=S.ori==0?Wc:Bd,se=S.ori==0?u:(Re,Ke,ot,Me,zt,Ve,Xe)=>{u(Re,Ke,ot,zt,Me,Xe,Ve)},fe=At(p.bands,Ld).find(Re=>Re.series[0]==_),he=fe!=null?fe.dir:0,ee=m.fillTo(p,_,m.min,m.max,he),me=B(v(ee,P,L,k)),ve,Ae,Se,We=N,rt=B(m.width*Rt),Ge=!1,ft=null,ct=null,it=null,jt=null;h!=null&&(rt==0||f!=null)&&(Ge=!0,ft=h.values(p,_,b,g),ct=new Map,new Set(ft).forEach(Re=>{Re!=null&&ct.set(Re,new Path2D)}),rt>0&&(it=f.values(p,_,b,g),jt=new Map,new Set(it).forEach(Re=>{Re!=null&&jt.set(Re,new Path2D)})));let{x0:Ht,size:gn}=c;if(Ht!=null&&gn!=null){V=1,x=Ht.values(p,_,b,g),Ht.unit==2&&(x=x.map(ot=>p.posToVal(E+ot*N,S.key,!0)));let Re=gn.values(p,_,b,g);gn.unit==2?Ae=Re[0]*N:Ae=C(Re[0],S,N,E)-C(0,S,N,E),We=D0(x,A,C,S,N,E,We),Se=We-Ae+U}else We=D0(x,A,C,S,N,E,We),Se=We*o+U,Ae=We-Se;Se<1&&(Se=0),rt>=Ae/2&&(rt=0),Se<5&&(B=G0);let Ot=Se>0,Fn=We-Se-(Ot?rt:0);Ae=B(xd(Fn,Y,H)),ve=(V==0?Ae/2:V==J?0:Ae)-V*J*((V==0?U/2:0)+(Ot?rt/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Tn=Ge?null:new Path2D,ln=null;if(fe!=null)ln=p.data[fe.series[1]];else{let{y0:Re,y1:Ke}=c;Re!=null&&Ke!=null&&(A=Ke.values(p,_,b,g),ln=Re.values(p,_,b,g))}let _n=G*Ae,O=le*Ae;for(let Re=J==1?b:g;Re>=b&&Re<=g;Re+=J){let Ke=A[Re];if(Ke==null)continue;if(ln!=null){let q=ln[Re]??0;if(Ke-q==0)continue;me=v(q,P,L,k)}let ot=S.distr!=2||c!=null?x[Re]:Re,Me=C(ot,S,N,E),zt=v(At(Ke,ee),P,L,k),Ve=B(Me-ve),Xe=B(ii(zt,me)),R=B(Xi(zt,me)),M=Xe-R;if(Ke!=null){let q=Ke<0?O:_n,ue=Ke<0?_n:O;Ge?(rt>0&&it[Re]!=null&&Q(jt.get(it[Re]),Ve,R+_i(rt/2),Ae,ii(0,M-rt),q,ue),ft[Re]!=null&&Q(ct.get(ft[Re]),Ve,R+_i(rt/2),Ae,ii(0,M-rt),q,ue)):Q(Tn,Ve,R+_i(rt/2),Ae,ii(0,M-rt),q,ue),se(p,_,Re,Ve-rt/2,R,Ae+rt,M)}}return rt>0?St.stroke=Ge?jt:Tn:Ge||(St._fill=m.width==0?m._fill:m._stroke??m._fill,St.width=0),St.fill=Ge?ct:Tn,St})}function Aw(n,e){let t=At(e?.alignGaps,0);return(i,s,r,o)=>Xr(i,s,(a,l,c,u,h,f,p,_,b,g,m)=>{[r,o]=Oc(c,r,o);let x=a.pxRound,A=G=>x(f(G,u,g,_)),S=G=>x(p(G,h,m,b)),P,C,v;u.ori==0?(P=Gc,v=Go,C=m_):(P=Hc,v=Ho,C=g_);let E=u.dir*(u.ori==0?1:-1),k=A(l[E==1?r:o]),N=k,L=[],B=[];for(let G=E==1?r:o;G>=r&&G<=o;G+=E)if(c[G]!=null){let J=l[G],Q=A(J);L.push(N=Q),B.push(S(c[G]))}let V={stroke:n(L,B,P,v,C,x),fill:null,clip:null,band:null,gaps:null,flags:zo},U=V.stroke,[H,Y]=Od(i,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(U),le=a.fillTo(i,s,a.min,a.max,H),J=S(le);v(G,N,J),v(G,k,J)}if(!a.spanGaps){let G=[];G.push(...kd(l,c,r,o,E,A,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=Vc(G,u.ori,_,b,g,m)}return Y!=0&&(V.band=Y==2?[Ns(i,s,r,o,U,-1),Ns(i,s,r,o,U,1)]:Ns(i,s,r,o,U,Y)),V})}function Cw(n){return Aw(Rw,n)}function Rw(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var wd=new Set;function N0(){for(let n of wd)n.syncRect(!0)}Vo&&(Wr(cM,Fo,N0),Wr(uM,Fo,N0,!0),Wr(Nc,Fo,()=>{nn.pxRatio=Rt}));var Pw=y_(),Iw=__();function U0(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Td(r,o,e,t))}function Lw(n,e){return n.map((t,i)=>i==0?{}:Mn({},e,t))}function Td(n,e,t,i){return Mn({},e==0?t:i,n)}function x_(n,e,t){return e==null?ko:[e,t]}var Dw=x_;function Nw(n,e,t){return e==null?ko:Uc(e,t,Pd,!0)}function b_(n,e,t,i){return e==null?ko:kc(e,t,n.scales[i].log,!1)}var Uw=b_;function S_(n,e,t,i){return e==null?ko:Rd(e,t,n.scales[i].log,!1)}var Fw=S_;function Ow(n,e,t,i,s){let r=ii(d0(n),d0(e)),o=e-n,a=qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?ur.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function F0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Rn((t=+s)*Rt))+"px"),[n,e,t]}function kw(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function nn(n,e,t){let i={mode:At(n.mode,1)},s=i.mode;function r(y,w,I,D){let W=w.valToPct(y);return D+I*(w.dir==-1?1-W:W)}function o(y,w,I,D){let W=w.valToPct(y);return D+I*(w.dir==-1?W:1-W)}function a(y,w,I,D){return w.ori==0?r(y,w,I,D):o(y,w,I,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ii(qS);if(n.id!=null&&(c.id=n.id),gi(c,n.class),n.title){let y=Ii(YS,c);y.textContent=n.title}let u=Wi("canvas"),h=i.ctx=u.getContext("2d"),f=Ii(KS,c);Wr("click",f,y=>{y.target===_&&($t!=So||Qt!=Mo)&&Hn.click(i,y)},!0);let p=i.under=Ii(ZS,f);f.appendChild(u);let _=i.over=Ii(JS,f);n=Bo(n);let b=+At(n.pxAlign,1),g=L0(b);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?U0(n.series||[],T0,P0,!1):Lw(n.series||[null],R0),A=i.axes=U0(n.axes||[],w0,A0,!0),S=i.scales={},P=i.bands=n.bands||[];P.forEach(y=>{y.fill=vt(y.fill||null),y.dir=At(y.dir,-1)});let C=s==2?x[1].facets[0].scale:x[0].scale,v={axes:Ps,series:pt},E=(n.drawOrder||["axes","series"]).map(y=>v[y]);function k(y){let w=y.distr==3?I=>Ds(I>0?I:y.clamp(i,I,y.min,y.max,y.key)):y.distr==4?I=>fd(I,y.asinh):y.distr==100?I=>y.fwd(I):I=>I;return I=>{let D=w(I),{_min:W,_max:Z}=y,ae=Z-W;return(D-W)/ae}}function N(y){let w=S[y];if(w==null){let I=(n.scales||al)[y]||al;if(I.from!=null){N(I.from);let D=Mn({},S[I.from],I,{key:y});D.valToPct=k(D),S[y]=D}else{w=S[y]=Mn({},y==C?u_:xw,I),w.key=y;let D=w.time,W=w.range,Z=cr(W);if((y!=C||s==2&&!D)&&(Z&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?u0:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?u0:{mode:1,hard:W[1],soft:W[1]}},Z=!1),!Z&&zc(W))){let ae=W;W=(de,xe,Ne)=>xe==null?ko:Uc(xe,Ne,ae)}w.range=vt(W||(D?Dw:y==C?w.distr==3?Uw:w.distr==4?Fw:x_:w.distr==3?b_:w.distr==4?S_:Nw)),w.auto=vt(Z?!1:w.auto),w.clamp=vt(w.clamp||yw),w._min=w._max=null,w.valToPct=k(w)}}}N("x"),N("y"),s==1&&x.forEach(y=>{N(y.scale)}),A.forEach(y=>{N(y.scale)});for(let y in n.scales)N(y);let L=S[C],B=L.distr,V,U;L.ori==0?(gi(c,XS),V=r,U=o):(gi(c,$S),V=o,U=r);let H={};for(let y in S){let w=S[y];(w.min!=null||w.max!=null)&&(H[y]={min:w.min,max:w.max},w.min=w.max=null)}let Y=n.tzDate||(y=>new Date(Rn(y/m))),G=n.fmtDate||Dd,le=m==1?XM(Y):KM(Y),J=b0(Y,x0(m==1?qM:YM,G)),Q=M0(Y,S0(JM,G)),se=[],fe=i.legend=Mn({},ew,n.legend),he=i.cursor=Mn({},ow,{drag:{y:s==2}},n.cursor),ee=fe.show,me=he.show,ve=fe.markers;fe.idxs=se,ve.width=vt(ve.width),ve.dash=vt(ve.dash),ve.stroke=vt(ve.stroke),ve.fill=vt(ve.fill);let Ae,Se,We,rt=[],Ge=[],ft,ct=!1,it={};if(fe.live){let y=x[1]?x[1].values:null;ct=y!=null,ft=ct?y(i,1,0):{_:0};for(let w in ft)it[w]=Ad}if(ee)if(Ae=Wi("table",iM,c),We=Wi("tbody",null,Ae),fe.mount(i,Ae),ct){Se=Wi("thead",null,Ae,We);let y=Wi("tr",null,Se);Wi("th",null,y);for(var jt in ft)Wi("th",Jg,y).textContent=jt}else gi(Ae,rM),fe.live&&gi(Ae,sM);let Ht={show:!0},gn={show:!1};function Ot(y,w){if(w==0&&(ct||!fe.live||s==2))return ko;let I=[],D=Wi("tr",oM,We,We.childNodes[w]);gi(D,y.class),y.show||gi(D,Hr);let W=Wi("th",null,D);if(ve.show){let de=Ii(aM,W);if(w>0){let xe=ve.width(i,w);xe&&(de.style.border=xe+"px "+ve.dash(i,w)+" "+ve.stroke(i,w)),de.style.background=ve.fill(i,w)}}let Z=Ii(Jg,W);y.label instanceof HTMLElement?Z.appendChild(y.label):Z.textContent=y.label,w>0&&(ve.show||(Z.style.color=y.width>0?ve.stroke(i,w):ve.fill(i,w)),St("click",W,de=>{if(he._lock)return;Je(de);let xe=x.indexOf(y);if((de.ctrlKey||de.metaKey)!=fe.isolate){let Ne=x.some((Ue,Oe)=>Oe>0&&Oe!=xe&&Ue.show);x.forEach((Ue,Oe)=>{Oe>0&&us(Oe,Ne?Oe==xe?Ht:gn:Ht,!0,bn.setSeries)})}else us(xe,{show:!y.show},!0,bn.setSeries)},!1),je&&St(t0,W,de=>{he._lock||(Je(de),us(x.indexOf(y),To,!0,bn.setSeries))},!1));for(var ae in ft){let de=Wi("td",lM,D);de.textContent="--",I.push(de)}return[D,I]}let Fn=new Map;function St(y,w,I,D=!0){let W=Fn.get(w)||{},Z=he.bind[y](i,w,I,D);Z&&(Wr(y,w,W[y]=Z),Fn.set(w,W))}function Tn(y,w,I){let D=Fn.get(w)||{};for(let W in D)(y==null||W==y)&&(yd(W,w,D[W]),delete D[W]);y==null&&Fn.delete(w)}let ln=0,_n=0,O=0,Re=0,Ke=0,ot=0,Me=Ke,zt=ot,Ve=O,Xe=Re,R=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,_e=!1,ye=!1,te=!1,ie=!1,pe=!1;function F(y,w,I){(I||y!=i.width||w!=i.height)&&re(y,w),ut(!1),ye=!0,_e=!0,Xn()}function re(y,w){i.width=ln=O=y,i.height=_n=Re=w,Ke=ot=0,be(),He();let I=i.bbox;R=I.left=Vr(Ke*Rt,.5),M=I.top=Vr(ot*Rt,.5),q=I.width=Vr(O*Rt,.5),ue=I.height=Vr(Re*Rt,.5)}let ne=3;function we(){let y=!1,w=0;for(;!y;){w++;let I=yo(w),D=cs(w);y=w==ne||I&&D,y||(re(i.width,i.height),_e=!0)}}function ge({width:y,height:w}){F(y,w)}i.setSize=ge;function be(){let y=!1,w=!1,I=!1,D=!1;A.forEach((W,Z)=>{if(W.show&&W._show){let{side:ae,_size:de}=W,xe=ae%2,Ne=W.label!=null?W.labelSize:0,Ue=de+Ne;Ue>0&&(xe?(O-=Ue,ae==3?(Ke+=Ue,D=!0):I=!0):(Re-=Ue,ae==0?(ot+=Ue,y=!0):w=!0))}}),as[0]=y,as[1]=I,as[2]=w,as[3]=D,O-=Vi[1]+Vi[3],Ke+=Vi[3],Re-=Vi[2]+Vi[0],ot+=Vi[0]}function He(){let y=Ke+O,w=ot+Re,I=Ke,D=ot;function W(Z,ae){switch(Z){case 1:return y+=ae,y-ae;case 2:return w+=ae,w-ae;case 3:return I-=ae,I+ae;case 0:return D-=ae,D+ae}}A.forEach((Z,ae)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=W(de,Z._size),Z.label!=null&&(Z._lpos=W(de,Z.labelSize))}})}if(he.dataIdx==null){let y=he.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let I=y.prox=vt(y.prox),D=y.bias??=0;he.dataIdx=(W,Z,ae,de)=>{if(Z==0)return ae;let xe=ae,Ne=I(W,Z,ae,de)??Vt,Ue=Ne>=0&&Ne<Vt,Oe=L.ori==0?O:Re,st=he.left,Ct=e[0],Tt=e[Z];if(w.has(Tt[ae])){xe=null;let gt=null,Ze=null,qe;if(D==0||D==-1)for(qe=ae;gt==null&&qe-- >0;)w.has(Tt[qe])||(gt=qe);if(D==0||D==1)for(qe=ae;Ze==null&&qe++<Tt.length;)w.has(Tt[qe])||(Ze=qe);if(gt!=null||Ze!=null)if(Ue){let Kt=gt==null?-1/0:V(Ct[gt],L,Oe,0),hn=Ze==null?1/0:V(Ct[Ze],L,Oe,0),zn=st-Kt,kt=hn-st;zn<=kt?zn<=Ne&&(xe=gt):kt<=Ne&&(xe=Ze)}else xe=Ze==null?gt:gt==null?Ze:ae-gt<=Ze-ae?gt:Ze}else Ue&&Pn(st-V(Ct[ae],L,Oe,0))>Ne&&(xe=null);return xe}}let Je=y=>{he.event=y};he.idxs=se,he._lock=!1;let ce=he.points;ce.show=vt(ce.show),ce.size=vt(ce.size),ce.stroke=vt(ce.stroke),ce.width=vt(ce.width),ce.fill=vt(ce.fill);let ke=i.focus=Mn({},n.focus||{alpha:.3},he.focus),je=ke.prox>=0,Ce=je&&ce.one,at=[],Xt=[],jn=[];function Fa(y,w){let I=ce.show(i,w);if(I instanceof HTMLElement)return gi(I,nM),gi(I,y.class),ps(I,-10,-10,O,Re),_.insertBefore(I,at[w]),I}function go(y,w){if(s==1||w>0){let I=s==1&&S[y.scale].time,D=y.value;y.value=I?g0(D)?M0(Y,S0(D,G)):D||Q:D||gw,y.label=y.label||(I?lw:aw)}if(Ce||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||Pw||xM,y.fillTo=vt(y.fillTo||bw),y.pxAlign=+At(y.pxAlign,b),y.pxRound=L0(y.pxAlign),y.stroke=vt(y.stroke||null),y.fill=vt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let I=_w(ii(1,y.width),1),D=y.points=Mn({},{size:I,width:ii(1,I*.2),stroke:y.stroke,space:I*2,paths:Iw,_stroke:null,_fill:null},y.points);D.show=vt(D.show),D.filter=vt(D.filter),D.fill=vt(D.fill),D.stroke=vt(D.stroke),D.paths=vt(D.paths),D.pxAlign=y.pxAlign}if(ee){let I=Ot(y,w);rt.splice(w,0,I[0]),Ge.splice(w,0,I[1]),fe.values.push(null)}if(me){se.splice(w,0,null);let I=null;Ce?w==0&&(I=Fa(y,w)):w>0&&(I=Fa(y,w)),at.splice(w,0,I),Xt.splice(w,0,0),jn.splice(w,0,0)}Bn("addSeries",w)}function Nf(y,w){w=w??x.length,y=s==1?Td(y,w,T0,P0):Td(y,w,{},R0),x.splice(w,0,y),go(x[w],w)}i.addSeries=Nf;function oc(y){if(x.splice(y,1),ee){fe.values.splice(y,1),Ge.splice(y,1);let w=rt.splice(y,1)[0];Tn(null,w.firstChild),w.remove()}me&&(se.splice(y,1),at.splice(y,1)[0].remove(),Xt.splice(y,1),jn.splice(y,1)),Bn("delSeries",y)}i.delSeries=oc;let as=[!1,!1,!1,!1];function As(y,w){if(y._show=y.show,y.show){let I=y.side%2,D=S[y.scale];D==null&&(y.scale=I?x[1].scale:C,D=S[y.scale]);let W=D.time;y.size=vt(y.size),y.space=vt(y.space),y.rotate=vt(y.rotate),cr(y.incrs)&&y.incrs.forEach(ae=>{!ur.has(ae)&&ur.set(ae,q0(ae))}),y.incrs=vt(y.incrs||(D.distr==2?GM:W?m==1?WM:$M:Gr)),y.splits=vt(y.splits||(W&&D.distr==1?le:D.distr==3?bd:D.distr==4?hw:uw)),y.stroke=vt(y.stroke),y.grid.stroke=vt(y.grid.stroke),y.ticks.stroke=vt(y.ticks.stroke),y.border.stroke=vt(y.border.stroke);let Z=y.values;y.values=cr(Z)&&!cr(Z[0])?vt(Z):W?cr(Z)?b0(Y,x0(Z,G)):g0(Z)?ZM(Y,Z):Z||J:Z||cw,y.filter=vt(y.filter||(D.distr>=3&&D.log==10?pw:D.distr==3&&D.log==2?mw:H0)),y.font=F0(y.font),y.labelFont=F0(y.labelFont),y._size=y.size(i,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(as[w]=!0,y._el=Ii(jS,f))}}function Cs(y,w,I,D){let[W,Z,ae,de]=I,xe=w%2,Ne=0;return xe==0&&(de||Z)&&(Ne=w==0&&!W||w==2&&!ae?Rn(w0.size/3):0),xe==1&&(W||ae)&&(Ne=w==1&&!Z||w==3&&!de?Rn(A0.size/2):0),Ne}let Oa=i.padding=(n.padding||[Cs,Cs,Cs,Cs]).map(y=>vt(At(y,Cs))),Vi=i._padding=Oa.map((y,w)=>y(i,w,as,0)),cn,dn=null,pn=null,ls=s==1?x[0].idxs:null,fi=null,js=!1;function ka(y,w){if(e=y??[],i.data=i._data=e,s==2){cn=0;for(let I=1;I<x.length;I++)cn+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),fi=e[0],cn=fi.length;let I=e;if(B==2){I=e.slice();let D=I[0]=Array(cn);for(let W=0;W<cn;W++)D[W]=W}i._data=e=I}if(ut(!0),Bn("setData"),B==2&&(ye=!0),w!==!1){let I=L;I.auto(i,js)?Ba():tr(C,I.min,I.max),te=te||he.left>=0,pe=!0,Xn()}}i.setData=ka;function Ba(){js=!0;let y,w;s==1&&(cn>0?(dn=ls[0]=0,pn=ls[1]=cn-1,y=e[0][dn],w=e[0][pn],B==2?(y=dn,w=pn):y==w&&(B==3?[y,w]=kc(y,y,L.log,!1):B==4?[y,w]=Rd(y,y,L.log,!1):L.time?w=y+Rn(86400/m):[y,w]=Uc(y,w,Pd,!0))):(dn=ls[0]=y=null,pn=ls[1]=w=null)),tr(C,y,w)}let _o,Qs,vo,T,z,j,X,$,Te,Pe;function Ee(y,w,I,D,W,Z){y??=Qg,I??=Ld,D??="butt",W??=Qg,Z??="round",y!=_o&&(h.strokeStyle=_o=y),W!=Qs&&(h.fillStyle=Qs=W),w!=vo&&(h.lineWidth=vo=w),Z!=z&&(h.lineJoin=z=Z),D!=j&&(h.lineCap=j=D),I!=T&&h.setLineDash(T=I)}function Ie(y,w,I,D){w!=Qs&&(h.fillStyle=Qs=w),y!=X&&(h.font=X=y),I!=$&&(h.textAlign=$=I),D!=Te&&(h.textBaseline=Te=D)}function ze(y,w,I,D,W=0){if(D.length>0&&y.auto(i,js)&&(w==null||w.min==null)){let Z=At(dn,0),ae=At(pn,D.length-1),de=I.min==null?pM(D,Z,ae,W,y.distr==3):[I.min,I.max];y.min=Xi(y.min,I.min=de[0]),y.max=ii(y.max,I.max=de[1])}}let Qe={min:null,max:null};function dt(){for(let D in S){let W=S[D];H[D]==null&&(W.min==null||H[C]!=null&&W.auto(i,js))&&(H[D]=Qe)}for(let D in S){let W=S[D];H[D]==null&&W.from!=null&&H[W.from]!=null&&(H[D]=Qe)}H[C]!=null&&ut(!0);let y={};for(let D in H){let W=H[D];if(W!=null){let Z=y[D]=Bo(S[D],MM);if(W.min!=null)Mn(Z,W);else if(D!=C||s==2)if(cn==0&&Z.from==null){let ae=Z.range(i,null,null,D);Z.min=ae[0],Z.max=ae[1]}else Z.min=Vt,Z.max=-Vt}}if(cn>0){x.forEach((D,W)=>{if(s==1){let Z=D.scale,ae=H[Z];if(ae==null)return;let de=y[Z];if(W==0){let xe=de.range(i,de.min,de.max,Z);de.min=xe[0],de.max=xe[1],dn=qi(de.min,e[0]),pn=qi(de.max,e[0]),pn-dn>1&&(e[0][dn]<de.min&&dn++,e[0][pn]>de.max&&pn--),D.min=fi[dn],D.max=fi[pn]}else D.show&&D.auto&&ze(de,ae,D,e[W],D.sorted);D.idxs[0]=dn,D.idxs[1]=pn}else if(W>0&&D.show&&D.auto){let[Z,ae]=D.facets,de=Z.scale,xe=ae.scale,[Ne,Ue]=e[W],Oe=y[de],st=y[xe];Oe!=null&&ze(Oe,H[de],Z,Ne,Z.sorted),st!=null&&ze(st,H[xe],ae,Ue,ae.sorted),D.min=ae.min,D.max=ae.max}});for(let D in y){let W=y[D],Z=H[D];if(W.from==null&&(Z==null||Z.min==null)){let ae=W.range(i,W.min==Vt?null:W.min,W.max==-Vt?null:W.max,D);W.min=ae[0],W.max=ae[1]}}}for(let D in y){let W=y[D];if(W.from!=null){let Z=y[W.from];if(Z.min==null)W.min=W.max=null;else{let ae=W.range(i,Z.min,Z.max,D);W.min=ae[0],W.max=ae[1]}}}let w={},I=!1;for(let D in y){let W=y[D],Z=S[D];if(Z.min!=W.min||Z.max!=W.max){Z.min=W.min,Z.max=W.max;let ae=Z.distr;Z._min=ae==3?Ds(Z.min):ae==4?fd(Z.min,Z.asinh):ae==100?Z.fwd(Z.min):Z.min,Z._max=ae==3?Ds(Z.max):ae==4?fd(Z.max,Z.asinh):ae==100?Z.fwd(Z.max):Z.max,w[D]=I=!0}}if(I){x.forEach((D,W)=>{s==2?W>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)ye=!0,Bn("setScale",D);me&&he.left>=0&&(te=pe=!0)}for(let D in H)H[D]=null}function Be(y){let w=xd(dn-1,0,cn-1),I=xd(pn+1,0,cn-1);for(;y[w]==null&&w>0;)w--;for(;y[I]==null&&I<cn-1;)I++;return[w,I]}function pt(){if(cn>0){let y=x.some(w=>w._focus)&&Pe!=ke.alpha;y&&(h.globalAlpha=Pe=ke.alpha),x.forEach((w,I)=>{if(I>0&&w.show&&(tn(I,!1),tn(I,!0),w._paths==null)){let D=Pe;Pe!=w.alpha&&(h.globalAlpha=Pe=w.alpha);let W=s==2?[0,e[I][0].length-1]:Be(e[I]);w._paths=w.paths(i,I,W[0],W[1]),Pe!=D&&(h.globalAlpha=Pe=D)}}),x.forEach((w,I)=>{if(I>0&&w.show){let D=Pe;Pe!=w.alpha&&(h.globalAlpha=Pe=w.alpha),w._paths!=null&&Dt(I,!1);{let W=w._paths!=null?w._paths.gaps:null,Z=w.points.show(i,I,dn,pn,W),ae=w.points.filter(i,I,Z,W);(Z||ae)&&(w.points._paths=w.points.paths(i,I,dn,pn,ae),Dt(I,!0))}Pe!=D&&(h.globalAlpha=Pe=D),Bn("drawSeries",I)}}),y&&(h.globalAlpha=Pe=1)}}function tn(y,w){let I=w?x[y].points:x[y];I._stroke=I.stroke(i,y),I._fill=I.fill(i,y)}function Dt(y,w){let I=w?x[y].points:x[y],{stroke:D,fill:W,clip:Z,flags:ae,_stroke:de=I._stroke,_fill:xe=I._fill,_width:Ne=I.width}=I._paths;Ne=Gt(Ne*Rt,3);let Ue=null,Oe=Ne%2/2;w&&xe==null&&(xe=Ne>0?"#fff":de);let st=I.pxAlign==1&&Oe>0;if(st&&h.translate(Oe,Oe),!w){let Ct=R-Ne/2,Tt=M-Ne/2,gt=q+Ne,Ze=ue+Ne;Ue=new Path2D,Ue.rect(Ct,Tt,gt,Ze)}w?Fe(de,Ne,I.dash,I.cap,xe,D,W,ae,Z):Nt(y,de,Ne,I.dash,I.cap,xe,D,W,ae,Ue,Z),st&&h.translate(-Oe,-Oe)}function Nt(y,w,I,D,W,Z,ae,de,xe,Ne,Ue){let Oe=!1;xe!=0&&P.forEach((st,Ct)=>{if(st.series[0]==y){let Tt=x[st.series[1]],gt=e[st.series[1]],Ze=(Tt._paths||al).band;cr(Ze)&&(Ze=st.dir==1?Ze[0]:Ze[1]);let qe,Kt=null;Tt.show&&Ze&&gM(gt,dn,pn)?(Kt=st.fill(i,Ct)||Z,qe=Tt._paths.clip):Ze=null,Fe(w,I,D,W,Kt,ae,de,xe,Ne,Ue,qe,Ze),Oe=!0}}),Oe||Fe(w,I,D,W,Z,ae,de,xe,Ne,Ue)}let En=zo|Md;function Fe(y,w,I,D,W,Z,ae,de,xe,Ne,Ue,Oe){Ee(y,w,I,D,W),(xe||Ne||Oe)&&(h.save(),xe&&h.clip(xe),Ne&&h.clip(Ne)),Oe?(de&En)==En?(h.clip(Oe),Ue&&h.clip(Ue),_t(W,ae),vn(y,Z,w)):de&Md?(_t(W,ae),h.clip(Oe),vn(y,Z,w)):de&zo&&(h.save(),h.clip(Oe),Ue&&h.clip(Ue),_t(W,ae),h.restore(),vn(y,Z,w)):(_t(W,ae),vn(y,Z,w)),(xe||Ne||Oe)&&h.restore()}function vn(y,w,I){I>0&&(w instanceof Map?w.forEach((D,W)=>{h.strokeStyle=_o=W,h.stroke(D)}):w!=null&&y&&h.stroke(w))}function _t(y,w){w instanceof Map?w.forEach((I,D)=>{h.fillStyle=Qs=D,h.fill(I)}):w!=null&&y&&h.fill(w)}function Rs(y,w,I,D){let W=A[y],Z;if(D<=0)Z=[0,0];else{let ae=W._space=W.space(i,y,w,I,D),de=W._incrs=W.incrs(i,y,w,I,D,ae);Z=Ow(w,I,de,D,ae)}return W._found=Z}function yn(y,w,I,D,W,Z,ae,de,xe,Ne){let Ue=ae%2/2;b==1&&h.translate(Ue,Ue),Ee(de,ae,xe,Ne,de),h.beginPath();let Oe,st,Ct,Tt,gt=W+(D==0||D==3?-Z:Z);I==0?(st=W,Tt=gt):(Oe=W,Ct=gt);for(let Ze=0;Ze<y.length;Ze++)w[Ze]!=null&&(I==0?Oe=Ct=y[Ze]:st=Tt=y[Ze],h.moveTo(Oe,st),h.lineTo(Ct,Tt));h.stroke(),b==1&&h.translate(-Ue,-Ue)}function yo(y){let w=!0;return A.forEach((I,D)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,ut(!1));return}else I._show||(w=!1,I._show=!0,ut(!1));let Z=I.side,ae=Z%2,{min:de,max:xe}=W,[Ne,Ue]=Rs(D,de,xe,ae==0?O:Re);if(Ue==0)return;let Oe=W.distr==2,st=I._splits=I.splits(i,D,de,xe,Ne,Ue,Oe),Ct=W.distr==2?st.map(qe=>fi[qe]):st,Tt=W.distr==2?fi[st[1]]-fi[st[0]]:Ne,gt=I._values=I.values(i,I.filter(i,Ct,D,Ue,Tt),D,Ue,Tt);I._rotate=Z==2?I.rotate(i,gt,D,Ue):0;let Ze=I._size;I._size=Li(I.size(i,gt,D,y)),Ze!=null&&I._size!=Ze&&(w=!1)}),w}function cs(y){let w=!0;return Oa.forEach((I,D)=>{let W=I(i,D,as,y);W!=Vi[D]&&(w=!1),Vi[D]=W}),w}function Ps(){for(let y=0;y<A.length;y++){let w=A[y];if(!w.show||!w._show)continue;let I=w.side,D=I%2,W,Z,ae=w.stroke(i,y),de=I==0||I==3?-1:1,[xe,Ne]=w._found;if(w.label!=null){let ti=w.labelGap*de,mi=Rn((w._lpos+ti)*Rt);Ie(w.labelFont[0],ae,"center",I==2?"top":jg),h.save(),D==1?(W=Z=0,h.translate(mi,Rn(M+ue/2)),h.rotate((I==3?-Dc:Dc)/2)):(W=Rn(R+q/2),Z=mi);let Or=V0(w.label)?w.label(i,y,xe,Ne):w.label;h.fillText(Or,W,Z),h.restore()}if(Ne==0)continue;let Ue=S[w.scale],Oe=D==0?q:ue,st=D==0?R:M,Ct=w._splits,Tt=Ue.distr==2?Ct.map(ti=>fi[ti]):Ct,gt=Ue.distr==2?fi[Ct[1]]-fi[Ct[0]]:xe,Ze=w.ticks,qe=w.border,Kt=Ze.show?Ze.size:0,hn=Rn(Kt*Rt),zn=Rn((w.alignTo==2?w._size-Kt-w.gap:w.gap)*Rt),kt=w._rotate*-Dc/180,fn=g(w._pos*Rt),di=(hn+zn)*de,ei=fn+di;Z=D==0?ei:0,W=D==1?ei:0;let Ri=w.font[0],Gi=w.align==1?No:w.align==2?cd:kt>0?No:kt<0?cd:D==0?"center":I==3?cd:No,fs=kt||D==1?"middle":I==2?"top":jg;Ie(Ri,ae,Gi,fs);let pi=w.font[1]*w.lineGap,Pi=Ct.map(ti=>g(a(ti,Ue,Oe,st))),Hi=w._values;for(let ti=0;ti<Hi.length;ti++){let mi=Hi[ti];if(mi!=null){D==0?W=Pi[ti]:Z=Pi[ti],mi=""+mi;let Or=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let ni=0;ni<Or.length;ni++){let fg=Or[ni];kt?(h.save(),h.translate(W,Z+ni*pi),h.rotate(kt),h.fillText(fg,0,0),h.restore()):h.fillText(fg,W,Z+ni*pi)}}}Ze.show&&yn(Pi,Ze.filter(i,Tt,y,Ne,gt),D,I,fn,hn,Gt(Ze.width*Rt,3),Ze.stroke(i,y),Ze.dash,Ze.cap);let ds=w.grid;ds.show&&yn(Pi,ds.filter(i,Tt,y,Ne,gt),D,D==0?2:1,D==0?M:R,D==0?ue:q,Gt(ds.width*Rt,3),ds.stroke(i,y),ds.dash,ds.cap),qe.show&&yn([fn],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:q,Gt(qe.width*Rt,3),qe.stroke(i,y),qe.dash,qe.cap)}Bn("drawAxes")}function ut(y){x.forEach((w,I)=>{I>0&&(w._paths=null,y&&(s==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let un=!1,Qn=!1,Ut=[];function xn(){Qn=!1;for(let y=0;y<Ut.length;y++)Bn(...Ut[y]);Ut.length=0}function Xn(){un||(PM(Ym),un=!0)}function ac(y,w=!1){un=!0,Qn=w,y(i),Ym(),w&&Ut.length>0&&queueMicrotask(xn)}i.batch=ac;function Ym(){if(oe&&(dt(),oe=!1),ye&&(we(),ye=!1),_e){if(Zt(p,No,Ke),Zt(p,"top",ot),Zt(p,il,O),Zt(p,sl,Re),Zt(_,No,Ke),Zt(_,"top",ot),Zt(_,il,O),Zt(_,sl,Re),Zt(f,il,ln),Zt(f,sl,_n),u.width=Rn(ln*Rt),u.height=Rn(_n*Rt),A.forEach(({_el:y,_show:w,_size:I,_pos:D,side:W})=>{if(y!=null)if(w){let Z=W===3||W===0?I:0,ae=W%2==1;Zt(y,ae?"left":"top",D-Z),Zt(y,ae?"width":"height",I),Zt(y,ae?"top":"left",ae?ot:Ke),Zt(y,ae?"height":"width",ae?Re:O),vd(y,Hr)}else gi(y,Hr)}),_o=Qs=vo=z=j=X=$=Te=T=null,Pe=1,Ga(!0),Ke!=Me||ot!=zt||O!=Ve||Re!=Xe){ut(!1);let y=O/Ve,w=Re/Xe;if(me&&!te&&he.left>=0){he.left*=y,he.top*=w,xo&&ps(xo,Rn(he.left),0,O,Re),bo&&ps(bo,0,Rn(he.top),O,Re);for(let I=0;I<at.length;I++){let D=at[I];D!=null&&(Xt[I]*=y,jn[I]*=w,ps(D,Li(Xt[I]),Li(jn[I]),O,Re))}}if(Yt.show&&!ie&&Yt.left>=0&&Yt.width>0){Yt.left*=y,Yt.width*=y,Yt.top*=w,Yt.height*=w;for(let I in zf)Zt(wo,I,Yt[I])}Me=Ke,zt=ot,Ve=O,Xe=Re}Bn("setSize"),_e=!1}ln>0&&_n>0&&(h.clearRect(0,0,u.width,u.height),Bn("drawClear"),E.forEach(y=>y()),Bn("draw")),Yt.show&&ie&&(lc(Yt),ie=!1),me&&te&&(Fr(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(kf(),pe=!1),l||(l=!0,i.status=1,Bn("ready")),js=!1,un=!1}i.redraw=(y,w)=>{ye=w||!1,y!==!1?tr(C,L.min,L.max):Xn()};function Uf(y,w){let I=S[y];if(I.from==null){if(cn==0){let D=I.range(i,w.min,w.max,y);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(cn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==C&&I.distr==2&&cn>0&&(w.min=qi(w.min,e[0]),w.max=qi(w.max,e[0]),w.min==w.max&&w.max++),H[y]=w,oe=!0,Xn()}}i.setScale=Uf;let Ff,Of,xo,bo,Km,Zm,So,Mo,Jm,jm,$t,Qt,er=!1,Hn=he.drag,On=Hn.x,kn=Hn.y;me&&(he.x&&(Ff=Ii(eM,_)),he.y&&(Of=Ii(tM,_)),L.ori==0?(xo=Ff,bo=Of):(xo=Of,bo=Ff),$t=he.left,Qt=he.top);let Yt=i.select=Mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),wo=Yt.show?Ii(QS,Yt.over?_:p):null;function lc(y,w){if(Yt.show){for(let I in y)Yt[I]=y[I],I in zf&&Zt(wo,I,y[I]);w!==!1&&Bn("setSelect")}}i.setSelect=lc;function Jb(y){if(x[y].show)ee&&vd(rt[y],Hr);else if(ee&&gi(rt[y],Hr),me){let I=Ce?at[0]:at[y];I!=null&&ps(I,-10,-10,O,Re)}}function tr(y,w,I){Uf(y,{min:w,max:I})}function us(y,w,I,D){w.focus!=null&&nS(y),w.show!=null&&x.forEach((W,Z)=>{Z>0&&(y==Z||y==null)&&(W.show=w.show,Jb(Z),s==2?(tr(W.facets[0].scale,null,null),tr(W.facets[1].scale,null,null)):tr(W.scale,null,null),Xn())}),I!==!1&&Bn("setSeries",y,w),D&&Ha("setSeries",i,y,w)}i.setSeries=us;function jb(y,w){Mn(P[y],w)}function Qb(y,w){y.fill=vt(y.fill||null),y.dir=At(y.dir,-1),w=w??P.length,P.splice(w,0,y)}function eS(y){y==null?P.length=0:P.splice(y,1)}i.addBand=Qb,i.setBand=jb,i.delBand=eS;function tS(y,w){x[y].alpha=w,me&&at[y]!=null&&(at[y].style.opacity=w),ee&&rt[y]&&(rt[y].style.opacity=w)}let Is,nr,Ur,To={focus:!0};function nS(y){if(y!=Ur){let w=y==null,I=ke.alpha!=1;x.forEach((D,W)=>{if(s==1||W>0){let Z=w||W==0||W==y;D._focus=w?null:Z,I&&tS(W,Z?1:ke.alpha)}}),Ur=y,I&&Xn()}}ee&&je&&St(n0,Ae,y=>{he._lock||(Je(y),Ur!=null&&us(null,To,!0,bn.setSeries))});function hs(y,w,I){let D=S[w];I&&(y=y/Rt-(D.ori==1?ot:Ke));let W=O;D.ori==1&&(W=Re,y=W-y),D.dir==-1&&(y=W-y);let Z=D._min,ae=D._max,de=y/W,xe=Z+(ae-Z)*de,Ne=D.distr;return Ne==3?Oo(10,xe):Ne==4?vM(xe,D.asinh):Ne==100?D.bwd(xe):xe}function iS(y,w){let I=hs(y,C,w);return qi(I,e[0],dn,pn)}i.valToIdx=y=>qi(y,e[0]),i.posToIdx=iS,i.posToVal=hs,i.valToPos=(y,w,I)=>S[w].ori==0?r(y,S[w],I?q:O,I?R:0):o(y,S[w],I?ue:Re,I?M:0),i.setCursor=(y,w,I)=>{$t=y.left,Qt=y.top,Fr(null,w,I)};function Qm(y,w){Zt(wo,No,Yt.left=y),Zt(wo,il,Yt.width=w)}function eg(y,w){Zt(wo,"top",Yt.top=y),Zt(wo,sl,Yt.height=w)}let za=L.ori==0?Qm:eg,Va=L.ori==1?Qm:eg;function sS(){if(ee&&fe.live)for(let y=s==2?1:0;y<x.length;y++){if(y==0&&ct)continue;let w=fe.values[y],I=0;for(let D in w)Ge[y][I++].firstChild.nodeValue=w[D]}}function kf(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((I,D)=>{se[D]=I}):SM(y.idx)||se.fill(y.idx),fe.idx=se[0]),ee&&fe.live){for(let I=0;I<x.length;I++)(I>0||s==1&&!ct)&&rS(I,se[I]);sS()}pe=!1,w!==!1&&Bn("setLegend")}i.setLegend=kf;function rS(y,w){let I=x[y],D=y==0&&B==2?fi:e[y],W;ct?W=I.values(i,y,w)??it:(W=I.value(i,w==null?null:D[w],y,w),W=W==null?it:{_:W}),fe.values[y]=W}function Fr(y,w,I){Jm=$t,jm=Qt,[$t,Qt]=he.move(i,$t,Qt),he.left=$t,he.top=Qt,me&&(xo&&ps(xo,Rn($t),0,O,Re),bo&&ps(bo,0,Rn(Qt),O,Re));let D,W=dn>pn;Is=Vt,nr=null;let Z=L.ori==0?O:Re,ae=L.ori==1?O:Re;if($t<0||cn==0||W){D=he.idx=null;for(let de=0;de<x.length;de++){let xe=at[de];xe!=null&&ps(xe,-10,-10,O,Re)}je&&us(null,To,!0,y==null&&bn.setSeries),fe.live&&(se.fill(D),pe=!0)}else{let de,xe,Ne;s==1&&(de=L.ori==0?$t:Qt,xe=hs(de,C),D=he.idx=qi(xe,e[0],dn,pn),Ne=V(e[0][D],L,Z,0));let Ue=-10,Oe=-10,st=0,Ct=0,Tt=!0,gt="",Ze="";for(let qe=s==2?1:0;qe<x.length;qe++){let Kt=x[qe],hn=se[qe],zn=hn==null?null:s==1?e[qe][hn]:e[qe][1][hn],kt=he.dataIdx(i,qe,D,xe),fn=kt==null?null:s==1?e[qe][kt]:e[qe][1][kt];if(pe=pe||fn!=zn||kt!=hn,se[qe]=kt,qe>0&&Kt.show){let di=kt==null?-10:kt==D?Ne:V(s==1?e[0][kt]:e[qe][0][kt],L,Z,0),ei=fn==null?-10:U(fn,s==1?S[Kt.scale]:S[Kt.facets[1].scale],ae,0);if(je&&fn!=null){let Ri=L.ori==1?$t:Qt,Gi=Pn(ke.dist(i,qe,kt,ei,Ri));if(Gi<Is){let fs=ke.bias;if(fs!=0){let pi=hs(Ri,Kt.scale),Pi=fn>=0?1:-1,Hi=pi>=0?1:-1;Hi==Pi&&(Hi==1?fs==1?fn>=pi:fn<=pi:fs==1?fn<=pi:fn>=pi)&&(Is=Gi,nr=qe)}else Is=Gi,nr=qe}}if(pe||Ce){let Ri,Gi;L.ori==0?(Ri=di,Gi=ei):(Ri=ei,Gi=di);let fs,pi,Pi,Hi,ds,ti,mi=!0,Or=ce.bbox;if(Or!=null){mi=!1;let ni=Or(i,qe);Pi=ni.left,Hi=ni.top,fs=ni.width,pi=ni.height}else Pi=Ri,Hi=Gi,fs=pi=ce.size(i,qe);if(ti=ce.fill(i,qe),ds=ce.stroke(i,qe),Ce)qe==nr&&Is<=ke.prox&&(Ue=Pi,Oe=Hi,st=fs,Ct=pi,Tt=mi,gt=ti,Ze=ds);else{let ni=at[qe];ni!=null&&(Xt[qe]=Pi,jn[qe]=Hi,c0(ni,fs,pi,mi),a0(ni,ti,ds),ps(ni,Li(Pi),Li(Hi),O,Re))}}}}if(Ce){let qe=ke.prox,Kt=Ur==null?Is<=qe:Is>qe||nr!=Ur;if(pe||Kt){let hn=at[0];hn!=null&&(Xt[0]=Ue,jn[0]=Oe,c0(hn,st,Ct,Tt),a0(hn,gt,Ze),ps(hn,Li(Ue),Li(Oe),O,Re))}}}if(Yt.show&&er)if(y!=null){let[de,xe]=bn.scales,[Ne,Ue]=bn.match,[Oe,st]=y.cursor.sync.scales,Ct=y.cursor.drag;if(On=Ct._x,kn=Ct._y,On||kn){let{left:Tt,top:gt,width:Ze,height:qe}=y.select,Kt=y.scales[Oe].ori,hn=y.posToVal,zn,kt,fn,di,ei,Ri=de!=null&&Ne(de,Oe),Gi=xe!=null&&Ue(xe,st);Ri&&On?(Kt==0?(zn=Tt,kt=Ze):(zn=gt,kt=qe),fn=S[de],di=V(hn(zn,Oe),fn,Z,0),ei=V(hn(zn+kt,Oe),fn,Z,0),za(Xi(di,ei),Pn(ei-di))):za(0,Z),Gi&&kn?(Kt==1?(zn=Tt,kt=Ze):(zn=gt,kt=qe),fn=S[xe],di=U(hn(zn,st),fn,ae,0),ei=U(hn(zn+kt,st),fn,ae,0),Va(Xi(di,ei),Pn(ei-di))):Va(0,ae)}else Vf()}else{let de=Pn(Jm-Km),xe=Pn(jm-Zm);if(L.ori==1){let st=de;de=xe,xe=st}On=Hn.x&&de>=Hn.dist,kn=Hn.y&&xe>=Hn.dist;let Ne=Hn.uni;Ne!=null?On&&kn&&(On=de>=Ne,kn=xe>=Ne,!On&&!kn&&(xe>de?kn=!0:On=!0)):Hn.x&&Hn.y&&(On||kn)&&(On=kn=!0);let Ue,Oe;On&&(L.ori==0?(Ue=So,Oe=$t):(Ue=Mo,Oe=Qt),za(Xi(Ue,Oe),Pn(Oe-Ue)),kn||Va(0,ae)),kn&&(L.ori==1?(Ue=So,Oe=$t):(Ue=Mo,Oe=Qt),Va(Xi(Ue,Oe),Pn(Oe-Ue)),On||za(0,Z)),!On&&!kn&&(za(0,0),Va(0,0))}if(Hn._x=On,Hn._y=kn,y==null){if(I){if(hg!=null){let[de,xe]=bn.scales;bn.values[0]=de!=null?hs(L.ori==0?$t:Qt,de):null,bn.values[1]=xe!=null?hs(L.ori==1?$t:Qt,xe):null}Ha(ud,i,$t,Qt,O,Re,D)}if(je){let de=I&&bn.setSeries,xe=ke.prox;Ur==null?Is<=xe&&us(nr,To,!0,de):Is>xe?us(null,To,!0,de):nr!=Ur&&us(nr,To,!0,de)}}pe&&(fe.idx=D,kf()),w!==!1&&Bn("setCursor")}let ir=null;Object.defineProperty(i,"rect",{get(){return ir==null&&Ga(!1),ir}});function Ga(y=!1){y?ir=null:(ir=_.getBoundingClientRect(),Bn("syncRect",ir))}function tg(y,w,I,D,W,Z,ae){he._lock||er&&y!=null&&y.movementX==0&&y.movementY==0||(Bf(y,w,I,D,W,Z,ae,!1,y!=null),y!=null?Fr(null,!0,!0):Fr(w,!0,!1))}function Bf(y,w,I,D,W,Z,ae,de,xe){if(ir==null&&Ga(!1),Je(y),y!=null)I=y.clientX-ir.left,D=y.clientY-ir.top;else{if(I<0||D<0){$t=-10,Qt=-10;return}let[Ne,Ue]=bn.scales,Oe=w.cursor.sync,[st,Ct]=Oe.values,[Tt,gt]=Oe.scales,[Ze,qe]=bn.match,Kt=w.axes[0].side%2==1,hn=L.ori==0?O:Re,zn=L.ori==1?O:Re,kt=Kt?Z:W,fn=Kt?W:Z,di=Kt?D:I,ei=Kt?I:D;if(Tt!=null?I=Ze(Ne,Tt)?a(st,S[Ne],hn,0):-10:I=hn*(di/kt),gt!=null?D=qe(Ue,gt)?a(Ct,S[Ue],zn,0):-10:D=zn*(ei/fn),L.ori==1){let Ri=I;I=D,D=Ri}}xe&&(w==null||w.cursor.event.type==ud)&&((I<=1||I>=O-1)&&(I=Vr(I,O)),(D<=1||D>=Re-1)&&(D=Vr(D,Re))),de?(Km=I,Zm=D,[So,Mo]=he.move(i,I,D)):($t=I,Qt=D)}let zf={width:0,height:0,left:0,top:0};function Vf(){lc(zf,!1)}let ng,ig,sg,rg;function og(y,w,I,D,W,Z,ae){er=!0,On=kn=Hn._x=Hn._y=!1,Bf(y,w,I,D,W,Z,ae,!0,!1),y!=null&&(St(hd,gd,ag,!1),Ha(e0,i,So,Mo,O,Re,null));let{left:de,top:xe,width:Ne,height:Ue}=Yt;ng=de,ig=xe,sg=Ne,rg=Ue}function ag(y,w,I,D,W,Z,ae){er=Hn._x=Hn._y=!1,Bf(y,w,I,D,W,Z,ae,!1,!0);let{left:de,top:xe,width:Ne,height:Ue}=Yt,Oe=Ne>0||Ue>0,st=ng!=de||ig!=xe||sg!=Ne||rg!=Ue;if(Oe&&st&&lc(Yt),Hn.setScale&&Oe&&st){let Ct=de,Tt=Ne,gt=xe,Ze=Ue;if(L.ori==1&&(Ct=xe,Tt=Ue,gt=de,Ze=Ne),On&&tr(C,hs(Ct,C),hs(Ct+Tt,C)),kn)for(let qe in S){let Kt=S[qe];qe!=C&&Kt.from==null&&Kt.min!=Vt&&tr(qe,hs(gt+Ze,qe),hs(gt,qe))}Vf()}else he.lock&&(he._lock=!he._lock,Fr(w,!0,y!=null));y!=null&&(Tn(hd,gd),Ha(hd,i,$t,Qt,O,Re,null))}function oS(y,w,I,D,W,Z,ae){if(he._lock)return;Je(y);let de=er;if(er){let xe=!0,Ne=!0,Ue=10,Oe,st;L.ori==0?(Oe=On,st=kn):(Oe=kn,st=On),Oe&&st&&(xe=$t<=Ue||$t>=O-Ue,Ne=Qt<=Ue||Qt>=Re-Ue),Oe&&xe&&($t=$t<So?0:O),st&&Ne&&(Qt=Qt<Mo?0:Re),Fr(null,!0,!0),er=!1}$t=-10,Qt=-10,se.fill(null),Fr(null,!0,!0),de&&(er=de)}function lg(y,w,I,D,W,Z,ae){he._lock||(Je(y),Ba(),Vf(),y!=null&&Ha(i0,i,$t,Qt,O,Re,null))}function cg(){A.forEach(kw),F(i.width,i.height,!0)}Wr(Nc,Fo,cg);let Eo={};Eo.mousedown=og,Eo.mousemove=tg,Eo.mouseup=ag,Eo.dblclick=lg,Eo.setSeries=(y,w,I,D)=>{let W=bn.match[2];I=W(i,w,I),I!=-1&&us(I,D,!0,!1)},me&&(St(e0,_,og),St(ud,_,tg),St(t0,_,y=>{Je(y),Ga(!1)}),St(n0,_,oS),St(i0,_,lg),wd.add(i),i.syncRect=Ga);let cc=i.hooks=n.hooks||{};function Bn(y,w,I){Qn?Ut.push([y,w,I]):y in cc&&cc[y].forEach(D=>{D.call(null,i,w,I)})}(n.plugins||[]).forEach(y=>{for(let w in y.hooks)cc[w]=(cc[w]||[]).concat(y.hooks[w])});let ug=(y,w,I)=>I,bn=Mn({key:null,setSeries:!1,filters:{pub:p0,sub:p0},scales:[C,x[1]?x[1].scale:null],match:[m0,m0,ug],values:[null,null]},he.sync);bn.match.length==2&&bn.match.push(ug),he.sync=bn;let hg=bn.key,Gf=h_(hg);function Ha(y,w,I,D,W,Z,ae){bn.filters.pub(y,w,I,D,W,Z,ae)&&Gf.pub(y,w,I,D,W,Z,ae)}Gf.sub(i);function aS(y,w,I,D,W,Z,ae){bn.filters.sub(y,w,I,D,W,Z,ae)&&Eo[y](null,w,I,D,W,Z,ae)}i.pub=aS;function lS(){Gf.unsub(i),wd.delete(i),Fn.clear(),yd(Nc,Fo,cg),c.remove(),Ae?.remove(),Bn("destroy")}i.destroy=lS;function Hf(){Bn("init",n,e),ka(e||n.data,!1),H[C]?Uf(C,H[C]):Ba(),ie=Yt.show&&(Yt.width>0||Yt.height>0),te=pe=!0,F(n.width,n.height)}return x.forEach(go),A.forEach(As),t?t instanceof HTMLElement?(t.appendChild(c),Hf()):t(i,Hf):Hf(),i}nn.assign=Mn;nn.fmtNum=Id;nn.rangeNum=Uc;nn.rangeLog=kc;nn.rangeAsinh=Rd;nn.orient=Xr;nn.pxRatio=Rt;nn.join=RM;nn.fmtDate=Dd,nn.tzDate=zM;nn.sync=h_;{nn.addGap=Sw,nn.clipGaps=Vc;let n=nn.paths={points:__};n.linear=y_,n.stepped=Tw,n.bars=Ew,n.spline=Cw}function $e(n){let e=document.querySelector(".haptonic")??document.documentElement;return getComputedStyle(e).getPropertyValue(`--${n}`).trim()}function ms(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}var Bw=240;function hr(n){return Math.max(n.clientWidth,Bw)}function fr(n,e,t,i){let s=[...i,ms(()=>n.redraw(!1,!0))],r=new ResizeObserver(()=>n.setSize(t()));return r.observe(e),()=>{r.disconnect();for(let o of s)o();n.destroy()}}function Wo(n,e){n.over.addEventListener("click",({clientX:t,clientY:i})=>{let s=n.over.getBoundingClientRect();e(t-s.left,i-s.top)})}function qo({ctx:n,bbox:e},t){n.save(),n.beginPath(),n.rect(e.left,e.top,e.width,e.height),n.clip(),t(),n.restore()}var zw=320,Vw=.72,Gw=40;function M_({diagram:n,choice:e}){let t=Et(null);return Bt(()=>{let i=t.current;if(i!==null)return Hw(i,n,e)},[n,e]),d("div",{class:"curves",ref:t})}function Hw(n,e,t){let i=()=>t.unit.peek().factor,s=e.branches(),r=()=>[Array.from(e.distance),...s.map(h=>h.map(f=>f===null?null:f/i()))],o=()=>{let h=hr(n);return{width:h,height:Math.max(zw,Math.min(Vw*h,.7*innerHeight))}},a=e.corners.map(({row:h})=>e.distance[h]??0),l={stroke:()=>$e("ink"),ticks:{stroke:()=>$e("rule")},grid:{}},c=new nn({...o(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(h,f,p)=>[f,p]},y:{range:(h,f,p)=>f===null?[0,1]:[f<.2*p?0:f,p]}},axes:[{...l,splits:()=>a,values:()=>e.corners.map(({label:h})=>h),font:"15px system-ui, sans-serif",grid:{stroke:()=>$e("rule"),width:1}},{...l,size:48,font:"13px system-ui, sans-serif",grid:{show:!1},label:"frequency",labelFont:"14px system-ui, sans-serif",labelSize:24,values:(h,f)=>f.map(p=>`${Number(p.toPrecision(6))}`)}],series:[{},...s.map(()=>({stroke:()=>$e("ink"),width:1.6,points:{show:!1}}))],hooks:{drawClear:[h=>qo(h,()=>qw(h,e,i()))],draw:[h=>$w(h,e,t)]}},r(),n),u=()=>c.setScale("y",{min:0,max:e.top/i()});return u(),Wo(c,(h,f)=>{let p=Ww(c,e,i(),h,f);p!==void 0&&(t.point.value=p)}),fr(c,n,o,[lt(()=>{let h=c.axes[1];h!==void 0&&(h.label=lr("frequency",t.unit.value)),c.setData(r(),!0),u()}),lt(()=>{let h=e.at(t.point.value)/i();h>(c.scales.y?.max??1/0)?c.setScale("y",{min:0,max:1.03*h}):c.redraw(!1,!1)})])}function Ww(n,e,t,i,s){let[r,o]=[void 0,Gw];for(let a=0;a<e.rows;a++){let l=n.valToPos(e.distance[a]??0,"x")-i;if(!(Math.abs(l)>o))for(let c=0;c<e.bands;c++){let u=Math.hypot(l,n.valToPos(e.at({row:a,band:c})/t,"y")-s);u<o&&([r,o]=[{row:a,band:c},u])}}return r}function qw(n,e,t){let{ctx:i,bbox:s}=n;for(let r of e.gaps){let o=n.valToPos(r.upper/t,"y",!0),a=n.valToPos(r.lower/t,"y",!0)-o;r.complete?(i.fillStyle=$e("gap"),i.fillRect(s.left,o,s.width,a)):r.waves!=="all"&&Xw(i,s.left,o,s.width,a)}if(e.carrier!==void 0){let r=n.valToPos(e.carrier/t,"y",!0);i.strokeStyle=$e("carrier"),i.lineWidth=1.5*devicePixelRatio,i.setLineDash([7*devicePixelRatio,5*devicePixelRatio]),i.beginPath(),i.moveTo(s.left,r),i.lineTo(s.left+s.width,r),i.stroke()}}function Xw(n,e,t,i,s){let r=12*devicePixelRatio;n.save(),n.beginPath(),n.rect(e,t,i,s),n.clip(),n.beginPath();for(let o=e-s;o<e+i;o+=r)n.moveTo(o,t+s),n.lineTo(o+s,t);n.strokeStyle=$e("gap"),n.lineWidth=2*devicePixelRatio,n.stroke(),n.restore()}function $w(n,e,t){let{ctx:i}=n,s=t.point.peek(),r=n.valToPos(e.distance[s.row]??0,"x",!0),o=n.valToPos(e.at(s)/t.unit.peek().factor,"y",!0);i.save(),i.beginPath(),i.arc(r,o,6*devicePixelRatio,0,2*Math.PI),i.fillStyle=$e("accent"),i.strokeStyle=$e("paper"),i.lineWidth=2*devicePixelRatio,i.fill(),i.stroke(),i.restore()}var qc=class{constructor(e){this.data=e;this.distance=e.values("distance"),this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),[this.rows=0,this.bands=0]=e.shape("frequency"),this.names=e.parsed("character_names");let t=e.parsed("path_labels"),i=e.parsed("path_corners");this.corners=t.map((r,o)=>({label:r,row:i[o]??0}));let s=e.header.attrs.carrier_hz;this.carrier=typeof s=="number"?s:void 0,this.top=Number(e.header.extra.top),this.units=Ac(e),this.gaps=this.readGaps()}data;distance;frequency;error;rows;bands;gaps;corners;carrier;top;units;names;branches(){let e=this.data.values("branch"),t=new Map;return e.forEach((i,s)=>{let r=t.get(i)??Array(this.rows).fill(null);r[Math.floor(s/this.bands)]=this.frequency[s]??null,t.set(i,r)}),[...t.values()]}at({row:e,band:t}){return this.frequency[e*this.bands+t]??NaN}errorAt({row:e,band:t}){return this.error[e*this.bands+t]??NaN}nature({row:e,band:t}){return this.names[this.data.values("character")[e*this.bands+t]??-1]??""}parity({row:e,band:t}){let i=e*this.bands+t,s=[["even","odd"][w_(this.data.values("parity")[i])],["symmetric","antisymmetric"][w_(this.data.values("middle_parity")[i])]],[r,o]=s;return[r&&`${r} under the mirror of the path`,o&&`${o} about the plate's middle plane`].filter(Boolean).join(", ")}velocity({row:e,band:t}){let i=this.data.values("group_velocity"),s=2*(e*this.bands+t),[r,o]=[i[s]??NaN,i[s+1]??NaN];return Number.isFinite(r)&&Number.isFinite(o)?[r,o]:void 0}phases(e){let t=this.data.values("kappa");return[t[2*e]??0,t[2*e+1]??0]}place(e){let t=this.corners.find(a=>a.row===e);if(t!==void 0)return t.label;let i=this.corners.findIndex(a=>a.row>e),[s,r]=[this.corners[i-1],this.corners[i]];if(s===void 0||r===void 0)return"";let o=(e-s.row)/(r.row-s.row);return`${Number(o.toFixed(3))} of ${s.label}-${r.label}`}belowGap(e){let t=e.below-1,i=0;for(let s=1;s<this.rows;s++)this.at({row:s,band:t})>this.at({row:i,band:t})&&(i=s);return{row:i,band:t}}readGaps(){if(!this.data.has("gap_below"))return[];let e=t=>this.data.values(t);return Array.from(e("gap_below"),(t,i)=>({below:t,lower:e("gap_lower")[i]??NaN,upper:e("gap_upper")[i]??NaN,lowerError:e("gap_lower_error")[i]??NaN,upperError:e("gap_upper_error")[i]??NaN,complete:e("gap_complete")[i]===1,direction:this.data.texts("gap_direction")[i]??"",waves:this.data.texts("gap_waves")[i]??""}))}};function w_(n){return n===1?0:n===-1?1:-1}function Xc(){return matchMedia("(prefers-reduced-motion: reduce)").matches}var Xo=class{constructor({playing:e,pace:t},i){this.draw=i;let s=0,r=o=>{s>0&&(this.moment=(this.moment+(o-s)/1e3*t.peek())%1),s=o,document.hidden||i(),this.frame=requestAnimationFrame(r)};this.stop=lt(()=>{cancelAnimationFrame(this.frame),s=0,e.value&&(this.frame=requestAnimationFrame(r))})}draw;moment=0;frame=0;stop;at(e){this.moment=e,this.draw()}end(){cancelAnimationFrame(this.frame),this.stop()}};var $c=6,Yc=.5;function T_(n){let e=n.gaps[0];return{point:De(e?n.belowGap(e):{row:n.corners[1]?.row??0,band:0}),playing:De(!Xc()),swing:De(.15),pace:De(.7),copies:De([2,2]),unit:De(Cc(n.units,Math.max(...n.frequency))),listing:De("none")}}function E_(n,{row:e,band:t},i,s){return{row:Math.min(Math.max(e+i,0),n.rows-1),band:Math.min(Math.max(t+s,0),n.bands-1)}}function A_(n,{band:e}){let t=[...n.gaps].filter(s=>s.waves==="all").sort((s,r)=>s.below-r.below),i=t.find(s=>s.below-1>e)??t[0];return i&&n.belowGap(i)}var Yw=10,C_=.05;function R_(n,e){let t=(r,o)=>e.point.value=E_(n,e.point.value,r,o),i=r=>e.swing.value=Math.min(Math.max(e.swing.value+r,0),Yc),s=r=>r.shiftKey?Yw:1;return[{keys:"← →",effect:"previous or next wavevector; ten with Shift",actions:{ArrowLeft:r=>t(-s(r),0),ArrowRight:r=>t(s(r),0)}},{keys:"↑ ↓",effect:"next higher or lower band",actions:{ArrowUp:()=>t(0,1),ArrowDown:()=>t(0,-1)}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},{keys:"+ −",effect:"larger or smaller displacement",actions:{"+":()=>i(C_),"-":()=>i(-C_)}},{keys:"g",effect:"lower edge of the next gap",actions:{g:()=>e.point.value=A_(n,e.point.value)??e.point.value}},...Lo(e.listing)]}var $o=gS(G_(),1);function jc(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),6e4)}var Qc=40,eu=40,Wd="video/webm",g1=6,H_=new WeakMap;function tu(n,e){H_.set(n,e)}function nu({canvas:n,name:e,caption:t}){let[i,s]=Ft(""),r=typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported(Wd),o=(a,l)=>async()=>{if(n.current!==null){s(`The ${a} is made.`),await new Promise(c=>setTimeout(c,eu));try{jc(await l(new qd(n.current,t)),`${e}.${a.toLowerCase()}`),s("")}catch(c){s(`The ${a} cannot be made: ${String(c)}`)}}};return d("p",{class:"sides film",children:[d("span",{children:"Save the motion"}),d("button",{type:"button",onClick:()=>{o("GIF",_1)()},children:"GIF"}),r&&d("button",{type:"button",onClick:()=>{o("WebM",v1)()},children:"WebM"}),d("span",{role:"status",children:i})]})}var qd=class{constructor(e,t){this.canvas=e;this.caption=t;let i=H_.get(e),s=this.copy.getContext("2d",{willReadFrequently:!0});if(i===void 0||s===null)throw new Error("the canvas does not move");[this.draw,this.context]=[i,s],[this.copy.width,this.copy.height]=[e.width,e.height]}canvas;caption;copy=document.createElement("canvas");context;draw;show(e){let{context:t,copy:i}=this;this.draw(e),t.fillStyle=$e("panel"),t.fillRect(0,0,i.width,i.height),t.drawImage(this.canvas,0,0),t.font=`${13*devicePixelRatio}px system-ui, sans-serif`,t.fillStyle=$e("ink");let s=g1*devicePixelRatio;return t.fillText(this.caption,s,i.height-s,i.width-2*s),t}};async function _1(n){let{width:e,height:t}=n.copy,i=(0,$o.GIFEncoder)(),s;for(let r=0;r<Qc;r++){let{data:o}=n.show(r/Qc).getImageData(0,0,e,t);s??=(0,$o.quantize)(o,256),i.writeFrame((0,$o.applyPalette)(o,s),e,t,r===0?{palette:s,delay:eu}:{delay:eu}),r%5===4&&await new Promise(a=>setTimeout(a))}return i.finish(),new Blob([i.bytes()],{type:"image/gif"})}async function v1(n){n.show(0);let e=n.copy.captureStream(),t=new MediaRecorder(e,{mimeType:Wd,videoBitsPerSecond:8e6}),i=[];t.ondataavailable=({data:r})=>i.push(r);let s=new Promise(r=>t.onstop=r);t.start();for(let r=0;r<Qc;r++)n.show(r/Qc),await new Promise(o=>setTimeout(o,eu));t.stop(),await s;for(let r of e.getTracks())r.stop();return new Blob(i,{type:Wd})}var Tr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Er={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},gv=0,vp=1,_v=2;var Fl=1,vv=2,va=3,Ar=0,oi=1,Fi=2,no=0,ya=1,yp=2,xp=3,bp=4,yv=5;var io=100,xv=101,bv=102,Sv=103,Mv=104,wv=200,Tv=201,Ev=202,Av=203,Sp=204,Mp=205,Cv=206,Rv=207,Pv=208,Iv=209,Lv=210,Dv=211,Nv=212,Uv=213,Fv=214,Au=0,Cu=1,Ru=2,la=3,Pu=4,Iu=5,Lu=6,Du=7,wp=0,Ov=1,kv=2,xs=0,Tp=1,Ep=2,Ap=3,Cp=4,Rp=5,Pp=6,Ip=7;var Lp=300,so=301,xa=302,ah=303,lh=304,Nu=1e3,_s=1001,Uu=1002,Gn=1003,Bv=1004;var Ol=1005;var Wn=1006,ch=1007;var Ws=1008;var Ci=1009,Dp=1010,Np=1011,ba=1012,uh=1013,Ji=1014,ji=1015,Qi=1016,hh=1017,fh=1018,ro=1020,Up=35902,Fp=35899,Op=1021,kp=1022,es=1023,Vs=1026,qs=1027,Bp=1028,dh=1029,Cr=1030,ph=1031;var mh=1033,kl=33776,Bl=33777,zl=33778,Vl=33779,gh=35840,_h=35841,vh=35842,yh=35843,xh=36196,bh=37492,Sh=37496,Mh=37488,wh=37489,Gl=37490,Th=37491,Eh=37808,Ah=37809,Ch=37810,Rh=37811,Ph=37812,Ih=37813,Lh=37814,Dh=37815,Nh=37816,Uh=37817,Fh=37818,Oh=37819,kh=37820,Bh=37821,zh=36492,Vh=36494,Gh=36495,Hh=36283,Wh=36284,Hl=36285,qh=36286;var vl=2300,Fu=2301,Tu=2302,fp=2303,dp=2400,pp=2401,mp=2402;var zv=3200;var zp=0,Vv=1,Xs="",bi="srgb",yl="srgb-linear",xl="linear",Lt="srgb";var Eu=7680;var Gv=519,Hv=512,Wv=513,qv=514,Vp=515,Xv=516,$v=517,Gp=518,Hp=519,Yv=35044;var Wp="300 es",Ni=2e3,bl=2001;function y1(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function x1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Sl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Kv(){let n=Sl("canvas");return n.style.display="block",n}var W_={},ca=null;function qp(...n){let e="THREE."+n.shift();ca?ca("log",e,...n):console.log(e,...n)}function Zv(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=Zv(n);let e="THREE."+n.shift();if(ca)ca("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function et(...n){n=Zv(n);let e="THREE."+n.shift();if(ca)ca("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ml(...n){let e=n.join(" ");e in W_||(W_[e]=!0,Ye(...n))}function Jv(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var jv={[Au]:Au,[Ru]:Lu,[Pu]:Pu,[la]:Iu,[Cu]:Cu,[Lu]:Ru,[Du]:Du,[Iu]:la},Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Yn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],q_=1234567,gl=Math.PI/180,ua=180/Math.PI;function Sa(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Yn[n&255]+Yn[n>>8&255]+Yn[n>>16&255]+Yn[n>>24&255]+"-"+Yn[e&255]+Yn[e>>8&255]+"-"+Yn[e>>16&15|64]+Yn[e>>24&255]+"-"+Yn[t&63|128]+Yn[t>>8&255]+"-"+Yn[t>>16&255]+Yn[t>>24&255]+Yn[i&255]+Yn[i>>8&255]+Yn[i>>16&255]+Yn[i>>24&255]).toLowerCase()}function mt(n,e,t){return Math.max(e,Math.min(t,n))}function Xp(n,e){return(n%e+e)%e}function b1(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function S1(n,e,t){return n!==e?(t-n)/(e-n):0}function _l(n,e,t){return(1-t)*n+t*e}function M1(n,e,t,i){return _l(n,e,1-Math.exp(-t*i))}function w1(n,e=1){return e-Math.abs(Xp(n,e*2)-e)}function T1(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function E1(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function A1(n,e){return n+Math.floor(Math.random()*(e-n+1))}function C1(n,e){return n+Math.random()*(e-n)}function R1(n){return n*(.5-Math.random())}function P1(n){n!==void 0&&(q_=n);let e=q_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function I1(n){return n*gl}function L1(n){return n*ua}function D1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function N1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function $p(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function U1(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),f=o((e-i)/2),p=r((i-e)/2),_=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*_,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*_,a*c);break;case"ZYZ":n.set(l*_,l*p,a*u,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Yp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Qv(n,e){if(e.constructor===Float32Array)return n;let t=Yp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function ey(n,e){if(e.constructor===Float32Array)return n;let t=Yp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Kp={DEG2RAD:gl,RAD2DEG:ua,generateUUID:Sa,clamp:mt,euclideanModulo:Xp,mapLinear:b1,inverseLerp:S1,lerp:_l,damp:M1,pingpong:w1,smoothstep:T1,smootherstep:E1,randInt:A1,randFloat:C1,randFloatSpread:R1,seededRandom:P1,degToRad:I1,radToDeg:L1,isPowerOfTwo:D1,ceilPowerOfTwo:N1,floorPowerOfTwo:$p,setQuaternionFromProperEuler:U1,normalize:ey,denormalize:Qv},tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Mi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],p=r[o+1],_=r[o+2],b=r[o+3];if(h!==b||l!==f||c!==p||u!==_){let g=l*f+c*p+u*_+h*b;g<0&&(f=-f,p=-p,_=-_,b=-b,g=-g);let m=1-a;if(g<.9995){let x=Math.acos(g),A=Math.sin(x);m=Math.sin(m*x)/A,a=Math.sin(a*x)/A,l=l*m+f*a,c=c*m+p*a,u=u*m+_*a,h=h*m+b*a}else{l=l*m+f*a,c=c*m+p*a,u=u*m+_*a,h=h*m+b*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],p=r[o+2],_=r[o+3];return e[t]=a*_+u*h+l*p-c*f,e[t+1]=l*_+u*f+c*h-a*p,e[t+2]=c*_+u*p+a*f-l*h,e[t+3]=u*_-a*h-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),p=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h-f*p*_;break;case"YXZ":this._x=f*u*h+c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h+f*p*_;break;case"ZXY":this._x=f*u*h-c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h-f*p*_;break;case"ZYX":this._x=f*u*h-c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h+f*p*_;break;case"YZX":this._x=f*u*h+c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h-f*p*_;break;case"XZY":this._x=f*u*h-c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h+f*p*_;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>h){let p=2*Math.sqrt(1+i-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-i-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(X_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(X_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Xd.copy(this).projectOnVector(e),this.sub(Xd)}reflect(e){return this.sub(Xd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Xd=new K,X_=new Mi,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],p=i[5],_=i[8],b=s[0],g=s[3],m=s[6],x=s[1],A=s[4],S=s[7],P=s[2],C=s[5],v=s[8];return r[0]=o*b+a*x+l*P,r[3]=o*g+a*A+l*C,r[6]=o*m+a*S+l*v,r[1]=c*b+u*x+h*P,r[4]=c*g+u*A+h*C,r[7]=c*m+u*S+h*v,r[2]=f*b+p*x+_*P,r[5]=f*g+p*A+_*C,r[8]=f*m+p*S+_*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,_=t*h+i*f+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/_;return e[0]=h*b,e[1]=(s*c-u*i)*b,e[2]=(a*i-s*o)*b,e[3]=f*b,e[4]=(u*t-s*l)*b,e[5]=(s*r-a*t)*b,e[6]=p*b,e[7]=(i*l-c*t)*b,e[8]=(o*t-i*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ml("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply($d.makeScale(e,t)),this}rotate(e){return ml("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply($d.makeRotation(-e)),this}translate(e,t){return ml("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply($d.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},$d=new nt,$_=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Y_=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function F1(){let n={enabled:!0,workingColorSpace:yl,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Lt&&(s.r=zs(s.r),s.g=zs(s.g),s.b=zs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Lt&&(s.r=aa(s.r),s.g=aa(s.g),s.b=aa(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Xs?xl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[yl]:{primaries:e,whitePoint:i,transfer:xl,toXYZ:$_,fromXYZ:Y_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:bi},outputColorSpaceConfig:{drawingBufferColorSpace:bi}},[bi]:{primaries:e,whitePoint:i,transfer:Lt,toXYZ:$_,fromXYZ:Y_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:bi}}}),n}var yt=F1();function zs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function aa(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Yo,Ou=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Yo===void 0&&(Yo=Sl("canvas")),Yo.width=e.width,Yo.height=e.height;let s=Yo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Yo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Sl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=zs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(zs(t[i]/255)*255):t[i]=zs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},O1=0,ha=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:O1++}),this.uuid=Sa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Yd(s[o].image)):r.push(Yd(s[o]))}else r=Yd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Yd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ou.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var k1=0,Kd=new K,ci=class n extends Zi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=_s,s=_s,r=Wn,o=Ws,a=es,l=Ci,c=n.DEFAULT_ANISOTROPY,u=Xs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:k1++}),this.uuid=Sa(),this.name="",this.source=new ha(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Kd).x}get height(){return this.source.getSize(Kd).y}get depth(){return this.source.getSize(Kd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Lp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Nu:e.x=e.x-Math.floor(e.x);break;case _s:e.x=e.x<0?0:1;break;case Uu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Nu:e.y=e.y-Math.floor(e.y);break;case _s:e.y=e.y<0?0:1;break;case Uu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ci.DEFAULT_IMAGE=null;ci.DEFAULT_MAPPING=Lp;ci.DEFAULT_ANISOTROPY=1;var rn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],_=l[9],b=l[2],g=l[6],m=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-b)<.01&&Math.abs(_-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+b)<.1&&Math.abs(_+g)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(p+1)/2,P=(m+1)/2,C=(u+f)/4,v=(h+b)/4,E=(_+g)/4;return A>S&&A>P?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=C/i,r=v/i):S>P?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=C/s,r=E/s):P<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),i=v/r,s=E/r),this.set(i,s,r,t),this}let x=Math.sqrt((g-_)*(g-_)+(h-b)*(h-b)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(g-_)/x,this.y=(h-b)/x,this.z=(f-u)/x,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ku=class extends Zi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Wn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new rn(0,0,e,t),this.scissorTest=!1,this.viewport=new rn(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ci({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Wn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ha(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wi=class extends ku{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ml=class extends ci{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=_s,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Bu=class extends ci{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=_s,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var sn=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,p,_,b,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,p,_,b,g)}set(e,t,i,s,r,o,a,l,c,u,h,f,p,_,b,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=f,m[3]=p,m[7]=_,m[11]=b,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Ko.setFromMatrixColumn(e,0).length(),r=1/Ko.setFromMatrixColumn(e,1).length(),o=1/Ko.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,p=o*h,_=a*u,b=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+_*c,t[5]=f-b*c,t[9]=-a*l,t[2]=b-f*c,t[6]=_+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*h,_=c*u,b=c*h;t[0]=f+b*a,t[4]=_*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-_,t[6]=b+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*h,_=c*u,b=c*h;t[0]=f-b*a,t[4]=-o*h,t[8]=_+p*a,t[1]=p+_*a,t[5]=o*u,t[9]=b-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*h,_=a*u,b=a*h;t[0]=l*u,t[4]=_*c-p,t[8]=f*c+b,t[1]=l*h,t[5]=b*c+f,t[9]=p*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,_=a*l,b=a*c;t[0]=l*u,t[4]=b-f*h,t[8]=_*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+_,t[10]=f-b*h}else if(e.order==="XZY"){let f=o*l,p=o*c,_=a*l,b=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+b,t[5]=o*u,t[9]=p*h-_,t[2]=_*h-p,t[6]=a*u,t[10]=b*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(B1,e,z1)}lookAt(e,t,i){let s=this.elements;return yi.subVectors(e,t),yi.lengthSq()===0&&(yi.z=1),yi.normalize(),pr.crossVectors(i,yi),pr.lengthSq()===0&&(Math.abs(i.z)===1?yi.x+=1e-4:yi.z+=1e-4,yi.normalize(),pr.crossVectors(i,yi)),pr.normalize(),iu.crossVectors(yi,pr),s[0]=pr.x,s[4]=iu.x,s[8]=yi.x,s[1]=pr.y,s[5]=iu.y,s[9]=yi.y,s[2]=pr.z,s[6]=iu.z,s[10]=yi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],p=i[13],_=i[2],b=i[6],g=i[10],m=i[14],x=i[3],A=i[7],S=i[11],P=i[15],C=s[0],v=s[4],E=s[8],k=s[12],N=s[1],L=s[5],B=s[9],V=s[13],U=s[2],H=s[6],Y=s[10],G=s[14],le=s[3],J=s[7],Q=s[11],se=s[15];return r[0]=o*C+a*N+l*U+c*le,r[4]=o*v+a*L+l*H+c*J,r[8]=o*E+a*B+l*Y+c*Q,r[12]=o*k+a*V+l*G+c*se,r[1]=u*C+h*N+f*U+p*le,r[5]=u*v+h*L+f*H+p*J,r[9]=u*E+h*B+f*Y+p*Q,r[13]=u*k+h*V+f*G+p*se,r[2]=_*C+b*N+g*U+m*le,r[6]=_*v+b*L+g*H+m*J,r[10]=_*E+b*B+g*Y+m*Q,r[14]=_*k+b*V+g*G+m*se,r[3]=x*C+A*N+S*U+P*le,r[7]=x*v+A*L+S*H+P*J,r[11]=x*E+A*B+S*Y+P*Q,r[15]=x*k+A*V+S*G+P*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],p=e[14],_=e[3],b=e[7],g=e[11],m=e[15],x=l*p-c*f,A=a*p-c*h,S=a*f-l*h,P=o*p-c*u,C=o*f-l*u,v=o*h-a*u;return t*(b*x-g*A+m*S)-i*(_*x-g*P+m*C)+s*(_*A-b*P+m*v)-r*(_*S-b*C+g*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],p=e[11],_=e[12],b=e[13],g=e[14],m=e[15],x=t*a-i*o,A=t*l-s*o,S=t*c-r*o,P=i*l-s*a,C=i*c-r*a,v=s*c-r*l,E=u*b-h*_,k=u*g-f*_,N=u*m-p*_,L=h*g-f*b,B=h*m-p*b,V=f*m-p*g,U=x*V-A*B+S*L+P*N-C*k+v*E;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/U;return e[0]=(a*V-l*B+c*L)*H,e[1]=(s*B-i*V-r*L)*H,e[2]=(b*v-g*C+m*P)*H,e[3]=(f*C-h*v-p*P)*H,e[4]=(l*N-o*V-c*k)*H,e[5]=(t*V-s*N+r*k)*H,e[6]=(g*S-_*v-m*A)*H,e[7]=(u*v-f*S+p*A)*H,e[8]=(o*B-a*N+c*E)*H,e[9]=(i*N-t*B-r*E)*H,e[10]=(_*C-b*S+m*x)*H,e[11]=(h*S-u*C-p*x)*H,e[12]=(a*k-o*L-l*E)*H,e[13]=(t*L-i*k+s*E)*H,e[14]=(b*A-_*P-g*x)*H,e[15]=(u*P-h*A+f*x)*H,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,_=r*h,b=o*u,g=o*h,m=a*h,x=l*c,A=l*u,S=l*h,P=i.x,C=i.y,v=i.z;return s[0]=(1-(b+m))*P,s[1]=(p+S)*P,s[2]=(_-A)*P,s[3]=0,s[4]=(p-S)*C,s[5]=(1-(f+m))*C,s[6]=(g+x)*C,s[7]=0,s[8]=(_+A)*v,s[9]=(g-x)*v,s[10]=(1-(f+b))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Ko.set(s[0],s[1],s[2]).length(),a=Ko.set(s[4],s[5],s[6]).length(),l=Ko.set(s[8],s[9],s[10]).length();r<0&&(o=-o),$i.copy(this);let c=1/o,u=1/a,h=1/l;return $i.elements[0]*=c,$i.elements[1]*=c,$i.elements[2]*=c,$i.elements[4]*=u,$i.elements[5]*=u,$i.elements[6]*=u,$i.elements[8]*=h,$i.elements[9]*=h,$i.elements[10]*=h,t.setFromRotationMatrix($i),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ni,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),p=(i+s)/(i-s),_,b;if(l)_=r/(o-r),b=o*r/(o-r);else if(a===Ni)_=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===bl)_=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ni,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),p=-(i+s)/(i-s),_,b;if(l)_=1/(o-r),b=o/(o-r);else if(a===Ni)_=-2/(o-r),b=-(o+r)/(o-r);else if(a===bl)_=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=_,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Ko=new K,$i=new sn,B1=new K(0,0,0),z1=new K(1,1,1),pr=new K,iu=new K,yi=new K,K_=new sn,Z_=new Mi,xr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return K_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(K_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Z_.setFromEuler(this),this.setFromQuaternion(Z_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};xr.DEFAULT_ORDER="XYZ";var wl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},V1=0,J_=new K,Zo=new Mi,Us=new sn,su=new K,ul=new K,G1=new K,H1=new Mi,j_=new K(1,0,0),Q_=new K(0,1,0),ev=new K(0,0,1),tv={type:"added"},W1={type:"removed"},Jo={type:"childadded",child:null},Zd={type:"childremoved",child:null},Ti=class n extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:V1++}),this.uuid=Sa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new K,t=new xr,i=new Mi,s=new K(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new sn},normalMatrix:{value:new nt}}),this.matrix=new sn,this.matrixWorld=new sn,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new wl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Zo.setFromAxisAngle(e,t),this.quaternion.multiply(Zo),this}rotateOnWorldAxis(e,t){return Zo.setFromAxisAngle(e,t),this.quaternion.premultiply(Zo),this}rotateX(e){return this.rotateOnAxis(j_,e)}rotateY(e){return this.rotateOnAxis(Q_,e)}rotateZ(e){return this.rotateOnAxis(ev,e)}translateOnAxis(e,t){return J_.copy(e).applyQuaternion(this.quaternion),this.position.add(J_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(j_,e)}translateY(e){return this.translateOnAxis(Q_,e)}translateZ(e){return this.translateOnAxis(ev,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Us.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?su.copy(e):su.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ul.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Us.lookAt(ul,su,this.up):Us.lookAt(su,ul,this.up),this.quaternion.setFromRotationMatrix(Us),s&&(Us.extractRotation(s.matrixWorld),Zo.setFromRotationMatrix(Us),this.quaternion.premultiply(Zo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(tv),Jo.child=e,this.dispatchEvent(Jo),Jo.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(W1),Zd.child=e,this.dispatchEvent(Zd),Zd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Us.multiply(e.parent.matrixWorld)),e.applyMatrix4(Us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(tv),Jo.child=e,this.dispatchEvent(Jo),Jo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ul,e,G1),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ul,H1,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),p=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ti.DEFAULT_UP=new K(0,1,0);Ti.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ti.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var jr=class extends Ti{constructor(){super(),this.isGroup=!0,this.type="Group"}},q1={type:"move"},fa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new jr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new jr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new jr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let g=t.getJointPose(b,i),m=this._getHandJoint(c,b);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,_=.005;c.inputState.pinching&&f>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(q1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new jr;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},ty={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},mr={h:0,s:0,l:0},ru={h:0,s:0,l:0};function Jd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var xt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=bi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=i,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=yt.workingColorSpace){if(e=Xp(e,1),t=mt(t,0,1),i=mt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Jd(o,r,e+1/3),this.g=Jd(o,r,e),this.b=Jd(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=bi){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=bi){let i=ty[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=zs(e.r),this.g=zs(e.g),this.b=zs(e.b),this}copyLinearToSRGB(e){return this.r=aa(e.r),this.g=aa(e.g),this.b=aa(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=bi){return yt.workingToColorSpace(Kn.copy(this),e),Math.round(mt(Kn.r*255,0,255))*65536+Math.round(mt(Kn.g*255,0,255))*256+Math.round(mt(Kn.b*255,0,255))}getHexString(e=bi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace(Kn.copy(this),t);let i=Kn.r,s=Kn.g,r=Kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace(Kn.copy(this),t),e.r=Kn.r,e.g=Kn.g,e.b=Kn.b,e}getStyle(e=bi){yt.workingToColorSpace(Kn.copy(this),e);let t=Kn.r,i=Kn.g,s=Kn.b;return e!==bi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(mr),this.setHSL(mr.h+e,mr.s+t,mr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(mr),e.getHSL(ru);let i=_l(mr.h,ru.h,t),s=_l(mr.s,ru.s,t),r=_l(mr.l,ru.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Kn=new xt;xt.NAMES=ty;var Tl=class extends Ti{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new xr,this.environmentIntensity=1,this.environmentRotation=new xr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Yi=new K,Fs=new K,jd=new K,Os=new K,jo=new K,Qo=new K,nv=new K,Qd=new K,ep=new K,tp=new K,np=new rn,ip=new rn,sp=new rn,yr=class n{constructor(e=new K,t=new K,i=new K){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Yi.subVectors(e,t),s.cross(Yi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Yi.subVectors(s,t),Fs.subVectors(i,t),jd.subVectors(e,t);let o=Yi.dot(Yi),a=Yi.dot(Fs),l=Yi.dot(jd),c=Fs.dot(Fs),u=Fs.dot(jd),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,_=(o*u-a*l)*f;return r.set(1-p-_,_,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Os)===null?!1:Os.x>=0&&Os.y>=0&&Os.x+Os.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Os.x),l.addScaledVector(o,Os.y),l.addScaledVector(a,Os.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return np.setScalar(0),ip.setScalar(0),sp.setScalar(0),np.fromBufferAttribute(e,t),ip.fromBufferAttribute(e,i),sp.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(np,r.x),o.addScaledVector(ip,r.y),o.addScaledVector(sp,r.z),o}static isFrontFacing(e,t,i,s){return Yi.subVectors(i,t),Fs.subVectors(e,t),Yi.cross(Fs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Yi.subVectors(this.c,this.b),Fs.subVectors(this.a,this.b),Yi.cross(Fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;jo.subVectors(s,i),Qo.subVectors(r,i),Qd.subVectors(e,i);let l=jo.dot(Qd),c=Qo.dot(Qd);if(l<=0&&c<=0)return t.copy(i);ep.subVectors(e,s);let u=jo.dot(ep),h=Qo.dot(ep);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(jo,o);tp.subVectors(e,r);let p=jo.dot(tp),_=Qo.dot(tp);if(_>=0&&p<=_)return t.copy(r);let b=p*c-l*_;if(b<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(i).addScaledVector(Qo,a);let g=u*_-p*h;if(g<=0&&h-u>=0&&p-_>=0)return nv.subVectors(r,s),a=(h-u)/(h-u+(p-_)),t.copy(s).addScaledVector(nv,a);let m=1/(g+b+f);return o=b*m,a=f*m,t.copy(i).addScaledVector(jo,o).addScaledVector(Qo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},vs=class{constructor(e=new K(1/0,1/0,1/0),t=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ki):Ki.fromBufferAttribute(r,o),Ki.applyMatrix4(e.matrixWorld),this.expandByPoint(Ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ou.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ou.copy(i.boundingBox)),ou.applyMatrix4(e.matrixWorld),this.union(ou)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ki),Ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(hl),au.subVectors(this.max,hl),ea.subVectors(e.a,hl),ta.subVectors(e.b,hl),na.subVectors(e.c,hl),gr.subVectors(ta,ea),_r.subVectors(na,ta),Yr.subVectors(ea,na);let t=[0,-gr.z,gr.y,0,-_r.z,_r.y,0,-Yr.z,Yr.y,gr.z,0,-gr.x,_r.z,0,-_r.x,Yr.z,0,-Yr.x,-gr.y,gr.x,0,-_r.y,_r.x,0,-Yr.y,Yr.x,0];return!rp(t,ea,ta,na,au)||(t=[1,0,0,0,1,0,0,0,1],!rp(t,ea,ta,na,au))?!1:(lu.crossVectors(gr,_r),t=[lu.x,lu.y,lu.z],rp(t,ea,ta,na,au))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ks[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ks[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ks[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ks[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ks[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ks[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ks[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ks[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ks),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ks=[new K,new K,new K,new K,new K,new K,new K,new K],Ki=new K,ou=new vs,ea=new K,ta=new K,na=new K,gr=new K,_r=new K,Yr=new K,hl=new K,au=new K,lu=new K,Kr=new K;function rp(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Kr.fromArray(n,r);let a=s.x*Math.abs(Kr.x)+s.y*Math.abs(Kr.y)+s.z*Math.abs(Kr.z),l=e.dot(Kr),c=t.dot(Kr),u=i.dot(Kr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var wn=new K,cu=new tt,X1=0,ri=class extends Zi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:X1++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Yv,this.updateRanges=[],this.gpuType=ji,this.version=0,this._normalizationScale=e!==void 0?Yp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)cu.fromBufferAttribute(this,t),cu.applyMatrix3(e),this.setXY(t,cu.x,cu.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix3(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix4(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyNormalMatrix(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.transformDirection(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Qv(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ey(e,this.array)}};var El=class extends ri{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Al=class extends ri{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var li=class extends ri{constructor(e,t,i){super(new Float32Array(e),t,i)}},$1=new vs,fl=new K,op=new K,Gs=class{constructor(e=new K,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):$1.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;fl.subVectors(e,this.center);let t=fl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(fl,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(op.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(fl.copy(e.center).add(op)),this.expandByPoint(fl.copy(e.center).sub(op))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Y1=0,Di=new sn,ap=new Ti,ia=new K,xi=new vs,dl=new vs,Vn=new K,ys=class n extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Y1++}),this.uuid=Sa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(y1(e)?Al:El)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Di.makeRotationFromQuaternion(e),this.applyMatrix4(Di),this}rotateX(e){return Di.makeRotationX(e),this.applyMatrix4(Di),this}rotateY(e){return Di.makeRotationY(e),this.applyMatrix4(Di),this}rotateZ(e){return Di.makeRotationZ(e),this.applyMatrix4(Di),this}translate(e,t,i){return Di.makeTranslation(e,t,i),this.applyMatrix4(Di),this}scale(e,t,i){return Di.makeScale(e,t,i),this.applyMatrix4(Di),this}lookAt(e){return ap.lookAt(e),ap.updateMatrix(),this.applyMatrix4(ap.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ia).negate(),this.translate(ia.x,ia.y,ia.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new li(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new vs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];xi.setFromBufferAttribute(r),this.morphTargetsRelative?(Vn.addVectors(this.boundingBox.min,xi.min),this.boundingBox.expandByPoint(Vn),Vn.addVectors(this.boundingBox.max,xi.max),this.boundingBox.expandByPoint(Vn)):(this.boundingBox.expandByPoint(xi.min),this.boundingBox.expandByPoint(xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(e){let i=this.boundingSphere.center;if(xi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];dl.setFromBufferAttribute(a),this.morphTargetsRelative?(Vn.addVectors(xi.min,dl.min),xi.expandByPoint(Vn),Vn.addVectors(xi.max,dl.max),xi.expandByPoint(Vn)):(xi.expandByPoint(dl.min),xi.expandByPoint(dl.max))}xi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Vn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Vn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Vn.fromBufferAttribute(a,c),l&&(ia.fromBufferAttribute(e,c),Vn.add(ia)),s=Math.max(s,i.distanceToSquared(Vn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ri(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new K,l[k]=new K;let u=new K,h=new K,f=new K,p=new tt,_=new tt,b=new tt,g=new K,m=new K;function x(k,N,L){c[k]=c[N]=c[L]=1,u.fromBufferAttribute(i,k),h.fromBufferAttribute(i,N),f.fromBufferAttribute(i,L),p.fromBufferAttribute(r,k),_.fromBufferAttribute(r,N),b.fromBufferAttribute(r,L),h.sub(u),f.sub(u),_.sub(p),b.sub(p);let B=1/(_.x*b.y-b.x*_.y);isFinite(B)&&(g.copy(h).multiplyScalar(b.y).addScaledVector(f,-_.y).multiplyScalar(B),m.copy(f).multiplyScalar(_.x).addScaledVector(h,-b.x).multiplyScalar(B),a[k].add(g),a[N].add(g),a[L].add(g),l[k].add(m),l[N].add(m),l[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let k=0,N=A.length;k<N;++k){let L=A[k],B=L.start,V=L.count;for(let U=B,H=B+V;U<H;U+=3)x(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let S=new K,P=new K,C=new K,v=new K;function E(k){C.fromBufferAttribute(s,k),v.copy(C);let N=a[k];S.copy(N),S.sub(C.multiplyScalar(C.dot(N))).normalize(),P.crossVectors(v,N);let B=P.dot(l[k])<0?-1:1;o.setXYZW(k,S.x,S.y,S.z,B)}for(let k=0,N=i.count;k<N;++k)c[k]&&E(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ri(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let s=new K,r=new K,o=new K,a=new K,l=new K,c=new K,u=new K,h=new K;if(e)for(let f=0,p=e.count;f<p;f+=3){let _=e.getX(f+0),b=e.getX(f+1),g=e.getX(f+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Vn.fromBufferAttribute(e,t),Vn.normalize(),e.setXYZ(t,Vn.x,Vn.y,Vn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,_=0;for(let b=0,g=l.length;b<g;b++){a.isInterleavedBufferAttribute?p=l[b]*a.data.stride+a.offset:p=l[b]*u;for(let m=0;m<u;m++)f[_++]=c[p++]}return new ri(f,u,h)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=e(f,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var lp=new K,K1=new K,Z1=new nt,Si=class{constructor(e=new K(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=lp.subVectors(i,t).cross(K1.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(lp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Z1.getNormalMatrix(e),s=this.coplanarPoint(lp).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},J1=0,br=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:J1++}),this.uuid=Sa(),this.name="",this.type="Material",this.blending=ya,this.side=Ar,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Sp,this.blendDst=Mp,this.blendEquation=io,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new xt(0,0,0),this.blendAlpha=0,this.depthFunc=la,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Gv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Eu,this.stencilZFail=Eu,this.stencilZPass=Eu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new xt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Si().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new tt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Bs=new K,cp=new K,uu=new K,hu=new K,Qr=class{constructor(e=new K,t=new K(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Bs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Bs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Bs.copy(this.origin).addScaledVector(this.direction,t),Bs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){cp.copy(e).add(t).multiplyScalar(.5),uu.copy(t).sub(e).normalize(),hu.copy(this.origin).sub(cp);let r=e.distanceTo(t)*.5,o=-this.direction.dot(uu),a=hu.dot(this.direction),l=-hu.dot(uu),c=hu.lengthSq(),u=Math.abs(1-o*o),h,f,p,_;if(u>0)if(h=o*l-a,f=o*a-l,_=r*u,h>=0)if(f>=-_)if(f<=_){let b=1/u;h*=b,f*=b,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-_?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=_?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(cp).addScaledVector(uu,f),p}intersectSphere(e,t){if(e.radius<0)return null;Bs.subVectors(e.center,this.origin);let i=Bs.dot(this.direction),s=Bs.dot(Bs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Bs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,p=e.z-o.z,_=t.x-o.x,b=t.y-o.y,g=t.z-o.z,m=i.x-o.x,x=i.y-o.y,A=i.z-o.z,S=Math.abs(l),P=Math.abs(c),C=Math.abs(u),v,E,k,N,L,B,V,U,H,Y,G,le;if(S>=P&&S>=C?(k=l,B=h,H=_,le=m,l>=0?(v=c,E=u,N=f,L=p,V=b,U=g,Y=x,G=A):(v=u,E=c,N=p,L=f,V=g,U=b,Y=A,G=x)):P>=C?(k=c,B=f,H=b,le=x,c>=0?(v=u,E=l,N=p,L=h,V=g,U=_,Y=A,G=m):(v=l,E=u,N=h,L=p,V=_,U=g,Y=m,G=A)):(k=u,B=p,H=g,le=A,u>=0?(v=l,E=c,N=h,L=f,V=_,U=b,Y=m,G=x):(v=c,E=l,N=f,L=h,V=b,U=_,Y=x,G=m)),k===0)return null;let J=v/k,Q=E/k,se=1/k,fe=N-J*B,he=L-Q*B,ee=V-J*H,me=U-Q*H,ve=Y-J*le,Ae=G-Q*le,Se=ve*me-Ae*ee,We=fe*Ae-he*ve,rt=ee*he-me*fe;if(s){if(Se<0||We<0||rt<0)return null}else if((Se<0||We<0||rt<0)&&(Se>0||We>0||rt>0))return null;let Ge=Se+We+rt;if(Ge===0)return null;let ft=se*(Se*B+We*H+rt*le);return(Ge>0?ft<0:ft>0)?null:this.at(ft/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},zu=class extends br{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xr,this.combine=wp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},iv=new sn,Zr=new Qr,fu=new Gs,sv=new K,du=new K,pu=new K,mu=new K,up=new K,gu=new K,rv=new K,_u=new K,Ui=class extends Ti{constructor(e=new ys,t=new zu){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){gu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(up.fromBufferAttribute(h,e),o?gu.addScaledVector(up,u):gu.addScaledVector(up.sub(t),u))}t.add(gu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),fu.copy(i.boundingSphere),fu.applyMatrix4(r),Zr.copy(e.ray).recast(e.near),!(fu.containsPoint(Zr.origin)===!1&&(Zr.intersectSphere(fu,sv)===null||Zr.origin.distanceToSquared(sv)>(e.far-e.near)**2))&&(iv.copy(r).invert(),Zr.copy(e.ray).applyMatrix4(iv),!(i.boundingBox!==null&&Zr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Zr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,b=f.length;_<b;_++){let g=f[_],m=o[g.materialIndex],x=Math.max(g.start,p.start),A=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let S=x,P=A;S<P;S+=3){let C=a.getX(S),v=a.getX(S+1),E=a.getX(S+2);s=vu(this,m,e,i,c,u,h,C,v,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let _=Math.max(0,p.start),b=Math.min(a.count,p.start+p.count);for(let g=_,m=b;g<m;g+=3){let x=a.getX(g),A=a.getX(g+1),S=a.getX(g+2);s=vu(this,o,e,i,c,u,h,x,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,b=f.length;_<b;_++){let g=f[_],m=o[g.materialIndex],x=Math.max(g.start,p.start),A=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let S=x,P=A;S<P;S+=3){let C=S,v=S+1,E=S+2;s=vu(this,m,e,i,c,u,h,C,v,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let _=Math.max(0,p.start),b=Math.min(l.count,p.start+p.count);for(let g=_,m=b;g<m;g+=3){let x=g,A=g+1,S=g+2;s=vu(this,o,e,i,c,u,h,x,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function j1(n,e,t,i,s,r,o,a){let l;if(e.side===oi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ar,a),l===null)return null;_u.copy(a),_u.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(_u);return c<t.near||c>t.far?null:{distance:c,point:_u.clone(),object:n}}function vu(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,du),n.getVertexPosition(l,pu),n.getVertexPosition(c,mu);let u=j1(n,e,t,i,du,pu,mu,rv);if(u){let h=new K;yr.getBarycoord(rv,du,pu,mu,h),s&&(u.uv=yr.getInterpolatedAttribute(s,a,l,c,h,new tt)),r&&(u.uv1=yr.getInterpolatedAttribute(r,a,l,c,h,new tt)),o&&(u.normal=yr.getInterpolatedAttribute(o,a,l,c,h,new K),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new K,materialIndex:0};yr.getNormal(du,pu,mu,f.normal),u.face=f,u.barycoord=h}return u}var eo=class extends ci{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Gn,u=Gn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var da=class extends ri{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Jr=new Gs,Q1=new tt(.5,.5),yu=new K,to=class{constructor(e=new Si,t=new Si,i=new Si,s=new Si,r=new Si,o=new Si){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ni,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],_=r[8],b=r[9],g=r[10],m=r[11],x=r[12],A=r[13],S=r[14],P=r[15];if(s[0].setComponents(c-o,p-u,m-_,P-x).normalize(),s[1].setComponents(c+o,p+u,m+_,P+x).normalize(),s[2].setComponents(c+a,p+h,m+b,P+A).normalize(),s[3].setComponents(c-a,p-h,m-b,P-A).normalize(),i)s[4].setComponents(l,f,g,S).normalize(),s[5].setComponents(c-l,p-f,m-g,P-S).normalize();else if(s[4].setComponents(c-l,p-f,m-g,P-S).normalize(),t===Ni)s[5].setComponents(c+l,p+f,m+g,P+S).normalize();else if(t===bl)s[5].setComponents(l,f,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Jr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Jr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Jr)}intersectsSprite(e){Jr.center.set(0,0,0);let t=Q1.distanceTo(e.center);return Jr.radius=.7071067811865476+t,Jr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Jr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(yu.x=s.normal.x>0?e.max.x:e.min.x,yu.y=s.normal.y>0?e.max.y:e.min.y,yu.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(yu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},ov=new sn,Vu=class n{constructor(){this.coordinateSystem=Ni,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];ov.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new to),i[s].setFromProjectionMatrix(ov,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new to),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Gu=class extends br{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new xt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Hu=new K,Wu=new K,av=new sn,pl=new Qr,xu=new Gs,hp=new K,lv=new K,qu=class extends Ti{constructor(e=new ys,t=new Gu){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Hu.fromBufferAttribute(t,s-1),Wu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Hu.distanceTo(Wu);e.setAttribute("lineDistance",new li(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),xu.copy(i.boundingSphere),xu.applyMatrix4(s),xu.radius+=r,e.ray.intersectsSphere(xu)===!1)return;av.copy(s).invert(),pl.copy(e.ray).applyMatrix4(av);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let b=p,g=_-1;b<g;b+=c){let m=u.getX(b),x=u.getX(b+1),A=bu(this,e,pl,l,m,x,b);A&&t.push(A)}if(this.isLineLoop){let b=u.getX(_-1),g=u.getX(p),m=bu(this,e,pl,l,b,g,_-1);m&&t.push(m)}}else{let p=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let b=p,g=_-1;b<g;b+=c){let m=bu(this,e,pl,l,b,b+1,b);m&&t.push(m)}if(this.isLineLoop){let b=bu(this,e,pl,l,_-1,p,_-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function bu(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Hu.fromBufferAttribute(a,s),Wu.fromBufferAttribute(a,r),t.distanceSqToSegment(Hu,Wu,hp,lv)>i)return;hp.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(hp);if(!(c<e.near||c>e.far))return{distance:c,point:lv.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var cv=new K,uv=new K,Cl=class extends qu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)cv.fromBufferAttribute(t,s),uv.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+cv.distanceTo(uv);e.setAttribute("lineDistance",new li(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Rl=class extends ci{constructor(e=[],t=so,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Hs=class extends ci{constructor(e,t,i=Ji,s,r,o,a=Gn,l=Gn,c,u=Vs,h=1){if(u!==Vs&&u!==qs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ha(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Pl=class extends Hs{constructor(e,t=Ji,i=so,s,r,o=Gn,a=Gn,l,c=Vs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Il=class extends ci{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},pa=class n extends ys{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new li(c,3)),this.setAttribute("normal",new li(u,3)),this.setAttribute("uv",new li(h,2));function _(b,g,m,x,A,S,P,C,v,E,k){let N=S/v,L=P/E,B=S/2,V=P/2,U=C/2,H=v+1,Y=E+1,G=0,le=0,J=new K;for(let Q=0;Q<Y;Q++){let se=Q*L-V;for(let fe=0;fe<H;fe++){let he=fe*N-B;J[b]=he*x,J[g]=se*A,J[m]=U,c.push(J.x,J.y,J.z),J[b]=0,J[g]=0,J[m]=C>0?1:-1,u.push(J.x,J.y,J.z),h.push(fe/v),h.push(1-Q/E),G+=1}}for(let Q=0;Q<E;Q++)for(let se=0;se<v;se++){let fe=f+se+H*Q,he=f+se+H*(Q+1),ee=f+(se+1)+H*(Q+1),me=f+(se+1)+H*Q;l.push(fe,he,me),l.push(he,ee,me),le+=6}a.addGroup(p,le,k),p+=le,f+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ll=class n extends ys{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,p=[],_=[],b=[],g=[];for(let m=0;m<u;m++){let x=m*f-o;for(let A=0;A<c;A++){let S=A*h-r;_.push(S,-x,0),b.push(0,0,1),g.push(A/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let A=x+c*m,S=x+c*(m+1),P=x+1+c*(m+1),C=x+1+c*m;p.push(A,S,C),p.push(S,P,C)}this.setIndex(p),this.setAttribute("position",new li(_,3)),this.setAttribute("normal",new li(b,3)),this.setAttribute("uv",new li(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function oo(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(hv(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(hv(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Zn(n){let e={};for(let t=0;t<n.length;t++){let i=oo(n[t]);for(let s in i)e[s]=i[s]}return e}function hv(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function eT(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Zp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var ny={clone:oo,merge:Zn},tT=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,nT=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ei=class extends br{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=tT,this.fragmentShader=nT,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=oo(e.uniforms),this.uniformsGroups=eT(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new xt().setHex(s.value);break;case"v2":this.uniforms[i].value=new tt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new K().fromArray(s.value);break;case"v4":this.uniforms[i].value=new rn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new sn().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Xu=class extends Ei{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var $u=class extends br{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=zv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Yu=class extends br{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function sa(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Su(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Sr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ku=class extends Sr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:dp,endingEnd:dp}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case pp:r=e,a=2*t-i;break;case mp:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case pp:o=e,l=2*i-t;break;case mp:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,p=this._weightNext,_=(i-t)/(s-t),b=_*_,g=b*_,m=-f*g+2*f*b-f*_,x=(1+f)*g+(-1.5-2*f)*b+(-.5+f)*_+1,A=(-1-p)*g+(1.5+p)*b+.5*_,S=p*g-p*b;for(let P=0;P!==a;++P)r[P]=m*o[u+P]+x*o[c+P]+A*o[l+P]+S*o[h+P];return r}},Zu=class extends Sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Ju=class extends Sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ju=class extends Sr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let _=(i-t)/(s-t),b=1-_;for(let g=0;g!==a;++g)r[g]=o[c+g]*b+o[l+g]*_;return r}let f=a*2,p=e-1;for(let _=0;_!==a;++_){let b=o[c+_],g=o[l+_],m=p*f+_*2,x=h[m],A=h[m+1],S=e*f+_*2,P=u[S],C=u[S+1],v=sT(i,t,x,P,s);r[_]=iy(v,b,A,C,g)}return r}};function iy(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function iT(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function sT(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=iy(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=iT(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ai=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=sa(t,this.TimeBufferType),this.values=sa(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:sa(e.times,Array),values:sa(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Su(e.settings)&&(i.settings={inTangents:sa(e.settings.inTangents,Array),outTangents:sa(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Ju(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Zu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ku(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ju(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case vl:t=this.InterpolantFactoryMethodDiscrete;break;case Fu:t=this.InterpolantFactoryMethodLinear;break;case Tu:t=this.InterpolantFactoryMethodSmooth;break;case fp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return vl;case this.InterpolantFactoryMethodLinear:return Fu;case this.InterpolantFactoryMethodSmooth:return Tu;case this.InterpolantFactoryMethodBezier:return fp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Su(this.settings)&&(fv(this.settings.inTangents,e),fv(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Su(this.settings)&&(dv(this.settings.inTangents,e),dv(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&x1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Tu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,p=h+i;for(let _=0;_!==i;++_){let b=t[h+_];if(b!==t[f+_]||b!==t[p+_]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let p=0;p!==i;++p)t[f+p]=t[h+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Su(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function fv(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function dv(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ai.prototype.ValueTypeName="";Ai.prototype.TimeBufferType=Float32Array;Ai.prototype.ValueBufferType=Float32Array;Ai.prototype.DefaultInterpolation=Fu;var Mr=class extends Ai{constructor(e,t,i){super(e,t,i)}};Mr.prototype.ValueTypeName="bool";Mr.prototype.ValueBufferType=Array;Mr.prototype.DefaultInterpolation=vl;Mr.prototype.InterpolantFactoryMethodLinear=void 0;Mr.prototype.InterpolantFactoryMethodSmooth=void 0;var Qu=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};Qu.prototype.ValueTypeName="color";var eh=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};eh.prototype.ValueTypeName="number";var th=class extends Sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Mi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Dl=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new th(this.times,this.values,this.getValueSize(),e)}};Dl.prototype.ValueTypeName="quaternion";Dl.prototype.InterpolantFactoryMethodSmooth=void 0;var wr=class extends Ai{constructor(e,t,i){super(e,t,i)}};wr.prototype.ValueTypeName="string";wr.prototype.ValueBufferType=Array;wr.prototype.DefaultInterpolation=vl;wr.prototype.InterpolantFactoryMethodLinear=void 0;wr.prototype.InterpolantFactoryMethodSmooth=void 0;var nh=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};nh.prototype.ValueTypeName="vector";var ih=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let p=c[h],_=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},sy=new ih,sh=class{constructor(e){this.manager=e!==void 0?e:sy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};sh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Mu=new K,wu=new Mi,gs=new K,Nl=class extends Ti{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new sn,this.projectionMatrix=new sn,this.projectionMatrixInverse=new sn,this.coordinateSystem=Ni,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Mu,wu,gs),gs.x===1&&gs.y===1&&gs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mu,wu,gs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Mu,wu,gs),gs.x===1&&gs.y===1&&gs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mu,wu,gs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},vr=new K,pv=new tt,mv=new tt,si=class extends Nl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ua*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(gl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ua*2*Math.atan(Math.tan(gl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){vr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(vr.x,vr.y).multiplyScalar(-e/vr.z),vr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(vr.x,vr.y).multiplyScalar(-e/vr.z)}getViewSize(e,t){return this.getViewBounds(e,pv,mv),t.subVectors(mv,pv)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(gl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var rh=class extends Nl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var ma=class extends ys{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var ra=-90,oa=1,ga=class extends Ti{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new si(ra,oa,e,t);s.layers=this.layers,this.add(s);let r=new si(ra,oa,e,t);r.layers=this.layers,this.add(r);let o=new si(ra,oa,e,t);o.layers=this.layers,this.add(o);let a=new si(ra,oa,e,t);a.layers=this.layers,this.add(a);let l=new si(ra,oa,e,t);l.layers=this.layers,this.add(l);let c=new si(ra,oa,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ni)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===bl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,p),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},oh=class extends si{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Jp="\\[\\]\\.:\\/",rT=new RegExp("["+Jp+"]","g"),jp="[^"+Jp+"]",oT="[^"+Jp.replace("\\.","")+"]",aT=/((?:WC+[\/:])*)/.source.replace("WC",jp),lT=/(WCOD+)?/.source.replace("WCOD",oT),cT=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",jp),uT=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",jp),hT=new RegExp("^"+aT+lT+cT+uT+"$"),fT=["material","materials","bones","map"],gp=class{constructor(e,t,i){let s=i||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(rT,"")}static parseTrackName(e){let t=hT.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);fT.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=gp;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var $2=new Float32Array(1);var _a=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var _p=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Ul=class extends Zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Qp(n,e,t,i){let s=dT(i);switch(t){case Op:return n*e;case Bp:return n*e/s.components*s.byteLength;case dh:return n*e/s.components*s.byteLength;case Cr:return n*e*2/s.components*s.byteLength;case ph:return n*e*2/s.components*s.byteLength;case kp:return n*e*3/s.components*s.byteLength;case es:return n*e*4/s.components*s.byteLength;case mh:return n*e*4/s.components*s.byteLength;case kl:case Bl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case zl:case Vl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case _h:case yh:return Math.max(n,16)*Math.max(e,8)/4;case gh:case vh:return Math.max(n,8)*Math.max(e,8)/2;case xh:case bh:case Mh:case wh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Sh:case Gl:case Th:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Eh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ah:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Ch:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Rh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ph:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ih:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Lh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Dh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Nh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Uh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Fh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Oh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case kh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Bh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case zh:case Vh:case Gh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Hh:case Wh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Hl:case qh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function dT(n){switch(n){case Ci:case Dp:return{byteLength:1,components:1};case ba:case Np:case Qi:return{byteLength:2,components:1};case hh:case fh:return{byteLength:2,components:4};case Ji:case uh:case ji:return{byteLength:4,components:1};case Up:case Fp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ey(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function mT(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((p,_)=>p.start-_.start);let f=0;for(let p=1;p<h.length;p++){let _=h[f],b=h[p];b.start<=_.start+_.count+1?_.count=Math.max(_.count,b.start+b.count-_.start):(++f,h[f]=b)}h.length=f+1;for(let p=0,_=h.length;p<_;p++){let b=h[p];n.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var gT=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_T=`#ifdef USE_ALPHAHASH
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
#endif`,vT=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yT=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,xT=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,bT=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ST=`#ifdef USE_AOMAP
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
#endif`,MT=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wT=`#ifdef USE_BATCHING
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
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,TT=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ET=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,AT=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,CT=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,RT=`#ifdef USE_IRIDESCENCE
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
#endif`,PT=`#ifdef USE_BUMPMAP
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
#endif`,IT=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,LT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,DT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,NT=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,UT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,FT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,OT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,kT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,BT=`#define PI 3.141592653589793
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
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
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
} // validated`,zT=`vec3 transformedNormal = objectNormal;
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
#endif`,VT=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,GT=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,HT=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,WT=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qT="gl_FragColor = linearToOutputTexel( gl_FragColor );",XT=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,$T=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,YT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,KT=`#ifdef USE_ENVMAP
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
#endif`,ZT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,JT=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,jT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,QT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,eE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,tE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,nE=`#ifdef USE_GRADIENTMAP
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
}`,iE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,sE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,rE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,oE=`uniform bool receiveShadow;
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
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
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
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
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
#endif
#include <lightprobes_pars_fragment>`,aE=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,lE=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,cE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,uE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,hE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,fE=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
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
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
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
#endif`,dE=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
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
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
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
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
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
		return 0.5 / max( gv + gl, EPSILON );
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
		float roughness = max( material.clearcoatRoughness, 0.045 );
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
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
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
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
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
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
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
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
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
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,pE=`
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
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
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
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,mE=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,gE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_E=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,vE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,yE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,xE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,SE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,ME=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,wE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,TE=`#if defined( USE_POINTS_UV )
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
#endif`,EE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,AE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,CE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,RE=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,PE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,IE=`#ifdef USE_MORPHTARGETS
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
#endif`,LE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,DE=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#ifdef DOUBLE_SIDED
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
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,NE=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,UE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,FE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,OE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,kE=`#ifdef USE_NORMALMAP
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
#endif`,BE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,zE=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,VE=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,GE=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,HE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,WE=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,qE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,XE=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,$E=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,YE=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,KE=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ZE=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,JE=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
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
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,jE=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
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
#endif`,QE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
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
#endif`,eA=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
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
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
}`,tA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nA=`#ifdef USE_SKINNING
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
#endif`,iA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sA=`#ifdef USE_SKINNING
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
#endif`,rA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,oA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,aA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,cA=`#ifdef USE_TRANSMISSION
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
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,uA=`#ifdef USE_TRANSMISSION
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
#endif`,hA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,fA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,dA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
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
#endif`,pA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gA=`uniform sampler2D t2D;
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
}`,_A=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vA=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bA=`#include <common>
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
}`,SA=`#if DEPTH_PACKING == 3200
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,MA=`#define DISTANCE
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
}`,wA=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,TA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,EA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AA=`uniform float scale;
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
}`,CA=`uniform vec3 diffuse;
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
}`,RA=`#include <common>
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
}`,PA=`uniform vec3 diffuse;
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
}`,IA=`#define LAMBERT
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
}`,LA=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,DA=`#define MATCAP
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
}`,NA=`#define MATCAP
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
}`,UA=`#define NORMAL
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
}`,FA=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
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
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,OA=`#define PHONG
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
}`,kA=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,BA=`#define STANDARD
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
}`,zA=`#define STANDARD
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
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
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
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
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
}`,VA=`#define TOON
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
}`,GA=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
}`,HA=`uniform float size;
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
}`,WA=`uniform vec3 diffuse;
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
}`,qA=`#include <common>
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
}`,XA=`uniform vec3 color;
uniform float opacity;
#include <common>
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
	#include <premultiplied_alpha_fragment>
}`,$A=`uniform float rotation;
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
}`,YA=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:gT,alphahash_pars_fragment:_T,alphamap_fragment:vT,alphamap_pars_fragment:yT,alphatest_fragment:xT,alphatest_pars_fragment:bT,aomap_fragment:ST,aomap_pars_fragment:MT,batching_pars_vertex:wT,batching_vertex:TT,begin_vertex:ET,beginnormal_vertex:AT,bsdfs:CT,iridescence_fragment:RT,bumpmap_pars_fragment:PT,clipping_planes_fragment:IT,clipping_planes_pars_fragment:LT,clipping_planes_pars_vertex:DT,clipping_planes_vertex:NT,color_fragment:UT,color_pars_fragment:FT,color_pars_vertex:OT,color_vertex:kT,common:BT,defaultnormal_vertex:zT,displacementmap_pars_vertex:VT,displacementmap_vertex:GT,emissivemap_fragment:HT,emissivemap_pars_fragment:WT,colorspace_fragment:qT,colorspace_pars_fragment:XT,envmap_fragment:$T,envmap_common_pars_fragment:YT,envmap_pars_fragment:KT,envmap_pars_vertex:ZT,envmap_physical_pars_fragment:aE,envmap_vertex:JT,fog_vertex:jT,fog_pars_vertex:QT,fog_fragment:eE,fog_pars_fragment:tE,gradientmap_pars_fragment:nE,lightmap_pars_fragment:iE,lights_lambert_fragment:sE,lights_lambert_pars_fragment:rE,lights_pars_begin:oE,lights_toon_fragment:lE,lights_toon_pars_fragment:cE,lights_phong_fragment:uE,lights_phong_pars_fragment:hE,lights_physical_fragment:fE,lights_physical_pars_fragment:dE,lights_fragment_begin:pE,lights_fragment_maps:mE,lights_fragment_end:gE,lightprobes_pars_fragment:_E,logdepthbuf_fragment:vE,logdepthbuf_pars_fragment:yE,logdepthbuf_pars_vertex:xE,logdepthbuf_vertex:bE,map_fragment:SE,map_pars_fragment:ME,map_particle_fragment:wE,map_particle_pars_fragment:TE,metalnessmap_fragment:EE,metalnessmap_pars_fragment:AE,morphinstance_vertex:CE,morphcolor_vertex:RE,morphnormal_vertex:PE,morphtarget_pars_vertex:IE,morphtarget_vertex:LE,normal_fragment_begin:DE,normal_fragment_maps:NE,normal_pars_fragment:UE,normal_pars_vertex:FE,normal_vertex:OE,normalmap_pars_fragment:kE,clearcoat_normal_fragment_begin:BE,clearcoat_normal_fragment_maps:zE,clearcoat_pars_fragment:VE,iridescence_pars_fragment:GE,opaque_fragment:HE,packing:WE,premultiplied_alpha_fragment:qE,project_vertex:XE,dithering_fragment:$E,dithering_pars_fragment:YE,roughnessmap_fragment:KE,roughnessmap_pars_fragment:ZE,shadowmap_pars_fragment:JE,shadowmap_pars_vertex:jE,shadowmap_vertex:QE,shadowmask_pars_fragment:eA,skinbase_vertex:tA,skinning_pars_vertex:nA,skinning_vertex:iA,skinnormal_vertex:sA,specularmap_fragment:rA,specularmap_pars_fragment:oA,tonemapping_fragment:aA,tonemapping_pars_fragment:lA,transmission_fragment:cA,transmission_pars_fragment:uA,uv_pars_fragment:hA,uv_pars_vertex:fA,uv_vertex:dA,worldpos_vertex:pA,background_vert:mA,background_frag:gA,backgroundCube_vert:_A,backgroundCube_frag:vA,cube_vert:yA,cube_frag:xA,depth_vert:bA,depth_frag:SA,distance_vert:MA,distance_frag:wA,equirect_vert:TA,equirect_frag:EA,linedashed_vert:AA,linedashed_frag:CA,meshbasic_vert:RA,meshbasic_frag:PA,meshlambert_vert:IA,meshlambert_frag:LA,meshmatcap_vert:DA,meshmatcap_frag:NA,meshnormal_vert:UA,meshnormal_frag:FA,meshphong_vert:OA,meshphong_frag:kA,meshphysical_vert:BA,meshphysical_frag:zA,meshtoon_vert:VA,meshtoon_frag:GA,points_vert:HA,points_frag:WA,shadow_vert:qA,shadow_frag:XA,sprite_vert:$A,sprite_frag:YA},Le={common:{diffuse:{value:new xt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new xt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new xt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new xt(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},Ss={basic:{uniforms:Zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},specular:{value:new xt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Zn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Zn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new xt(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Zn([Le.points,Le.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Zn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Zn([Le.common,Le.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Zn([Le.sprite,Le.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Zn([Le.common,Le.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Zn([Le.lights,Le.fog,{color:{value:new xt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};Ss.physical={uniforms:Zn([Ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new xt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new xt(0)},specularColor:{value:new xt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Xh={r:0,b:0,g:0},KA=new sn,Ay=new nt;Ay.set(-1,0,0,0,1,0,0,0,1);function ZA(n,e,t,i,s,r){let o=new xt(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function p(x){let A=x.isScene===!0?x.background:null;if(A&&A.isTexture){let S=x.backgroundBlurriness>0;A=e.get(A,S)}return A}function _(x){let A=!1,S=p(x);S===null?g(o,a):S&&S.isColor&&(g(S,1),A=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(x,A){let S=p(A);S&&S.isCubeTexture?(c===void 0&&(c=new Ui(new pa(1,1,1),new Ei({name:"BackgroundCubeMaterial",uniforms:oo(Ss.backgroundCube.uniforms),vertexShader:Ss.backgroundCube.vertexShader,fragmentShader:Ss.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(KA.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ay),c.material.toneMapped=yt.getTransfer(S.colorSpace)!==Lt,(u!==S||h!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Ui(new Ll(2,2),new Ei({name:"BackgroundMaterial",uniforms:oo(Ss.background.uniforms),vertexShader:Ss.background.vertexShader,fragmentShader:Ss.background.fragmentShader,side:Ar,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=yt.getTransfer(S.colorSpace)!==Lt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,A){x.getRGB(Xh,Zp(n)),t.buffers.color.setClear(Xh.r,Xh.g,Xh.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,A=1){o.set(x),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:_,addToRenderList:b,dispose:m}}function JA(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(L,B,V,U,H){let Y=!1,G=h(L,U,V,B);r!==G&&(r=G,c(r.object)),Y=p(L,U,V,H),Y&&_(L,U,V,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(L,B,V,U),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,B,V,U){let H=U.wireframe===!0,Y=i[B.id];Y===void 0&&(Y={},i[B.id]=Y);let G=L.isInstancedMesh===!0?L.id:0,le=Y[G];le===void 0&&(le={},Y[G]=le);let J=le[V.id];J===void 0&&(J={},le[V.id]=J);let Q=J[H];return Q===void 0&&(Q=f(l()),J[H]=Q),Q}function f(L){let B=[],V=[],U=[];for(let H=0;H<t;H++)B[H]=0,V[H]=0,U[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:U,object:L,attributes:{},index:null}}function p(L,B,V,U){let H=r.attributes,Y=B.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let se=H[J],fe=Y[J];if(fe===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;G++}return r.attributesNum!==G||r.index!==U}function _(L,B,V,U){let H={},Y=B.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let se=Y[J];se===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[J]=fe,G++}r.attributes=H,r.attributesNum=G,r.index=U}function b(){let L=r.newAttributes;for(let B=0,V=L.length;B<V;B++)L[B]=0}function g(L){m(L,0)}function m(L,B){let V=r.newAttributes,U=r.enabledAttributes,H=r.attributeDivisors;V[L]=1,U[L]===0&&(n.enableVertexAttribArray(L),U[L]=1),H[L]!==B&&(n.vertexAttribDivisor(L,B),H[L]=B)}function x(){let L=r.newAttributes,B=r.enabledAttributes;for(let V=0,U=B.length;V<U;V++)B[V]!==L[V]&&(n.disableVertexAttribArray(V),B[V]=0)}function A(L,B,V,U,H,Y,G){G===!0?n.vertexAttribIPointer(L,B,V,H,Y):n.vertexAttribPointer(L,B,V,U,H,Y)}function S(L,B,V,U){b();let H=U.attributes,Y=V.getAttributes(),G=B.defaultAttributeValues;for(let le in Y){let J=Y[le];if(J.location>=0){let Q=H[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let se=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ve=he.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===uh;if(Q.isInterleavedBufferAttribute){let Se=Q.data,We=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,rt=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Ge=0;Ge<J.locationSize;Ge++)m(J.location+Ge,Se.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Ge=0;Ge<J.locationSize;Ge++)g(J.location+Ge);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ge=0;Ge<J.locationSize;Ge++)A(J.location+Ge,fe/J.locationSize,me,se,We*ve,(rt+fe/J.locationSize*Ge)*ve,Ae)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<J.locationSize;Se++)m(J.location+Se,Q.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<J.locationSize;Se++)g(J.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<J.locationSize;Se++)A(J.location+Se,fe/J.locationSize,me,se,fe*ve,fe/J.locationSize*Se*ve,Ae)}}else if(G!==void 0){let se=G[le];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(J.location,se);break;case 3:n.vertexAttrib3fv(J.location,se);break;case 4:n.vertexAttrib4fv(J.location,se);break;default:n.vertexAttrib1fv(J.location,se)}}}}x()}function P(){k();for(let L in i){let B=i[L];for(let V in B){let U=B[V];for(let H in U){let Y=U[H];for(let G in Y)u(Y[G].object),delete Y[G];delete U[H]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let B=i[L.id];for(let V in B){let U=B[V];for(let H in U){let Y=U[H];for(let G in Y)u(Y[G].object),delete Y[G];delete U[H]}}delete i[L.id]}function v(L){for(let B in i){let V=i[B];for(let U in V){let H=V[U];if(H[L.id]===void 0)continue;let Y=H[L.id];for(let G in Y)u(Y[G].object),delete Y[G];delete H[L.id]}}}function E(L){for(let B in i){let V=i[B],U=L.isInstancedMesh===!0?L.id:0,H=V[U];if(H!==void 0){for(let Y in H){let G=H[Y];for(let le in G)u(G[le].object),delete G[le];delete H[Y]}delete V[U],Object.keys(V).length===0&&delete i[B]}}}function k(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:N,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:b,enableAttribute:g,disableUnusedAttributes:x}}function jA(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let p=0;p<u;p++)f+=c[p];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function QA(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==es&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===Qi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Ci&&v!==ji&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:p,maxVertexTextures:_,maxTextureSize:b,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:x,maxVaryings:A,maxFragmentUniforms:S,maxSamples:P,samples:C}}function eC(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Si,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||i!==0||s;return s=f,i=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,p){let _=h.clippingPlanes,b=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||_===null||_.length===0||r&&!g)r?u(null):c();else{let x=r?0:i,A=x*4,S=m.clippingState||null;l.value=S,S=u(_,f,A,p);for(let P=0;P!==A;++P)S[P]=t[P];m.clippingState=S,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,p,_){let b=h!==null?h.length:0,g=null;if(b!==0){if(g=l.value,_!==!0||g===null){let m=p+b*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,S=p;A!==b;++A,S+=4)o.copy(h[A]).applyMatrix4(x,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,g}}var Xl=class extends wi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Rl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new pa(5,5,5),r=new Ei({name:"CubemapFromEquirect",uniforms:oo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:no});r.uniforms.tEquirect.value=t;let o=new Ui(s,r),a=t.minFilter;return t.minFilter===Ws&&(t.minFilter=Wn),new ga(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},ry=256,tC=3,nC=20,Cy=256,Ry=16,iC=3,sC=new K,rC=new xt,Yh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ga(1,10,null),this._boxMesh=new Ui(new pa(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=sC}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,_=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(rC));let g=new ga(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=_,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ly(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ay(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(ry,$p(e))}_fromTexture(e,t){e.mapping===so||e.mapping===xa?this._setSize(e.image.length===0?ry:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=oy(e,!1,!1),i=Math.log2(e)-tC;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=oy(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===so||e.mapping===xa?(this._cubemapMaterial===null&&(this._cubemapMaterial=ly()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ay()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=oC(),this._integrationMaterial=aC());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Ry);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-iC)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Cy*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=lC());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function oy(n,e,t){return new Xl(n,{minFilter:Ws,generateMipmaps:e,type:Qi,colorSpace:yl,depthBuffer:t})}function $l(n,e,t){return new Ei({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:oi,blending:no,depthTest:!1,depthWrite:!1})}function oC(){return $l("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Cy}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function aC(){return $l("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ry}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function lC(){return $l("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${nC}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function ay(){return $l("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function ly(){return $l("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function cC(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,p=!1){return f==null?null:p?o(f):r(f)}function r(f){if(f&&f.isTexture){let p=f.mapping;if(p===ah||p===lh)if(e.has(f)){let _=e.get(f).texture;return a(_,f.mapping)}else{let _=f.image;if(_&&_.height>0){let b=new Xl(_.height);return b.fromEquirectangularTexture(n,f),e.set(f,b),f.addEventListener("dispose",c),a(b.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,_=p===ah||p===lh,b=p===so||p===xa;if(_||b){let g=t.get(f),m=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Yh(n)),g=_?i.fromEquirectangular(f,g):i.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),g.texture;if(g!==void 0)return g.texture;{let x=f.image;return _&&x&&x.height>0||b&&x&&l(x)?(i===null&&(i=new Yh(n)),g=_?i.fromEquirectangular(f):i.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,p){return p===ah?f.mapping=so:p===lh&&(f.mapping=xa),f}function l(f){let p=0,_=6;for(let b=0;b<_;b++)f[b]!==void 0&&p++;return p===_}function c(f){let p=f.target;p.removeEventListener("dispose",c);let _=e.get(p);_!==void 0&&(e.delete(p),_.dispose())}function u(f){let p=f.target;p.removeEventListener("dispose",u);let _=t.get(p);_!==void 0&&(t.delete(p),_.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function uC(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ml("WebGLRenderer: "+i+" extension not supported."),s}}}function hC(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(_=>delete s[_]);function a(_){l(_.target)}function l(_){_.index!==null&&e.remove(_.index);for(let g in _.attributes)e.remove(_.attributes[g]);_.removeEventListener("dispose",a),delete s[_.id],o.unregister(_);let b=r.get(_);b&&(e.remove(b),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}function c(_,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function u(_){let b=_.attributes;for(let g in b)e.update(b[g],n.ARRAY_BUFFER)}function h(_){let b=_.index,g=_.attributes.position,m=0;if(g===void 0)return;let x=b!==null?b.array.length:g.array.length/3-1,A=g.count>=65535?Al:El,S=new A(Math.ceil(x/3)*6,1),P=S.array;if(b!==null){let v=b.array;m=b.version;for(let E=0,k=0;E<x;E+=3){let N=v[E+0],L=v[E+1],B=v[E+2];P[k++]=N,P[k++]=L,P[k++]=L,P[k++]=B,P[k++]=B,P[k++]=N}}else{m=g.version;for(let v=0,E=0;v<x;v+=3){let k=v+0,N=v+1,L=v+2;P[E++]=k,P[E++]=N,P[E++]=N,P[E++]=L,P[E++]=L,P[E++]=k}}S.version=m;let C=r.get(_);C&&e.remove(C),r.set(_,S)}function f(_){let b=r.get(_);if(b){let g=_.index;g!==null&&b.version<g.version&&h(_)}else h(_);return r.get(_)}function p(){for(let _ in s){let b=s[_].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:f,dispose:p}}function fC(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,p){p!==0&&(n.drawElementsInstanced(i,f,r,h*o,p),t.update(f,i,p))}function u(h,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,p);let b=0;for(let g=0;g<p;g++)b+=f[g];t.update(b,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function dC(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function pC(n,e,t){let i=new WeakMap,s=new rn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let k=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",k)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],A=0;p===!0&&(A=1),_===!0&&(A=2),b===!0&&(A=3);let S=a.attributes.position.count*A,P=1;S>e.maxTextureSize&&(P=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*P*4*h),v=new Ml(C,S,P,h);v.type=ji,v.needsUpdate=!0;let E=A*4;for(let N=0;N<h;N++){let L=g[N],B=m[N],V=x[N],U=S*P*4*N;for(let H=0;H<L.count;H++){let Y=H*E;p===!0&&(s.fromBufferAttribute(L,H),C[U+Y+0]=s.x,C[U+Y+1]=s.y,C[U+Y+2]=s.z,C[U+Y+3]=0),_===!0&&(s.fromBufferAttribute(B,H),C[U+Y+4]=s.x,C[U+Y+5]=s.y,C[U+Y+6]=s.z,C[U+Y+7]=0),b===!0&&(s.fromBufferAttribute(V,H),C[U+Y+8]=s.x,C[U+Y+9]=s.y,C[U+Y+10]=s.z,C[U+Y+11]=V.itemSize===4?s.w:1)}}f={count:h,texture:v,size:new tt(S,P)},i.set(a,f),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let b=0;b<c.length;b++)p+=c[b];let _=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function mC(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var gC={[Tp]:"LINEAR_TONE_MAPPING",[Ep]:"REINHARD_TONE_MAPPING",[Ap]:"CINEON_TONE_MAPPING",[Cp]:"ACES_FILMIC_TONE_MAPPING",[Pp]:"AGX_TONE_MAPPING",[Ip]:"NEUTRAL_TONE_MAPPING",[Rp]:"CUSTOM_TONE_MAPPING"};function _C(n,e,t,i,s,r){let o=new wi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new ys;u.setAttribute("position",new li([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new li([0,2,0,0,2,0],2));let h=new Xu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Ui(u,h),p=new rh(-1,1,1,-1,0,1),_=null,b=null,g=!1,m,x=null,A=[],S=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let v=0;v<A.length;v++){let E=A[v];E.setSize&&E.setSize(P,C)}},this.setEffects=function(P){A=P,S=A.length>0&&A[0].isRenderPass===!0;let C=o.width,v=o.height;A.length>0&&a===null&&(a=new wi(C,v,{type:Qi,depthBuffer:!1,stencilBuffer:!1}),l=new wi(C,v,{type:Qi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&A.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Hs(C,v),r===!0&&(c.format=qs,c.type=ro)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<A.length;k++){let N=A[k];N.setSize&&N.setSize(C,v),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(P,C){if(g||P.toneMapping===xs&&A.length===0)return!1;if(x=C,C!==null){let v=C.width,E=C.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return S===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=xs,!0},this.hasRenderPass=function(){return S},this.end=function(P,C){P.toneMapping=m,g=!0;let v=o,E=a;for(let k=0;k<A.length;k++){let N=A[k];N.enabled!==!1&&(N.render(P,E,v,C),N.needsSwap!==!1&&(v=E,E=E===a?l:a))}if(_!==P.outputColorSpace||b!==P.toneMapping){_=P.outputColorSpace,b=P.toneMapping,h.defines={},yt.getTransfer(_)===Lt&&(h.defines.SRGB_TRANSFER="");let k=gC[b];k&&(h.defines[k]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=v.texture,P.setRenderTarget(x),P.render(f,p),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Py=new ci,Iy=new Hs(1,1),Ly=new Pl(1),Dy=new Ml,Ny=new Bu,Uy=new Rl,cy=[],uy=[],hy=new Float32Array(16),fy=new Float32Array(9),dy=new Float32Array(4);function wa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=cy[s];if(r===void 0&&(r=new Float32Array(s),cy[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function In(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ln(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Zh(n,e){let t=uy[e];t===void 0&&(t=new Int32Array(e),uy[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function vC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function yC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(In(t,e))return;n.uniform2fv(this.addr,e),Ln(t,e)}}function xC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(In(t,e))return;n.uniform3fv(this.addr,e),Ln(t,e)}}function bC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(In(t,e))return;n.uniform4fv(this.addr,e),Ln(t,e)}}function SC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(In(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ln(t,e)}else{if(In(t,i))return;dy.set(i),n.uniformMatrix2fv(this.addr,!1,dy),Ln(t,i)}}function MC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(In(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ln(t,e)}else{if(In(t,i))return;fy.set(i),n.uniformMatrix3fv(this.addr,!1,fy),Ln(t,i)}}function wC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(In(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ln(t,e)}else{if(In(t,i))return;hy.set(i),n.uniformMatrix4fv(this.addr,!1,hy),Ln(t,i)}}function TC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function EC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(In(t,e))return;n.uniform2iv(this.addr,e),Ln(t,e)}}function AC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(In(t,e))return;n.uniform3iv(this.addr,e),Ln(t,e)}}function CC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(In(t,e))return;n.uniform4iv(this.addr,e),Ln(t,e)}}function RC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function PC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(In(t,e))return;n.uniform2uiv(this.addr,e),Ln(t,e)}}function IC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(In(t,e))return;n.uniform3uiv(this.addr,e),Ln(t,e)}}function LC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(In(t,e))return;n.uniform4uiv(this.addr,e),Ln(t,e)}}function Jh(n){return n.version===0&&(n.compareFunction=Hp,n.needsUpdate=!0),n}function DC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Jh(Iy):r=Py,t.setTexture2D(e||r,s)}function NC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Ny,s)}function UC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Jh(Ly):r=Uy,t.setTextureCube(e||r,s)}function FC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Dy,s)}function OC(n){switch(n){case 5126:return vC;case 35664:return yC;case 35665:return xC;case 35666:return bC;case 35674:return SC;case 35675:return MC;case 35676:return wC;case 5124:case 35670:return TC;case 35667:case 35671:return EC;case 35668:case 35672:return AC;case 35669:case 35673:return CC;case 5125:return RC;case 36294:return PC;case 36295:return IC;case 36296:return LC;case 35678:case 36198:case 36298:case 36306:case 35682:return DC;case 35679:case 36299:case 36307:return NC;case 35680:case 36300:case 36308:case 36293:return UC;case 36289:case 36303:case 36311:case 36292:return FC}}function kC(n,e){n.uniform1fv(this.addr,e)}function BC(n,e){let t=wa(e,this.size,2);n.uniform2fv(this.addr,t)}function zC(n,e){let t=wa(e,this.size,3);n.uniform3fv(this.addr,t)}function VC(n,e){let t=wa(e,this.size,4);n.uniform4fv(this.addr,t)}function GC(n,e){let t=wa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function HC(n,e){let t=wa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function WC(n,e){let t=wa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function qC(n,e){n.uniform1iv(this.addr,e)}function XC(n,e){n.uniform2iv(this.addr,e)}function $C(n,e){n.uniform3iv(this.addr,e)}function YC(n,e){n.uniform4iv(this.addr,e)}function KC(n,e){n.uniform1uiv(this.addr,e)}function ZC(n,e){n.uniform2uiv(this.addr,e)}function JC(n,e){n.uniform3uiv(this.addr,e)}function jC(n,e){n.uniform4uiv(this.addr,e)}function QC(n,e,t){let i=this.cache,s=e.length,r=Zh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Jh(Iy):o=Py;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function eR(n,e,t){let i=this.cache,s=e.length,r=Zh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Ny,r[o])}function tR(n,e,t){let i=this.cache,s=e.length,r=Zh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Jh(Ly):o=Uy;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function nR(n,e,t){let i=this.cache,s=e.length,r=Zh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Dy,r[o])}function iR(n){switch(n){case 5126:return kC;case 35664:return BC;case 35665:return zC;case 35666:return VC;case 35674:return GC;case 35675:return HC;case 35676:return WC;case 5124:case 35670:return qC;case 35667:case 35671:return XC;case 35668:case 35672:return $C;case 35669:case 35673:return YC;case 5125:return KC;case 36294:return ZC;case 36295:return JC;case 36296:return jC;case 35678:case 36198:case 36298:case 36306:case 35682:return QC;case 35679:case 36299:case 36307:return eR;case 35680:case 36300:case 36308:case 36293:return tR;case 36289:case 36303:case 36311:case 36292:return nR}}var nm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=OC(t.type)}},im=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=iR(t.type)}},sm=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},em=/(\w+)(\])?(\[|\.)?/g;function py(n,e){n.seq.push(e),n.map[e.id]=e}function sR(n,e,t){let i=n.name,s=i.length;for(em.lastIndex=0;;){let r=em.exec(i),o=em.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){py(t,c===void 0?new nm(a,n,e):new im(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new sm(a),py(t,h)),t=h}}}var Ma=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);sR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function my(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var rR=37297,oR=0;function aR(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var gy=new nt;function lR(n){yt._getMatrix(gy,yt.workingColorSpace,n);let e=`mat3( ${gy.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(n)){case xl:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function _y(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+aR(n.getShaderSource(e),a)}else return r}function cR(n,e){let t=lR(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var uR={[Tp]:"Linear",[Ep]:"Reinhard",[Ap]:"Cineon",[Cp]:"ACESFilmic",[Pp]:"AgX",[Ip]:"Neutral",[Rp]:"Custom"};function hR(n,e){let t=uR[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var $h=new K;function fR(){yt.getLuminanceCoefficients($h);let n=$h.x.toFixed(4),e=$h.y.toFixed(4),t=$h.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function dR(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ql).join(`
`)}function pR(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function mR(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ql(n){return n!==""}function vy(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function yy(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var gR=/^[ \t]*#include +<([\w\d./]+)>/gm;function rm(n){return n.replace(gR,_R)}function _R(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return rm(t)}var vR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function xy(n){return n.replace(vR,yR)}function yR(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function by(n){let e=`precision ${n.precision} float;
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
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var xR={[Fl]:"SHADOWMAP_TYPE_PCF",[va]:"SHADOWMAP_TYPE_VSM"};function bR(n){return xR[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var SR={[xa]:"ENVMAP_MODE_REFRACTION"};function MR(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":SR[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var wR={[wp]:"ENVMAP_BLENDING_MULTIPLY",[Ov]:"ENVMAP_BLENDING_MIX",[kv]:"ENVMAP_BLENDING_ADD"};function TR(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":wR[n.combine]||"ENVMAP_BLENDING_NONE"}function ER(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=bR(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=MR(t),h=TR(t),f=dR(t),p=pR(r),_=s.createProgram(),b,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ql).join(`
`),b.length>0&&(b+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ql).join(`
`),g.length>0&&(g+=`
`)):(b=[by(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ql).join(`
`),g=[by(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==xs?"#define TONE_MAPPING":"",t.toneMapping!==xs?ht.tonemapping_pars_fragment:"",t.toneMapping!==xs?hR("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,cR("linearToOutputTexel",t.outputColorSpace),fR(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ql).join(`
`)),o=rm(o),o=vy(o,t),o=yy(o,t),a=rm(a),a=vy(a,t),a=yy(a,t),o=xy(o),a=xy(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,b=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,g=["#define varying in",t.glslVersion===Wp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Wp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=m+b+o,A=m+g+a,S=my(s,s.VERTEX_SHADER,x),P=my(s,s.FRAGMENT_SHADER,A);s.attachShader(_,S),s.attachShader(_,P),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function C(N){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(_)||"",B=s.getShaderInfoLog(S)||"",V=s.getShaderInfoLog(P)||"",U=L.trim(),H=B.trim(),Y=V.trim(),G=!0,le=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,S,P);else{let J=_y(s,S,"vertex"),Q=_y(s,P,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+U+`
`+J+`
`+Q)}else U!==""?Ye("WebGLProgram: Program Info Log:",U):(H===""||Y==="")&&(le=!1);le&&(N.diagnostics={runnable:G,programLog:U,vertexShader:{log:H,prefix:b},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(S),s.deleteShader(P),v=new Ma(s,_),E=mR(s,_)}let v;this.getUniforms=function(){return v===void 0&&C(this),v};let E;this.getAttributes=function(){return E===void 0&&C(this),E};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(_,rR)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=oR++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=S,this.fragmentShader=P,this}var AR=0,om=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new am(e),t.set(e,i)),i}},am=class{constructor(e){this.id=AR++,this.code=e,this.usedTimes=0}};function CR(n){return n===Cr||n===Gl||n===Hl}function RR(n,e,t,i,s,r){let o=new wl,a=new om,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(v){return l.add(v),v===0?"uv":`uv${v}`}function _(v,E,k,N,L,B){let V=N.fog,U=L.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?N.environment:null,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||H,Y),le=f[v.type],J=i.precision;v.precision!==null&&(J=i.getMaxPrecision(v.precision),J!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,se=Q!==void 0?Q.length:0,fe=0;U.morphAttributes.position!==void 0&&(fe=1),U.morphAttributes.normal!==void 0&&(fe=2),U.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ve;if(le){let Ce=Ss[le];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),at=a.getFragmentShaderStage(v);a.update(v,Ce,at),me=Ce.id,ve=at.id}let Ae=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),We=L.isInstancedMesh===!0,rt=L.isBatchedMesh===!0,Ge=!!v.map,ft=!!v.matcap,ct=!!G,it=ct&&G.isPMREMTexture===!0,jt=!!v.aoMap,Ht=!!v.lightMap,gn=!!v.bumpMap&&v.wireframe===!1,Ot=!!v.normalMap,Fn=!!v.displacementMap,St=!!v.emissiveMap,Tn=!!v.metalnessMap,ln=!!v.roughnessMap,_n=v.anisotropy>0,O=v.clearcoat>0,Re=v.diffuseRoughness>0,Ke=v.dispersion>0,ot=v.retroreflectivity>0,Me=v.iridescence>0,zt=v.sheen>0,Ve=v.transmission>0,Xe=_n&&!!v.anisotropyMap,R=O&&!!v.clearcoatMap,M=O&&!!v.clearcoatNormalMap,q=O&&!!v.clearcoatRoughnessMap,ue=Re&&!!v.diffuseRoughnessMap,oe=Me&&!!v.iridescenceMap,_e=Me&&!!v.iridescenceThicknessMap,ye=zt&&!!v.sheenColorMap,te=zt&&!!v.sheenRoughnessMap,ie=!!v.specularMap,pe=!!v.specularColorMap,F=!!v.specularIntensityMap,re=Ve&&!!v.transmissionMap,ne=Ve&&!!v.thicknessMap,we=!!v.gradientMap,ge=!!v.alphaMap,be=v.alphaTest>0,He=!!v.alphaHash,Je=!!v.extensions,ce=xs;v.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=it?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,je={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:rt,batchingColor:rt&&L._colorsTexture!==null,instancing:We,instancingColor:We&&L.instanceColor!==null,instancingMorph:We&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:yt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ge,matcap:ft,envMap:ct,envMapMode:ct&&G.mapping,envMapPMREM:it,envMapMaxLod:it?ke.length-1:null,envMapSize:it?ke[0].width:null,aoMap:jt,lightMap:Ht,bumpMap:gn,normalMap:Ot,displacementMap:Fn,emissiveMap:St,normalMapObjectSpace:Ot&&v.normalMapType===Vv,normalMapTangentSpace:Ot&&v.normalMapType===zp,packedNormalMap:Ot&&v.normalMapType===zp&&CR(v.normalMap.format),metalnessMap:Tn,roughnessMap:ln,anisotropy:_n,anisotropyMap:Xe,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ke,retroreflection:ot,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:_e,sheen:zt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:pe,specularIntensityMap:F,transmission:Ve,transmissionMap:re,thicknessMap:ne,gradientMap:we,opaque:v.transparent===!1&&v.blending===ya&&v.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:He,combine:v.combine,mapUv:Ge&&p(v.map.channel),aoMapUv:jt&&p(v.aoMap.channel),lightMapUv:Ht&&p(v.lightMap.channel),bumpMapUv:gn&&p(v.bumpMap.channel),normalMapUv:Ot&&p(v.normalMap.channel),displacementMapUv:Fn&&p(v.displacementMap.channel),emissiveMapUv:St&&p(v.emissiveMap.channel),metalnessMapUv:Tn&&p(v.metalnessMap.channel),roughnessMapUv:ln&&p(v.roughnessMap.channel),anisotropyMapUv:Xe&&p(v.anisotropyMap.channel),clearcoatMapUv:R&&p(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&p(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&p(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(v.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&p(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&p(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(v.sheenRoughnessMap.channel),specularMapUv:ie&&p(v.specularMap.channel),specularColorMapUv:pe&&p(v.specularColorMap.channel),specularIntensityMapUv:F&&p(v.specularIntensityMap.channel),transmissionMapUv:re&&p(v.transmissionMap.channel),thicknessMapUv:ne&&p(v.thicknessMap.channel),alphaMapUv:ge&&p(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ot||_n),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(Ge||ge),fog:!!V,useFog:v.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&Ot===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Se,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:B.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ge&&v.map.isVideoTexture===!0&&yt.getTransfer(v.map.colorSpace)===Lt,decodeVideoTextureEmissive:St&&v.emissiveMap.isVideoTexture===!0&&yt.getTransfer(v.emissiveMap.colorSpace)===Lt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Fi,flipSided:v.side===oi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&v.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function b(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let k in v.defines)E.push(k),E.push(v.defines[k]);return v.isRawShaderMaterial===!1&&(g(E,v),m(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function g(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function m(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let E=f[v.type],k;if(E){let N=Ss[E];k=ny.clone(N.uniforms)}else k=v.uniforms;return k}function A(v,E){let k=u.get(E);return k!==void 0?++k.usedTimes:(k=new ER(n,E,v,s),c.push(k),u.set(E,k)),k}function S(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function P(v){a.remove(v)}function C(){a.dispose()}return{getParameters:_,getProgramCacheKey:b,getUniforms:x,acquireProgram:A,releaseProgram:S,releaseShaderCache:P,programs:c,dispose:C}}function PR(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function IR(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Sy(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function My(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,_,b,g,m){let x=n[e];return x===void 0?(x={id:f.id,object:f,geometry:p,material:_,materialVariant:o(f),groupOrder:b,renderOrder:f.renderOrder,z:g,group:m},n[e]=x):(x.id=f.id,x.object=f,x.geometry=p,x.material=_,x.materialVariant=o(f),x.groupOrder=b,x.renderOrder=f.renderOrder,x.z=g,x.group=m),e++,x}function l(f,p,_,b,g,m,x){x.reversedDepth===!0&&(g=-g);let A=a(f,p,_,b,g,m);_.transmission>0?i.push(A):_.transparent===!0?s.push(A):t.push(A)}function c(f,p,_,b,g,m){let x=a(f,p,_,b,g,m);_.transmission>0?i.unshift(x):_.transparent===!0?s.unshift(x):t.unshift(x)}function u(f,p){t.length>1&&t.sort(f||IR),i.length>1&&i.sort(p||Sy),s.length>1&&s.sort(p||Sy)}function h(){for(let f=e,p=n.length;f<p;f++){let _=n[f];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function LR(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new My,n.set(i,[o])):s>=r.length?(o=new My,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function DR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new K,color:new xt};break;case"SpotLight":t={position:new K,direction:new K,color:new xt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new K,color:new xt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new K,skyColor:new xt,groundColor:new xt};break;case"RectAreaLight":t={color:new xt,position:new K,halfWidth:new K,halfHeight:new K};break}return n[e.id]=t,t}}}function NR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var UR=0;function FR(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function OR(n){let e=new DR,t=NR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new K);let s=new K,r=new sn,o=new sn;function a(c){let u=0,h=0,f=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let p=0,_=0,b=0,g=0,m=0,x=0,A=0,S=0,P=0,C=0,v=0,E=0,k=0,N=0;c.sort(FR);for(let B=0,V=c.length;B<V;B++){let U=c[B],H=U.color,Y=U.intensity,G=U.distance,le=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Cr?le=U.shadow.map.texture:le=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)u+=H.r*Y,h+=H.g*Y,f+=H.b*Y;else if(U.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(U.sh.coefficients[J],Y);N++}else if(U.isSunLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[_]=se,i.sunShadowMap[_]=le;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[b+he]=Q.getMatrix(he),i.sunShadowCascade[b+he]=Q._cascadeData[he];b+=fe,_++}i.sun[p]=J,p++}else if(U.isDirectionalLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[g]=se,i.directionalShadowMap[g]=le,i.directionalShadowMatrix[g]=U.shadow.matrix,P++}i.directional[g]=J,g++}else if(U.isSpotLight){let J=e.get(U);J.position.setFromMatrixPosition(U.matrixWorld),J.color.copy(H).multiplyScalar(Y),J.distance=G,J.coneCos=Math.cos(U.angle),J.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),J.decay=U.decay,i.spot[x]=J;let Q=U.shadow;if(U.map&&(i.spotLightMap[E]=U.map,E++,Q.updateMatrices(U),U.castShadow&&k++),i.spotLightMatrix[x]=Q.matrix,U.castShadow){let se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[x]=se,i.spotShadowMap[x]=le,v++}x++}else if(U.isRectAreaLight){let J=e.get(U);J.color.copy(H).multiplyScalar(Y),J.halfWidth.set(U.width*.5,0,0),J.halfHeight.set(0,U.height*.5,0),i.rectArea[A]=J,A++}else if(U.isPointLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),J.distance=U.distance,J.decay=U.decay,U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[m]=se,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=U.shadow.matrix,C++}i.point[m]=J,m++}else if(U.isHemisphereLight){let J=e.get(U);J.skyColor.copy(U.color).multiplyScalar(Y),J.groundColor.copy(U.groundColor).multiplyScalar(Y),i.hemi[S]=J,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let L=i.hash;(L.sunLength!==p||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==x||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==_||L.numDirectionalShadows!==P||L.numPointShadows!==C||L.numSpotShadows!==v||L.numSpotMaps!==E||L.numLightProbes!==N)&&(i.sun.length=p,i.directional.length=g,i.spot.length=x,i.rectArea.length=A,i.point.length=m,i.hemi.length=S,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-k,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=N,L.sunLength=p,L.directionalLength=g,L.pointLength=m,L.spotLength=x,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=_,L.numDirectionalShadows=P,L.numPointShadows=C,L.numSpotShadows=v,L.numSpotMaps=E,L.numLightProbes=N,i.version=UR++)}function l(c,u){let h=0,f=0,p=0,_=0,b=0,g=0,m=u.matrixWorldInverse;for(let x=0,A=c.length;x<A;x++){let S=c[x];if(S.isSunLight){let P=i.sun[h];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),h++}else if(S.isDirectionalLight){let P=i.directional[f];P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),f++}else if(S.isSpotLight){let P=i.spot[_];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),_++}else if(S.isRectAreaLight){let P=i.rectArea[b];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),b++}else if(S.isPointLight){let P=i.point[p];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),p++}else if(S.isHemisphereLight){let P=i.hemi[g];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function wy(n){let e=new OR(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function kR(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new wy(n),e.set(s,[a])):r>=o.length?(a=new wy(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var BR=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zR=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,VR=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],GR=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],Ty=new sn,Wl=new K,tm=new K;function HR(n,e,t){let i=new to,s=new tt,r=new tt,o=new rn,a=new $u,l=new Yu,c={},u=t.maxTextureSize,h={[Ar]:oi,[oi]:Ar,[Fi]:Fi},f=new Ei({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:BR,fragmentShader:zR}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let _=new ys;_.setAttribute("position",new ri(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Ui(_,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Fl;let m=this.type;this.render=function(C,v,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||C.length===0)return;this.type===vv&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Fl);let k=n.getRenderTarget(),N=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),B=n.state;B.setBlending(no),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=m!==this.type;V&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(H=>H.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,H=C.length;U<H;U++){let Y=C[U],G=Y.shadow;if(G===void 0){Ye("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let le=G.getFrameExtents();s.multiply(le),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,G.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=J,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===va){if(Y.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new wi(s.x,s.y,{format:Cr,type:Qi,minFilter:Wn,magFilter:Wn,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new Hs(s.x,s.y,ji),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=Vs,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Gn,G.map.depthTexture.magFilter=Gn}else Y.isPointLight?(G.map=new Xl(s.x),G.map.depthTexture=new Pl(s.x,Ji)):(G.map=new wi(s.x,s.y),G.map.depthTexture=new Hs(s.x,s.y,Ji)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=Vs,this.type===Fl?(G.map.depthTexture.compareFunction=J?Gp:Vp,G.map.depthTexture.minFilter=Wn,G.map.depthTexture.magFilter=Wn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Gn,G.map.depthTexture.magFilter=Gn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,E);let se=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:E.layers;for(let fe=0;fe<Q;fe++){let he=G.getCamera(fe);if(Y.isPointLight){let ee=G.camera,me=G.matrix,ve=Y.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),Wl.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(Wl),tm.copy(ee.position),tm.add(VR[fe]),ee.up.copy(GR[fe]),ee.lookAt(tm),ee.updateMatrixWorld(),me.makeTranslation(-Wl.x,-Wl.y,-Wl.z),Ty.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Ty,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),B.viewport(o)}i=G.getFrustum(fe),S(v,E,he,Y,se,this.type)}G.isPointLightShadow!==!0&&this.type===va&&x(G,E),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(k,N,L)};function x(C,v){let E=e.update(b);f.defines.VSM_SAMPLES!==C.blurSamples&&(f.defines.VSM_SAMPLES=C.blurSamples,p.defines.VSM_SAMPLES=C.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),C.mapPass===null?C.mapPass=new wi(s.x,s.y,{format:Cr,type:Qi}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),f.uniforms.shadow_pass.value=C.map.depthTexture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(v,null,E,f,b,null),p.uniforms.shadow_pass.value=C.mapPass.texture,p.uniforms.resolution.value.set(C.map.width,C.map.height),p.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(v,null,E,p,b,null)}function A(C,v,E,k){let N=null,L=E.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)N=L;else if(N=E.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let B=N.uuid,V=v.uuid,U=c[B];U===void 0&&(U={},c[B]=U);let H=U[V];H===void 0&&(H=N.clone(),U[V]=H,v.addEventListener("dispose",P)),N=H}if(N.visible=v.visible,N.wireframe=v.wireframe,k===va?N.side=v.shadowSide!==null?v.shadowSide:v.side:N.side=v.shadowSide!==null?v.shadowSide:h[v.side],N.alphaMap=v.alphaMap,N.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,N.map=v.map,N.clipShadows=v.clipShadows,N.clippingPlanes=v.clippingPlanes,N.clipIntersection=v.clipIntersection,N.displacementMap=v.displacementMap,N.displacementScale=v.displacementScale,N.displacementBias=v.displacementBias,N.wireframeLinewidth=v.wireframeLinewidth,N.linewidth=v.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let B=n.properties.get(N);B.light=E}return N}function S(C,v,E,k,N,L){if(C.visible===!1)return;if(C.layers.test(N)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===va)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,C.matrixWorld);let U=e.update(C),H=C.material;if(Array.isArray(H)){let Y=U.groups;for(let G=0,le=Y.length;G<le;G++){let J=Y[G],Q=H[J.materialIndex];if(Q&&Q.visible){let se=A(C,Q,k,L);C.onBeforeShadow(n,C,v,E,U,se,J),n.renderBufferDirect(E,null,U,se,C,J),C.onAfterShadow(n,C,v,E,U,se,J)}}}else if(H.visible){let Y=A(C,H,k,L);C.onBeforeShadow(n,C,v,E,U,Y,null),n.renderBufferDirect(E,null,U,Y,C,null),C.onAfterShadow(n,C,v,E,U,Y,null)}}let V=C.children;for(let U=0,H=V.length;U<H;U++)S(V[U],v,E,k,N,L)}function P(C){C.target.removeEventListener("dispose",P);for(let E in c){let k=c[E],N=C.target.uuid;N in k&&(k[N].dispose(),delete k[N])}}}function WR(n,e){function t(){let F=!1,re=new rn,ne=null,we=new rn(0,0,0,0);return{setMask:function(ge){ne!==ge&&!F&&(n.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){F=ge},setClear:function(ge,be,He,Je,ce){ce===!0&&(ge*=Je,be*=Je,He*=Je),re.set(ge,be,He,Je),we.equals(re)===!1&&(n.clearColor(ge,be,He,Je),we.copy(re))},reset:function(){F=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let F=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){if(re!==be){let He=e.get("EXT_clip_control");be?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),re=be;let Je=ge;ge=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(be){be?Se(n.DEPTH_TEST):We(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!F&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=jv[be]),we!==be){switch(be){case Au:n.depthFunc(n.NEVER);break;case Cu:n.depthFunc(n.ALWAYS);break;case Ru:n.depthFunc(n.LESS);break;case la:n.depthFunc(n.LEQUAL);break;case Pu:n.depthFunc(n.EQUAL);break;case Iu:n.depthFunc(n.GEQUAL);break;case Lu:n.depthFunc(n.GREATER);break;case Du:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=be}},setLocked:function(be){F=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){F=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let F=!1,re=null,ne=null,we=null,ge=null,be=null,He=null,Je=null,ce=null;return{setTest:function(ke){F||(ke?Se(n.STENCIL_TEST):We(n.STENCIL_TEST))},setMask:function(ke){re!==ke&&!F&&(n.stencilMask(ke),re=ke)},setFunc:function(ke,je,Ce){(ne!==ke||we!==je||ge!==Ce)&&(n.stencilFunc(ke,je,Ce),ne=ke,we=je,ge=Ce)},setOp:function(ke,je,Ce){(be!==ke||He!==je||Je!==Ce)&&(n.stencilOp(ke,je,Ce),be=ke,He=je,Je=Ce)},setLocked:function(ke){F=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){F=!1,re=null,ne=null,we=null,ge=null,be=null,He=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},p=new WeakMap,_=[],b=null,g=!1,m=null,x=null,A=null,S=null,P=null,C=null,v=null,E=new xt(0,0,0),k=0,N=!1,L=null,B=null,V=null,U=null,H=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),G=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),G=le>=2);let Q=null,se={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new rn().fromArray(fe),me=new rn().fromArray(he);function ve(F,re,ne,we){let ge=new Uint8Array(4),be=n.createTexture();n.bindTexture(F,be),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let He=0;He<ne;He++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+He,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return be}let Ae={};Ae[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(la),gn(!1),Ot(vp),Se(n.CULL_FACE),jt(no);function Se(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function We(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function rt(F,re){return f[F]!==re?(n.bindFramebuffer(F,re),f[F]=re,F===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=re),F===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ge(F,re){let ne=_,we=!1;if(F){ne=p.get(re),ne===void 0&&(ne=[],p.set(re,ne));let ge=F.textures;if(ne.length!==ge.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,He=ge.length;be<He;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function ft(F){return b!==F?(n.useProgram(F),b=F,!0):!1}let ct={[io]:n.FUNC_ADD,[xv]:n.FUNC_SUBTRACT,[bv]:n.FUNC_REVERSE_SUBTRACT};ct[Sv]=n.MIN,ct[Mv]=n.MAX;let it={[wv]:n.ZERO,[Tv]:n.ONE,[Ev]:n.SRC_COLOR,[Sp]:n.SRC_ALPHA,[Lv]:n.SRC_ALPHA_SATURATE,[Pv]:n.DST_COLOR,[Cv]:n.DST_ALPHA,[Av]:n.ONE_MINUS_SRC_COLOR,[Mp]:n.ONE_MINUS_SRC_ALPHA,[Iv]:n.ONE_MINUS_DST_COLOR,[Rv]:n.ONE_MINUS_DST_ALPHA,[Dv]:n.CONSTANT_COLOR,[Nv]:n.ONE_MINUS_CONSTANT_COLOR,[Uv]:n.CONSTANT_ALPHA,[Fv]:n.ONE_MINUS_CONSTANT_ALPHA};function jt(F,re,ne,we,ge,be,He,Je,ce,ke){if(F===no){g===!0&&(We(n.BLEND),g=!1);return}if(g===!1&&(Se(n.BLEND),g=!0),F!==yv){if(F!==m||ke!==N){if((x!==io||P!==io)&&(n.blendEquation(n.FUNC_ADD),x=io,P=io),ke)switch(F){case ya:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yp:n.blendFunc(n.ONE,n.ONE);break;case xp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case bp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:et("WebGLState: Invalid blending: ",F);break}else switch(F){case ya:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case xp:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case bp:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",F);break}A=null,S=null,C=null,v=null,E.set(0,0,0),k=0,m=F,N=ke}return}ge=ge||re,be=be||ne,He=He||we,(re!==x||ge!==P)&&(n.blendEquationSeparate(ct[re],ct[ge]),x=re,P=ge),(ne!==A||we!==S||be!==C||He!==v)&&(n.blendFuncSeparate(it[ne],it[we],it[be],it[He]),A=ne,S=we,C=be,v=He),(Je.equals(E)===!1||ce!==k)&&(n.blendColor(Je.r,Je.g,Je.b,ce),E.copy(Je),k=ce),m=F,N=!1}function Ht(F,re){F.side===Fi?We(n.CULL_FACE):Se(n.CULL_FACE);let ne=F.side===oi;re&&(ne=!ne),gn(ne),F.blending===ya&&F.transparent===!1?jt(no):jt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let we=F.stencilWrite;a.setTest(we),we&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),St(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):We(n.SAMPLE_ALPHA_TO_COVERAGE)}function gn(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function Ot(F){F!==gv?(Se(n.CULL_FACE),F!==B&&(F===vp?n.cullFace(n.BACK):F===_v?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):We(n.CULL_FACE),B=F}function Fn(F){F!==V&&(G&&n.lineWidth(F),V=F)}function St(F,re,ne){F?(Se(n.POLYGON_OFFSET_FILL),(U!==re||H!==ne)&&(U=re,H=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):We(n.POLYGON_OFFSET_FILL)}function Tn(F){F?Se(n.SCISSOR_TEST):We(n.SCISSOR_TEST)}function ln(F){F===void 0&&(F=n.TEXTURE0+Y-1),Q!==F&&(n.activeTexture(F),Q=F)}function _n(F,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+Y-1:ne=Q);let we=se[ne];we===void 0&&(we={type:void 0,texture:void 0},se[ne]=we),(we.type!==F||we.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(F,re||Ae[F]),we.type=F,we.texture=re)}function O(){let F=se[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function ot(){try{n.texSubImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Me(){try{n.texSubImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function Xe(){try{n.texStorage2D(...arguments)}catch(F){et("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){et("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function q(){try{n.texImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function ue(F){return h[F]!==void 0?h[F]:n.getParameter(F)}function oe(F,re){h[F]!==re&&(n.pixelStorei(F,re),h[F]=re)}function _e(F){ee.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function ye(F){me.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function te(F,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(F);we===void 0&&(we=n.getUniformBlockIndex(re,F.name),n.uniformBlockBinding(re,we,we),ne.set(F,we))}function ie(F,re,ne){let ge=c.get(re).get(F);l[ge]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,se={},f={},l={},p=new WeakMap,_=[],b=null,g=!1,m=null,x=null,A=null,S=null,P=null,C=null,v=null,E=new xt(0,0,0),k=0,N=!1,L=null,B=null,V=null,U=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:We,bindFramebuffer:rt,drawBuffers:Ge,useProgram:ft,setBlending:jt,setMaterial:Ht,setFlipSided:gn,setCullFace:Ot,setLineWidth:Fn,setPolygonOffset:St,setScissorTest:Tn,activeTexture:ln,bindTexture:_n,unbindTexture:O,compressedTexImage2D:Re,compressedTexImage3D:Ke,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:Xe,texStorage3D:R,texSubImage2D:ot,texSubImage3D:Me,compressedTexSubImage2D:zt,compressedTexSubImage3D:Ve,scissor:_e,viewport:ye,reset:pe}}function qR(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new tt,u=new WeakMap,h=new Set,f,p=new WeakMap,_=new Set,b=new FinalizationRegistry(R=>_.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,M){return g?new OffscreenCanvas(R,M):Sl("canvas")}function x(R,M,q){let ue=1,oe=Xe(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _e=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);f===void 0&&(f=m(_e,ye));let te=M?m(_e,ye):f;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(R,0,0,_e,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+ye+")."),te}else return"data"in R&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function P(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,M,q,ue,oe,_e=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let ie=_e?xl:yt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Lt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(R,M){let q;return R?M===null||M===Ji||M===ro?q=n.DEPTH24_STENCIL8:M===ji?q=n.DEPTH32F_STENCIL8:M===ba&&(q=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ji||M===ro?q=n.DEPTH_COMPONENT24:M===ji?q=n.DEPTH_COMPONENT32F:M===ba&&(q=n.DEPTH_COMPONENT16),q}function E(R,M){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Gn&&R.minFilter!==Wn?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function k(R){let M=new WeakRef(R);i.get(R).__ref=M,_.add(M),b.register(R,M,M)}function N(R){let M=i.get(R).__ref;M!==void 0&&(_.delete(M),b.unregister(M))}function L(R){V(R.target)}function B(R){U(R.target)}function V(R){R.removeEventListener("dispose",L),N(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function U(R){R.removeEventListener("dispose",B),N(R),le(R)}function H(){for(let R of _){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?U(M):V(M))}_.clear(),h.clear()}function Y(R){let M=i.get(R);if(M.__webglInit===void 0)return;let q=R.source,ue=p.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(R),Object.keys(ue).length===0&&p.delete(q)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let q=R.source,ue=p.get(q);delete ue[M.__cacheKey],o.memory.textures--}function le(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&V(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let _e=0;_e<M.__webglFramebuffer[oe].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[oe][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,_e=ue.length;oe<_e;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let J=0;function Q(){J=0}function se(){return J}function fe(R){J=R}function he(){let R=J;return R>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function ee(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let q=i.get(R);if(R.isVideoTexture&&zt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht(q,R,M);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ve(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ht(q,R,M);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ae(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ht(q,R,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Se(R,M){let q=i.get(R);if(R.version>0&&q.__version!==R.version){gn(q,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let We={[Nu]:n.REPEAT,[_s]:n.CLAMP_TO_EDGE,[Uu]:n.MIRRORED_REPEAT},rt={[Gn]:n.NEAREST,[Bv]:n.NEAREST_MIPMAP_NEAREST,[Ol]:n.NEAREST_MIPMAP_LINEAR,[Wn]:n.LINEAR,[ch]:n.LINEAR_MIPMAP_NEAREST,[Ws]:n.LINEAR_MIPMAP_LINEAR},Ge={[Hv]:n.NEVER,[Hp]:n.ALWAYS,[Wv]:n.LESS,[Vp]:n.LEQUAL,[qv]:n.EQUAL,[Gp]:n.GEQUAL,[Xv]:n.GREATER,[$v]:n.NOTEQUAL};function ft(R,M){if(M.type===ji&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Wn||M.magFilter===ch||M.magFilter===Ol||M.magFilter===Ws||M.minFilter===Wn||M.minFilter===ch||M.minFilter===Ol||M.minFilter===Ws)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,We[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,We[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,We[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,rt[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,rt[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ge[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Gn||M.minFilter!==Ol&&M.minFilter!==Ws||M.type===ji&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ct(R,M){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),k(M));let ue=M.source,oe=p.get(ue);oe===void 0&&(oe={},p.set(ue,oe));let _e=ee(M);if(_e!==R.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[_e].usedTimes++;let ye=oe[R.__cacheKey];ye!==void 0&&(oe[R.__cacheKey].usedTimes--,ye.usedTimes===0&&G(M)),R.__cacheKey=_e,R.__webglTexture=oe[_e].texture}return q}function it(R,M,q){return Math.floor(Math.floor(R/q)/M)}function jt(R,M,q,ue){let _e=R.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{_e.sort((F,re)=>F.start-re.start);let ye=0;for(let F=1;F<_e.length;F++){let re=_e[ye],ne=_e[F],we=re.start+re.count,ge=it(ne.start,M.width,4),be=it(re.start,M.width,4);ne.start<=we+1&&ge===be&&it(ne.start+ne.count-1,M.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,re=_e.length;F<re;F++){let ne=_e[F],we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%M.width,He=Math.floor(we/M.width),Je=ge,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,He),t.texSubImage2D(n.TEXTURE_2D,0,be,He,Je,ce,q,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ht(R,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ct(R,M),_e=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(_e);if(_e.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=yt.getPrimaries(yt.workingColorSpace),ke=M.colorSpace===Xs?null:yt.getPrimaries(M.colorSpace),je=M.colorSpace===Xs||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=x(M.image,!1,s.maxTextureSize);ie=Ve(M,ie);let pe=r.convert(M.format,M.colorSpace),F=r.convert(M.type),re=C(M.internalFormat,pe,F,M.normalized,M.colorSpace,M.isVideoTexture);ft(ue,M);let ne,we=M.mipmaps,ge=M.isVideoTexture!==!0,be=ye.__version===void 0||oe===!0,He=_e.dataReady,Je=E(M,ie);if(M.isDepthTexture)re=v(M.format===qs,M.type),be&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,null));else if(M.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,ke=we.length;ce<ke;ce++)ne=we[ce],ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data);M.generateMipmaps=!1}else ge?(be&&t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height),He&&jt(M,ie,pe,F)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,we[0].width,we[0].height,ie.depth);for(let ce=0,ke=we.length;ce<ke;ce++)if(ne=we[ce],M.format!==es)if(pe!==null)if(ge){if(He)if(M.layerUpdates.size>0){let je=Qp(ne.width,ne.height,M.format,M.type);for(let Ce of M.layerUpdates){let at=ne.data.subarray(Ce*je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,at)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?He&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,F,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,pe,F,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,ke=we.length;ce<ke;ce++)ne=we[ce],M.format!==es?pe!==null?ge?He&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data)}else if(M.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,ie.width,ie.height,ie.depth),He)if(M.layerUpdates.size>0){let ce=Qp(ie.width,ie.height,M.format,M.type);for(let ke of M.layerUpdates){let je=ie.data.subarray(ke*ce/ie.data.BYTES_PER_ELEMENT,(ke+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,ie.width,ie.height,1,pe,F,je)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isData3DTexture)ge?(be&&t.texStorage3D(n.TEXTURE_3D,Je,re,ie.width,ie.height,ie.depth),He&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isFramebufferTexture){if(be)if(ge)t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height);else{let ce=ie.width,ke=ie.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,re,ce,ke,0,pe,F,null),ce>>=1,ke>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),h.add(M),ce.onpaint=ke=>{let je=ke.changedElements;for(let Ce of h)je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let je=n.RGBA,Ce=n.RGBA,at=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Ce,at,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=Xe(we[0]);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,ke=we.length;ce<ke;ce++)ne=we[ce],ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,F,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,F,ne);M.generateMipmaps=!1}else if(ge){if(be){let ce=Xe(ie);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}He&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,F,ie);A(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=_e.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function gn(R,M,q){if(M.image.length!==6)return;let ue=ct(R,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let _e=i.get(oe);if(oe.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=yt.getPrimaries(yt.workingColorSpace),te=M.colorSpace===Xs?null:yt.getPrimaries(M.colorSpace),ie=M.colorSpace===Xs||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!F?re[Ce]=x(M.image[Ce],!0,s.maxCubemapSize):re[Ce]=F?M.image[Ce].image:M.image[Ce],re[Ce]=Ve(M,re[Ce]);let ne=re[0],we=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=C(M.internalFormat,we,ge,M.normalized,M.colorSpace),He=M.isVideoTexture!==!0,Je=_e.__version===void 0||ue===!0,ce=oe.dataReady,ke=E(M,ne);ft(n.TEXTURE_CUBE_MAP,M);let je;if(M.isDepthTexture){if(be=v(M.format===qs,M.type),Je)if(He)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,0,we,ge,null)}else if(pe){He&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){je=re[Ce].mipmaps;for(let at=0;at<je.length;at++){let Xt=je[at];M.format!==es?we!==null?He?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Xt.width,Xt.height,we,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Xt.width,Xt.height,0,Xt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Xt.width,Xt.height,we,ge,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Xt.width,Xt.height,0,we,ge,Xt.data)}}}else{if(je=M.mipmaps,He&&Je){je.length>0&&ke++;let Ce=Xe(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(F){He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,we,ge,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,re[Ce].width,re[Ce].height,0,we,ge,re[Ce].data);for(let at=0;at<je.length;at++){let jn=je[at].image[Ce].image;He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,jn.width,jn.height,we,ge,jn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,jn.width,jn.height,0,we,ge,jn.data)}}else{He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ge,re[Ce]);for(let at=0;at<je.length;at++){let Xt=je[at];He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,we,ge,Xt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,we,ge,Xt.image[Ce])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=oe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ot(R,M,q,ue,oe,_e){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ie=C(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(M),F=i.get(q);if(F.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>_e),ne=Math.max(1,M.height>>_e);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,ie,re,ne,M.depth,0,ye,te,null):t.texImage2D(oe,_e,ie,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,F.__webglTexture,0,ot(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,F.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Fn(R,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,_e=v(M.stencilBuffer,oe),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),_e,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let _e=ue[oe],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),ie=C(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),ie,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function St(R,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):me(M.depthTexture,0);let ye=oe.__webglTexture,te=ot(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===qs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Vs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else if(M.depthTexture.format===qs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Tn(R){let M=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)St(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?St(M.__webglFramebuffer[0],R,0):St(M.__webglFramebuffer,R,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),Fn(M.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Fn(M.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ln(R,M,q){let ue=i.get(R);M!==void 0&&Ot(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Tn(R)}function _n(R){let M=R.texture,q=i.get(R),ue=i.get(M);R.addEventListener("dispose",B),k(R);let oe=R.textures,_e=R.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,ie=oe.length;te<ie;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),re=C(ie.internalFormat,pe,F,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=ot(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Fn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ft(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ot(q.__webglFramebuffer[te][ie],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Ot(q.__webglFramebuffer[te],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=oe.length;te<ie;te++){let pe=oe[te],F=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,F.__webglTexture),ft(re,pe),Ot(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,re,0),A(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ft(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ot(q.__webglFramebuffer[ie],R,M,n.COLOR_ATTACHMENT0,te,ie);else Ot(q.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,te,0);A(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Tn(R)}function O(R){let M=R.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let _e=P(R),ye=i.get(oe).__webglTexture;t.bindTexture(_e,ye),S(_e),t.unbindTexture()}}}let Re=[];function Ke(R){if(R.samples>0){if(Me(R)===!1){let M=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,_e=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ot(R){return Math.min(s.maxSamples,R.samples)}function Me(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function zt(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function Ve(R,M){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==yl&&q!==Xs&&(yt.getTransfer(q)===Lt?(ue!==es||oe!==Ci)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",q)),M}function Xe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ae,this.setTextureCube=Se,this.rebindTextures=ln,this.setupRenderTarget=_n,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=Tn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=Me,this.dispose=H}function XR(n,e){function t(i,s=Xs){let r,o=yt.getTransfer(s);if(i===Ci)return n.UNSIGNED_BYTE;if(i===hh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===fh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Up)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Fp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Dp)return n.BYTE;if(i===Np)return n.SHORT;if(i===ba)return n.UNSIGNED_SHORT;if(i===uh)return n.INT;if(i===Ji)return n.UNSIGNED_INT;if(i===ji)return n.FLOAT;if(i===Qi)return n.HALF_FLOAT;if(i===Op)return n.ALPHA;if(i===kp)return n.RGB;if(i===es)return n.RGBA;if(i===Vs)return n.DEPTH_COMPONENT;if(i===qs)return n.DEPTH_STENCIL;if(i===Bp)return n.RED;if(i===dh)return n.RED_INTEGER;if(i===Cr)return n.RG;if(i===ph)return n.RG_INTEGER;if(i===mh)return n.RGBA_INTEGER;if(i===kl||i===Bl||i===zl||i===Vl)if(o===Lt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===kl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Bl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===zl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===kl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Bl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===zl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Vl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===gh||i===_h||i===vh||i===yh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===gh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===_h)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===vh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===yh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===xh||i===bh||i===Sh||i===Mh||i===wh||i===Gl||i===Th)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===xh||i===bh)return o===Lt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Sh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Mh)return r.COMPRESSED_R11_EAC;if(i===wh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Gl)return r.COMPRESSED_RG11_EAC;if(i===Th)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Eh||i===Ah||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Uh||i===Fh||i===Oh||i===kh||i===Bh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Eh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ah)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ch)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Rh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ph)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ih)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Lh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Dh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Nh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Uh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Fh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Oh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===kh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Bh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===zh||i===Vh||i===Gh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===zh)return o===Lt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Gh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Hh||i===Wh||i===Hl||i===qh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Hh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Wh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Hl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===qh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ro?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var $R=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YR=`
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

}`,lm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Il(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ei({vertexShader:$R,fragmentShader:YR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ui(new Ll(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},cm=class extends Zi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,_=null,b=typeof XRWebGLBinding<"u",g=new lm,m={},x=t.getContextAttributes(),A=null,S=null,P=[],C=[],v=new tt,E=null,k=null,N=new si;N.viewport=new rn;let L=new si;L.viewport=new rn;let B=[N,L],V=new oh,U=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=P[ee];return me===void 0&&(me=new fa,P[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=P[ee];return me===void 0&&(me=new fa,P[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=P[ee];return me===void 0&&(me=new fa,P[ee]=me),me.getHandSpace()};function Y(ee){let me=C.indexOf(ee.inputSource);if(me===-1)return;let ve=P[me];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<P.length;ee++){let me=C[ee];me!==null&&(C[ee]=null,P[ee].disconnect(me))}U=null,H=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(A),p=null,f=null,h=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),k!==null){let ee=k.camera;ee.fov=k.fov,ee.zoom=k.zoom,ee.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&b&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",le),x.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ae=null,Se=null;x.depth&&(Se=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=x.stencil?qs:Vs,Ae=x.stencil?ro:Ji);let We={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(We),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new wi(f.textureWidth,f.textureHeight,{format:es,type:Ci,depthTexture:new Hs(f.textureWidth,f.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ve={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new wi(p.framebufferWidth,p.framebufferHeight,{format:es,type:Ci,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ve=ee.removed[me],Ae=C.indexOf(ve);Ae>=0&&(C[Ae]=null,P[Ae].disconnect(ve))}for(let me=0;me<ee.added.length;me++){let ve=ee.added[me],Ae=C.indexOf(ve);if(Ae===-1){for(let We=0;We<P.length;We++)if(We>=C.length){C.push(ve),Ae=We;break}else if(C[We]===null){C[We]=ve,Ae=We;break}if(Ae===-1)break}let Se=P[Ae];Se&&Se.connect(ve)}}function J(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ve=ee.far;g.texture!==null&&(g.depthNear>0&&(me=g.depthNear),g.depthFar>0&&(ve=g.depthFar)),V.near=L.near=N.near=me,V.far=L.far=N.far=ve,(U!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),U=V.near,H=V.far),V.layers.mask=ee.layers.mask|6,N.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let Ae=ee.parent,Se=V.cameras;J(V,Ae);for(let We=0;We<Se.length;We++)J(Se[We],Ae);V.projectionMatrix.copy(N.projectionMatrix),V.projectionMatrixInverse.copy(N.projectionMatrixInverse),k===null&&ee.isPerspectiveCamera&&(k={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,V,Ae)};function Q(ee,me,ve){ve===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=ua*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(ee){return m[ee]};let se=null;function fe(ee,me){if(u=me.getViewerPose(c||o),_=me,u!==null){let ve=u.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Ae=!1;ve.length!==V.cameras.length&&(V.cameras.length=0,Ae=!0);for(let Ge=0;Ge<ve.length;Ge++){let ft=ve[Ge],ct=null;if(p!==null)ct=p.getViewport(ft);else{let jt=h.getViewSubImage(f,ft);ct=jt.viewport,Ge===0&&(e.setRenderTargetTextures(S,jt.colorTexture,jt.depthStencilTexture),e.setRenderTarget(S))}let it=B[Ge];it===void 0&&(it=new si,it.layers.enable(Ge),it.viewport=new rn,B[Ge]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ct.x,ct.y,ct.width,ct.height),Ge===0&&(V.matrix.copy(it.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ae===!0&&V.cameras.push(it)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){h=i.getBinding();let Ge=h.getDepthInformation(ve[0]);Ge&&Ge.isValid&&Ge.texture&&g.init(Ge,s.renderState)}if(Se&&Se.includes("camera-access")&&b){e.state.unbindTexture(),h=i.getBinding();for(let Ge=0;Ge<ve.length;Ge++){let ft=ve[Ge].camera;if(ft){let ct=m[ft];ct||(ct=new Il,m[ft]=ct);let it=h.getCameraImage(ft);ct.sourceTexture=it}}}}for(let ve=0;ve<P.length;ve++){let Ae=C[ve],Se=P[ve];Ae!==null&&Se!==void 0&&Se.update(Ae,me,c||o)}se&&se(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),_=null}let he=new Ey;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},KR=new sn,Fy=new nt;Fy.set(-1,0,0,0,1,0,0,0,1);function ZR(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Zp(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,x,A,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),f(g,m),m.isMeshPhysicalMaterial&&p(g,m,S)):m.isMeshMatcapMaterial?(r(g,m),_(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),b(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,x,A):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===oi&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===oi&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let x=e.get(m),A=x.envMap,S=x.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(KR.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Fy),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,x,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*x,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function f(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function p(g,m,x){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===oi&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function _(g,m){m.matcap&&(g.matcap.value=m.matcap)}function b(g,m){let x=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function JR(n,e,t,i){let s={},r={};function o(x,A){let S=A.program;i.uniformBlockBinding(x,S,s[x.id])}function a(x,A){let S=s[x.id];S===void 0&&(_(x),S=l(x),s[x.id]=S,x.addEventListener("dispose",g));let P=A.program;i.updateUBOMapping(x,P);let C=e.render.frame;r[x.id]!==C&&(c(x),r[x.id]=C)}function l(x){let A=n.createBuffer(),S=x.__size,P=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,P),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(x){let A=s[x.id],S=x.uniforms,P=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let C=0,v=S.length;C<v;C++){let E=S[C];if(Array.isArray(E))for(let k=0,N=E.length;k<N;k++)u(E[k],C,k,P);else u(E,C,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,A,S,P){if(f(x,A,S,P)===!0){let C=x.__offset,v=x.value;if(Array.isArray(v)){let E=0;for(let k=0;k<v.length;k++){let N=v[k],L=b(N,!0);h(N,x.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(v,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,x.__data)}}function h(x,A,S){typeof x=="number"||typeof x=="boolean"?A[S]=x:x.isMatrix3?(A[S]=x.elements[0],A[S+1]=x.elements[1],A[S+2]=x.elements[2],A[S+3]=0,A[S+4]=x.elements[3],A[S+5]=x.elements[4],A[S+6]=x.elements[5],A[S+7]=0,A[S+8]=x.elements[6],A[S+9]=x.elements[7],A[S+10]=x.elements[8],A[S+11]=0):ArrayBuffer.isView(x)?A.set(x.subarray(0,A.length-S),S):x.toArray(A,S)}function f(x,A,S,P){let C=x.value,v=A+"_"+S;if(Array.isArray(C)){P[v]===void 0&&(P[v]=[]);let E=P[v],k=!1;for(let N=0;N<C.length;N++)p(C[N],E,N)===!0&&(k=!0);return k}return p(C,P,v)}function p(x,A,S){if(A[S]===void 0)return typeof x=="number"||typeof x=="boolean"?A[S]=x:ArrayBuffer.isView(x)?A[S]=x.slice():A[S]=x.clone(),!0;{let P=A[S];if(typeof x=="number"||typeof x=="boolean"){if(P!==x)return A[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(P.equals(x)===!1)return P.copy(x),!0}}return!1}function _(x){let A=x.uniforms,S=0,P=16;for(let v=0,E=A.length;v<E;v++){let k=Array.isArray(A[v])?A[v]:[A[v]];for(let N=0,L=k.length;N<L;N++){let B=k[N],V=Array.isArray(B.value)?B.value:[B.value],U=Array.isArray(A[v])||Array.isArray(B.value),H=S;for(let G=0,le=V.length;G<le;G++){let J=V[G],Q=b(J,U),se=S%P,fe=se%Q.boundary,he=se+fe;S+=fe,he!==0&&P-he<Q.storage&&(S+=P-he),G===0&&(H=S),S+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((S-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}let C=S%P;return C>0&&(S+=P-C),x.__size=S,x.__cache={},this}function b(x,A){let S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",x),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(x){let A=x.target;A.removeEventListener("dispose",g),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var jR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),bs=null;function QR(){return bs===null&&(bs=new eo(jR,16,16,Cr,Qi),bs.name="DFG_LUT",bs.minFilter=Wn,bs.magFilter=Wn,bs.wrapS=_s,bs.wrapT=_s,bs.generateMipmaps=!1,bs.needsUpdate=!0),bs}var Kh=class{constructor(e={}){let{canvas:t=Kv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:p=Ci}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let b=p,g=new Set([mh,ph,dh]),m=new Set([Ci,Ji,ba,ro,hh,fh]),x=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,C=null,v=[],E=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,B=null,V=null,U=null,H=null;this._outputColorSpace=bi;let Y=0,G=0,le=null,J=-1,Q=null,se=new rn,fe=new rn,he=null,ee=new xt(0),me=0,ve=t.width,Ae=t.height,Se=1,We=null,rt=null,Ge=new rn(0,0,ve,Ae),ft=new rn(0,0,ve,Ae),ct=!1,it=new to,jt=new Vu,Ht=!1,gn=!1,Ot=new sn,Fn=new K,St=new rn,Tn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ln=!1;function _n(){return le===null?Se:1}let O=i;function Re(T,z){return t.getContext(T,z)}let Ke,ot,Me,zt,Ve,Xe,R,M,q,ue,oe,_e,ye,te,ie,pe,F,re,ne,we,ge,be,He;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),O===null){let z="webgl2";if(O=Re(z,T),O===null)throw Re(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(T){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),et("WebGLRenderer: "+T.message),T}function Je(){Ke=new uC(O),Ke.init(),ge=new XR(O,Ke),ot=new QA(O,Ke,e,ge),Me=new WR(O,Ke),ot.reversedDepthBuffer&&f&&Me.buffers.depth.setReversed(!0),V=O.createFramebuffer(),U=O.createFramebuffer(),H=O.createFramebuffer(),zt=new dC(O),Ve=new PR,Xe=new qR(O,Ke,Me,Ve,ot,ge,zt),R=new cC(N),M=new mT(O),be=new JA(O,M),q=new hC(O,M,zt,be),ue=new mC(O,q,M,be,zt),re=new pC(O,ot,Xe),ie=new eC(Ve),oe=new RR(N,R,Ke,ot,be,ie),_e=new ZR(N,Ve),ye=new LR,te=new kR(Ke),F=new ZA(N,R,Me,ue,_,l),pe=new HR(N,ue,ot),He=new JR(O,zt,ot,Me),ne=new jA(O,Ke,zt),we=new fC(O,Ke,zt),zt.programs=oe.programs,N.capabilities=ot,N.extensions=Ke,N.properties=Ve,N.renderLists=ye,N.shadowMap=pe,N.state=Me,N.info=zt}b!==Ci&&(k=new _C(b,t.width,t.height,a,s,r));let ce=new cm(N,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let T=Ke.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ke.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(T){T!==void 0&&(Se=T,this.setSize(ve,Ae,!1))},this.getSize=function(T){return T.set(ve,Ae)},this.setSize=function(T,z,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Ae=z,t.width=Math.floor(T*Se),t.height=Math.floor(z*Se),j===!0&&(t.style.width=T+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(ve*Se,Ae*Se).floor()},this.setDrawingBufferSize=function(T,z,j){ve=T,Ae=z,Se=j,t.width=Math.floor(T*j),t.height=Math.floor(z*j),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(b===Ci){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy(Ge)},this.setViewport=function(T,z,j,X){T.isVector4?Ge.set(T.x,T.y,T.z,T.w):Ge.set(T,z,j,X),Me.viewport(se.copy(Ge).multiplyScalar(_n()).round())},this.getScissor=function(T){return T.copy(ft)},this.setScissor=function(T,z,j,X){T.isVector4?ft.set(T.x,T.y,T.z,T.w):ft.set(T,z,j,X),Me.scissor(fe.copy(ft).multiplyScalar(_n()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(T){Me.setScissorTest(ct=T)},this.setOpaqueSort=function(T){We=T},this.setTransparentSort=function(T){rt=T},this.getClearColor=function(T){return T.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,j=!0){let X=0;if(T){let $=!1;if(le!==null){let Te=le.texture.format;$=g.has(Te)}if($){let Te=le.texture.type,Pe=m.has(Te),Ee=F.getClearColor(),Ie=F.getClearAlpha(),ze=Ee.r,Qe=Ee.g,dt=Ee.b;Pe?(x[0]=ze,x[1]=Qe,x[2]=dt,x[3]=Ie,O.clearBufferuiv(O.COLOR,0,x)):(A[0]=ze,A[1]=Qe,A[2]=dt,A[3]=Ie,O.clearBufferiv(O.COLOR,0,A))}else X|=O.COLOR_BUFFER_BIT}z&&(X|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(X|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),X!==0&&O.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),B=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),F.dispose(),ye.dispose(),te.dispose(),Xe.dispose(),Ve.dispose(),R.dispose(),ue.dispose(),q.dispose(),be.dispose(),He.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",oc),ce.removeEventListener("sessionend",as),As.stop()};function ke(T){T.preventDefault(),qp("WebGLRenderer: Context Lost."),L=!0}function je(){qp("WebGLRenderer: Context Restored."),L=!1;let T=zt.autoReset,z=pe.enabled,j=pe.autoUpdate,X=pe.needsUpdate,$=pe.type;Je(),zt.autoReset=T,pe.enabled=z,pe.autoUpdate=j,pe.needsUpdate=X,pe.type=$}function Ce(T){et("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function at(T){let z=T.target;z.removeEventListener("dispose",at),Xt(z)}function Xt(T){jn(T),Ve.remove(T)}function jn(T){let z=Ve.get(T).programs;z!==void 0&&(z.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,j,X,$,Te){z===null&&(z=Tn);let Pe=$.isMesh&&$.matrixWorld.determinantAffine()<0,Ee=Ba(T,z,j,X,$);Me.setMaterial(X,Pe);let Ie=j.index,ze=1;if(X.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ze=2}let Qe=j.drawRange,dt=j.attributes.position,Be=Qe.start*ze,pt=(Qe.start+Qe.count)*ze;Te!==null&&(Be=Math.max(Be,Te.start*ze),pt=Math.min(pt,(Te.start+Te.count)*ze)),Ie!==null?(Be=Math.max(Be,0),pt=Math.min(pt,Ie.count)):dt!=null&&(Be=Math.max(Be,0),pt=Math.min(pt,dt.count));let tn=pt-Be;if(tn<0||tn===1/0)return;be.setup($,X,Ee,j,Ie);let Dt,Nt=ne;if(Ie!==null&&(Dt=M.get(Ie),Nt=we,Nt.setIndex(Dt)),$.isMesh)X.wireframe===!0?(Me.setLineWidth(X.wireframeLinewidth*_n()),Nt.setMode(O.LINES)):Nt.setMode(O.TRIANGLES);else if($.isLine){let En=X.linewidth;En===void 0&&(En=1),Me.setLineWidth(En*_n()),$.isLineSegments?Nt.setMode(O.LINES):$.isLineLoop?Nt.setMode(O.LINE_LOOP):Nt.setMode(O.LINE_STRIP)}else $.isPoints?Nt.setMode(O.POINTS):$.isSprite&&Nt.setMode(O.TRIANGLES);if($.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Nt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let En=$._multiDrawStarts,Fe=$._multiDrawCounts,vn=$._multiDrawCount,_t=Ie?M.get(Ie).bytesPerElement:1,Rs=Ve.get(X).currentProgram.getUniforms();for(let yn=0;yn<vn;yn++)Rs.setValue(O,"_gl_DrawID",yn),Nt.render(En[yn]/_t,Fe[yn])}else if($.isInstancedMesh)Nt.renderInstances(Be,tn,$.count);else if(j.isInstancedBufferGeometry){let En=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,En);Nt.renderInstances(Be,tn,Fe)}else Nt.render(Be,tn)};function Fa(T,z,j,X){B!==null&&T.isNodeMaterial&&B.setObject(X,T),Ht===!0&&ie.setState(T,j,!1),T.transparent===!0&&T.side===Fi&&T.forceSinglePass===!1?(T.side=oi,T.needsUpdate=!0,ls(T,z,X),T.side=Ar,T.needsUpdate=!0,ls(T,z,X),T.side=Fi):ls(T,z,X)}this.compile=function(T,z,j=null){j===null&&(j=T),B!==null&&B.renderStart(T,z,j),C=te.get(j),C.init(z),E.push(C),j.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),T!==j&&T.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),C.setupLights(),B!==null&&B.updateLights(C.state.lightsArray),gn=this.localClippingEnabled,Ht=ie.init(this.clippingPlanes,gn),Ht===!0&&ie.setGlobalState(this.clippingPlanes,z),B!==null&&pe.render(C.state.shadowsArray,j,z);let X=new Set;return T.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Te=$.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ee=Te[Pe];Fa(Ee,j,z,$),X.add(Ee)}else Fa(Te,j,z,$),X.add(Te)}),C=E.pop(),B!==null&&B.renderEnd(),X},this.compileAsync=function(T,z,j=null){let X=this.compile(T,z,j);return new Promise($=>{function Te(){if(X.forEach(function(Pe){let Ie=Ve.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&X.delete(Pe)}),X.size===0){$(T);return}setTimeout(Te,10)}Ke.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let go=null;function Nf(T){go&&go(T)}function oc(){As.stop()}function as(){As.start()}let As=new Ey;As.setAnimationLoop(Nf),typeof self<"u"&&As.setContext(self),this.setAnimationLoop=function(T){go=T,ce.setAnimationLoop(T),T===null?As.stop():As.start()},ce.addEventListener("sessionstart",oc),ce.addEventListener("sessionend",as),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;B!==null&&B.renderStart(T,z);let j=ce.enabled===!0&&ce.isPresenting===!0,X=k!==null&&(le===null||j)&&k.begin(N,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(N,T,z,le),C=te.get(T,E.length),C.init(z),C.state.textureUnits=Xe.getTextureUnits(),E.push(C),Ot.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?jt.setFromArrayCamera(z):it.setFromProjectionMatrix(Ot,Ni,z.reversedDepth),gn=this.localClippingEnabled,Ht=ie.init(this.clippingPlanes,gn),P=ye.get(T,v.length),P.init(),v.push(P),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&Cs(Pe,z,-1/0,N.sortObjects)}Cs(T,z,0,N.sortObjects),P.finish(),B!==null&&B.updateLights(C.state.lightsArray),N.sortObjects===!0&&P.sort(We,rt),ln=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,ln&&F.addToRenderList(P,T),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&ie.beginShadows();let $=C.state.shadowsArray;if(pe.render($,T,z),Ht===!0&&ie.endShadows(),(X&&k.hasRenderPass())===!1){let Pe=P.opaque,Ee=P.transmissive;if(C.setupLights(),z.isArrayCamera){let Ie=z.cameras;if(Ee.length>0)for(let ze=0,Qe=Ie.length;ze<Qe;ze++){let dt=Ie[ze];Vi(Pe,Ee,T,dt)}ln&&F.render(T);for(let ze=0,Qe=Ie.length;ze<Qe;ze++){let dt=Ie[ze];Oa(P,T,dt,dt.viewport)}}else Ee.length>0&&Vi(Pe,Ee,T,z),ln&&F.render(T),Oa(P,T,z)}le!==null&&G===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),X&&k.end(N),T.isScene===!0&&T.onAfterRender(N,T,z),be.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(C=E[E.length-1],Xe.setTextureUnits(C.state.textureUnits),Ht===!0&&ie.setGlobalState(N.clippingPlanes,C.state.camera)):C=null,v.pop(),v.length>0?P=v[v.length-1]:P=null,B!==null&&B.renderEnd()};function Cs(T,z,j,X){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)C.pushLight(T),T.castShadow&&C.pushShadow(T);else if(T.isSprite){let Pe=z.isArrayCamera?jt:it;if(!T.frustumCulled||T.intersectsFrustum(Pe)){X&&St.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ot);let Ee=ue.update(T),Ie=T.material;Ie.visible&&P.push(T,Ee,Ie,j,St.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=z.isArrayCamera?jt:it;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Ee=ue.update(T),Ie=T.material;if(X&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),St.copy(T.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),St.copy(Ee.boundingSphere.center)),St.applyMatrix4(T.matrixWorld).applyMatrix4(Ot)),Array.isArray(Ie)){let ze=Ee.groups;for(let Qe=0,dt=ze.length;Qe<dt;Qe++){let Be=ze[Qe],pt=Ie[Be.materialIndex];pt&&pt.visible&&P.push(T,Ee,pt,j,St.z,Be,z)}}else Ie.visible&&P.push(T,Ee,Ie,j,St.z,null,z)}}}let Te=T.children;for(let Pe=0,Ee=Te.length;Pe<Ee;Pe++)Cs(Te[Pe],z,j,X)}function Oa(T,z,j,X){let{opaque:$,transmissive:Te,transparent:Pe}=T;C.setupLightsView(j),Ht===!0&&ie.setGlobalState(N.clippingPlanes,j),X&&Me.viewport(se.copy(X)),$.length>0&&cn($,z,j),Te.length>0&&cn(Te,z,j),Pe.length>0&&cn(Pe,z,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Vi(T,z,j,X){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[X.id]===void 0){let Be=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[X.id]=new wi(1,1,{generateMipmaps:!0,type:Be?Qi:Ci,minFilter:Ws,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:yt.workingColorSpace})}let Te=C.state.transmissionRenderTarget[X.id],Pe=X.viewport||se;Te.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Ee=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ze=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),ln&&F.render(j);let Qe=N.toneMapping;N.toneMapping=xs;let dt=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),C.setupLightsView(X),Ht===!0&&ie.setGlobalState(N.clippingPlanes,X),cn(T,j,X),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let pt=0,tn=z.length;pt<tn;pt++){let Dt=z[pt],{object:Nt,geometry:En,material:Fe,group:vn}=Dt;if(Fe.side===Fi&&Nt.layers.test(X.layers)){let _t=Fe.side;Fe.side=oi,Fe.needsUpdate=!0,dn(Nt,j,X,En,Fe,vn),Fe.side=_t,Fe.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ee,Ie,ze),N.setClearColor(ee,me),dt!==void 0&&(X.viewport=dt),N.toneMapping=Qe}function cn(T,z,j){let X=z.isScene===!0?z.overrideMaterial:null;for(let $=0,Te=T.length;$<Te;$++){let Pe=T[$],{object:Ee,geometry:Ie,group:ze}=Pe,Qe=Pe.material;Qe.allowOverride===!0&&X!==null&&(Qe=X),Ee.layers.test(j.layers)&&dn(Ee,z,j,Ie,Qe,ze)}}function dn(T,z,j,X,$,Te){B!==null&&$.isNodeMaterial&&B.setObject(T,$),T.onBeforeRender(N,z,j,X,$,Te),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),$.onBeforeRender(N,z,j,X,T,Te),$.transparent===!0&&$.side===Fi&&$.forceSinglePass===!1?($.side=oi,$.needsUpdate=!0,N.renderBufferDirect(j,z,X,$,T,Te),$.side=Ar,$.needsUpdate=!0,N.renderBufferDirect(j,z,X,$,T,Te),$.side=Fi):N.renderBufferDirect(j,z,X,$,T,Te),T.onAfterRender(N,z,j,X,$,Te)}function pn(T){let z=0;for(let j of T)j.texture!==null&&z++;return z}function ls(T,z,j){z.isScene!==!0&&(z=Tn);let X=Ve.get(T),$=C.state.lights,Te=C.state.shadowsArray,Pe=$.state.version,Ee=oe.getParameters(T,$.state,Te,z,j,C.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ee),ze=X.programs;X.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,X.fog=z.fog;let Qe=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;X.envMap=R.get(T.envMap||X.environment,Qe),X.envMapRotation=X.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",at),ze=new Map,X.programs=ze,X.programVariants=new Map);let dt=ze.get(Ie);if(dt!==void 0){if(X.currentProgram===dt&&X.lightsStateVersion===Pe)return ka(T,Ee),dt}else Ee.uniforms=oe.getUniforms(T),B!==null&&T.isNodeMaterial&&B.build(T,j,Ee),T.onBeforeCompile(Ee,N),dt=oe.acquireProgram(Ee,Ie),ze.set(Ie,dt),X.uniforms=Ee.uniforms;let Be=X.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Be.clippingPlanes=ie.uniform),ka(T,Ee),X.needsLights=Qs(T),X.lightsStateVersion=Pe,X.needsLights&&(Be.ambientLightColor.value=$.state.ambient,Be.lightProbe.value=$.state.probe,Be.sunLights.value=$.state.sun,Be.sunLightShadows.value=$.state.sunShadow,Be.directionalLights.value=$.state.directional,Be.directionalLightShadows.value=$.state.directionalShadow,Be.spotLights.value=$.state.spot,Be.spotLightShadows.value=$.state.spotShadow,Be.rectAreaLights.value=$.state.rectArea,Be.ltc_1.value=$.state.rectAreaLTC1,Be.ltc_2.value=$.state.rectAreaLTC2,Be.pointLights.value=$.state.point,Be.pointLightShadows.value=$.state.pointShadow,Be.hemisphereLights.value=$.state.hemi,Be.sunShadowMatrix.value=$.state.sunShadowMatrix,Be.sunShadowCascade.value=$.state.sunShadowCascade,Be.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Be.spotLightMatrix.value=$.state.spotLightMatrix,Be.spotLightMap.value=$.state.spotLightMap,Be.pointShadowMatrix.value=$.state.pointShadowMatrix),X.numLightProbeGrids=pn(C.state.lightProbeGridArray),X.currentProgram=dt,X.uniformsList=null,dt}function fi(T,z,j,X,$){let Te=Ve.get(T),Pe=Te.currentProgram.id+","+X+","+$,Ee=Te.programVariants.get(Pe);return Ee===void 0?(Ee=ls(T,z,j),Te.programVariants.set(Pe,Ee)):(Te.currentProgram=Ee,Te.uniformsList=null,Te.outputColorSpace=X,Te.toneMapping=$),Ee}function js(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=Ma.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function ka(T,z){let j=Ve.get(T);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function Ba(T,z,j,X,$){z.isScene!==!0&&(z=Tn),Xe.resetTextureUnits();let Te=z.fog,Pe=X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial?z.environment:null,Ee=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:yt.workingColorSpace,Ie=X.isMeshStandardMaterial||X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,ze=R.get(X.envMap||Pe,Ie),Qe=X.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,dt=!!j.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Be=!!j.morphAttributes.position,pt=!!j.morphAttributes.normal,tn=!!j.morphAttributes.color,Dt=xs;X.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Dt=N.toneMapping);let Nt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,En=Nt!==void 0?Nt.length:0,Fe=Ve.get(X),vn=C.state.lights;if(Ht===!0&&(gn===!0||T!==Q)){let Ut=T===Q&&X.id===J;ie.setState(X,T,Ut)}let _t=!1,Rs=!1;X.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==vn.state.version||$.isBatchedMesh&&Fe.batching===!1||!$.isBatchedMesh&&Fe.batching===!0||$.isBatchedMesh&&Fe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Fe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Fe.instancing===!1||!$.isInstancedMesh&&Fe.instancing===!0||$.isSkinnedMesh&&Fe.skinning===!1||!$.isSkinnedMesh&&Fe.skinning===!0||$.isInstancedMesh&&Fe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Fe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Fe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Fe.instancingMorph===!1&&$.morphTexture!==null||Fe.envMap!==ze||X.fog===!0&&Fe.fog!==Te||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ie.numPlanes||Fe.numIntersection!==ie.numIntersection)||Fe.vertexAlphas!==Qe||Fe.vertexTangents!==dt||Fe.morphTargets!==Be||Fe.morphNormals!==pt||Fe.morphColors!==tn||Fe.morphTargetsCount!==En||Fe.numLightProbeGrids!==pn(C.state.lightProbeGridArray)?_t=!0:(Fe.outputColorSpace!==Ee||Fe.toneMapping!==Dt)&&(Rs=!0):(_t=!0,Fe.__version=X.version);let yn=Fe.currentProgram;(_t===!0||Rs===!0)&&(yn=Rs===!0?fi(X,z,$,Ee,Dt):ls(X,z,$),B&&X.isNodeMaterial&&B.onUpdateProgram(X,yn,Fe));let yo=!1,cs=!1,Ps=!1,ut=yn.getUniforms(),un=Fe.uniforms;if(Me.useProgram(yn.program)&&(yo=!0,cs=!0,Ps=!0),X.id!==J&&(J=X.id,cs=!0),yo||Q!==T){Me.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ut.setValue(O,"projectionMatrix",T.projectionMatrix),ut.setValue(O,"viewMatrix",T.matrixWorldInverse);let xn=ut.map.cameraPosition;xn!==void 0&&xn.setValue(O,Fn.setFromMatrixPosition(T.matrixWorld)),ot.logarithmicDepthBuffer&&ut.setValue(O,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&ut.setValue(O,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,cs=!0,Ps=!0)}if(Fe.needsLights&&(vn.state.sunShadowMap.length>0&&ut.setValue(O,"sunShadowMap",vn.state.sunShadowMap,Xe),vn.state.directionalShadowMap.length>0&&ut.setValue(O,"directionalShadowMap",vn.state.directionalShadowMap,Xe),vn.state.spotShadowMap.length>0&&ut.setValue(O,"spotShadowMap",vn.state.spotShadowMap,Xe),vn.state.pointShadowMap.length>0&&ut.setValue(O,"pointShadowMap",vn.state.pointShadowMap,Xe)),$.isSkinnedMesh){ut.setOptional(O,$,"bindMatrix"),ut.setOptional(O,$,"bindMatrixInverse");let Ut=$.skeleton;Ut&&(Ut.boneTexture===null&&Ut.computeBoneTexture(),ut.setValue(O,"boneTexture",Ut.boneTexture,Xe))}$.isBatchedMesh&&(ut.setOptional(O,$,"batchingTexture"),ut.setValue(O,"batchingTexture",$._matricesTexture,Xe),ut.setOptional(O,$,"batchingIdTexture"),ut.setValue(O,"batchingIdTexture",$._indirectTexture,Xe),ut.setOptional(O,$,"batchingColorTexture"),$._colorsTexture!==null&&ut.setValue(O,"batchingColorTexture",$._colorsTexture,Xe));let Qn=j.morphAttributes;if((Qn.position!==void 0||Qn.normal!==void 0||Qn.color!==void 0)&&re.update($,j,yn),(cs||Fe.receiveShadow!==$.receiveShadow)&&(Fe.receiveShadow=$.receiveShadow,ut.setValue(O,"receiveShadow",$.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&z.environment!==null&&(un.envMapIntensity.value=z.environmentIntensity),un.dfgLUT!==void 0&&(un.dfgLUT.value=QR()),cs){if(ut.setValue(O,"toneMappingExposure",N.toneMappingExposure),Fe.needsLights&&_o(un,Ps),Te&&X.fog===!0&&_e.refreshFogUniforms(un,Te),_e.refreshMaterialUniforms(un,X,Se,Ae,C.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ut=S,xn=0;for(let Xn of C.state.lightProbeGridArray)Xn.texture!==null&&(Ut.textures[xn]=Xn.texture,Ut.min[xn]=Xn.boundingBox.min,Ut.max[xn]=Xn.boundingBox.max,Ut.resolution[xn]=Xn.resolution,xn++);for(let Xn in Ut)Ut[Xn].length=xn;un.probesSH.value=Ut.textures,un.probesMin.value=Ut.min,un.probesMax.value=Ut.max,un.probesResolution.value=Ut.resolution}Ma.upload(O,js(Fe),un,Xe)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(Ma.upload(O,js(Fe),un,Xe),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&ut.setValue(O,"center",$.center),ut.setValue(O,"modelViewMatrix",$.modelViewMatrix),ut.setValue(O,"normalMatrix",$.normalMatrix),ut.setValue(O,"modelMatrix",$.matrixWorld),X.uniformsGroups!==void 0){let Ut=X.uniformsGroups;for(let xn=0,Xn=Ut.length;xn<Xn;xn++){let ac=Ut[xn];He.update(ac,yn),He.bind(ac,yn)}}return yn}function _o(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Qs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,z,j){let X=Ve.get(T);X.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),Ve.get(T.texture).__webglTexture=z,Ve.get(T.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?void 0:j,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let j=Ve.get(T);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,j=0){le=T,Y=z,G=j;let X=null,$=!1,Te=!1;if(T){let Ee=Ve.get(T);if(Ee.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(O.FRAMEBUFFER,Ee.__webglFramebuffer),se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest,Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),J=-1;return}else if(Ee.__webglFramebuffer===void 0)Xe.setupRenderTarget(T);else if(Ee.__hasExternalTextures)Xe.rebindTextures(T,Ve.get(T.texture).__webglTexture,Ve.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let Qe=T.depthTexture;if(Ee.__boundDepthTexture!==Qe){if(Qe!==null&&Ve.has(Qe)&&(T.width!==Qe.image.width||T.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(T)}}let Ie=T.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=Ve.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?X=ze[z][j]:X=ze[z],$=!0):T.samples>0&&Xe.useMultisampledRTT(T)===!1?X=Ve.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?X=ze[j]:X=ze,se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest}else se.copy(Ge).multiplyScalar(Se).floor(),fe.copy(ft).multiplyScalar(Se).floor(),he=ct;if(j!==0&&(X=V),Me.bindFramebuffer(O.FRAMEBUFFER,X)&&Me.drawBuffers(T,X),Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),$){let Ee=Ve.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ee.__webglTexture,j)}else if(Te){let Ee=z;for(let Ie=0;Ie<T.textures.length;Ie++){let ze=Ve.get(T.textures[Ie]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ee)}}else if(T!==null&&j!==0){let Ee=Ve.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ee.__webglTexture,j)}J=-1};function vo(T){let z=Ve.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=ot.textureFormatReadable(T.format),z.__typeReadable=ot.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,j,X,$,Te,Pe,Ee=0){if(!(T&&T.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Me.bindFramebuffer(O.FRAMEBUFFER,Ie);try{let ze=T.textures[Ee],Qe=ze.format,dt=ze.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=vo(ze);if(Be.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-X&&j>=0&&j<=T.height-$&&O.readPixels(z,j,X,$,ge.convert(Qe),ge.convert(dt),Te)}finally{let ze=le!==null?Ve.get(le).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,z,j,X,$,Te,Pe,Ee=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(z>=0&&z<=T.width-X&&j>=0&&j<=T.height-$){Me.bindFramebuffer(O.FRAMEBUFFER,Ie);let ze=T.textures[Ee],Qe=ze.format,dt=ze.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=vo(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.bufferData(O.PIXEL_PACK_BUFFER,Te.byteLength,O.STREAM_READ),O.readPixels(z,j,X,$,ge.convert(Qe),ge.convert(dt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let tn=le!==null?Ve.get(le).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,tn);let Dt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await Jv(O,Dt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Te),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pt),O.deleteSync(Dt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,j=0){let X=Math.pow(2,-j),$=Math.floor(T.image.width*X),Te=Math.floor(T.image.height*X),Pe=z!==null?z.x:0,Ee=z!==null?z.y:0;Xe.setTexture2D(T,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Pe,Ee,$,Te),Me.unbindTexture()},this.copyTextureToTexture=function(T,z,j=null,X=null,$=0,Te=0){let Pe,Ee,Ie,ze,Qe,dt,Be,pt,tn,Dt=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(j!==null)Pe=j.max.x-j.min.x,Ee=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,Qe=j.min.y,dt=j.isBox3?j.min.z:0;else{let ut=Math.pow(2,-$);Pe=Math.floor(Dt.width*ut),Ee=Math.floor(Dt.height*ut),T.isDataArrayTexture?Ie=Dt.depth:T.isData3DTexture?Ie=Math.floor(Dt.depth*ut):Ie=1,ze=0,Qe=0,dt=0}X!==null?(Be=X.x,pt=X.y,tn=X.z):(Be=0,pt=0,tn=0);let Nt=ge.convert(z.format),En=ge.convert(z.type),Fe;z.isData3DTexture?(Xe.setTexture3D(z,0),Fe=O.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Xe.setTexture2DArray(z,0),Fe=O.TEXTURE_2D_ARRAY):(Xe.setTexture2D(z,0),Fe=O.TEXTURE_2D),Me.activeTexture(O.TEXTURE0),Me.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,z.flipY),Me.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Me.pixelStorei(O.UNPACK_ALIGNMENT,z.unpackAlignment);let vn=Me.getParameter(O.UNPACK_ROW_LENGTH),_t=Me.getParameter(O.UNPACK_IMAGE_HEIGHT),Rs=Me.getParameter(O.UNPACK_SKIP_PIXELS),yn=Me.getParameter(O.UNPACK_SKIP_ROWS),yo=Me.getParameter(O.UNPACK_SKIP_IMAGES);Me.pixelStorei(O.UNPACK_ROW_LENGTH,Dt.width),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Dt.height),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,ze),Me.pixelStorei(O.UNPACK_SKIP_ROWS,Qe),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,dt);let cs=T.isDataArrayTexture||T.isData3DTexture,Ps=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let ut=Ve.get(T),un=Ve.get(z),Qn=Ve.get(ut.__renderTarget),Ut=Ve.get(un.__renderTarget);Me.bindFramebuffer(O.READ_FRAMEBUFFER,Qn.__webglFramebuffer),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ut.__webglFramebuffer);for(let xn=0;xn<Ie;xn++)cs&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(T).__webglTexture,$,dt+xn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(z).__webglTexture,Te,tn+xn)),O.blitFramebuffer(ze,Qe,ze+Pe,Qe+Ee,Be,pt,Be+Pe,pt+Ee,O.DEPTH_BUFFER_BIT,O.NEAREST);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if($!==0||T.isRenderTargetTexture||Ve.has(T)){let ut=Ve.get(T),un=Ve.get(z);Me.bindFramebuffer(O.READ_FRAMEBUFFER,U),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let Qn=0;Qn<Ie;Qn++)cs?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ut.__webglTexture,$,dt+Qn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ut.__webglTexture,$),Ps?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,un.__webglTexture,Te,tn+Qn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,un.__webglTexture,Te),$!==0?O.blitFramebuffer(ze,Qe,ze+Pe,Qe+Ee,Be,pt,Be+Pe,pt+Ee,O.COLOR_BUFFER_BIT,O.NEAREST):Ps?O.copyTexSubImage3D(Fe,Te,Be,pt,tn+Qn,ze,Qe,Pe,Ee):O.copyTexSubImage2D(Fe,Te,Be,pt,ze,Qe,Pe,Ee);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Ps?T.isDataTexture||T.isData3DTexture?O.texSubImage3D(Fe,Te,Be,pt,tn,Pe,Ee,Ie,Nt,En,Dt.data):z.isCompressedArrayTexture?O.compressedTexSubImage3D(Fe,Te,Be,pt,tn,Pe,Ee,Ie,Nt,Dt.data):O.texSubImage3D(Fe,Te,Be,pt,tn,Pe,Ee,Ie,Nt,En,Dt):T.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Pe,Ee,Nt,En,Dt.data):T.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Te,Be,pt,Dt.width,Dt.height,Nt,Dt.data):O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Pe,Ee,Nt,En,Dt);Me.pixelStorei(O.UNPACK_ROW_LENGTH,vn),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,_t),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,Rs),Me.pixelStorei(O.UNPACK_SKIP_ROWS,yn),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,yo),Te===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&O.generateMipmap(Fe),Me.unbindTexture()},this.initRenderTarget=function(T){Ve.get(T).__webglFramebuffer===void 0&&Xe.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Xe.setTextureCube(T,0):T.isData3DTexture?Xe.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Xe.setTexture2DArray(T,0):Xe.setTexture2D(T,0),Me.unbindTexture()},this.resetState=function(){Y=0,G=0,le=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ni}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var Oy={type:"change"},hm={type:"start"},By={type:"end"},jh=new Qr,ky=new Si,tP=Math.cos(70*Kp.DEG2RAD),Dn=new K,ui=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},um=1e-6,Qh=class extends Ul{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new K,this.cursor=new K,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Tr.ROTATE,MIDDLE:Tr.DOLLY,RIGHT:Tr.PAN},this.touches={ONE:Er.ROTATE,TWO:Er.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new K,this._lastQuaternion=new Mi,this._lastTargetPosition=new K,this._quat=new Mi().setFromUnitVectors(e.up,new K(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new _a,this._sphericalDelta=new _a,this._scale=1,this._panOffset=new K,this._rotateStart=new tt,this._rotateEnd=new tt,this._rotateDelta=new tt,this._panStart=new tt,this._panEnd=new tt,this._panDelta=new tt,this._dollyStart=new tt,this._dollyEnd=new tt,this._dollyDelta=new tt,this._dollyDirection=new K,this._mouse=new tt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=iP.bind(this),this._onPointerDown=nP.bind(this),this._onPointerUp=sP.bind(this),this._onContextMenu=hP.bind(this),this._onMouseWheel=aP.bind(this),this._onKeyDown=lP.bind(this),this._onTouchStart=cP.bind(this),this._onTouchMove=uP.bind(this),this._onMouseDown=rP.bind(this),this._onMouseMove=oP.bind(this),this._interceptControlDown=fP.bind(this),this._interceptControlUp=dP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Oy),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Dn.copy(t).sub(this.target),Dn.applyQuaternion(this._quat),this._spherical.setFromVector3(Dn),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ui:i>Math.PI&&(i-=ui),s<-Math.PI?s+=ui:s>Math.PI&&(s-=ui),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Dn.setFromSpherical(this._spherical),Dn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Dn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Dn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new K(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new K(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Dn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(jh.origin.copy(this.object.position),jh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(jh.direction))<tP?this.object.lookAt(this.target):(ky.setFromNormalAndCoplanarPoint(this.object.up,this.target),jh.intersectPlane(ky,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>um||8*(1-this._lastQuaternion.dot(this.object.quaternion))>um||this._lastTargetPosition.distanceToSquared(this.target)>um?(this.dispatchEvent(Oy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ui/60*this.autoRotateSpeed*e:ui/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Dn.setFromMatrixColumn(t,0),Dn.multiplyScalar(-e),this._panOffset.add(Dn)}_panUp(e,t){this.screenSpacePanning===!0?Dn.setFromMatrixColumn(t,1):(Dn.setFromMatrixColumn(t,0),Dn.crossVectors(this.object.up,Dn)),Dn.multiplyScalar(e),this._panOffset.add(Dn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Dn.copy(s).sub(this.target);let r=Dn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/t.clientHeight),this._rotateUp(ui*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/t.clientHeight),this._rotateUp(ui*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function nP(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function iP(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function sP(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(By),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function rP(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Tr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Pt.DOLLY;break;case Tr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}break;case Tr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(hm)}function oP(n){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function aP(n){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(n.preventDefault(),this.dispatchEvent(hm),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(By))}function lP(n){this.enabled!==!1&&this._handleKeyDown(n)}function cP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Er.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(n),this.state=Pt.TOUCH_ROTATE;break;case Er.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(n),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case Er.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Pt.TOUCH_DOLLY_PAN;break;case Er.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(hm)}function uP(n){switch(this._trackPointer(n),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Pt.NONE}}function hP(n){this.enabled!==!1&&n.preventDefault()}function fP(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function dP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var pP=`
attribute vec3 real;
attribute vec3 imag;
attribute vec3 origin;
attribute vec2 turn;
uniform vec2 phase;
uniform float swing;
varying vec3 seen;
varying float amount;
void main() {
  vec3 first = real * turn.x - imag * turn.y;
  vec3 second = real * turn.y + imag * turn.x;
  amount = sqrt(dot(real, real) + dot(imag, imag));
  vec3 moved = position + origin + swing * (first * phase.x - second * phase.y);
  vec4 place = modelViewMatrix * vec4(moved, 1.0);
  seen = place.xyz;
  gl_Position = projectionMatrix * place;
}`,mP=`
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`,gP=`
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`,_P={oblique:[.45,-.8,.45],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},ef=class{constructor(e,t,i){this.data=e;this.canvas=t;this.renderer=new Kh({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),this.vectors=e.header.extra.lattice_vectors,this.period=Math.hypot(...this.vectors[0]);let s=Float32Array.from(e.values("skin_position"),u=>u/this.period),r={position:new ri(s,3),real:new ri(new Float32Array(s.length),3),imag:new ri(new Float32Array(s.length),3)};for(let u of[this.surface,this.edges])for(let[h,f]of Object.entries(r))u.setAttribute(h,f);this.surface.setIndex(yP(e.values("skin_face"))),this.edges.setIndex(Array.from(e.values("skin_edge"))),this.box.setFromBufferAttribute(r.position);let o=new eo(Uint8Array.from(i.flatMap(([u=0,h=0,f=0])=>[u,h,f,255])),i.length,1);o.minFilter=o.magFilter=Wn,o.needsUpdate=!0,this.uniforms.scale.value=o;let a={uniforms:this.uniforms,vertexShader:pP},l=new Ui(this.surface,new Ei({...a,fragmentShader:mP,side:Fi,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),c=new Cl(this.edges,new Ei({...a,fragmentShader:gP}));for(let u of[l,c])u.frustumCulled=!1,this.scene.add(u);this.camera.up.set(0,0,1),this.controls=new Qh(this.camera,t),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.colourLines()}data;canvas;renderer;scene=new Tl;camera=new si(28,1,.01,100);controls;uniforms={phase:{value:new tt(1,0)},swing:{value:.15},scale:{value:new eo(new Uint8Array(4),1,1)},ink:{value:new xt(0,0,0)}};surface=new ma;edges=new ma;period;vectors;box=new vs;copies=[1,1];kappa=[0,0];frames=0;turns=[];show({row:e,band:t},i){let[,s=0,r=0]=this.data.shape("path_mode_real"),o=(e*s+t)*r,a=this.data.values("path_shape");for(let l of["real","imag"]){let c=`path_mode_${l}`,u=this.data.values(c).subarray(o,o+r),h=this.data.scale(c)*this.data.scale("path_shape"),f=this.surface.getAttribute(l);vP(f.array,a,u,h),f.needsUpdate=!0}this.kappa=i,this.place()}repeat(e){this.copies=e,this.place(),this.look("oblique")}set swing(e){this.uniforms.swing.value=e}turn(e){this.uniforms.phase.value.set(Math.cos(2*Math.PI*e),Math.sin(2*Math.PI*e)),this.draw()}draw(){this.frames++,this.renderer.render(this.scene,this.camera)}look(e){let[t,i]=this.copies,s=this.box.clone();for(let[c,u]of[[t-1,0],[0,i-1],[t-1,i-1]])s.union(this.box.clone().translate(this.shift(c,u)));let r=s.getBoundingSphere(new Gs),o=this.camera.fov*Math.PI/360,a=Math.atan(Math.tan(o)*Math.min(1,this.camera.aspect)),l=1.08*r.radius/Math.sin(a);this.controls.target.copy(r.center),this.camera.position.set(..._P[e]).normalize().multiplyScalar(l).add(r.center),this.camera.near=.01*l,this.camera.far=10*l,this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}resize(e,t){this.renderer.setPixelRatio(devicePixelRatio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix()}colourLines(){this.uniforms.ink.value.set($e("ink"))}dispose(){this.controls.dispose(),this.surface.dispose(),this.edges.dispose(),this.uniforms.scale.value.dispose(),this.renderer.dispose()}shift(e,t){let[[i,s],[r,o]]=this.vectors;return new K((e*i+t*r)/this.period,(e*s+t*o)/this.period,0)}place(){let[e,t]=this.copies,i=[],s=[];for(let r=0;r<e;r++)for(let o=0;o<t;o++){let a=r*this.kappa[0]+o*this.kappa[1];i.push(...this.shift(r,o).toArray()),s.push(Math.cos(a),Math.sin(a))}this.turns=s;for(let r of[this.surface,this.edges])r.instanceCount=e*t,r.setAttribute("origin",new da(Float32Array.from(i),3)),r.setAttribute("turn",new da(Float32Array.from(s),2))}};function vP(n,e,t,i){n.fill(0);for(let s=0;s<t.length;s++){let r=(t[s]??0)*i;if(r===0)continue;let o=s*n.length;for(let a=0;a<n.length;a++)n[a]+=r*e[o+a]}}function yP(n){let e=[];for(let t=0;t<n.length;t+=4){let[i,s,r,o]=n.subarray(t,t+4);e.push(i,s,r,i,r,o)}return e}var xP=[["oblique","oblique"],["x","along x"],["y","along y"],["z","from above"]];function zy({diagram:n,choice:e}){let t=Et(null),i=Et(null),[s,r]=Ft("");return Bt(()=>{if(t.current===null)return;let o;try{o=new ef(n.data,t.current,Vy(n))}catch{r("The mode cannot be drawn, because this browser has no WebGL.");return}return i.current=o,Object.assign(t.current,{moving:o}),SP(o,n,e)},[n,e]),d("div",{class:"mode",children:[s?d("p",{role:"alert",children:s}):d("canvas",{ref:t,role:"img","aria-label":"The cell moving in the selected mode"}),d("p",{class:"scale",children:[d("span",{children:"0"}),d("span",{class:"bar",style:{background:bP(n)}}),d("span",{children:"1"})," displacement, relative to the largest"]}),d("p",{class:"sides",children:[d("span",{id:"seen",children:"Seen"}),xP.map(([o,a])=>d("button",{type:"button",onClick:()=>i.current?.look(o),"aria-describedby":"seen",children:a}))]}),d(nu,{canvas:t,name:"mode",caption:`${n.data.header.title}, ${tl(n.data)}`})]})}function Vy(n){return n.data.header.extra.colours}function bP(n){return`linear-gradient(to right, ${Vy(n).map(e=>`rgb(${e.join(" ")})`).join(", ")})`}function SP(n,e,t){let{canvas:i}=n,s=()=>n.turn(r.moment),r=new Xo(t,s);tu(i,l=>r.at(l));let o=new ResizeObserver(()=>{n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1)),n.look("oblique")});n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1));let a=[lt(()=>n.repeat(t.copies.value)),lt(()=>{let l=t.point.value;n.show(l,e.phases(l.row)),i.dataset.shown=`${l.row},${l.band}`,s()}),lt(()=>{n.swing=t.swing.value,s()}),ms(()=>{n.colourLines(),n.draw()})];return o.observe(i),()=>{r.end(),o.disconnect();for(let l of a)l();n.dispose()}}function Gy({diagram:n,unit:e}){let{factor:t}=e;return n.gaps.length===0?d("p",{children:"The computed bands have no gap."}):d("div",{class:"wide",children:d("table",{children:[d("caption",{children:"Gaps"}),d("thead",{children:d("tr",{children:[d("th",{scope:"col",children:"bands"}),d("th",{scope:"col",children:"where"}),d("th",{scope:"col",children:lr("lower",e)}),d("th",{scope:"col",children:lr("upper",e)})]})}),d("tbody",{children:n.gaps.map(i=>d("tr",{children:[d("td",{children:[i.waves==="all"?"":`${i.waves} `,i.below,"-",i.below+1]}),d("td",{children:i.complete?"everywhere (complete)":i.waves==="all"?`${i.direction} only`:"everywhere, these waves only"}),d("td",{children:ar(i.lower/t,i.lowerError/t)}),d("td",{children:ar(i.upper/t,i.upperError/t)})]}))})]})})}function Hy({diagram:n,choice:e}){let{row:t,band:i}=e.point.value,s=e.unit.value,{factor:r}=s,o=Array.from({length:n.bands},(a,l)=>({row:t,band:l}));return d("div",{class:"wide",children:d("table",{children:[d("caption",{children:["Modes at ",n.place(t)]}),d("thead",{children:d("tr",{children:[d("th",{scope:"col",children:"band"}),d("th",{scope:"col",children:lr("frequency",s)}),d("th",{scope:"col",children:"motion"}),d("th",{scope:"col",children:"symmetry"}),d("th",{scope:"col",children:"show"})]})}),d("tbody",{children:o.map(a=>d("tr",{"aria-current":a.band===i?"true":void 0,children:[d("td",{children:a.band+1}),d("td",{children:ar(n.at(a)/r,n.errorAt(a)/r)}),d("td",{children:n.nature(a)}),d("td",{children:n.parity(a)}),d("td",{children:d("button",{type:"button",onClick:()=>e.point.value=a,children:["band ",a.band+1]})})]}))})]})})}function qy(n){return d(wP,{data:n})}var MP="Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of the model.";function wP({data:n}){let e=$n(()=>new qc(n),[n]),t=$n(()=>T_(e),[e]),i=$n(()=>R_(e,t),[e,t]);return d(Io,{name:"bands",data:n,keys:i,foot:MP,children:[d("div",{class:"pair",children:[d("section",{"aria-label":"Band diagram",children:[d("div",{class:"walk",tabIndex:0,role:"application","aria-label":"Band diagram. Arrow keys move along the path and between bands.","aria-describedby":"point",children:d(M_,{diagram:e,choice:t})}),d("p",{class:"axes",children:[d(wc,{title:"Frequencies in",units:e.units,unit:t.unit}),d(TP,{diagram:e})]})]}),d("section",{"aria-label":"Mode",children:[d(zy,{diagram:e,choice:t}),d(EP,{diagram:e,choice:t}),d(AP,{choice:t})]})]}),d(Do,{listing:t.listing,keys:i,children:[d(Gy,{diagram:e,unit:t.unit.value}),d(Hy,{diagram:e,choice:t})]})]})}function TP({diagram:n}){return d("span",{class:"legend",children:[n.gaps.some(e=>e.complete)&&d("span",{class:"of-gap",children:"complete gap"}),n.gaps.some(e=>e.waves!=="all")&&d("span",{class:"of-parity",children:"gap of one parity"}),n.carrier!==void 0&&d("span",{class:"of-carrier",children:"carrier"})]})}function EP({diagram:n,choice:e}){let t=e.point.value,i=e.unit.value,s=n.velocity(t),r=[["motion",n.nature(t)],["symmetry",n.parity(t)],["group velocity",s?`${Math.hypot(...s).toPrecision(3)} m/s`:"not defined"]].filter(([,a])=>a),o=n.place(t.row);return d("div",{class:"facts",children:[d("p",{id:"point","aria-live":"polite",children:["Band ",t.band+1," at ",o,": ",d("b",{children:Rc(ar(n.at(t)/i.factor,n.errorAt(t)/i.factor),i)})]}),d("dl",{children:r.map(([a,l])=>d("div",{children:[d("dt",{children:a}),d("dd",{children:l})]}))}),d("p",{class:"again",children:["The same mode as a picture: ",d("code",{children:['haptonic bands STUDY --modes-at "',o,'"']})," or, in Python,"," ",d("code",{children:['study.bands(modes_at="',o,'").plot("modes")']})]})]})}function AP({choice:n}){let[e,t]=n.copies.value;return d("div",{class:"controls",children:[d(Tc,{playing:n.playing}),d("label",{children:["largest displacement, share of the period: ",n.swing.value.toFixed(2),d("input",{type:"range",min:"0",max:Yc,step:"0.01",value:n.swing.value,onInput:i=>n.swing.value=Number(i.currentTarget.value)})]}),d(Ec,{pace:n.pace}),d("label",{children:["cells along a1",d("input",{type:"number",min:"1",max:$c,value:e,onChange:i=>n.copies.value=[Wy(i.currentTarget.value),t]})]}),d("label",{children:["cells along a2",d("input",{type:"number",min:"1",max:$c,value:t,onChange:i=>n.copies.value=[e,Wy(i.currentTarget.value)]})]})]})}function Wy(n){let e=Math.round(Number(n));return Number.isFinite(e)?Math.min(Math.max(e,1),$c):1}var CP=250,Xy=1e6,RP=["low","high","value"];function $y({data:n,finger:e}){let t=Et(null);return Bt(()=>{if(t.current!==null)return PP(t.current,n,e)},[n,e]),d(wt,{children:[d("div",{class:"curves",ref:t}),d("p",{class:"legend",children:[d("span",{class:"of-curve",children:[d("svg",{width:"34",height:"8","aria-hidden":"true",children:d("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:"var(--curve-0)"})})," ","model"]}),d("span",{class:"of-gap",children:"its interval"}),d("span",{class:"of-carrier",children:"people notice less than this"})]})]})}function PP(n,e,t){let i=Array.from(e.amplitudes,c=>c*Xy),s=()=>[i,...RP.map(c=>Array.from(t.law.value[c]))],r={stroke:()=>$e("ink"),ticks:{stroke:()=>$e("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},o=()=>({width:hr(n),height:CP}),a={width:0,points:{show:!1}},l=new nn({...o(),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,distr:3},y:{range:[0,1.02]}},bands:[{series:[2,1],fill:()=>$e("gap")}],axes:[{...r,label:`${e.data.title("table")} / µm`,labelSize:22,size:34,values:(c,u)=>u.map(h=>Number.isInteger(Math.round(1e6*Math.log10(h))/1e6)?String(h):"")},{...r,label:e.data.title("load_sharing"),labelSize:24,size:50}],series:[{},a,a,{stroke:()=>$e("curve-0"),width:2,points:{show:!1}}],hooks:{draw:[c=>IP(c,e,t)]}},s(),n);return fr(l,n,o,[lt(()=>l.setData(s())),lt(()=>{t.below.value,l.redraw(!1,!1)})])}function IP({ctx:n,bbox:e,valToPos:t},i,s){let{amplitude:r,friction:o}=s.below.peek(),a=t(1-i.extra.weber,"y",!0),[l,c]=[t(Math.max(r.value*Xy,.001),"x",!0),t(o.value,"y",!0)];n.save(),n.strokeStyle=$e("carrier"),n.lineWidth=1.5*devicePixelRatio,n.setLineDash([7*devicePixelRatio,5*devicePixelRatio]),n.beginPath(),n.moveTo(e.left,a),n.lineTo(e.left+e.width,a),n.stroke(),n.setLineDash([]),n.strokeStyle=n.fillStyle=$e("accent"),n.beginPath(),n.moveTo(l,e.top),n.lineTo(l,e.top+e.height),n.stroke(),n.beginPath(),n.arc(l,c,5*devicePixelRatio,0,2*Math.PI),n.fill(),n.restore()}var Yy=["value","low","high"],tf=class{constructor(e){this.data=e;this.extra=e.header.extra,this.forces=e.values("force"),this.speeds=e.values("speed"),this.amplitudes=e.values("table"),this.x=e.values("x"),this.y=e.values("y"),this.columns=[...new Set(this.x)].sort((s,r)=>s-r),this.rows=[...new Set(this.y)].sort((s,r)=>s-r),this.cells=new Int32Array(this.columns.length*this.rows.length).fill(-1);let[t,i]=[this.columns,this.rows].map(s=>new Map(s.map((r,o)=>[r,o])));this.x.forEach((s,r)=>{this.cells[(i?.get(this.y[r]??0)??0)*this.columns.length+(t?.get(s)??0)]=r})}data;extra;forces;speeds;amplitudes;x;y;columns;rows;cells;get count(){return this.x.length}placeIn(e,t){if(t<0||t>=this.columns.length)return null;let i=this.cells[e*this.columns.length+t]??-1;return i<0?null:i}nearest([e,t]){let[i,s]=[0,1/0];for(let r=0;r<this.count;r++){let o=((this.x[r]??0)-e)**2+((this.y[r]??0)-t)**2;o<s&&([i,s]=[r,o])}return i}beside(e,t,i){let[s,r]=[this.rows.indexOf(this.y[e]??0),this.columns.indexOf(this.x[e]??0)];return this.placeIn(s+i,r+t)??e}region(e){return this.data.texts("region")[e]||"a lattice"}amplitude(e,t,i){let s=this.data.texts("load").indexOf(t);return i*(this.data.values("amplitude")[s*this.count+e]??0)}law(e,t){let i=this.amplitudes.length,s=this.data.texts("end"),r=(c,u)=>{let h=this.data.values(c);return f=>{let p=(u*s.length+s.indexOf(f))*i;return h.subarray(p,p+i)}},[o,a]=[r("load_sharing",e),r("intermittent",t)],l=(c,u)=>{let[h,f]=[o(c),a(c)];return Float64Array.from(h,(p,_)=>Number.isNaN(p)?f[_]??NaN:u(p,f[_]??NaN))};return{value:l("value",c=>c),low:l("low",Math.min),high:l("high",Math.max)}}friction(e,t){let[i=1,s=1]=[this.amplitudes[0],this.amplitudes.at(-1)],r=e.length-1,o=Math.log(Math.max(t,i)/i)/Math.log(s/i)*r,a=Math.min(Math.floor(o),r-1),l=Math.min(o-a,1);return(e[a]??NaN)*(1-l)+(e[a+1]??NaN)*l}};function Ky(n,e){return n.low>e?"noticed, also at the lower limit":n.value>e?"probably noticed; the lower limit is below the threshold":n.high>e?"probably not noticed; the upper limit is above the threshold":"not noticed, even at the upper limit"}var Yl="#1c2126",Zy={ink:Yl,rim:"#ffffff"};function nf(n,e,t,i=()=>!0){n.beginPath();for(let{outline:s,places:r}of e)for(let o of r)i(o)&&Kl(n,s.map(([a,l])=>[o[0]+a,o[1]+l]),t)}function sf(n,e,t){n.save(),n.strokeStyle=$e("carrier"),n.lineWidth=4*devicePixelRatio;for(let{hold:i,ends:s}of e)n.setLineDash(i==="clamped"?[]:[5*devicePixelRatio,3*devicePixelRatio]),n.beginPath(),Kl(n,s,t),n.stroke();n.restore()}function Kl(n,e,t){e.forEach((i,s)=>s===0?n.moveTo(...t(i)):n.lineTo(...t(i))),n.closePath()}function Ms(n,e,t){n.beginPath(),Kl(n,e,t),n.stroke()}function Rr([n,e],[t,i]){let[s,r]=[t/2,i/2];return[[n-s,e-r],[n+s,e-r],[n+s,e+r],[n-s,e+r]]}function Ta(n,e,t,i,s=Zy){let o=t.flatMap(f=>f.map((p,_)=>[i(p),i(f[(_+1)%f.length]??p)])).filter(([f,p])=>Math.abs(f[1]-p[1])<1),a=Math.min(...o.map(([f])=>f[1])),l=([f,p])=>Math.abs(f[0]-p[0]),[c]=o.filter(([f])=>f[1]<a+1).sort((f,p)=>l(p)-l(f));if(c===void 0)return;let[u,h]=c;fm(n,e,[(u[0]+h[0])/2,a+17*devicePixelRatio],s)}function fm(n,e,[t,i],s=Zy){n.save(),n.font=`${13*devicePixelRatio}px system-ui, sans-serif`,n.textAlign="center",n.lineWidth=3*devicePixelRatio,n.strokeStyle=s.rim,n.fillStyle=s.ink;let r=n.measureText(e).width/2,o=Math.min(Math.max(t,r),n.canvas.width-r);n.strokeText(e,o,i),n.fillText(e,o,i),n.restore()}var LP=.62;function Jy({data:n,finger:e}){let t=Et(null);Bt(()=>{if(t.current!==null)return DP(t.current,n,e)},[n,e]);let{colours:i}=n.extra,s=[0,.25,.5,.75,1].map(r=>`rgb(${(i[Math.round(r*(i.length-1))]??[]).join(" ")})`);return d("div",{class:"map",children:[d("canvas",{ref:t,role:"img","aria-label":"Map of the reduction of friction"}),d("p",{class:"scale",children:[d("span",{children:"0"}),d("span",{class:"bar",style:{background:`linear-gradient(to right, ${s.join(", ")})`}}),d("span",{children:"100 %"})," less friction below a finger with its middle there, model"]})]})}function DP(n,e,t){let[i,s]=[e.columns,e.rows],r=new ImageData(i.length,s.length),o=new OffscreenCanvas(i.length,s.length),[a,l]=[n.getContext("2d"),o.getContext("2d")];if(a===null||l===null)return()=>{};let[c,u]=[i,s].map(m=>NP(m)),h=([m,x])=>[n.width*(m-c[0])/(c[1]-c[0]),n.height*(u[1]-x)/(u[1]-u[0])],f=()=>{let{colours:m}=e.extra,[x,A]=[t.law.peek(),t.drive.peek()];s.forEach((S,P)=>i.forEach((C,v)=>{let E=e.placeIn(P,v),k=4*((s.length-1-P)*i.length+v);if(r.data[k+3]=E===null?0:255,E===null)return;let N=1-e.friction(x.value,e.amplitude(E,"value",A));(m[Math.round(Math.min(Math.max(N,0),1)*(m.length-1))]??[]).forEach((B,V)=>r.data[k+V]=B)})),l.putImageData(r,0,0)},p=()=>{a.clearRect(0,0,n.width,n.height),a.imageSmoothingEnabled=!1,a.drawImage(o,0,0,n.width,n.height),UP(a,e,h),FP(a,e,t.place.peek(),h),n.dataset.shown=String(t.place.peek())},_=()=>{let m=(u[1]-u[0])/(c[1]-c[0]),x=Math.min(n.parentElement?.clientWidth??300,LP*innerHeight/m);n.style.width=`${x}px`,n.style.height=`${x*m}px`,n.width=Math.round(x*devicePixelRatio),n.height=Math.round(x*m*devicePixelRatio),p()},b=new ResizeObserver(_);n.parentElement!==null&&b.observe(n.parentElement);let g=[lt(()=>{t.law.value,t.drive.value,f(),p()}),lt(()=>{t.place.value,p()}),ms(p),OP(n,([m,x])=>{let A=[c[0]+m*(c[1]-c[0]),u[1]-x*(u[1]-u[0])];t.place.value=e.nearest(A)})];return()=>{b.disconnect();for(let m of g)m()}}function NP(n){let[e=0,t=e+.001]=n,i=(t-e)/2;return[e-i,(n.at(-1)??0)+i]}function UP(n,{extra:e},t){n.lineWidth=1.2*devicePixelRatio,n.strokeStyle="#ffffff";for(let i of Object.values(e.regions).flat())Ms(n,i,t);n.strokeStyle=$e("quiet");for(let i of e.plate)Ms(n,i,t);n.strokeStyle="#ffffff",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[i,s,r,o]of Object.values(e.patches))Ms(n,Rr([i,s],[r,o]),t);n.setLineDash([]);for(let[i,s]of Object.entries(e.regions))Ta(n,i,s,t)}function FP(n,e,t,i){let s=[e.x[t]??0,e.y[t]??0],[r,o]=i(s),a=i([s[0]+e.extra.diameter/2,s[1]])[0]-r;for(let[l,c]of[["#ffffff",5],[Yl,2]])n.strokeStyle=l,n.lineWidth=c*devicePixelRatio,n.beginPath(),n.arc(r,o,a,0,2*Math.PI),n.moveTo(r-4*devicePixelRatio,o),n.lineTo(r+4*devicePixelRatio,o),n.moveTo(r,o-4*devicePixelRatio),n.lineTo(r,o+4*devicePixelRatio),n.stroke()}function OP(n,e){let t=i=>{if(i.type==="pointerdown")n.setPointerCapture(i.pointerId);else if(i.buttons===0)return;let s=n.getBoundingClientRect();e([(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height])};return n.addEventListener("pointerdown",t),n.addEventListener("pointermove",t),()=>{n.removeEventListener("pointerdown",t),n.removeEventListener("pointermove",t)}}var kP=5,jy=1.05;function Qy(n){let{drive:e,force:t,speed:i}=n.extra,s=De(BP(n)),r={drive:De(e.value),force:De(n.forces.indexOf(t)),speed:De(n.speeds.indexOf(i))};r.force.peek()<0&&(r.force.value=0);let o=Wt(()=>n.law(r.force.value,r.speed.value)),a=Wt(()=>zP(n,o.value,s.value,r.drive.value));return{place:s,...r,listing:De("none"),law:o,below:a}}function BP(n){let e=n.extra.diameter/2,t=(r,o)=>r-e>=(o[0]??0)&&r+e<=(o.at(-1)??0),[i,s]=[0,-1];for(let r=0;r<n.count;r++){let o=n.amplitude(r,"value",1),a=t(n.x[r]??0,n.columns)&&t(n.y[r]??0,n.rows);o>s&&a&&([i,s]=[r,o])}return i}function zP(n,e,t,i){let s=a=>Object.fromEntries(Yy.map(l=>[l,a(l)])),r=s(a=>n.amplitude(t,a,i)),o=s(a=>n.friction(e[a],r[a]));return{amplitude:r,free:n.amplitude(t,"free",i),friction:o,reduction:{value:1-o.value,low:1-o.high,high:1-o.low}}}function ex(n,e){let t=(c,u)=>h=>{for(let f=0;f<(h.shiftKey?kP:1);f++)e.place.value=n.beside(e.place.peek(),c,u)},{low:i,high:s}=n.extra.drive,r=c=>()=>e.drive.value=Math.min(Math.max(e.drive.peek()*c,i),s),o=(c,u,h)=>()=>c.value=Math.min(Math.max(c.peek()+u,0),h-1),[a,l]=[n.forces.length,n.speeds.length];return[{keys:"← → ↑ ↓",effect:"move the finger; five places with Shift",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}},{keys:"+ −",effect:"5 % more or less drive",actions:{"+":r(jy),"-":r(1/jy)}},{keys:"f F",effect:"more or less force",actions:{f:o(e.force,1,a),F:o(e.force,-1,a)}},{keys:"s S",effect:"faster or slower",actions:{s:o(e.speed,1,l),S:o(e.speed,-1,l)}},...Lo(e.listing)]}var VP=.62;function tx({plate:n,choice:e}){let t=Et(null);Bt(()=>{if(t.current!==null)return GP(t.current,n,e)},[n,e]);let s=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(r=>`rgb(${(n.colours[r]??[]).join(" ")})`);return d("div",{class:"map",children:[d("canvas",{ref:t,role:"img","aria-label":"Map of the moving plate"}),d("p",{class:"scale",children:[d("span",{children:`−${ao(n.largest(e.line.value))}`}),d("span",{class:"bar",style:{background:`linear-gradient(to right, ${s.join(", ")})`}}),d("span",{children:ao(n.largest(e.line.value))})," normal displacement",n.drive]}),d(nu,{canvas:t,name:"map",caption:`${n.data.header.title}, ${tl(n.data)}`})]})}function ao(n){let[e,t]=n>=1e-6?["µm",1e6]:n>=1e-9?["nm",1e9]:["pm",1e12];return`${Number((n*Number(t)).toPrecision(3))} ${e}`}function GP(n,e,t){let{left:i,right:s,bottom:r,top:o}=e.extent,a=new ImageData(e.columns,e.rows),l=new OffscreenCanvas(e.columns,e.rows),c=n.getContext("2d"),u=l.getContext("2d");if(c===null||u===null)return()=>{};let h={frames:0},f=()=>{let m=t.line.peek();h.frames++,e.paint(a,m,e.outermost(m)+p.moment),u.putImageData(a,0,0),c.clearRect(0,0,n.width,n.height),c.imageSmoothingEnabled=!0,c.imageSmoothingQuality="high",c.drawImage(l,0,0,n.width,n.height),HP(c,e,([A,S])=>[n.width*(A-i)/(s-i),n.height*(o-S)/(o-r)],t.plan.peek()),n.dataset.shown=String(m)},p=new Xo(t,f);tu(n,m=>p.at(m));let _=()=>{let m=(o-r)/(s-i),x=n.parentElement?.clientWidth??300,A=Math.min(x,VP*innerHeight/m);n.style.width=`${A}px`,n.style.height=`${A*m}px`,n.width=Math.round(A*devicePixelRatio),n.height=Math.round(A*m*devicePixelRatio),f()},b=new ResizeObserver(_);n.parentElement!==null&&b.observe(n.parentElement),Object.assign(n,{counted:h});let g=[lt(()=>{t.line.value,t.plan.value,f()}),ms(f)];return()=>{p.end(),b.disconnect();for(let m of g)m()}}function HP(n,e,t,i){let{plate:s,regions:r,patches:o,features:a,held:l}=e.parts;n.strokeStyle=Yl,n.lineWidth=1.2*devicePixelRatio;for(let c of Object.values(r).flat())Ms(n,c,t);i&&(n.lineWidth=.8*devicePixelRatio,nf(n,a,t),n.stroke(),sf(n,l,t)),n.lineWidth=1.2*devicePixelRatio,n.strokeStyle=$e("quiet");for(let c of s)Ms(n,c,t);n.strokeStyle="#855a12",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[c,u,h,f]of Object.values(o))Ms(n,Rr([c,u],[h,f]),t);n.setLineDash([]);for(let[c,u]of Object.entries(r))Ta(n,c,u,t)}var WP="All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, at the nearest computed place.",qP=500;function sx(n){return d(XP,{dataset:n})}function XP({dataset:n}){let e=$n(()=>new tf(n),[n]),t=$n(()=>Qy(e),[e]),i=$n(()=>ex(e,t),[e,t]);return d(Io,{name:"finger",data:n,keys:i,foot:WP,children:[d("div",{class:"pair",children:[d("section",{"aria-label":"Map",children:d("div",{class:"walk",tabIndex:0,role:"application","aria-describedby":"felt","aria-label":"Finger on the plate. Arrow keys move it.",children:d(Jy,{data:e,finger:t})})}),d("section",{"aria-label":"Friction",children:[d($P,{data:e,finger:t}),d($y,{data:e,finger:t}),d(YP,{data:e,finger:t})]})]}),d(Do,{listing:t.listing,keys:i,children:d(KP,{data:e})})]})}function $s(n,e){let t=Math.abs(n),[i,s]=t>=1||t===0?["",1]:t>=.001?["m",1e3]:["µ",1e6];return`${Number((n*Number(s)).toPrecision(3))} ${i}${e}`}var nx=n=>`${(100*n).toFixed(0)} %`;function $P({data:n,finger:e}){let{amplitude:t,free:i,friction:s,reduction:r}=e.below.value,o=e.place.value,{weber:a,frequency:l,drive:c,diameter:u}=n.extra,h=(p,_,[b,g])=>`${_(p.value)} (${_(p[b])} to ${_(p[g])})`,f=p=>p.toFixed(2);return d("div",{class:"facts",children:[d("p",{id:"felt","aria-live":"polite",children:[d("b",{children:n.region(o)}),", x = ",$s(n.x[o]??0,"m"),", y = ",$s(n.y[o]??0,"m"),":"," ",d("b",{children:Ky(r,a)})]}),d("dl",{children:[d("div",{children:[d("dt",{children:"mu / mu0, model"}),d("dd",{children:h(s,f,["low","high"])})]}),d("div",{children:[d("dt",{children:"less friction"}),d("dd",{children:h(r,nx,["low","high"])})]}),d("div",{children:[d("dt",{children:"amplitude below the finger"}),d("dd",{children:h(t,ao,["high","low"])})]}),d("div",{children:[d("dt",{children:"without a finger"}),d("dd",{children:ao(i)})]})]}),d("p",{class:"again",children:["People notice reductions above ",nx(a),". The finger covers ",$s(u,"m"),";"," ",Number((l/1e3).toFixed(3))," kHz. The same in the study:"," ",d("code",{children:["touch = ","{",' force = "',$s(n.forces[e.force.value]??0,"N"),'", speed = "',$s(n.speeds[e.speed.value]??0,"m/s"),'"',c.unit==="V"?`, voltage = "${$s(e.drive.value,"V")}"`:""," ","}"]})]})]})}function YP({data:n,finger:e}){let{low:t,high:i,title:s,unit:r}=n.extra.drive;return d("div",{class:"controls",children:[d("label",{class:"long",children:["Drive, ",s.toLowerCase(),": ",$s(e.drive.value,r),d("input",{type:"range",min:t,max:i,step:(i-t)/qP||1,value:e.drive.value,"aria-valuetext":$s(e.drive.value,r),onInput:o=>e.drive.value=Number(o.currentTarget.value)})]}),d(ix,{title:n.data.title("force"),unit:"N",values:n.forces,chosen:e.force}),d(ix,{title:n.data.title("speed"),unit:"m/s",values:n.speeds,chosen:e.speed})]})}function ix({title:n,unit:e,values:t,chosen:i}){let s=$s(t[i.value]??0,e);return d("label",{class:"long",children:[n,": ",s,d("input",{type:"range",min:"0",max:t.length-1,step:"1",value:i.value,"aria-valuetext":s,onInput:r=>i.value=Number(r.currentTarget.value)})]})}function KP({data:n}){return d("div",{class:"wide",children:[d("table",{children:[d("caption",{children:"Numbers of the models"}),d("thead",{children:d("tr",{children:["number","value","plausible","origin","source"].map(e=>d("th",{scope:"col",children:e}))})}),d("tbody",{children:n.extra.parameters.map(({title:e,value:t,plausible:i,mark:s,source:r})=>d("tr",{children:[e,t,i,s,r].map(o=>d("td",{children:o}))}))})]}),d("dl",{children:Object.entries(n.extra.models).map(([e,t])=>d("div",{children:[d("dt",{children:["Model of ",e]}),d("dd",{children:t})]}))})]})}var rf=class{constructor(e){this.data=e;let{extra:t}=e.header;this.frequency=e.values("frequency"),[,this.rows=0,this.columns=0]=e.shape("shape_real"),this.real=e.values("shape_real"),this.imag=e.values("shape_imag"),this.step=e.values("shape_step"),this.present=e.values("present"),this.gap=t.gap,this.carrier=Number(t.carrier),this.drive=String(t.drive),this.parts=t,this.colours=t.colours,this.units=Ac(e);let[i,s]=[e.values("mode_frequency"),e.values("mode_quality")];this.modes=Array.from(i,(r,o)=>({frequency:r,name:e.texts("mode_name")[o]??"",quality:s[o]??NaN}))}data;frequency;columns;rows;gap;carrier;drive;parts;modes;colours;units;real;imag;step;present;nearest(e){let t=0;return this.frequency.forEach((i,s)=>{Math.abs(i-e)<Math.abs((this.frequency[t]??0)-e)&&(t=s)}),t}get first(){return this.nearest(Number(this.data.header.extra.first))}largest(e){return(this.step[e]??0)*(this.colours.length-1)*.5}get extent(){let[e,t]=[this.data.values("x"),this.data.values("y")],[i,s]=[rx(e),rx(t)];return{left:(e[0]??0)-i,right:(e[e.length-1]??0)+i,bottom:(t[0]??0)-s,top:(t[t.length-1]??0)+s}}paint(e,t,i){let[s,r]=[Math.cos(2*Math.PI*i),Math.sin(2*Math.PI*i)],o=(this.colours.length-1)/2,a=t*this.rows*this.columns;for(let l=0;l<this.rows;l++)for(let c=0;c<this.columns;c++){let u=l*this.columns+c,h=(this.real[a+u]??0)*s-(this.imag[a+u]??0)*r,f=Math.min(Math.max(Math.round(o+h),0),2*o),[p=0,_=0,b=0]=this.colours[f]??[],g=4*((this.rows-1-l)*this.columns+c);e.data[g]=p,e.data[g+1]=_,e.data[g+2]=b,e.data[g+3]=this.present[u]===0?0:255}}outermost(e){let t=e*this.rows*this.columns,[i,s]=[0,-1];for(let r=t;r<t+this.rows*this.columns;r++){let o=Math.hypot(this.real[r]??0,this.imag[r]??0);o>s&&([i,s]=[r,o])}return-Math.atan2(this.imag[i]??0,this.real[i]??0)/(2*Math.PI)}has(e){return this.data.has(e)}curves(e){if(!this.data.has(e))return[];let t=this.data.values(e),i=this.data.texts(e==="level"?"region":"pair"),s=this.frequency.length;return i.map((r,o)=>({name:r,values:Array.from(t.subarray(o*s,(o+1)*s),a=>Number.isFinite(a)&&(e==="contrast"||a>0)?a:null)}))}};function rx(n){return n.length>1?.5*((n[1]??0)-(n[0]??0)):5e-4}var Zl=[[],[8,4],[2,3],[10,3,2,3]],dm=4,ZP=300;function ax({plate:n,choice:e}){let t=Et(null),i=e.shown.value;return Bt(()=>{if(t.current!==null)return JP(t.current,n,e)},[n,e,i]),d("div",{class:"curves",ref:t})}function JP(n,e,t){let i=t.shown.peek(),s=e.curves(i),r=e.data.unit(i),o={stroke:()=>$e("ink"),ticks:{stroke:()=>$e("rule")}},a={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},l=()=>t.unit.peek().factor,c=()=>[Array.from(e.frequency,f=>f/l()),...s.map(({values:f})=>f)],u=()=>({width:hr(n),height:ZP}),h=new nn({...u(),legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},scales:{x:{time:!1},y:{distr:i==="level"?3:1}},axes:[{...o,...a,label:"frequency",labelSize:22,size:34,grid:{show:!1}},{...o,...a,label:`${e.data.title(i)} / ${r}`,labelSize:24,size:58,grid:{show:!1},values:(f,p)=>p.map(_=>_===null?"":jP(_,i==="level"))}],series:[{},...s.map((f,p)=>({stroke:()=>$e(`curve-${p%dm}`),dash:Zl[p%Zl.length]??[],width:1.4,points:{show:!1}}))],hooks:{drawClear:[f=>qo(f,()=>QP(f,e,l()))],draw:[f=>eI(f,e,t)]}},c(),n);return Wo(h,f=>t.line.value=e.nearest(l()*h.posToVal(f,"x"))),fr(h,n,u,[lt(()=>{let f=h.axes[0];f!==void 0&&(f.label=lr("frequency",t.unit.value)),h.setData(c(),!0)}),lt(()=>{t.line.value,h.redraw(!1,!1)})])}function jP(n,e){if(!e)return`${Number(n.toPrecision(4))}`.replace("-","−");let t=Math.log10(n);return Math.abs(t-Math.round(t))<1e-9?`1e${Math.round(t)}`.replace("-","−"):""}function QP(n,e,t){let{ctx:i,bbox:s}=n;if(e.gap===null)return;let[r,o]=e.gap.map(a=>n.valToPos(a/t,"x",!0));i.fillStyle=$e("gap"),i.fillRect(r,s.top,o-r,s.height)}function eI(n,e,t){let{factor:i}=t.unit.peek();ox(n,e.carrier/i,$e("carrier"),[7,5]),ox(n,(e.frequency[t.line.peek()]??0)/i,$e("accent"),[])}function ox({ctx:n,bbox:e,valToPos:t},i,s,r){let o=t(i,"x",!0);o<e.left||o>e.left+e.width||(n.save(),n.strokeStyle=s,n.lineWidth=1.5*devicePixelRatio,n.setLineDash(r.map(a=>a*devicePixelRatio)),n.beginPath(),n.moveTo(o,e.top),n.lineTo(o,e.top+e.height),n.stroke(),n.restore())}var tI=10;function lx(n){return{line:De(n.first),shown:De(n.has("level")?"level":"contrast"),plan:De(!1),unit:De(Cc(n.units,Math.max(...n.frequency))),playing:De(!Xc()),pace:De(.7),listing:De("none")}}function cx(n,e){let t=n.frequency.length-1,i=a=>e.line.value=Math.min(Math.max(e.line.value+a,0),t),s=a=>a.shiftKey?tI:1,r=n.modes.map(({frequency:a})=>n.nearest(a)).sort((a,l)=>a-l),o=a=>{a!==void 0&&(e.line.value=a)};return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:a=>i(-s(a)),ArrowRight:a=>i(s(a))}},{keys:"p n",effect:"previous or next mode near the carrier",actions:{p:()=>o(r.filter(a=>a<e.line.value).pop()),n:()=>o(r.find(a=>a>e.line.value))}},{keys:"c",effect:"carrier",actions:{c:()=>o(n.nearest(n.carrier))}},{keys:"g",effect:"resonance in the gap",actions:{g:()=>o(n.first)}},{keys:"l",effect:"pillars and supports",actions:{l:()=>e.plan.value=!e.plan.value}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},...Lo(e.listing)]}var nI="The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.",ux=["level","contrast"];function hx(n){return d(iI,{data:n})}function iI({data:n}){let e=$n(()=>new rf(n),[n]),t=$n(()=>lx(e),[e]),i=$n(()=>cx(e,t),[e,t]),s=ux.filter(r=>e.has(r));return d(Io,{name:"plate",data:n,keys:i,foot:nI,children:[d("div",{class:"pair",children:[d("section",{"aria-label":"Spectra",children:[s.length>0&&e.frequency.length>1&&d(wt,{children:[d("div",{class:"walk",tabIndex:0,role:"application","aria-label":"Spectra. Arrow keys change the frequency.","aria-describedby":"point",children:d(ax,{plate:e,choice:t})}),d(sI,{plate:e,choice:t}),d("p",{class:"axes",children:[d("label",{children:["Curves"," ",d("select",{value:t.shown.value,onChange:r=>t.shown.value=r.currentTarget.value,children:s.map(r=>d("option",{value:r,children:e.data.title(r)}))})]}),d(wc,{title:"Frequencies in",units:e.units,unit:t.unit})]})]}),d(rI,{plate:e,choice:t})]}),d("section",{"aria-label":"Map",children:[d(tx,{plate:e,choice:t}),d("div",{class:"controls",children:[d(Tc,{playing:t.playing}),d(oI,{plate:e,choice:t}),d(Ec,{pace:t.pace}),d("label",{class:"check",children:[d("input",{type:"checkbox",checked:t.plan.value,onChange:r=>t.plan.value=r.currentTarget.checked}),"pillars and supports"]})]})]})]}),d(Do,{listing:t.listing,keys:i,children:[d(aI,{plate:e,choice:t}),d(lI,{plate:e,choice:t})]})]})}function sI({plate:n,choice:e}){return d("p",{class:"legend",children:[n.curves(e.shown.value).map(({name:t},i)=>d("span",{class:"of-curve",children:[d("svg",{width:"34",height:"8","aria-hidden":"true",children:d("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${i%dm})`,"stroke-dasharray":(Zl[i%Zl.length]??[]).join(" ")})})," ",t]})),n.gap!==null&&d("span",{class:"of-gap",children:"gap"}),d("span",{class:"of-carrier",children:"carrier"})]})}function Ea(n,e){return Rc(Zg(n/e.factor),e)}function rI({plate:n,choice:e}){let t=e.line.value,i=n.frequency[t]??0,s=n.curves("contrast");return d("div",{class:"facts",children:[d("p",{id:"point","aria-live":"polite",children:[d("b",{children:Ea(i,e.unit.value)}),": up to ",ao(n.largest(t)),n.drive,s.map(({name:r,values:o})=>`; ${r} ${o[t]?.toFixed(1)??"-"} dB`).join("")]}),d("p",{class:"again",children:["The same map as a picture, in Python: ",d("code",{children:['study.plate().plot("maps", frequency=',Number(i.toFixed(3)),")"]})]})]})}function oI({plate:n,choice:e}){let t=n.frequency.length-1,i=e.line.value;return d("label",{class:"long",children:["frequency: ",Ea(n.frequency[i]??0,e.unit.value),d("input",{type:"range",min:"0",max:t,step:"1",value:i,disabled:t===0,"aria-valuetext":Ea(n.frequency[i]??0,e.unit.value),onInput:s=>e.line.value=Number(s.currentTarget.value)})]})}function aI({plate:n,choice:e}){let t=e.line.value,i=ux.flatMap(s=>n.curves(s).map(({name:r,values:o})=>[n.data.title(s),r,`${o[t]?.toPrecision(3)??"-"} ${n.data.unit(s)}`]));return d("div",{class:"wide",children:d("table",{children:[d("caption",{children:["Regions at ",Ea(n.frequency[t]??0,e.unit.value)]}),d("tbody",{children:i.map(s=>d("tr",{children:s.map(r=>d("td",{children:r}))}))})]})})}function lI({plate:n,choice:e}){return n.modes.length===0?null:d("div",{class:"wide",children:d("table",{children:[d("caption",{children:"Modes near the carrier"}),d("thead",{children:d("tr",{children:[d("th",{scope:"col",children:"frequency"}),d("th",{scope:"col",children:"nodal lines"}),d("th",{scope:"col",children:"Q"}),d("th",{scope:"col",children:"show"})]})}),d("tbody",{children:n.modes.map(({frequency:t,name:i,quality:s})=>d("tr",{children:[d("td",{children:Ea(t,e.unit.value)}),d("td",{children:i}),d("td",{children:s.toFixed(0)}),d("td",{children:d("button",{type:"button",onClick:()=>e.line.value=n.nearest(t),children:Ea(n.frequency[n.nearest(t)]??0,e.unit.value)})})]}))})]})})}var fx='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var dx=`& {
  --paper: #ffffff;
  --panel: #f5f6f7;
  --ink: #1c2126;
  --quiet: #4d565e;
  --rule: #c9ced3;
  --accent: #0a5ea8;
  --gap: #f3d9a4;
  --carrier: #b3123f;
  --curve-0: #0072b2;
  --curve-1: #b34e00;
  --curve-2: #007a59;
  --curve-3: #a0447c;
  color-scheme: light dark;
  background: var(--paper);
  color: var(--ink);
  font: 1rem/1.45 system-ui, sans-serif;
}
@media (prefers-color-scheme: dark) {
  & {
    --paper: #15181b;
    --panel: #1f2428;
    --ink: #e8eaec;
    --quiet: #b3bac0;
    --rule: #4a5258;
    --accent: #6db3f2;
    --gap: #5c4714;
    --carrier: #ff7d9c;
    --curve-0: #6db3f2;
    --curve-1: #ffb066;
    --curve-2: #4fd1a5;
    --curve-3: #f0a3cf;
  }
}
body { margin: 0; }
.view { container-type: inline-size; }
#view { max-width: 84rem; margin: 0 auto; padding: 0.75rem 1rem 2rem; }
h1 { font-size: 1.3rem; margin: 0; display: inline-block; }
.origin {
  display: inline-block; margin: 0 0 0 0.75rem; padding: 0 0.5rem;
  border: 1px solid var(--rule); border-radius: 0.75rem; color: var(--quiet); font-size: 0.85rem;
}
header p { margin: 0.25rem 0; max-width: 60rem; }
.pair { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr); margin-top: 0.75rem; }
@container (min-width: 52rem) { .pair { grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr); } }
.walk:focus-visible, button:focus-visible, input:focus-visible, select:focus-visible, canvas:focus-visible {
  outline: 3px solid var(--accent); outline-offset: 2px;
}
.curves { width: 100%; overflow: hidden; }
.mode canvas {
  display: block; width: 100%; height: clamp(17rem, 46vh, 30rem); background: var(--panel);
  border-radius: 0.4rem; touch-action: none;
}
.map canvas { display: block; max-width: 100%; background: var(--panel); }
.finger .map canvas { touch-action: none; cursor: pointer; }
.finger .map .bar { flex: 0 1 8rem; }
.axes label { max-width: 100%; }
.opened { display: flex; gap: 0.4rem; }
.legend .of-curve::before { display: none; }
.legend .of-curve { margin-right: 1rem; }
.legend > span { display: inline-block; }
.axes, .sides, .controls { display: flex; flex-wrap: wrap; gap: 0.4rem 1rem; align-items: center; margin: 0.5rem 0; }
.sides { gap: 0.4rem; font-size: 0.9rem; }
.scale { display: flex; flex-wrap: wrap; gap: 0.4rem; align-items: center; margin: 0.4rem 0; font-size: 0.85rem; }
.scale .bar { width: 8rem; height: 0.8rem; border: 1px solid var(--rule); }
.legend span::before { content: ""; display: inline-block; width: 1.4em; height: 0.8em; margin: 0 0.35em 0 0.9em; }
.legend .of-gap::before { background: var(--gap); border: 1px solid var(--rule); }
.legend .of-parity::before { background: repeating-linear-gradient(-45deg, var(--gap) 0 2px, transparent 2px 6px); border: 1px solid var(--rule); }
.legend .of-carrier::before { height: 0; border-top: 2px dashed var(--carrier); vertical-align: 0.25em; }
.facts p { margin: 0.4rem 0; }
.facts dl { display: flex; flex-wrap: wrap; gap: 0.2rem 1.5rem; margin: 0.4rem 0; }
.facts dt { color: var(--quiet); font-size: 0.85rem; }
.facts dd { margin: 0; }
.again { color: var(--quiet); font-size: 0.9rem; }
code { font: 0.95em ui-monospace, monospace; overflow-wrap: anywhere; }
.controls label { display: flex; flex-direction: column; font-size: 0.85rem; color: var(--quiet); }
.controls label.check { flex-direction: row; gap: 0.4rem; align-items: center; }
button, select, input[type="number"] {
  font: inherit; color: var(--ink); background: var(--panel); border: 1px solid var(--quiet);
  border-radius: 0.35rem; padding: 0.2rem 0.6rem; min-height: 1.9rem;
}
select { max-width: 100%; }
button { cursor: pointer; }
a { color: var(--accent); }
input[type="range"] { accent-color: var(--accent); min-width: 10rem; }
.controls .long { flex: 1 1 100%; }
.wide { overflow-x: auto; position: relative; }
table { border-collapse: collapse; margin: 0.5rem 0 1rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: 0.3rem 0; }
th, td { text-align: left; padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid var(--rule); font-weight: normal; }
thead th { color: var(--quiet); }
tr[aria-current] td { font-weight: 600; }
footer { color: var(--quiet); font-size: 0.85rem; }
`;var hI={bands:qy,plate:hx,finger:sx};function px(n,e){let t=hI[n.header.kind];if(t===void 0)throw new Error(`this version has no view "${n.header.kind}"`);return pm(),e.classList.add("haptonic","view"),Xa(t(n),e),()=>Xa(null,e)}function pm(){if(document.getElementById("haptonic-style")!==null)return;let n=document.createElement("style");n.id="haptonic-style",n.textContent=`${fx}:where(.haptonic) { ${dx} }`,document.head.append(n)}var of=/^\s*\[\[?\s*([^\]]+?)\s*\]\]?/,fI=["quantity","number","integer","quantities","entries"];function mx(n,e,t,i){let s=n.lastIndexOf(`
`,e-1)+1,r=n.slice(s,e),o=n.slice(0,s).split(`
`),a=new Map(t.map(f=>[f.path,f])),l=r.indexOf("="),c=/^\s*\[+\s*([\w.-]*)$/.exec(r);if(c!==null)return gI(c[1]??"",e-r.trimStart().length,t);let u=dI(o,a);if(l<0){let f=pI(n.split(`
`),o.length-1);return _I(/[\w-]*$/.exec(r)?.[0]??"",e,{keys:t,table:u,given:f})}let h=a.get(_x(u,gx(r.slice(0,l).trim(),a,u)))??a.get(u);return h===void 0?{from:e,list:[]}:vI(r.slice(l+1),e,h,h.path===i?[]:mI(n,i))}function dI(n,e){return gx(n.flatMap(t=>of.exec(t)?.[1]??[]).at(-1)??"",e,"")}function gx(n,e,t){return n.split(".").reduce((i,s)=>{let r=i?`${i}.${s.trim()}`:s.trim();return e.get(_x(t,r))?.kind==="tables"?`${r}[]`:r},"")}var _x=(n,e)=>n&&e?`${n}.${e}`:n||e;function pI(n,e){let t=n.map(o=>of.test(o)),i=t.lastIndexOf(!0,e)+1,s=t.indexOf(!0,e+1),r=n.filter((o,a)=>a>=i&&(s<0||a<s)&&a!==e);return new Set(r.map(o=>/^\s*([\w-]+)\s*=/.exec(o)?.[1]??""))}function mI(n,e){let t=n.split(`
`),i=t.findIndex(r=>of.exec(r)?.[1]===e)+1;if(i===0)return[];let s=t.slice(i).findIndex(r=>of.test(r));return t.slice(i,s<0?t.length:i+s).flatMap(r=>{let[,o,a]=/^\s*([A-Za-z_]\w*)\s*=\s*(.*)/.exec(r)??[];return o===void 0?[]:[[o,a??""]]})}function mm(n,e){let t=e.toLowerCase();return n.filter(({label:i})=>i.replace(/^[["]+/,"").toLowerCase().startsWith(t)).slice(0,50)}function gI(n,e,t){let i=t.filter(({kind:s})=>["table","tables","entries"].includes(s)).map(({path:s,kind:r,title:o})=>{let a=s.replaceAll("[]",""),l=r==="tables"?`[[${a}]]`:`[${a}]`;return{insert:l,label:l,detail:o}});return{from:e,list:mm(i,n)}}function _I(n,e,{keys:t,table:i,given:s}){let r=t.filter(({path:o,kind:a})=>o.slice(0,o.lastIndexOf(".")+1)===(i&&`${i}.`)&&!["table","tables","entries"].includes(a)).map(o=>({name:o.path.slice(o.path.lastIndexOf(".")+1),key:o})).filter(({name:o})=>!s.has(o)).map(({name:o,key:a})=>({insert:`${o} = `,label:o,detail:a.title+(a.required?", required":a.default?`, default ${a.default}`:"")}));return{from:e-n.length,list:mm(r,n)}}function vI(n,e,t,i){let s=n.trimStart().startsWith('"'),r=/[\w.-]*$/.exec(n)?.[0]??"",o=f=>s?f:`"${f}"`,a=[...t.names,...t.numbers].map(f=>({insert:o(f),label:f,detail:t.title})),l=t.kind==="boolean"?["true","false"].map(f=>({insert:f,label:f,detail:t.title})):[],u=(fI.includes(t.kind)?i:[]).map(([f,p])=>({insert:o(f),label:f,detail:`parameter, ${p}`})),h=n.trim()===""&&t.example&&!t.closed?[{insert:t.kind==="quantity"?`"${t.example}"`:t.example,label:t.example,detail:`${t.title}, an example`}]:[];return{from:e-r.length,list:mm([...l,...a,...u,...h],r)}}var Pr=class extends Error{constructor(t,i){super(t);this.problem=i}problem};async function yx(n){let e;try{e=await n}catch{throw new Pr("The server does not answer; is `haptonic studio` still running?")}if(e.ok)return e;if(e.status===422){let{error:t}=await e.json();throw new Pr(`${t.argument}: ${t.cause}`,t)}throw e.status===403?new Pr("The server was started again; open its new link."):new Pr(e.headers.get("content-type")?.startsWith("text/plain")?await e.text():`Error ${e.status} of the server.`)}var af=async n=>await(await yx(n)).json();async function vx(n){let e=await yx(n);return{name:/filename="([^"]*)"/.exec(e.headers.get("content-disposition")??"")?.[1]??"file",content:await e.blob()}}function xx(n,e){let t={"content-type":"application/json"};return fetch(`api/${n}`,{method:"POST",headers:t,body:JSON.stringify(e)})}var ts=(n,e)=>af(xx(n,e)),qt={start:()=>af(fetch("api/start")),check:n=>ts("check",{text:n}),change:(n,e)=>ts("change",{text:n,changes:e}),forecast:n=>ts("forecast",{text:n}),open:n=>ts("open",{name:n}),template:n=>ts("template",{name:n}),save:(n,e,t)=>ts("save",{name:n,text:e,known:t}),run:(n,e,t,i)=>ts("run",{analysis:n,options:e,text:t,file:i}),cancel:n=>ts("cancel",{number:n}),compare:(n,e)=>ts("differences",{first:n,second:e}),export:(n,e)=>vx(xx("product",{number:n,...e})),page:n=>vx(fetch(`api/jobs/${n}/page`)),remove:n=>ts("remove",{number:n}),design:(n,e)=>ts("opened",{number:n,point:e}),points:(n,e)=>af(fetch(`api/jobs/${n}/points/${e}`)),job:n=>af(fetch(`api/jobs/${n}`)),view:async n=>(await fetch(`api/jobs/${n}/view`)).arrayBuffer(),picture:(n,e)=>`api/jobs/${n}/pictures/${encodeURIComponent(e)}`},yI=2e3;function gm(n,e){let t=new WebSocket(`ws://${location.host}/api/live`);t.onopen=()=>e(!1),t.onmessage=i=>n(JSON.parse(String(i.data)).jobs),t.onclose=()=>{e(!0),setTimeout(()=>gm(n,e),yI)}}var xI=250,bI=800,SI=300,bt=De(""),ki=De({}),ws=De(!1),lf=De(null),qn=De([]),Ys=De([]),Oi=De(null),Ra=De([]),Ts=De(null),Ca=De(null),Aa=De([]),cf=De([]),lo=Wt(()=>bt.value!==(Ca.value??"")),Sx=Wt(()=>Aa.value.length>0),Mx=Wt(()=>cf.value.length>0),_m=0,uf="",vm=0,ym=-1/0,bx=Promise.resolve();function Jl(n){_m+=1,uf=n.text,ws.value=n.values===null&&bt.peek().trim()!=="",ws.value||(ki.value=n.values??{}),lf.value=n.plate,qn.value=n.problems,Ys.value=n.remarks}async function Nn(n){Ts.value=null;try{await n()}catch(e){if(!(e instanceof Pr))throw e;Ts.value=e.problem??e.message}}var wx=()=>({text:bt.peek(),values:uf===bt.peek()&&!ws.peek()?ki.peek():null});function Pa(n,e=!1){if(n===bt.peek())return;let t=performance.now();!(Aa.peek().length===0&&bt.peek()==="")&&!(e&&t-ym<bI)&&(Aa.value=[...Aa.peek(),wx()].slice(-SI)),ym=e?t:-1/0,cf.value=[],bt.value=n}function xm(n=xI){clearTimeout(vm),vm=window.setTimeout(()=>{Nn(Tx)},n)}async function Tx(){let n=_m+=1,e=bt.peek(),t=await qt.check(e);n===_m&&Jl({...t,text:e})}function hf(n){Pa(n,!0),xm()}function bm(n){Pa(n),xm(0)}var ns=(n,e)=>{Ia(()=>[{steps:n,value:e}])};function Ia(n){return bx=bx.then(()=>Nn(async()=>{for(;;){uf!==bt.peek()&&await Tx();let[e,t]=[bt.peek(),n()];if(t.length===0)return;let i=await qt.change(e,t);if(bt.peek()===e){Pa(i.text),clearTimeout(vm),Jl(i);return}}}))}function Ex(n,e){let t=n.peek().at(-1);t!==void 0&&(n.value=n.peek().slice(0,-1),e.value=[...e.peek(),wx()],ym=-1/0,bt.value=t.text,t.values!==null&&([ki.value,uf]=[t.values,t.text]),xm(0))}var La=()=>Ex(Aa,cf),Da=()=>Ex(cf,Aa),ff=n=>Nn(async()=>{let e=await qt.open(n);Pa(e.text),Oi.value=e.name,Ca.value=e.text,Jl(e)}),Ax=n=>Nn(async()=>{let e=await qt.template(n);Pa(e.text),Oi.value=null,Ca.value=null,Jl(e)});function Cx(n){bm(n),Oi.value=Ca.value=null}var Rx=(n,e)=>Nn(async()=>{let t=await qt.design(n,e);Pa(t.text),Jl(t)}),Px=n=>Nn(async()=>{let e=bt.peek(),t=await qt.save(n,e,n===Oi.peek()?Ca.peek():null);Oi.value=t.name,Ca.value=e,Ra.value=t.files});function Un(n){return n.reduce((e,t)=>typeof t=="number"?`${e}[${t+1}]`:e?`${e}.${t}`:t,"")}var df="completions",MI=14,Es=De(null),Ir=De(0),Ix=De([]),Lx=De(""),pf=Wt(()=>Es.value===null?{from:0,list:[]}:mx(bt.value,Es.value,Ix.value,Lx.value));function Dx(n,e){[Ix.value,Lx.value]=[n,e]}var mf=()=>Es.value=null;function Sm(n){Es.peek()!==null&&(Es.value=n.selectionStart,Ir.value=0)}function Nx(n,e){let{list:t}=pf.peek();if(n.key===" "&&n.ctrlKey)[Es.value,Ir.value]=[e.selectionStart,0];else{if(Es.peek()===null||t.length===0)return!1;if(n.key==="ArrowDown"||n.key==="ArrowUp")Ir.value=(Ir.peek()+(n.key==="ArrowDown"?1:t.length-1))%t.length;else if(n.key==="Enter"||n.key==="Tab")Ux(e,Ir.peek());else if(n.key==="Escape")mf();else return!1}return n.preventDefault(),!0}function Ux(n,e){let{from:t,list:i}=pf.peek(),s=i[e];s===void 0||Es.peek()===null||(n.setRangeText(s.insert,t,Es.peek(),"end"),mf(),hf(n.value),n.focus())}function Fx(){return{"aria-autocomplete":"list",...pf.value.list.length>0?{"aria-controls":df,"aria-activedescendant":`${df}-${Ir.value}`}:{}}}function Ox({area:n}){let{from:e,list:t}=pf.value,i=n.current;if(Es.value===null||i===null)return null;let s=bt.value.slice(0,e).split(`
`),r=i.scrollHeight/bt.value.split(`
`).length,o=i.offsetTop+s.length*r-i.scrollTop+6,a=parseFloat(getComputedStyle(document.documentElement).fontSize),c=i.getBoundingClientRect().top-i.offsetTop+o+MI*a<innerHeight?{top:`${o}px`}:{top:`${o-r-6}px`,transform:"translateY(-100%)"},u=`min(calc(${i.offsetLeft}px + ${(s.at(-1)??"").length}ch), max(0px, 100% - 22rem))`;return d("ul",{id:df,role:"listbox",tabIndex:0,"aria-label":"Completions",class:"completions",style:{...c,left:u},children:[t.length===0&&d("li",{role:"option","aria-selected":"false",class:"quiet",children:"Nothing fits here."}),t.map(({label:h,detail:f},p)=>d("li",{id:`${df}-${p}`,role:"option","aria-selected":p===Ir.value,ref:_=>{p===Ir.value&&_?.scrollIntoView({block:"nearest"})},onMouseDown:_=>{_.preventDefault(),Ux(i,p)},children:[d("code",{children:h})," ",d("span",{class:"quiet",children:f})]}))]})}var kx=[{keys:"Ctrl+Space",effect:"list of keys and values that fit at the cursor",actions:{}},{keys:"Ctrl+Z",effect:"undo",actions:{}},{keys:"Ctrl+Shift+Z",effect:"redo",actions:{}}];function Bx(){let n=Et(null),e=Et(null),t=new Set(qn.value.map(({line:o})=>o)),i=new Set(Ys.value.map(({line:o})=>o)),s=bt.value.split(`
`).length,r=o=>{n.current!==null&&o!==null&&wI(n.current,o)};return d("div",{class:"editor",children:[d("div",{class:"page",children:[d("ol",{ref:e,"aria-hidden":"true",children:Array.from({length:s},(o,a)=>d("li",{class:t.has(a+1)?"wrong":i.has(a+1)?"doubtful":"",children:a+1}))}),d("textarea",{ref:n,"aria-label":"Text of the study file, TOML","aria-invalid":qn.value.length>0,value:bt.value,wrap:"off",spellcheck:!1,autocapitalize:"off",autocomplete:"off",...Fx(),onInput:o=>{hf(o.currentTarget.value),Sm(o.currentTarget)},onSelect:o=>Sm(o.currentTarget),onBlur:mf,onScroll:o=>{e.current!==null&&(e.current.scrollTop=o.currentTarget.scrollTop)},onKeyDown:o=>{if(Nx(o,o.currentTarget)||!(o.ctrlKey||o.metaKey)||o.altKey)return;let a=o.key.toLowerCase(),l=a==="y"||a==="z"&&o.shiftKey?Da:a==="z"?La:null;l!==null&&(o.preventDefault(),l())}})]}),d(Ox,{area:n}),d("section",{"aria-label":"Problems","aria-live":"polite",class:"problems",children:[qn.value.length>0&&d("ul",{children:qn.value.map(o=>d("li",{children:d(jl,{problem:o,go:r})}))}),Ys.value.map(o=>d("p",{class:"doubt",children:[d(zx,{path:o.path,line:o.line,go:r}),": ",o.text]})),qn.value.length===0&&Ys.value.length===0&&bt.value!==""&&d("p",{class:"quiet",children:"The study has no problem."}),bt.value===""&&d("p",{children:"Choose a template or open a study above, or write here."})]})]})}function zx({path:n,line:e,go:t}){let i=e===null?n:`line ${e}${n?`, ${n}`:""}`;return e===null?d("b",{children:i}):d("button",{type:"button",class:"minor",onClick:()=>t(e),children:i})}function jl({problem:n,go:e=()=>{}}){return d("div",{class:"parts",children:[d("p",{children:[d(zx,{path:n.path||n.argument,line:n.line,go:e}),": got ",n.given]}),d("dl",{children:[d("dt",{children:"allowed"}),d("dd",{children:n.allowed}),d("dt",{children:"likely cause"}),d("dd",{children:n.cause}),d("dt",{children:"next step"}),d("dd",{children:n.next_step})]})]})}function wI(n,e){let t=n.value.split(`
`),i=t.slice(0,e-1).join(`
`).length+(e>1?1:0);n.focus(),n.setSelectionRange(i,i+(t[e-1]?.length??0));let s=n.scrollHeight/Math.max(t.length,1);n.scrollTop=Math.max(0,(e-4)*s)}var is=De([]),Mm=De(!1),mn=De(null),co=De(null),Vx=De(0),Gx=()=>is.value.find(n=>n.state==="running"),Hx=(n,e)=>n.seconds+Math.max(0,e-Vx.value)/1e3;function Wx(){gm(n=>{let e=n.at(-1);e&&mn.peek()===null&&(mn.value=e.number),Vx.value=performance.now(),is.value=n},n=>Mm.value=n),lt(()=>{let n=is.value.find(t=>t.number===mn.value);if(n===void 0||n.state==="running")return;let e=co.peek();e?.number===n.number&&e.state===n.state||Nn(async()=>{let t=await qt.job(n.number);mn.peek()===t.number&&(co.value=t)})})}var qx=(n,e)=>Nn(async()=>{let{number:t}=await qt.run(n,e,bt.peek(),Oi.peek());mn.value=t}),Xx=n=>Nn(async()=>{mn.peek()===n&&(mn.value=co.value=null),await qt.remove(n)}),$x=n=>Nn(async()=>{await qt.cancel(n)});function gf({table:n}){let e=n.count-n.rows.length;return d("div",{class:"wide",tabIndex:0,role:"group","aria-label":n.title,children:[d("table",{children:[d("caption",{children:n.title}),d("thead",{children:d("tr",{children:n.head.map(t=>d("th",{scope:"col",children:t}))})}),d("tbody",{children:[n.rows.length===0&&d("tr",{children:d("td",{colSpan:n.head.length,children:"none"})}),n.rows.map((t,i)=>d("tr",{class:n.strong.includes(i)?"strong":"",children:t.map((s,r)=>d("td",{class:n.numeric[r]?"number":"",children:s}))}))]})]}),e>0&&d("p",{class:"quiet",children:["and ",e," more rows, in the files of the command"]})]})}var Yx="folder ",TI="page ";function Kx({job:n,answer:e,exports:t}){let[i,s]=Ft(Yx),[r,o]=Ft(""),[a,l]=Ft(Object.keys(t.looks)[0]??""),[c,u]=Ft(!1),[h,f]=[i.slice(0,i.indexOf(" ")),i.slice(i.indexOf(" ")+1)],p=h==="picture"?t.pictures:h==="table"?t.tables:[],_=p.includes(r)?r:p[0]??"",b=()=>Nn(async()=>{u(!0);try{let m={kind:h,name:f,form:_,...h==="picture"?{style:a}:{}},x=await(h==="page"?qt.page(n.number):qt.export(n.number,m));jc(x.content,x.name)}finally{u(!1)}}),g=(m,x,A)=>A.length>0&&d("optgroup",{label:m,children:A.map(S=>d("option",{value:`${x} ${S}`,children:S}))});return d("div",{class:"row",role:"group","aria-label":"Save the result",children:[d("label",{children:["Save",d("select",{value:i,onChange:m=>s(m.currentTarget.value),children:[d("option",{value:Yx,children:"everything, as one zip"}),n.view&&d("option",{value:TI,children:"the interactive page, as one HTML file"}),g("Pictures","picture",e.pictures.map(m=>m.name)),g("Tables","table",e.tables.map(m=>m.title)),g("Files","file",e.files)]})]}),p.length>0&&d("label",{children:["Format",d("select",{value:_,onChange:m=>o(m.currentTarget.value),children:p.map(m=>d("option",{children:m}))})]}),h==="picture"&&d("label",{children:["Style",d("select",{value:a,onChange:m=>l(m.currentTarget.value),children:Object.entries(t.looks).map(([m,x])=>d("option",{value:m,children:x}))})]}),d("button",{type:"button",disabled:c,onClick:()=>{b()},children:c?"The file is made":"Save file"})]})}function Zx({exports:n}){let e=co.value;return e===null?null:d("section",{id:"result",class:"result","aria-label":`Result of ${e.analysis}`,children:[e.text!==bt.value&&d("p",{class:"notice",children:["This result belongs to another version of the study."," ",d("button",{type:"button",onClick:()=>bm(e.text),children:"Show that version"})]}),e.state==="cancelled"&&d("p",{children:["The computation of ",e.analysis," was cancelled."]}),e.error!==null&&d(wt,{children:[d("h2",{children:["No result of ",e.analysis]}),d(jl,{problem:{...e.error,path:e.error.argument,line:null}})]}),e.answer!==null&&d(EI,{job:e,answer:e.answer,exports:n},e.number)]})}function EI({job:n,answer:e,exports:t}){return d(wt,{children:[n.view?d(CI,{number:n.number}):d(AI,{answer:e}),e.remarks.map(i=>d("p",{class:"doubt",children:i})),d(Kx,{job:n,answer:e,exports:t}),d("dl",{class:"repeat",children:[d("dt",{children:"The same as a command"}),d("dd",{children:d("code",{children:n.command})}),d("dt",{children:"in Python"}),d("dd",{children:d("code",{children:n.python})})]}),e.tables.length>0&&d("details",{class:"section",open:!n.view,children:[d("summary",{children:"Tables"}),e.tables.map(i=>d(gf,{table:i}))]}),d(RI,{job:n,answer:e})]})}function AI({answer:n}){return d("header",{children:[d("h2",{children:n.title}),d("p",{class:"origin",children:n.origin}),n.summary.map(e=>d("p",{children:e}))]})}function CI({number:n}){let e=Et(null),[t,i]=Ft("");return Bt(()=>{let s=()=>{},r=!1;return qt.view(n).then(o=>{!r&&e.current!==null&&(s=px(Mc.read(o),e.current))},()=>i("The view cannot be loaded: the server does not answer.")),()=>{r=!0,s()}},[n]),d(wt,{children:[t&&d("p",{role:"alert",children:t}),d("div",{ref:e})]})}function RI({job:n,answer:e}){let t=is.value.find(({number:s})=>s===n.number)??n;if(e.pictures.length===0)return null;let i=e.pictures.filter(({name:s})=>t.pictures.includes(s));return d("details",{class:"section",open:!n.view,children:[d("summary",{children:"Pictures"}),d("div",{class:"pictures",children:i.map(({name:s,caption:r})=>d("figure",{children:[d("img",{src:qt.picture(n.number,s),alt:r||s,loading:"lazy"}),d("figcaption",{children:r})]},s))}),i.length<e.pictures.length&&d("p",{class:"quiet",children:t.drawn?`${e.pictures.length-i.length} pictures were left out, because another computation began.`:"Pictures are drawn."})]})}var uo=De(null),_f=De(null);function Jx(){lt(()=>{let[n,e]=[uo.value,mn.value],t=i=>is.value.some(s=>s.number===i&&s.state==="done");if(t(n)||(uo.value=null),n===e||!t(n)||!t(e)){_f.value=null;return}Nn(async()=>{let i=await qt.compare(n,e);uo.peek()===n&&mn.peek()===e&&(_f.value=i)})})}function jx(){if(_f.value===null)return null;let{runs:n,tables:e}=_f.value;return d("section",{class:"section","aria-labelledby":"comparison-title",children:[d("h2",{id:"comparison-title",children:n.map(({name:t})=>t).join(" and ")}),d("div",{class:"sides-by-side",children:n.map(({name:t,title:i,summary:s})=>d("div",{children:[d("h3",{children:[t," ",d("span",{class:"quiet",children:i})]}),s.map(r=>d("p",{children:r}))]}))}),e.map(t=>d(gf,{table:t})),d("p",{class:"quiet",children:"Bold differences exceed the sum of both errors. Equal numbers are left out."}),d("button",{type:"button",onClick:()=>uo.value=null,children:"Close the comparison"})]})}var wm={running:"is computed",done:"",failed:"failed",cancelled:"cancelled"};function Qx(){let n=[...is.value].reverse();return d(wt,{children:[d("p",{class:"hidden",role:"status",children:n[0]===void 0?"":`${n[0].analysis} ${wm[n[0].state]||"is finished"}`}),n.length>0&&d("details",{class:"section",children:[d("summary",{children:["Runs ",d("span",{class:"quiet",children:[n.length," in this folder"]})]}),d("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Runs",children:d("table",{children:[d("thead",{children:d("tr",{children:[d("th",{scope:"col",children:"run"}),d("th",{scope:"col",children:"study"}),d("th",{scope:"col",children:"file"}),d("th",{scope:"col",children:"begun"}),d("th",{scope:"col",children:"took"}),d("th",{scope:"col",colSpan:2,children:d("span",{class:"hidden",children:"compare and remove"})})]})}),d("tbody",{children:n.map(e=>d(PI,{job:e},e.number))})]})})]})]})}function PI({job:n}){let e=`${n.number}. ${n.analysis}`;return d("tr",{children:[d("td",{children:d("button",{type:"button",class:"minor","aria-pressed":mn.value===n.number,onClick:()=>mn.value=n.number,children:[e," ",wm[n.state]&&`(${wm[n.state]})`]})}),d("td",{class:"study-title",children:n.title||"-"}),d("td",{children:n.file}),d("td",{class:"number",children:II(n.started)}),d("td",{class:"number",children:n.state==="running"?"":`${Math.round(n.seconds)} s`}),d("td",{children:n.state==="done"&&n.number!==mn.value&&d("button",{type:"button",class:"minor","aria-pressed":uo.value===n.number,onClick:()=>uo.value=n.number,"aria-label":`Compare the shown run with ${e}`,children:"Compare"})}),d("td",{children:n.state!=="running"&&d("button",{type:"button",class:"minor",onClick:()=>{Xx(n.number)},"aria-label":`Remove ${e}`,children:"Remove"})})]})}var II=n=>new Date(1e3*n).toLocaleString([],{dateStyle:"short",timeStyle:"short"});function eb({analyses:n}){let[e,t]=Ft(n.find(({interactive:u})=>u)?.name??n[0]?.name??""),[i,s]=Ft({}),r=n.find(u=>u.name===e),o=Gx();if(r===void 0)return null;let a=qn.value.length>0||ws.value||bt.value.trim()==="",l=i[e]??{},c=(u,h)=>s({...i,[e]:{...l,[u]:h}});return d("section",{class:"compute","aria-labelledby":"compute-title",children:[d("h2",{id:"compute-title",children:"Compute"}),d("div",{class:"row",children:[d("label",{children:["Analysis",d("select",{value:e,onChange:u=>t(u.currentTarget.value),children:n.map(u=>d("option",{children:u.name}))})]}),d("button",{type:"button",class:"main",disabled:a,onClick:()=>{qx(e,l)},children:["Compute ",e]}),o!==void 0&&d("button",{type:"button",onClick:()=>{$x(o.number)},children:"Cancel"}),co.value!==null&&d("a",{href:"#result",children:"Go to the result"}),a&&d("span",{class:"quiet",children:"The study has problems, or is empty."})]}),d("p",{class:"quiet",children:r.help}),r.options.length>0&&d("div",{class:"fields",children:r.options.map(u=>d(LI,{option:u,value:l[u.name],set:h=>c(u.name,h)},`${e}-${u.name}`))}),o!==void 0&&d(NI,{job:o}),d(Qx,{})]})}function LI({option:n,value:e,set:t}){let i=`option-${n.name}`,s=n.name.replaceAll("_"," "),r={id:i,"aria-describedby":`${i}-help`},o=e??n.default??"";return d("div",{class:"field given",children:[n.form==="bool"?d("label",{class:"check",children:[d("input",{...r,type:"checkbox",checked:o===!0,onChange:a=>t(a.currentTarget.checked)}),s]}):d(wt,{children:[d("label",{for:i,children:[s,n.unit&&d("span",{class:"quiet",children:[" with unit, such as 1 ",n.unit]})]}),n.form==="choice"?d("select",{...r,value:String(o),onChange:a=>t(a.currentTarget.value),children:n.choices.map(a=>d("option",{children:a}))}):d("input",{...r,type:"text",inputMode:n.form==="int"||n.form==="float"?"decimal":"text",value:String(o),onChange:({currentTarget:{value:a}})=>t(n.form==="int"||n.form==="float"?DI(a):a)})]}),d("p",{id:`${i}-help`,class:"help",children:n.help})]})}var DI=n=>n.trim()===""||Number.isNaN(Number(n))?n:Number(n);function NI({job:n}){let[e,t]=Ft(performance.now());Bt(()=>{let a=setInterval(()=>t(performance.now()),1e3);return()=>clearInterval(a)},[]);let[i,s,r]=n.progress,o=s>0?{value:i,max:s}:{};return d("div",{class:"running",children:[d("progress",{...o,"aria-label":`Computing ${n.analysis}`}),d("p",{children:[`Computing ${n.analysis}${s>0?`: ${i} of ${s}`:""}${r&&` (${r})`}, `,Math.floor(Hx(n,e))," s."," ",d("span",{class:"quiet",children:n.cost})]})]})}function nb(n){let e=[],t=new Map;for(let i of n){let s=i.path.lastIndexOf("."),r={key:i,name:i.path.slice(s+1),inside:[]};t.set(i.path,r),((s<0?void 0:t.get(i.path.slice(0,s).replace(/\[\]$/,"")))?.inside??e).push(r)}return e}var vf=({key:n})=>["table","tables","entries"].includes(n.kind),tb=/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;function Ql(n,e){let t=e.trim().replace(/^"([^"]*)"$/,"$1");if(t==="")return null;switch(n.kind){case"integer":return Number.isSafeInteger(Number(t))&&/^[+-]?\d+$/.test(t)?Number(t):t;case"number":case"entries":return tb.test(t)&&!n.unit?Number(t):t;case"quantities":return t.split(",").map(i=>n.unit||!tb.test(i.trim())?i.trim():Number(i));case"text":return e;default:return t}}function ss(n){return n===void 0?"":Array.isArray(n)?n.map(ss).join(", "):typeof n=="object"?"":String(n)}function ib(n){return[n.help,n.kind==="quantities"?"Commas between the values.":"",n.example?`For example ${n.example}.`:"",n.bounds?`${n.bounds[0]?.toUpperCase()}${n.bounds.slice(1)}.`:"",n.typical?`Usual: ${n.typical}.`:""].filter(Boolean).join(" ")}function sb(){let n=Et(null),e=()=>{n.current?.open||n.current?.showModal()};return Bt(()=>{let t=[{keys:"?",effect:"this list",actions:{"?":e}}],i=s=>or(s,t);return document.addEventListener("keydown",i),()=>document.removeEventListener("keydown",i)},[]),d(wt,{children:[d("button",{type:"button",onClick:e,"aria-keyshortcuts":"?",children:"Keys"}),d("dialog",{ref:n,"aria-label":"Keys of the page",children:[Po.value.map(({title:t,keys:i})=>d(ld,{title:t,keys:i})),d("p",{class:"quiet",children:"Keys of a part work while it has the focus."}),d("button",{type:"button",onClick:()=>n.current?.close(),children:"Close"})]})]})}var Tm="#study=",Em=1e5,rb=1e6;async function UI(n){let e=new Blob([n]).stream().pipeThrough(new CompressionStream("deflate-raw")),t=new Uint8Array(await new Response(e).arrayBuffer()),i="";for(let r of t)i+=String.fromCharCode(r);let s=btoa(i).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}${Tm}${s}`}async function FI(n){if(n.length>Em)throw new Error(`it has more than ${Em} letters`);let e=Uint8Array.from(atob(n.replaceAll("-","+").replaceAll("_","/")),o=>o.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader(),i=new TextDecoder("utf-8",{fatal:!0}),[s,r]=["",0];for(;;){let{done:o,value:a}=await t.read();if(o)return s+i.decode();if(r+=a.length,r>rb)throw await t.cancel(),new Error(`the study in it has more than ${rb} bytes`);s+=i.decode(a,{stream:!0})}}async function Am(){if(!location.hash.startsWith(Tm))return;let n=location.hash.slice(Tm.length);history.replaceState(null,"",location.pathname);try{let e=await FI(n);if(e===bt.peek()||lo.peek()&&!confirm("The link has another study. Leave the text that is not saved? Undo brings it back."))return;Cx(e)}catch(e){Ts.value=OI(`${n.slice(0,40)}${n.length>40?"...":""}`,e)}}function OI(n,e){return{code:"malformed",argument:"link",given:n,allowed:'a link that "Copy link" has made',cause:e instanceof Error&&e.constructor===Error?e.message:"the link is damaged or incomplete",next_step:"copy the link again, or open the file of the study",path:"",line:null}}async function ob(){let n=await UI(bt.peek());if(n.length>Em)return"The study is too long for a link. Send its file.";try{return await navigator.clipboard.writeText(n),"The link is copied. It contains the whole study."}catch{return prompt("Copy this link. It contains the whole study.",n),""}}var Cm=".toml";function ab({start:n}){let[e,t]=Ft(null),[i,s]=Ft(""),r=e??Oi.value??"",o=()=>!lo.peek()||confirm("The study has changes that are not saved. Leave them? Undo brings them back.");return d("header",{class:"bar",children:[d("div",{class:"row",children:[d("h1",{children:"haptonic studio"}),d("label",{children:["New, from a template",d("select",{value:"",onChange:a=>{let l=a.currentTarget.value;a.currentTarget.value="",t(null),l&&o()&&Ax(l)},children:[d("option",{value:"",children:"choose"}),Object.entries(n.templates).map(([a,l])=>d("option",{value:a,title:l,children:a}))]})]}),d("label",{children:["Open, in ",n.folder,d("select",{value:Oi.value??"",onChange:a=>{let l=a.currentTarget.value;a.currentTarget.value=Oi.peek()??"",t(null),l&&o()&&ff(l)},children:[d("option",{value:"",children:Ra.value.length>0?"choose":"no study yet"}),Ra.value.map(a=>d("option",{children:a}))]})]}),d("form",{class:"row",onSubmit:a=>{a.preventDefault();let l=r.trim();l!==""&&(Px(l.endsWith(Cm)?l:`${l}${Cm}`),t(null))},children:[d("label",{children:["File name",d("input",{value:r,placeholder:`my${Cm}`,spellcheck:!1,autocomplete:"off",onInput:a=>t(a.currentTarget.value)})]}),d("button",{type:"submit",disabled:r.trim()==="",children:"Save"})]}),d("button",{type:"button",disabled:!Sx.value,onClick:La,children:"Undo"}),d("button",{type:"button",disabled:!Mx.value,onClick:Da,children:"Redo"}),d("button",{type:"button",disabled:bt.value==="",onClick:()=>{ob().then(s)},children:"Copy link"}),d(sb,{}),d("span",{class:"quiet",role:"status",children:i}),d("span",{class:"quiet",role:"status",children:lo.value?"not saved":Oi.value===null?"":"saved"})]}),Ts.value!==null&&d("div",{class:"notice",role:"alert",children:[typeof Ts.value=="string"?d("p",{children:Ts.value}):d(jl,{problem:Ts.value}),d("button",{type:"button",class:"minor",onClick:()=>Ts.value=null,children:"Close"})]})]})}function lb({branch:{key:n},steps:e,value:t}){let i=Un(e),s=qn.value.filter(c=>c.path===i||c.path.startsWith(`${i}[`)),r=Ys.value.filter(c=>c.path===i||c.path.startsWith(`${i}[`)),o=`key-${i}`,a={id:o,"aria-describedby":`${o}-about`,"aria-invalid":s.length>0,"aria-required":n.required},l=c=>{c!==ss(t)&&ns(e,Ql(n,c))};return d("div",{class:`field${s.length>0?" wrong":""}${t!==void 0?" given":""}`,children:[d("label",{for:o,children:[n.title,n.unit&&n.kind!=="quantities"&&d("span",{class:"quiet",children:" with unit"}),n.required&&t===void 0&&d("span",{class:"quiet",children:" (required)"})]}),n.kind==="boolean"?d("select",{...a,value:ss(t),onChange:c=>ns(e,BI(c.currentTarget.value)),children:[d("option",{value:"",children:[n.default," (default)"]}),d("option",{children:"true"}),d("option",{children:"false"})]}):n.closed?d("select",{...a,value:ss(t),onChange:c=>l(c.currentTarget.value),children:[d("option",{value:"",children:n.default?`${n.default} (default)`:"not given"}),n.names.map(c=>d("option",{children:c})),t!==void 0&&!n.names.includes(ss(t))&&d("option",{children:ss(t)})]}):d(zI,{...a,value:ss(t),lines:kI(t),set:l,placeholder:n.default,names:[...n.names,...n.numbers]}),d("div",{id:`${o}-about`,children:[s.map(c=>d("p",{class:"problem",children:[c.cause,"; ",c.next_step]})),r.map(c=>d("p",{class:"doubt",children:c.text})),d("p",{class:"help",children:[ib(n)," ",d("code",{children:i})]})]})]})}var kI=n=>typeof n=="string"&&n.includes(`
`)?Math.min(n.split(`
`).length+1,30):0,BI=n=>n===""?null:n==="true";function zI({value:n,lines:e,set:t,names:i,...s}){let[r,o]=Ft(null),a={...s,value:r??n,spellcheck:!1,autocomplete:"off",onInput:l=>o(l.currentTarget.value),onBlur:()=>{r!==null&&t(r),o(null)}};return e>0?d("textarea",{...a,rows:e,wrap:"off"}):d(wt,{children:[d("input",{...a,type:"text",list:i.length>0?`${s.id}-names`:void 0,onKeyDown:l=>{l.key==="Enter"&&r!==null&&t(r),l.key==="Escape"&&o(null)}}),i.length>0&&d("datalist",{id:`${s.id}-names`,children:i.map(l=>d("option",{value:l}))})]})}function cb({tree:n}){return d("div",{class:"form",children:[ws.value&&d("p",{class:"problem",role:"status",children:"The text has a mistake in its syntax. The form shows the last values until it is corrected."}),d("fieldset",{disabled:ws.value,children:[d("legend",{class:"hidden",children:"Keys of the study"}),d(Rm,{branches:n,steps:[],given:ki.value})]})]})}function Rm({branches:n,steps:e,given:t}){let i=n.filter(a=>!vf(a)),s=({name:a,key:l})=>e.length===0&&!l.required&&t[a]===void 0,r=n.filter(a=>vf(a)&&s(a)),o=a=>d(VI,{branch:a,steps:[...e,a.name],value:t[a.name]},a.key.path);return d(wt,{children:[i.length>0&&d("div",{class:"fields",children:i.map(a=>d(lb,{branch:a,steps:[...e,a.name],value:t[a.name]},a.key.path))}),n.filter(a=>vf(a)&&!s(a)).map(o),r.length>0&&d("details",{class:"further",children:[d("summary",{children:["Further tables ",d("span",{class:"quiet",children:"that the study does not have"})]}),r.map(o)]})]})}function VI({branch:n,steps:e,value:t}){let{key:i}=n,s=Un(e),r=qn.value.filter(u=>u.path===s||u.path.startsWith(`${s}.`)||u.path.startsWith(`${s}[`)),o=r.filter(u=>u.path===s),[a,l]=Ft(null),c=a??(i.required||e.length>1&&t!==void 0);return d("details",{class:"section",open:c,onToggle:({currentTarget:u})=>{u.open!==c&&l(u.open)},children:[d("summary",{children:[i.title,d("span",{class:"quiet",children:[" ",qI(t)]}),r.length>0&&d("span",{class:"problem",children:[" ",r.length," problem",r.length>1?"s":""]})]}),c&&d("div",{class:"inside",children:[d("p",{class:"quiet",children:[i.help," ",d("code",{children:i.kind==="tables"?`[[${s}]]`:`[${s}]`})]}),o.map(u=>d("p",{class:"problem",children:[u.cause,"; ",u.next_step]})),i.kind==="tables"?d(HI,{branch:n,steps:e,items:Array.isArray(t)?t:[]}):i.kind==="entries"?d(WI,{branch:n,steps:e,given:Im(t)}):d(GI,{branch:n,steps:e,value:t})]})]})}function GI({branch:n,steps:e,value:t}){let{key:i}=n,s=`key-${Un(e)}`,r=i.names.length>0,o=r&&(t===void 0||typeof t=="string");return d(wt,{children:[r&&d("div",{class:"field",children:[d("label",{for:s,children:[i.title,", by name"]}),d("select",{id:s,value:o?ss(t):`
`,onChange:a=>{let l=a.currentTarget.value;ns(e,l===""?null:l===`
`?{}:l)},children:[d("option",{value:"",children:"not given"}),i.names.map(a=>d("option",{children:a})),typeof t=="string"&&!i.names.includes(t)&&d("option",{children:t}),d("option",{value:`
`,children:"other, by its constants"})]})]}),!o&&d(Rm,{branches:n.inside,steps:e,given:Im(t)}),t!==void 0&&!i.required&&d(Pm,{steps:e,children:["Remove ",i.title.toLowerCase()]})]})}function HI({branch:n,steps:e,items:t}){let i=n.key.title.toLowerCase();return d(wt,{children:[t.map((s,r)=>d("fieldset",{class:"item",children:[d("legend",{children:[n.key.title," ",r+1]}),d(Rm,{branches:n.inside,steps:[...e,r],given:Im(s)}),d(Pm,{steps:[...e,r],children:["Remove ",i," ",r+1]})]},r)),d("button",{type:"button",onClick:()=>ns([...e,t.length],{}),children:["Add to ",i]})]})}function WI({branch:{key:n},steps:e,given:t}){let[i,s]=Ft(""),[r,o]=Ft(""),a=Un(e);return d(wt,{children:[d("ul",{class:"entries",children:Object.entries(t).map(([l,c])=>d("li",{children:[d("label",{for:`key-${a}.${l}`,children:l}),d("input",{id:`key-${a}.${l}`,value:ss(c),onChange:u=>ns([...e,l],Ql(n,u.currentTarget.value))}),d(Pm,{steps:[...e,l],children:["Remove ",l]})]},l))}),d("div",{class:"row",children:[d("label",{children:["Name",d("input",{value:i,onInput:l=>s(l.currentTarget.value)})]}),d("label",{children:["Value",d("input",{value:r,onInput:l=>o(l.currentTarget.value)})]}),d("button",{type:"button",disabled:i===""||r==="",onClick:()=>{ns([...e,i],Ql(n,r)),s(""),o("")},children:"Add a line"})]})]})}function Pm({steps:n,children:e}){return d("button",{type:"button",class:"minor",onClick:()=>ns(n,null),children:e})}function qI(n){return n===void 0?"":typeof n=="string"?n:Array.isArray(n)?`${n.length} in the study`:"in the study"}function Im(n){return typeof n=="object"&&!Array.isArray(n)?n:{}}var XI=["plate","map"],$I=["plate","rows"];function ub(n){let{map:e,rows:t}=n;if(typeof e!="string")return null;let i=e.trim().split(/\r?\n/).map(r=>Array.from(r.trim())),s=i[0]?.length??0;return s===0||i.some(r=>r.length!==s)?null:typeof t!="number"||t%i.length!==0||t<=0||t*s>1e5?i:Array.from({length:t},(r,o)=>i[o%i.length]??[])}function hb(n,e){let t=e.rows!==void 0,i=n.map(a=>a.join("")),s=t?YI(i):i.length,r=`${i.slice(0,s).join(`
`)}
`,o=s<i.length?i.length:null;return[...r.trim()===String(e.map).trim()?[]:[{steps:XI,value:r}],...t&&e.rows!==o?[{steps:$I,value:o}]:[]]}function YI(n){for(let e=1;e<=n.length/2;e++)if(n.length%e===0&&n.every((t,i)=>t===n[i%e]))return e;return n.length}function fb(n,e,t){let i=new Map;for(let[s,r]of e){let o=i.get(s)??n[s]?.slice();o===void 0||r<0||r>=o.length||(o[r]=t,i.set(s,o))}return n.map((s,r)=>i.get(r)??s)}function Lm([n,e],[t,i]){let s=Math.max(Math.abs(t-n),Math.abs(i-e));return Array.from({length:s+1},(r,o)=>{let a=s===0?0:o/s;return[Math.round(n+a*(t-n)),Math.round(e+a*(i-e))]})}function db([n,e],[t,i]){let s=[];for(let r=Math.min(n,t);r<=Math.max(n,t);r++)for(let o=Math.min(e,i);o<=Math.max(e,i);o++)s.push([r,o]);return s}function Dm(n,e){let t=n[e[0]]?.[e[1]],i=n.map(r=>r.map(()=>!1)),s=[];for(let r=[e];;){let o=r.pop();if(o===void 0)return s;let[a,l]=o,c=i[a];c===void 0||c[l]!==!1||n[a]?.[l]!==t||(c[l]=!0,s.push(o),r.push([a-1,l],[a+1,l],[a,l-1],[a,l+1]))}}function pb(n,e,t,i){let[s,r]=[n.length-1,(n[0]?.length??0)-1],o=t?[...e,...e.map(([a,l])=>[a,r-l])]:e;return i?[...o,...o.map(([a,l])=>[s-a,l])]:o}function mb(n,e,t){if(e==="above"||e==="below"){let i=e==="above";if(!t)return n.length===1?n:i?n.slice(1):n.slice(0,-1);let s=(i?n[0]:n.at(-1))??[];return i?[s,...n]:[...n,s]}return n.map(i=>{let s=e==="left";if(!t)return i.length===1?i:s?i.slice(1):i.slice(0,-1);let r=(s?i[0]:i.at(-1))??".";return s?[r,...i]:[...i,r]})}function Nm(n,e){let t=e.length>1?(e.at(-1)??1)/(e.length-1):1;return e.length===n+1?e:Array.from({length:n+1},(i,s)=>s*t)}var gb={m:1,cm:.01,mm:.001,um:1e-6,µm:1e-6,nm:1e-9},_b="mm",KI=50;function yb(n){let e=n/KI,t=10**Math.floor(Math.log10(e)+1e-9);return([5,2].find(i=>i*t<=e*(1+1e-9))??1)*t}function ec(n,e,t,i,s){let r=Math.round(n/i)*i,o=s,a=t.flatMap((l,c)=>[l,(l+(t[c+1]??l))/2]);for(let l of e>0?[0,-e,e]:[0])for(let c of a){let u=Math.abs(n+l-c);u<o&&([r,o]=[c-l,u])}return r}function yf(n,e){let t=/^\s*[-+.\deE]+\s*([a-zµ]+)\s*$/.exec(String(e??""))?.[1]??_b,[i,s]=t in gb?[t,gb[t]??.001]:[_b,.001];return`${Number((n/s).toPrecision(9))} ${i}`}function ZI(n,e){let t=n;for(let i of e)t=Array.isArray(t)?t[Number(i)]:t?.[String(i)];return t??{}}var vb=n=>Array.isArray(n)?n:[];function xb(n,e,t){let i=ZI(t,n.steps),[s,r]=[vb(i.centre),vb(i.size)],o=e.centre.map((c,u)=>yf(c-n.corner[u],s[u])),a=e.size.map((c,u)=>u<2?yf(c,r[u]):r[u]??""),l=(c,u)=>c.some((h,f)=>h!==u[f]);return[...l(o,s)?[{steps:[...n.steps,"centre"],value:o}]:[],...e.size.length>0&&l(a,r)?[{steps:[...n.steps,"size"],value:a}]:[]]}var Dr="plate.clamp.corners",on=De("brush"),ho=De(""),Um=De(!1),Fm=De(!1),rs=De([0,0]),os=De(null),Ks=De([]),ai=De(""),tc=De({}),nc=De(null),xf=De(null),bf=De([]),Lr=Wt(()=>{let n=ki.value.plate;return typeof n=="object"&&!Array.isArray(n)?n:null}),Bi=De(null);lt(()=>{(lf.value!==null||Lr.value===null)&&(Bi.value=lf.value)});var Sb=n=>typeof n=="object"&&!Array.isArray(n)?Object.entries(n):[],hi=Wt(()=>{let n=Sb(Lr.value?.tiles).map(([i,s])=>({letter:i,name:String(s),isNew:!1})),e=new Set(n.map(({letter:i})=>i)),t=bf.value.filter(({letter:i})=>!e.has(i)).map(i=>({...i,isNew:!0}));return[...n,...t,{letter:".",name:"no plate",isNew:!1}]}),Om=Wt(()=>Lr.value===null?null:ub(Lr.value)),Jn=Wt(()=>{let n=xf.value??Om.value;return n===null||Ks.value.length===0?n:fb(n,pb(n,Ks.value,Um.value,Fm.value),km())}),Zs=Wt(()=>(Bi.value?.parts??[]).map(n=>({...n,...tc.value[Un(n.steps)]}))),Js=Wt(()=>nc.value??Bi.value?.clamp??null),Mb=Wt(()=>xf.value!==null),km=()=>hi.value.some(({letter:n})=>n===ho.value)?ho.value:hi.value[0]?.letter??".";lt(()=>{Bi.value,tc.value={},nc.value=null});var bb=0;function ic(n){if(Ks.value=[],n===null)return;let e=bb+=1;xf.value=n;let t=new Set(n.flat());Ia(()=>[...bf.peek().filter(({letter:i})=>t.has(i)&&!JI(i)).map(({letter:i,name:s})=>({steps:["plate","tiles",i],value:s})),...hb(n,Lr.peek()??{})]).then(()=>{e===bb&&(xf.value=null)})}var JI=n=>Sb(Lr.peek()?.tiles).some(([e])=>e===n);function sc(n){Ks.value=n,ic(Jn.peek())}var jI="123456789abcdefghijklmnpqrstuvwxyzABCDEFGHIJKLMNPQRSTUVWXYZ";function wb(n){let e=new Set(hi.peek().map(({letter:i})=>i)),t=Array.from(jI).find(i=>!e.has(i));t!==void 0&&(bf.value=[...bf.peek(),{letter:t,name:n}],ho.value=t)}function Sf(n,e){tc.value={...tc.peek(),[Un(n.steps)]:e}}function Mf(n){let e=tc.peek()[Un(n.steps)];e!==void 0&&Ia(()=>xb(n,e,ki.peek()))}var po=12,wf=5,QI=5,eL=4,tL=.6,Eb=()=>({ink:$e("ink"),rim:$e("paper")});function Ab(n,e){let t=Bi.peek(),i=Nm(n[0]?.length??1,t?.x??[]),s=Nm(n.length,t?.y??[]),[r,o]=[i.at(-1)??1,s.at(-1)??1],a=Math.max(e-2*po,50);return{x:i,y:s,scale:Math.min(a/r,tL*innerHeight/o)}}var Cb=({x:n,y:e,scale:t})=>[(n.at(-1)??0)*t+2*po,(e.at(-1)??0)*t+2*po],Rb=({y:n,scale:e},[t,i])=>[(t-po)/e,(n.at(-1)??0)-(i-po)/e];function Tf({x:n,y:e},[t,i]){let s=n.findIndex(o=>o>t)-1,r=e.findIndex(o=>o>i)-1;return s<0||r<0?null:[e.length-2-r,s]}function Bm(n){let e=Bi.value?.lattices??[],i=hi.value.filter(({letter:s,name:r})=>s!=="."&&r!==e[0]).findIndex(s=>s.letter===n);return i<0?"rule":`curve-${i%eL}`}function zm({x:n,y:e},t){let[i,s]=[n.at(-1)??0,e.at(-1)??0],r=o=>[t,o-t];return[0,s].flatMap(o=>r(i).map(a=>[a,o])).concat([0,i].flatMap(o=>r(s).map(a=>[o,a])))}function Pb(n,e,t){let[i,s,r]=[n.getContext("2d"),Jn.peek(),Bi.peek()];if(i===null||s===null)return;let o=devicePixelRatio,a=e.y.at(-1)??0,l=([u,h])=>[o*(po+u*e.scale),o*(po+(a-h)*e.scale)];i.clearRect(0,0,n.width,n.height),nL(i,s,e,l),r!==null&&iL(i,r,s,e,l),sL(i,e,l);let c=[[t&&on.peek()!=="move"?rs.peek():null,"accent",[]],[os.peek(),"carrier",[3,3]]];for(let[u,h,f]of c)u!==null&&rL(i,u,e,l,h,f)}function Ib([n,e],{x:t,y:i}){let s=i.length-2-n;return[[t[e]??0,i[s+1]??0],[t[e+1]??0,i[s]??0]]}function nL(n,e,t,i){let s=new Map(hi.peek().map(({letter:c})=>[c,$e(Bm(c))]));n.save(),n.globalAlpha=.34,e.forEach((c,u)=>c.forEach((h,f)=>{if(h===".")return;let[[p,_],[b,g]]=Ib([u,f],t).map(i);n.fillStyle=s.get(h)??$e("carrier"),n.fillRect(p,_,b-p,g-_)}));let[r,o]=[t.x.length-1,t.y.length-1],[a,l]=[t.x.at(-1)??0,t.y.at(-1)??0];if(a/r*t.scale>=QI){n.globalAlpha=1,n.strokeStyle=$e("rule"),n.lineWidth=1,n.beginPath();let c=[...t.x.map(u=>[[u,0],[u,l]]),...t.y.map(u=>[[0,u],[a,u]])];for(let[u,h]of c)n.moveTo(...i(u)),n.lineTo(...i(h));n.stroke()}n.restore(),n.canvas.dataset.tiles=`${r} x ${o}`}function iL(n,e,t,i,s){let r=Om.peek();if(e.x.length!==i.x.length||e.y.length!==i.y.length)return;let o=a=>{let l=Tf(i,a);return l!==null&&t[l[0]]?.[l[1]]===r?.[l[0]]?.[l[1]]};n.strokeStyle=n.fillStyle=$e("quiet"),n.lineWidth=devicePixelRatio,nf(n,e.features,s,o),n.stroke(),n.strokeStyle=$e("ink");for(let a of e.plate)Ms(n,a,s);sf(n,e.held,s);for(let[a,l]of Object.entries(e.regions))Ta(n,a,l,s,Eb())}function sL(n,e,t){let i=on.peek()==="move";n.lineWidth=1.5*devicePixelRatio;for(let r of Zs.peek()){let[o=0,a=0]=r.diameter===null?r.size:[r.diameter,r.diameter],l=Rr(r.centre,[o,a]);if(n.save(),n.strokeStyle=$e("ink"),n.fillStyle=$e("gap"),n.beginPath(),r.diameter!==null||o===0){let f=Math.max((r.diameter??0)/2*e.scale,wf)*devicePixelRatio;n.arc(...t(r.centre),f,0,2*Math.PI)}else Kl(n,l,t);n.globalAlpha=r.diameter===null?.85:.3,n.fill(),n.globalAlpha=1,n.stroke(),n.restore();let[c,u]=t([r.centre[0],r.centre[1]]),h=o===0?-10:4;fm(n,r.name,[c,u+h*devicePixelRatio],Eb()),i&&Un(r.steps)===ai.peek()&&Tb(n,r.size.length>0?l:[r.centre],t)}let s=Js.peek();i&&s!==null&&ai.peek()===Dr&&Tb(n,zm(e,s),t)}function Tb(n,e,t){let i=wf*devicePixelRatio;n.fillStyle=$e("paper"),n.strokeStyle=$e("accent");for(let s of e){let[r,o]=t(s);n.fillRect(r-i,o-i,2*i,2*i),n.strokeRect(r-i,o-i,2*i,2*i)}}function rL(n,e,t,i,s,r){let[[o,a],[l,c]]=Ib(e,t).map(i);n.save(),n.strokeStyle=$e(s),n.lineWidth=2.5*devicePixelRatio,n.setLineDash(r.map(u=>u*devicePixelRatio)),n.strokeRect(o,a,l-o,c-a),n.restore()}var oL=800,Vm=n=>String(Number(n.toPrecision(3)));function Lb(){let[n,e]=[Jn.value,Bi.value];if(n===null)return null;let t=new Map;for(let r of n.flat())t.set(r,(t.get(r)??0)+1);let i=e!==null&&e.x.length===(n[0]?.length??0)+1&&e.y.length===n.length+1,s=Mb.value||qn.value.length>0;return d("div",{class:"facts",children:[d("dl",{children:[hi.value.filter(({letter:r})=>r!==".").map(({letter:r,name:o})=>d("div",{children:[d("dt",{children:o}),d("dd",{children:[t.get(r)??0," tiles"]})]})),d("div",{children:[d("dt",{children:"map"}),d("dd",{children:[n[0]?.length," x ",n.length," tiles"]})]}),e!==null&&i&&d(wt,{children:[d("div",{children:[d("dt",{children:"size"}),d("dd",{children:[Vm(1e3*(e.x.at(-1)??0))," x ",Vm(1e3*(e.y.at(-1)??0))," mm"]})]}),d("div",{children:[d("dt",{children:"contents"}),d("dd",{children:e.contents})]}),e.mass!==null&&d("div",{children:[d("dt",{children:"mass without patches"}),d("dd",{children:[Vm(1e3*e.mass)," g"]})]})]})]}),s&&d("p",{class:"quiet",children:"Size, contents and mass are those of the last map that could be built."}),!s&&e?.remarks.map(r=>d("p",{class:"doubt",children:r}))]})}function Db(){let[n,e]=Ft(null),t=Et(null),i=Et(!1),s=bt.value;Bt(()=>{let o=setTimeout(async()=>{if(t.current=s,!i.current){for(i.current=!0;t.current!==null;){let a=t.current;t.current=null;try{e({of:a,...await qt.forecast(a)})}catch{}}i.current=!1}},oL);return()=>clearTimeout(o)},[s]);let r=n===null||n.of!==s;return d("details",{open:!0,children:[d("summary",{children:["Estimated costs ",d("span",{class:"quiet",children:"as orders of magnitude"})]}),r?d("p",{class:"quiet",children:"Estimated again after a moment without changes."}):n.costs.length===0?d("p",{class:"quiet",children:"Not estimated, because the study has a problem."}):d("table",{children:[d("thead",{children:d("tr",{children:[d("th",{scope:"col",children:"command"}),d("th",{scope:"col",children:"processor time"}),d("th",{scope:"col",children:"memory"})]})}),d("tbody",{children:n.costs.map(({command:o,time:a,memory:l,refusal:c})=>d("tr",{children:[d("td",{children:["haptonic ",o]}),d("td",{children:c?`refused: ${c}`:a}),d("td",{children:c?"":l})]}))})]})]})}var Fb=6,Gm={b:"brush",l:"line",r:"rectangle",f:"fill",v:"move"},aL=10;function Ob(n,e){return on.peek()==="rectangle"?db(n,e):Lm(n,e)}function Ef({x:n}){return yb((n.at(-1)??1)/Math.max(n.length-1,1))}function kb(n,e){let t=null,i=()=>{},s=u=>{let h=n.getBoundingClientRect();return Rb(e(),[u.clientX-h.left,u.clientY-h.top])},c={pointerdown:u=>{if(u.button!==0)return;let h=s(u);on.peek()==="move"?[t,i]=cL(e(),h):[t,i]=lL(e(),h),t!==null&&n.setPointerCapture(u.pointerId)},pointermove:u=>t?.(s(u)),pointerup:()=>{t!==null&&i(),t=null},pointercancel:()=>{t=null,Ks.value=[]}};for(let[u,h]of Object.entries(c))n.addEventListener(u,h);return()=>{for(let[u,h]of Object.entries(c))n.removeEventListener(u,h)}}var Hm=[null,()=>{}];function lL(n,e){let[t,i]=[Tf(n,e),Jn.peek()];if(t===null||i===null)return Hm;if(rs.value=t,os.value=null,on.peek()==="fill")return sc(Dm(i,t)),Hm;let s=t;return Ks.value=[t],[o=>{let a=Tf(n,o);a===null||a[0]===s[0]&&a[1]===s[1]||(Ks.value=on.peek()==="brush"?[...Ks.peek(),...Lm(s,a)]:Ob(t,a),rs.value=s=a)},()=>ic(Jn.peek())]}function cL(n,e){let t=2*wf/n.scale,i=([h,f])=>Math.hypot(e[0]-h,e[1]-f)<t,s=Zs.peek(),r=s.find(h=>Un(h.steps)===ai.peek());if(r!==void 0&&r.size.length>0){let[h=0,f=0]=r.size,p=Rr(r.centre,[h,f]),_=p.findIndex(i),b=p[(_+2)%4];if(_>=0&&b!==void 0)return[g=>Sf(r,hL(r,b,g,n)),()=>Mf(r)]}let o=Js.peek();if(o!==null&&zm(n,o).some(i))return ai.value=Dr,[h=>Bb(fL(h,n),n),zb];let a=[...s].reverse().find(({centre:h,size:f,diameter:p})=>{let[_=0,b=0]=p===null?f:[p,p],[g,m]=[Math.abs(e[0]-h[0]),Math.abs(e[1]-h[1])];return g<Math.max(_/2,t)&&m<Math.max(b/2,t)});if(ai.value=a===void 0?"":Un(a.steps),a===void 0)return Hm;let[l,c]=[e[0]-a.centre[0],e[1]-a.centre[1]];return[([h,f])=>Sf(a,uL(a,[h-l,f-c],n)),()=>Mf(a)]}function uL(n,[e,t],i){let[s=0,r=0]=n.diameter===null?n.size:[n.diameter,n.diameter],[o,a]=[Ef(i),Fb/i.scale],l=[ec(e,s/2,i.x,o,a),ec(t,r/2,i.y,o,a)];return{...n,centre:l}}function hL(n,[e,t],[i,s],r){let[o,a]=[Ef(r),Fb/r.scale],[l,c]=[ec(i,0,r.x,o,a),ec(s,0,r.y,o,a)],u=[Math.max(Math.abs(l-e),o),Math.max(Math.abs(c-t),o)];return{...n,centre:[(e+l)/2,(t+c)/2],size:[...u,...n.size.slice(2)]}}function fL([n,e],t){let[i,s]=[t.x.at(-1)??0,t.y.at(-1)??0],[r,o]=[Math.min(n,i-n),Math.min(e,s-e)];return Math.max(r,o)}function Bb(n,e){let t=Ef(e);nc.value=Math.max(Math.round(n/t)*t,t)}function zb(){let n=nc.peek();if(n===null)return;let e=["plate","clamp","corners"];Ia(()=>{let t=ki.peek().plate;return[{steps:e,value:yf(n,t.clamp?.corners)}]})}function Nb(n,[e,t],i){let s=Ef(n);if(ai.peek()===Dr){Bb((Js.peek()??s)+(e+t)*s,n),zb();return}let r=Zs.peek().find(({steps:h})=>Un(h)===ai.peek());if(r===void 0)return;let[o,a]=r.centre,[l=0,c=0,...u]=r.size;i&&r.size.length===0||(Sf(r,i?{...r,size:[Math.max(l+e*s,s),Math.max(c+t*s,s),...u]}:{...r,centre:[o+e*s,a+t*s]}),Mf(r))}function dL(n,e){let t=Jn.peek();if(t===null)return;let[i,s]=rs.peek(),r=(o,a)=>Math.min(Math.max(o,0),a-1);rs.value=[r(i-e,t.length),r(s+n,t[0]?.length??1)]}function pL(){let[n,e,t]=[Jn.peek(),rs.peek(),os.peek()];n===null||on.peek()==="move"||(on.peek()==="fill"?sc(Dm(n,e)):on.peek()==="brush"?sc([e]):t===null?os.value=e:(os.value=null,sc(Ob(t,e))))}function Ub(n){let e=[...Zs.peek().map(({steps:s})=>Un(s)),...Bi.peek()?.clamp?[Dr]:[]],t=e.length,i=e.indexOf(ai.peek())+n;ai.value=e[(i%t+t)%t]??"",on.value="move"}function Vb(n){let e=(s,r)=>o=>{let a=o.shiftKey?aL:1;on.peek()!=="move"?dL(s*a,r*a):Nb(n(),[s*a,r*a],!1)},t=s=>()=>{let r=hi.peek()[s];r!==void 0&&(ho.value=r.letter)},i=(s,r)=>()=>{on.peek()==="move"&&Nb(n(),[s,r],!0)};return[{keys:"← → ↑ ↓",effect:"move the cursor, or the selected part; ten steps with Shift",actions:{ArrowLeft:e(-1,0),ArrowRight:e(1,0),ArrowUp:e(0,1),ArrowDown:e(0,-1)}},{keys:"space",effect:"paint; of a line or rectangle first one end, then the other",actions:{" ":pL}},{keys:"1 … 9",effect:"choose a tile, in the order of the palette",actions:Object.fromEntries(Array.from({length:9},(s,r)=>[String(r+1),t(r)]))},{keys:Object.keys(Gm).join(" "),effect:Object.values(Gm).join(", "),actions:Object.fromEntries(Object.entries(Gm).map(([s,r])=>[s,()=>on.value=r]))},{keys:"n p",effect:"select the next or the previous part",actions:{n:()=>Ub(1),p:()=>Ub(-1)}},{keys:"+ − > <",effect:"make the selected patch wider, narrower, higher or lower",actions:{"+":i(1,0),"-":i(-1,0),">":i(0,1),"<":i(0,-1)}},{keys:"Esc",effect:"forget the first end",actions:{Escape:()=>os.value=null}}]}var mL={brush:"Brush",line:"Line",rectangle:"Rectangle",fill:"Fill",move:"Move parts"},gL=["left","right","above","below"],_L={x:[0,1],y:[0,1],scale:1};function Gb({first:n}){return Object.keys(ki.value).length===0?null:Lr.value===null?d("p",{class:"paint",children:[d("button",{type:"button",class:"minor",disabled:ws.value,onClick:()=>ns(["plate"],n),children:"Begin a plate"})," ",d("span",{class:"quiet",children:"of this cell, and paint its map"})]}):d("details",{class:"section paint",open:!0,children:[d("summary",{children:["Map of the plate ",d("span",{class:"quiet",children:"painted with tiles; parts are dragged"})]}),Jn.value===null?d("p",{class:"problem",children:"The map can be painted when it has letters, and all its lines are equally long."}):d(vL,{})]})}function vL(){let n=Et(null),e=Et(_L),[t]=Ft(()=>Vb(()=>e.current));return Bt(()=>{let i=n.current;if(i===null)return;let s=()=>{let a=Jn.peek();if(a===null)return;e.current=Ab(a,i.parentElement?.clientWidth??300);let[l,c]=Cb(e.current),[u,h]=[l,c].map(f=>Math.round(f*devicePixelRatio));(i.width!==u||i.height!==h)&&([i.width,i.height]=[u??0,h??0],[i.style.width,i.style.height]=[`${l}px`,`${c}px`]),Pb(i,e.current,document.activeElement===i)},r=new ResizeObserver(s);i.parentElement!==null&&r.observe(i.parentElement),i.addEventListener("focus",s),i.addEventListener("blur",s);let o=[kb(i,()=>e.current),ms(s),lt(()=>{Jn.value,Zs.value,on.value,rs.value,os.value,ai.value,Js.value,hi.value,s()})];return()=>{r.disconnect();for(let a of o)a()}},[]),d("div",{class:"inside",children:[d(yL,{}),d(xL,{}),d("div",{class:"board",children:[d("canvas",{ref:n,tabIndex:0,role:"application","aria-label":"Map of the plate. Arrow keys move, the space bar paints, digits choose a tile.","aria-describedby":"paint-place",onKeyDown:i=>{(i.ctrlKey||i.metaKey)&&i.key.toLowerCase()==="z"?(i.preventDefault(),(i.shiftKey?Da:La)()):or(i,t)}}),d("div",{class:"beside",children:[d(bL,{}),d(Lb,{}),d(SL,{}),d(ML,{}),d(Db,{})]})]}),d("details",{children:[d("summary",{children:"Keys on the map"}),d("table",{children:d("tbody",{children:t.map(({keys:i,effect:s})=>d("tr",{children:[d("th",{scope:"row",children:d("kbd",{children:i})}),d("td",{children:s})]}))})})]})]})}function yL(){let[n,e]=Ft("");return d("div",{class:"row palette",role:"group","aria-label":"Tiles",children:[hi.value.map(({letter:t,name:i})=>d("button",{type:"button",class:"minor","aria-pressed":t===km()&&on.value!=="move",onClick:()=>{ho.value=t,on.peek()==="move"&&(on.value="brush")},children:[d("span",{class:"swatch",style:{background:t==="."?"none":`var(--${Bm(t)})`},"aria-hidden":"true"}),d("code",{children:t})," ",i]})),d("form",{class:"row",onSubmit:t=>{t.preventDefault(),wb(n.trim()),e("")},children:[d("input",{"aria-label":"Name of a new region or lattice",placeholder:"new tile",size:9,value:n,onInput:t=>e(t.currentTarget.value)}),d("button",{type:"submit",class:"minor",disabled:n.trim()==="",children:"Add"})]})]})}function xL(){let n=[{signal:Um,words:"mirror left and right"},{signal:Fm,words:"mirror top and bottom"}];return d("div",{class:"row",role:"group","aria-label":"Tools",children:[Object.entries(mL).map(([e,t])=>d("button",{type:"button",class:"minor","aria-pressed":on.value===e,onClick:()=>on.value=e,children:t})),n.map(({signal:e,words:t})=>d("label",{class:"check",children:[d("input",{type:"checkbox",checked:e.value,onChange:i=>e.value=i.currentTarget.checked}),t]}))]})}function bL(){let n=Zs.value.find(({steps:l})=>Un(l)===ai.value),e=l=>Number((1e3*l).toPrecision(6)),[t,i]=rs.value,s=Jn.value?.[t]?.[i],r=hi.value.find(l=>l.letter===s)?.name??"",o=n!==void 0&&n.size.length>0?`, ${n.size.slice(0,2).map(e).join(" x ")} mm`:"",a=on.value!=="move"?`Row ${t+1} from above, column ${i+1}: ${s??""} ${r}${os.value===null?"":"; the first end is chosen"}`:n!==void 0?`${n.name}: centre at ${n.centre.map(e).join(" and ")} mm on the plate${o}`:ai.value===Dr&&Js.value!==null?`Corners supported over ${e(Js.value)} mm`:"Select a part in the drawing, or with the key n.";return d("p",{id:"paint-place",class:"small","aria-live":"polite",children:a})}function SL(){let n=(e,t)=>{let i=Jn.peek();i!==null&&ic(mb(i,e,t))};return d("div",{class:"row",role:"group","aria-label":"Size of the map",children:gL.map(e=>d("span",{children:[e," ",d("button",{type:"button",class:"minor","aria-label":`Add a line ${e}`,onClick:()=>n(e,!0),children:"+"})," ",d("button",{type:"button",class:"minor","aria-label":`Remove a line ${e}`,onClick:()=>n(e,!1),children:"−"})]}))})}function ML(){let n=({path:e})=>e==="plate"||e.startsWith("plate.");return d("div",{"aria-live":"polite",children:[qn.value.filter(n).map(({path:e,cause:t,next_step:i})=>d("p",{class:"problem",children:[d("code",{children:e}),": ",t,"; ",i]})),Ys.value.filter(n).map(({path:e,text:t})=>d("p",{class:"doubt",children:[d("code",{children:e}),": ",t]}))]})}var Hb=`.paint .inside { padding-bottom: 0.6rem; }
.paint .row { align-items: center; }
.paint .row label.check { flex-direction: row; align-items: center; gap: 0.4rem; }
.paint .board { display: flex; flex-wrap: wrap; gap: 0.5rem 1rem; margin: 0.5rem 0; }
.paint .beside { flex: 1 1 9rem; min-width: 0; }
.paint table { font-size: 0.85rem; }
.paint th, .paint td { padding-right: 0.5rem; }
.paint .beside p { margin: 0 0 0.4rem; }
.paint canvas { display: block; max-width: 100%; touch-action: none; background: var(--paper); cursor: crosshair; }
.paint .swatch {
  display: inline-block; width: 0.9em; height: 0.9em; border: 1px solid var(--quiet); opacity: 0.6; vertical-align: -0.08em;
}
.paint details > summary { cursor: pointer; padding: 0.2rem 0; }
.paint .inside > details > summary { font-weight: normal; }
.paint .problem, .paint .doubt { margin: 0.3rem 0; overflow-wrap: anywhere; }
.palette button { max-width: 100%; overflow-wrap: anywhere; }
.palette form.row { margin: 0; }
`;var mo="order of computation",Wb="",an=De([]),Na=De(Wb),Rf=De(null),zi=De(null),Wm=null,Af=!1,Nr=Wt(()=>an.value.map((n,e)=>e).filter(n=>!Na.value||an.value[n]?.group===Na.value)),Pf=Wt(()=>[...new Set(an.value.map(n=>n.group))]),Cf=Wt(()=>{let n=Nr.value.map(e=>(an.value[e]?.varied??[]).map(({title:t})=>t));return[...new Set(n[0])].filter(e=>n.every(t=>t.includes(e)))}),Ua=Wt(()=>{let n=Rf.value;return n!==null&&(n===mo||Cf.value.includes(n))?n:Cf.value[0]??mo});function qb(){lt(()=>{let n=is.value.find(({number:e})=>e===mn.value);mn.value!==Wm&&(Wm=mn.value,an.value=[],zi.value=Rf.value=null,Na.value=Wb),n!==void 0&&n.points>an.value.length&&TL(n.number)})}async function TL(n){Af||(Af=!0,await Nn(async()=>{let e=an.peek().length,t=await qt.points(n,e);Af=!1,n===Wm&&e===an.peek().length&&(an.value=[...an.peek(),...t])}),Af=!1)}var rc=(n,e,t)=>t===mo?e+1:n.varied.find(i=>i.title===t)?.value??NaN,EL=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"]],AL=["Hz","m","Pa"];function If(n,e){let t=Math.max(...n.map(Math.abs),0);if(e==="rad")return{factor:180/Math.PI,unit:"deg"};let[i,s]=EL.find(([r])=>AL.includes(e)&&t>=r)??[1,""];return{factor:1/i,unit:s+e}}function Lf({value:n,unit:e,error:t},i){let s=If([n],e),r=n*s.factor;return`${i&&t!==null?ar(r,t*s.factor):String(Number(r.toPrecision(i?4:6)))} ${s.unit}`.trim()+(i&&t===null?" (preview)":"")}var CL=280,RL=3.5,PL=20,IL=4;function Df(){let n=Nr.value,e=Ua.value,t=n.flatMap(u=>an.value[u]?.results??[]),i=t[0]?.unit??"",s=[...new Set(t.filter(u=>u.unit===i).map(u=>u.title))],r=n.map(u=>rc(an.value[u],u,e)),o=an.value[n[0]??0]?.varied.find(u=>u.title===e)?.unit??"",a=e===mo?{factor:1,unit:""}:If(r,o),l=If(t.filter(u=>u.unit===i).map(({value:u})=>u),i);return{list:n.flatMap((u,h)=>(an.value[u]?.results??[]).filter(f=>f.unit===i).map(f=>({place:u,x:r[h]*a.factor,y:f.value*l.factor,error:f.error===null?null:f.error*l.factor,series:s.indexOf(f.title)}))),titles:s,x:a,y:l}}function Xb(n){let[e,t]=[Math.min(...n),Math.max(...n)];if(!Number.isFinite(e))return[0,1];let i=.06*(t-e)||Math.abs(t)*.05||1;return[e-i,t+i]}function $b(n){let e=Df(),t=()=>({width:hr(n),height:CL}),i={stroke:()=>$e("ink"),ticks:{stroke:()=>$e("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},s=(a,{unit:l})=>l?`${a} / ${l}`:a,r=()=>({x:Xb(e.list.map(a=>a.x)),y:Xb(e.list.flatMap(a=>[a.y-(a.error??0),a.y+(a.error??0)]))}),o=new nn({...t(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!1,y:!1}},scales:{x:{time:!1,range:()=>r().x},y:{range:()=>r().y}},axes:[{...i,label:" ",labelSize:22,size:34},{...i,label:" ",labelSize:24,size:58}],series:[{},{show:!0,stroke:"transparent",points:{show:!1}}],hooks:{draw:[a=>qo(a,()=>LL(a,e))]}},[[0,1],[0,1]],n);return Wo(o,(a,l)=>{let c=({x:h,y:f})=>Math.hypot(o.valToPos(h,"x")-a,o.valToPos(f,"y")-l),u=e.list.reduce((h,f)=>h&&c(h)<=c(f)?h:f,null);u!==null&&c(u)<PL&&(zi.value=u.place)}),fr(o,n,t,[lt(()=>{e=Df(),zi.value,o.axes[0].label=s(Ua.value,e.x),o.axes[1].label=s(e.titles.join(", "),e.y);let{x:a,y:l}=r();o.setData([a,l]),n.dataset.marks=String(e.list.length)})])}function LL(n,{list:e}){let{ctx:t}=n,i=RL*devicePixelRatio;t.lineWidth=1.5*devicePixelRatio;for(let{place:s,x:r,y:o,error:a,series:l}of e){let[c,u]=[n.valToPos(r,"x",!0),n.valToPos(o,"y",!0)];t.strokeStyle=t.fillStyle=$e(`curve-${l%IL}`),t.beginPath(),l%2?t.rect(c-i,u-i,2*i,2*i):t.arc(c,u,i,0,2*Math.PI),a===null||(t.fill(),t.beginPath(),t.moveTo(c,n.valToPos(o-a,"y",!0)),t.lineTo(c,n.valToPos(o+a,"y",!0))),t.stroke(),s===zi.peek()&&(t.strokeStyle=$e("ink"),t.beginPath(),t.arc(c,u,2.4*i,0,2*Math.PI),t.stroke())}}var qm=500;function Yb(n){let e=Ua.peek(),t=[...Nr.peek()].sort((s,r)=>rc(an.peek()[s],s,e)-rc(an.peek()[r],r,e)),i=zi.peek()===null?-1:t.indexOf(zi.peek());zi.value=t[Math.min(Math.max(i+n,0),t.length-1)]??null}var Xm=n=>{n!==null&&mn.peek()!==null&&Rx(mn.peek(),n)},$m=[{keys:"← →",effect:"previous or next design",actions:{ArrowLeft:()=>Yb(-1),ArrowRight:()=>Yb(1)}},{keys:"Enter",effect:"open the design in the text",actions:{Enter:()=>Xm(zi.peek())}}];function Kb(){let n=an.value.length;return n===0?null:d("details",{class:"section",open:!0,children:[d("summary",{children:["Computed designs ",d("span",{class:"quiet",children:n})]}),d("div",{class:"row",children:[Pf.value.length>1&&d("label",{children:["Part",d("select",{value:Na.value,onChange:e=>Na.value=e.currentTarget.value,children:[d("option",{value:"",children:"all"}),Pf.value.map(e=>d("option",{children:e}))]})]}),d("label",{children:["Horizontal axis",d("select",{value:Ua.value,onChange:e=>Rf.value=e.currentTarget.value,children:[...Cf.value,mo].map(e=>d("option",{children:e}))})]}),d(NL,{})]}),d("div",{class:"walk",tabIndex:0,role:"application","aria-label":"Computed designs. Arrow keys select a design, Enter opens it.","aria-describedby":"selected-design",onKeyDown:e=>or(e,$m),children:d(DL,{})}),d(UL,{}),d("details",{class:"further",children:[d("summary",{children:"Designs as a table"}),d(FL,{})]})]})}function DL(){let n=Et(null);return Bt(()=>n.current===null?void 0:$b(n.current),[]),d("div",{class:"curves",ref:n})}function NL(){let{list:n,titles:e}=Df();return d("span",{class:"quiet legend",children:[e.map((t,i)=>d("span",{class:"of-mark",style:{"--mark":`var(--curve-${i%4})`,"--round":i%2?"0":"50%"},children:t})),n.some(({error:t})=>t===null)&&d("span",{class:"of-preview",children:"hollow: preview, without an error"})]})}function UL(){let n=zi.value,e=n===null?void 0:an.value[n];if(e===void 0)return d("p",{id:"selected-design",class:"quiet",children:"Select a design with a click or the arrow keys."});let t=[...e.varied.map(i=>[i.title,Lf(i,!1)]),...e.results.map(i=>[i.title,Lf(i,!0)])];return d("div",{class:"facts",children:d("p",{id:"selected-design","aria-live":"polite",children:["Design ",n+1,Pf.value.length>1&&`, ${e.group}`,": ",t.map(([i,s])=>`${i} ${s}`).join(", "),e.results.length===0&&", no result","."," ",d("button",{type:"button",onClick:()=>Xm(n),children:"Open as a design"})]})})}function FL(){let n=Nr.value.slice(0,qm),e=r=>[...new Set(n.flatMap(o=>an.value[o][r].map(({title:a})=>a)))],[t,i]=[e("varied"),e("results")],s=(r,o,a)=>{let l=an.value[r][o].find(c=>c.title===a);return d("td",{class:"number",children:l===void 0?"-":Lf(l,o==="results")})};return d("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Computed designs",children:[d("table",{children:[d("thead",{children:d("tr",{children:[d("th",{scope:"col",children:"design"}),d("th",{scope:"col",children:"part"}),[...t,...i].map(r=>d("th",{scope:"col",children:r}))]})}),d("tbody",{children:n.map(r=>d("tr",{"aria-current":zi.value===r?"true":void 0,children:[d("td",{children:d("button",{type:"button",class:"minor",onClick:()=>Xm(r),children:["Open ",r+1]})}),d("td",{children:an.value[r].group}),t.map(o=>s(r,"varied",o)),i.map(o=>s(r,"results",o))]}))})]}),Nr.value.length>qm&&d("p",{class:"quiet",children:["and ",Nr.value.length-qm," more"]})]})}var Zb=`#studio { padding: 0.75rem 1rem; }
#studio h2 { font-size: 1.15rem; margin: 0 0 0.4rem; }
.quiet { color: var(--quiet); }
.help { font-size: 0.85rem; }
.hidden { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
.row { display: flex; flex-wrap: wrap; gap: 0.5rem 0.75rem; align-items: end; margin: 0.4rem 0; }
.row label { display: flex; flex-direction: column; min-width: 0; max-width: 100%; font-size: 0.85rem; color: var(--quiet); }
.row > .quiet { padding-bottom: 0.25rem; }
.bar { border-bottom: 1px solid var(--rule); padding-bottom: 0.5rem; }
.bar .row { margin: 0; }
.bar h1 { margin-right: 0.75rem; }
.bar form.row { margin: 0; }
.notice {
  border: 1px solid var(--carrier); border-radius: 0.4rem; padding: 0.5rem 0.75rem; margin: 0.5rem 0;
  overflow-wrap: anywhere;
}
.workbench { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr); margin-top: 0.75rem; }
.results { container-type: inline-size; }
/* on a wide screen the study and the results scroll beside each other, and nothing scrolls away from the other */
@media (min-width: 60rem) {
  #studio { display: flex; flex-direction: column; height: 100vh; box-sizing: border-box; padding-block: 0.5rem; }
  .workbench { flex: 1; min-height: 0; grid-template: minmax(0, 1fr) / minmax(22rem, 30rem) minmax(0, 1fr); }
  .study { display: flex; flex-direction: column; gap: 0.75rem; min-height: 0; }
  #form { flex: none; height: 55%; min-height: 8rem; max-height: calc(100% - 8rem); overflow: auto; resize: vertical; border-bottom: 1px solid var(--rule); }
  #text { flex: 1; min-height: 0; display: flex; flex-direction: column; }
  #form, .results { padding: 4px 0.5rem 4px 4px; }
  .results { overflow: auto; }
}
#studio fieldset { border: 0; margin: 0; padding: 0; min-width: 0; }
#studio fieldset.item { border: 1px solid var(--rule); border-radius: 0.4rem; padding: 0.25rem 0.75rem 0.6rem; margin: 0.5rem 0; }
.fields { display: grid; gap: 0.6rem 1rem; grid-template-columns: repeat(auto-fill, minmax(min(13rem, 100%), 1fr)); margin: 0.4rem 0; align-items: start; }
.field label { display: block; font-size: 0.9rem; overflow-wrap: anywhere; }
.field.given > label { font-weight: 600; }
.field.given > label .quiet { font-weight: normal; }
.field input:not([type="checkbox"]), .field select, .field textarea { width: 100%; box-sizing: border-box; }
.field textarea { font: 0.9rem/1.3 ui-monospace, monospace; }
.field:has(textarea) { grid-column: 1 / -1; }
.field.wrong :is(input, select, textarea) { border: 2px solid var(--carrier); }
.field p { margin: 0.2rem 0; overflow-wrap: anywhere; }
.field .help { display: none; color: var(--quiet); }
.field:focus-within .help { display: block; }
label.check { display: flex; gap: 0.4rem; align-items: center; }
#studio input:not([type="checkbox"]), #studio textarea {
  font: inherit; color: var(--ink); background: var(--panel); border: 1px solid var(--quiet); border-radius: 0.35rem;
  padding: 0.2rem 0.5rem; min-height: 1.9rem; box-sizing: border-box; max-width: 100%;
}
#studio select { max-width: 100%; min-height: 1.9rem; box-sizing: border-box; }
#studio :disabled { opacity: 0.6; cursor: default; }
#studio ::placeholder { color: var(--quiet); opacity: 1; }
#studio :is(textarea, summary, .wide, #form, .results):focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
button.minor { padding: 0 0.45rem; min-height: 1.6rem; font-size: 0.85rem; }
button.minor[aria-pressed="true"] { border: 2px solid var(--accent); font-weight: 600; }
button.main { background: var(--accent); color: var(--paper); border-color: var(--accent); }
.section { border: 1px solid var(--rule); border-radius: 0.4rem; margin: 0.5rem 0; padding: 0 0.75rem; }
.section summary { cursor: pointer; padding: 0.4rem 0; font-weight: 600; }
.section summary .quiet { font-weight: normal; }
.section .inside { padding-bottom: 0.6rem; }
.section .inside > p { margin: 0 0 0.3rem; font-size: 0.9rem; }
.further { margin: 0.75rem 0; }
.further > summary { cursor: pointer; padding: 0.4rem 0; }
.problem { color: var(--carrier); }
.doubt { color: var(--ink); border-left: 4px solid var(--gap); padding-left: 0.5rem; }
.entries { list-style: none; margin: 0; padding: 0; }
.entries li { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 2fr) auto; gap: 0.5rem; align-items: center; margin: 0.25rem 0; }
.entries label { overflow-wrap: anywhere; }
.editor .page {
  display: grid; grid-template-columns: auto minmax(0, 1fr); height: 20rem;
  border: 1px solid var(--quiet); border-radius: 0.4rem; overflow: hidden; font: 0.9rem/1.45 ui-monospace, monospace;
}
.editor ol { list-style: none; margin: 0; padding: 0.4rem 0; overflow: hidden; background: var(--panel); color: var(--quiet); text-align: right; }
.editor li { padding: 0 0.5rem; }
.editor ol .wrong { background: var(--carrier); color: var(--paper); font-weight: 700; }
.editor ol .doubtful { background: var(--gap); color: var(--ink); }
#studio .editor textarea {
  font: inherit; border: 0; border-radius: 0; background: var(--paper); padding: 0.4rem 0.6rem; resize: none; height: 100%;
  white-space: pre; overflow: auto;
}
#studio .editor textarea:focus-visible { outline-offset: -3px; }
@media (min-width: 60rem) {
  .editor { display: flex; flex-direction: column; min-height: 0; flex: 1; }
  .editor .page { flex: 1; min-height: 4rem; height: auto; }
  .problems { max-height: 40%; overflow: auto; flex: none; }
}
.problems ul { list-style: none; padding: 0; margin: 0.5rem 0; }
.problems li { border-left: 4px solid var(--carrier); padding-left: 0.6rem; margin: 0.5rem 0; }
.parts { overflow-wrap: anywhere; }
.parts p { margin: 0; }
.parts dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 0 0.75rem; margin: 0.2rem 0; font-size: 0.9rem; }
.parts dt { color: var(--quiet); }
.parts dd { margin: 0; }
.compute { border: 1px solid var(--rule); border-radius: 0.4rem; padding: 0.6rem 0.75rem; background: var(--panel); }
.compute :is(select, button, input) { background: var(--paper); }
.compute button.main { background: var(--accent); }
.compute > p { margin: 0.3rem 0; }
.running progress { width: 100%; accent-color: var(--accent); }
.running p { margin: 0.2rem 0; }
.result { margin-top: 1rem; }
.repeat { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 0.1rem 0.75rem; font-size: 0.9rem; }
.repeat dt { color: var(--quiet); }
.repeat dd { margin: 0; overflow-wrap: anywhere; }
@media (max-width: 30rem) { .repeat, .parts dl { grid-template-columns: minmax(0, 1fr); } }
.pictures { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(28rem, 100%), 1fr)); }
.pictures figure { margin: 0; }
.pictures img { width: 100%; background: #ffffff; border-radius: 0.3rem; }
.pictures figcaption { color: var(--quiet); font-size: 0.85rem; }
tr.strong td { font-weight: 600; }
td.number { white-space: nowrap; }
td.study-title { min-width: 8rem; overflow-wrap: anywhere; }
.legend .of-mark::before { width: 0.7em; height: 0.7em; background: var(--mark); border-radius: var(--round); }
.legend .of-preview::before { width: 0.6em; height: 0.6em; border: 2px solid var(--quiet); border-radius: 50%; }
.sides-by-side { display: grid; gap: 0.5rem 1.5rem; grid-template-columns: repeat(auto-fit, minmax(min(18rem, 100%), 1fr)); }
#studio h3 { font-size: 1rem; margin: 0.4rem 0 0; }
.sides-by-side p { margin: 0.2rem 0; }
section.section { padding-block: 0.5rem; }
.editor { position: relative; }
.completions {
  position: absolute; z-index: 2; margin: 0; padding: 0.2rem; list-style: none; max-height: 13rem; overflow: auto;
  min-width: min(14rem, 100%); max-width: min(32rem, 100%); box-sizing: border-box; background: var(--paper);
  border: 1px solid var(--quiet); border-radius: 0.35rem; font: 0.9rem/1.45 ui-monospace, monospace;
}
.completions .quiet { font-family: system-ui, sans-serif; }
.completions li { padding: 0.15rem 0.4rem; cursor: pointer; border: 1px solid transparent; border-radius: 0.25rem; }
.completions li[aria-selected="true"] { border-color: var(--accent); background: var(--panel); }
dialog { color: var(--ink); background: var(--paper); border: 1px solid var(--quiet); border-radius: 0.4rem; max-width: 40rem; }
`;function kL({start:n}){let e=nb(n.form);return d(wt,{children:[d(ab,{start:n}),d(BL,{}),d("main",{class:"workbench",children:[d("div",{class:"study",children:[d("section",{id:"form","aria-label":"Form",tabIndex:0,children:d(cb,{tree:e})}),d("section",{id:"text","aria-label":"Text",children:d(Bx,{})})]}),d("div",{class:"results",tabIndex:0,role:"group","aria-label":"Analyses and result",children:[d(eb,{analyses:n.analyses}),d(Gb,{first:n.plate}),d(jx,{}),d(Kb,{}),d(Zx,{exports:n.exports}),d("footer",{children:d("p",{children:["haptonic ",n.version]})})]})]})]})}function BL(){return Mm.value?d("p",{class:"notice",role:"alert",children:["The server of the studio does not answer. If it has ended, run ",d("code",{children:"haptonic studio"})," again and open its new link; copy a text that is not saved first."]}):null}async function zL(){pm();let n=document.createElement("style");n.textContent=Zb+Hb,document.head.append(n);let e=document.getElementById("studio");if(e===null)throw new Error("the page has no place for the studio");await Nn(async()=>{let t=await qt.start();Ra.value=t.files,Dx(t.form,t.expressions),el("Text of the study",kx),el("Computed designs",$m),Xa(d(kL,{start:t}),e),t.opened!==null&&await ff(t.opened),await Am(),Wx(),qb(),Jx()}),addEventListener("hashchange",()=>{Am()}),addEventListener("beforeunload",t=>{lo.peek()&&t.preventDefault()})}zL().catch(n=>{let e=document.createElement("p");e.textContent=`The studio cannot be shown: ${n instanceof Error?n.message:String(n)}`,document.body.replaceChildren(e)});
