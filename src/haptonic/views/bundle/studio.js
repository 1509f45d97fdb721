var MS=Object.create;var xg=Object.defineProperty;var wS=Object.getOwnPropertyDescriptor;var TS=Object.getOwnPropertyNames;var ES=Object.getPrototypeOf,AS=Object.prototype.hasOwnProperty;var CS=(n,e)=>()=>{try{return e||n((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var RS=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of TS(e))!AS.call(n,s)&&s!==t&&xg(n,s,{get:()=>e[s],enumerable:!(i=wS(e,s))||i.enumerable});return n};var PS=(n,e,t)=>(t=n!=null?MS(ES(n)):{},RS(e||!n||!n.__esModule?xg(t,"default",{value:n,enumerable:!0}):t,n));var Y_=CS($d=>{var B_=Object.defineProperty,c1=n=>B_(n,"__esModule",{value:!0}),u1=(n,e)=>{for(var t in e)B_(n,t,{get:e[t],enumerable:!0})};c1($d);u1($d,{GIFEncoder:()=>X_,applyPalette:()=>y1,default:()=>R1,nearestColor:()=>M1,nearestColorIndex:()=>W_,nearestColorIndexWithDistance:()=>q_,prequantize:()=>v1,quantize:()=>g1,snapColorsToPalette:()=>S1});var h1={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};function z_(n=256){let e=0,t=new Uint8Array(n);return{get buffer(){return t.buffer},reset(){e=0},bytesView(){return t.subarray(0,e)},bytes(){return t.slice(0,e)},writeByte(s){i(e+1),t[e]=s,e++},writeBytes(s,r=0,o=s.length){i(e+o);for(let a=0;a<o;a++)t[e++]=s[a+r]},writeBytesView(s,r=0,o=s.byteLength){i(e+o),t.set(s.subarray(r,r+o),e),e+=o}};function i(s){var r=t.length;if(r>=s)return;var o=1024*1024;s=Math.max(s,r*(r<o?2:1.125)>>>0),r!=0&&(s=Math.max(s,256));let a=t;t=new Uint8Array(s),e>0&&t.set(a.subarray(0,e),0)}}var Wd=12,F_=5003,f1=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function d1(n,e,t,i,s=z_(512),r=new Uint8Array(256),o=new Int32Array(F_),a=new Int32Array(F_)){let l=o.length,c=Math.max(2,i);r.fill(0),a.fill(0),o.fill(-1);let u=0,h=0,d=c+1,p=d,_=!1,x=p,g=(1<<x)-1,m=1<<d-1,b=m+1,A=m+2,S=0,P=t[0],C=0;for(let k=l;k<65536;k*=2)++C;C=8-C,s.writeByte(c),E(m);let v=t.length;for(let k=1;k<v;k++)e:{let N=t[k],L=(N<<Wd)+P,B=N<<C^P;if(o[B]===L){P=a[B];break e}let V=B===0?1:l-B;for(;o[B]>=0;)if(B-=V,B<0&&(B+=l),o[B]===L){P=a[B];break e}E(P),P=N,A<1<<Wd?(a[B]=A++,o[B]=L):(o.fill(-1),A=m+2,_=!0,E(m))}return E(P),E(b),s.writeByte(0),s.bytesView();function E(k){for(u&=f1[h],h>0?u|=k<<h:u=k,h+=x;h>=8;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,h-=8;if((A>g||_)&&(_?(x=p,g=(1<<x)-1,_=!1):(++x,g=x===Wd?1<<x:(1<<x)-1)),k==b){for(;h>0;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,h-=8;S>0&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0)}}}var p1=d1;function V_(n,e,t){return n<<8&63488|e<<2&992|t>>3}function G_(n,e,t,i){return n>>4|e&240|(t&240)<<4|(i&240)<<8}function H_(n,e,t){return n>>4<<8|e&240|t>>4}function Zc(n,e,t){return n<e?e:n>t?t:n}function dl(n){return n*n}function O_(n,e,t){var i=0,s=1e100;let r=n[e],o=r.cnt,a=r.ac,l=r.rc,c=r.gc,u=r.bc;for(var h=r.fw;h!=0;h=n[h].fw){let p=n[h],_=p.cnt,x=o*_/(o+_);if(!(x>=s)){var d=0;t&&(d+=x*dl(p.ac-a),d>=s)||(d+=x*dl(p.rc-l),!(d>=s)&&(d+=x*dl(p.gc-c),!(d>=s)&&(d+=x*dl(p.bc-u),!(d>=s)&&(s=d,i=h))))}}r.err=s,r.nn=i}function qd(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function m1(n,e){let t=e==="rgb444"?4096:65536,i=new Array(t),s=n.length;if(e==="rgba4444")for(let r=0;r<s;++r){let o=n[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255,h=G_(u,c,l,a),d=h in i?i[h]:i[h]=qd();d.rc+=u,d.gc+=c,d.bc+=l,d.ac+=a,d.cnt++}else if(e==="rgb444")for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=H_(c,l,a),h=u in i?i[u]:i[u]=qd();h.rc+=c,h.gc+=l,h.bc+=a,h.cnt++}else for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=V_(c,l,a),h=u in i?i[u]:i[u]=qd();h.rc+=c,h.gc+=l,h.bc+=a,h.cnt++}return i}function g1(n,e,t={}){let{format:i="rgb565",clearAlpha:s=!0,clearAlphaColor:r=0,clearAlphaThreshold:o=0,oneBitAlpha:a=!1}=t;if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(n.buffer),c=t.useSqrt!==!1,u=i==="rgba4444",h=m1(l,i),d=h.length,p=d-1,_=new Uint32Array(d+1);for(var x=0,m=0;m<d;++m){let H=h[m];if(H!=null){var g=1/H.cnt;u&&(H.ac*=g),H.rc*=g,H.gc*=g,H.bc*=g,h[x++]=H}}dl(e)/x<.022&&(c=!1);for(var m=0;m<x-1;++m)h[m].fw=m+1,h[m+1].bk=m,c&&(h[m].cnt=Math.sqrt(h[m].cnt));c&&(h[m].cnt=Math.sqrt(h[m].cnt));var b,A,S;for(m=0;m<x;++m){O_(h,m,!1);var P=h[m].err;for(A=++_[0];A>1&&(S=A>>1,!(h[b=_[S]].err<=P));A=S)_[A]=b;_[A]=m}var C=x-e;for(m=0;m<C;){for(var v;;){var E=_[1];if(v=h[E],v.tm>=v.mtm&&h[v.nn].mtm<=v.tm)break;v.mtm==p?E=_[1]=_[_[0]--]:(O_(h,E,!1),v.tm=m);var P=h[E].err;for(A=1;(S=A+A)<=_[0]&&(S<_[0]&&h[_[S]].err>h[_[S+1]].err&&S++,!(P<=h[b=_[S]].err));A=S)_[A]=b;_[A]=E}var k=h[v.nn],N=v.cnt,L=k.cnt,g=1/(N+L);u&&(v.ac=g*(N*v.ac+L*k.ac)),v.rc=g*(N*v.rc+L*k.rc),v.gc=g*(N*v.gc+L*k.gc),v.bc=g*(N*v.bc+L*k.bc),v.cnt+=k.cnt,v.mtm=++m,h[k.bk].fw=k.fw,h[k.fw].bk=k.bk,k.mtm=p}let B=[];var V=0;for(m=0;;++V){let U=Zc(Math.round(h[m].rc),0,255),H=Zc(Math.round(h[m].gc),0,255),Y=Zc(Math.round(h[m].bc),0,255),G=255;u&&(G=Zc(Math.round(h[m].ac),0,255),a&&(G=G<=(typeof a=="number"?a:127)?0:255),s&&G<=o&&(U=H=Y=r,G=0));let le=u?[U,H,Y,G]:[U,H,Y];if(_1(B,le)||B.push(le),(m=h[m].fw)==0)break}return B}function _1(n,e){for(let t=0;t<n.length;t++){let i=n[t],s=i[0]===e[0]&&i[1]===e[1]&&i[2]===e[2],r=i.length>=4&&e.length>=4?i[3]===e[3]:!0;if(s&&r)return!0}return!1}function jc(n,e){var t=0,i;for(i=0;i<n.length;i++){let s=n[i]-e[i];t+=s*s}return t}function Jc(n,e){return e>1?Math.round(n/e)*e:n}function v1(n,{roundRGB:e=5,roundAlpha:t=10,oneBitAlpha:i=null}={}){let s=new Uint32Array(n.buffer);for(let r=0;r<s.length;r++){let o=s[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255;a=Jc(a,t),i&&(a=a<=(typeof i=="number"?i:127)?0:255),u=Jc(u,e),c=Jc(c,e),l=Jc(l,e),s[r]=a<<24|l<<16|c<<8|u<<0}}function y1(n,e,t="rgb565"){if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let i=new Uint32Array(n.buffer),s=i.length,r=t==="rgb444"?4096:65536,o=new Uint8Array(s),a=new Array(r),l=t==="rgba4444";if(t==="rgba4444")for(let c=0;c<s;c++){let u=i[c],h=u>>24&255,d=u>>16&255,p=u>>8&255,_=u&255,x=G_(_,p,d,h),g=x in a?a[x]:a[x]=x1(_,p,d,h,e);o[c]=g}else{let c=t==="rgb444"?H_:V_;for(let u=0;u<s;u++){let h=i[u],d=h>>16&255,p=h>>8&255,_=h&255,x=c(_,p,d),g=x in a?a[x]:a[x]=b1(_,p,d,e);o[u]=g}}return o}function x1(n,e,t,i,s){let r=0,o=1e100;for(let a=0;a<s.length;a++){let l=s[a],c=l[3],u=jr(c-i);if(u>o)continue;let h=l[0];if(u+=jr(h-n),u>o)continue;let d=l[1];if(u+=jr(d-e),u>o)continue;let p=l[2];u+=jr(p-t),!(u>o)&&(o=u,r=a)}return r}function b1(n,e,t,i){let s=0,r=1e100;for(let o=0;o<i.length;o++){let a=i[o],l=a[0],c=jr(l-n);if(c>r)continue;let u=a[1];if(c+=jr(u-e),c>r)continue;let h=a[2];c+=jr(h-t),!(c>r)&&(r=c,s=o)}return s}function S1(n,e,t=5){if(!n.length||!e.length)return;let i=n.map(o=>o.slice(0,3)),s=t*t,r=n[0].length;for(let o=0;o<e.length;o++){let a=e[o];a.length<r?a=[a[0],a[1],a[2],255]:a.length>r?a=a.slice(0,3):a=a.slice();let l=q_(i,a.slice(0,3),jc),c=l[0],u=l[1];u>0&&u<=s&&(n[c]=a)}}function jr(n){return n*n}function W_(n,e,t=jc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return s}function q_(n,e,t=jc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return[s,i]}function M1(n,e,t=jc){return n[W_(n,e,t)]}function X_(n={}){let{initialCapacity:e=4096,auto:t=!0}=n,i=z_(e),s=5003,r=new Uint8Array(256),o=new Int32Array(s),a=new Int32Array(s),l=!1;return{reset(){i.reset(),l=!1},finish(){i.writeByte(h1.trailer)},bytes(){return i.bytes()},bytesView(){return i.bytesView()},get buffer(){return i.buffer},get stream(){return i},writeHeader:c,writeFrame(u,h,d,p={}){let{transparent:_=!1,transparentIndex:x=0,delay:g=0,palette:m=null,repeat:b=0,colorDepth:A=8,dispose:S=-1}=p,P=!1;if(t?l||(P=!0,c(),l=!0):P=!!p.first,h=Math.max(0,Math.floor(h)),d=Math.max(0,Math.floor(d)),P){if(!m)throw new Error("First frame must include a { palette } option");T1(i,h,d,m,A),k_(i,m),b>=0&&E1(i,b)}let C=Math.round(g/10);w1(i,S,C,_,x);let v=!!m&&!P;A1(i,h,d,v?m:null),v&&k_(i,m),C1(i,u,h,d,A,r,o,a)}};function c(){$_(i,"GIF89a")}}function w1(n,e,t,i,s){n.writeByte(33),n.writeByte(249),n.writeByte(4),s<0&&(s=0,i=!1);var r,o;i?(r=1,o=2):(r=0,o=0),e>=0&&(o=e&7),o<<=2,n.writeByte(0|o|0|r),vr(n,t),n.writeByte(s||0),n.writeByte(0)}function T1(n,e,t,i,s=8){let a=Xd(i.length)-1,l=128|s-1<<4|0|a,c=0,u=0;vr(n,e),vr(n,t),n.writeBytes([l,c,u])}function E1(n,e){n.writeByte(33),n.writeByte(255),n.writeByte(11),$_(n,"NETSCAPE2.0"),n.writeByte(3),n.writeByte(1),vr(n,e),n.writeByte(0)}function k_(n,e){let t=1<<Xd(e.length);for(let i=0;i<t;i++){let s=[0,0,0];i<e.length&&(s=e[i]),n.writeByte(s[0]),n.writeByte(s[1]),n.writeByte(s[2])}}function A1(n,e,t,i){if(n.writeByte(44),vr(n,0),vr(n,0),vr(n,e),vr(n,t),i){let o=Xd(i.length)-1;n.writeByte(128|o)}else n.writeByte(0)}function C1(n,e,t,i,s=8,r,o,a){p1(t,i,e,s,n,r,o,a)}function vr(n,e){n.writeByte(e&255),n.writeByte(e>>8&255)}function $_(n,e){for(var t=0;t<e.length;t++)n.writeByte(e.charCodeAt(t))}function Xd(n){return Math.max(Math.ceil(Math.log2(n)),1)}var R1=X_});var wt,Mg,Zf,cr,Yf,_c,wg,mc,Tg,Jf,Kf,IS,Ka=Symbol.for("pv"),vc={},yc=[],LS=/^m(i|n|o|s|text|space)$/,jf=Array.isArray,Qf=yc.slice,Wr=Object.assign;function Hr(n){n&&n.parentNode&&n.remove()}function Eg(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Qf.call(arguments,2):t),Ya(n,o,i,s,null)}function Ya(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Ka,__v:s||++Mg,__i:-1,__u:0};return!s&&wt.vnode&&wt.vnode(r),r}function Tt(n){return n.children}function Lo(n,e){this.props=n,this.context=e,this.__g=0}function ur(n,e){if(e==null)return n.__&&ur(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:ur(n)}function DS(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Wr({constructor:Ka},t)).__v=t.__v+1,wt.vnode&&wt.vnode(e),ed(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||ur(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Lg(s,e,r),t.__=t.__e=null,e.__e!=i&&Ag(e))}function Ag(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Ag(n)}function bg(n){(8&n.__g||(n.__g|=8,cr.push(n),_c++))&&Yf==wt.debounceRendering||((Yf=wt.debounceRendering)||queueMicrotask)(Cg)}function Cg(){try{for(var n,e=1;cr.length;)cr.length>e&&cr.sort(wg),n=cr.shift(),e=cr.length,8&n.__g&&DS(n)}finally{(_c=cr.length)&&(Yf||queueMicrotask)(Cg)}}function Rg(n,e,t,i,s,r,o,a,l,c,u){var h,d,p,_,x,g,m=i.__k||yc,b=e.length;for(l=NS(t,e,m,l,b),h=0;h<b;h++)(p=t.__k[h])!=null&&(d=~p.__i&&m[p.__i]||vc,p.__i=h,g=ed(n,p,d,s,r,o,a,l,c,u),_=p.__e,(d.ref!=p.ref||8&d.__u)&&(d.ref&&td(d.ref,null,p,d),p.ref&&u.push(p.ref,p.__c||_,p)),x=x||_,4&p.__u?(l=Pg(p,l,n,!d.__v),d.__e&&(d.__e=null)):typeof p.type=="function"&&g!==void 0?l=g:_&&(l=_.nextSibling),p.__u&=-21);return t.__e=x,l}function NS(n,e,t,i,s){var r,o,a,l,c,u,h,d,p,_=t.length,x=_,g=0,m=0,b=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=b[r]=Ya(null,o):jf(o)?o=b[r]=Ya(Tt,{children:o}):o.constructor===Ka&&o.__b?o=b[r]=Ya(o.type,o.props,o.key,o.ref,o.__v):b[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=US(o,t,l,x))&&(x--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,m=1)):(~c||(s>_?g--:s<_&&g++),typeof o.type!="function"&&(o.__u|=4))):b[r]=null;if(m){for(u=[],h=[],r=0;r<s;r++)if((o=b[r])&&16&o.__u){for(g=0,d=u.length;g<d;)u[p=g+d>>1]<o.__i?g=p+1:d=p;u[g]=o.__i,h[r]=g+1}for(g=u.length;r--;)h[r]&&(h[r]==g?g--:b[r].__u|=4)}if(x)for(r=0;r<_;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=ur(a)),nd(a,a));return i}function Pg(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Pg(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=ur(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function US(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Sg(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function pc(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Sg(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Sg(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Kf[e]||(Kf[e]=FS(e)),(n.__a||(n.__a={}))[e]=Jf,r=e!=(e=e.replace(Tg,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function FS(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[mc]==null)e[mc]=Jf++;else if(e[mc]<this.__a[n])return;return t(wt.event?wt.event(e):e)}}}function ed(n,e,t,i,s,r,o,a,l,c){var u,h,d,p,_,x,g,m,b,A,S,P,C,v,E,k,N,L,B=e.type;if(e.constructor!==Ka)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=gc(u,r):r.push(u),a=r[0]||a),(u=wt.__b)&&u(e);e:if(typeof B=="function"){d=o.length;try{if(m=e.props,b=(u=B.prototype)&&u.render,A=(u=B.contextType)&&i[u.__c],S=u?A?A.props.value:u.__:i,(p=t.__c)?(e.__c=p,2&p.__g&&(p.__g|=1)):(b?e.__c=p=new B(m,S):(e.__c=p=new Lo(m,S),p.constructor=B,p.render=kS),A&&A.sub(p),p.state||(p.state={}),p.__n=i,p.__g|=8,p.__h=[],p.__k=[]),b&&(p.__s||(p.__s=p.state),B.getDerivedStateFromProps&&(p.__s==p.state&&(p.__s=Wr({},p.__s)),Wr(p.__s,B.getDerivedStateFromProps(m,p.__s)))),_=p.props,x=p.state,p.__v=e,t.__c){if(m!==_&&b&&!B.getDerivedStateFromProps&&p.componentWillReceiveProps&&p.componentWillReceiveProps(m,S),e.__v==t.__v&&!(8&p.__g)||!(4&p.__g)&&p.shouldComponentUpdate&&p.shouldComponentUpdate(m,p.__s,S)===!1){e.__v!=t.__v&&(p.props=m,p.state=p.__s,p.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),yc.push.apply(p.__h,p.__k),p.__k=[],p.__h.length&&o.push(p),a=ur(t);break e}p.componentWillUpdate&&p.componentWillUpdate(m,p.__s,S),b&&p.componentDidUpdate&&p.__h.push(function(){p.componentDidUpdate(_,x,g)})}else b&&!B.getDerivedStateFromProps&&p.componentWillMount&&p.componentWillMount(),b&&p.componentDidMount&&p.__h.push(p.componentDidMount);p.context=S,p.props=m,p.__P=n,p.__g&=-5,P=wt.__r,C=b?25:0;do p.__g&=-9,P&&P(e),u=p.render(p.props,p.state=p.__s,p.context);while(8&p.__g&&++C<25);b&&(yc.push.apply(p.__h,p.__k),p.__k=[]),p.state=p.__s,p.getChildContext&&(i=Wr({},i,p.getChildContext())),b&&t.__c&&p.getSnapshotBeforeUpdate&&(g=p.getSnapshotBeforeUpdate(_,x)),v=u&&u.type===Tt&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&nd(V,V)}),t.__k=null),a=t.__k?ur(t,0):null),a=Rg(n,jf(v)?v:[v],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(Hr),p.__h.length&&o.push(p),1&p.__g&&(p.__g&=-4)}catch(V){if(o.length=d,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(N=r.indexOf(a||void 0))||(N=r.length);(L=r[N-1])&&L.nodeType==8;)N--;for(;N<r.length;N++)if(L=r[N])if(r[N]=null,E){if(L==k)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(k=gc(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=gc(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Hr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||Ig(e),wt.__e(V,e,t)}}else a=e.__e=OS(t.__e,e,t,i,s,r,o,l,c,n);return(u=wt.diffed)&&u(e),a}function gc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Ig(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Ig))}function Lg(n,e,t){for(var i=0;i<t.length;)td(t[i++],t[i++],t[i++]);wt.__c&&wt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){wt.__e(r,s.__v)}})}function OS(n,e,t,i,s,r,o,a,l,c){var u,h,d,p,_,x,g,m,b=t.props||vc,A=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((_=r[u])&&(S?_.localName==S:_.nodeType==3)){n=_,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!S)return m.createTextNode(A);n=m.createElementNS(s,S,A.is?A:c),a&&(wt.__m&&wt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&A.defaultValue!=null?null:r&&Qf.call(c.childNodes),!a&&r)for(b={},u=0;u<n.attributes.length;u++)b[(_=n.attributes[u]).name]=_.value;for(u in b)_=b[u],u=="dangerouslySetInnerHTML"?d=_:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||pc(n,u,null,_,s);for(u in A)_=A[u],u=="children"?p=_:u=="dangerouslySetInnerHTML"?h=_:u=="value"?x=_:u=="checked"?g=_:a&&typeof _!="function"||b[u]===_||pc(n,u,_,b[u],s);h?(a||d&&(h.__html==d.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(d&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&LS.test(S))&&(s="http://www.w3.org/1999/xhtml"),Rg(c,jf(p)?p:[p],e,t,i,s,r,o,r?r[0]:t.__k&&ur(t,0),a,l),r&&r.some(Hr)),a&&S!="textarea"||(u="value",S=="progress"&&x==null?n.removeAttribute(u):x==null||x===n[u]&&(S!="progress"||x)||pc(n,u,x,b[u],s),u="checked",g!=null&&g!=n[u]&&pc(n,u,g,b[u],s))}else b===A||a&&n.data==A||(n.data=A);return n}function td(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){wt.__e(s,t)}}function nd(n,e,t){var i,s,r,o;if(wt.unmount&&wt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||td(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){wt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&nd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=gc(i,r=[]))&&(i==n.__e&&r.some(Hr),Hr(s),Hr(i)),t||Hr(n.__e),n.__e=n.__c=n.__=null}function kS(n,e,t){return this.constructor(n,t)}function Za(n,e){var t,i,s,r;wt.__&&wt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Ya(Tt,{children:[n]}),s=[],r=[],ed(e,e.__k,i||vc,vc,e.namespaceURI,i?null:e.firstChild?Qf.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Lg(s,e.__k,r),e.__k.props.children=null}wt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw _c=0,n}},Mg=0,Zf=function(n){return n!=null&&n.constructor===Ka},Lo.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Wr({},this.state)),typeof n=="function"&&(n=n(Wr({},t),this.props)),n&&(Wr(t,n),this.__v&&(e&&this.__k.push(e),bg(this)))},Lo.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),bg(this))},Lo.prototype.render=Tt,cr=[],_c=0,wg=function(n,e){return n.__v.__b-e.__v.__b},mc=Symbol(),Tg=/(PointerCapture)$|Capture$/i,Jf=0,Kf={},IS=0;var ja,Cn,id,Dg,sd=Object.is,xc=0,Gg=[],rd=[],Mn=wt,Ng=Mn.__b,Ug=Mn.__r,Fg=Mn.diffed,Og=Mn.__c,kg=Mn.unmount,Bg=Mn.__;function ad(n,e){Mn.__h&&Mn.__h(Cn,n,xc||e),xc=0;var t=Cn.__H||(Cn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Ot(n){return xc=1,BS(Wg,n)}function BS(n,e,t){var i=ad(ja++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Wg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);sd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Cn,!Cn.__f)){Cn.__f=!0;var s=Cn.shouldComponentUpdate;Cn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,sd(d.__[0],d.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function Rt(n,e){var t=ad(ja++,3);!Mn.__s&&Hg(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Cn.__H.__h.push(t))}function vt(n){return xc=5,Zt(function(){return{current:n}},[])}function Zt(n,e){var t=ad(ja++,7);return Hg(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function zS(){var n;do{for(;n=rd.shift();)try{Ja(n)}catch(t){Mn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Gg.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ja),e.__h.some(od),e.__h=[]}catch(t){e.__h=[],Mn.__e(t,n.__v)}}}while(rd.length)}Mn.__b=function(n){Cn=null,Ng&&Ng(n)},Mn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Bg&&Bg(n,e)},Mn.__r=function(n){Ug&&Ug(n),ja=0;var e=(Cn=n.__c).__H;e&&(id==Cn?Cn.__h=[]:(e.__h.some(Ja),e.__h.some(od),ja=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),id=Cn},Mn.diffed=function(n){Fg&&Fg(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Vg(Gg.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),id=Cn=null},Mn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ja),t.__h=t.__h.filter(function(i){return!i.__||od(i)})}catch(i){t.__h=[function(){throw i}]}}),Og&&Og(n,e)},Mn.unmount=function(n){kg&&kg(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Vg(rd.push(s))}else Ja(s)}catch(r){e=r}}),i.__H=void 0,e&&Mn.__e(e,i.__v))};var zg=typeof requestAnimationFrame=="function";function VS(n){var e,t=function(){clearTimeout(i),zg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);zg&&(e=requestAnimationFrame(t))}function Vg(n){n!=1&&Dg==Mn.requestAnimationFrame||((Dg=Mn.requestAnimationFrame)||VS)(zS)}function Ja(n){var e=Cn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Cn=e}function od(n){var e=Cn;n.__c=n.__(),Cn=e}function Hg(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!sd(t,n[i])})}function Wg(n,e){return typeof e=="function"?e(n):e}var GS=Symbol.for("preact-signals");function wc(){if(Fs>1)Fs--;else{var n,e=!1;for((function(){var s=Sc;for(Sc=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();el!==void 0;){var t=el;for(el=void 0,bc++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&Xg(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(bc=0,Fs--,e)throw n}}function Tc(n){if(Fs>0)return n();ld=++HS,Fs++;try{return n()}finally{wc()}}var Qa,nn=void 0;function tl(n){var e=nn,t=Qa;nn=void 0,Qa=void 0;try{return n()}finally{nn=e,Qa=t}}var el=void 0,Fs=0,bc=0,HS=0,ld=0,Sc=void 0,Mc=0;function qg(n){if(nn!==void 0){var e=n.n;if(e===void 0||e.t!==nn)return e={i:0,S:n,p:nn.s,n:void 0,t:nn,e:void 0,x:void 0,r:e},nn.s!==void 0&&(nn.s.n=e),nn.s=e,n.n=e,32&nn.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=nn.s,e.n=void 0,nn.s.n=e,nn.s=e),e}}function Rn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Rn.prototype.brand=GS;Rn.prototype.h=function(){return!0};Rn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:tl(function(){var i;(i=e.W)==null||i.call(e)}))};Rn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&tl(function(){var s;(s=e.Z)==null||s.call(e)}))}};Rn.prototype.subscribe=function(n){var e=this;return lt(function(){var t=e.value;tl(function(){return n(t)})},{name:"sub"})};Rn.prototype.valueOf=function(){return this.value};Rn.prototype.toString=function(){return this.value+""};Rn.prototype.toJSON=function(){return this.value};Rn.prototype.peek=function(){var n=this;return tl(function(){return n.value})};Object.defineProperty(Rn.prototype,"value",{get:function(){var n=qg(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(bc>100)throw new Error("Cycle detected");(function(t){Fs!==0&&bc===0&&t.l!==ld&&(t.l=ld,Sc={S:t,v:t.v,i:t.i,o:Sc})})(this),this.v=n,this.i++,Mc++,Fs++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{wc()}}}});function Pe(n,e){return new Rn(n,e)}function Xg(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function $g(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function Yg(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function qr(n,e){Rn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Mc-1,this.f=4}qr.prototype=new Rn;qr.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Mc))return!0;if(this.g=Mc,this.f|=1,this.i>0&&!Xg(this))return this.f&=-2,!0;var n=nn;try{$g(this),nn=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return nn=n,Yg(this),this.f&=-2,!0};qr.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Rn.prototype.S.call(this,n)};qr.prototype.U=function(n){if(this.t!==void 0&&(Rn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};qr.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(qr.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=qg(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function Wt(n,e){return new qr(n,e)}function Kg(n){var e=n.j;if(n.j=void 0,typeof e=="function"){Fs++;var t=nn;nn=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,cd(n),i}finally{nn=t,wc()}}}function cd(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,Kg(n)}function WS(n){if(nn!==this)throw new Error("Out-of-order effect");Yg(this),nn=n,this.f&=-2;try{8&this.f&&cd(this)}finally{wc()}}function Do(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,Qa&&Qa.push(this)}Do.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Do.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,Kg(this),$g(this),Fs++;var n=nn;return nn=this,WS.bind(this,n)};Do.prototype.N=function(){2&this.f||(this.f|=2,this.u=el,el=this)};Do.prototype.d=function(){this.f|=8,1&this.f||cd(this)};Do.prototype.dispose=function(){this.d()};function lt(n,e){var t=new Do(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var ud,il,Ec,qS=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,Zg=[],Jg=[];lt(function(){ud=this.N})();function No(n,e){wt[n]=e.bind(null,wt[n]||function(){})}function nl(n){if(Ec){var e=Ec;Ec=void 0,e()}Ec=n&&n.S()}function jg(n){var e=this,t=n.data,i=$S(t);i.name="ReactiveDom",i.value=t;var s=Zt(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=Wt(function(){var p=i.value.value;return p===0?0:p===!0?"":p||""}),u=Wt(function(){return!Array.isArray(c.value)&&!Zf(c.value)}),h=lt(function(){if(this.N=Qg,u.value){var p=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=p)}}),d=e.__$u.d;return e.__$u.d=function(){h(),d.call(this)},[u,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}jg.displayName="ReactiveTextNode";Object.defineProperties(Rn.prototype,{constructor:{configurable:!0,value:Eg(Tt,null).constructor},type:{configurable:!0,value:jg},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});No("__b",function(n,e){if(nl(),il=void 0,typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Rn&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});No("__r",function(n,e){if(n(e),e.type!==Tt){nl();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return lt(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;qS&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),il=i,nl(t)}});No("__e",function(n,e,t,i){nl(),il=void 0,n(e,t,i)});No("diffed",function(n,e){nl(),il=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=XS(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function XS(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=Pe(t);return{o:function(o,a){r.value=o,i=a},d:lt(function(){this.N=Qg;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}No("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});No("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});Lo.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function $S(n,e){return Zt(function(){return Pe(n,e)},[])}var YS=typeof requestAnimationFrame>"u"?setTimeout:function(n){var e=function(){clearTimeout(t),cancelAnimationFrame(i),n()},t=setTimeout(e,35),i=requestAnimationFrame(e)},KS=function(n){queueMicrotask(function(){queueMicrotask(n)})};function ZS(){Tc(function(){for(var n;n=Zg.shift();)ud.call(n)})}function JS(){Zg.push(this)===1&&(wt.requestAnimationFrame||YS)(ZS)}function jS(){Tc(function(){for(var n;n=Jg.shift();)ud.call(n)})}function Qg(){Jg.push(this)===1&&(wt.requestAnimationFrame||KS)(jS)}function e0(n,e){var t=vt(n);t.current=n;var i=il;Rt(function(){return lt(function(){if(this.N=JS,!(i&&8&i.__$f))return t.current()},e)},[])}var Uo=Pe([]);function sl(n,e){let t={title:n,keys:e};return Uo.value=[...Uo.peek(),t],()=>Uo.value=Uo.peek().filter(i=>i!==t)}var QS="input, textarea, select",eM="button, summary, a";function hr(n,e){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return;let t=n.target;if(t.closest(QS)!==null||n.key===" "&&t.closest(eM)!==null)return;let i=e.map(s=>s.actions[n.key]).find(s=>s!==void 0);i!==void 0&&(n.preventDefault(),i(n))}var t0=8,tM={"<f8":Float64Array,"<f4":Float32Array,"<i4":Int32Array,"<i2":Int16Array,"|i1":Int8Array},Ac=class n{constructor(e,t,i){this.header=e;this.content=t;this.front=i}header;content;front;static read(e){let t=new DataView(e).getUint32(0,!0),i=new TextDecoder().decode(new Uint8Array(e,4,t)),s=Math.ceil((4+t)/t0)*t0;return new n(JSON.parse(i),e,s)}has(e){return e in this.header.variables}values(e){let{type:t,start:i,shape:s}=this.described(e);if(t===void 0||i===void 0)throw new Error(`${e} has no numbers`);let r=s.reduce((o,a)=>o*a,1);return new tM[t](this.content,this.front+i,r)}scale(e){return this.described(e).scale??1}texts(e){return this.described(e).texts??[]}shape(e){return this.described(e).shape}unit(e){return this.described(e).attrs.units??""}title(e){return this.described(e).attrs.long_name??e}parsed(e){return JSON.parse(String(this.header.attrs[e]))}described(e){let t=this.header.variables[e];if(t===void 0)throw new Error(`the dataset has no variable ${e}`);return t}};var nM=Symbol.for("pv"),iM=0;function f(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:nM,__v:--iM,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),wt.vnode&&wt.vnode(c),c}function Fo({title:n,units:e,unit:t}){return f("label",{children:[n," ",f("select",{value:t.value.name,onChange:({currentTarget:i})=>t.value=e[i.selectedIndex]??t.value,children:e.map(({name:i})=>f("option",{children:i}))})]})}function Cc({playing:n}){return f("button",{type:"button",onClick:()=>n.value=!n.value,children:n.value?"Stop":"Move"})}function Rc({pace:n}){return f("label",{children:["pace, cycles per second: ",n.value.toFixed(1),f("input",{type:"range",min:"0.1",max:"3",step:"0.1",value:n.value,onInput:e=>n.value=Number(e.currentTarget.value)})]})}var rl=n=>String(n.header.attrs.origin??"simulated");function fr({name:n,data:e,keys:t,foot:i,children:s}){Rt(()=>sl(e.header.title,t),[e,t]);let r=e.header.extra.summary??[];return f("div",{class:n,tabIndex:-1,onKeyDown:o=>hr(o,t),children:[f("header",{children:[f("h1",{children:e.header.title}),f("p",{class:"origin",children:rl(e)}),r.map(o=>f("p",{children:o}))]}),s,f("footer",{children:f("p",{children:["haptonic ",String(e.header.attrs.haptonic_version??""),". ",i]})})]})}function dr(n){return[{keys:"t",effect:"tables",actions:{t:()=>hd(n,"table")}},{keys:"?",effect:"this list",actions:{"?":()=>hd(n,"keys")}}]}function hd(n,e){n.value=n.value===e?"none":e}function pr({listing:n,keys:e,children:t}){let i=vt(null);return e0(()=>{n.value!=="none"&&i.current?.focus()}),f("section",{"aria-label":"Tables and keys",children:[f("p",{class:"opened",children:[["table","Tables"],["keys","Keys"]].map(([r,o])=>f("button",{type:"button","aria-expanded":n.value===r,onClick:()=>hd(n,r),children:o}))}),f("div",{ref:i,tabIndex:-1,children:[n.value==="table"&&t,n.value==="keys"&&f(fd,{title:"Keys",keys:e})]})]})}function fd({title:n,keys:e}){return f("table",{children:[f("caption",{children:n}),f("tbody",{children:e.map(({keys:t,effect:i})=>f("tr",{children:[f("th",{scope:"row",children:f("kbd",{children:t})}),f("td",{children:i})]}))})]})}function Ii(n,e){if(!(Number.isFinite(e)&&e>0))return n.toFixed(3);e=Math.max(e,10**-6);let t=Math.floor(Math.log10(e)+1e-9);e<2*10**t&&(t-=1);let i=Math.ceil(e/10**t-1e-9);i===10&&([i,t]=[1,t+1]);let s=Math.min(Math.max(-t,0),6);return`${n.toFixed(s)} ± ${(i*10**t).toFixed(s)}`}var n0=[{name:"Hz",factor:1},{name:"kHz",factor:1e3},{name:"MHz",factor:1e6}],sM=1e4;function Oo(n){let{pitch_m:e,shear_speed_m_per_s:t}=n.header.attrs;return typeof e!="number"||typeof t!="number"?n0:[...n0,{name:"ωa/(2πcₜ)",factor:t/e,relative:!0}]}function ko(n,e){return n.find(({factor:i,relative:s})=>!s&&e<sM*i)??n[0]}function Bo(n,{name:e,relative:t}){return t?`${e} = ${n}`:`${n} ${e}`}function qi(n,{name:e,relative:t}){return t?e:`${n} / ${e.includes("/")?`(${e})`:e}`}function Pc(n){return`${Number(n.toPrecision(6))}`}var rM="uplot",oM="u-hz",aM="u-vt",lM="u-title",cM="u-wrap",uM="u-under",hM="u-over",fM="u-axis",Yr="u-off",dM="u-select",pM="u-cursor-x",mM="u-cursor-y",gM="u-cursor-pt",_M="u-legend",vM="u-live",yM="u-inline",xM="u-series",bM="u-marker",i0="u-label",SM="u-value",al="width",ll="height";var s0="bottom",zo="left",dd="right",Pd="#000",r0=Pd+"0",pd="mousemove",o0="mousedown",md="mouseup",a0="mouseenter",l0="mouseleave",c0="dblclick",MM="resize",wM="scroll",u0="change",Uc="dppxchange",Id="--",$o=typeof window<"u",xd=$o?document:null,Go=$o?window:null,TM=$o?navigator:null,Pt,Ic;function bd(){let n=devicePixelRatio;Pt!=n&&(Pt=n,Ic&&Md(u0,Ic,bd),Ic=matchMedia(`(min-resolution: ${Pt-.001}dppx) and (max-resolution: ${Pt+.001}dppx)`),Kr(u0,Ic,bd),Go.dispatchEvent(new CustomEvent(Uc)))}function gi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Sd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function Xi(n,e,t,i){let s=xd.createElement(n);return e!=null&&gi(s,e),t?.insertBefore(s,i),s}function Li(n,e){return Xi("div",n,e)}var h0=new WeakMap;function gs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=h0.get(n);r!=o&&(n.style.transform=r,h0.set(n,r),e<0||t<0||e>i||t>s?gi(n,Yr):Sd(n,Yr))}var f0=new WeakMap;function d0(n,e,t){let i=e+t,s=f0.get(n);i!=s&&(f0.set(n,i),n.style.background=e,n.style.borderColor=t)}var p0=new WeakMap;function m0(n,e,t,i){let s=e+""+t,r=p0.get(n);s!=r&&(p0.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Ld={passive:!0},EM={...Ld,capture:!0};function Kr(n,e,t,i){e.addEventListener(n,t,i?EM:Ld)}function Md(n,e,t,i){e.removeEventListener(n,t,Ld)}$o&&bd();function $i(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:_i((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function H0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var W0=n=>n!=null,q0=n=>n!=null&&n>0,kc=H0(W0),AM=H0(q0);function CM(n,e,t,i=0,s=!1){let r=s?AM:kc,o=s?q0:W0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function Bc(n,e,t,i){let s=v0(n),r=v0(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Os:X0,a=s==1?_i:Di,l=r==1?Di:_i,c=a(o(In(n))),u=l(o(In(e))),h=Ho(t,c),d=Ho(t,u);return t==10&&(c<0&&(h=Gt(h,-c)),u<0&&(d=Gt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=Z0(n,h),e=zc(e,d)),[n,e]}function Dd(n,e,t,i){let s=Bc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Nd=.1,g0={mode:3,pad:Nd},ul={pad:0,soft:null,mode:0},RM={min:ul,max:ul};function Fc(n,e,t,i){return Vc(t)?_0(n,e,t):(ul.pad=t,ul.soft=i?0:null,ul.mode=i?3:0,_0(n,e,RM))}function At(n,e){return n??e}function PM(n,e,t){for(e=At(e,0),t=At(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function _0(n,e,t){let i=t.min,s=t.max,r=At(i.pad,0),o=At(s.pad,0),a=At(i.hard,-Vt),l=At(s.hard,Vt),c=At(i.soft,Vt),u=At(s.soft,-Vt),h=At(i.mode,0),d=At(s.mode,0),p=e-n,_=Os(p),x=ii(In(n),In(e)),g=Os(x),m=In(g-_);(p<1e-24||m>10)&&(p=0,(n==0||e==0)&&(p=1e-24,h==2&&c!=Vt&&(r=0),d==2&&u!=-Vt&&(o=0)));let b=p||x||1e3,A=Os(b),S=Ho(10,_i(A)),P=b*(p==0?n==0?.1:1:r),C=Gt(Z0(n-P,S/10),24),v=n>=c&&(h==1||h==3&&C<=c||h==2&&C>=c)?c:Vt,E=ii(a,C<v&&n>=v?v:Yi(v,C)),k=b*(p==0?e==0?.1:1:o),N=Gt(zc(e+k,S/10),24),L=e<=u&&(d==1||d==3&&N>=u||d==2&&N<=u)?u:-Vt,B=Yi(l,N>L&&e<=L?L:ii(L,N));return E==B&&E==0&&(B=100),[E,B]}var IM=new Intl.NumberFormat($o?TM.language:"en-US"),Ud=n=>IM.format(n),vi=Math,Nc=vi.PI,In=vi.abs,_i=vi.floor,Pn=vi.round,Di=vi.ceil,Yi=vi.min,ii=vi.max,Ho=vi.pow,v0=vi.sign,Os=vi.log10,X0=vi.log2,LM=(n,e=1)=>vi.sinh(n)*e,gd=(n,e=1)=>vi.asinh(n/e),Vt=1/0;function y0(n){return(Os((n^n>>31)-(n>>31))|0)+1}function wd(n,e,t){return Yi(ii(n,e),t)}function $0(n){return typeof n=="function"}function yt(n){return $0(n)?n:()=>n}var DM=()=>{},Y0=n=>n,K0=(n,e)=>e,NM=n=>null,x0=n=>!0,b0=(n,e)=>n==e,UM=/\.\d*?(?=9{6,}|0{6,})/gm,Zr=n=>{if(j0(n)||gr.has(n))return n;let e=`${n}`,t=e.match(UM);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Zr(s)}e${r}`}return Gt(n,i)};function Xr(n,e){return Zr(Gt(Zr(n/e))*e)}function zc(n,e){return Zr(Di(Zr(n/e))*e)}function Z0(n,e){return Zr(_i(Zr(n/e))*e)}function Gt(n,e=0){if(j0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Pn(i)/t}var gr=new Map;function J0(n){return((""+n).split(".")[1]||"").length}function fl(n,e,t,i){let s=[],r=i.map(J0);for(let o=e;o<t;o++){let a=In(o),l=Gt(Ho(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Gt(u,h);s.push(d),gr.set(d,h)}}return s}var hl={},Fd=[],Wo=[null,null],mr=Array.isArray,j0=Number.isInteger,FM=n=>n===void 0;function S0(n){return typeof n=="string"}function Vc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function OM(n){return n!=null&&typeof n=="object"}var kM=Object.getPrototypeOf(Uint8Array),Q0="__proto__";function qo(n,e=Vc){let t;if(mr(n)){let i=n.find(s=>s!=null);if(mr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=qo(n[s],e)}else t=n.slice()}else if(n instanceof kM)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Q0&&(t[i]=qo(n[i],e))}else t=n;return t}function wn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Q0&&(Vc(n[s])?wn(n[s],qo(i[s])):n[s]=qo(i[s]))}return n}var BM=0,zM=1,VM=2;function GM(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function HM(n,e){if(XM(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return $M(o[0])||(o=qM(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:zM,p=[];for(let _=0;_<u.length;_++){let x=u[_],g=r.get(l[_]);x===null?d!=BM&&(h[g]=x,d==VM&&p.push(g)):h[g]=x}GM(h,p,s),i.push(h)}}return i}var WM=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function qM(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function XM(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function $M(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ii(1,_i((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var e_=["January","February","March","April","May","June","July","August","September","October","November","December"],t_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function n_(n){return n.slice(0,3)}var YM=t_.map(n_),KM=e_.map(n_),ZM={MMMM:e_,MMM:KM,WWWW:t_,WWW:YM};function ol(n){return(n<10?"0":"")+n}function JM(n){return(n<10?"00":n<100?"0":"")+n}var jM={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ol(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ol(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ol(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ol(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ol(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>JM(n.getMilliseconds())};function Od(n,e){e=e||ZM;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?jM[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var QM=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ew(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==QM?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var i_=n=>n%1==0,Oc=[1,2,2.5,5],tw=fl(10,-32,0,Oc),s_=fl(10,0,32,Oc),nw=s_.filter(i_),$r=tw.concat(s_),kd=`
`,r_="{YYYY}",M0=kd+r_,o_="{M}/{D}",cl=kd+o_,Lc=cl+"/{YY}",a_="{aa}",iw="{h}:{mm}",Vo=iw+a_,w0=kd+Vo,T0=":{ss}",Lt=null;function l_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?fl(10,0,3,Oc).filter(i_):fl(10,-3,0,Oc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,r_,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",M0,Lt,Lt,Lt,Lt,Lt,1],[s,o_,M0,Lt,Lt,Lt,Lt,Lt,1],[i,"{h}"+a_,Lc,Lt,cl,Lt,Lt,Lt,1],[t,Vo,Lc,Lt,cl,Lt,Lt,Lt,1],[e,T0,Lc+" "+Vo,Lt,cl+" "+Vo,Lt,w0,Lt,1],[n,T0+".{fff}",Lc+" "+Vo,Lt,cl+" "+Vo,Lt,w0,Lt,1]];function u(h){return(d,p,_,x,g,m)=>{let b=[],A=g>=o,S=g>=r&&g<o,P=h(_),C=Gt(P*n,3),v=_d(P.getFullYear(),A?0:P.getMonth(),S||A?1:P.getDate()),E=Gt(v*n,3);if(S||A){let k=S?g/r:0,N=A?g/o:0,L=C==E?C:Gt(_d(v.getFullYear()+N,v.getMonth()+k,1)*n,3),B=new Date(Pn(L/n)),V=B.getFullYear(),U=B.getMonth();for(let H=0;L<=x;H++){let Y=_d(V+N*H,U+k*H,1),G=Y-h(Gt(Y*n,3));L=Gt((+Y+G)*n,3),L<=x&&b.push(L)}}else{let k=g>=s?s:g,N=_i(_)-_i(C),L=E+N+zc(C-E,k);b.push(L);let B=h(L),V=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,U=g/i,H=d.axes[p]._space,Y=m/H;for(;L=Gt(L+g,n==1?0:3),!(L>x);)if(U>1){let G=_i(Gt(V+U,6))%24,Q=h(L).getHours()-G;Q>1&&(Q=-1),L-=Q*i,V=(V+U)%24;let se=b[b.length-1];Gt((L-se)/g,3)*Y>=.7&&b.push(L)}else b.push(L)}return b}}return[l,c,u]}var[sw,rw,ow]=l_(1),[aw,lw,cw]=l_(.001);fl(2,-53,53,[1]);function E0(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function A0(n,e){return(t,i,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,h,d,p;return i.map(_=>{let x=n(_),g=x.getFullYear(),m=x.getMonth(),b=x.getDate(),A=x.getHours(),S=x.getMinutes(),P=x.getSeconds(),C=g!=l&&a[2]||m!=c&&a[3]||b!=u&&a[4]||A!=h&&a[5]||S!=d&&a[6]||P!=p&&a[7]||a[1];return l=g,c=m,u=b,h=A,d=S,p=P,C(x)})}}function uw(n,e){let t=Od(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function _d(n,e,t){return new Date(n,e,t)}function C0(n,e){return e(n)}var hw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function R0(n,e){return(t,i,s,r)=>r==null?Id:e(n(i))}function fw(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function dw(n,e){return n.series[e].fill(n,e)}var pw={show:!0,live:!0,isolate:!1,mount:DM,markers:{show:!0,width:2,stroke:fw,fill:dw,dash:"solid"},idx:null,idxs:null,values:[]};function mw(n,e){let t=n.cursor.points,i=Li(),s=t.size(n,e);Jt(i,al,s),Jt(i,ll,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Jt(i,"borderWidth",o),i}function gw(n,e){let t=n.series[e].points;return t._fill||t._stroke}function _w(n,e){let t=n.series[e].points;return t._stroke||t._fill}function vw(n,e){return n.series[e].points.size}var vd=[0,0];function yw(n,e,t){return vd[0]=e,vd[1]=t,vd}function Dc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function yd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var xw={show:!0,x:!0,y:!0,lock:!1,move:yw,points:{one:!1,show:mw,size:vw,width:0,stroke:_w,fill:gw},bind:{mousedown:Dc,mouseup:Dc,click:Dc,dblclick:Dc,mousemove:yd,mouseleave:yd,mouseenter:yd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},c_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Bd=wn({},c_,{filter:K0}),u_=wn({},Bd,{size:10}),h_=wn({},c_,{show:!1}),zd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',f_="bold "+zd,d_=1.5,P0={show:!0,scale:"x",stroke:Pd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:f_,side:2,grid:Bd,ticks:u_,border:h_,font:zd,lineGap:d_,rotate:0},bw="Value",Sw="Time",I0={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function Mw(n,e,t,i,s){return e.map(r=>r==null?"":Ud(r))}function ww(n,e,t,i,s,r,o){let a=[],l=gr.get(s)||0;t=o?t:Gt(zc(t,s),l);for(let c=t;c<=i;c=Gt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Td(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Os:X0,u=_i(c(t));s=Ho(l,u),l==10&&(s=$r[$i(s,$r)]);let h=t,d=s*l;l==10&&(d=$r[$i(d,$r)]);do a.push(h),h=h+s,l==10&&!gr.has(h)&&(h=Gt(h,gr.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=$r[$i(d,$r)]));while(h<=i);return a}function Tw(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Td(n,e,ii(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Td(n,e,ii(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var p_=/./,Ew=/[12357]/,Aw=/[125]/,L0=/1/,Ed=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Cw(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?p_:l(7,o)-u>=c?Ew:l(5,o)-u>=c?Aw:L0;if(h==L0){let d=In(l(1,o)-u);if(d<c)return Ed(e.slice().reverse(),a.distr,h,Di(c/d)).reverse()}return Ed(e,a.distr,h,1)}function Rw(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=In(l(1,o)-l(2,o));return c<a?Ed(e.slice().reverse(),3,p_,Di(a/c)).reverse():e}function Pw(n,e,t,i){return i==null?Id:e==null?"":Ud(e)}var D0={show:!0,scale:"y",stroke:Pd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:f_,side:3,grid:Bd,ticks:u_,border:h_,font:zd,lineGap:d_,rotate:0};function Iw(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function Lw(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=In(o-r),l=n.series[e],c=a/(l.points.space*Pt);return i[1]-i[0]<=c}var N0={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},m_=(n,e,t,i,s)=>s,U0={show:!0,auto:!0,sorted:0,gaps:m_,alpha:1,facets:[wn({},N0,{scale:"x"}),wn({},N0,{scale:"y"})]},F0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:m_,alpha:1,points:{show:Lw,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function Dw(n,e,t,i,s){return t/10}var g_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Nw=wn({},g_,{time:!1,ori:1}),O0={};function __(n,e){let t=O0[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(O0[n]=t)),t}var Xo=1,Ad=2;function Jr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,p=a.top,_=a.width,x=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,g,m,d,p,_,x,Hc,Yo,qc,y_,b_):t(s,l,c,u,h,m,g,p,d,x,_,Wc,Ko,Hd,x_,S_)}function Vd(n,e){let t=0,i=0,s=At(n.bands,Fd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Uw(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ks(n,e,t,i,s,r){return Jr(n,e,(o,a,l,c,u,h,d,p,_,x,g)=>{let m=o.pxRound,b=c.dir*(c.ori==0?1:-1),A=c.ori==0?Yo:Ko,S,P;b==1?(S=t,P=i):(S=i,P=t);let C=m(h(a[S],c,x,p)),v=m(d(l[S],u,g,_)),E=m(h(a[P],c,x,p)),k=m(d(r==1?u.max:u.min,u,g,_)),N=new Path2D(s);return A(N,E,k),A(N,C,k),A(N,C,v),N})}function Gc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?qc:Hd,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let p=d[0]-l;p>0&&a(o,l,i,p,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Fw(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Gd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let p=r(n[h]),_=d==h?p:r(n[d]),x=h-s;p=o<=0&&x>=0&&x<l?r(n[x]):p;let m=d+s;_=o>=0&&m>=0&&m<l?r(n[m]):_,_>=p&&a.push([p,_])}return a}function k0(n){return n==0?Y0:n==1?Pn:e=>Xr(e,n)}function v_(n){let e=n==0?Hc:Wc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Yi(c,a/2,l/2),u=Yi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Hc=(n,e,t)=>{n.moveTo(e,t)},Wc=(n,e,t)=>{n.moveTo(t,e)},Yo=(n,e,t)=>{n.lineTo(e,t)},Ko=(n,e,t)=>{n.lineTo(t,e)},qc=v_(0),Hd=v_(1),y_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},x_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},b_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},S_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function M_(n){return(e,t,i,s,r)=>Jr(e,t,(o,a,l,c,u,h,d,p,_,x,g)=>{let{pxRound:m,points:b}=o,A,S;c.ori==0?(A=Hc,S=y_):(A=Wc,S=x_);let P=Gt(b.width*Pt,3),C=(b.size-b.width)/2*Pt,v=Gt(C*2,3),E=new Path2D,k=new Path2D,{left:N,top:L,width:B,height:V}=e.bbox;qc(k,N-v,L-v,B+v*2,V+v*2);let U=H=>{if(l[H]!=null){let Y=m(h(a[H],c,x,p)),G=m(d(l[H],u,g,_));A(E,Y+C,G),S(E,Y,G,C,0,Nc*2)}};if(r)r.forEach(U);else for(let H=i;H<=s;H++)U(H);return{stroke:P>0?E:null,fill:E,clip:k,flags:Xo|Ad}})}function w_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Ow=w_(Yo),kw=w_(Ko);function T_(n){let e=At(n?.alignGaps,0);return(t,i,s,r)=>Jr(t,i,(o,a,l,c,u,h,d,p,_,x,g)=>{[s,r]=kc(l,s,r);let m=o.pxRound,b=V=>m(h(V,c,x,p)),A=V=>m(d(V,u,g,_)),S,P;c.ori==0?(S=Yo,P=Ow):(S=Ko,P=kw);let C=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xo},E=v.stroke,k=!1;if(r-s>=x*4){let V=he=>t.posToVal(he,c.key,!0),U=null,H=null,Y,G,le,J=b(a[C==1?s:r]),Q=b(a[s]),se=b(a[r]),fe=V(C==1?Q+1:se-1);for(let he=C==1?s:r;he>=s&&he<=r;he+=C){let ee=a[he],ve=(C==1?ee<fe:ee>fe)?J:b(ee),Ae=l[he];ve==J?Ae!=null?(G=Ae,U==null?(S(E,ve,A(G)),Y=U=H=G):G<U?U=G:G>H&&(H=G)):Ae===null&&(k=!0):(U!=null&&P(E,J,A(U),A(H),A(Y),A(G)),Ae!=null?(G=Ae,S(E,ve,A(G)),U=H=Y=G):(U=H=null,Ae===null&&(k=!0)),J=ve,fe=V(J+C))}U!=null&&U!=H&&le!=J&&P(E,J,A(U),A(H),A(Y),A(G))}else for(let V=C==1?s:r;V>=s&&V<=r;V+=C){let U=l[V];U===null?k=!0:U!=null&&S(E,b(a[V]),A(U))}let[L,B]=Vd(t,i);if(o.fill!=null||L!=0){let V=v.fill=new Path2D(E),U=o.fillTo(t,i,o.min,o.max,L),H=A(U),Y=b(a[s]),G=b(a[r]);C==-1&&([G,Y]=[Y,G]),S(V,G,H),S(V,Y,H)}if(!o.spanGaps){let V=[];k&&V.push(...Gd(a,l,s,r,C,b,e)),v.gaps=V=o.gaps(t,i,s,r,V),v.clip=Gc(V,c.ori,p,_,x,g)}return B!=0&&(v.band=B==2?[ks(t,i,s,r,E,-1),ks(t,i,s,r,E,1)]:ks(t,i,s,r,E,B)),v})}function Bw(n){let e=At(n.align,1),t=At(n.ascDesc,!1),i=At(n.alignGaps,0),s=At(n.extend,!1);return(r,o,a,l)=>Jr(r,o,(c,u,h,d,p,_,x,g,m,b,A)=>{[a,l]=kc(h,a,l);let S=c.pxRound,{left:P,width:C}=r.bbox,v=Q=>S(_(Q,d,b,g)),E=Q=>S(x(Q,p,A,m)),k=d.ori==0?Yo:Ko,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xo},L=N.stroke,B=d.dir*(d.ori==0?1:-1),V=E(h[B==1?a:l]),U=v(u[B==1?a:l]),H=U,Y=U;s&&e==-1&&(Y=P,k(L,Y,V)),k(L,U,V);for(let Q=B==1?a:l;Q>=a&&Q<=l;Q+=B){let se=h[Q];if(se==null)continue;let fe=v(u[Q]),he=E(se);e==1?k(L,fe,V):k(L,H,he),k(L,fe,he),V=he,H=fe}let G=H;s&&e==1&&(G=P+C,k(L,G,V));let[le,J]=Vd(r,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(L),se=c.fillTo(r,o,c.min,c.max,le),fe=E(se);k(Q,G,fe),k(Q,Y,fe)}if(!c.spanGaps){let Q=[];Q.push(...Gd(u,h,a,l,B,v,i));let se=c.width*Pt/2,fe=t||e==1?se:-se,he=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=Gc(Q,d.ori,g,m,b,A)}return J!=0&&(N.band=J==2?[ks(r,o,a,l,L,-1),ks(r,o,a,l,L,1)]:ks(r,o,a,l,L,J)),N})}function B0(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=In(n[l]-n[a]);u<c&&(c=u,o=In(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function zw(n){n=n||hl;let e=At(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=At(e[1],Vt),l=At(e[2],1),c=At(n.disp,hl),u=At(n.each,p=>{}),{fill:h,stroke:d}=c;return(p,_,x,g)=>Jr(p,_,(m,b,A,S,P,C,v,E,k,N,L)=>{let B=m.pxRound,V=t,U=i*Pt,H=a*Pt,Y=l*Pt,G,le;S.ori==0?[G,le]=r(p,_):[le,G]=r(p,_);let J=S.dir*(S.ori==0?1:-1),Q=S.ori==0?qc:Hd,se=S.ori==0?u:(Re,Ke,ot,Me,zt,Ve,$e)=>{u(Re,Ke,ot,zt,Me,$e,Ve)},fe=At(p.bands,Fd).find(Re=>Re.series[0]==_),he=fe!=null?fe.dir:0,ee=m.fillTo(p,_,m.min,m.max,he),me=B(v(ee,P,L,k)),ve,Ae,Se,qe=N,rt=B(m.width*Pt),He=!1,ft=null,ct=null,it=null,en=null;h!=null&&(rt==0||d!=null)&&(He=!0,ft=h.values(p,_,x,g),ct=new Map,new Set(ft).forEach(Re=>{Re!=null&&ct.set(Re,new Path2D)}),rt>0&&(it=d.values(p,_,x,g),en=new Map,new Set(it).forEach(Re=>{Re!=null&&en.set(Re,new Path2D)})));let{x0:Ht,size:_n}=c;if(Ht!=null&&_n!=null){V=1,b=Ht.values(p,_,x,g),Ht.unit==2&&(b=b.map(ot=>p.posToVal(E+ot*N,S.key,!0)));let Re=_n.values(p,_,x,g);_n.unit==2?Ae=Re[0]*N:Ae=C(Re[0],S,N,E)-C(0,S,N,E),qe=B0(b,A,C,S,N,E,qe),Se=qe-Ae+U}else qe=B0(b,A,C,S,N,E,qe),Se=qe*o+U,Ae=qe-Se;Se<1&&(Se=0),rt>=Ae/2&&(rt=0),Se<5&&(B=Y0);let kt=Se>0,On=qe-Se-(kt?rt:0);Ae=B(wd(On,Y,H)),ve=(V==0?Ae/2:V==J?0:Ae)-V*J*((V==0?U/2:0)+(kt?rt/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},En=He?null:new Path2D,cn=null;if(fe!=null)cn=p.data[fe.series[1]];else{let{y0:Re,y1:Ke}=c;Re!=null&&Ke!=null&&(A=Ke.values(p,_,x,g),cn=Re.values(p,_,x,g))}let vn=G*Ae,O=le*Ae;for(let Re=J==1?x:g;Re>=x&&Re<=g;Re+=J){let Ke=A[Re];if(Ke==null)continue;if(cn!=null){let q=cn[Re]??0;if(Ke-q==0)continue;me=v(q,P,L,k)}let ot=S.distr!=2||c!=null?b[Re]:Re,Me=C(ot,S,N,E),zt=v(At(Ke,ee),P,L,k),Ve=B(Me-ve),$e=B(ii(zt,me)),R=B(Yi(zt,me)),M=$e-R;if(Ke!=null){let q=Ke<0?O:vn,ue=Ke<0?vn:O;He?(rt>0&&it[Re]!=null&&Q(en.get(it[Re]),Ve,R+_i(rt/2),Ae,ii(0,M-rt),q,ue),ft[Re]!=null&&Q(ct.get(ft[Re]),Ve,R+_i(rt/2),Ae,ii(0,M-rt),q,ue)):Q(En,Ve,R+_i(rt/2),Ae,ii(0,M-rt),q,ue),se(p,_,Re,Ve-rt/2,R,Ae+rt,M)}}return rt>0?Mt.stroke=He?en:En:He||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=He?ct:En,Mt})}function Vw(n,e){let t=At(e?.alignGaps,0);return(i,s,r,o)=>Jr(i,s,(a,l,c,u,h,d,p,_,x,g,m)=>{[r,o]=kc(c,r,o);let b=a.pxRound,A=G=>b(d(G,u,g,_)),S=G=>b(p(G,h,m,x)),P,C,v;u.ori==0?(P=Hc,v=Yo,C=b_):(P=Wc,v=Ko,C=S_);let E=u.dir*(u.ori==0?1:-1),k=A(l[E==1?r:o]),N=k,L=[],B=[];for(let G=E==1?r:o;G>=r&&G<=o;G+=E)if(c[G]!=null){let J=l[G],Q=A(J);L.push(N=Q),B.push(S(c[G]))}let V={stroke:n(L,B,P,v,C,b),fill:null,clip:null,band:null,gaps:null,flags:Xo},U=V.stroke,[H,Y]=Vd(i,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(U),le=a.fillTo(i,s,a.min,a.max,H),J=S(le);v(G,N,J),v(G,k,J)}if(!a.spanGaps){let G=[];G.push(...Gd(l,c,r,o,E,A,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=Gc(G,u.ori,_,x,g,m)}return Y!=0&&(V.band=Y==2?[ks(i,s,r,o,U,-1),ks(i,s,r,o,U,1)]:ks(i,s,r,o,U,Y)),V})}function Gw(n){return Vw(Hw,n)}function Hw(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var Cd=new Set;function z0(){for(let n of Cd)n.syncRect(!0)}$o&&(Kr(MM,Go,z0),Kr(wM,Go,z0,!0),Kr(Uc,Go,()=>{jt.pxRatio=Pt}));var Ww=T_(),qw=M_();function V0(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Rd(r,o,e,t))}function Xw(n,e){return n.map((t,i)=>i==0?{}:wn({},e,t))}function Rd(n,e,t,i){return wn({},e==0?t:i,n)}function E_(n,e,t){return e==null?Wo:[e,t]}var $w=E_;function Yw(n,e,t){return e==null?Wo:Fc(e,t,Nd,!0)}function A_(n,e,t,i){return e==null?Wo:Bc(e,t,n.scales[i].log,!1)}var Kw=A_;function C_(n,e,t,i){return e==null?Wo:Dd(e,t,n.scales[i].log,!1)}var Zw=C_;function Jw(n,e,t,i,s){let r=ii(y0(n),y0(e)),o=e-n,a=$i(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?gr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function G0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Pn((t=+s)*Pt))+"px"),[n,e,t]}function jw(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*Pt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function jt(n,e,t){let i={mode:At(n.mode,1)},s=i.mode;function r(y,w,I,D){let W=w.valToPct(y);return D+I*(w.dir==-1?1-W:W)}function o(y,w,I,D){let W=w.valToPct(y);return D+I*(w.dir==-1?W:1-W)}function a(y,w,I,D){return w.ori==0?r(y,w,I,D):o(y,w,I,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Li(rM);if(n.id!=null&&(c.id=n.id),gi(c,n.class),n.title){let y=Li(lM,c);y.textContent=n.title}let u=Xi("canvas"),h=i.ctx=u.getContext("2d"),d=Li(cM,c);Kr("click",d,y=>{y.target===_&&($t!=Ao||tn!=Co)&&Wn.click(i,y)},!0);let p=i.under=Li(uM,d);d.appendChild(u);let _=i.over=Li(hM,d);n=qo(n);let x=+At(n.pxAlign,1),g=k0(x);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let m=n.ms||.001,b=i.series=s==1?V0(n.series||[],I0,F0,!1):Xw(n.series||[null],U0),A=i.axes=V0(n.axes||[],P0,D0,!0),S=i.scales={},P=i.bands=n.bands||[];P.forEach(y=>{y.fill=yt(y.fill||null),y.dir=At(y.dir,-1)});let C=s==2?b[1].facets[0].scale:b[0].scale,v={axes:Ns,series:pt},E=(n.drawOrder||["axes","series"]).map(y=>v[y]);function k(y){let w=y.distr==3?I=>Os(I>0?I:y.clamp(i,I,y.min,y.max,y.key)):y.distr==4?I=>gd(I,y.asinh):y.distr==100?I=>y.fwd(I):I=>I;return I=>{let D=w(I),{_min:W,_max:Z}=y,ae=Z-W;return(D-W)/ae}}function N(y){let w=S[y];if(w==null){let I=(n.scales||hl)[y]||hl;if(I.from!=null){N(I.from);let D=wn({},S[I.from],I,{key:y});D.valToPct=k(D),S[y]=D}else{w=S[y]=wn({},y==C?g_:Nw,I),w.key=y;let D=w.time,W=w.range,Z=mr(W);if((y!=C||s==2&&!D)&&(Z&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?g0:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?g0:{mode:1,hard:W[1],soft:W[1]}},Z=!1),!Z&&Vc(W))){let ae=W;W=(de,xe,Ne)=>xe==null?Wo:Fc(xe,Ne,ae)}w.range=yt(W||(D?$w:y==C?w.distr==3?Kw:w.distr==4?Zw:E_:w.distr==3?A_:w.distr==4?C_:Yw)),w.auto=yt(Z?!1:w.auto),w.clamp=yt(w.clamp||Dw),w._min=w._max=null,w.valToPct=k(w)}}}N("x"),N("y"),s==1&&b.forEach(y=>{N(y.scale)}),A.forEach(y=>{N(y.scale)});for(let y in n.scales)N(y);let L=S[C],B=L.distr,V,U;L.ori==0?(gi(c,oM),V=r,U=o):(gi(c,aM),V=o,U=r);let H={};for(let y in S){let w=S[y];(w.min!=null||w.max!=null)&&(H[y]={min:w.min,max:w.max},w.min=w.max=null)}let Y=n.tzDate||(y=>new Date(Pn(y/m))),G=n.fmtDate||Od,le=m==1?ow(Y):cw(Y),J=A0(Y,E0(m==1?rw:lw,G)),Q=R0(Y,C0(hw,G)),se=[],fe=i.legend=wn({},pw,n.legend),he=i.cursor=wn({},xw,{drag:{y:s==2}},n.cursor),ee=fe.show,me=he.show,ve=fe.markers;fe.idxs=se,ve.width=yt(ve.width),ve.dash=yt(ve.dash),ve.stroke=yt(ve.stroke),ve.fill=yt(ve.fill);let Ae,Se,qe,rt=[],He=[],ft,ct=!1,it={};if(fe.live){let y=b[1]?b[1].values:null;ct=y!=null,ft=ct?y(i,1,0):{_:0};for(let w in ft)it[w]=Id}if(ee)if(Ae=Xi("table",_M,c),qe=Xi("tbody",null,Ae),fe.mount(i,Ae),ct){Se=Xi("thead",null,Ae,qe);let y=Xi("tr",null,Se);Xi("th",null,y);for(var en in ft)Xi("th",i0,y).textContent=en}else gi(Ae,yM),fe.live&&gi(Ae,vM);let Ht={show:!0},_n={show:!1};function kt(y,w){if(w==0&&(ct||!fe.live||s==2))return Wo;let I=[],D=Xi("tr",xM,qe,qe.childNodes[w]);gi(D,y.class),y.show||gi(D,Yr);let W=Xi("th",null,D);if(ve.show){let de=Li(bM,W);if(w>0){let xe=ve.width(i,w);xe&&(de.style.border=xe+"px "+ve.dash(i,w)+" "+ve.stroke(i,w)),de.style.background=ve.fill(i,w)}}let Z=Li(i0,W);y.label instanceof HTMLElement?Z.appendChild(y.label):Z.textContent=y.label,w>0&&(ve.show||(Z.style.color=y.width>0?ve.stroke(i,w):ve.fill(i,w)),Mt("click",W,de=>{if(he._lock)return;Je(de);let xe=b.indexOf(y);if((de.ctrlKey||de.metaKey)!=fe.isolate){let Ne=b.some((Ue,Oe)=>Oe>0&&Oe!=xe&&Ue.show);b.forEach((Ue,Oe)=>{Oe>0&&fs(Oe,Ne?Oe==xe?Ht:_n:Ht,!0,Sn.setSeries)})}else fs(xe,{show:!y.show},!0,Sn.setSeries)},!1),je&&Mt(a0,W,de=>{he._lock||(Je(de),fs(b.indexOf(y),Po,!0,Sn.setSeries))},!1));for(var ae in ft){let de=Xi("td",SM,D);de.textContent="--",I.push(de)}return[D,I]}let On=new Map;function Mt(y,w,I,D=!0){let W=On.get(w)||{},Z=he.bind[y](i,w,I,D);Z&&(Kr(y,w,W[y]=Z),On.set(w,W))}function En(y,w,I){let D=On.get(w)||{};for(let W in D)(y==null||W==y)&&(Md(W,w,D[W]),delete D[W]);y==null&&On.delete(w)}let cn=0,vn=0,O=0,Re=0,Ke=0,ot=0,Me=Ke,zt=ot,Ve=O,$e=Re,R=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,_e=!1,ye=!1,te=!1,ie=!1,pe=!1;function F(y,w,I){(I||y!=i.width||w!=i.height)&&re(y,w),ut(!1),ye=!0,_e=!0,$n()}function re(y,w){i.width=cn=O=y,i.height=vn=Re=w,Ke=ot=0,be(),We();let I=i.bbox;R=I.left=Xr(Ke*Pt,.5),M=I.top=Xr(ot*Pt,.5),q=I.width=Xr(O*Pt,.5),ue=I.height=Xr(Re*Pt,.5)}let ne=3;function we(){let y=!1,w=0;for(;!y;){w++;let I=wo(w),D=hs(w);y=w==ne||I&&D,y||(re(i.width,i.height),_e=!0)}}function ge({width:y,height:w}){F(y,w)}i.setSize=ge;function be(){let y=!1,w=!1,I=!1,D=!1;A.forEach((W,Z)=>{if(W.show&&W._show){let{side:ae,_size:de}=W,xe=ae%2,Ne=W.label!=null?W.labelSize:0,Ue=de+Ne;Ue>0&&(xe?(O-=Ue,ae==3?(Ke+=Ue,D=!0):I=!0):(Re-=Ue,ae==0?(ot+=Ue,y=!0):w=!0))}}),cs[0]=y,cs[1]=I,cs[2]=w,cs[3]=D,O-=Gi[1]+Gi[3],Ke+=Gi[3],Re-=Gi[2]+Gi[0],ot+=Gi[0]}function We(){let y=Ke+O,w=ot+Re,I=Ke,D=ot;function W(Z,ae){switch(Z){case 1:return y+=ae,y-ae;case 2:return w+=ae,w-ae;case 3:return I-=ae,I+ae;case 0:return D-=ae,D+ae}}A.forEach((Z,ae)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=W(de,Z._size),Z.label!=null&&(Z._lpos=W(de,Z.labelSize))}})}if(he.dataIdx==null){let y=he.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let I=y.prox=yt(y.prox),D=y.bias??=0;he.dataIdx=(W,Z,ae,de)=>{if(Z==0)return ae;let xe=ae,Ne=I(W,Z,ae,de)??Vt,Ue=Ne>=0&&Ne<Vt,Oe=L.ori==0?O:Re,st=he.left,Ct=e[0],Et=e[Z];if(w.has(Et[ae])){xe=null;let gt=null,Ze=null,Xe;if(D==0||D==-1)for(Xe=ae;gt==null&&Xe-- >0;)w.has(Et[Xe])||(gt=Xe);if(D==0||D==1)for(Xe=ae;Ze==null&&Xe++<Et.length;)w.has(Et[Xe])||(Ze=Xe);if(gt!=null||Ze!=null)if(Ue){let Kt=gt==null?-1/0:V(Ct[gt],L,Oe,0),fn=Ze==null?1/0:V(Ct[Ze],L,Oe,0),Vn=st-Kt,Bt=fn-st;Vn<=Bt?Vn<=Ne&&(xe=gt):Bt<=Ne&&(xe=Ze)}else xe=Ze==null?gt:gt==null?Ze:ae-gt<=Ze-ae?gt:Ze}else Ue&&In(st-V(Ct[ae],L,Oe,0))>Ne&&(xe=null);return xe}}let Je=y=>{he.event=y};he.idxs=se,he._lock=!1;let ce=he.points;ce.show=yt(ce.show),ce.size=yt(ce.size),ce.stroke=yt(ce.stroke),ce.width=yt(ce.width),ce.fill=yt(ce.fill);let ke=i.focus=wn({},n.focus||{alpha:.3},he.focus),je=ke.prox>=0,Ce=je&&ce.one,at=[],Xt=[],jn=[];function za(y,w){let I=ce.show(i,w);if(I instanceof HTMLElement)return gi(I,gM),gi(I,y.class),gs(I,-10,-10,O,Re),_.insertBefore(I,at[w]),I}function bo(y,w){if(s==1||w>0){let I=s==1&&S[y.scale].time,D=y.value;y.value=I?S0(D)?R0(Y,C0(D,G)):D||Q:D||Pw,y.label=y.label||(I?Sw:bw)}if(Ce||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||Ww||NM,y.fillTo=yt(y.fillTo||Uw),y.pxAlign=+At(y.pxAlign,x),y.pxRound=k0(y.pxAlign),y.stroke=yt(y.stroke||null),y.fill=yt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let I=Iw(ii(1,y.width),1),D=y.points=wn({},{size:I,width:ii(1,I*.2),stroke:y.stroke,space:I*2,paths:qw,_stroke:null,_fill:null},y.points);D.show=yt(D.show),D.filter=yt(D.filter),D.fill=yt(D.fill),D.stroke=yt(D.stroke),D.paths=yt(D.paths),D.pxAlign=y.pxAlign}if(ee){let I=kt(y,w);rt.splice(w,0,I[0]),He.splice(w,0,I[1]),fe.values.push(null)}if(me){se.splice(w,0,null);let I=null;Ce?w==0&&(I=za(y,w)):w>0&&(I=za(y,w)),at.splice(w,0,I),Xt.splice(w,0,0),jn.splice(w,0,0)}zn("addSeries",w)}function kf(y,w){w=w??b.length,y=s==1?Rd(y,w,I0,F0):Rd(y,w,{},U0),b.splice(w,0,y),bo(b[w],w)}i.addSeries=kf;function uc(y){if(b.splice(y,1),ee){fe.values.splice(y,1),He.splice(y,1);let w=rt.splice(y,1)[0];En(null,w.firstChild),w.remove()}me&&(se.splice(y,1),at.splice(y,1)[0].remove(),Xt.splice(y,1),jn.splice(y,1)),zn("delSeries",y)}i.delSeries=uc;let cs=[!1,!1,!1,!1];function Is(y,w){if(y._show=y.show,y.show){let I=y.side%2,D=S[y.scale];D==null&&(y.scale=I?b[1].scale:C,D=S[y.scale]);let W=D.time;y.size=yt(y.size),y.space=yt(y.space),y.rotate=yt(y.rotate),mr(y.incrs)&&y.incrs.forEach(ae=>{!gr.has(ae)&&gr.set(ae,J0(ae))}),y.incrs=yt(y.incrs||(D.distr==2?nw:W?m==1?sw:aw:$r)),y.splits=yt(y.splits||(W&&D.distr==1?le:D.distr==3?Td:D.distr==4?Tw:ww)),y.stroke=yt(y.stroke),y.grid.stroke=yt(y.grid.stroke),y.ticks.stroke=yt(y.ticks.stroke),y.border.stroke=yt(y.border.stroke);let Z=y.values;y.values=mr(Z)&&!mr(Z[0])?yt(Z):W?mr(Z)?A0(Y,E0(Z,G)):S0(Z)?uw(Y,Z):Z||J:Z||Mw,y.filter=yt(y.filter||(D.distr>=3&&D.log==10?Cw:D.distr==3&&D.log==2?Rw:K0)),y.font=G0(y.font),y.labelFont=G0(y.labelFont),y._size=y.size(i,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(cs[w]=!0,y._el=Li(fM,d))}}function Ls(y,w,I,D){let[W,Z,ae,de]=I,xe=w%2,Ne=0;return xe==0&&(de||Z)&&(Ne=w==0&&!W||w==2&&!ae?Pn(P0.size/3):0),xe==1&&(W||ae)&&(Ne=w==1&&!Z||w==3&&!de?Pn(D0.size/2):0),Ne}let Va=i.padding=(n.padding||[Ls,Ls,Ls,Ls]).map(y=>yt(At(y,Ls))),Gi=i._padding=Va.map((y,w)=>y(i,w,cs,0)),un,pn=null,mn=null,us=s==1?b[0].idxs:null,fi=null,ir=!1;function Ga(y,w){if(e=y??[],i.data=i._data=e,s==2){un=0;for(let I=1;I<b.length;I++)un+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),fi=e[0],un=fi.length;let I=e;if(B==2){I=e.slice();let D=I[0]=Array(un);for(let W=0;W<un;W++)D[W]=W}i._data=e=I}if(ut(!0),zn("setData"),B==2&&(ye=!0),w!==!1){let I=L;I.auto(i,ir)?Ha():or(C,I.min,I.max),te=te||he.left>=0,pe=!0,$n()}}i.setData=Ga;function Ha(){ir=!0;let y,w;s==1&&(un>0?(pn=us[0]=0,mn=us[1]=un-1,y=e[0][pn],w=e[0][mn],B==2?(y=pn,w=mn):y==w&&(B==3?[y,w]=Bc(y,y,L.log,!1):B==4?[y,w]=Dd(y,y,L.log,!1):L.time?w=y+Pn(86400/m):[y,w]=Fc(y,w,Nd,!0))):(pn=us[0]=y=null,mn=us[1]=w=null)),or(C,y,w)}let So,sr,Mo,T,z,j,X,$,Te,Ie;function Ee(y,w,I,D,W,Z){y??=r0,I??=Fd,D??="butt",W??=r0,Z??="round",y!=So&&(h.strokeStyle=So=y),W!=sr&&(h.fillStyle=sr=W),w!=Mo&&(h.lineWidth=Mo=w),Z!=z&&(h.lineJoin=z=Z),D!=j&&(h.lineCap=j=D),I!=T&&h.setLineDash(T=I)}function Le(y,w,I,D){w!=sr&&(h.fillStyle=sr=w),y!=X&&(h.font=X=y),I!=$&&(h.textAlign=$=I),D!=Te&&(h.textBaseline=Te=D)}function ze(y,w,I,D,W=0){if(D.length>0&&y.auto(i,ir)&&(w==null||w.min==null)){let Z=At(pn,0),ae=At(mn,D.length-1),de=I.min==null?CM(D,Z,ae,W,y.distr==3):[I.min,I.max];y.min=Yi(y.min,I.min=de[0]),y.max=ii(y.max,I.max=de[1])}}let Qe={min:null,max:null};function dt(){for(let D in S){let W=S[D];H[D]==null&&(W.min==null||H[C]!=null&&W.auto(i,ir))&&(H[D]=Qe)}for(let D in S){let W=S[D];H[D]==null&&W.from!=null&&H[W.from]!=null&&(H[D]=Qe)}H[C]!=null&&ut(!0);let y={};for(let D in H){let W=H[D];if(W!=null){let Z=y[D]=qo(S[D],OM);if(W.min!=null)wn(Z,W);else if(D!=C||s==2)if(un==0&&Z.from==null){let ae=Z.range(i,null,null,D);Z.min=ae[0],Z.max=ae[1]}else Z.min=Vt,Z.max=-Vt}}if(un>0){b.forEach((D,W)=>{if(s==1){let Z=D.scale,ae=H[Z];if(ae==null)return;let de=y[Z];if(W==0){let xe=de.range(i,de.min,de.max,Z);de.min=xe[0],de.max=xe[1],pn=$i(de.min,e[0]),mn=$i(de.max,e[0]),mn-pn>1&&(e[0][pn]<de.min&&pn++,e[0][mn]>de.max&&mn--),D.min=fi[pn],D.max=fi[mn]}else D.show&&D.auto&&ze(de,ae,D,e[W],D.sorted);D.idxs[0]=pn,D.idxs[1]=mn}else if(W>0&&D.show&&D.auto){let[Z,ae]=D.facets,de=Z.scale,xe=ae.scale,[Ne,Ue]=e[W],Oe=y[de],st=y[xe];Oe!=null&&ze(Oe,H[de],Z,Ne,Z.sorted),st!=null&&ze(st,H[xe],ae,Ue,ae.sorted),D.min=ae.min,D.max=ae.max}});for(let D in y){let W=y[D],Z=H[D];if(W.from==null&&(Z==null||Z.min==null)){let ae=W.range(i,W.min==Vt?null:W.min,W.max==-Vt?null:W.max,D);W.min=ae[0],W.max=ae[1]}}}for(let D in y){let W=y[D];if(W.from!=null){let Z=y[W.from];if(Z.min==null)W.min=W.max=null;else{let ae=W.range(i,Z.min,Z.max,D);W.min=ae[0],W.max=ae[1]}}}let w={},I=!1;for(let D in y){let W=y[D],Z=S[D];if(Z.min!=W.min||Z.max!=W.max){Z.min=W.min,Z.max=W.max;let ae=Z.distr;Z._min=ae==3?Os(Z.min):ae==4?gd(Z.min,Z.asinh):ae==100?Z.fwd(Z.min):Z.min,Z._max=ae==3?Os(Z.max):ae==4?gd(Z.max,Z.asinh):ae==100?Z.fwd(Z.max):Z.max,w[D]=I=!0}}if(I){b.forEach((D,W)=>{s==2?W>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)ye=!0,zn("setScale",D);me&&he.left>=0&&(te=pe=!0)}for(let D in H)H[D]=null}function Be(y){let w=wd(pn-1,0,un-1),I=wd(mn+1,0,un-1);for(;y[w]==null&&w>0;)w--;for(;y[I]==null&&I<un-1;)I++;return[w,I]}function pt(){if(un>0){let y=b.some(w=>w._focus)&&Ie!=ke.alpha;y&&(h.globalAlpha=Ie=ke.alpha),b.forEach((w,I)=>{if(I>0&&w.show&&(sn(I,!1),sn(I,!0),w._paths==null)){let D=Ie;Ie!=w.alpha&&(h.globalAlpha=Ie=w.alpha);let W=s==2?[0,e[I][0].length-1]:Be(e[I]);w._paths=w.paths(i,I,W[0],W[1]),Ie!=D&&(h.globalAlpha=Ie=D)}}),b.forEach((w,I)=>{if(I>0&&w.show){let D=Ie;Ie!=w.alpha&&(h.globalAlpha=Ie=w.alpha),w._paths!=null&&Nt(I,!1);{let W=w._paths!=null?w._paths.gaps:null,Z=w.points.show(i,I,pn,mn,W),ae=w.points.filter(i,I,Z,W);(Z||ae)&&(w.points._paths=w.points.paths(i,I,pn,mn,ae),Nt(I,!0))}Ie!=D&&(h.globalAlpha=Ie=D),zn("drawSeries",I)}}),y&&(h.globalAlpha=Ie=1)}}function sn(y,w){let I=w?b[y].points:b[y];I._stroke=I.stroke(i,y),I._fill=I.fill(i,y)}function Nt(y,w){let I=w?b[y].points:b[y],{stroke:D,fill:W,clip:Z,flags:ae,_stroke:de=I._stroke,_fill:xe=I._fill,_width:Ne=I.width}=I._paths;Ne=Gt(Ne*Pt,3);let Ue=null,Oe=Ne%2/2;w&&xe==null&&(xe=Ne>0?"#fff":de);let st=I.pxAlign==1&&Oe>0;if(st&&h.translate(Oe,Oe),!w){let Ct=R-Ne/2,Et=M-Ne/2,gt=q+Ne,Ze=ue+Ne;Ue=new Path2D,Ue.rect(Ct,Et,gt,Ze)}w?Fe(de,Ne,I.dash,I.cap,xe,D,W,ae,Z):Ut(y,de,Ne,I.dash,I.cap,xe,D,W,ae,Ue,Z),st&&h.translate(-Oe,-Oe)}function Ut(y,w,I,D,W,Z,ae,de,xe,Ne,Ue){let Oe=!1;xe!=0&&P.forEach((st,Ct)=>{if(st.series[0]==y){let Et=b[st.series[1]],gt=e[st.series[1]],Ze=(Et._paths||hl).band;mr(Ze)&&(Ze=st.dir==1?Ze[0]:Ze[1]);let Xe,Kt=null;Et.show&&Ze&&PM(gt,pn,mn)?(Kt=st.fill(i,Ct)||Z,Xe=Et._paths.clip):Ze=null,Fe(w,I,D,W,Kt,ae,de,xe,Ne,Ue,Xe,Ze),Oe=!0}}),Oe||Fe(w,I,D,W,Z,ae,de,xe,Ne,Ue)}let An=Xo|Ad;function Fe(y,w,I,D,W,Z,ae,de,xe,Ne,Ue,Oe){Ee(y,w,I,D,W),(xe||Ne||Oe)&&(h.save(),xe&&h.clip(xe),Ne&&h.clip(Ne)),Oe?(de&An)==An?(h.clip(Oe),Ue&&h.clip(Ue),_t(W,ae),yn(y,Z,w)):de&Ad?(_t(W,ae),h.clip(Oe),yn(y,Z,w)):de&Xo&&(h.save(),h.clip(Oe),Ue&&h.clip(Ue),_t(W,ae),h.restore(),yn(y,Z,w)):(_t(W,ae),yn(y,Z,w)),(xe||Ne||Oe)&&h.restore()}function yn(y,w,I){I>0&&(w instanceof Map?w.forEach((D,W)=>{h.strokeStyle=So=W,h.stroke(D)}):w!=null&&y&&h.stroke(w))}function _t(y,w){w instanceof Map?w.forEach((I,D)=>{h.fillStyle=sr=D,h.fill(I)}):w!=null&&y&&h.fill(w)}function Ds(y,w,I,D){let W=A[y],Z;if(D<=0)Z=[0,0];else{let ae=W._space=W.space(i,y,w,I,D),de=W._incrs=W.incrs(i,y,w,I,D,ae);Z=Jw(w,I,de,D,ae)}return W._found=Z}function xn(y,w,I,D,W,Z,ae,de,xe,Ne){let Ue=ae%2/2;x==1&&h.translate(Ue,Ue),Ee(de,ae,xe,Ne,de),h.beginPath();let Oe,st,Ct,Et,gt=W+(D==0||D==3?-Z:Z);I==0?(st=W,Et=gt):(Oe=W,Ct=gt);for(let Ze=0;Ze<y.length;Ze++)w[Ze]!=null&&(I==0?Oe=Ct=y[Ze]:st=Et=y[Ze],h.moveTo(Oe,st),h.lineTo(Ct,Et));h.stroke(),x==1&&h.translate(-Ue,-Ue)}function wo(y){let w=!0;return A.forEach((I,D)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,ut(!1));return}else I._show||(w=!1,I._show=!0,ut(!1));let Z=I.side,ae=Z%2,{min:de,max:xe}=W,[Ne,Ue]=Ds(D,de,xe,ae==0?O:Re);if(Ue==0)return;let Oe=W.distr==2,st=I._splits=I.splits(i,D,de,xe,Ne,Ue,Oe),Ct=W.distr==2?st.map(Xe=>fi[Xe]):st,Et=W.distr==2?fi[st[1]]-fi[st[0]]:Ne,gt=I._values=I.values(i,I.filter(i,Ct,D,Ue,Et),D,Ue,Et);I._rotate=Z==2?I.rotate(i,gt,D,Ue):0;let Ze=I._size;I._size=Di(I.size(i,gt,D,y)),Ze!=null&&I._size!=Ze&&(w=!1)}),w}function hs(y){let w=!0;return Va.forEach((I,D)=>{let W=I(i,D,cs,y);W!=Gi[D]&&(w=!1),Gi[D]=W}),w}function Ns(){for(let y=0;y<A.length;y++){let w=A[y];if(!w.show||!w._show)continue;let I=w.side,D=I%2,W,Z,ae=w.stroke(i,y),de=I==0||I==3?-1:1,[xe,Ne]=w._found;if(w.label!=null){let ti=w.labelGap*de,mi=Pn((w._lpos+ti)*Pt);Le(w.labelFont[0],ae,"center",I==2?"top":s0),h.save(),D==1?(W=Z=0,h.translate(mi,Pn(M+ue/2)),h.rotate((I==3?-Nc:Nc)/2)):(W=Pn(R+q/2),Z=mi);let Gr=$0(w.label)?w.label(i,y,xe,Ne):w.label;h.fillText(Gr,W,Z),h.restore()}if(Ne==0)continue;let Ue=S[w.scale],Oe=D==0?q:ue,st=D==0?R:M,Ct=w._splits,Et=Ue.distr==2?Ct.map(ti=>fi[ti]):Ct,gt=Ue.distr==2?fi[Ct[1]]-fi[Ct[0]]:xe,Ze=w.ticks,Xe=w.border,Kt=Ze.show?Ze.size:0,fn=Pn(Kt*Pt),Vn=Pn((w.alignTo==2?w._size-Kt-w.gap:w.gap)*Pt),Bt=w._rotate*-Nc/180,dn=g(w._pos*Pt),di=(fn+Vn)*de,ei=dn+di;Z=D==0?ei:0,W=D==1?ei:0;let Ri=w.font[0],Hi=w.align==1?zo:w.align==2?dd:Bt>0?zo:Bt<0?dd:D==0?"center":I==3?dd:zo,ps=Bt||D==1?"middle":I==2?"top":s0;Le(Ri,ae,Hi,ps);let pi=w.font[1]*w.lineGap,Pi=Ct.map(ti=>g(a(ti,Ue,Oe,st))),Wi=w._values;for(let ti=0;ti<Wi.length;ti++){let mi=Wi[ti];if(mi!=null){D==0?W=Pi[ti]:Z=Pi[ti],mi=""+mi;let Gr=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let ni=0;ni<Gr.length;ni++){let yg=Gr[ni];Bt?(h.save(),h.translate(W,Z+ni*pi),h.rotate(Bt),h.fillText(yg,0,0),h.restore()):h.fillText(yg,W,Z+ni*pi)}}}Ze.show&&xn(Pi,Ze.filter(i,Et,y,Ne,gt),D,I,dn,fn,Gt(Ze.width*Pt,3),Ze.stroke(i,y),Ze.dash,Ze.cap);let ms=w.grid;ms.show&&xn(Pi,ms.filter(i,Et,y,Ne,gt),D,D==0?2:1,D==0?M:R,D==0?ue:q,Gt(ms.width*Pt,3),ms.stroke(i,y),ms.dash,ms.cap),Xe.show&&xn([dn],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:q,Gt(Xe.width*Pt,3),Xe.stroke(i,y),Xe.dash,Xe.cap)}zn("drawAxes")}function ut(y){b.forEach((w,I)=>{I>0&&(w._paths=null,y&&(s==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let hn=!1,Qn=!1,Ft=[];function bn(){Qn=!1;for(let y=0;y<Ft.length;y++)zn(...Ft[y]);Ft.length=0}function $n(){hn||(WM(tg),hn=!0)}function hc(y,w=!1){hn=!0,Qn=w,y(i),tg(),w&&Ft.length>0&&queueMicrotask(bn)}i.batch=hc;function tg(){if(oe&&(dt(),oe=!1),ye&&(we(),ye=!1),_e){if(Jt(p,zo,Ke),Jt(p,"top",ot),Jt(p,al,O),Jt(p,ll,Re),Jt(_,zo,Ke),Jt(_,"top",ot),Jt(_,al,O),Jt(_,ll,Re),Jt(d,al,cn),Jt(d,ll,vn),u.width=Pn(cn*Pt),u.height=Pn(vn*Pt),A.forEach(({_el:y,_show:w,_size:I,_pos:D,side:W})=>{if(y!=null)if(w){let Z=W===3||W===0?I:0,ae=W%2==1;Jt(y,ae?"left":"top",D-Z),Jt(y,ae?"width":"height",I),Jt(y,ae?"top":"left",ae?ot:Ke),Jt(y,ae?"height":"width",ae?Re:O),Sd(y,Yr)}else gi(y,Yr)}),So=sr=Mo=z=j=X=$=Te=T=null,Ie=1,Xa(!0),Ke!=Me||ot!=zt||O!=Ve||Re!=$e){ut(!1);let y=O/Ve,w=Re/$e;if(me&&!te&&he.left>=0){he.left*=y,he.top*=w,To&&gs(To,Pn(he.left),0,O,Re),Eo&&gs(Eo,0,Pn(he.top),O,Re);for(let I=0;I<at.length;I++){let D=at[I];D!=null&&(Xt[I]*=y,jn[I]*=w,gs(D,Di(Xt[I]),Di(jn[I]),O,Re))}}if(Yt.show&&!ie&&Yt.left>=0&&Yt.width>0){Yt.left*=y,Yt.width*=y,Yt.top*=w,Yt.height*=w;for(let I in Wf)Jt(Ro,I,Yt[I])}Me=Ke,zt=ot,Ve=O,$e=Re}zn("setSize"),_e=!1}cn>0&&vn>0&&(h.clearRect(0,0,u.width,u.height),zn("drawClear"),E.forEach(y=>y()),zn("draw")),Yt.show&&ie&&(fc(Yt),ie=!1),me&&te&&(Vr(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(Gf(),pe=!1),l||(l=!0,i.status=1,zn("ready")),ir=!1,hn=!1}i.redraw=(y,w)=>{ye=w||!1,y!==!1?or(C,L.min,L.max):$n()};function Bf(y,w){let I=S[y];if(I.from==null){if(un==0){let D=I.range(i,w.min,w.max,y);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(un>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==C&&I.distr==2&&un>0&&(w.min=$i(w.min,e[0]),w.max=$i(w.max,e[0]),w.min==w.max&&w.max++),H[y]=w,oe=!0,$n()}}i.setScale=Bf;let zf,Vf,To,Eo,ng,ig,Ao,Co,sg,rg,$t,tn,rr=!1,Wn=he.drag,kn=Wn.x,Bn=Wn.y;me&&(he.x&&(zf=Li(pM,_)),he.y&&(Vf=Li(mM,_)),L.ori==0?(To=zf,Eo=Vf):(To=Vf,Eo=zf),$t=he.left,tn=he.top);let Yt=i.select=wn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ro=Yt.show?Li(dM,Yt.over?_:p):null;function fc(y,w){if(Yt.show){for(let I in y)Yt[I]=y[I],I in Wf&&Jt(Ro,I,y[I]);w!==!1&&zn("setSelect")}}i.setSelect=fc;function hS(y){if(b[y].show)ee&&Sd(rt[y],Yr);else if(ee&&gi(rt[y],Yr),me){let I=Ce?at[0]:at[y];I!=null&&gs(I,-10,-10,O,Re)}}function or(y,w,I){Bf(y,{min:w,max:I})}function fs(y,w,I,D){w.focus!=null&&gS(y),w.show!=null&&b.forEach((W,Z)=>{Z>0&&(y==Z||y==null)&&(W.show=w.show,hS(Z),s==2?(or(W.facets[0].scale,null,null),or(W.facets[1].scale,null,null)):or(W.scale,null,null),$n())}),I!==!1&&zn("setSeries",y,w),D&&$a("setSeries",i,y,w)}i.setSeries=fs;function fS(y,w){wn(P[y],w)}function dS(y,w){y.fill=yt(y.fill||null),y.dir=At(y.dir,-1),w=w??P.length,P.splice(w,0,y)}function pS(y){y==null?P.length=0:P.splice(y,1)}i.addBand=dS,i.setBand=fS,i.delBand=pS;function mS(y,w){b[y].alpha=w,me&&at[y]!=null&&(at[y].style.opacity=w),ee&&rt[y]&&(rt[y].style.opacity=w)}let Us,ar,zr,Po={focus:!0};function gS(y){if(y!=zr){let w=y==null,I=ke.alpha!=1;b.forEach((D,W)=>{if(s==1||W>0){let Z=w||W==0||W==y;D._focus=w?null:Z,I&&mS(W,Z?1:ke.alpha)}}),zr=y,I&&$n()}}ee&&je&&Mt(l0,Ae,y=>{he._lock||(Je(y),zr!=null&&fs(null,Po,!0,Sn.setSeries))});function ds(y,w,I){let D=S[w];I&&(y=y/Pt-(D.ori==1?ot:Ke));let W=O;D.ori==1&&(W=Re,y=W-y),D.dir==-1&&(y=W-y);let Z=D._min,ae=D._max,de=y/W,xe=Z+(ae-Z)*de,Ne=D.distr;return Ne==3?Ho(10,xe):Ne==4?LM(xe,D.asinh):Ne==100?D.bwd(xe):xe}function _S(y,w){let I=ds(y,C,w);return $i(I,e[0],pn,mn)}i.valToIdx=y=>$i(y,e[0]),i.posToIdx=_S,i.posToVal=ds,i.valToPos=(y,w,I)=>S[w].ori==0?r(y,S[w],I?q:O,I?R:0):o(y,S[w],I?ue:Re,I?M:0),i.setCursor=(y,w,I)=>{$t=y.left,tn=y.top,Vr(null,w,I)};function og(y,w){Jt(Ro,zo,Yt.left=y),Jt(Ro,al,Yt.width=w)}function ag(y,w){Jt(Ro,"top",Yt.top=y),Jt(Ro,ll,Yt.height=w)}let Wa=L.ori==0?og:ag,qa=L.ori==1?og:ag;function vS(){if(ee&&fe.live)for(let y=s==2?1:0;y<b.length;y++){if(y==0&&ct)continue;let w=fe.values[y],I=0;for(let D in w)He[y][I++].firstChild.nodeValue=w[D]}}function Gf(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((I,D)=>{se[D]=I}):FM(y.idx)||se.fill(y.idx),fe.idx=se[0]),ee&&fe.live){for(let I=0;I<b.length;I++)(I>0||s==1&&!ct)&&yS(I,se[I]);vS()}pe=!1,w!==!1&&zn("setLegend")}i.setLegend=Gf;function yS(y,w){let I=b[y],D=y==0&&B==2?fi:e[y],W;ct?W=I.values(i,y,w)??it:(W=I.value(i,w==null?null:D[w],y,w),W=W==null?it:{_:W}),fe.values[y]=W}function Vr(y,w,I){sg=$t,rg=tn,[$t,tn]=he.move(i,$t,tn),he.left=$t,he.top=tn,me&&(To&&gs(To,Pn($t),0,O,Re),Eo&&gs(Eo,0,Pn(tn),O,Re));let D,W=pn>mn;Us=Vt,ar=null;let Z=L.ori==0?O:Re,ae=L.ori==1?O:Re;if($t<0||un==0||W){D=he.idx=null;for(let de=0;de<b.length;de++){let xe=at[de];xe!=null&&gs(xe,-10,-10,O,Re)}je&&fs(null,Po,!0,y==null&&Sn.setSeries),fe.live&&(se.fill(D),pe=!0)}else{let de,xe,Ne;s==1&&(de=L.ori==0?$t:tn,xe=ds(de,C),D=he.idx=$i(xe,e[0],pn,mn),Ne=V(e[0][D],L,Z,0));let Ue=-10,Oe=-10,st=0,Ct=0,Et=!0,gt="",Ze="";for(let Xe=s==2?1:0;Xe<b.length;Xe++){let Kt=b[Xe],fn=se[Xe],Vn=fn==null?null:s==1?e[Xe][fn]:e[Xe][1][fn],Bt=he.dataIdx(i,Xe,D,xe),dn=Bt==null?null:s==1?e[Xe][Bt]:e[Xe][1][Bt];if(pe=pe||dn!=Vn||Bt!=fn,se[Xe]=Bt,Xe>0&&Kt.show){let di=Bt==null?-10:Bt==D?Ne:V(s==1?e[0][Bt]:e[Xe][0][Bt],L,Z,0),ei=dn==null?-10:U(dn,s==1?S[Kt.scale]:S[Kt.facets[1].scale],ae,0);if(je&&dn!=null){let Ri=L.ori==1?$t:tn,Hi=In(ke.dist(i,Xe,Bt,ei,Ri));if(Hi<Us){let ps=ke.bias;if(ps!=0){let pi=ds(Ri,Kt.scale),Pi=dn>=0?1:-1,Wi=pi>=0?1:-1;Wi==Pi&&(Wi==1?ps==1?dn>=pi:dn<=pi:ps==1?dn<=pi:dn>=pi)&&(Us=Hi,ar=Xe)}else Us=Hi,ar=Xe}}if(pe||Ce){let Ri,Hi;L.ori==0?(Ri=di,Hi=ei):(Ri=ei,Hi=di);let ps,pi,Pi,Wi,ms,ti,mi=!0,Gr=ce.bbox;if(Gr!=null){mi=!1;let ni=Gr(i,Xe);Pi=ni.left,Wi=ni.top,ps=ni.width,pi=ni.height}else Pi=Ri,Wi=Hi,ps=pi=ce.size(i,Xe);if(ti=ce.fill(i,Xe),ms=ce.stroke(i,Xe),Ce)Xe==ar&&Us<=ke.prox&&(Ue=Pi,Oe=Wi,st=ps,Ct=pi,Et=mi,gt=ti,Ze=ms);else{let ni=at[Xe];ni!=null&&(Xt[Xe]=Pi,jn[Xe]=Wi,m0(ni,ps,pi,mi),d0(ni,ti,ms),gs(ni,Di(Pi),Di(Wi),O,Re))}}}}if(Ce){let Xe=ke.prox,Kt=zr==null?Us<=Xe:Us>Xe||ar!=zr;if(pe||Kt){let fn=at[0];fn!=null&&(Xt[0]=Ue,jn[0]=Oe,m0(fn,st,Ct,Et),d0(fn,gt,Ze),gs(fn,Di(Ue),Di(Oe),O,Re))}}}if(Yt.show&&rr)if(y!=null){let[de,xe]=Sn.scales,[Ne,Ue]=Sn.match,[Oe,st]=y.cursor.sync.scales,Ct=y.cursor.drag;if(kn=Ct._x,Bn=Ct._y,kn||Bn){let{left:Et,top:gt,width:Ze,height:Xe}=y.select,Kt=y.scales[Oe].ori,fn=y.posToVal,Vn,Bt,dn,di,ei,Ri=de!=null&&Ne(de,Oe),Hi=xe!=null&&Ue(xe,st);Ri&&kn?(Kt==0?(Vn=Et,Bt=Ze):(Vn=gt,Bt=Xe),dn=S[de],di=V(fn(Vn,Oe),dn,Z,0),ei=V(fn(Vn+Bt,Oe),dn,Z,0),Wa(Yi(di,ei),In(ei-di))):Wa(0,Z),Hi&&Bn?(Kt==1?(Vn=Et,Bt=Ze):(Vn=gt,Bt=Xe),dn=S[xe],di=U(fn(Vn,st),dn,ae,0),ei=U(fn(Vn+Bt,st),dn,ae,0),qa(Yi(di,ei),In(ei-di))):qa(0,ae)}else qf()}else{let de=In(sg-ng),xe=In(rg-ig);if(L.ori==1){let st=de;de=xe,xe=st}kn=Wn.x&&de>=Wn.dist,Bn=Wn.y&&xe>=Wn.dist;let Ne=Wn.uni;Ne!=null?kn&&Bn&&(kn=de>=Ne,Bn=xe>=Ne,!kn&&!Bn&&(xe>de?Bn=!0:kn=!0)):Wn.x&&Wn.y&&(kn||Bn)&&(kn=Bn=!0);let Ue,Oe;kn&&(L.ori==0?(Ue=Ao,Oe=$t):(Ue=Co,Oe=tn),Wa(Yi(Ue,Oe),In(Oe-Ue)),Bn||qa(0,ae)),Bn&&(L.ori==1?(Ue=Ao,Oe=$t):(Ue=Co,Oe=tn),qa(Yi(Ue,Oe),In(Oe-Ue)),kn||Wa(0,Z)),!kn&&!Bn&&(Wa(0,0),qa(0,0))}if(Wn._x=kn,Wn._y=Bn,y==null){if(I){if(vg!=null){let[de,xe]=Sn.scales;Sn.values[0]=de!=null?ds(L.ori==0?$t:tn,de):null,Sn.values[1]=xe!=null?ds(L.ori==1?$t:tn,xe):null}$a(pd,i,$t,tn,O,Re,D)}if(je){let de=I&&Sn.setSeries,xe=ke.prox;zr==null?Us<=xe&&fs(ar,Po,!0,de):Us>xe?fs(null,Po,!0,de):ar!=zr&&fs(ar,Po,!0,de)}}pe&&(fe.idx=D,Gf()),w!==!1&&zn("setCursor")}let lr=null;Object.defineProperty(i,"rect",{get(){return lr==null&&Xa(!1),lr}});function Xa(y=!1){y?lr=null:(lr=_.getBoundingClientRect(),zn("syncRect",lr))}function lg(y,w,I,D,W,Z,ae){he._lock||rr&&y!=null&&y.movementX==0&&y.movementY==0||(Hf(y,w,I,D,W,Z,ae,!1,y!=null),y!=null?Vr(null,!0,!0):Vr(w,!0,!1))}function Hf(y,w,I,D,W,Z,ae,de,xe){if(lr==null&&Xa(!1),Je(y),y!=null)I=y.clientX-lr.left,D=y.clientY-lr.top;else{if(I<0||D<0){$t=-10,tn=-10;return}let[Ne,Ue]=Sn.scales,Oe=w.cursor.sync,[st,Ct]=Oe.values,[Et,gt]=Oe.scales,[Ze,Xe]=Sn.match,Kt=w.axes[0].side%2==1,fn=L.ori==0?O:Re,Vn=L.ori==1?O:Re,Bt=Kt?Z:W,dn=Kt?W:Z,di=Kt?D:I,ei=Kt?I:D;if(Et!=null?I=Ze(Ne,Et)?a(st,S[Ne],fn,0):-10:I=fn*(di/Bt),gt!=null?D=Xe(Ue,gt)?a(Ct,S[Ue],Vn,0):-10:D=Vn*(ei/dn),L.ori==1){let Ri=I;I=D,D=Ri}}xe&&(w==null||w.cursor.event.type==pd)&&((I<=1||I>=O-1)&&(I=Xr(I,O)),(D<=1||D>=Re-1)&&(D=Xr(D,Re))),de?(ng=I,ig=D,[Ao,Co]=he.move(i,I,D)):($t=I,tn=D)}let Wf={width:0,height:0,left:0,top:0};function qf(){fc(Wf,!1)}let cg,ug,hg,fg;function dg(y,w,I,D,W,Z,ae){rr=!0,kn=Bn=Wn._x=Wn._y=!1,Hf(y,w,I,D,W,Z,ae,!0,!1),y!=null&&(Mt(md,xd,pg,!1),$a(o0,i,Ao,Co,O,Re,null));let{left:de,top:xe,width:Ne,height:Ue}=Yt;cg=de,ug=xe,hg=Ne,fg=Ue}function pg(y,w,I,D,W,Z,ae){rr=Wn._x=Wn._y=!1,Hf(y,w,I,D,W,Z,ae,!1,!0);let{left:de,top:xe,width:Ne,height:Ue}=Yt,Oe=Ne>0||Ue>0,st=cg!=de||ug!=xe||hg!=Ne||fg!=Ue;if(Oe&&st&&fc(Yt),Wn.setScale&&Oe&&st){let Ct=de,Et=Ne,gt=xe,Ze=Ue;if(L.ori==1&&(Ct=xe,Et=Ue,gt=de,Ze=Ne),kn&&or(C,ds(Ct,C),ds(Ct+Et,C)),Bn)for(let Xe in S){let Kt=S[Xe];Xe!=C&&Kt.from==null&&Kt.min!=Vt&&or(Xe,ds(gt+Ze,Xe),ds(gt,Xe))}qf()}else he.lock&&(he._lock=!he._lock,Vr(w,!0,y!=null));y!=null&&(En(md,xd),$a(md,i,$t,tn,O,Re,null))}function xS(y,w,I,D,W,Z,ae){if(he._lock)return;Je(y);let de=rr;if(rr){let xe=!0,Ne=!0,Ue=10,Oe,st;L.ori==0?(Oe=kn,st=Bn):(Oe=Bn,st=kn),Oe&&st&&(xe=$t<=Ue||$t>=O-Ue,Ne=tn<=Ue||tn>=Re-Ue),Oe&&xe&&($t=$t<Ao?0:O),st&&Ne&&(tn=tn<Co?0:Re),Vr(null,!0,!0),rr=!1}$t=-10,tn=-10,se.fill(null),Vr(null,!0,!0),de&&(rr=de)}function mg(y,w,I,D,W,Z,ae){he._lock||(Je(y),Ha(),qf(),y!=null&&$a(c0,i,$t,tn,O,Re,null))}function gg(){A.forEach(jw),F(i.width,i.height,!0)}Kr(Uc,Go,gg);let Io={};Io.mousedown=dg,Io.mousemove=lg,Io.mouseup=pg,Io.dblclick=mg,Io.setSeries=(y,w,I,D)=>{let W=Sn.match[2];I=W(i,w,I),I!=-1&&fs(I,D,!0,!1)},me&&(Mt(o0,_,dg),Mt(pd,_,lg),Mt(a0,_,y=>{Je(y),Xa(!1)}),Mt(l0,_,xS),Mt(c0,_,mg),Cd.add(i),i.syncRect=Xa);let dc=i.hooks=n.hooks||{};function zn(y,w,I){Qn?Ft.push([y,w,I]):y in dc&&dc[y].forEach(D=>{D.call(null,i,w,I)})}(n.plugins||[]).forEach(y=>{for(let w in y.hooks)dc[w]=(dc[w]||[]).concat(y.hooks[w])});let _g=(y,w,I)=>I,Sn=wn({key:null,setSeries:!1,filters:{pub:x0,sub:x0},scales:[C,b[1]?b[1].scale:null],match:[b0,b0,_g],values:[null,null]},he.sync);Sn.match.length==2&&Sn.match.push(_g),he.sync=Sn;let vg=Sn.key,Xf=__(vg);function $a(y,w,I,D,W,Z,ae){Sn.filters.pub(y,w,I,D,W,Z,ae)&&Xf.pub(y,w,I,D,W,Z,ae)}Xf.sub(i);function bS(y,w,I,D,W,Z,ae){Sn.filters.sub(y,w,I,D,W,Z,ae)&&Io[y](null,w,I,D,W,Z,ae)}i.pub=bS;function SS(){Xf.unsub(i),Cd.delete(i),On.clear(),Md(Uc,Go,gg),c.remove(),Ae?.remove(),zn("destroy")}i.destroy=SS;function $f(){zn("init",n,e),Ga(e||n.data,!1),H[C]?Bf(C,H[C]):Ha(),ie=Yt.show&&(Yt.width>0||Yt.height>0),te=pe=!0,F(n.width,n.height)}return b.forEach(bo),A.forEach(Is),t?t instanceof HTMLElement?(t.appendChild(c),$f()):t(i,$f):$f(),i}jt.assign=wn;jt.fmtNum=Ud;jt.rangeNum=Fc;jt.rangeLog=Bc;jt.rangeAsinh=Dd;jt.orient=Jr;jt.pxRatio=Pt;jt.join=HM;jt.fmtDate=Od,jt.tzDate=ew;jt.sync=__;{jt.addGap=Fw,jt.clipGaps=Gc;let n=jt.paths={points:M_};n.linear=T_,n.stepped=Bw,n.bars=zw,n.spline=Gw}function Ge(n){let e=document.querySelector(".haptonic")??document.documentElement;return getComputedStyle(e).getPropertyValue(`--${n}`).trim()}function _s(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}var Qw=240;function vs(n){return Math.max(n.clientWidth,Qw)}function ys(n,e,t,i){let s=[...i,_s(()=>n.redraw(!1,!0))],r=new ResizeObserver(()=>n.setSize(t()));return r.observe(e),()=>{r.disconnect();for(let o of s)o();n.destroy()}}function _r(n,e){n.over.addEventListener("click",({clientX:t,clientY:i})=>{let s=n.over.getBoundingClientRect();e(t-s.left,i-s.top)})}function Bs({ctx:n,bbox:e},t){n.save(),n.beginPath(),n.rect(e.left,e.top,e.width,e.height),n.clip(),t(),n.restore()}var e1=320,t1=.72,n1=40;function R_({diagram:n,choice:e}){let t=vt(null);return Rt(()=>{let i=t.current;if(i!==null)return i1(i,n,e)},[n,e]),f("div",{class:"curves",ref:t})}function i1(n,e,t){let i=()=>t.unit.peek().factor,s=e.branches(),r=()=>[Array.from(e.distance),...s.map(h=>h.map(d=>d===null?null:d/i()))],o=()=>{let h=vs(n);return{width:h,height:Math.max(e1,Math.min(t1*h,.7*innerHeight))}},a=e.corners.map(({row:h})=>e.distance[h]??0),l={stroke:()=>Ge("ink"),ticks:{stroke:()=>Ge("rule")},grid:{}},c=new jt({...o(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(h,d,p)=>[d,p]},y:{range:(h,d,p)=>d===null?[0,1]:[d<.2*p?0:d,p]}},axes:[{...l,splits:()=>a,values:()=>e.corners.map(({label:h})=>h),font:"15px system-ui, sans-serif",grid:{stroke:()=>Ge("rule"),width:1}},{...l,size:48,font:"13px system-ui, sans-serif",grid:{show:!1},label:"frequency",labelFont:"14px system-ui, sans-serif",labelSize:24,values:(h,d)=>d.map(p=>`${Number(p.toPrecision(6))}`)}],series:[{},...s.map(()=>({stroke:()=>Ge("ink"),width:1.6,points:{show:!1}}))],hooks:{drawClear:[h=>Bs(h,()=>r1(h,e,i()))],draw:[h=>a1(h,e,t)]}},r(),n),u=()=>c.setScale("y",{min:0,max:e.top/i()});return u(),_r(c,(h,d)=>{let p=s1(c,e,i(),h,d);p!==void 0&&(t.point.value=p)}),ys(c,n,o,[lt(()=>{let h=c.axes[1];h!==void 0&&(h.label=qi("frequency",t.unit.value)),c.setData(r(),!0),u()}),lt(()=>{let h=e.at(t.point.value)/i();h>(c.scales.y?.max??1/0)?c.setScale("y",{min:0,max:1.03*h}):c.redraw(!1,!1)})])}function s1(n,e,t,i,s){let[r,o]=[void 0,n1];for(let a=0;a<e.rows;a++){let l=n.valToPos(e.distance[a]??0,"x")-i;if(!(Math.abs(l)>o))for(let c=0;c<e.bands;c++){let u=Math.hypot(l,n.valToPos(e.at({row:a,band:c})/t,"y")-s);u<o&&([r,o]=[{row:a,band:c},u])}}return r}function r1(n,e,t){let{ctx:i,bbox:s}=n;for(let r of e.gaps){let o=n.valToPos(r.upper/t,"y",!0),a=n.valToPos(r.lower/t,"y",!0)-o;r.complete?(i.fillStyle=Ge("gap"),i.fillRect(s.left,o,s.width,a)):r.waves!=="all"&&o1(i,s.left,o,s.width,a)}if(e.carrier!==void 0){let r=n.valToPos(e.carrier/t,"y",!0);i.strokeStyle=Ge("carrier"),i.lineWidth=1.5*devicePixelRatio,i.setLineDash([7*devicePixelRatio,5*devicePixelRatio]),i.beginPath(),i.moveTo(s.left,r),i.lineTo(s.left+s.width,r),i.stroke()}}function o1(n,e,t,i,s){let r=12*devicePixelRatio;n.save(),n.beginPath(),n.rect(e,t,i,s),n.clip(),n.beginPath();for(let o=e-s;o<e+i;o+=r)n.moveTo(o,t+s),n.lineTo(o+s,t);n.strokeStyle=Ge("gap"),n.lineWidth=2*devicePixelRatio,n.stroke(),n.restore()}function a1(n,e,t){let{ctx:i}=n,s=t.point.peek(),r=n.valToPos(e.distance[s.row]??0,"x",!0),o=n.valToPos(e.at(s)/t.unit.peek().factor,"y",!0);i.save(),i.beginPath(),i.arc(r,o,6*devicePixelRatio,0,2*Math.PI),i.fillStyle=Ge("accent"),i.strokeStyle=Ge("paper"),i.lineWidth=2*devicePixelRatio,i.fill(),i.stroke(),i.restore()}var Xc=class{constructor(e){this.data=e;this.distance=e.values("distance"),this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),[this.rows=0,this.bands=0]=e.shape("frequency"),this.names=e.parsed("character_names");let t=e.parsed("path_labels"),i=e.parsed("path_corners");this.corners=t.map((r,o)=>({label:r,row:i[o]??0}));let s=e.header.attrs.carrier_hz;this.carrier=typeof s=="number"?s:void 0,this.top=Number(e.header.extra.top),this.units=Oo(e),this.gaps=this.readGaps()}data;distance;frequency;error;rows;bands;gaps;corners;carrier;top;units;names;branches(){let e=this.data.values("branch"),t=new Map;return e.forEach((i,s)=>{let r=t.get(i)??Array(this.rows).fill(null);r[Math.floor(s/this.bands)]=this.frequency[s]??null,t.set(i,r)}),[...t.values()]}at({row:e,band:t}){return this.frequency[e*this.bands+t]??NaN}errorAt({row:e,band:t}){return this.error[e*this.bands+t]??NaN}nature({row:e,band:t}){return this.names[this.data.values("character")[e*this.bands+t]??-1]??""}parity({row:e,band:t}){let i=e*this.bands+t,s=[["even","odd"][P_(this.data.values("parity")[i])],["symmetric","antisymmetric"][P_(this.data.values("middle_parity")[i])]],[r,o]=s;return[r&&`${r} under the mirror of the path`,o&&`${o} about the plate's middle plane`].filter(Boolean).join(", ")}velocity({row:e,band:t}){let i=this.data.values("group_velocity"),s=2*(e*this.bands+t),[r,o]=[i[s]??NaN,i[s+1]??NaN];return Number.isFinite(r)&&Number.isFinite(o)?[r,o]:void 0}phases(e){let t=this.data.values("kappa");return[t[2*e]??0,t[2*e+1]??0]}place(e){let t=this.corners.find(a=>a.row===e);if(t!==void 0)return t.label;let i=this.corners.findIndex(a=>a.row>e),[s,r]=[this.corners[i-1],this.corners[i]];if(s===void 0||r===void 0)return"";let o=(e-s.row)/(r.row-s.row);return`${Number(o.toFixed(3))} of ${s.label}-${r.label}`}belowGap(e){let t=e.below-1,i=0;for(let s=1;s<this.rows;s++)this.at({row:s,band:t})>this.at({row:i,band:t})&&(i=s);return{row:i,band:t}}readGaps(){if(!this.data.has("gap_below"))return[];let e=t=>this.data.values(t);return Array.from(e("gap_below"),(t,i)=>({below:t,lower:e("gap_lower")[i]??NaN,upper:e("gap_upper")[i]??NaN,lowerError:e("gap_lower_error")[i]??NaN,upperError:e("gap_upper_error")[i]??NaN,complete:e("gap_complete")[i]===1,direction:this.data.texts("gap_direction")[i]??"",waves:this.data.texts("gap_waves")[i]??""}))}};function P_(n){return n===1?0:n===-1?1:-1}function $c(){return matchMedia("(prefers-reduced-motion: reduce)").matches}var Zo=class{constructor({playing:e,pace:t},i){this.draw=i;let s=0,r=o=>{s>0&&(this.moment=(this.moment+(o-s)/1e3*t.peek())%1),s=o,document.hidden||i(),this.frame=requestAnimationFrame(r)};this.stop=lt(()=>{cancelAnimationFrame(this.frame),s=0,e.value&&(this.frame=requestAnimationFrame(r))})}draw;moment=0;frame=0;stop;at(e){this.moment=e,this.draw()}end(){cancelAnimationFrame(this.frame),this.stop()}};var Yc=6,Kc=.5;function I_(n){let e=n.gaps[0];return{point:Pe(e?n.belowGap(e):{row:n.corners[1]?.row??0,band:0}),playing:Pe(!$c()),swing:Pe(.15),pace:Pe(.7),copies:Pe([2,2]),unit:Pe(ko(n.units,Math.max(...n.frequency))),listing:Pe("none")}}function L_(n,{row:e,band:t},i,s){return{row:Math.min(Math.max(e+i,0),n.rows-1),band:Math.min(Math.max(t+s,0),n.bands-1)}}function D_(n,{band:e}){let t=[...n.gaps].filter(s=>s.waves==="all").sort((s,r)=>s.below-r.below),i=t.find(s=>s.below-1>e)??t[0];return i&&n.belowGap(i)}var l1=10,N_=.05;function U_(n,e){let t=(r,o)=>e.point.value=L_(n,e.point.value,r,o),i=r=>e.swing.value=Math.min(Math.max(e.swing.value+r,0),Kc),s=r=>r.shiftKey?l1:1;return[{keys:"← →",effect:"previous or next wavevector; ten with Shift",actions:{ArrowLeft:r=>t(-s(r),0),ArrowRight:r=>t(s(r),0)}},{keys:"↑ ↓",effect:"next higher or lower band",actions:{ArrowUp:()=>t(0,1),ArrowDown:()=>t(0,-1)}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},{keys:"+ −",effect:"larger or smaller displacement",actions:{"+":()=>i(N_),"-":()=>i(-N_)}},{keys:"g",effect:"lower edge of the next gap",actions:{g:()=>e.point.value=D_(n,e.point.value)??e.point.value}},...dr(e.listing)]}var Jo=PS(Y_(),1);function Qc(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),6e4)}var eu=40,tu=40,Yd="video/webm",P1=6,K_=new WeakMap;function nu(n,e){K_.set(n,e)}function iu({canvas:n,name:e,caption:t}){let[i,s]=Ot(""),r=typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported(Yd),o=(a,l)=>async()=>{if(n.current!==null){s(`The ${a} is made.`),await new Promise(c=>setTimeout(c,tu));try{Qc(await l(new Kd(n.current,t)),`${e}.${a.toLowerCase()}`),s("")}catch(c){s(`The ${a} cannot be made: ${String(c)}`)}}};return f("p",{class:"sides film",children:[f("span",{children:"Save the motion"}),f("button",{type:"button",onClick:()=>{o("GIF",I1)()},children:"GIF"}),r&&f("button",{type:"button",onClick:()=>{o("WebM",L1)()},children:"WebM"}),f("span",{role:"status",children:i})]})}var Kd=class{constructor(e,t){this.canvas=e;this.caption=t;let i=K_.get(e),s=this.copy.getContext("2d",{willReadFrequently:!0});if(i===void 0||s===null)throw new Error("the canvas does not move");[this.draw,this.context]=[i,s],[this.copy.width,this.copy.height]=[e.width,e.height]}canvas;caption;copy=document.createElement("canvas");context;draw;show(e){let{context:t,copy:i}=this;this.draw(e),t.fillStyle=Ge("panel"),t.fillRect(0,0,i.width,i.height),t.drawImage(this.canvas,0,0),t.font=`${13*devicePixelRatio}px system-ui, sans-serif`,t.fillStyle=Ge("ink");let s=P1*devicePixelRatio;return t.fillText(this.caption,s,i.height-s,i.width-2*s),t}};async function I1(n){let{width:e,height:t}=n.copy,i=(0,Jo.GIFEncoder)(),s;for(let r=0;r<eu;r++){let{data:o}=n.show(r/eu).getImageData(0,0,e,t);s??=(0,Jo.quantize)(o,256),i.writeFrame((0,Jo.applyPalette)(o,s),e,t,r===0?{palette:s,delay:tu}:{delay:tu}),r%5===4&&await new Promise(a=>setTimeout(a))}return i.finish(),new Blob([i.bytes()],{type:"image/gif"})}async function L1(n){n.show(0);let e=n.copy.captureStream(),t=new MediaRecorder(e,{mimeType:Yd,videoBitsPerSecond:8e6}),i=[];t.ondataavailable=({data:r})=>i.push(r);let s=new Promise(r=>t.onstop=r);t.start();for(let r=0;r<eu;r++)n.show(r/eu),await new Promise(o=>setTimeout(o,tu));t.stop(),await s;for(let r of e.getTracks())r.stop();return new Blob(i,{type:Yd})}var Pr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ir={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Sv=0,Sp=1,Mv=2;var zl=1,wv=2,Sa=3,Lr=0,oi=1,Oi=2,ao=0,Ma=1,Mp=2,wp=3,Tp=4,Tv=5;var lo=100,Ev=101,Av=102,Cv=103,Rv=104,Pv=200,Iv=201,Lv=202,Dv=203,Ep=204,Ap=205,Nv=206,Uv=207,Fv=208,Ov=209,kv=210,Bv=211,zv=212,Vv=213,Gv=214,Cu=0,Ru=1,Pu=2,fa=3,Iu=4,Lu=5,Du=6,Nu=7,Cp=0,Hv=1,Wv=2,ws=0,Rp=1,Pp=2,Ip=3,Lp=4,Dp=5,Np=6,Up=7;var Fp=300,co=301,wa=302,lh=303,ch=304,Uu=1e3,bs=1001,Fu=1002,Hn=1003,qv=1004;var Vl=1005;var qn=1006,uh=1007;var Ks=1008;var Ci=1009,Op=1010,kp=1011,Ta=1012,hh=1013,Qi=1014,es=1015,ts=1016,fh=1017,dh=1018,uo=1020,Bp=35902,zp=35899,Vp=1021,Gp=1022,ns=1023,Xs=1026,Zs=1027,Hp=1028,ph=1029,Dr=1030,mh=1031;var gh=1033,Gl=33776,Hl=33777,Wl=33778,ql=33779,_h=35840,vh=35841,yh=35842,xh=35843,bh=36196,Sh=37492,Mh=37496,wh=37488,Th=37489,Xl=37490,Eh=37491,Ah=37808,Ch=37809,Rh=37810,Ph=37811,Ih=37812,Lh=37813,Dh=37814,Nh=37815,Uh=37816,Fh=37817,Oh=37818,kh=37819,Bh=37820,zh=37821,Vh=36492,Gh=36494,Hh=36495,Wh=36283,qh=36284,$l=36285,Xh=36286;var Sl=2300,Ou=2301,Eu=2302,gp=2303,_p=2400,vp=2401,yp=2402;var Xv=3200;var Wp=0,$v=1,Js="",bi="srgb",Ml="srgb-linear",wl="linear",Dt="srgb";var Au=7680;var Yv=519,Kv=512,Zv=513,Jv=514,qp=515,jv=516,Qv=517,Xp=518,$p=519,ey=35044;var Yp="300 es",Ui=2e3,Tl=2001;function D1(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function N1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function El(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function ty(){let n=El("canvas");return n.style.display="block",n}var Z_={},da=null;function Kp(...n){let e="THREE."+n.shift();da?da("log",e,...n):console.log(e,...n)}function ny(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=ny(n);let e="THREE."+n.shift();if(da)da("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function et(...n){n=ny(n);let e="THREE."+n.shift();if(da)da("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function yl(...n){let e=n.join(" ");e in Z_||(Z_[e]=!0,Ye(...n))}function iy(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var sy={[Cu]:Cu,[Pu]:Du,[Iu]:Iu,[fa]:Lu,[Ru]:Ru,[Du]:Pu,[Nu]:Nu,[Lu]:fa},ji=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Yn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],J_=1234567,xl=Math.PI/180,pa=180/Math.PI;function Ea(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Yn[n&255]+Yn[n>>8&255]+Yn[n>>16&255]+Yn[n>>24&255]+"-"+Yn[e&255]+Yn[e>>8&255]+"-"+Yn[e>>16&15|64]+Yn[e>>24&255]+"-"+Yn[t&63|128]+Yn[t>>8&255]+"-"+Yn[t>>16&255]+Yn[t>>24&255]+Yn[i&255]+Yn[i>>8&255]+Yn[i>>16&255]+Yn[i>>24&255]).toLowerCase()}function mt(n,e,t){return Math.max(e,Math.min(t,n))}function Zp(n,e){return(n%e+e)%e}function U1(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function F1(n,e,t){return n!==e?(t-n)/(e-n):0}function bl(n,e,t){return(1-t)*n+t*e}function O1(n,e,t,i){return bl(n,e,1-Math.exp(-t*i))}function k1(n,e=1){return e-Math.abs(Zp(n,e*2)-e)}function B1(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function z1(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function V1(n,e){return n+Math.floor(Math.random()*(e-n+1))}function G1(n,e){return n+Math.random()*(e-n)}function H1(n){return n*(.5-Math.random())}function W1(n){n!==void 0&&(J_=n);let e=J_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function q1(n){return n*xl}function X1(n){return n*pa}function $1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Y1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Jp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function K1(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),d=o((e-i)/2),p=r((i-e)/2),_=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*_,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*_,a*c);break;case"ZYZ":n.set(l*_,l*p,a*u,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function jp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function ry(n,e){if(e.constructor===Float32Array)return n;let t=jp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function oy(n,e){if(e.constructor===Float32Array)return n;let t=jp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Qp={DEG2RAD:xl,RAD2DEG:pa,generateUUID:Ea,clamp:mt,euclideanModulo:Zp,mapLinear:U1,inverseLerp:F1,lerp:bl,damp:O1,pingpong:k1,smoothstep:B1,smootherstep:z1,randInt:V1,randFloat:G1,randFloatSpread:H1,seededRandom:W1,degToRad:q1,radToDeg:X1,isPowerOfTwo:$1,ceilPowerOfTwo:Y1,floorPowerOfTwo:Jp,setQuaternionFromProperEuler:K1,normalize:oy,denormalize:ry},tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Mi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],p=r[o+1],_=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==p||u!==_){let g=l*d+c*p+u*_+h*x;g<0&&(d=-d,p=-p,_=-_,x=-x,g=-g);let m=1-a;if(g<.9995){let b=Math.acos(g),A=Math.sin(b);m=Math.sin(m*b)/A,a=Math.sin(a*b)/A,l=l*m+d*a,c=c*m+p*a,u=u*m+_*a,h=h*m+x*a}else{l=l*m+d*a,c=c*m+p*a,u=u*m+_*a,h=h*m+x*a;let b=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=b,c*=b,u*=b,h*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],p=r[o+2],_=r[o+3];return e[t]=a*_+u*h+l*p-c*d,e[t+1]=l*_+u*d+c*h-a*p,e[t+2]=c*_+u*p+a*d-l*h,e[t+3]=u*_-a*h-l*d-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),p=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*p*_,this._y=c*p*h-d*u*_,this._z=c*u*_+d*p*h,this._w=c*u*h-d*p*_;break;case"YXZ":this._x=d*u*h+c*p*_,this._y=c*p*h-d*u*_,this._z=c*u*_-d*p*h,this._w=c*u*h+d*p*_;break;case"ZXY":this._x=d*u*h-c*p*_,this._y=c*p*h+d*u*_,this._z=c*u*_+d*p*h,this._w=c*u*h-d*p*_;break;case"ZYX":this._x=d*u*h-c*p*_,this._y=c*p*h+d*u*_,this._z=c*u*_-d*p*h,this._w=c*u*h+d*p*_;break;case"YZX":this._x=d*u*h+c*p*_,this._y=c*p*h+d*u*_,this._z=c*u*_-d*p*h,this._w=c*u*h-d*p*_;break;case"XZY":this._x=d*u*h-c*p*_,this._y=c*p*h-d*u*_,this._z=c*u*_+d*p*h,this._w=c*u*h+d*p*_;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>h){let p=2*Math.sqrt(1+i-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-i-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(j_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(j_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Zd.copy(this).projectOnVector(e),this.sub(Zd)}reflect(e){return this.sub(Zd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Zd=new K,j_=new Mi,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],p=i[5],_=i[8],x=s[0],g=s[3],m=s[6],b=s[1],A=s[4],S=s[7],P=s[2],C=s[5],v=s[8];return r[0]=o*x+a*b+l*P,r[3]=o*g+a*A+l*C,r[6]=o*m+a*S+l*v,r[1]=c*x+u*b+h*P,r[4]=c*g+u*A+h*C,r[7]=c*m+u*S+h*v,r[2]=d*x+p*b+_*P,r[5]=d*g+p*A+_*C,r[8]=d*m+p*S+_*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,p=c*r-o*l,_=t*h+i*d+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/_;return e[0]=h*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=p*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return yl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Jd.makeScale(e,t)),this}rotate(e){return yl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Jd.makeRotation(-e)),this}translate(e,t){return yl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Jd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Jd=new nt,Q_=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ev=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Z1(){let n={enabled:!0,workingColorSpace:Ml,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=qs(s.r),s.g=qs(s.g),s.b=qs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=ha(s.r),s.g=ha(s.g),s.b=ha(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Js?wl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ml]:{primaries:e,whitePoint:i,transfer:wl,toXYZ:Q_,fromXYZ:ev,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:bi},outputColorSpaceConfig:{drawingBufferColorSpace:bi}},[bi]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:Q_,fromXYZ:ev,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:bi}}}),n}var xt=Z1();function qs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ha(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var jo,ku=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{jo===void 0&&(jo=El("canvas")),jo.width=e.width,jo.height=e.height;let s=jo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=jo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=El("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=qs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(qs(t[i]/255)*255):t[i]=qs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},J1=0,ma=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:J1++}),this.uuid=Ea(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(jd(s[o].image)):r.push(jd(s[o]))}else r=jd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function jd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?ku.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var j1=0,Qd=new K,ci=class n extends ji{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=bs,s=bs,r=qn,o=Ks,a=ns,l=Ci,c=n.DEFAULT_ANISOTROPY,u=Js){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:j1++}),this.uuid=Ea(),this.name="",this.source=new ma(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Qd).x}get height(){return this.source.getSize(Qd).y}get depth(){return this.source.getSize(Qd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Fp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Uu:e.x=e.x-Math.floor(e.x);break;case bs:e.x=e.x<0?0:1;break;case Fu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Uu:e.y=e.y-Math.floor(e.y);break;case bs:e.y=e.y<0?0:1;break;case Fu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ci.DEFAULT_IMAGE=null;ci.DEFAULT_MAPPING=Fp;ci.DEFAULT_ANISOTROPY=1;var on=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],p=l[5],_=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(_-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(_+g)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(p+1)/2,P=(m+1)/2,C=(u+d)/4,v=(h+x)/4,E=(_+g)/4;return A>S&&A>P?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=C/i,r=v/i):S>P?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=C/s,r=E/s):P<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),i=v/r,s=E/r),this.set(i,s,r,t),this}let b=Math.sqrt((g-_)*(g-_)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(b)<.001&&(b=1),this.x=(g-_)/b,this.y=(h-x)/b,this.z=(d-u)/b,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Bu=class extends ji{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new on(0,0,e,t),this.scissorTest=!1,this.viewport=new on(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ci({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ma(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wi=class extends Bu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Al=class extends ci{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Hn,this.minFilter=Hn,this.wrapR=bs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var zu=class extends ci{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Hn,this.minFilter=Hn,this.wrapR=bs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var rn=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,p,_,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,p,_,x,g)}set(e,t,i,s,r,o,a,l,c,u,h,d,p,_,x,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=p,m[7]=_,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Qo.setFromMatrixColumn(e,0).length(),r=1/Qo.setFromMatrixColumn(e,1).length(),o=1/Qo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,p=o*h,_=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+_*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=_+p*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,p=l*h,_=c*u,x=c*h;t[0]=d+x*a,t[4]=_*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-_,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,p=l*h,_=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=_+p*a,t[1]=p+_*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,p=o*h,_=a*u,x=a*h;t[0]=l*u,t[4]=_*c-p,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=p*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,p=o*c,_=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=_*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+_,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,p=o*c,_=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=p*h-_,t[2]=_*h-p,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Q1,e,eT)}lookAt(e,t,i){let s=this.elements;return yi.subVectors(e,t),yi.lengthSq()===0&&(yi.z=1),yi.normalize(),yr.crossVectors(i,yi),yr.lengthSq()===0&&(Math.abs(i.z)===1?yi.x+=1e-4:yi.z+=1e-4,yi.normalize(),yr.crossVectors(i,yi)),yr.normalize(),su.crossVectors(yi,yr),s[0]=yr.x,s[4]=su.x,s[8]=yi.x,s[1]=yr.y,s[5]=su.y,s[9]=yi.y,s[2]=yr.z,s[6]=su.z,s[10]=yi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],p=i[13],_=i[2],x=i[6],g=i[10],m=i[14],b=i[3],A=i[7],S=i[11],P=i[15],C=s[0],v=s[4],E=s[8],k=s[12],N=s[1],L=s[5],B=s[9],V=s[13],U=s[2],H=s[6],Y=s[10],G=s[14],le=s[3],J=s[7],Q=s[11],se=s[15];return r[0]=o*C+a*N+l*U+c*le,r[4]=o*v+a*L+l*H+c*J,r[8]=o*E+a*B+l*Y+c*Q,r[12]=o*k+a*V+l*G+c*se,r[1]=u*C+h*N+d*U+p*le,r[5]=u*v+h*L+d*H+p*J,r[9]=u*E+h*B+d*Y+p*Q,r[13]=u*k+h*V+d*G+p*se,r[2]=_*C+x*N+g*U+m*le,r[6]=_*v+x*L+g*H+m*J,r[10]=_*E+x*B+g*Y+m*Q,r[14]=_*k+x*V+g*G+m*se,r[3]=b*C+A*N+S*U+P*le,r[7]=b*v+A*L+S*H+P*J,r[11]=b*E+A*B+S*Y+P*Q,r[15]=b*k+A*V+S*G+P*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],p=e[14],_=e[3],x=e[7],g=e[11],m=e[15],b=l*p-c*d,A=a*p-c*h,S=a*d-l*h,P=o*p-c*u,C=o*d-l*u,v=o*h-a*u;return t*(x*b-g*A+m*S)-i*(_*b-g*P+m*C)+s*(_*A-x*P+m*v)-r*(_*S-x*C+g*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],p=e[11],_=e[12],x=e[13],g=e[14],m=e[15],b=t*a-i*o,A=t*l-s*o,S=t*c-r*o,P=i*l-s*a,C=i*c-r*a,v=s*c-r*l,E=u*x-h*_,k=u*g-d*_,N=u*m-p*_,L=h*g-d*x,B=h*m-p*x,V=d*m-p*g,U=b*V-A*B+S*L+P*N-C*k+v*E;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/U;return e[0]=(a*V-l*B+c*L)*H,e[1]=(s*B-i*V-r*L)*H,e[2]=(x*v-g*C+m*P)*H,e[3]=(d*C-h*v-p*P)*H,e[4]=(l*N-o*V-c*k)*H,e[5]=(t*V-s*N+r*k)*H,e[6]=(g*S-_*v-m*A)*H,e[7]=(u*v-d*S+p*A)*H,e[8]=(o*B-a*N+c*E)*H,e[9]=(i*N-t*B-r*E)*H,e[10]=(_*C-x*S+m*b)*H,e[11]=(h*S-u*C-p*b)*H,e[12]=(a*k-o*L-l*E)*H,e[13]=(t*L-i*k+s*E)*H,e[14]=(x*A-_*P-g*b)*H,e[15]=(u*P-h*A+d*b)*H,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,p=r*u,_=r*h,x=o*u,g=o*h,m=a*h,b=l*c,A=l*u,S=l*h,P=i.x,C=i.y,v=i.z;return s[0]=(1-(x+m))*P,s[1]=(p+S)*P,s[2]=(_-A)*P,s[3]=0,s[4]=(p-S)*C,s[5]=(1-(d+m))*C,s[6]=(g+b)*C,s[7]=0,s[8]=(_+A)*v,s[9]=(g-b)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Qo.set(s[0],s[1],s[2]).length(),a=Qo.set(s[4],s[5],s[6]).length(),l=Qo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ki.copy(this);let c=1/o,u=1/a,h=1/l;return Ki.elements[0]*=c,Ki.elements[1]*=c,Ki.elements[2]*=c,Ki.elements[4]*=u,Ki.elements[5]*=u,Ki.elements[6]*=u,Ki.elements[8]*=h,Ki.elements[9]*=h,Ki.elements[10]*=h,t.setFromRotationMatrix(Ki),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ui,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),p=(i+s)/(i-s),_,x;if(l)_=r/(o-r),x=o*r/(o-r);else if(a===Ui)_=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Tl)_=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ui,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),p=-(i+s)/(i-s),_,x;if(l)_=1/(o-r),x=o/(o-r);else if(a===Ui)_=-2/(o-r),x=-(o+r)/(o-r);else if(a===Tl)_=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Qo=new K,Ki=new rn,Q1=new K(0,0,0),eT=new K(1,1,1),yr=new K,su=new K,yi=new K,tv=new rn,nv=new Mi,Tr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return tv.makeRotationFromQuaternion(e),this.setFromRotationMatrix(tv,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return nv.setFromEuler(this),this.setFromQuaternion(nv,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Tr.DEFAULT_ORDER="XYZ";var Cl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},tT=0,iv=new K,ea=new Mi,zs=new rn,ru=new K,pl=new K,nT=new K,iT=new Mi,sv=new K(1,0,0),rv=new K(0,1,0),ov=new K(0,0,1),av={type:"added"},sT={type:"removed"},ta={type:"childadded",child:null},ep={type:"childremoved",child:null},Ti=class n extends ji{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:tT++}),this.uuid=Ea(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new K,t=new Tr,i=new Mi,s=new K(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new rn},normalMatrix:{value:new nt}}),this.matrix=new rn,this.matrixWorld=new rn,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Cl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ea.setFromAxisAngle(e,t),this.quaternion.multiply(ea),this}rotateOnWorldAxis(e,t){return ea.setFromAxisAngle(e,t),this.quaternion.premultiply(ea),this}rotateX(e){return this.rotateOnAxis(sv,e)}rotateY(e){return this.rotateOnAxis(rv,e)}rotateZ(e){return this.rotateOnAxis(ov,e)}translateOnAxis(e,t){return iv.copy(e).applyQuaternion(this.quaternion),this.position.add(iv.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(sv,e)}translateY(e){return this.translateOnAxis(rv,e)}translateZ(e){return this.translateOnAxis(ov,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(zs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ru.copy(e):ru.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),pl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?zs.lookAt(pl,ru,this.up):zs.lookAt(ru,pl,this.up),this.quaternion.setFromRotationMatrix(zs),s&&(zs.extractRotation(s.matrixWorld),ea.setFromRotationMatrix(zs),this.quaternion.premultiply(ea.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(av),ta.child=e,this.dispatchEvent(ta),ta.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(sT),ep.child=e,this.dispatchEvent(ep),ep.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),zs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),zs.multiply(e.parent.matrixWorld)),e.applyMatrix4(zs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(av),ta.child=e,this.dispatchEvent(ta),ta.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pl,e,nT),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pl,iT,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),p=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),p.length>0&&(i.animations=p),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ti.DEFAULT_UP=new K(0,1,0);Ti.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ti.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var io=class extends Ti{constructor(){super(),this.isGroup=!0,this.type="Group"}},rT={type:"move"},ga=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new io,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new io,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new io,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let g=t.getJointPose(x,i),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),p=.02,_=.005;c.inputState.pinching&&d>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(rT)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new io;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},ay={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},xr={h:0,s:0,l:0},ou={h:0,s:0,l:0};function tp(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var bt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=bi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=Zp(e,1),t=mt(t,0,1),i=mt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=tp(o,r,e+1/3),this.g=tp(o,r,e),this.b=tp(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=bi){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=bi){let i=ay[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=qs(e.r),this.g=qs(e.g),this.b=qs(e.b),this}copyLinearToSRGB(e){return this.r=ha(e.r),this.g=ha(e.g),this.b=ha(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=bi){return xt.workingToColorSpace(Kn.copy(this),e),Math.round(mt(Kn.r*255,0,255))*65536+Math.round(mt(Kn.g*255,0,255))*256+Math.round(mt(Kn.b*255,0,255))}getHexString(e=bi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Kn.copy(this),t);let i=Kn.r,s=Kn.g,r=Kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Kn.copy(this),t),e.r=Kn.r,e.g=Kn.g,e.b=Kn.b,e}getStyle(e=bi){xt.workingToColorSpace(Kn.copy(this),e);let t=Kn.r,i=Kn.g,s=Kn.b;return e!==bi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(xr),this.setHSL(xr.h+e,xr.s+t,xr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(xr),e.getHSL(ou);let i=bl(xr.h,ou.h,t),s=bl(xr.s,ou.s,t),r=bl(xr.l,ou.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Kn=new bt;bt.NAMES=ay;var Rl=class extends Ti{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Tr,this.environmentIntensity=1,this.environmentRotation=new Tr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Zi=new K,Vs=new K,np=new K,Gs=new K,na=new K,ia=new K,lv=new K,ip=new K,sp=new K,rp=new K,op=new on,ap=new on,lp=new on,wr=class n{constructor(e=new K,t=new K,i=new K){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Zi.subVectors(e,t),s.cross(Zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Zi.subVectors(s,t),Vs.subVectors(i,t),np.subVectors(e,t);let o=Zi.dot(Zi),a=Zi.dot(Vs),l=Zi.dot(np),c=Vs.dot(Vs),u=Vs.dot(np),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,p=(c*l-a*u)*d,_=(o*u-a*l)*d;return r.set(1-p-_,_,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Gs)===null?!1:Gs.x>=0&&Gs.y>=0&&Gs.x+Gs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Gs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Gs.x),l.addScaledVector(o,Gs.y),l.addScaledVector(a,Gs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return op.setScalar(0),ap.setScalar(0),lp.setScalar(0),op.fromBufferAttribute(e,t),ap.fromBufferAttribute(e,i),lp.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(op,r.x),o.addScaledVector(ap,r.y),o.addScaledVector(lp,r.z),o}static isFrontFacing(e,t,i,s){return Zi.subVectors(i,t),Vs.subVectors(e,t),Zi.cross(Vs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Zi.subVectors(this.c,this.b),Vs.subVectors(this.a,this.b),Zi.cross(Vs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;na.subVectors(s,i),ia.subVectors(r,i),ip.subVectors(e,i);let l=na.dot(ip),c=ia.dot(ip);if(l<=0&&c<=0)return t.copy(i);sp.subVectors(e,s);let u=na.dot(sp),h=ia.dot(sp);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(na,o);rp.subVectors(e,r);let p=na.dot(rp),_=ia.dot(rp);if(_>=0&&p<=_)return t.copy(r);let x=p*c-l*_;if(x<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(i).addScaledVector(ia,a);let g=u*_-p*h;if(g<=0&&h-u>=0&&p-_>=0)return lv.subVectors(r,s),a=(h-u)/(h-u+(p-_)),t.copy(s).addScaledVector(lv,a);let m=1/(g+x+d);return o=x*m,a=d*m,t.copy(i).addScaledVector(na,o).addScaledVector(ia,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ss=class{constructor(e=new K(1/0,1/0,1/0),t=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ji.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ji.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ji.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ji):Ji.fromBufferAttribute(r,o),Ji.applyMatrix4(e.matrixWorld),this.expandByPoint(Ji);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),au.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),au.copy(i.boundingBox)),au.applyMatrix4(e.matrixWorld),this.union(au)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ji),Ji.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ml),lu.subVectors(this.max,ml),sa.subVectors(e.a,ml),ra.subVectors(e.b,ml),oa.subVectors(e.c,ml),br.subVectors(ra,sa),Sr.subVectors(oa,ra),Qr.subVectors(sa,oa);let t=[0,-br.z,br.y,0,-Sr.z,Sr.y,0,-Qr.z,Qr.y,br.z,0,-br.x,Sr.z,0,-Sr.x,Qr.z,0,-Qr.x,-br.y,br.x,0,-Sr.y,Sr.x,0,-Qr.y,Qr.x,0];return!cp(t,sa,ra,oa,lu)||(t=[1,0,0,0,1,0,0,0,1],!cp(t,sa,ra,oa,lu))?!1:(cu.crossVectors(br,Sr),t=[cu.x,cu.y,cu.z],cp(t,sa,ra,oa,lu))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ji).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ji).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Hs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Hs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Hs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Hs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Hs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Hs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Hs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Hs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Hs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Hs=[new K,new K,new K,new K,new K,new K,new K,new K],Ji=new K,au=new Ss,sa=new K,ra=new K,oa=new K,br=new K,Sr=new K,Qr=new K,ml=new K,lu=new K,cu=new K,eo=new K;function cp(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){eo.fromArray(n,r);let a=s.x*Math.abs(eo.x)+s.y*Math.abs(eo.y)+s.z*Math.abs(eo.z),l=e.dot(eo),c=t.dot(eo),u=i.dot(eo);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Tn=new K,uu=new tt,oT=0,ri=class extends ji{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:oT++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=ey,this.updateRanges=[],this.gpuType=es,this.version=0,this._normalizationScale=e!==void 0?jp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)uu.fromBufferAttribute(this,t),uu.applyMatrix3(e),this.setXY(t,uu.x,uu.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Tn.fromBufferAttribute(this,t),Tn.applyMatrix3(e),this.setXYZ(t,Tn.x,Tn.y,Tn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Tn.fromBufferAttribute(this,t),Tn.applyMatrix4(e),this.setXYZ(t,Tn.x,Tn.y,Tn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Tn.fromBufferAttribute(this,t),Tn.applyNormalMatrix(e),this.setXYZ(t,Tn.x,Tn.y,Tn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Tn.fromBufferAttribute(this,t),Tn.transformDirection(e),this.setXYZ(t,Tn.x,Tn.y,Tn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):ry(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):oy(e,this.array)}};var Pl=class extends ri{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Il=class extends ri{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var li=class extends ri{constructor(e,t,i){super(new Float32Array(e),t,i)}},aT=new Ss,gl=new K,up=new K,$s=class{constructor(e=new K,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):aT.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;gl.subVectors(e,this.center);let t=gl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(gl,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(up.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(gl.copy(e.center).add(up)),this.expandByPoint(gl.copy(e.center).sub(up))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},lT=0,Ni=new rn,hp=new Ti,aa=new K,xi=new Ss,_l=new Ss,Gn=new K,Ms=class n extends ji{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:lT++}),this.uuid=Ea(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(D1(e)?Il:Pl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ni.makeRotationFromQuaternion(e),this.applyMatrix4(Ni),this}rotateX(e){return Ni.makeRotationX(e),this.applyMatrix4(Ni),this}rotateY(e){return Ni.makeRotationY(e),this.applyMatrix4(Ni),this}rotateZ(e){return Ni.makeRotationZ(e),this.applyMatrix4(Ni),this}translate(e,t,i){return Ni.makeTranslation(e,t,i),this.applyMatrix4(Ni),this}scale(e,t,i){return Ni.makeScale(e,t,i),this.applyMatrix4(Ni),this}lookAt(e){return hp.lookAt(e),hp.updateMatrix(),this.applyMatrix4(hp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(aa).negate(),this.translate(aa.x,aa.y,aa.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new li(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ss);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];xi.setFromBufferAttribute(r),this.morphTargetsRelative?(Gn.addVectors(this.boundingBox.min,xi.min),this.boundingBox.expandByPoint(Gn),Gn.addVectors(this.boundingBox.max,xi.max),this.boundingBox.expandByPoint(Gn)):(this.boundingBox.expandByPoint(xi.min),this.boundingBox.expandByPoint(xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new $s);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(e){let i=this.boundingSphere.center;if(xi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];_l.setFromBufferAttribute(a),this.morphTargetsRelative?(Gn.addVectors(xi.min,_l.min),xi.expandByPoint(Gn),Gn.addVectors(xi.max,_l.max),xi.expandByPoint(Gn)):(xi.expandByPoint(_l.min),xi.expandByPoint(_l.max))}xi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Gn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Gn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Gn.fromBufferAttribute(a,c),l&&(aa.fromBufferAttribute(e,c),Gn.add(aa)),s=Math.max(s,i.distanceToSquared(Gn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ri(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new K,l[k]=new K;let u=new K,h=new K,d=new K,p=new tt,_=new tt,x=new tt,g=new K,m=new K;function b(k,N,L){c[k]=c[N]=c[L]=1,u.fromBufferAttribute(i,k),h.fromBufferAttribute(i,N),d.fromBufferAttribute(i,L),p.fromBufferAttribute(r,k),_.fromBufferAttribute(r,N),x.fromBufferAttribute(r,L),h.sub(u),d.sub(u),_.sub(p),x.sub(p);let B=1/(_.x*x.y-x.x*_.y);isFinite(B)&&(g.copy(h).multiplyScalar(x.y).addScaledVector(d,-_.y).multiplyScalar(B),m.copy(d).multiplyScalar(_.x).addScaledVector(h,-x.x).multiplyScalar(B),a[k].add(g),a[N].add(g),a[L].add(g),l[k].add(m),l[N].add(m),l[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let k=0,N=A.length;k<N;++k){let L=A[k],B=L.start,V=L.count;for(let U=B,H=B+V;U<H;U+=3)b(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let S=new K,P=new K,C=new K,v=new K;function E(k){C.fromBufferAttribute(s,k),v.copy(C);let N=a[k];S.copy(N),S.sub(C.multiplyScalar(C.dot(N))).normalize(),P.crossVectors(v,N);let B=P.dot(l[k])<0?-1:1;o.setXYZW(k,S.x,S.y,S.z,B)}for(let k=0,N=i.count;k<N;++k)c[k]&&E(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ri(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,p=i.count;d<p;d++)i.setXYZ(d,0,0,0);let s=new K,r=new K,o=new K,a=new K,l=new K,c=new K,u=new K,h=new K;if(e)for(let d=0,p=e.count;d<p;d+=3){let _=e.getX(d+0),x=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,p=t.count;d<p;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Gn.fromBufferAttribute(e,t),Gn.normalize(),e.setXYZ(t,Gn.x,Gn.y,Gn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),p=0,_=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*u;for(let m=0;m<u;m++)d[_++]=c[p++]}return new ri(d,u,h)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],p=e(d,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,p=h.length;d<p;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var fp=new K,cT=new K,uT=new nt,Si=class{constructor(e=new K(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=fp.subVectors(i,t).cross(cT.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(fp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||uT.getNormalMatrix(e),s=this.coplanarPoint(fp).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},hT=0,Er=class extends ji{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:hT++}),this.uuid=Ea(),this.name="",this.type="Material",this.blending=Ma,this.side=Lr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ep,this.blendDst=Ap,this.blendEquation=lo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new bt(0,0,0),this.blendAlpha=0,this.depthFunc=fa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Yv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Au,this.stencilZFail=Au,this.stencilZPass=Au,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new bt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Si().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new tt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ws=new K,dp=new K,hu=new K,fu=new K,so=class{constructor(e=new K,t=new K(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ws)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ws.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ws.copy(this.origin).addScaledVector(this.direction,t),Ws.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){dp.copy(e).add(t).multiplyScalar(.5),hu.copy(t).sub(e).normalize(),fu.copy(this.origin).sub(dp);let r=e.distanceTo(t)*.5,o=-this.direction.dot(hu),a=fu.dot(this.direction),l=-fu.dot(hu),c=fu.lengthSq(),u=Math.abs(1-o*o),h,d,p,_;if(u>0)if(h=o*l-a,d=o*a-l,_=r*u,h>=0)if(d>=-_)if(d<=_){let x=1/u;h*=x,d*=x,p=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),p=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),p=-h*h+d*(d+2*l)+c;else d<=-_?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+d*(d+2*l)+c):d<=_?(h=0,d=Math.min(Math.max(-r,-l),r),p=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),p=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(dp).addScaledVector(hu,d),p}intersectSphere(e,t){if(e.radius<0)return null;Ws.subVectors(e.center,this.origin);let i=Ws.dot(this.direction),s=Ws.dot(Ws)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Ws)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,p=e.z-o.z,_=t.x-o.x,x=t.y-o.y,g=t.z-o.z,m=i.x-o.x,b=i.y-o.y,A=i.z-o.z,S=Math.abs(l),P=Math.abs(c),C=Math.abs(u),v,E,k,N,L,B,V,U,H,Y,G,le;if(S>=P&&S>=C?(k=l,B=h,H=_,le=m,l>=0?(v=c,E=u,N=d,L=p,V=x,U=g,Y=b,G=A):(v=u,E=c,N=p,L=d,V=g,U=x,Y=A,G=b)):P>=C?(k=c,B=d,H=x,le=b,c>=0?(v=u,E=l,N=p,L=h,V=g,U=_,Y=A,G=m):(v=l,E=u,N=h,L=p,V=_,U=g,Y=m,G=A)):(k=u,B=p,H=g,le=A,u>=0?(v=l,E=c,N=h,L=d,V=_,U=x,Y=m,G=b):(v=c,E=l,N=d,L=h,V=x,U=_,Y=b,G=m)),k===0)return null;let J=v/k,Q=E/k,se=1/k,fe=N-J*B,he=L-Q*B,ee=V-J*H,me=U-Q*H,ve=Y-J*le,Ae=G-Q*le,Se=ve*me-Ae*ee,qe=fe*Ae-he*ve,rt=ee*he-me*fe;if(s){if(Se<0||qe<0||rt<0)return null}else if((Se<0||qe<0||rt<0)&&(Se>0||qe>0||rt>0))return null;let He=Se+qe+rt;if(He===0)return null;let ft=se*(Se*B+qe*H+rt*le);return(He>0?ft<0:ft>0)?null:this.at(ft/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Vu=class extends Er{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new bt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Tr,this.combine=Cp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},cv=new rn,to=new so,du=new $s,uv=new K,pu=new K,mu=new K,gu=new K,pp=new K,_u=new K,hv=new K,vu=new K,Fi=class extends Ti{constructor(e=new Ms,t=new Vu){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){_u.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(pp.fromBufferAttribute(h,e),o?_u.addScaledVector(pp,u):_u.addScaledVector(pp.sub(t),u))}t.add(_u)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),du.copy(i.boundingSphere),du.applyMatrix4(r),to.copy(e.ray).recast(e.near),!(du.containsPoint(to.origin)===!1&&(to.intersectSphere(du,uv)===null||to.origin.distanceToSquared(uv)>(e.far-e.near)**2))&&(cv.copy(r).invert(),to.copy(e.ray).applyMatrix4(cv),!(i.boundingBox!==null&&to.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,to)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,x=d.length;_<x;_++){let g=d[_],m=o[g.materialIndex],b=Math.max(g.start,p.start),A=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let S=b,P=A;S<P;S+=3){let C=a.getX(S),v=a.getX(S+1),E=a.getX(S+2);s=yu(this,m,e,i,c,u,h,C,v,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let _=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let g=_,m=x;g<m;g+=3){let b=a.getX(g),A=a.getX(g+1),S=a.getX(g+2);s=yu(this,o,e,i,c,u,h,b,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,x=d.length;_<x;_++){let g=d[_],m=o[g.materialIndex],b=Math.max(g.start,p.start),A=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let S=b,P=A;S<P;S+=3){let C=S,v=S+1,E=S+2;s=yu(this,m,e,i,c,u,h,C,v,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let _=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let g=_,m=x;g<m;g+=3){let b=g,A=g+1,S=g+2;s=yu(this,o,e,i,c,u,h,b,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function fT(n,e,t,i,s,r,o,a){let l;if(e.side===oi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Lr,a),l===null)return null;vu.copy(a),vu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(vu);return c<t.near||c>t.far?null:{distance:c,point:vu.clone(),object:n}}function yu(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,pu),n.getVertexPosition(l,mu),n.getVertexPosition(c,gu);let u=fT(n,e,t,i,pu,mu,gu,hv);if(u){let h=new K;wr.getBarycoord(hv,pu,mu,gu,h),s&&(u.uv=wr.getInterpolatedAttribute(s,a,l,c,h,new tt)),r&&(u.uv1=wr.getInterpolatedAttribute(r,a,l,c,h,new tt)),o&&(u.normal=wr.getInterpolatedAttribute(o,a,l,c,h,new K),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new K,materialIndex:0};wr.getNormal(pu,mu,gu,d.normal),u.face=d,u.barycoord=h}return u}var ro=class extends ci{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Hn,u=Hn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var _a=class extends ri{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var no=new $s,dT=new tt(.5,.5),xu=new K,oo=class{constructor(e=new Si,t=new Si,i=new Si,s=new Si,r=new Si,o=new Si){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ui,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],p=r[7],_=r[8],x=r[9],g=r[10],m=r[11],b=r[12],A=r[13],S=r[14],P=r[15];if(s[0].setComponents(c-o,p-u,m-_,P-b).normalize(),s[1].setComponents(c+o,p+u,m+_,P+b).normalize(),s[2].setComponents(c+a,p+h,m+x,P+A).normalize(),s[3].setComponents(c-a,p-h,m-x,P-A).normalize(),i)s[4].setComponents(l,d,g,S).normalize(),s[5].setComponents(c-l,p-d,m-g,P-S).normalize();else if(s[4].setComponents(c-l,p-d,m-g,P-S).normalize(),t===Ui)s[5].setComponents(c+l,p+d,m+g,P+S).normalize();else if(t===Tl)s[5].setComponents(l,d,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),no.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),no.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(no)}intersectsSprite(e){no.center.set(0,0,0);let t=dT.distanceTo(e.center);return no.radius=.7071067811865476+t,no.applyMatrix4(e.matrixWorld),this.intersectsSphere(no)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(xu.x=s.normal.x>0?e.max.x:e.min.x,xu.y=s.normal.y>0?e.max.y:e.min.y,xu.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(xu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},fv=new rn,Gu=class n{constructor(){this.coordinateSystem=Ui,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];fv.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new oo),i[s].setFromProjectionMatrix(fv,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new oo),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Hu=class extends Er{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new bt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Wu=new K,qu=new K,dv=new rn,vl=new so,bu=new $s,mp=new K,pv=new K,Xu=class extends Ti{constructor(e=new Ms,t=new Hu){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Wu.fromBufferAttribute(t,s-1),qu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Wu.distanceTo(qu);e.setAttribute("lineDistance",new li(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),bu.copy(i.boundingSphere),bu.applyMatrix4(s),bu.radius+=r,e.ray.intersectsSphere(bu)===!1)return;dv.copy(s).invert(),vl.copy(e.ray).applyMatrix4(dv);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let x=p,g=_-1;x<g;x+=c){let m=u.getX(x),b=u.getX(x+1),A=Su(this,e,vl,l,m,b,x);A&&t.push(A)}if(this.isLineLoop){let x=u.getX(_-1),g=u.getX(p),m=Su(this,e,vl,l,x,g,_-1);m&&t.push(m)}}else{let p=Math.max(0,o.start),_=Math.min(d.count,o.start+o.count);for(let x=p,g=_-1;x<g;x+=c){let m=Su(this,e,vl,l,x,x+1,x);m&&t.push(m)}if(this.isLineLoop){let x=Su(this,e,vl,l,_-1,p,_-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Su(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Wu.fromBufferAttribute(a,s),qu.fromBufferAttribute(a,r),t.distanceSqToSegment(Wu,qu,mp,pv)>i)return;mp.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(mp);if(!(c<e.near||c>e.far))return{distance:c,point:pv.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var mv=new K,gv=new K,Ll=class extends Xu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)mv.fromBufferAttribute(t,s),gv.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+mv.distanceTo(gv);e.setAttribute("lineDistance",new li(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Dl=class extends ci{constructor(e=[],t=co,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ys=class extends ci{constructor(e,t,i=Qi,s,r,o,a=Hn,l=Hn,c,u=Xs,h=1){if(u!==Xs&&u!==Zs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ma(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Nl=class extends Ys{constructor(e,t=Qi,i=co,s,r,o=Hn,a=Hn,l,c=Xs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ul=class extends ci{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},va=class n extends Ms{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,p=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new li(c,3)),this.setAttribute("normal",new li(u,3)),this.setAttribute("uv",new li(h,2));function _(x,g,m,b,A,S,P,C,v,E,k){let N=S/v,L=P/E,B=S/2,V=P/2,U=C/2,H=v+1,Y=E+1,G=0,le=0,J=new K;for(let Q=0;Q<Y;Q++){let se=Q*L-V;for(let fe=0;fe<H;fe++){let he=fe*N-B;J[x]=he*b,J[g]=se*A,J[m]=U,c.push(J.x,J.y,J.z),J[x]=0,J[g]=0,J[m]=C>0?1:-1,u.push(J.x,J.y,J.z),h.push(fe/v),h.push(1-Q/E),G+=1}}for(let Q=0;Q<E;Q++)for(let se=0;se<v;se++){let fe=d+se+H*Q,he=d+se+H*(Q+1),ee=d+(se+1)+H*(Q+1),me=d+(se+1)+H*Q;l.push(fe,he,me),l.push(he,ee,me),le+=6}a.addGroup(p,le,k),p+=le,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Fl=class n extends Ms{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,p=[],_=[],x=[],g=[];for(let m=0;m<u;m++){let b=m*d-o;for(let A=0;A<c;A++){let S=A*h-r;_.push(S,-b,0),x.push(0,0,1),g.push(A/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let b=0;b<a;b++){let A=b+c*m,S=b+c*(m+1),P=b+1+c*(m+1),C=b+1+c*m;p.push(A,S,C),p.push(S,P,C)}this.setIndex(p),this.setAttribute("position",new li(_,3)),this.setAttribute("normal",new li(x,3)),this.setAttribute("uv",new li(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function ho(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(_v(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(_v(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Zn(n){let e={};for(let t=0;t<n.length;t++){let i=ho(n[t]);for(let s in i)e[s]=i[s]}return e}function _v(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function pT(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function em(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var ly={clone:ho,merge:Zn},mT=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,gT=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ei=class extends Er{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=mT,this.fragmentShader=gT,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ho(e.uniforms),this.uniformsGroups=pT(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new bt().setHex(s.value);break;case"v2":this.uniforms[i].value=new tt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new K().fromArray(s.value);break;case"v4":this.uniforms[i].value=new on().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new rn().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},$u=class extends Ei{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Yu=class extends Er{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Xv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ku=class extends Er{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function la(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Mu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ar=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Zu=class extends Ar{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:_p,endingEnd:_p}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case vp:r=e,a=2*t-i;break;case yp:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case vp:o=e,l=2*i-t;break;case yp:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,p=this._weightNext,_=(i-t)/(s-t),x=_*_,g=x*_,m=-d*g+2*d*x-d*_,b=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*_+1,A=(-1-p)*g+(1.5+p)*x+.5*_,S=p*g-p*x;for(let P=0;P!==a;++P)r[P]=m*o[u+P]+b*o[c+P]+A*o[l+P]+S*o[h+P];return r}},Ju=class extends Ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},ju=class extends Ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Qu=class extends Ar{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let _=(i-t)/(s-t),x=1-_;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*_;return r}let d=a*2,p=e-1;for(let _=0;_!==a;++_){let x=o[c+_],g=o[l+_],m=p*d+_*2,b=h[m],A=h[m+1],S=e*d+_*2,P=u[S],C=u[S+1],v=vT(i,t,b,P,s);r[_]=cy(v,x,A,C,g)}return r}};function cy(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function _T(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function vT(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=cy(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=_T(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ai=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=la(t,this.TimeBufferType),this.values=la(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:la(e.times,Array),values:la(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Mu(e.settings)&&(i.settings={inTangents:la(e.settings.inTangents,Array),outTangents:la(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new ju(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ju(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Zu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Qu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Sl:t=this.InterpolantFactoryMethodDiscrete;break;case Ou:t=this.InterpolantFactoryMethodLinear;break;case Eu:t=this.InterpolantFactoryMethodSmooth;break;case gp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Sl;case this.InterpolantFactoryMethodLinear:return Ou;case this.InterpolantFactoryMethodSmooth:return Eu;case this.InterpolantFactoryMethodBezier:return gp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Mu(this.settings)&&(vv(this.settings.inTangents,e),vv(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Mu(this.settings)&&(yv(this.settings.inTangents,e),yv(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&N1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Eu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,p=h+i;for(let _=0;_!==i;++_){let x=t[h+_];if(x!==t[d+_]||x!==t[p+_]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let p=0;p!==i;++p)t[d+p]=t[h+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Mu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function vv(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function yv(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ai.prototype.ValueTypeName="";Ai.prototype.TimeBufferType=Float32Array;Ai.prototype.ValueBufferType=Float32Array;Ai.prototype.DefaultInterpolation=Ou;var Cr=class extends Ai{constructor(e,t,i){super(e,t,i)}};Cr.prototype.ValueTypeName="bool";Cr.prototype.ValueBufferType=Array;Cr.prototype.DefaultInterpolation=Sl;Cr.prototype.InterpolantFactoryMethodLinear=void 0;Cr.prototype.InterpolantFactoryMethodSmooth=void 0;var eh=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};eh.prototype.ValueTypeName="color";var th=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};th.prototype.ValueTypeName="number";var nh=class extends Ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Mi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ol=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new nh(this.times,this.values,this.getValueSize(),e)}};Ol.prototype.ValueTypeName="quaternion";Ol.prototype.InterpolantFactoryMethodSmooth=void 0;var Rr=class extends Ai{constructor(e,t,i){super(e,t,i)}};Rr.prototype.ValueTypeName="string";Rr.prototype.ValueBufferType=Array;Rr.prototype.DefaultInterpolation=Sl;Rr.prototype.InterpolantFactoryMethodLinear=void 0;Rr.prototype.InterpolantFactoryMethodSmooth=void 0;var ih=class extends Ai{constructor(e,t,i,s){super(e,t,i,s)}};ih.prototype.ValueTypeName="vector";var sh=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let p=c[h],_=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},uy=new sh,rh=class{constructor(e){this.manager=e!==void 0?e:uy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};rh.DEFAULT_MATERIAL_NAME="__DEFAULT";var wu=new K,Tu=new Mi,xs=new K,kl=class extends Ti{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new rn,this.projectionMatrix=new rn,this.projectionMatrixInverse=new rn,this.coordinateSystem=Ui,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(wu,Tu,xs),xs.x===1&&xs.y===1&&xs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wu,Tu,xs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(wu,Tu,xs),xs.x===1&&xs.y===1&&xs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wu,Tu,xs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Mr=new K,xv=new tt,bv=new tt,si=class extends kl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=pa*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(xl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return pa*2*Math.atan(Math.tan(xl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Mr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Mr.x,Mr.y).multiplyScalar(-e/Mr.z),Mr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Mr.x,Mr.y).multiplyScalar(-e/Mr.z)}getViewSize(e,t){return this.getViewBounds(e,xv,bv),t.subVectors(bv,xv)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(xl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var oh=class extends kl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var ya=class extends Ms{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var ca=-90,ua=1,xa=class extends Ti{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new si(ca,ua,e,t);s.layers=this.layers,this.add(s);let r=new si(ca,ua,e,t);r.layers=this.layers,this.add(r);let o=new si(ca,ua,e,t);o.layers=this.layers,this.add(o);let a=new si(ca,ua,e,t);a.layers=this.layers,this.add(a);let l=new si(ca,ua,e,t);l.layers=this.layers,this.add(l);let c=new si(ca,ua,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ui)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Tl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,p),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},ah=class extends si{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var tm="\\[\\]\\.:\\/",yT=new RegExp("["+tm+"]","g"),nm="[^"+tm+"]",xT="[^"+tm.replace("\\.","")+"]",bT=/((?:WC+[\/:])*)/.source.replace("WC",nm),ST=/(WCOD+)?/.source.replace("WCOD",xT),MT=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",nm),wT=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",nm),TT=new RegExp("^"+bT+ST+MT+wT+"$"),ET=["material","materials","bones","map"],xp=class{constructor(e,t,i){let s=i||Qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Qt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(yT,"")}static parseTrackName(e){let t=TT.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);ET.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Qt.Composite=xp;Qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Qt.prototype.GetterByBindingType=[Qt.prototype._getValue_direct,Qt.prototype._getValue_array,Qt.prototype._getValue_arrayElement,Qt.prototype._getValue_toArray];Qt.prototype.SetterByBindingTypeAndVersioning=[[Qt.prototype._setValue_direct,Qt.prototype._setValue_direct_setNeedsUpdate,Qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_array,Qt.prototype._setValue_array_setNeedsUpdate,Qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_arrayElement,Qt.prototype._setValue_arrayElement_setNeedsUpdate,Qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_fromArray,Qt.prototype._setValue_fromArray_setNeedsUpdate,Qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var vD=new Float32Array(1);var ba=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var bp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Bl=class extends ji{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function im(n,e,t,i){let s=AT(i);switch(t){case Vp:return n*e;case Hp:return n*e/s.components*s.byteLength;case ph:return n*e/s.components*s.byteLength;case Dr:return n*e*2/s.components*s.byteLength;case mh:return n*e*2/s.components*s.byteLength;case Gp:return n*e*3/s.components*s.byteLength;case ns:return n*e*4/s.components*s.byteLength;case gh:return n*e*4/s.components*s.byteLength;case Gl:case Hl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Wl:case ql:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case vh:case xh:return Math.max(n,16)*Math.max(e,8)/4;case _h:case yh:return Math.max(n,8)*Math.max(e,8)/2;case bh:case Sh:case wh:case Th:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Mh:case Xl:case Eh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ah:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ch:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Rh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Ph:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ih:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Lh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Dh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Nh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Uh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Fh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Oh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case kh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Bh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case zh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Vh:case Gh:case Hh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Wh:case qh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case $l:case Xh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function AT(n){switch(n){case Ci:case Op:return{byteLength:1,components:1};case Ta:case kp:case ts:return{byteLength:2,components:1};case fh:case dh:return{byteLength:2,components:4};case Qi:case hh:case es:return{byteLength:4,components:1};case Bp:case zp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ly(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function RT(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((p,_)=>p.start-_.start);let d=0;for(let p=1;p<h.length;p++){let _=h[d],x=h[p];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++d,h[d]=x)}h.length=d+1;for(let p=0,_=h.length;p<_;p++){let x=h[p];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var PT=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,IT=`#ifdef USE_ALPHAHASH
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
#endif`,LT=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,DT=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,NT=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,UT=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,FT=`#ifdef USE_AOMAP
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
#endif`,OT=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kT=`#ifdef USE_BATCHING
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
#endif`,BT=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,zT=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,VT=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,GT=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,HT=`#ifdef USE_IRIDESCENCE
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
#endif`,WT=`#ifdef USE_BUMPMAP
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
#endif`,qT=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,XT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,$T=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,YT=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,KT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ZT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,JT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,jT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,QT=`#define PI 3.141592653589793
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
} // validated`,eE=`vec3 transformedNormal = objectNormal;
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
#endif`,tE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,nE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,iE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,sE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,rE="gl_FragColor = linearToOutputTexel( gl_FragColor );",oE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,aE=`#ifdef USE_ENVMAP
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
#endif`,lE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,cE=`#ifdef USE_ENVMAP
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
#endif`,uE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,hE=`#ifdef USE_ENVMAP
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
#endif`,fE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,dE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,pE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,mE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gE=`#ifdef USE_GRADIENTMAP
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
}`,_E=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,yE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,xE=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,bE=`#ifdef USE_ENVMAP
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
#endif`,SE=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ME=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,wE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,TE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,EE=`PhysicalMaterial material;
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
#endif`,AE=`uniform sampler2D dfgLUT;
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
}`,CE=`
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
#endif`,RE=`#if defined( RE_IndirectDiffuse )
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
#endif`,PE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,IE=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,LE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,DE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,NE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,UE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,FE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,OE=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,BE=`#if defined( USE_POINTS_UV )
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
#endif`,zE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,VE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,GE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,HE=`#if defined( USE_MORPHCOLORS )
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
#endif`,WE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qE=`#ifdef USE_MORPHTARGETS
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
#endif`,XE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$E=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,YE=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,KE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ZE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,JE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,jE=`#ifdef USE_NORMALMAP
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
#endif`,QE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,eA=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,tA=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,nA=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,iA=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,sA=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,rA=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,oA=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,aA=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,lA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,cA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,hA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,dA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,pA=`float getShadowMask() {
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
}`,mA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,gA=`#ifdef USE_SKINNING
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
#endif`,_A=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vA=`#ifdef USE_SKINNING
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
#endif`,yA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,xA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,bA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,SA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,MA=`#ifdef USE_TRANSMISSION
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
#endif`,wA=`#ifdef USE_TRANSMISSION
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
#endif`,TA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,EA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,AA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,CA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,RA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,PA=`uniform sampler2D t2D;
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
}`,IA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,LA=`uniform float backgroundBlurriness;
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
}`,DA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UA=`#include <common>
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
}`,FA=`#if DEPTH_PACKING == 3200
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
}`,OA=`#define DISTANCE
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
}`,kA=`#define DISTANCE
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
}`,BA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,zA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VA=`uniform float scale;
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
}`,GA=`uniform vec3 diffuse;
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
}`,HA=`#include <common>
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
}`,WA=`uniform vec3 diffuse;
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
}`,qA=`#define LAMBERT
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
}`,XA=`#define LAMBERT
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
}`,$A=`#define MATCAP
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
}`,YA=`#define MATCAP
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
}`,KA=`#define NORMAL
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
}`,ZA=`#define NORMAL
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
}`,JA=`#define PHONG
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
}`,jA=`#define PHONG
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
}`,QA=`#define STANDARD
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
}`,eC=`#define STANDARD
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
}`,tC=`#define TOON
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
}`,nC=`#define TOON
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
}`,iC=`uniform float size;
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
}`,sC=`uniform vec3 diffuse;
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
}`,rC=`#include <common>
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
}`,oC=`uniform vec3 color;
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
}`,aC=`uniform float rotation;
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
}`,lC=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:PT,alphahash_pars_fragment:IT,alphamap_fragment:LT,alphamap_pars_fragment:DT,alphatest_fragment:NT,alphatest_pars_fragment:UT,aomap_fragment:FT,aomap_pars_fragment:OT,batching_pars_vertex:kT,batching_vertex:BT,begin_vertex:zT,beginnormal_vertex:VT,bsdfs:GT,iridescence_fragment:HT,bumpmap_pars_fragment:WT,clipping_planes_fragment:qT,clipping_planes_pars_fragment:XT,clipping_planes_pars_vertex:$T,clipping_planes_vertex:YT,color_fragment:KT,color_pars_fragment:ZT,color_pars_vertex:JT,color_vertex:jT,common:QT,defaultnormal_vertex:eE,displacementmap_pars_vertex:tE,displacementmap_vertex:nE,emissivemap_fragment:iE,emissivemap_pars_fragment:sE,colorspace_fragment:rE,colorspace_pars_fragment:oE,envmap_fragment:aE,envmap_common_pars_fragment:lE,envmap_pars_fragment:cE,envmap_pars_vertex:uE,envmap_physical_pars_fragment:bE,envmap_vertex:hE,fog_vertex:fE,fog_pars_vertex:dE,fog_fragment:pE,fog_pars_fragment:mE,gradientmap_pars_fragment:gE,lightmap_pars_fragment:_E,lights_lambert_fragment:vE,lights_lambert_pars_fragment:yE,lights_pars_begin:xE,lights_toon_fragment:SE,lights_toon_pars_fragment:ME,lights_phong_fragment:wE,lights_phong_pars_fragment:TE,lights_physical_fragment:EE,lights_physical_pars_fragment:AE,lights_fragment_begin:CE,lights_fragment_maps:RE,lights_fragment_end:PE,lightprobes_pars_fragment:IE,logdepthbuf_fragment:LE,logdepthbuf_pars_fragment:DE,logdepthbuf_pars_vertex:NE,logdepthbuf_vertex:UE,map_fragment:FE,map_pars_fragment:OE,map_particle_fragment:kE,map_particle_pars_fragment:BE,metalnessmap_fragment:zE,metalnessmap_pars_fragment:VE,morphinstance_vertex:GE,morphcolor_vertex:HE,morphnormal_vertex:WE,morphtarget_pars_vertex:qE,morphtarget_vertex:XE,normal_fragment_begin:$E,normal_fragment_maps:YE,normal_pars_fragment:KE,normal_pars_vertex:ZE,normal_vertex:JE,normalmap_pars_fragment:jE,clearcoat_normal_fragment_begin:QE,clearcoat_normal_fragment_maps:eA,clearcoat_pars_fragment:tA,iridescence_pars_fragment:nA,opaque_fragment:iA,packing:sA,premultiplied_alpha_fragment:rA,project_vertex:oA,dithering_fragment:aA,dithering_pars_fragment:lA,roughnessmap_fragment:cA,roughnessmap_pars_fragment:uA,shadowmap_pars_fragment:hA,shadowmap_pars_vertex:fA,shadowmap_vertex:dA,shadowmask_pars_fragment:pA,skinbase_vertex:mA,skinning_pars_vertex:gA,skinning_vertex:_A,skinnormal_vertex:vA,specularmap_fragment:yA,specularmap_pars_fragment:xA,tonemapping_fragment:bA,tonemapping_pars_fragment:SA,transmission_fragment:MA,transmission_pars_fragment:wA,uv_pars_fragment:TA,uv_pars_vertex:EA,uv_vertex:AA,worldpos_vertex:CA,background_vert:RA,background_frag:PA,backgroundCube_vert:IA,backgroundCube_frag:LA,cube_vert:DA,cube_frag:NA,depth_vert:UA,depth_frag:FA,distance_vert:OA,distance_frag:kA,equirect_vert:BA,equirect_frag:zA,linedashed_vert:VA,linedashed_frag:GA,meshbasic_vert:HA,meshbasic_frag:WA,meshlambert_vert:qA,meshlambert_frag:XA,meshmatcap_vert:$A,meshmatcap_frag:YA,meshnormal_vert:KA,meshnormal_frag:ZA,meshphong_vert:JA,meshphong_frag:jA,meshphysical_vert:QA,meshphysical_frag:eC,meshtoon_vert:tC,meshtoon_frag:nC,points_vert:iC,points_frag:sC,shadow_vert:rC,shadow_frag:oC,sprite_vert:aC,sprite_frag:lC},De={common:{diffuse:{value:new bt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new bt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new bt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new bt(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},Es={basic:{uniforms:Zn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Zn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new bt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Zn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new bt(0)},specular:{value:new bt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Zn([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new bt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Zn([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new bt(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Zn([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Zn([De.points,De.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Zn([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Zn([De.common,De.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Zn([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Zn([De.sprite,De.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Zn([De.common,De.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Zn([De.lights,De.fog,{color:{value:new bt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};Es.physical={uniforms:Zn([Es.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new bt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new bt(0)},specularColor:{value:new bt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var $h={r:0,b:0,g:0},cC=new rn,Dy=new nt;Dy.set(-1,0,0,0,1,0,0,0,1);function uC(n,e,t,i,s,r){let o=new bt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function p(b){let A=b.isScene===!0?b.background:null;if(A&&A.isTexture){let S=b.backgroundBlurriness>0;A=e.get(A,S)}return A}function _(b){let A=!1,S=p(b);S===null?g(o,a):S&&S.isColor&&(g(S,1),A=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(b,A){let S=p(A);S&&S.isCubeTexture?(c===void 0&&(c=new Fi(new va(1,1,1),new Ei({name:"BackgroundCubeMaterial",uniforms:ho(Es.backgroundCube.uniforms),vertexShader:Es.backgroundCube.vertexShader,fragmentShader:Es.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(cC.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Dy),c.material.toneMapped=xt.getTransfer(S.colorSpace)!==Dt,(u!==S||h!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Fi(new Fl(2,2),new Ei({name:"BackgroundMaterial",uniforms:ho(Es.background.uniforms),vertexShader:Es.background.vertexShader,fragmentShader:Es.background.fragmentShader,side:Lr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=xt.getTransfer(S.colorSpace)!==Dt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function g(b,A){b.getRGB($h,em(n)),t.buffers.color.setClear($h.r,$h.g,$h.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,A=1){o.set(b),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,g(o,a)},render:_,addToRenderList:x,dispose:m}}function hC(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(L,B,V,U,H){let Y=!1,G=h(L,U,V,B);r!==G&&(r=G,c(r.object)),Y=p(L,U,V,H),Y&&_(L,U,V,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(L,B,V,U),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,B,V,U){let H=U.wireframe===!0,Y=i[B.id];Y===void 0&&(Y={},i[B.id]=Y);let G=L.isInstancedMesh===!0?L.id:0,le=Y[G];le===void 0&&(le={},Y[G]=le);let J=le[V.id];J===void 0&&(J={},le[V.id]=J);let Q=J[H];return Q===void 0&&(Q=d(l()),J[H]=Q),Q}function d(L){let B=[],V=[],U=[];for(let H=0;H<t;H++)B[H]=0,V[H]=0,U[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:U,object:L,attributes:{},index:null}}function p(L,B,V,U){let H=r.attributes,Y=B.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let se=H[J],fe=Y[J];if(fe===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;G++}return r.attributesNum!==G||r.index!==U}function _(L,B,V,U){let H={},Y=B.attributes,G=0,le=V.getAttributes();for(let J in le)if(le[J].location>=0){let se=Y[J];se===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[J]=fe,G++}r.attributes=H,r.attributesNum=G,r.index=U}function x(){let L=r.newAttributes;for(let B=0,V=L.length;B<V;B++)L[B]=0}function g(L){m(L,0)}function m(L,B){let V=r.newAttributes,U=r.enabledAttributes,H=r.attributeDivisors;V[L]=1,U[L]===0&&(n.enableVertexAttribArray(L),U[L]=1),H[L]!==B&&(n.vertexAttribDivisor(L,B),H[L]=B)}function b(){let L=r.newAttributes,B=r.enabledAttributes;for(let V=0,U=B.length;V<U;V++)B[V]!==L[V]&&(n.disableVertexAttribArray(V),B[V]=0)}function A(L,B,V,U,H,Y,G){G===!0?n.vertexAttribIPointer(L,B,V,H,Y):n.vertexAttribPointer(L,B,V,U,H,Y)}function S(L,B,V,U){x();let H=U.attributes,Y=V.getAttributes(),G=B.defaultAttributeValues;for(let le in Y){let J=Y[le];if(J.location>=0){let Q=H[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let se=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ve=he.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===hh;if(Q.isInterleavedBufferAttribute){let Se=Q.data,qe=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,rt=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let He=0;He<J.locationSize;He++)m(J.location+He,Se.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let He=0;He<J.locationSize;He++)g(J.location+He);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let He=0;He<J.locationSize;He++)A(J.location+He,fe/J.locationSize,me,se,qe*ve,(rt+fe/J.locationSize*He)*ve,Ae)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<J.locationSize;Se++)m(J.location+Se,Q.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<J.locationSize;Se++)g(J.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<J.locationSize;Se++)A(J.location+Se,fe/J.locationSize,me,se,fe*ve,fe/J.locationSize*Se*ve,Ae)}}else if(G!==void 0){let se=G[le];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(J.location,se);break;case 3:n.vertexAttrib3fv(J.location,se);break;case 4:n.vertexAttrib4fv(J.location,se);break;default:n.vertexAttrib1fv(J.location,se)}}}}b()}function P(){k();for(let L in i){let B=i[L];for(let V in B){let U=B[V];for(let H in U){let Y=U[H];for(let G in Y)u(Y[G].object),delete Y[G];delete U[H]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let B=i[L.id];for(let V in B){let U=B[V];for(let H in U){let Y=U[H];for(let G in Y)u(Y[G].object),delete Y[G];delete U[H]}}delete i[L.id]}function v(L){for(let B in i){let V=i[B];for(let U in V){let H=V[U];if(H[L.id]===void 0)continue;let Y=H[L.id];for(let G in Y)u(Y[G].object),delete Y[G];delete H[L.id]}}}function E(L){for(let B in i){let V=i[B],U=L.isInstancedMesh===!0?L.id:0,H=V[U];if(H!==void 0){for(let Y in H){let G=H[Y];for(let le in G)u(G[le].object),delete G[le];delete H[Y]}delete V[U],Object.keys(V).length===0&&delete i[B]}}}function k(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:N,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:g,disableUnusedAttributes:b}}function fC(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let p=0;p<u;p++)d+=c[p];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function dC(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==ns&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===ts&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Ci&&v!==es&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:p,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:b,maxVaryings:A,maxFragmentUniforms:S,maxSamples:P,samples:C}}function pC(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Si,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let p=h.length!==0||d||i!==0||s;return s=d,i=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,p){let _=h.clippingPlanes,x=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||_===null||_.length===0||r&&!g)r?u(null):c();else{let b=r?0:i,A=b*4,S=m.clippingState||null;l.value=S,S=u(_,d,A,p);for(let P=0;P!==A;++P)S[P]=t[P];m.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,p,_){let x=h!==null?h.length:0,g=null;if(x!==0){if(g=l.value,_!==!0||g===null){let m=p+x*4,b=d.matrixWorldInverse;a.getNormalMatrix(b),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,S=p;A!==x;++A,S+=4)o.copy(h[A]).applyMatrix4(b,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,g}}var Zl=class extends wi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Dl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new va(5,5,5),r=new Ei({name:"CubemapFromEquirect",uniforms:ho(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:ao});r.uniforms.tEquirect.value=t;let o=new Fi(s,r),a=t.minFilter;return t.minFilter===Ks&&(t.minFilter=qn),new xa(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},hy=256,mC=3,gC=20,Ny=256,Uy=16,_C=3,vC=new K,yC=new bt,Kh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xa(1,10,null),this._boxMesh=new Fi(new va(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=vC}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,p=l.autoClearDepth,_=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(yC));let g=new xa(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=p,l.autoClearStencil=_,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=py(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=dy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(hy,Jp(e))}_fromTexture(e,t){e.mapping===co||e.mapping===wa?this._setSize(e.image.length===0?hy:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=fy(e,!1,!1),i=Math.log2(e)-mC;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=fy(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===co||e.mapping===wa?(this._cubemapMaterial===null&&(this._cubemapMaterial=py()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=dy()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=xC(),this._integrationMaterial=bC());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Uy);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-_C)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Ny*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=SC());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function fy(n,e,t){return new Zl(n,{minFilter:Ks,generateMipmaps:e,type:ts,colorSpace:Ml,depthBuffer:t})}function Jl(n,e,t){return new Ei({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:oi,blending:ao,depthTest:!1,depthWrite:!1})}function xC(){return Jl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ny}u

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
	`)}function bC(){return Jl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Uy}},`

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
	`)}function SC(){return Jl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${gC}
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
	`)}function dy(){return Jl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function py(){return Jl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function MC(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,p=!1){return d==null?null:p?o(d):r(d)}function r(d){if(d&&d.isTexture){let p=d.mapping;if(p===lh||p===ch)if(e.has(d)){let _=e.get(d).texture;return a(_,d.mapping)}else{let _=d.image;if(_&&_.height>0){let x=new Zl(_.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let p=d.mapping,_=p===lh||p===ch,x=p===co||p===wa;if(_||x){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new Kh(n)),g=_?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let b=d.image;return _&&b&&b.height>0||x&&b&&l(b)?(i===null&&(i=new Kh(n)),g=_?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,p){return p===lh?d.mapping=co:p===ch&&(d.mapping=wa),d}function l(d){let p=0,_=6;for(let x=0;x<_;x++)d[x]!==void 0&&p++;return p===_}function c(d){let p=d.target;p.removeEventListener("dispose",c);let _=e.get(p);_!==void 0&&(e.delete(p),_.dispose())}function u(d){let p=d.target;p.removeEventListener("dispose",u);let _=t.get(p);_!==void 0&&(t.delete(p),_.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function wC(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&yl("WebGLRenderer: "+i+" extension not supported."),s}}}function TC(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(_=>delete s[_]);function a(_){l(_.target)}function l(_){_.index!==null&&e.remove(_.index);for(let g in _.attributes)e.remove(_.attributes[g]);_.removeEventListener("dispose",a),delete s[_.id],o.unregister(_);let x=r.get(_);x&&(e.remove(x),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}function c(_,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(_){let x=_.attributes;for(let g in x)e.update(x[g],n.ARRAY_BUFFER)}function h(_){let x=_.index,g=_.attributes.position,m=0;if(g===void 0)return;let b=x!==null?x.array.length:g.array.length/3-1,A=g.count>=65535?Il:Pl,S=new A(Math.ceil(b/3)*6,1),P=S.array;if(x!==null){let v=x.array;m=x.version;for(let E=0,k=0;E<b;E+=3){let N=v[E+0],L=v[E+1],B=v[E+2];P[k++]=N,P[k++]=L,P[k++]=L,P[k++]=B,P[k++]=B,P[k++]=N}}else{m=g.version;for(let v=0,E=0;v<b;v+=3){let k=v+0,N=v+1,L=v+2;P[E++]=k,P[E++]=N,P[E++]=N,P[E++]=L,P[E++]=L,P[E++]=k}}S.version=m;let C=r.get(_);C&&e.remove(C),r.set(_,S)}function d(_){let x=r.get(_);if(x){let g=_.index;g!==null&&x.version<g.version&&h(_)}else h(_);return r.get(_)}function p(){for(let _ in s){let x=s[_].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:p}}function EC(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,p){p!==0&&(n.drawElementsInstanced(i,d,r,h*o,p),t.update(d,i,p))}function u(h,d,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,p);let x=0;for(let g=0;g<p;g++)x+=d[g];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function AC(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function CC(n,e,t){let i=new WeakMap,s=new on;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let k=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",k)};d!==void 0&&d.texture.dispose();let p=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],A=0;p===!0&&(A=1),_===!0&&(A=2),x===!0&&(A=3);let S=a.attributes.position.count*A,P=1;S>e.maxTextureSize&&(P=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*P*4*h),v=new Al(C,S,P,h);v.type=es,v.needsUpdate=!0;let E=A*4;for(let N=0;N<h;N++){let L=g[N],B=m[N],V=b[N],U=S*P*4*N;for(let H=0;H<L.count;H++){let Y=H*E;p===!0&&(s.fromBufferAttribute(L,H),C[U+Y+0]=s.x,C[U+Y+1]=s.y,C[U+Y+2]=s.z,C[U+Y+3]=0),_===!0&&(s.fromBufferAttribute(B,H),C[U+Y+4]=s.x,C[U+Y+5]=s.y,C[U+Y+6]=s.z,C[U+Y+7]=0),x===!0&&(s.fromBufferAttribute(V,H),C[U+Y+8]=s.x,C[U+Y+9]=s.y,C[U+Y+10]=s.z,C[U+Y+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:v,size:new tt(S,P)},i.set(a,d),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let _=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function RC(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var PC={[Rp]:"LINEAR_TONE_MAPPING",[Pp]:"REINHARD_TONE_MAPPING",[Ip]:"CINEON_TONE_MAPPING",[Lp]:"ACES_FILMIC_TONE_MAPPING",[Np]:"AGX_TONE_MAPPING",[Up]:"NEUTRAL_TONE_MAPPING",[Dp]:"CUSTOM_TONE_MAPPING"};function IC(n,e,t,i,s,r){let o=new wi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Ms;u.setAttribute("position",new li([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new li([0,2,0,0,2,0],2));let h=new $u({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Fi(u,h),p=new oh(-1,1,1,-1,0,1),_=null,x=null,g=!1,m,b=null,A=[],S=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let v=0;v<A.length;v++){let E=A[v];E.setSize&&E.setSize(P,C)}},this.setEffects=function(P){A=P,S=A.length>0&&A[0].isRenderPass===!0;let C=o.width,v=o.height;A.length>0&&a===null&&(a=new wi(C,v,{type:ts,depthBuffer:!1,stencilBuffer:!1}),l=new wi(C,v,{type:ts,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&A.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ys(C,v),r===!0&&(c.format=Zs,c.type=uo)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<A.length;k++){let N=A[k];N.setSize&&N.setSize(C,v),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(P,C){if(g||P.toneMapping===ws&&A.length===0)return!1;if(b=C,C!==null){let v=C.width,E=C.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return S===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=ws,!0},this.hasRenderPass=function(){return S},this.end=function(P,C){P.toneMapping=m,g=!0;let v=o,E=a;for(let k=0;k<A.length;k++){let N=A[k];N.enabled!==!1&&(N.render(P,E,v,C),N.needsSwap!==!1&&(v=E,E=E===a?l:a))}if(_!==P.outputColorSpace||x!==P.toneMapping){_=P.outputColorSpace,x=P.toneMapping,h.defines={},xt.getTransfer(_)===Dt&&(h.defines.SRGB_TRANSFER="");let k=PC[x];k&&(h.defines[k]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=v.texture,P.setRenderTarget(b),P.render(d,p),b=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Fy=new ci,Oy=new Ys(1,1),ky=new Nl(1),By=new Al,zy=new zu,Vy=new Dl,my=[],gy=[],_y=new Float32Array(16),vy=new Float32Array(9),yy=new Float32Array(4);function Ca(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=my[s];if(r===void 0&&(r=new Float32Array(s),my[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Ln(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Dn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Jh(n,e){let t=gy[e];t===void 0&&(t=new Int32Array(e),gy[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function LC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function DC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2fv(this.addr,e),Dn(t,e)}}function NC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ln(t,e))return;n.uniform3fv(this.addr,e),Dn(t,e)}}function UC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4fv(this.addr,e),Dn(t,e)}}function FC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Dn(t,e)}else{if(Ln(t,i))return;yy.set(i),n.uniformMatrix2fv(this.addr,!1,yy),Dn(t,i)}}function OC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Dn(t,e)}else{if(Ln(t,i))return;vy.set(i),n.uniformMatrix3fv(this.addr,!1,vy),Dn(t,i)}}function kC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Dn(t,e)}else{if(Ln(t,i))return;_y.set(i),n.uniformMatrix4fv(this.addr,!1,_y),Dn(t,i)}}function BC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function zC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2iv(this.addr,e),Dn(t,e)}}function VC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ln(t,e))return;n.uniform3iv(this.addr,e),Dn(t,e)}}function GC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4iv(this.addr,e),Dn(t,e)}}function HC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function WC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2uiv(this.addr,e),Dn(t,e)}}function qC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ln(t,e))return;n.uniform3uiv(this.addr,e),Dn(t,e)}}function XC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4uiv(this.addr,e),Dn(t,e)}}function jh(n){return n.version===0&&(n.compareFunction=$p,n.needsUpdate=!0),n}function $C(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=jh(Oy):r=Fy,t.setTexture2D(e||r,s)}function YC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||zy,s)}function KC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=jh(ky):r=Vy,t.setTextureCube(e||r,s)}function ZC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||By,s)}function JC(n){switch(n){case 5126:return LC;case 35664:return DC;case 35665:return NC;case 35666:return UC;case 35674:return FC;case 35675:return OC;case 35676:return kC;case 5124:case 35670:return BC;case 35667:case 35671:return zC;case 35668:case 35672:return VC;case 35669:case 35673:return GC;case 5125:return HC;case 36294:return WC;case 36295:return qC;case 36296:return XC;case 35678:case 36198:case 36298:case 36306:case 35682:return $C;case 35679:case 36299:case 36307:return YC;case 35680:case 36300:case 36308:case 36293:return KC;case 36289:case 36303:case 36311:case 36292:return ZC}}function jC(n,e){n.uniform1fv(this.addr,e)}function QC(n,e){let t=Ca(e,this.size,2);n.uniform2fv(this.addr,t)}function eR(n,e){let t=Ca(e,this.size,3);n.uniform3fv(this.addr,t)}function tR(n,e){let t=Ca(e,this.size,4);n.uniform4fv(this.addr,t)}function nR(n,e){let t=Ca(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function iR(n,e){let t=Ca(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function sR(n,e){let t=Ca(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function rR(n,e){n.uniform1iv(this.addr,e)}function oR(n,e){n.uniform2iv(this.addr,e)}function aR(n,e){n.uniform3iv(this.addr,e)}function lR(n,e){n.uniform4iv(this.addr,e)}function cR(n,e){n.uniform1uiv(this.addr,e)}function uR(n,e){n.uniform2uiv(this.addr,e)}function hR(n,e){n.uniform3uiv(this.addr,e)}function fR(n,e){n.uniform4uiv(this.addr,e)}function dR(n,e,t){let i=this.cache,s=e.length,r=Jh(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Dn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=jh(Oy):o=Fy;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function pR(n,e,t){let i=this.cache,s=e.length,r=Jh(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Dn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||zy,r[o])}function mR(n,e,t){let i=this.cache,s=e.length,r=Jh(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Dn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=jh(ky):o=Vy;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function gR(n,e,t){let i=this.cache,s=e.length,r=Jh(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Dn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||By,r[o])}function _R(n){switch(n){case 5126:return jC;case 35664:return QC;case 35665:return eR;case 35666:return tR;case 35674:return nR;case 35675:return iR;case 35676:return sR;case 5124:case 35670:return rR;case 35667:case 35671:return oR;case 35668:case 35672:return aR;case 35669:case 35673:return lR;case 5125:return cR;case 36294:return uR;case 36295:return hR;case 36296:return fR;case 35678:case 36198:case 36298:case 36306:case 35682:return dR;case 35679:case 36299:case 36307:return pR;case 35680:case 36300:case 36308:case 36293:return mR;case 36289:case 36303:case 36311:case 36292:return gR}}var om=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=JC(t.type)}},am=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=_R(t.type)}},lm=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},sm=/(\w+)(\])?(\[|\.)?/g;function xy(n,e){n.seq.push(e),n.map[e.id]=e}function vR(n,e,t){let i=n.name,s=i.length;for(sm.lastIndex=0;;){let r=sm.exec(i),o=sm.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){xy(t,c===void 0?new om(a,n,e):new am(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new lm(a),xy(t,h)),t=h}}}var Aa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);vR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function by(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var yR=37297,xR=0;function bR(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Sy=new nt;function SR(n){xt._getMatrix(Sy,xt.workingColorSpace,n);let e=`mat3( ${Sy.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case wl:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function My(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+bR(n.getShaderSource(e),a)}else return r}function MR(n,e){let t=SR(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var wR={[Rp]:"Linear",[Pp]:"Reinhard",[Ip]:"Cineon",[Lp]:"ACESFilmic",[Np]:"AgX",[Up]:"Neutral",[Dp]:"Custom"};function TR(n,e){let t=wR[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Yh=new K;function ER(){xt.getLuminanceCoefficients(Yh);let n=Yh.x.toFixed(4),e=Yh.y.toFixed(4),t=Yh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function AR(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Kl).join(`
`)}function CR(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function RR(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Kl(n){return n!==""}function wy(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ty(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var PR=/^[ \t]*#include +<([\w\d./]+)>/gm;function cm(n){return n.replace(PR,IR)}function IR(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return cm(t)}var LR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ey(n){return n.replace(LR,DR)}function DR(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Ay(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var NR={[zl]:"SHADOWMAP_TYPE_PCF",[Sa]:"SHADOWMAP_TYPE_VSM"};function UR(n){return NR[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var FR={[wa]:"ENVMAP_MODE_REFRACTION"};function OR(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":FR[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kR={[Cp]:"ENVMAP_BLENDING_MULTIPLY",[Hv]:"ENVMAP_BLENDING_MIX",[Wv]:"ENVMAP_BLENDING_ADD"};function BR(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":kR[n.combine]||"ENVMAP_BLENDING_NONE"}function zR(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=UR(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=OR(t),h=BR(t),d=AR(t),p=CR(r),_=s.createProgram(),x,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Kl).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Kl).join(`
`),g.length>0&&(g+=`
`)):(x=[Ay(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Kl).join(`
`),g=[Ay(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ws?"#define TONE_MAPPING":"",t.toneMapping!==ws?ht.tonemapping_pars_fragment:"",t.toneMapping!==ws?TR("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,MR("linearToOutputTexel",t.outputColorSpace),ER(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Kl).join(`
`)),o=cm(o),o=wy(o,t),o=Ty(o,t),a=cm(a),a=wy(a,t),a=Ty(a,t),o=Ey(o),a=Ey(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",t.glslVersion===Yp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Yp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let b=m+x+o,A=m+g+a,S=by(s,s.VERTEX_SHADER,b),P=by(s,s.FRAGMENT_SHADER,A);s.attachShader(_,S),s.attachShader(_,P),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function C(N){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(_)||"",B=s.getShaderInfoLog(S)||"",V=s.getShaderInfoLog(P)||"",U=L.trim(),H=B.trim(),Y=V.trim(),G=!0,le=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,S,P);else{let J=My(s,S,"vertex"),Q=My(s,P,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+U+`
`+J+`
`+Q)}else U!==""?Ye("WebGLProgram: Program Info Log:",U):(H===""||Y==="")&&(le=!1);le&&(N.diagnostics={runnable:G,programLog:U,vertexShader:{log:H,prefix:x},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(S),s.deleteShader(P),v=new Aa(s,_),E=RR(s,_)}let v;this.getUniforms=function(){return v===void 0&&C(this),v};let E;this.getAttributes=function(){return E===void 0&&C(this),E};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(_,yR)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=xR++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=S,this.fragmentShader=P,this}var VR=0,um=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new hm(e),t.set(e,i)),i}},hm=class{constructor(e){this.id=VR++,this.code=e,this.usedTimes=0}};function GR(n){return n===Dr||n===Xl||n===$l}function HR(n,e,t,i,s,r){let o=new Cl,a=new um,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(v){return l.add(v),v===0?"uv":`uv${v}`}function _(v,E,k,N,L,B){let V=N.fog,U=L.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?N.environment:null,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||H,Y),le=d[v.type],J=i.precision;v.precision!==null&&(J=i.getMaxPrecision(v.precision),J!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,se=Q!==void 0?Q.length:0,fe=0;U.morphAttributes.position!==void 0&&(fe=1),U.morphAttributes.normal!==void 0&&(fe=2),U.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ve;if(le){let Ce=Es[le];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),at=a.getFragmentShaderStage(v);a.update(v,Ce,at),me=Ce.id,ve=at.id}let Ae=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),qe=L.isInstancedMesh===!0,rt=L.isBatchedMesh===!0,He=!!v.map,ft=!!v.matcap,ct=!!G,it=ct&&G.isPMREMTexture===!0,en=!!v.aoMap,Ht=!!v.lightMap,_n=!!v.bumpMap&&v.wireframe===!1,kt=!!v.normalMap,On=!!v.displacementMap,Mt=!!v.emissiveMap,En=!!v.metalnessMap,cn=!!v.roughnessMap,vn=v.anisotropy>0,O=v.clearcoat>0,Re=v.diffuseRoughness>0,Ke=v.dispersion>0,ot=v.retroreflectivity>0,Me=v.iridescence>0,zt=v.sheen>0,Ve=v.transmission>0,$e=vn&&!!v.anisotropyMap,R=O&&!!v.clearcoatMap,M=O&&!!v.clearcoatNormalMap,q=O&&!!v.clearcoatRoughnessMap,ue=Re&&!!v.diffuseRoughnessMap,oe=Me&&!!v.iridescenceMap,_e=Me&&!!v.iridescenceThicknessMap,ye=zt&&!!v.sheenColorMap,te=zt&&!!v.sheenRoughnessMap,ie=!!v.specularMap,pe=!!v.specularColorMap,F=!!v.specularIntensityMap,re=Ve&&!!v.transmissionMap,ne=Ve&&!!v.thicknessMap,we=!!v.gradientMap,ge=!!v.alphaMap,be=v.alphaTest>0,We=!!v.alphaHash,Je=!!v.extensions,ce=ws;v.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=it?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,je={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:rt,batchingColor:rt&&L._colorsTexture!==null,instancing:qe,instancingColor:qe&&L.instanceColor!==null,instancingMorph:qe&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:He,matcap:ft,envMap:ct,envMapMode:ct&&G.mapping,envMapPMREM:it,envMapMaxLod:it?ke.length-1:null,envMapSize:it?ke[0].width:null,aoMap:en,lightMap:Ht,bumpMap:_n,normalMap:kt,displacementMap:On,emissiveMap:Mt,normalMapObjectSpace:kt&&v.normalMapType===$v,normalMapTangentSpace:kt&&v.normalMapType===Wp,packedNormalMap:kt&&v.normalMapType===Wp&&GR(v.normalMap.format),metalnessMap:En,roughnessMap:cn,anisotropy:vn,anisotropyMap:$e,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ke,retroreflection:ot,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:_e,sheen:zt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:pe,specularIntensityMap:F,transmission:Ve,transmissionMap:re,thicknessMap:ne,gradientMap:we,opaque:v.transparent===!1&&v.blending===Ma&&v.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:We,combine:v.combine,mapUv:He&&p(v.map.channel),aoMapUv:en&&p(v.aoMap.channel),lightMapUv:Ht&&p(v.lightMap.channel),bumpMapUv:_n&&p(v.bumpMap.channel),normalMapUv:kt&&p(v.normalMap.channel),displacementMapUv:On&&p(v.displacementMap.channel),emissiveMapUv:Mt&&p(v.emissiveMap.channel),metalnessMapUv:En&&p(v.metalnessMap.channel),roughnessMapUv:cn&&p(v.roughnessMap.channel),anisotropyMapUv:$e&&p(v.anisotropyMap.channel),clearcoatMapUv:R&&p(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&p(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&p(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(v.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&p(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&p(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(v.sheenRoughnessMap.channel),specularMapUv:ie&&p(v.specularMap.channel),specularColorMapUv:pe&&p(v.specularColorMap.channel),specularIntensityMapUv:F&&p(v.specularIntensityMap.channel),transmissionMapUv:re&&p(v.transmissionMap.channel),thicknessMapUv:ne&&p(v.thicknessMap.channel),alphaMapUv:ge&&p(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(kt||vn),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(He||ge),fog:!!V,useFog:v.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&kt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Se,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:B.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:He&&v.map.isVideoTexture===!0&&xt.getTransfer(v.map.colorSpace)===Dt,decodeVideoTextureEmissive:Mt&&v.emissiveMap.isVideoTexture===!0&&xt.getTransfer(v.emissiveMap.colorSpace)===Dt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Oi,flipSided:v.side===oi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&v.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function x(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let k in v.defines)E.push(k),E.push(v.defines[k]);return v.isRawShaderMaterial===!1&&(g(E,v),m(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function g(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function m(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let E=d[v.type],k;if(E){let N=Es[E];k=ly.clone(N.uniforms)}else k=v.uniforms;return k}function A(v,E){let k=u.get(E);return k!==void 0?++k.usedTimes:(k=new zR(n,E,v,s),c.push(k),u.set(E,k)),k}function S(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function P(v){a.remove(v)}function C(){a.dispose()}return{getParameters:_,getProgramCacheKey:x,getUniforms:b,acquireProgram:A,releaseProgram:S,releaseShaderCache:P,programs:c,dispose:C}}function WR(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function qR(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Cy(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Ry(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let p=0;return d.isInstancedMesh&&(p+=2),d.isSkinnedMesh&&(p+=1),p}function a(d,p,_,x,g,m){let b=n[e];return b===void 0?(b={id:d.id,object:d,geometry:p,material:_,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:m},n[e]=b):(b.id=d.id,b.object=d,b.geometry=p,b.material=_,b.materialVariant=o(d),b.groupOrder=x,b.renderOrder=d.renderOrder,b.z=g,b.group=m),e++,b}function l(d,p,_,x,g,m,b){b.reversedDepth===!0&&(g=-g);let A=a(d,p,_,x,g,m);_.transmission>0?i.push(A):_.transparent===!0?s.push(A):t.push(A)}function c(d,p,_,x,g,m){let b=a(d,p,_,x,g,m);_.transmission>0?i.unshift(b):_.transparent===!0?s.unshift(b):t.unshift(b)}function u(d,p){t.length>1&&t.sort(d||qR),i.length>1&&i.sort(p||Cy),s.length>1&&s.sort(p||Cy)}function h(){for(let d=e,p=n.length;d<p;d++){let _=n[d];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function XR(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Ry,n.set(i,[o])):s>=r.length?(o=new Ry,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function $R(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new K,color:new bt};break;case"SpotLight":t={position:new K,direction:new K,color:new bt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new K,color:new bt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new K,skyColor:new bt,groundColor:new bt};break;case"RectAreaLight":t={color:new bt,position:new K,halfWidth:new K,halfHeight:new K};break}return n[e.id]=t,t}}}function YR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var KR=0;function ZR(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function JR(n){let e=new $R,t=YR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new K);let s=new K,r=new rn,o=new rn;function a(c){let u=0,h=0,d=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let p=0,_=0,x=0,g=0,m=0,b=0,A=0,S=0,P=0,C=0,v=0,E=0,k=0,N=0;c.sort(ZR);for(let B=0,V=c.length;B<V;B++){let U=c[B],H=U.color,Y=U.intensity,G=U.distance,le=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Dr?le=U.shadow.map.texture:le=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)u+=H.r*Y,h+=H.g*Y,d+=H.b*Y;else if(U.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(U.sh.coefficients[J],Y);N++}else if(U.isSunLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[_]=se,i.sunShadowMap[_]=le;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[x+he]=Q.getMatrix(he),i.sunShadowCascade[x+he]=Q._cascadeData[he];x+=fe,_++}i.sun[p]=J,p++}else if(U.isDirectionalLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[g]=se,i.directionalShadowMap[g]=le,i.directionalShadowMatrix[g]=U.shadow.matrix,P++}i.directional[g]=J,g++}else if(U.isSpotLight){let J=e.get(U);J.position.setFromMatrixPosition(U.matrixWorld),J.color.copy(H).multiplyScalar(Y),J.distance=G,J.coneCos=Math.cos(U.angle),J.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),J.decay=U.decay,i.spot[b]=J;let Q=U.shadow;if(U.map&&(i.spotLightMap[E]=U.map,E++,Q.updateMatrices(U),U.castShadow&&k++),i.spotLightMatrix[b]=Q.matrix,U.castShadow){let se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[b]=se,i.spotShadowMap[b]=le,v++}b++}else if(U.isRectAreaLight){let J=e.get(U);J.color.copy(H).multiplyScalar(Y),J.halfWidth.set(U.width*.5,0,0),J.halfHeight.set(0,U.height*.5,0),i.rectArea[A]=J,A++}else if(U.isPointLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),J.distance=U.distance,J.decay=U.decay,U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[m]=se,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=U.shadow.matrix,C++}i.point[m]=J,m++}else if(U.isHemisphereLight){let J=e.get(U);J.skyColor.copy(U.color).multiplyScalar(Y),J.groundColor.copy(U.groundColor).multiplyScalar(Y),i.hemi[S]=J,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let L=i.hash;(L.sunLength!==p||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==b||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==_||L.numDirectionalShadows!==P||L.numPointShadows!==C||L.numSpotShadows!==v||L.numSpotMaps!==E||L.numLightProbes!==N)&&(i.sun.length=p,i.directional.length=g,i.spot.length=b,i.rectArea.length=A,i.point.length=m,i.hemi.length=S,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-k,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=N,L.sunLength=p,L.directionalLength=g,L.pointLength=m,L.spotLength=b,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=_,L.numDirectionalShadows=P,L.numPointShadows=C,L.numSpotShadows=v,L.numSpotMaps=E,L.numLightProbes=N,i.version=KR++)}function l(c,u){let h=0,d=0,p=0,_=0,x=0,g=0,m=u.matrixWorldInverse;for(let b=0,A=c.length;b<A;b++){let S=c[b];if(S.isSunLight){let P=i.sun[h];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),h++}else if(S.isDirectionalLight){let P=i.directional[d];P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),d++}else if(S.isSpotLight){let P=i.spot[_];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),_++}else if(S.isRectAreaLight){let P=i.rectArea[x];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let P=i.point[p];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),p++}else if(S.isHemisphereLight){let P=i.hemi[g];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Py(n){let e=new JR(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function jR(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Py(n),e.set(s,[a])):r>=o.length?(a=new Py(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var QR=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,eP=`uniform sampler2D shadow_pass;
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
}`,tP=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],nP=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],Iy=new rn,Yl=new K,rm=new K;function iP(n,e,t){let i=new oo,s=new tt,r=new tt,o=new on,a=new Yu,l=new Ku,c={},u=t.maxTextureSize,h={[Lr]:oi,[oi]:Lr,[Oi]:Oi},d=new Ei({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:QR,fragmentShader:eP}),p=d.clone();p.defines.HORIZONTAL_PASS=1;let _=new Ms;_.setAttribute("position",new ri(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Fi(_,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=zl;let m=this.type;this.render=function(C,v,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||C.length===0)return;this.type===wv&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=zl);let k=n.getRenderTarget(),N=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),B=n.state;B.setBlending(ao),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=m!==this.type;V&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(H=>H.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,H=C.length;U<H;U++){let Y=C[U],G=Y.shadow;if(G===void 0){Ye("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let le=G.getFrameExtents();s.multiply(le),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,G.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=J,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Sa){if(Y.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new wi(s.x,s.y,{format:Dr,type:ts,minFilter:qn,magFilter:qn,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new Ys(s.x,s.y,es),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=Xs,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Hn,G.map.depthTexture.magFilter=Hn}else Y.isPointLight?(G.map=new Zl(s.x),G.map.depthTexture=new Nl(s.x,Qi)):(G.map=new wi(s.x,s.y),G.map.depthTexture=new Ys(s.x,s.y,Qi)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=Xs,this.type===zl?(G.map.depthTexture.compareFunction=J?Xp:qp,G.map.depthTexture.minFilter=qn,G.map.depthTexture.magFilter=qn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Hn,G.map.depthTexture.magFilter=Hn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,E);let se=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:E.layers;for(let fe=0;fe<Q;fe++){let he=G.getCamera(fe);if(Y.isPointLight){let ee=G.camera,me=G.matrix,ve=Y.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),Yl.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(Yl),rm.copy(ee.position),rm.add(tP[fe]),ee.up.copy(nP[fe]),ee.lookAt(rm),ee.updateMatrixWorld(),me.makeTranslation(-Yl.x,-Yl.y,-Yl.z),Iy.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Iy,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),B.viewport(o)}i=G.getFrustum(fe),S(v,E,he,Y,se,this.type)}G.isPointLightShadow!==!0&&this.type===Sa&&b(G,E),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(k,N,L)};function b(C,v){let E=e.update(x);d.defines.VSM_SAMPLES!==C.blurSamples&&(d.defines.VSM_SAMPLES=C.blurSamples,p.defines.VSM_SAMPLES=C.blurSamples,d.needsUpdate=!0,p.needsUpdate=!0),C.mapPass===null?C.mapPass=new wi(s.x,s.y,{format:Dr,type:ts}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),d.uniforms.shadow_pass.value=C.map.depthTexture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(v,null,E,d,x,null),p.uniforms.shadow_pass.value=C.mapPass.texture,p.uniforms.resolution.value.set(C.map.width,C.map.height),p.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(v,null,E,p,x,null)}function A(C,v,E,k){let N=null,L=E.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)N=L;else if(N=E.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let B=N.uuid,V=v.uuid,U=c[B];U===void 0&&(U={},c[B]=U);let H=U[V];H===void 0&&(H=N.clone(),U[V]=H,v.addEventListener("dispose",P)),N=H}if(N.visible=v.visible,N.wireframe=v.wireframe,k===Sa?N.side=v.shadowSide!==null?v.shadowSide:v.side:N.side=v.shadowSide!==null?v.shadowSide:h[v.side],N.alphaMap=v.alphaMap,N.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,N.map=v.map,N.clipShadows=v.clipShadows,N.clippingPlanes=v.clippingPlanes,N.clipIntersection=v.clipIntersection,N.displacementMap=v.displacementMap,N.displacementScale=v.displacementScale,N.displacementBias=v.displacementBias,N.wireframeLinewidth=v.wireframeLinewidth,N.linewidth=v.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let B=n.properties.get(N);B.light=E}return N}function S(C,v,E,k,N,L){if(C.visible===!1)return;if(C.layers.test(N)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===Sa)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,C.matrixWorld);let U=e.update(C),H=C.material;if(Array.isArray(H)){let Y=U.groups;for(let G=0,le=Y.length;G<le;G++){let J=Y[G],Q=H[J.materialIndex];if(Q&&Q.visible){let se=A(C,Q,k,L);C.onBeforeShadow(n,C,v,E,U,se,J),n.renderBufferDirect(E,null,U,se,C,J),C.onAfterShadow(n,C,v,E,U,se,J)}}}else if(H.visible){let Y=A(C,H,k,L);C.onBeforeShadow(n,C,v,E,U,Y,null),n.renderBufferDirect(E,null,U,Y,C,null),C.onAfterShadow(n,C,v,E,U,Y,null)}}let V=C.children;for(let U=0,H=V.length;U<H;U++)S(V[U],v,E,k,N,L)}function P(C){C.target.removeEventListener("dispose",P);for(let E in c){let k=c[E],N=C.target.uuid;N in k&&(k[N].dispose(),delete k[N])}}}function sP(n,e){function t(){let F=!1,re=new on,ne=null,we=new on(0,0,0,0);return{setMask:function(ge){ne!==ge&&!F&&(n.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){F=ge},setClear:function(ge,be,We,Je,ce){ce===!0&&(ge*=Je,be*=Je,We*=Je),re.set(ge,be,We,Je),we.equals(re)===!1&&(n.clearColor(ge,be,We,Je),we.copy(re))},reset:function(){F=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let F=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){if(re!==be){let We=e.get("EXT_clip_control");be?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=be;let Je=ge;ge=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(be){be?Se(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!F&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=sy[be]),we!==be){switch(be){case Cu:n.depthFunc(n.NEVER);break;case Ru:n.depthFunc(n.ALWAYS);break;case Pu:n.depthFunc(n.LESS);break;case fa:n.depthFunc(n.LEQUAL);break;case Iu:n.depthFunc(n.EQUAL);break;case Lu:n.depthFunc(n.GEQUAL);break;case Du:n.depthFunc(n.GREATER);break;case Nu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=be}},setLocked:function(be){F=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){F=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let F=!1,re=null,ne=null,we=null,ge=null,be=null,We=null,Je=null,ce=null;return{setTest:function(ke){F||(ke?Se(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(ke){re!==ke&&!F&&(n.stencilMask(ke),re=ke)},setFunc:function(ke,je,Ce){(ne!==ke||we!==je||ge!==Ce)&&(n.stencilFunc(ke,je,Ce),ne=ke,we=je,ge=Ce)},setOp:function(ke,je,Ce){(be!==ke||We!==je||Je!==Ce)&&(n.stencilOp(ke,je,Ce),be=ke,We=je,Je=Ce)},setLocked:function(ke){F=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){F=!1,re=null,ne=null,we=null,ge=null,be=null,We=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},p=new WeakMap,_=[],x=null,g=!1,m=null,b=null,A=null,S=null,P=null,C=null,v=null,E=new bt(0,0,0),k=0,N=!1,L=null,B=null,V=null,U=null,H=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),G=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),G=le>=2);let Q=null,se={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new on().fromArray(fe),me=new on().fromArray(he);function ve(F,re,ne,we){let ge=new Uint8Array(4),be=n.createTexture();n.bindTexture(F,be),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<ne;We++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return be}let Ae={};Ae[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(fa),_n(!1),kt(Sp),Se(n.CULL_FACE),en(ao);function Se(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function qe(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function rt(F,re){return d[F]!==re?(n.bindFramebuffer(F,re),d[F]=re,F===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=re),F===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=re),!0):!1}function He(F,re){let ne=_,we=!1;if(F){ne=p.get(re),ne===void 0&&(ne=[],p.set(re,ne));let ge=F.textures;if(ne.length!==ge.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,We=ge.length;be<We;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function ft(F){return x!==F?(n.useProgram(F),x=F,!0):!1}let ct={[lo]:n.FUNC_ADD,[Ev]:n.FUNC_SUBTRACT,[Av]:n.FUNC_REVERSE_SUBTRACT};ct[Cv]=n.MIN,ct[Rv]=n.MAX;let it={[Pv]:n.ZERO,[Iv]:n.ONE,[Lv]:n.SRC_COLOR,[Ep]:n.SRC_ALPHA,[kv]:n.SRC_ALPHA_SATURATE,[Fv]:n.DST_COLOR,[Nv]:n.DST_ALPHA,[Dv]:n.ONE_MINUS_SRC_COLOR,[Ap]:n.ONE_MINUS_SRC_ALPHA,[Ov]:n.ONE_MINUS_DST_COLOR,[Uv]:n.ONE_MINUS_DST_ALPHA,[Bv]:n.CONSTANT_COLOR,[zv]:n.ONE_MINUS_CONSTANT_COLOR,[Vv]:n.CONSTANT_ALPHA,[Gv]:n.ONE_MINUS_CONSTANT_ALPHA};function en(F,re,ne,we,ge,be,We,Je,ce,ke){if(F===ao){g===!0&&(qe(n.BLEND),g=!1);return}if(g===!1&&(Se(n.BLEND),g=!0),F!==Tv){if(F!==m||ke!==N){if((b!==lo||P!==lo)&&(n.blendEquation(n.FUNC_ADD),b=lo,P=lo),ke)switch(F){case Ma:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Mp:n.blendFunc(n.ONE,n.ONE);break;case wp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Tp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:et("WebGLState: Invalid blending: ",F);break}else switch(F){case Ma:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Mp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case wp:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Tp:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",F);break}A=null,S=null,C=null,v=null,E.set(0,0,0),k=0,m=F,N=ke}return}ge=ge||re,be=be||ne,We=We||we,(re!==b||ge!==P)&&(n.blendEquationSeparate(ct[re],ct[ge]),b=re,P=ge),(ne!==A||we!==S||be!==C||We!==v)&&(n.blendFuncSeparate(it[ne],it[we],it[be],it[We]),A=ne,S=we,C=be,v=We),(Je.equals(E)===!1||ce!==k)&&(n.blendColor(Je.r,Je.g,Je.b,ce),E.copy(Je),k=ce),m=F,N=!1}function Ht(F,re){F.side===Oi?qe(n.CULL_FACE):Se(n.CULL_FACE);let ne=F.side===oi;re&&(ne=!ne),_n(ne),F.blending===Ma&&F.transparent===!1?en(ao):en(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let we=F.stencilWrite;a.setTest(we),we&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Mt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function _n(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function kt(F){F!==Sv?(Se(n.CULL_FACE),F!==B&&(F===Sp?n.cullFace(n.BACK):F===Mv?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),B=F}function On(F){F!==V&&(G&&n.lineWidth(F),V=F)}function Mt(F,re,ne){F?(Se(n.POLYGON_OFFSET_FILL),(U!==re||H!==ne)&&(U=re,H=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):qe(n.POLYGON_OFFSET_FILL)}function En(F){F?Se(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function cn(F){F===void 0&&(F=n.TEXTURE0+Y-1),Q!==F&&(n.activeTexture(F),Q=F)}function vn(F,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+Y-1:ne=Q);let we=se[ne];we===void 0&&(we={type:void 0,texture:void 0},se[ne]=we),(we.type!==F||we.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(F,re||Ae[F]),we.type=F,we.texture=re)}function O(){let F=se[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function ot(){try{n.texSubImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Me(){try{n.texSubImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function $e(){try{n.texStorage2D(...arguments)}catch(F){et("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){et("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function q(){try{n.texImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function ue(F){return h[F]!==void 0?h[F]:n.getParameter(F)}function oe(F,re){h[F]!==re&&(n.pixelStorei(F,re),h[F]=re)}function _e(F){ee.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function ye(F){me.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function te(F,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(F);we===void 0&&(we=n.getUniformBlockIndex(re,F.name),n.uniformBlockBinding(re,we,we),ne.set(F,we))}function ie(F,re,ne){let ge=c.get(re).get(F);l[ge]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,se={},d={},l={},p=new WeakMap,_=[],x=null,g=!1,m=null,b=null,A=null,S=null,P=null,C=null,v=null,E=new bt(0,0,0),k=0,N=!1,L=null,B=null,V=null,U=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:qe,bindFramebuffer:rt,drawBuffers:He,useProgram:ft,setBlending:en,setMaterial:Ht,setFlipSided:_n,setCullFace:kt,setLineWidth:On,setPolygonOffset:Mt,setScissorTest:En,activeTexture:cn,bindTexture:vn,unbindTexture:O,compressedTexImage2D:Re,compressedTexImage3D:Ke,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:$e,texStorage3D:R,texSubImage2D:ot,texSubImage3D:Me,compressedTexSubImage2D:zt,compressedTexSubImage3D:Ve,scissor:_e,viewport:ye,reset:pe}}function rP(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new tt,u=new WeakMap,h=new Set,d,p=new WeakMap,_=new Set,x=new FinalizationRegistry(R=>_.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,M){return g?new OffscreenCanvas(R,M):El("canvas")}function b(R,M,q){let ue=1,oe=$e(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _e=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);d===void 0&&(d=m(_e,ye));let te=M?m(_e,ye):d;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(R,0,0,_e,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+ye+")."),te}else return"data"in R&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function P(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,M,q,ue,oe,_e=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let ie=_e?wl:xt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Dt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(R,M){let q;return R?M===null||M===Qi||M===uo?q=n.DEPTH24_STENCIL8:M===es?q=n.DEPTH32F_STENCIL8:M===Ta&&(q=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Qi||M===uo?q=n.DEPTH_COMPONENT24:M===es?q=n.DEPTH_COMPONENT32F:M===Ta&&(q=n.DEPTH_COMPONENT16),q}function E(R,M){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Hn&&R.minFilter!==qn?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function k(R){let M=new WeakRef(R);i.get(R).__ref=M,_.add(M),x.register(R,M,M)}function N(R){let M=i.get(R).__ref;M!==void 0&&(_.delete(M),x.unregister(M))}function L(R){V(R.target)}function B(R){U(R.target)}function V(R){R.removeEventListener("dispose",L),N(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function U(R){R.removeEventListener("dispose",B),N(R),le(R)}function H(){for(let R of _){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?U(M):V(M))}_.clear(),h.clear()}function Y(R){let M=i.get(R);if(M.__webglInit===void 0)return;let q=R.source,ue=p.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(R),Object.keys(ue).length===0&&p.delete(q)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let q=R.source,ue=p.get(q);delete ue[M.__cacheKey],o.memory.textures--}function le(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&V(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let _e=0;_e<M.__webglFramebuffer[oe].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[oe][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,_e=ue.length;oe<_e;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let J=0;function Q(){J=0}function se(){return J}function fe(R){J=R}function he(){let R=J;return R>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function ee(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let q=i.get(R);if(R.isVideoTexture&&zt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht(q,R,M);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ve(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ht(q,R,M);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ae(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ht(q,R,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Se(R,M){let q=i.get(R);if(R.version>0&&q.__version!==R.version){_n(q,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let qe={[Uu]:n.REPEAT,[bs]:n.CLAMP_TO_EDGE,[Fu]:n.MIRRORED_REPEAT},rt={[Hn]:n.NEAREST,[qv]:n.NEAREST_MIPMAP_NEAREST,[Vl]:n.NEAREST_MIPMAP_LINEAR,[qn]:n.LINEAR,[uh]:n.LINEAR_MIPMAP_NEAREST,[Ks]:n.LINEAR_MIPMAP_LINEAR},He={[Kv]:n.NEVER,[$p]:n.ALWAYS,[Zv]:n.LESS,[qp]:n.LEQUAL,[Jv]:n.EQUAL,[Xp]:n.GEQUAL,[jv]:n.GREATER,[Qv]:n.NOTEQUAL};function ft(R,M){if(M.type===es&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===qn||M.magFilter===uh||M.magFilter===Vl||M.magFilter===Ks||M.minFilter===qn||M.minFilter===uh||M.minFilter===Vl||M.minFilter===Ks)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,qe[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,qe[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,qe[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,rt[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,rt[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,He[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Hn||M.minFilter!==Vl&&M.minFilter!==Ks||M.type===es&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ct(R,M){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),k(M));let ue=M.source,oe=p.get(ue);oe===void 0&&(oe={},p.set(ue,oe));let _e=ee(M);if(_e!==R.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[_e].usedTimes++;let ye=oe[R.__cacheKey];ye!==void 0&&(oe[R.__cacheKey].usedTimes--,ye.usedTimes===0&&G(M)),R.__cacheKey=_e,R.__webglTexture=oe[_e].texture}return q}function it(R,M,q){return Math.floor(Math.floor(R/q)/M)}function en(R,M,q,ue){let _e=R.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{_e.sort((F,re)=>F.start-re.start);let ye=0;for(let F=1;F<_e.length;F++){let re=_e[ye],ne=_e[F],we=re.start+re.count,ge=it(ne.start,M.width,4),be=it(re.start,M.width,4);ne.start<=we+1&&ge===be&&it(ne.start+ne.count-1,M.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,re=_e.length;F<re;F++){let ne=_e[F],we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%M.width,We=Math.floor(we/M.width),Je=ge,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,be,We,Je,ce,q,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ht(R,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ct(R,M),_e=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(_e);if(_e.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=xt.getPrimaries(xt.workingColorSpace),ke=M.colorSpace===Js?null:xt.getPrimaries(M.colorSpace),je=M.colorSpace===Js||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=b(M.image,!1,s.maxTextureSize);ie=Ve(M,ie);let pe=r.convert(M.format,M.colorSpace),F=r.convert(M.type),re=C(M.internalFormat,pe,F,M.normalized,M.colorSpace,M.isVideoTexture);ft(ue,M);let ne,we=M.mipmaps,ge=M.isVideoTexture!==!0,be=ye.__version===void 0||oe===!0,We=_e.dataReady,Je=E(M,ie);if(M.isDepthTexture)re=v(M.format===Zs,M.type),be&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,null));else if(M.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,ke=we.length;ce<ke;ce++)ne=we[ce],ge?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data);M.generateMipmaps=!1}else ge?(be&&t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height),We&&en(M,ie,pe,F)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,we[0].width,we[0].height,ie.depth);for(let ce=0,ke=we.length;ce<ke;ce++)if(ne=we[ce],M.format!==ns)if(pe!==null)if(ge){if(We)if(M.layerUpdates.size>0){let je=im(ne.width,ne.height,M.format,M.type);for(let Ce of M.layerUpdates){let at=ne.data.subarray(Ce*je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,at)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,F,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,pe,F,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,ke=we.length;ce<ke;ce++)ne=we[ce],M.format!==ns?pe!==null?ge?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data)}else if(M.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,ie.width,ie.height,ie.depth),We)if(M.layerUpdates.size>0){let ce=im(ie.width,ie.height,M.format,M.type);for(let ke of M.layerUpdates){let je=ie.data.subarray(ke*ce/ie.data.BYTES_PER_ELEMENT,(ke+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,ie.width,ie.height,1,pe,F,je)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isData3DTexture)ge?(be&&t.texStorage3D(n.TEXTURE_3D,Je,re,ie.width,ie.height,ie.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isFramebufferTexture){if(be)if(ge)t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height);else{let ce=ie.width,ke=ie.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,re,ce,ke,0,pe,F,null),ce>>=1,ke>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),h.add(M),ce.onpaint=ke=>{let je=ke.changedElements;for(let Ce of h)je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let je=n.RGBA,Ce=n.RGBA,at=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Ce,at,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=$e(we[0]);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,ke=we.length;ce<ke;ce++)ne=we[ce],ge?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,F,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,F,ne);M.generateMipmaps=!1}else if(ge){if(be){let ce=$e(ie);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,F,ie);A(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=_e.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function _n(R,M,q){if(M.image.length!==6)return;let ue=ct(R,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let _e=i.get(oe);if(oe.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=xt.getPrimaries(xt.workingColorSpace),te=M.colorSpace===Js?null:xt.getPrimaries(M.colorSpace),ie=M.colorSpace===Js||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!F?re[Ce]=b(M.image[Ce],!0,s.maxCubemapSize):re[Ce]=F?M.image[Ce].image:M.image[Ce],re[Ce]=Ve(M,re[Ce]);let ne=re[0],we=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=C(M.internalFormat,we,ge,M.normalized,M.colorSpace),We=M.isVideoTexture!==!0,Je=_e.__version===void 0||ue===!0,ce=oe.dataReady,ke=E(M,ne);ft(n.TEXTURE_CUBE_MAP,M);let je;if(M.isDepthTexture){if(be=v(M.format===Zs,M.type),Je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,0,we,ge,null)}else if(pe){We&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){je=re[Ce].mipmaps;for(let at=0;at<je.length;at++){let Xt=je[at];M.format!==ns?we!==null?We?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Xt.width,Xt.height,we,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Xt.width,Xt.height,0,Xt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Xt.width,Xt.height,we,ge,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Xt.width,Xt.height,0,we,ge,Xt.data)}}}else{if(je=M.mipmaps,We&&Je){je.length>0&&ke++;let Ce=$e(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(F){We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,we,ge,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,re[Ce].width,re[Ce].height,0,we,ge,re[Ce].data);for(let at=0;at<je.length;at++){let jn=je[at].image[Ce].image;We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,jn.width,jn.height,we,ge,jn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,jn.width,jn.height,0,we,ge,jn.data)}}else{We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ge,re[Ce]);for(let at=0;at<je.length;at++){let Xt=je[at];We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,we,ge,Xt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,we,ge,Xt.image[Ce])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=oe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function kt(R,M,q,ue,oe,_e){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ie=C(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(M),F=i.get(q);if(F.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>_e),ne=Math.max(1,M.height>>_e);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,ie,re,ne,M.depth,0,ye,te,null):t.texImage2D(oe,_e,ie,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,F.__webglTexture,0,ot(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,F.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function On(R,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,_e=v(M.stencilBuffer,oe),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),_e,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let _e=ue[oe],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),ie=C(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),ie,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Mt(R,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):me(M.depthTexture,0);let ye=oe.__webglTexture,te=ot(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===Zs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Xs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else if(M.depthTexture.format===Zs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function En(R){let M=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)Mt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?Mt(M.__webglFramebuffer[0],R,0):Mt(M.__webglFramebuffer,R,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),On(M.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),On(M.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function cn(R,M,q){let ue=i.get(R);M!==void 0&&kt(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&En(R)}function vn(R){let M=R.texture,q=i.get(R),ue=i.get(M);R.addEventListener("dispose",B),k(R);let oe=R.textures,_e=R.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,ie=oe.length;te<ie;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),re=C(ie.internalFormat,pe,F,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=ot(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),On(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ft(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)kt(q.__webglFramebuffer[te][ie],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else kt(q.__webglFramebuffer[te],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=oe.length;te<ie;te++){let pe=oe[te],F=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,F.__webglTexture),ft(re,pe),kt(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,re,0),A(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ft(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)kt(q.__webglFramebuffer[ie],R,M,n.COLOR_ATTACHMENT0,te,ie);else kt(q.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,te,0);A(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&En(R)}function O(R){let M=R.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let _e=P(R),ye=i.get(oe).__webglTexture;t.bindTexture(_e,ye),S(_e),t.unbindTexture()}}}let Re=[];function Ke(R){if(R.samples>0){if(Me(R)===!1){let M=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,_e=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ot(R){return Math.min(s.maxSamples,R.samples)}function Me(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function zt(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function Ve(R,M){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==Ml&&q!==Js&&(xt.getTransfer(q)===Dt?(ue!==ns||oe!==Ci)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",q)),M}function $e(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ae,this.setTextureCube=Se,this.rebindTextures=cn,this.setupRenderTarget=vn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=En,this.setupFrameBufferTexture=kt,this.useMultisampledRTT=Me,this.dispose=H}function oP(n,e){function t(i,s=Js){let r,o=xt.getTransfer(s);if(i===Ci)return n.UNSIGNED_BYTE;if(i===fh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===dh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Bp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===zp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Op)return n.BYTE;if(i===kp)return n.SHORT;if(i===Ta)return n.UNSIGNED_SHORT;if(i===hh)return n.INT;if(i===Qi)return n.UNSIGNED_INT;if(i===es)return n.FLOAT;if(i===ts)return n.HALF_FLOAT;if(i===Vp)return n.ALPHA;if(i===Gp)return n.RGB;if(i===ns)return n.RGBA;if(i===Xs)return n.DEPTH_COMPONENT;if(i===Zs)return n.DEPTH_STENCIL;if(i===Hp)return n.RED;if(i===ph)return n.RED_INTEGER;if(i===Dr)return n.RG;if(i===mh)return n.RG_INTEGER;if(i===gh)return n.RGBA_INTEGER;if(i===Gl||i===Hl||i===Wl||i===ql)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Gl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Wl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ql)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Gl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Hl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Wl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ql)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===_h||i===vh||i===yh||i===xh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===_h)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===vh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===yh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===xh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===bh||i===Sh||i===Mh||i===wh||i===Th||i===Xl||i===Eh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===bh||i===Sh)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Mh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===wh)return r.COMPRESSED_R11_EAC;if(i===Th)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Xl)return r.COMPRESSED_RG11_EAC;if(i===Eh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ah||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Uh||i===Fh||i===Oh||i===kh||i===Bh||i===zh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ah)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ch)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Rh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ph)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ih)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Lh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Dh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Nh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Uh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Fh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Oh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===kh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Bh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===zh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Vh||i===Gh||i===Hh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Vh)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Gh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Hh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Wh||i===qh||i===$l||i===Xh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Wh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===qh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===$l)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Xh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===uo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var aP=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,lP=`
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

}`,fm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Ul(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ei({vertexShader:aP,fragmentShader:lP,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Fi(new Fl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},dm=class extends ji{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,p=null,_=null,x=typeof XRWebGLBinding<"u",g=new fm,m={},b=t.getContextAttributes(),A=null,S=null,P=[],C=[],v=new tt,E=null,k=null,N=new si;N.viewport=new on;let L=new si;L.viewport=new on;let B=[N,L],V=new ah,U=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=P[ee];return me===void 0&&(me=new ga,P[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=P[ee];return me===void 0&&(me=new ga,P[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=P[ee];return me===void 0&&(me=new ga,P[ee]=me),me.getHandSpace()};function Y(ee){let me=C.indexOf(ee.inputSource);if(me===-1)return;let ve=P[me];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<P.length;ee++){let me=C[ee];me!==null&&(C[ee]=null,P[ee].disconnect(me))}U=null,H=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(A),p=null,d=null,h=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),k!==null){let ee=k.camera;ee.fov=k.fov,ee.zoom=k.zoom,ee.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:p},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",le),b.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ae=null,Se=null;b.depth&&(Se=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=b.stencil?Zs:Xs,Ae=b.stencil?uo:Qi);let qe={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(qe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new wi(d.textureWidth,d.textureHeight,{format:ns,type:Ci,depthTexture:new Ys(d.textureWidth,d.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new wi(p.framebufferWidth,p.framebufferHeight,{format:ns,type:Ci,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ve=ee.removed[me],Ae=C.indexOf(ve);Ae>=0&&(C[Ae]=null,P[Ae].disconnect(ve))}for(let me=0;me<ee.added.length;me++){let ve=ee.added[me],Ae=C.indexOf(ve);if(Ae===-1){for(let qe=0;qe<P.length;qe++)if(qe>=C.length){C.push(ve),Ae=qe;break}else if(C[qe]===null){C[qe]=ve,Ae=qe;break}if(Ae===-1)break}let Se=P[Ae];Se&&Se.connect(ve)}}function J(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ve=ee.far;g.texture!==null&&(g.depthNear>0&&(me=g.depthNear),g.depthFar>0&&(ve=g.depthFar)),V.near=L.near=N.near=me,V.far=L.far=N.far=ve,(U!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),U=V.near,H=V.far),V.layers.mask=ee.layers.mask|6,N.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let Ae=ee.parent,Se=V.cameras;J(V,Ae);for(let qe=0;qe<Se.length;qe++)J(Se[qe],Ae);V.projectionMatrix.copy(N.projectionMatrix),V.projectionMatrixInverse.copy(N.projectionMatrixInverse),k===null&&ee.isPerspectiveCamera&&(k={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,V,Ae)};function Q(ee,me,ve){ve===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=pa*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&p===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(ee){return m[ee]};let se=null;function fe(ee,me){if(u=me.getViewerPose(c||o),_=me,u!==null){let ve=u.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Ae=!1;ve.length!==V.cameras.length&&(V.cameras.length=0,Ae=!0);for(let He=0;He<ve.length;He++){let ft=ve[He],ct=null;if(p!==null)ct=p.getViewport(ft);else{let en=h.getViewSubImage(d,ft);ct=en.viewport,He===0&&(e.setRenderTargetTextures(S,en.colorTexture,en.depthStencilTexture),e.setRenderTarget(S))}let it=B[He];it===void 0&&(it=new si,it.layers.enable(He),it.viewport=new on,B[He]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ct.x,ct.y,ct.width,ct.height),He===0&&(V.matrix.copy(it.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ae===!0&&V.cameras.push(it)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let He=h.getDepthInformation(ve[0]);He&&He.isValid&&He.texture&&g.init(He,s.renderState)}if(Se&&Se.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let He=0;He<ve.length;He++){let ft=ve[He].camera;if(ft){let ct=m[ft];ct||(ct=new Ul,m[ft]=ct);let it=h.getCameraImage(ft);ct.sourceTexture=it}}}}for(let ve=0;ve<P.length;ve++){let Ae=C[ve],Se=P[ve];Ae!==null&&Se!==void 0&&Se.update(Ae,me,c||o)}se&&se(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),_=null}let he=new Ly;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},cP=new rn,Gy=new nt;Gy.set(-1,0,0,0,1,0,0,0,1);function uP(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,em(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,b,A,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&p(g,m,S)):m.isMeshMatcapMaterial?(r(g,m),_(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,b,A):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===oi&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===oi&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let b=e.get(m),A=b.envMap,S=b.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(cP.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Gy),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,b,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*b,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function p(g,m,b){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===oi&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=b.texture,g.transmissionSamplerSize.value.set(b.width,b.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function _(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let b=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(b.matrixWorld),g.nearDistance.value=b.shadow.camera.near,g.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function hP(n,e,t,i){let s={},r={};function o(b,A){let S=A.program;i.uniformBlockBinding(b,S,s[b.id])}function a(b,A){let S=s[b.id];S===void 0&&(_(b),S=l(b),s[b.id]=S,b.addEventListener("dispose",g));let P=A.program;i.updateUBOMapping(b,P);let C=e.render.frame;r[b.id]!==C&&(c(b),r[b.id]=C)}function l(b){let A=n.createBuffer(),S=b.__size,P=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,P),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(b){let A=s[b.id],S=b.uniforms,P=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let C=0,v=S.length;C<v;C++){let E=S[C];if(Array.isArray(E))for(let k=0,N=E.length;k<N;k++)u(E[k],C,k,P);else u(E,C,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(b,A,S,P){if(d(b,A,S,P)===!0){let C=b.__offset,v=b.value;if(Array.isArray(v)){let E=0;for(let k=0;k<v.length;k++){let N=v[k],L=x(N,!0);h(N,b.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(v,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,b.__data)}}function h(b,A,S){typeof b=="number"||typeof b=="boolean"?A[S]=b:b.isMatrix3?(A[S]=b.elements[0],A[S+1]=b.elements[1],A[S+2]=b.elements[2],A[S+3]=0,A[S+4]=b.elements[3],A[S+5]=b.elements[4],A[S+6]=b.elements[5],A[S+7]=0,A[S+8]=b.elements[6],A[S+9]=b.elements[7],A[S+10]=b.elements[8],A[S+11]=0):ArrayBuffer.isView(b)?A.set(b.subarray(0,A.length-S),S):b.toArray(A,S)}function d(b,A,S,P){let C=b.value,v=A+"_"+S;if(Array.isArray(C)){P[v]===void 0&&(P[v]=[]);let E=P[v],k=!1;for(let N=0;N<C.length;N++)p(C[N],E,N)===!0&&(k=!0);return k}return p(C,P,v)}function p(b,A,S){if(A[S]===void 0)return typeof b=="number"||typeof b=="boolean"?A[S]=b:ArrayBuffer.isView(b)?A[S]=b.slice():A[S]=b.clone(),!0;{let P=A[S];if(typeof b=="number"||typeof b=="boolean"){if(P!==b)return A[S]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(P.equals(b)===!1)return P.copy(b),!0}}return!1}function _(b){let A=b.uniforms,S=0,P=16;for(let v=0,E=A.length;v<E;v++){let k=Array.isArray(A[v])?A[v]:[A[v]];for(let N=0,L=k.length;N<L;N++){let B=k[N],V=Array.isArray(B.value)?B.value:[B.value],U=Array.isArray(A[v])||Array.isArray(B.value),H=S;for(let G=0,le=V.length;G<le;G++){let J=V[G],Q=x(J,U),se=S%P,fe=se%Q.boundary,he=se+fe;S+=fe,he!==0&&P-he<Q.storage&&(S+=P-he),G===0&&(H=S),S+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((S-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}let C=S%P;return C>0&&(S+=P-C),b.__size=S,b.__cache={},this}function x(b,A){let S={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(S.boundary=4,S.storage=4):b.isVector2?(S.boundary=8,S.storage=8):b.isVector3||b.isColor?(S.boundary=16,S.storage=12):b.isVector4?(S.boundary=16,S.storage=16):b.isMatrix3?(S.boundary=16,S.storage=48):b.isMatrix4?(S.boundary=16,S.storage=64):b.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(S.boundary=16,S.storage=b.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",b),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(b){let A=b.target;A.removeEventListener("dispose",g),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let b in s)n.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:m}}var fP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ts=null;function dP(){return Ts===null&&(Ts=new ro(fP,16,16,Dr,ts),Ts.name="DFG_LUT",Ts.minFilter=qn,Ts.magFilter=qn,Ts.wrapS=bs,Ts.wrapT=bs,Ts.generateMipmaps=!1,Ts.needsUpdate=!0),Ts}var Zh=class{constructor(e={}){let{canvas:t=ty(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:p=Ci}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let x=p,g=new Set([gh,mh,ph]),m=new Set([Ci,Qi,Ta,uo,fh,dh]),b=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,C=null,v=[],E=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ws,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,B=null,V=null,U=null,H=null;this._outputColorSpace=bi;let Y=0,G=0,le=null,J=-1,Q=null,se=new on,fe=new on,he=null,ee=new bt(0),me=0,ve=t.width,Ae=t.height,Se=1,qe=null,rt=null,He=new on(0,0,ve,Ae),ft=new on(0,0,ve,Ae),ct=!1,it=new oo,en=new Gu,Ht=!1,_n=!1,kt=new rn,On=new K,Mt=new on,En={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},cn=!1;function vn(){return le===null?Se:1}let O=i;function Re(T,z){return t.getContext(T,z)}let Ke,ot,Me,zt,Ve,$e,R,M,q,ue,oe,_e,ye,te,ie,pe,F,re,ne,we,ge,be,We;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),O===null){let z="webgl2";if(O=Re(z,T),O===null)throw Re(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(T){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),et("WebGLRenderer: "+T.message),T}function Je(){Ke=new wC(O),Ke.init(),ge=new oP(O,Ke),ot=new dC(O,Ke,e,ge),Me=new sP(O,Ke),ot.reversedDepthBuffer&&d&&Me.buffers.depth.setReversed(!0),V=O.createFramebuffer(),U=O.createFramebuffer(),H=O.createFramebuffer(),zt=new AC(O),Ve=new WR,$e=new rP(O,Ke,Me,Ve,ot,ge,zt),R=new MC(N),M=new RT(O),be=new hC(O,M),q=new TC(O,M,zt,be),ue=new RC(O,q,M,be,zt),re=new CC(O,ot,$e),ie=new pC(Ve),oe=new HR(N,R,Ke,ot,be,ie),_e=new uP(N,Ve),ye=new XR,te=new jR(Ke),F=new uC(N,R,Me,ue,_,l),pe=new iP(N,ue,ot),We=new hP(O,zt,ot,Me),ne=new fC(O,Ke,zt),we=new EC(O,Ke,zt),zt.programs=oe.programs,N.capabilities=ot,N.extensions=Ke,N.properties=Ve,N.renderLists=ye,N.shadowMap=pe,N.state=Me,N.info=zt}x!==Ci&&(k=new IC(x,t.width,t.height,a,s,r));let ce=new dm(N,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let T=Ke.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ke.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(T){T!==void 0&&(Se=T,this.setSize(ve,Ae,!1))},this.getSize=function(T){return T.set(ve,Ae)},this.setSize=function(T,z,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Ae=z,t.width=Math.floor(T*Se),t.height=Math.floor(z*Se),j===!0&&(t.style.width=T+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(ve*Se,Ae*Se).floor()},this.setDrawingBufferSize=function(T,z,j){ve=T,Ae=z,Se=j,t.width=Math.floor(T*j),t.height=Math.floor(z*j),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(x===Ci){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy(He)},this.setViewport=function(T,z,j,X){T.isVector4?He.set(T.x,T.y,T.z,T.w):He.set(T,z,j,X),Me.viewport(se.copy(He).multiplyScalar(vn()).round())},this.getScissor=function(T){return T.copy(ft)},this.setScissor=function(T,z,j,X){T.isVector4?ft.set(T.x,T.y,T.z,T.w):ft.set(T,z,j,X),Me.scissor(fe.copy(ft).multiplyScalar(vn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(T){Me.setScissorTest(ct=T)},this.setOpaqueSort=function(T){qe=T},this.setTransparentSort=function(T){rt=T},this.getClearColor=function(T){return T.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,j=!0){let X=0;if(T){let $=!1;if(le!==null){let Te=le.texture.format;$=g.has(Te)}if($){let Te=le.texture.type,Ie=m.has(Te),Ee=F.getClearColor(),Le=F.getClearAlpha(),ze=Ee.r,Qe=Ee.g,dt=Ee.b;Ie?(b[0]=ze,b[1]=Qe,b[2]=dt,b[3]=Le,O.clearBufferuiv(O.COLOR,0,b)):(A[0]=ze,A[1]=Qe,A[2]=dt,A[3]=Le,O.clearBufferiv(O.COLOR,0,A))}else X|=O.COLOR_BUFFER_BIT}z&&(X|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(X|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),X!==0&&O.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),B=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),F.dispose(),ye.dispose(),te.dispose(),$e.dispose(),Ve.dispose(),R.dispose(),ue.dispose(),q.dispose(),be.dispose(),We.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",uc),ce.removeEventListener("sessionend",cs),Is.stop()};function ke(T){T.preventDefault(),Kp("WebGLRenderer: Context Lost."),L=!0}function je(){Kp("WebGLRenderer: Context Restored."),L=!1;let T=zt.autoReset,z=pe.enabled,j=pe.autoUpdate,X=pe.needsUpdate,$=pe.type;Je(),zt.autoReset=T,pe.enabled=z,pe.autoUpdate=j,pe.needsUpdate=X,pe.type=$}function Ce(T){et("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function at(T){let z=T.target;z.removeEventListener("dispose",at),Xt(z)}function Xt(T){jn(T),Ve.remove(T)}function jn(T){let z=Ve.get(T).programs;z!==void 0&&(z.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,j,X,$,Te){z===null&&(z=En);let Ie=$.isMesh&&$.matrixWorld.determinantAffine()<0,Ee=Ha(T,z,j,X,$);Me.setMaterial(X,Ie);let Le=j.index,ze=1;if(X.wireframe===!0){if(Le=q.getWireframeAttribute(j),Le===void 0)return;ze=2}let Qe=j.drawRange,dt=j.attributes.position,Be=Qe.start*ze,pt=(Qe.start+Qe.count)*ze;Te!==null&&(Be=Math.max(Be,Te.start*ze),pt=Math.min(pt,(Te.start+Te.count)*ze)),Le!==null?(Be=Math.max(Be,0),pt=Math.min(pt,Le.count)):dt!=null&&(Be=Math.max(Be,0),pt=Math.min(pt,dt.count));let sn=pt-Be;if(sn<0||sn===1/0)return;be.setup($,X,Ee,j,Le);let Nt,Ut=ne;if(Le!==null&&(Nt=M.get(Le),Ut=we,Ut.setIndex(Nt)),$.isMesh)X.wireframe===!0?(Me.setLineWidth(X.wireframeLinewidth*vn()),Ut.setMode(O.LINES)):Ut.setMode(O.TRIANGLES);else if($.isLine){let An=X.linewidth;An===void 0&&(An=1),Me.setLineWidth(An*vn()),$.isLineSegments?Ut.setMode(O.LINES):$.isLineLoop?Ut.setMode(O.LINE_LOOP):Ut.setMode(O.LINE_STRIP)}else $.isPoints?Ut.setMode(O.POINTS):$.isSprite&&Ut.setMode(O.TRIANGLES);if($.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Ut.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let An=$._multiDrawStarts,Fe=$._multiDrawCounts,yn=$._multiDrawCount,_t=Le?M.get(Le).bytesPerElement:1,Ds=Ve.get(X).currentProgram.getUniforms();for(let xn=0;xn<yn;xn++)Ds.setValue(O,"_gl_DrawID",xn),Ut.render(An[xn]/_t,Fe[xn])}else if($.isInstancedMesh)Ut.renderInstances(Be,sn,$.count);else if(j.isInstancedBufferGeometry){let An=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,An);Ut.renderInstances(Be,sn,Fe)}else Ut.render(Be,sn)};function za(T,z,j,X){B!==null&&T.isNodeMaterial&&B.setObject(X,T),Ht===!0&&ie.setState(T,j,!1),T.transparent===!0&&T.side===Oi&&T.forceSinglePass===!1?(T.side=oi,T.needsUpdate=!0,us(T,z,X),T.side=Lr,T.needsUpdate=!0,us(T,z,X),T.side=Oi):us(T,z,X)}this.compile=function(T,z,j=null){j===null&&(j=T),B!==null&&B.renderStart(T,z,j),C=te.get(j),C.init(z),E.push(C),j.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),T!==j&&T.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),C.setupLights(),B!==null&&B.updateLights(C.state.lightsArray),_n=this.localClippingEnabled,Ht=ie.init(this.clippingPlanes,_n),Ht===!0&&ie.setGlobalState(this.clippingPlanes,z),B!==null&&pe.render(C.state.shadowsArray,j,z);let X=new Set;return T.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Te=$.material;if(Te)if(Array.isArray(Te))for(let Ie=0;Ie<Te.length;Ie++){let Ee=Te[Ie];za(Ee,j,z,$),X.add(Ee)}else za(Te,j,z,$),X.add(Te)}),C=E.pop(),B!==null&&B.renderEnd(),X},this.compileAsync=function(T,z,j=null){let X=this.compile(T,z,j);return new Promise($=>{function Te(){if(X.forEach(function(Ie){let Le=Ve.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&X.delete(Ie)}),X.size===0){$(T);return}setTimeout(Te,10)}Ke.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let bo=null;function kf(T){bo&&bo(T)}function uc(){Is.stop()}function cs(){Is.start()}let Is=new Ly;Is.setAnimationLoop(kf),typeof self<"u"&&Is.setContext(self),this.setAnimationLoop=function(T){bo=T,ce.setAnimationLoop(T),T===null?Is.stop():Is.start()},ce.addEventListener("sessionstart",uc),ce.addEventListener("sessionend",cs),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;B!==null&&B.renderStart(T,z);let j=ce.enabled===!0&&ce.isPresenting===!0,X=k!==null&&(le===null||j)&&k.begin(N,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(N,T,z,le),C=te.get(T,E.length),C.init(z),C.state.textureUnits=$e.getTextureUnits(),E.push(C),kt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?en.setFromArrayCamera(z):it.setFromProjectionMatrix(kt,Ui,z.reversedDepth),_n=this.localClippingEnabled,Ht=ie.init(this.clippingPlanes,_n),P=ye.get(T,v.length),P.init(),v.push(P),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=N.xr.getDepthSensingMesh();Ie!==null&&Ls(Ie,z,-1/0,N.sortObjects)}Ls(T,z,0,N.sortObjects),P.finish(),B!==null&&B.updateLights(C.state.lightsArray),N.sortObjects===!0&&P.sort(qe,rt),cn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,cn&&F.addToRenderList(P,T),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&ie.beginShadows();let $=C.state.shadowsArray;if(pe.render($,T,z),Ht===!0&&ie.endShadows(),(X&&k.hasRenderPass())===!1){let Ie=P.opaque,Ee=P.transmissive;if(C.setupLights(),z.isArrayCamera){let Le=z.cameras;if(Ee.length>0)for(let ze=0,Qe=Le.length;ze<Qe;ze++){let dt=Le[ze];Gi(Ie,Ee,T,dt)}cn&&F.render(T);for(let ze=0,Qe=Le.length;ze<Qe;ze++){let dt=Le[ze];Va(P,T,dt,dt.viewport)}}else Ee.length>0&&Gi(Ie,Ee,T,z),cn&&F.render(T),Va(P,T,z)}le!==null&&G===0&&($e.updateMultisampleRenderTarget(le),$e.updateRenderTargetMipmap(le)),X&&k.end(N),T.isScene===!0&&T.onAfterRender(N,T,z),be.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(C=E[E.length-1],$e.setTextureUnits(C.state.textureUnits),Ht===!0&&ie.setGlobalState(N.clippingPlanes,C.state.camera)):C=null,v.pop(),v.length>0?P=v[v.length-1]:P=null,B!==null&&B.renderEnd()};function Ls(T,z,j,X){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)C.pushLight(T),T.castShadow&&C.pushShadow(T);else if(T.isSprite){let Ie=z.isArrayCamera?en:it;if(!T.frustumCulled||T.intersectsFrustum(Ie)){X&&Mt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(kt);let Ee=ue.update(T),Le=T.material;Le.visible&&P.push(T,Ee,Le,j,Mt.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Ie=z.isArrayCamera?en:it;if(!T.frustumCulled||T.intersectsFrustum(Ie)){let Ee=ue.update(T),Le=T.material;if(X&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Mt.copy(T.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),Mt.copy(Ee.boundingSphere.center)),Mt.applyMatrix4(T.matrixWorld).applyMatrix4(kt)),Array.isArray(Le)){let ze=Ee.groups;for(let Qe=0,dt=ze.length;Qe<dt;Qe++){let Be=ze[Qe],pt=Le[Be.materialIndex];pt&&pt.visible&&P.push(T,Ee,pt,j,Mt.z,Be,z)}}else Le.visible&&P.push(T,Ee,Le,j,Mt.z,null,z)}}}let Te=T.children;for(let Ie=0,Ee=Te.length;Ie<Ee;Ie++)Ls(Te[Ie],z,j,X)}function Va(T,z,j,X){let{opaque:$,transmissive:Te,transparent:Ie}=T;C.setupLightsView(j),Ht===!0&&ie.setGlobalState(N.clippingPlanes,j),X&&Me.viewport(se.copy(X)),$.length>0&&un($,z,j),Te.length>0&&un(Te,z,j),Ie.length>0&&un(Ie,z,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Gi(T,z,j,X){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[X.id]===void 0){let Be=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[X.id]=new wi(1,1,{generateMipmaps:!0,type:Be?ts:Ci,minFilter:Ks,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Te=C.state.transmissionRenderTarget[X.id],Ie=X.viewport||se;Te.setSize(Ie.z*N.transmissionResolutionScale,Ie.w*N.transmissionResolutionScale);let Ee=N.getRenderTarget(),Le=N.getActiveCubeFace(),ze=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),cn&&F.render(j);let Qe=N.toneMapping;N.toneMapping=ws;let dt=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),C.setupLightsView(X),Ht===!0&&ie.setGlobalState(N.clippingPlanes,X),un(T,j,X),$e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let pt=0,sn=z.length;pt<sn;pt++){let Nt=z[pt],{object:Ut,geometry:An,material:Fe,group:yn}=Nt;if(Fe.side===Oi&&Ut.layers.test(X.layers)){let _t=Fe.side;Fe.side=oi,Fe.needsUpdate=!0,pn(Ut,j,X,An,Fe,yn),Fe.side=_t,Fe.needsUpdate=!0,Be=!0}}Be===!0&&($e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ee,Le,ze),N.setClearColor(ee,me),dt!==void 0&&(X.viewport=dt),N.toneMapping=Qe}function un(T,z,j){let X=z.isScene===!0?z.overrideMaterial:null;for(let $=0,Te=T.length;$<Te;$++){let Ie=T[$],{object:Ee,geometry:Le,group:ze}=Ie,Qe=Ie.material;Qe.allowOverride===!0&&X!==null&&(Qe=X),Ee.layers.test(j.layers)&&pn(Ee,z,j,Le,Qe,ze)}}function pn(T,z,j,X,$,Te){B!==null&&$.isNodeMaterial&&B.setObject(T,$),T.onBeforeRender(N,z,j,X,$,Te),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),$.onBeforeRender(N,z,j,X,T,Te),$.transparent===!0&&$.side===Oi&&$.forceSinglePass===!1?($.side=oi,$.needsUpdate=!0,N.renderBufferDirect(j,z,X,$,T,Te),$.side=Lr,$.needsUpdate=!0,N.renderBufferDirect(j,z,X,$,T,Te),$.side=Oi):N.renderBufferDirect(j,z,X,$,T,Te),T.onAfterRender(N,z,j,X,$,Te)}function mn(T){let z=0;for(let j of T)j.texture!==null&&z++;return z}function us(T,z,j){z.isScene!==!0&&(z=En);let X=Ve.get(T),$=C.state.lights,Te=C.state.shadowsArray,Ie=$.state.version,Ee=oe.getParameters(T,$.state,Te,z,j,C.state.lightProbeGridArray),Le=oe.getProgramCacheKey(Ee),ze=X.programs;X.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,X.fog=z.fog;let Qe=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;X.envMap=R.get(T.envMap||X.environment,Qe),X.envMapRotation=X.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",at),ze=new Map,X.programs=ze,X.programVariants=new Map);let dt=ze.get(Le);if(dt!==void 0){if(X.currentProgram===dt&&X.lightsStateVersion===Ie)return Ga(T,Ee),dt}else Ee.uniforms=oe.getUniforms(T),B!==null&&T.isNodeMaterial&&B.build(T,j,Ee),T.onBeforeCompile(Ee,N),dt=oe.acquireProgram(Ee,Le),ze.set(Le,dt),X.uniforms=Ee.uniforms;let Be=X.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Be.clippingPlanes=ie.uniform),Ga(T,Ee),X.needsLights=sr(T),X.lightsStateVersion=Ie,X.needsLights&&(Be.ambientLightColor.value=$.state.ambient,Be.lightProbe.value=$.state.probe,Be.sunLights.value=$.state.sun,Be.sunLightShadows.value=$.state.sunShadow,Be.directionalLights.value=$.state.directional,Be.directionalLightShadows.value=$.state.directionalShadow,Be.spotLights.value=$.state.spot,Be.spotLightShadows.value=$.state.spotShadow,Be.rectAreaLights.value=$.state.rectArea,Be.ltc_1.value=$.state.rectAreaLTC1,Be.ltc_2.value=$.state.rectAreaLTC2,Be.pointLights.value=$.state.point,Be.pointLightShadows.value=$.state.pointShadow,Be.hemisphereLights.value=$.state.hemi,Be.sunShadowMatrix.value=$.state.sunShadowMatrix,Be.sunShadowCascade.value=$.state.sunShadowCascade,Be.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Be.spotLightMatrix.value=$.state.spotLightMatrix,Be.spotLightMap.value=$.state.spotLightMap,Be.pointShadowMatrix.value=$.state.pointShadowMatrix),X.numLightProbeGrids=mn(C.state.lightProbeGridArray),X.currentProgram=dt,X.uniformsList=null,dt}function fi(T,z,j,X,$){let Te=Ve.get(T),Ie=Te.currentProgram.id+","+X+","+$,Ee=Te.programVariants.get(Ie);return Ee===void 0?(Ee=us(T,z,j),Te.programVariants.set(Ie,Ee)):(Te.currentProgram=Ee,Te.uniformsList=null,Te.outputColorSpace=X,Te.toneMapping=$),Ee}function ir(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=Aa.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function Ga(T,z){let j=Ve.get(T);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function Ha(T,z,j,X,$){z.isScene!==!0&&(z=En),$e.resetTextureUnits();let Te=z.fog,Ie=X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial?z.environment:null,Ee=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:xt.workingColorSpace,Le=X.isMeshStandardMaterial||X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,ze=R.get(X.envMap||Ie,Le),Qe=X.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,dt=!!j.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Be=!!j.morphAttributes.position,pt=!!j.morphAttributes.normal,sn=!!j.morphAttributes.color,Nt=ws;X.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Nt=N.toneMapping);let Ut=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,An=Ut!==void 0?Ut.length:0,Fe=Ve.get(X),yn=C.state.lights;if(Ht===!0&&(_n===!0||T!==Q)){let Ft=T===Q&&X.id===J;ie.setState(X,T,Ft)}let _t=!1,Ds=!1;X.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==yn.state.version||$.isBatchedMesh&&Fe.batching===!1||!$.isBatchedMesh&&Fe.batching===!0||$.isBatchedMesh&&Fe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Fe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Fe.instancing===!1||!$.isInstancedMesh&&Fe.instancing===!0||$.isSkinnedMesh&&Fe.skinning===!1||!$.isSkinnedMesh&&Fe.skinning===!0||$.isInstancedMesh&&Fe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Fe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Fe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Fe.instancingMorph===!1&&$.morphTexture!==null||Fe.envMap!==ze||X.fog===!0&&Fe.fog!==Te||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ie.numPlanes||Fe.numIntersection!==ie.numIntersection)||Fe.vertexAlphas!==Qe||Fe.vertexTangents!==dt||Fe.morphTargets!==Be||Fe.morphNormals!==pt||Fe.morphColors!==sn||Fe.morphTargetsCount!==An||Fe.numLightProbeGrids!==mn(C.state.lightProbeGridArray)?_t=!0:(Fe.outputColorSpace!==Ee||Fe.toneMapping!==Nt)&&(Ds=!0):(_t=!0,Fe.__version=X.version);let xn=Fe.currentProgram;(_t===!0||Ds===!0)&&(xn=Ds===!0?fi(X,z,$,Ee,Nt):us(X,z,$),B&&X.isNodeMaterial&&B.onUpdateProgram(X,xn,Fe));let wo=!1,hs=!1,Ns=!1,ut=xn.getUniforms(),hn=Fe.uniforms;if(Me.useProgram(xn.program)&&(wo=!0,hs=!0,Ns=!0),X.id!==J&&(J=X.id,hs=!0),wo||Q!==T){Me.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ut.setValue(O,"projectionMatrix",T.projectionMatrix),ut.setValue(O,"viewMatrix",T.matrixWorldInverse);let bn=ut.map.cameraPosition;bn!==void 0&&bn.setValue(O,On.setFromMatrixPosition(T.matrixWorld)),ot.logarithmicDepthBuffer&&ut.setValue(O,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&ut.setValue(O,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,hs=!0,Ns=!0)}if(Fe.needsLights&&(yn.state.sunShadowMap.length>0&&ut.setValue(O,"sunShadowMap",yn.state.sunShadowMap,$e),yn.state.directionalShadowMap.length>0&&ut.setValue(O,"directionalShadowMap",yn.state.directionalShadowMap,$e),yn.state.spotShadowMap.length>0&&ut.setValue(O,"spotShadowMap",yn.state.spotShadowMap,$e),yn.state.pointShadowMap.length>0&&ut.setValue(O,"pointShadowMap",yn.state.pointShadowMap,$e)),$.isSkinnedMesh){ut.setOptional(O,$,"bindMatrix"),ut.setOptional(O,$,"bindMatrixInverse");let Ft=$.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),ut.setValue(O,"boneTexture",Ft.boneTexture,$e))}$.isBatchedMesh&&(ut.setOptional(O,$,"batchingTexture"),ut.setValue(O,"batchingTexture",$._matricesTexture,$e),ut.setOptional(O,$,"batchingIdTexture"),ut.setValue(O,"batchingIdTexture",$._indirectTexture,$e),ut.setOptional(O,$,"batchingColorTexture"),$._colorsTexture!==null&&ut.setValue(O,"batchingColorTexture",$._colorsTexture,$e));let Qn=j.morphAttributes;if((Qn.position!==void 0||Qn.normal!==void 0||Qn.color!==void 0)&&re.update($,j,xn),(hs||Fe.receiveShadow!==$.receiveShadow)&&(Fe.receiveShadow=$.receiveShadow,ut.setValue(O,"receiveShadow",$.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&z.environment!==null&&(hn.envMapIntensity.value=z.environmentIntensity),hn.dfgLUT!==void 0&&(hn.dfgLUT.value=dP()),hs){if(ut.setValue(O,"toneMappingExposure",N.toneMappingExposure),Fe.needsLights&&So(hn,Ns),Te&&X.fog===!0&&_e.refreshFogUniforms(hn,Te),_e.refreshMaterialUniforms(hn,X,Se,Ae,C.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ft=S,bn=0;for(let $n of C.state.lightProbeGridArray)$n.texture!==null&&(Ft.textures[bn]=$n.texture,Ft.min[bn]=$n.boundingBox.min,Ft.max[bn]=$n.boundingBox.max,Ft.resolution[bn]=$n.resolution,bn++);for(let $n in Ft)Ft[$n].length=bn;hn.probesSH.value=Ft.textures,hn.probesMin.value=Ft.min,hn.probesMax.value=Ft.max,hn.probesResolution.value=Ft.resolution}Aa.upload(O,ir(Fe),hn,$e)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(Aa.upload(O,ir(Fe),hn,$e),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&ut.setValue(O,"center",$.center),ut.setValue(O,"modelViewMatrix",$.modelViewMatrix),ut.setValue(O,"normalMatrix",$.normalMatrix),ut.setValue(O,"modelMatrix",$.matrixWorld),X.uniformsGroups!==void 0){let Ft=X.uniformsGroups;for(let bn=0,$n=Ft.length;bn<$n;bn++){let hc=Ft[bn];We.update(hc,xn),We.bind(hc,xn)}}return xn}function So(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function sr(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,z,j){let X=Ve.get(T);X.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),Ve.get(T.texture).__webglTexture=z,Ve.get(T.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?void 0:j,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let j=Ve.get(T);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,j=0){le=T,Y=z,G=j;let X=null,$=!1,Te=!1;if(T){let Ee=Ve.get(T);if(Ee.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(O.FRAMEBUFFER,Ee.__webglFramebuffer),se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest,Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),J=-1;return}else if(Ee.__webglFramebuffer===void 0)$e.setupRenderTarget(T);else if(Ee.__hasExternalTextures)$e.rebindTextures(T,Ve.get(T.texture).__webglTexture,Ve.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let Qe=T.depthTexture;if(Ee.__boundDepthTexture!==Qe){if(Qe!==null&&Ve.has(Qe)&&(T.width!==Qe.image.width||T.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(T)}}let Le=T.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Te=!0);let ze=Ve.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?X=ze[z][j]:X=ze[z],$=!0):T.samples>0&&$e.useMultisampledRTT(T)===!1?X=Ve.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?X=ze[j]:X=ze,se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest}else se.copy(He).multiplyScalar(Se).floor(),fe.copy(ft).multiplyScalar(Se).floor(),he=ct;if(j!==0&&(X=V),Me.bindFramebuffer(O.FRAMEBUFFER,X)&&Me.drawBuffers(T,X),Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),$){let Ee=Ve.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ee.__webglTexture,j)}else if(Te){let Ee=z;for(let Le=0;Le<T.textures.length;Le++){let ze=Ve.get(T.textures[Le]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Le,ze.__webglTexture,j,Ee)}}else if(T!==null&&j!==0){let Ee=Ve.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ee.__webglTexture,j)}J=-1};function Mo(T){let z=Ve.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=ot.textureFormatReadable(T.format),z.__typeReadable=ot.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,j,X,$,Te,Ie,Ee=0){if(!(T&&T.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){Me.bindFramebuffer(O.FRAMEBUFFER,Le);try{let ze=T.textures[Ee],Qe=ze.format,dt=ze.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=Mo(ze);if(Be.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-X&&j>=0&&j<=T.height-$&&O.readPixels(z,j,X,$,ge.convert(Qe),ge.convert(dt),Te)}finally{let ze=le!==null?Ve.get(le).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,z,j,X,$,Te,Ie,Ee=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(z>=0&&z<=T.width-X&&j>=0&&j<=T.height-$){Me.bindFramebuffer(O.FRAMEBUFFER,Le);let ze=T.textures[Ee],Qe=ze.format,dt=ze.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=Mo(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.bufferData(O.PIXEL_PACK_BUFFER,Te.byteLength,O.STREAM_READ),O.readPixels(z,j,X,$,ge.convert(Qe),ge.convert(dt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let sn=le!==null?Ve.get(le).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,sn);let Nt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await iy(O,Nt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Te),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pt),O.deleteSync(Nt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,j=0){let X=Math.pow(2,-j),$=Math.floor(T.image.width*X),Te=Math.floor(T.image.height*X),Ie=z!==null?z.x:0,Ee=z!==null?z.y:0;$e.setTexture2D(T,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Ie,Ee,$,Te),Me.unbindTexture()},this.copyTextureToTexture=function(T,z,j=null,X=null,$=0,Te=0){let Ie,Ee,Le,ze,Qe,dt,Be,pt,sn,Nt=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(j!==null)Ie=j.max.x-j.min.x,Ee=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,Qe=j.min.y,dt=j.isBox3?j.min.z:0;else{let ut=Math.pow(2,-$);Ie=Math.floor(Nt.width*ut),Ee=Math.floor(Nt.height*ut),T.isDataArrayTexture?Le=Nt.depth:T.isData3DTexture?Le=Math.floor(Nt.depth*ut):Le=1,ze=0,Qe=0,dt=0}X!==null?(Be=X.x,pt=X.y,sn=X.z):(Be=0,pt=0,sn=0);let Ut=ge.convert(z.format),An=ge.convert(z.type),Fe;z.isData3DTexture?($e.setTexture3D(z,0),Fe=O.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?($e.setTexture2DArray(z,0),Fe=O.TEXTURE_2D_ARRAY):($e.setTexture2D(z,0),Fe=O.TEXTURE_2D),Me.activeTexture(O.TEXTURE0),Me.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,z.flipY),Me.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Me.pixelStorei(O.UNPACK_ALIGNMENT,z.unpackAlignment);let yn=Me.getParameter(O.UNPACK_ROW_LENGTH),_t=Me.getParameter(O.UNPACK_IMAGE_HEIGHT),Ds=Me.getParameter(O.UNPACK_SKIP_PIXELS),xn=Me.getParameter(O.UNPACK_SKIP_ROWS),wo=Me.getParameter(O.UNPACK_SKIP_IMAGES);Me.pixelStorei(O.UNPACK_ROW_LENGTH,Nt.width),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Nt.height),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,ze),Me.pixelStorei(O.UNPACK_SKIP_ROWS,Qe),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,dt);let hs=T.isDataArrayTexture||T.isData3DTexture,Ns=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let ut=Ve.get(T),hn=Ve.get(z),Qn=Ve.get(ut.__renderTarget),Ft=Ve.get(hn.__renderTarget);Me.bindFramebuffer(O.READ_FRAMEBUFFER,Qn.__webglFramebuffer),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let bn=0;bn<Le;bn++)hs&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(T).__webglTexture,$,dt+bn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(z).__webglTexture,Te,sn+bn)),O.blitFramebuffer(ze,Qe,ze+Ie,Qe+Ee,Be,pt,Be+Ie,pt+Ee,O.DEPTH_BUFFER_BIT,O.NEAREST);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if($!==0||T.isRenderTargetTexture||Ve.has(T)){let ut=Ve.get(T),hn=Ve.get(z);Me.bindFramebuffer(O.READ_FRAMEBUFFER,U),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let Qn=0;Qn<Le;Qn++)hs?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ut.__webglTexture,$,dt+Qn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ut.__webglTexture,$),Ns?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,hn.__webglTexture,Te,sn+Qn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,hn.__webglTexture,Te),$!==0?O.blitFramebuffer(ze,Qe,ze+Ie,Qe+Ee,Be,pt,Be+Ie,pt+Ee,O.COLOR_BUFFER_BIT,O.NEAREST):Ns?O.copyTexSubImage3D(Fe,Te,Be,pt,sn+Qn,ze,Qe,Ie,Ee):O.copyTexSubImage2D(Fe,Te,Be,pt,ze,Qe,Ie,Ee);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Ns?T.isDataTexture||T.isData3DTexture?O.texSubImage3D(Fe,Te,Be,pt,sn,Ie,Ee,Le,Ut,An,Nt.data):z.isCompressedArrayTexture?O.compressedTexSubImage3D(Fe,Te,Be,pt,sn,Ie,Ee,Le,Ut,Nt.data):O.texSubImage3D(Fe,Te,Be,pt,sn,Ie,Ee,Le,Ut,An,Nt):T.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Ie,Ee,Ut,An,Nt.data):T.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Te,Be,pt,Nt.width,Nt.height,Ut,Nt.data):O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Ie,Ee,Ut,An,Nt);Me.pixelStorei(O.UNPACK_ROW_LENGTH,yn),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,_t),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,Ds),Me.pixelStorei(O.UNPACK_SKIP_ROWS,xn),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,wo),Te===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&O.generateMipmap(Fe),Me.unbindTexture()},this.initRenderTarget=function(T){Ve.get(T).__webglFramebuffer===void 0&&$e.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?$e.setTextureCube(T,0):T.isData3DTexture?$e.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?$e.setTexture2DArray(T,0):$e.setTexture2D(T,0),Me.unbindTexture()},this.resetState=function(){Y=0,G=0,le=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ui}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};var Hy={type:"change"},mm={type:"start"},qy={type:"end"},Qh=new so,Wy=new Si,mP=Math.cos(70*Qp.DEG2RAD),Nn=new K,ui=2*Math.PI,It={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},pm=1e-6,ef=class extends Bl{constructor(e,t=null){super(e,t),this.state=It.NONE,this.target=new K,this.cursor=new K,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Pr.ROTATE,MIDDLE:Pr.DOLLY,RIGHT:Pr.PAN},this.touches={ONE:Ir.ROTATE,TWO:Ir.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new K,this._lastQuaternion=new Mi,this._lastTargetPosition=new K,this._quat=new Mi().setFromUnitVectors(e.up,new K(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ba,this._sphericalDelta=new ba,this._scale=1,this._panOffset=new K,this._rotateStart=new tt,this._rotateEnd=new tt,this._rotateDelta=new tt,this._panStart=new tt,this._panEnd=new tt,this._panDelta=new tt,this._dollyStart=new tt,this._dollyEnd=new tt,this._dollyDelta=new tt,this._dollyDirection=new K,this._mouse=new tt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=_P.bind(this),this._onPointerDown=gP.bind(this),this._onPointerUp=vP.bind(this),this._onContextMenu=TP.bind(this),this._onMouseWheel=bP.bind(this),this._onKeyDown=SP.bind(this),this._onTouchStart=MP.bind(this),this._onTouchMove=wP.bind(this),this._onMouseDown=yP.bind(this),this._onMouseMove=xP.bind(this),this._interceptControlDown=EP.bind(this),this._interceptControlUp=AP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=It.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Hy),this.update(),this.state=It.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Nn.copy(t).sub(this.target),Nn.applyQuaternion(this._quat),this._spherical.setFromVector3(Nn),this.autoRotate&&this.state===It.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ui:i>Math.PI&&(i-=ui),s<-Math.PI?s+=ui:s>Math.PI&&(s-=ui),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Nn.setFromSpherical(this._spherical),Nn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Nn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Nn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new K(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new K(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Nn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Qh.origin.copy(this.object.position),Qh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Qh.direction))<mP?this.object.lookAt(this.target):(Wy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Qh.intersectPlane(Wy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>pm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>pm||this._lastTargetPosition.distanceToSquared(this.target)>pm?(this.dispatchEvent(Hy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ui/60*this.autoRotateSpeed*e:ui/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Nn.setFromMatrixColumn(t,0),Nn.multiplyScalar(-e),this._panOffset.add(Nn)}_panUp(e,t){this.screenSpacePanning===!0?Nn.setFromMatrixColumn(t,1):(Nn.setFromMatrixColumn(t,0),Nn.crossVectors(this.object.up,Nn)),Nn.multiplyScalar(e),this._panOffset.add(Nn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Nn.copy(s).sub(this.target);let r=Nn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/t.clientHeight),this._rotateUp(ui*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/t.clientHeight),this._rotateUp(ui*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function gP(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function _P(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function vP(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(qy),this.state=It.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function yP(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Pr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=It.DOLLY;break;case Pr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=It.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=It.ROTATE}break;case Pr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=It.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=It.PAN}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(mm)}function xP(n){switch(this.state){case It.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case It.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case It.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function bP(n){this.enabled===!1||this.enableZoom===!1||this.state!==It.NONE||(n.preventDefault(),this.dispatchEvent(mm),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(qy))}function SP(n){this.enabled!==!1&&this._handleKeyDown(n)}function MP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ir.ROTATE:if(this.enableRotate===!1){this.state=It.NONE;break}this._handleTouchStartRotate(n),this.state=It.TOUCH_ROTATE;break;case Ir.PAN:if(this.enablePan===!1){this.state=It.NONE;break}this._handleTouchStartPan(n),this.state=It.TOUCH_PAN;break;default:this.state=It.NONE}break;case 2:switch(this.touches.TWO){case Ir.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=It.TOUCH_DOLLY_PAN;break;case Ir.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=It.TOUCH_DOLLY_ROTATE;break;default:this.state=It.NONE}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(mm)}function wP(n){switch(this._trackPointer(n),this.state){case It.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case It.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case It.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case It.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=It.NONE}}function TP(n){this.enabled!==!1&&n.preventDefault()}function EP(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function AP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var CP=`
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
}`,RP=`
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`,PP=`
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`,IP={oblique:[.45,-.8,.45],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},tf=class{constructor(e,t,i){this.data=e;this.canvas=t;this.renderer=new Zh({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),this.vectors=e.header.extra.lattice_vectors,this.period=Math.hypot(...this.vectors[0]);let s=Float32Array.from(e.values("skin_position"),u=>u/this.period),r={position:new ri(s,3),real:new ri(new Float32Array(s.length),3),imag:new ri(new Float32Array(s.length),3)};for(let u of[this.surface,this.edges])for(let[h,d]of Object.entries(r))u.setAttribute(h,d);this.surface.setIndex(DP(e.values("skin_face"))),this.edges.setIndex(Array.from(e.values("skin_edge"))),this.box.setFromBufferAttribute(r.position);let o=new ro(Uint8Array.from(i.flatMap(([u=0,h=0,d=0])=>[u,h,d,255])),i.length,1);o.minFilter=o.magFilter=qn,o.needsUpdate=!0,this.uniforms.scale.value=o;let a={uniforms:this.uniforms,vertexShader:CP},l=new Fi(this.surface,new Ei({...a,fragmentShader:RP,side:Oi,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),c=new Ll(this.edges,new Ei({...a,fragmentShader:PP}));for(let u of[l,c])u.frustumCulled=!1,this.scene.add(u);this.camera.up.set(0,0,1),this.controls=new ef(this.camera,t),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.colourLines()}data;canvas;renderer;scene=new Rl;camera=new si(28,1,.01,100);controls;uniforms={phase:{value:new tt(1,0)},swing:{value:.15},scale:{value:new ro(new Uint8Array(4),1,1)},ink:{value:new bt(0,0,0)}};surface=new ya;edges=new ya;period;vectors;box=new Ss;copies=[1,1];kappa=[0,0];frames=0;turns=[];show({row:e,band:t},i){let[,s=0,r=0]=this.data.shape("path_mode_real"),o=(e*s+t)*r,a=this.data.values("path_shape");for(let l of["real","imag"]){let c=`path_mode_${l}`,u=this.data.values(c).subarray(o,o+r),h=this.data.scale(c)*this.data.scale("path_shape"),d=this.surface.getAttribute(l);LP(d.array,a,u,h),d.needsUpdate=!0}this.kappa=i,this.place()}repeat(e){this.copies=e,this.place(),this.look("oblique")}set swing(e){this.uniforms.swing.value=e}turn(e){this.uniforms.phase.value.set(Math.cos(2*Math.PI*e),Math.sin(2*Math.PI*e)),this.draw()}draw(){this.frames++,this.renderer.render(this.scene,this.camera)}look(e){let[t,i]=this.copies,s=this.box.clone();for(let[c,u]of[[t-1,0],[0,i-1],[t-1,i-1]])s.union(this.box.clone().translate(this.shift(c,u)));let r=s.getBoundingSphere(new $s),o=this.camera.fov*Math.PI/360,a=Math.atan(Math.tan(o)*Math.min(1,this.camera.aspect)),l=1.08*r.radius/Math.sin(a);this.controls.target.copy(r.center),this.camera.position.set(...IP[e]).normalize().multiplyScalar(l).add(r.center),this.camera.near=.01*l,this.camera.far=10*l,this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}resize(e,t){this.renderer.setPixelRatio(devicePixelRatio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix()}colourLines(){this.uniforms.ink.value.set(Ge("ink"))}dispose(){this.controls.dispose(),this.surface.dispose(),this.edges.dispose(),this.uniforms.scale.value.dispose(),this.renderer.dispose()}shift(e,t){let[[i,s],[r,o]]=this.vectors;return new K((e*i+t*r)/this.period,(e*s+t*o)/this.period,0)}place(){let[e,t]=this.copies,i=[],s=[];for(let r=0;r<e;r++)for(let o=0;o<t;o++){let a=r*this.kappa[0]+o*this.kappa[1];i.push(...this.shift(r,o).toArray()),s.push(Math.cos(a),Math.sin(a))}this.turns=s;for(let r of[this.surface,this.edges])r.instanceCount=e*t,r.setAttribute("origin",new _a(Float32Array.from(i),3)),r.setAttribute("turn",new _a(Float32Array.from(s),2))}};function LP(n,e,t,i){n.fill(0);for(let s=0;s<t.length;s++){let r=(t[s]??0)*i;if(r===0)continue;let o=s*n.length;for(let a=0;a<n.length;a++)n[a]+=r*e[o+a]}}function DP(n){let e=[];for(let t=0;t<n.length;t+=4){let[i,s,r,o]=n.subarray(t,t+4);e.push(i,s,r,i,r,o)}return e}var NP=[["oblique","oblique"],["x","along x"],["y","along y"],["z","from above"]];function Xy({diagram:n,choice:e}){let t=vt(null),i=vt(null),[s,r]=Ot("");return Rt(()=>{if(t.current===null)return;let o;try{o=new tf(n.data,t.current,$y(n))}catch{r("The mode cannot be drawn, because this browser has no WebGL.");return}return i.current=o,Object.assign(t.current,{moving:o}),FP(o,n,e)},[n,e]),f("div",{class:"mode",children:[s?f("p",{role:"alert",children:s}):f("canvas",{ref:t,role:"img","aria-label":"The cell moving in the selected mode"}),f("p",{class:"scale",children:[f("span",{children:"0"}),f("span",{class:"bar",style:{background:UP(n)}}),f("span",{children:"1"})," displacement, relative to the largest"]}),f("p",{class:"sides",children:[f("span",{id:"seen",children:"Seen"}),NP.map(([o,a])=>f("button",{type:"button",onClick:()=>i.current?.look(o),"aria-describedby":"seen",children:a}))]}),f(iu,{canvas:t,name:"mode",caption:`${n.data.header.title}, ${rl(n.data)}`})]})}function $y(n){return n.data.header.extra.colours}function UP(n){return`linear-gradient(to right, ${$y(n).map(e=>`rgb(${e.join(" ")})`).join(", ")})`}function FP(n,e,t){let{canvas:i}=n,s=()=>n.turn(r.moment),r=new Zo(t,s);nu(i,l=>r.at(l));let o=new ResizeObserver(()=>{n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1)),n.look("oblique")});n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1));let a=[lt(()=>n.repeat(t.copies.value)),lt(()=>{let l=t.point.value;n.show(l,e.phases(l.row)),i.dataset.shown=`${l.row},${l.band}`,s()}),lt(()=>{n.swing=t.swing.value,s()}),_s(()=>{n.colourLines(),n.draw()})];return o.observe(i),()=>{r.end(),o.disconnect();for(let l of a)l();n.dispose()}}function Yy({diagram:n,unit:e}){let{factor:t}=e;return n.gaps.length===0?f("p",{children:"The computed bands have no gap."}):f("div",{class:"wide",children:f("table",{children:[f("caption",{children:"Gaps"}),f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"bands"}),f("th",{scope:"col",children:"where"}),f("th",{scope:"col",children:qi("lower",e)}),f("th",{scope:"col",children:qi("upper",e)})]})}),f("tbody",{children:n.gaps.map(i=>f("tr",{children:[f("td",{children:[i.waves==="all"?"":`${i.waves} `,i.below,"-",i.below+1]}),f("td",{children:i.complete?"everywhere (complete)":i.waves==="all"?`${i.direction} only`:"everywhere, these waves only"}),f("td",{children:Ii(i.lower/t,i.lowerError/t)}),f("td",{children:Ii(i.upper/t,i.upperError/t)})]}))})]})})}function Ky({diagram:n,choice:e}){let{row:t,band:i}=e.point.value,s=e.unit.value,{factor:r}=s,o=Array.from({length:n.bands},(a,l)=>({row:t,band:l}));return f("div",{class:"wide",children:f("table",{children:[f("caption",{children:["Modes at ",n.place(t)]}),f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"band"}),f("th",{scope:"col",children:qi("frequency",s)}),f("th",{scope:"col",children:"motion"}),f("th",{scope:"col",children:"symmetry"}),f("th",{scope:"col",children:"show"})]})}),f("tbody",{children:o.map(a=>f("tr",{"aria-current":a.band===i?"true":void 0,children:[f("td",{children:a.band+1}),f("td",{children:Ii(n.at(a)/r,n.errorAt(a)/r)}),f("td",{children:n.nature(a)}),f("td",{children:n.parity(a)}),f("td",{children:f("button",{type:"button",onClick:()=>e.point.value=a,children:["band ",a.band+1]})})]}))})]})})}function Jy(n){return f(kP,{data:n})}var OP="Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of the model.";function kP({data:n}){let e=Zt(()=>new Xc(n),[n]),t=Zt(()=>I_(e),[e]),i=Zt(()=>U_(e,t),[e,t]);return f(fr,{name:"bands",data:n,keys:i,foot:OP,children:[f("div",{class:"pair",children:[f("section",{"aria-label":"Band diagram",children:[f("div",{class:"walk",tabIndex:0,role:"application","aria-label":"Band diagram. Arrow keys move along the path and between bands.","aria-describedby":"point",children:f(R_,{diagram:e,choice:t})}),f("p",{class:"axes",children:[f(Fo,{title:"Frequencies in",units:e.units,unit:t.unit}),f(BP,{diagram:e})]})]}),f("section",{"aria-label":"Mode",children:[f(Xy,{diagram:e,choice:t}),f(zP,{diagram:e,choice:t}),f(VP,{choice:t})]})]}),f(pr,{listing:t.listing,keys:i,children:[f(Yy,{diagram:e,unit:t.unit.value}),f(Ky,{diagram:e,choice:t})]})]})}function BP({diagram:n}){return f("span",{class:"legend",children:[n.gaps.some(e=>e.complete)&&f("span",{class:"of-gap",children:"complete gap"}),n.gaps.some(e=>e.waves!=="all")&&f("span",{class:"of-parity",children:"gap of one parity"}),n.carrier!==void 0&&f("span",{class:"of-carrier",children:"carrier"})]})}function zP({diagram:n,choice:e}){let t=e.point.value,i=e.unit.value,s=n.velocity(t),r=[["motion",n.nature(t)],["symmetry",n.parity(t)],["group velocity",s?`${Math.hypot(...s).toPrecision(3)} m/s`:"not defined"]].filter(([,a])=>a),o=n.place(t.row);return f("div",{class:"facts",children:[f("p",{id:"point","aria-live":"polite",children:["Band ",t.band+1," at ",o,": ",f("b",{children:Bo(Ii(n.at(t)/i.factor,n.errorAt(t)/i.factor),i)})]}),f("dl",{children:r.map(([a,l])=>f("div",{children:[f("dt",{children:a}),f("dd",{children:l})]}))}),f("p",{class:"again",children:["The same mode as a picture: ",f("code",{children:['haptonic bands STUDY --modes-at "',o,'"']})," or, in Python,"," ",f("code",{children:['study.bands(modes_at="',o,'").plot("modes")']})]})]})}function VP({choice:n}){let[e,t]=n.copies.value;return f("div",{class:"controls",children:[f(Cc,{playing:n.playing}),f("label",{children:["largest displacement, share of the period: ",n.swing.value.toFixed(2),f("input",{type:"range",min:"0",max:Kc,step:"0.01",value:n.swing.value,onInput:i=>n.swing.value=Number(i.currentTarget.value)})]}),f(Rc,{pace:n.pace}),f("label",{children:["cells along a1",f("input",{type:"number",min:"1",max:Yc,value:e,onChange:i=>n.copies.value=[Zy(i.currentTarget.value),t]})]}),f("label",{children:["cells along a2",f("input",{type:"number",min:"1",max:Yc,value:t,onChange:i=>n.copies.value=[e,Zy(i.currentTarget.value)]})]})]})}function Zy(n){let e=Math.round(Number(n));return Number.isFinite(e)?Math.min(Math.max(e,1),Yc):1}var GP=250,jy=1e6,HP=["low","high","value"];function Qy({data:n,finger:e}){let t=vt(null);return Rt(()=>{if(t.current!==null)return WP(t.current,n,e)},[n,e]),f(Tt,{children:[f("div",{class:"curves",ref:t}),f("p",{class:"legend",children:[f("span",{class:"of-curve",children:[f("svg",{width:"34",height:"8","aria-hidden":"true",children:f("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:"var(--curve-0)"})})," ","model"]}),f("span",{class:"of-gap",children:"its interval"}),f("span",{class:"of-carrier",children:"people notice less than this"})]})]})}function WP(n,e,t){let i=Array.from(e.amplitudes,c=>c*jy),s=()=>[i,...HP.map(c=>Array.from(t.law.value[c]))],r={stroke:()=>Ge("ink"),ticks:{stroke:()=>Ge("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},o=()=>({width:vs(n),height:GP}),a={width:0,points:{show:!1}},l=new jt({...o(),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,distr:3},y:{range:[0,1.02]}},bands:[{series:[2,1],fill:()=>Ge("gap")}],axes:[{...r,label:`${e.data.title("table")} / µm`,labelSize:22,size:34,values:(c,u)=>u.map(h=>Number.isInteger(Math.round(1e6*Math.log10(h))/1e6)?String(h):"")},{...r,label:e.data.title("load_sharing"),labelSize:24,size:50}],series:[{},a,a,{stroke:()=>Ge("curve-0"),width:2,points:{show:!1}}],hooks:{draw:[c=>qP(c,e,t)]}},s(),n);return ys(l,n,o,[lt(()=>l.setData(s())),lt(()=>{t.below.value,l.redraw(!1,!1)})])}function qP({ctx:n,bbox:e,valToPos:t},i,s){let{amplitude:r,friction:o}=s.below.peek(),a=t(1-i.extra.weber,"y",!0),[l,c]=[t(Math.max(r.value*jy,.001),"x",!0),t(o.value,"y",!0)];n.save(),n.strokeStyle=Ge("carrier"),n.lineWidth=1.5*devicePixelRatio,n.setLineDash([7*devicePixelRatio,5*devicePixelRatio]),n.beginPath(),n.moveTo(e.left,a),n.lineTo(e.left+e.width,a),n.stroke(),n.setLineDash([]),n.strokeStyle=n.fillStyle=Ge("accent"),n.beginPath(),n.moveTo(l,e.top),n.lineTo(l,e.top+e.height),n.stroke(),n.beginPath(),n.arc(l,c,5*devicePixelRatio,0,2*Math.PI),n.fill(),n.restore()}var ex=["value","low","high"],nf=class{constructor(e){this.data=e;this.extra=e.header.extra,this.forces=e.values("force"),this.speeds=e.values("speed"),this.amplitudes=e.values("table"),this.x=e.values("x"),this.y=e.values("y"),this.columns=[...new Set(this.x)].sort((s,r)=>s-r),this.rows=[...new Set(this.y)].sort((s,r)=>s-r),this.cells=new Int32Array(this.columns.length*this.rows.length).fill(-1);let[t,i]=[this.columns,this.rows].map(s=>new Map(s.map((r,o)=>[r,o])));this.x.forEach((s,r)=>{this.cells[(i?.get(this.y[r]??0)??0)*this.columns.length+(t?.get(s)??0)]=r})}data;extra;forces;speeds;amplitudes;x;y;columns;rows;cells;get count(){return this.x.length}placeIn(e,t){if(t<0||t>=this.columns.length)return null;let i=this.cells[e*this.columns.length+t]??-1;return i<0?null:i}nearest([e,t]){let[i,s]=[0,1/0];for(let r=0;r<this.count;r++){let o=((this.x[r]??0)-e)**2+((this.y[r]??0)-t)**2;o<s&&([i,s]=[r,o])}return i}beside(e,t,i){let[s,r]=[this.rows.indexOf(this.y[e]??0),this.columns.indexOf(this.x[e]??0)];return this.placeIn(s+i,r+t)??e}region(e){return this.data.texts("region")[e]||"a lattice"}amplitude(e,t,i){let s=this.data.texts("load").indexOf(t);return i*(this.data.values("amplitude")[s*this.count+e]??0)}law(e,t){let i=this.amplitudes.length,s=this.data.texts("end"),r=(c,u)=>{let h=this.data.values(c);return d=>{let p=(u*s.length+s.indexOf(d))*i;return h.subarray(p,p+i)}},[o,a]=[r("load_sharing",e),r("intermittent",t)],l=(c,u)=>{let[h,d]=[o(c),a(c)];return Float64Array.from(h,(p,_)=>Number.isNaN(p)?d[_]??NaN:u(p,d[_]??NaN))};return{value:l("value",c=>c),low:l("low",Math.min),high:l("high",Math.max)}}friction(e,t){let[i=1,s=1]=[this.amplitudes[0],this.amplitudes.at(-1)],r=e.length-1,o=Math.log(Math.max(t,i)/i)/Math.log(s/i)*r,a=Math.min(Math.floor(o),r-1),l=Math.min(o-a,1);return(e[a]??NaN)*(1-l)+(e[a+1]??NaN)*l}};function tx(n,e){return n.low>e?"noticed, also at the lower limit":n.value>e?"probably noticed; the lower limit is below the threshold":n.high>e?"probably not noticed; the upper limit is above the threshold":"not noticed, even at the upper limit"}var jl="#1c2126",nx={ink:jl,rim:"#ffffff"};function sf(n,e,t,i=()=>!0){n.beginPath();for(let{outline:s,places:r}of e)for(let o of r)i(o)&&Ql(n,s.map(([a,l])=>[o[0]+a,o[1]+l]),t)}function rf(n,e,t){n.save(),n.strokeStyle=Ge("carrier"),n.lineWidth=4*devicePixelRatio;for(let{hold:i,ends:s}of e)n.setLineDash(i==="clamped"?[]:[5*devicePixelRatio,3*devicePixelRatio]),n.beginPath(),Ql(n,s,t),n.stroke();n.restore()}function Ql(n,e,t){e.forEach((i,s)=>s===0?n.moveTo(...t(i)):n.lineTo(...t(i))),n.closePath()}function As(n,e,t){n.beginPath(),Ql(n,e,t),n.stroke()}function Nr([n,e],[t,i]){let[s,r]=[t/2,i/2];return[[n-s,e-r],[n+s,e-r],[n+s,e+r],[n-s,e+r]]}function Ra(n,e,t,i,s=nx){let o=t.flatMap(d=>d.map((p,_)=>[i(p),i(d[(_+1)%d.length]??p)])).filter(([d,p])=>Math.abs(d[1]-p[1])<1),a=Math.min(...o.map(([d])=>d[1])),l=([d,p])=>Math.abs(d[0]-p[0]),[c]=o.filter(([d])=>d[1]<a+1).sort((d,p)=>l(p)-l(d));if(c===void 0)return;let[u,h]=c;gm(n,e,[(u[0]+h[0])/2,a+17*devicePixelRatio],s)}function gm(n,e,[t,i],s=nx){n.save(),n.font=`${13*devicePixelRatio}px system-ui, sans-serif`,n.textAlign="center",n.lineWidth=3*devicePixelRatio,n.strokeStyle=s.rim,n.fillStyle=s.ink;let r=n.measureText(e).width/2,o=Math.min(Math.max(t,r),n.canvas.width-r);n.strokeText(e,o,i),n.fillText(e,o,i),n.restore()}var XP=.62;function ix({data:n,finger:e}){let t=vt(null);Rt(()=>{if(t.current!==null)return $P(t.current,n,e)},[n,e]);let{colours:i}=n.extra,s=[0,.25,.5,.75,1].map(r=>`rgb(${(i[Math.round(r*(i.length-1))]??[]).join(" ")})`);return f("div",{class:"map",children:[f("canvas",{ref:t,role:"img","aria-label":"Map of the reduction of friction"}),f("p",{class:"scale",children:[f("span",{children:"0"}),f("span",{class:"bar",style:{background:`linear-gradient(to right, ${s.join(", ")})`}}),f("span",{children:"100 %"})," less friction below a finger with its middle there, model"]})]})}function $P(n,e,t){let[i,s]=[e.columns,e.rows],r=new ImageData(i.length,s.length),o=new OffscreenCanvas(i.length,s.length),[a,l]=[n.getContext("2d"),o.getContext("2d")];if(a===null||l===null)return()=>{};let[c,u]=[i,s].map(m=>YP(m)),h=([m,b])=>[n.width*(m-c[0])/(c[1]-c[0]),n.height*(u[1]-b)/(u[1]-u[0])],d=()=>{let{colours:m}=e.extra,[b,A]=[t.law.peek(),t.drive.peek()];s.forEach((S,P)=>i.forEach((C,v)=>{let E=e.placeIn(P,v),k=4*((s.length-1-P)*i.length+v);if(r.data[k+3]=E===null?0:255,E===null)return;let N=1-e.friction(b.value,e.amplitude(E,"value",A));(m[Math.round(Math.min(Math.max(N,0),1)*(m.length-1))]??[]).forEach((B,V)=>r.data[k+V]=B)})),l.putImageData(r,0,0)},p=()=>{a.clearRect(0,0,n.width,n.height),a.imageSmoothingEnabled=!1,a.drawImage(o,0,0,n.width,n.height),KP(a,e,h),ZP(a,e,t.place.peek(),h),n.dataset.shown=String(t.place.peek())},_=()=>{let m=(u[1]-u[0])/(c[1]-c[0]),b=Math.min(n.parentElement?.clientWidth??300,XP*innerHeight/m);n.style.width=`${b}px`,n.style.height=`${b*m}px`,n.width=Math.round(b*devicePixelRatio),n.height=Math.round(b*m*devicePixelRatio),p()},x=new ResizeObserver(_);n.parentElement!==null&&x.observe(n.parentElement);let g=[lt(()=>{t.law.value,t.drive.value,d(),p()}),lt(()=>{t.place.value,p()}),_s(p),JP(n,([m,b])=>{let A=[c[0]+m*(c[1]-c[0]),u[1]-b*(u[1]-u[0])];t.place.value=e.nearest(A)})];return()=>{x.disconnect();for(let m of g)m()}}function YP(n){let[e=0,t=e+.001]=n,i=(t-e)/2;return[e-i,(n.at(-1)??0)+i]}function KP(n,{extra:e},t){n.lineWidth=1.2*devicePixelRatio,n.strokeStyle="#ffffff";for(let i of Object.values(e.regions).flat())As(n,i,t);n.strokeStyle=Ge("quiet");for(let i of e.plate)As(n,i,t);n.strokeStyle="#ffffff",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[i,s,r,o]of Object.values(e.patches))As(n,Nr([i,s],[r,o]),t);n.setLineDash([]);for(let[i,s]of Object.entries(e.regions))Ra(n,i,s,t)}function ZP(n,e,t,i){let s=[e.x[t]??0,e.y[t]??0],[r,o]=i(s),a=i([s[0]+e.extra.diameter/2,s[1]])[0]-r;for(let[l,c]of[["#ffffff",5],[jl,2]])n.strokeStyle=l,n.lineWidth=c*devicePixelRatio,n.beginPath(),n.arc(r,o,a,0,2*Math.PI),n.moveTo(r-4*devicePixelRatio,o),n.lineTo(r+4*devicePixelRatio,o),n.moveTo(r,o-4*devicePixelRatio),n.lineTo(r,o+4*devicePixelRatio),n.stroke()}function JP(n,e){let t=i=>{if(i.type==="pointerdown")n.setPointerCapture(i.pointerId);else if(i.buttons===0)return;let s=n.getBoundingClientRect();e([(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height])};return n.addEventListener("pointerdown",t),n.addEventListener("pointermove",t),()=>{n.removeEventListener("pointerdown",t),n.removeEventListener("pointermove",t)}}var jP=5,sx=1.05;function rx(n){let{drive:e,force:t,speed:i}=n.extra,s=Pe(QP(n)),r={drive:Pe(e.value),force:Pe(n.forces.indexOf(t)),speed:Pe(n.speeds.indexOf(i))};r.force.peek()<0&&(r.force.value=0);let o=Wt(()=>n.law(r.force.value,r.speed.value)),a=Wt(()=>eI(n,o.value,s.value,r.drive.value));return{place:s,...r,listing:Pe("none"),law:o,below:a}}function QP(n){let e=n.extra.diameter/2,t=(r,o)=>r-e>=(o[0]??0)&&r+e<=(o.at(-1)??0),[i,s]=[0,-1];for(let r=0;r<n.count;r++){let o=n.amplitude(r,"value",1),a=t(n.x[r]??0,n.columns)&&t(n.y[r]??0,n.rows);o>s&&a&&([i,s]=[r,o])}return i}function eI(n,e,t,i){let s=a=>Object.fromEntries(ex.map(l=>[l,a(l)])),r=s(a=>n.amplitude(t,a,i)),o=s(a=>n.friction(e[a],r[a]));return{amplitude:r,free:n.amplitude(t,"free",i),friction:o,reduction:{value:1-o.value,low:1-o.high,high:1-o.low}}}function ox(n,e){let t=(c,u)=>h=>{for(let d=0;d<(h.shiftKey?jP:1);d++)e.place.value=n.beside(e.place.peek(),c,u)},{low:i,high:s}=n.extra.drive,r=c=>()=>e.drive.value=Math.min(Math.max(e.drive.peek()*c,i),s),o=(c,u,h)=>()=>c.value=Math.min(Math.max(c.peek()+u,0),h-1),[a,l]=[n.forces.length,n.speeds.length];return[{keys:"← → ↑ ↓",effect:"move the finger; five places with Shift",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}},{keys:"+ −",effect:"5 % more or less drive",actions:{"+":r(sx),"-":r(1/sx)}},{keys:"f F",effect:"more or less force",actions:{f:o(e.force,1,a),F:o(e.force,-1,a)}},{keys:"s S",effect:"faster or slower",actions:{s:o(e.speed,1,l),S:o(e.speed,-1,l)}},...dr(e.listing)]}var tI=.62;function ax({plate:n,choice:e}){let t=vt(null);Rt(()=>{if(t.current!==null)return nI(t.current,n,e)},[n,e]);let s=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(r=>`rgb(${(n.colours[r]??[]).join(" ")})`);return f("div",{class:"map",children:[f("canvas",{ref:t,role:"img","aria-label":"Map of the moving plate"}),f("p",{class:"scale",children:[f("span",{children:`−${fo(n.largest(e.line.value))}`}),f("span",{class:"bar",style:{background:`linear-gradient(to right, ${s.join(", ")})`}}),f("span",{children:fo(n.largest(e.line.value))})," normal displacement",n.drive]}),f(iu,{canvas:t,name:"map",caption:`${n.data.header.title}, ${rl(n.data)}`})]})}function fo(n){let[e,t]=n>=1e-6?["µm",1e6]:n>=1e-9?["nm",1e9]:["pm",1e12];return`${Number((n*Number(t)).toPrecision(3))} ${e}`}function nI(n,e,t){let{left:i,right:s,bottom:r,top:o}=e.extent,a=new ImageData(e.columns,e.rows),l=new OffscreenCanvas(e.columns,e.rows),c=n.getContext("2d"),u=l.getContext("2d");if(c===null||u===null)return()=>{};let h={frames:0},d=()=>{let m=t.line.peek();h.frames++,e.paint(a,m,e.outermost(m)+p.moment),u.putImageData(a,0,0),c.clearRect(0,0,n.width,n.height),c.imageSmoothingEnabled=!0,c.imageSmoothingQuality="high",c.drawImage(l,0,0,n.width,n.height),iI(c,e,([A,S])=>[n.width*(A-i)/(s-i),n.height*(o-S)/(o-r)],t.plan.peek()),n.dataset.shown=String(m)},p=new Zo(t,d);nu(n,m=>p.at(m));let _=()=>{let m=(o-r)/(s-i),b=n.parentElement?.clientWidth??300,A=Math.min(b,tI*innerHeight/m);n.style.width=`${A}px`,n.style.height=`${A*m}px`,n.width=Math.round(A*devicePixelRatio),n.height=Math.round(A*m*devicePixelRatio),d()},x=new ResizeObserver(_);n.parentElement!==null&&x.observe(n.parentElement),Object.assign(n,{counted:h});let g=[lt(()=>{t.line.value,t.plan.value,d()}),_s(d)];return()=>{p.end(),x.disconnect();for(let m of g)m()}}function iI(n,e,t,i){let{plate:s,regions:r,patches:o,features:a,held:l}=e.parts;n.strokeStyle=jl,n.lineWidth=1.2*devicePixelRatio;for(let c of Object.values(r).flat())As(n,c,t);i&&(n.lineWidth=.8*devicePixelRatio,sf(n,a,t),n.stroke(),rf(n,l,t)),n.lineWidth=1.2*devicePixelRatio,n.strokeStyle=Ge("quiet");for(let c of s)As(n,c,t);n.strokeStyle="#855a12",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[c,u,h,d]of Object.values(o))As(n,Nr([c,u],[h,d]),t);n.setLineDash([]);for(let[c,u]of Object.entries(r))Ra(n,c,u,t)}var sI="All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, at the nearest computed place.",rI=500;function ux(n){return f(oI,{dataset:n})}function oI({dataset:n}){let e=Zt(()=>new nf(n),[n]),t=Zt(()=>rx(e),[e]),i=Zt(()=>ox(e,t),[e,t]);return f(fr,{name:"finger",data:n,keys:i,foot:sI,children:[f("div",{class:"pair",children:[f("section",{"aria-label":"Map",children:f("div",{class:"walk",tabIndex:0,role:"application","aria-describedby":"felt","aria-label":"Finger on the plate. Arrow keys move it.",children:f(ix,{data:e,finger:t})})}),f("section",{"aria-label":"Friction",children:[f(aI,{data:e,finger:t}),f(Qy,{data:e,finger:t}),f(lI,{data:e,finger:t})]})]}),f(pr,{listing:t.listing,keys:i,children:f(cI,{data:e})})]})}function js(n,e){let t=Math.abs(n),[i,s]=t>=1||t===0?["",1]:t>=.001?["m",1e3]:["µ",1e6];return`${Number((n*Number(s)).toPrecision(3))} ${i}${e}`}var lx=n=>`${(100*n).toFixed(0)} %`;function aI({data:n,finger:e}){let{amplitude:t,free:i,friction:s,reduction:r}=e.below.value,o=e.place.value,{weber:a,frequency:l,drive:c,diameter:u}=n.extra,h=(p,_,[x,g])=>`${_(p.value)} (${_(p[x])} to ${_(p[g])})`,d=p=>p.toFixed(2);return f("div",{class:"facts",children:[f("p",{id:"felt","aria-live":"polite",children:[f("b",{children:n.region(o)}),", x = ",js(n.x[o]??0,"m"),", y = ",js(n.y[o]??0,"m"),":"," ",f("b",{children:tx(r,a)})]}),f("dl",{children:[f("div",{children:[f("dt",{children:"mu / mu0, model"}),f("dd",{children:h(s,d,["low","high"])})]}),f("div",{children:[f("dt",{children:"less friction"}),f("dd",{children:h(r,lx,["low","high"])})]}),f("div",{children:[f("dt",{children:"amplitude below the finger"}),f("dd",{children:h(t,fo,["high","low"])})]}),f("div",{children:[f("dt",{children:"without a finger"}),f("dd",{children:fo(i)})]})]}),f("p",{class:"again",children:["People notice reductions above ",lx(a),". The finger covers ",js(u,"m"),";"," ",Number((l/1e3).toFixed(3))," kHz. The same in the study:"," ",f("code",{children:["touch = ","{",' force = "',js(n.forces[e.force.value]??0,"N"),'", speed = "',js(n.speeds[e.speed.value]??0,"m/s"),'"',c.unit==="V"?`, voltage = "${js(e.drive.value,"V")}"`:""," ","}"]})]})]})}function lI({data:n,finger:e}){let{low:t,high:i,title:s,unit:r}=n.extra.drive;return f("div",{class:"controls",children:[f("label",{class:"long",children:["Drive, ",s.toLowerCase(),": ",js(e.drive.value,r),f("input",{type:"range",min:t,max:i,step:(i-t)/rI||1,value:e.drive.value,"aria-valuetext":js(e.drive.value,r),onInput:o=>e.drive.value=Number(o.currentTarget.value)})]}),f(cx,{title:n.data.title("force"),unit:"N",values:n.forces,chosen:e.force}),f(cx,{title:n.data.title("speed"),unit:"m/s",values:n.speeds,chosen:e.speed})]})}function cx({title:n,unit:e,values:t,chosen:i}){let s=js(t[i.value]??0,e);return f("label",{class:"long",children:[n,": ",s,f("input",{type:"range",min:"0",max:t.length-1,step:"1",value:i.value,"aria-valuetext":s,onInput:r=>i.value=Number(r.currentTarget.value)})]})}function cI({data:n}){return f("div",{class:"wide",children:[f("table",{children:[f("caption",{children:"Numbers of the models"}),f("thead",{children:f("tr",{children:["number","value","plausible","origin","source"].map(e=>f("th",{scope:"col",children:e}))})}),f("tbody",{children:n.extra.parameters.map(({title:e,value:t,plausible:i,mark:s,source:r})=>f("tr",{children:[e,t,i,s,r].map(o=>f("td",{children:o}))}))})]}),f("dl",{children:Object.entries(n.extra.models).map(([e,t])=>f("div",{children:[f("dt",{children:["Model of ",e]}),f("dd",{children:t})]}))})]})}var uI={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"};function of(n){let{x:e,curves:t,titles:i,height:s,limits:r,whole:o}=n,a=vt(null),l=vt(n);l.current=n;let c=vt(null);return Rt(()=>{let u=a.current;if(u===null)return;let h={...uI,stroke:()=>Ge("ink"),ticks:{stroke:()=>Ge("rule")},grid:{show:!1}},d=()=>({width:vs(u),height:s}),p=new jt({...d(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(_,x,g)=>x===null?r?.x??[0,1]:[x,g]},y:{range:(_,x,g)=>x===null?r?.y??[0,1]:[x,g]}},axes:[{...h,label:i[0],labelSize:22,size:34,...o?{incrs:[1,2,5,10]}:{}},{...h,label:i[1],labelSize:24,size:52}],series:[{},...t.map(({colour:_,dash:x,width:g,points:m})=>({stroke:()=>Ge(_),fill:()=>"transparent",dash:x??[],width:m?0:g??1.4,points:m?{show:!0,size:4,fill:()=>Ge(_),width:0}:{show:!1}}))],hooks:{drawClear:[_=>Bs(_,()=>l.current.below?.(_))],draw:[_=>Bs(_,()=>l.current.above?.(_))]}},[e,...t.map(({values:_})=>_)],u);return r?.x&&p.setScale("x",{min:r.x[0],max:r.x[1]}),r?.y&&p.setScale("y",{min:r.y[0],max:r.y[1]}),_r(p,(_,x)=>l.current.pick?.(p.posToVal(_,"x"),p.posToVal(x,"y"),p)),c.current=p,ys(p,u,d,[])},[e,t,i[0],i[1]]),Rt(()=>c.current?.redraw(!1,!1)),f("div",{class:"curves",ref:a})}function _m(n,e,t,i=[]){let{ctx:s,bbox:r}=n,o=n.valToPos(e,"x",!0);vm(s,[o,r.top],[o,r.top+r.height],t,i)}function vm(n,e,t,i,s=[]){n.save(),n.strokeStyle=Ge(i),n.lineWidth=1.5*devicePixelRatio,n.setLineDash(s.map(r=>r*devicePixelRatio)),n.beginPath(),n.moveTo(...e),n.lineTo(...t),n.stroke(),n.restore()}function hx(n,[e,t],i){n.save(),n.beginPath(),n.arc(e,t,5*devicePixelRatio,0,2*Math.PI),n.fillStyle=Ge(i),n.strokeStyle=Ge("paper"),n.lineWidth=2*devicePixelRatio,n.fill(),n.stroke(),n.restore()}function fx(n,[e,t],i){let{ctx:s,bbox:r}=n,[o,a]=[n.valToPos(e,"x",!0),n.valToPos(t,"x",!0)];s.fillStyle=Ge(i),s.fillRect(o,r.top,a-o,r.height)}var af=class{constructor(e){this.data=e;this.frequency=e.values("frequency"),this.rows=e.values("rows"),this.kinds=e.texts("incident"),this.incident=this.kinds.filter(t=>this.losses(t).flat().some(Number.isFinite)),[this.waves=0]=e.shape("decay"),this.carrier=Number(e.header.extra.carrier),this.gap=e.header.extra.gap,this.units=Oo(e)}data;frequency;rows;incident;waves;carrier;gap;units;kinds;nearest(e){let t=Array.from(this.frequency,i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}losses(e,t="loss"){let i=this.kinds.indexOf(e)*this.rows.length;return Array.from(this.rows,(s,r)=>this.curve(t,i+r))}ofWaves(e){return Array.from({length:this.waves},(t,i)=>this.curve(e,i))}curve(e,t){let i=this.frequency.length;return Array.from(this.data.values(e).subarray(t*i,(t+1)*i))}};function lf(n){return n.map(e=>Number.isFinite(e)?e:null)}var hI="Errors are the change of a value if all frequencies of the lattice move by the bound of their relative error, and this share of the value. Waves of the lattice are shown at normal incidence.",fI=10,px=1.05,dI=60;function mx(n){return f(pI,{data:n})}function pI({data:n}){let e=Zt(()=>new af(n),[n]),t=Zt(()=>({line:Pe(e.nearest(e.carrier)),rows:Pe(e.rows.length-1),incident:Pe(e.incident[0]??""),unit:Pe(ko(e.units,Math.max(...e.frequency))),listing:Pe("none")}),[e]),i=Zt(()=>mI(e,t),[e,t]);return f(fr,{name:"mirror",data:n,keys:i,foot:hI,children:[f("div",{class:"pair",children:[f("section",{"aria-label":"Insertion loss",children:[f("div",{class:"walk",tabIndex:0,role:"application","aria-label":"Insertion loss. Arrow keys change the frequency and the number of rows.","aria-describedby":"point",children:f(gI,{mirror:e,choice:t})}),f("p",{class:"axes",children:[f("label",{children:["Incident wave"," ",f("select",{value:t.incident.value,onChange:s=>t.incident.value=s.currentTarget.value,children:e.incident.map(s=>f("option",{children:s}))})]}),f(Fo,{title:"Frequencies in",units:e.units,unit:t.unit}),f("span",{class:"legend",children:[e.gap&&f("span",{class:"of-gap",children:"gap"}),f("span",{class:"of-carrier",children:"carrier"})]})]}),f(vI,{mirror:e,choice:t}),f(_I,{mirror:e,choice:t})]}),f("section",{"aria-label":"Waves of the lattice",children:[f(dx,{mirror:e,choice:t,name:"decay"}),f(dx,{mirror:e,choice:t,name:"phase"})]})]}),f(pr,{listing:t.listing,keys:i,children:[f(yI,{mirror:e,choice:t}),f(xI,{mirror:e,choice:t})]})]})}function mI(n,e){let t=(o,a)=>Math.min(Math.max(o,0),a-1),i=o=>e.line.value=t(e.line.value+o,n.frequency.length),s=o=>e.rows.value=t(e.rows.value+o,n.rows.length),r=o=>o.shiftKey?fI:1;return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:o=>i(-r(o)),ArrowRight:o=>i(r(o))}},{keys:"↑ ↓",effect:"one more or one less row",actions:{ArrowUp:()=>s(1),ArrowDown:()=>s(-1)}},{keys:"i",effect:"next incident wave",actions:{i:()=>{let o=(n.incident.indexOf(e.incident.value)+1)%n.incident.length;e.incident.value=n.incident[o]??""}}},{keys:"c",effect:"carrier",actions:{c:()=>e.line.value=n.nearest(n.carrier)}},...dr(e.listing)]}function gx({mirror:n,choice:e}){let{factor:t}=e.unit.value,i=(n.frequency[e.line.value]??0)/t;return{below:s=>{n.gap&&fx(s,[n.gap[0]/t,n.gap[1]/t],"gap")},above:s=>{_m(s,n.carrier/t,"carrier",[7,5]),_m(s,i,"accent")},pick:s=>e.line.value=n.nearest(s*t)}}function _x({mirror:n,choice:e}){let{factor:t}=e.unit.value;return Zt(()=>Array.from(n.frequency,i=>i/t),[n,t])}function gI({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.rows.value],s=Zt(()=>n.losses(t).map((r,o)=>({values:lf(r),colour:o===i?"accent":"quiet",width:o===i?2.6:1})),[n,t,i]);return f(of,{x:_x({mirror:n,choice:e}),curves:s,titles:[qi("frequency",e.unit.value),`${n.data.title("loss")} / dB`],height:300,...gx({mirror:n,choice:e})})}function _I({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.line.value],[s,r]=["loss","loss_error"].map(c=>n.losses(t,c).map(u=>u[i]??NaN)),o=Zt(()=>Array.from(n.rows),[n]),a=Zt(()=>[{values:lf(s??[]),colour:"quiet",dash:[2,4]}],[n,t,i]),l=Math.max(1,...o.map((c,u)=>(s?.[u]??NaN)+(r?.[u]??NaN)).filter(Number.isFinite));return f(of,{x:o,curves:a,titles:["rows",`${n.data.title("loss")} / dB`],height:200,whole:!0,limits:{x:[.5,o.length+.5],y:[Math.min(0,...(s??[]).filter(Number.isFinite)),px*l]},above:c=>o.forEach((u,h)=>{let[d=NaN,p=NaN]=[s?.[h],r?.[h]];if(!Number.isFinite(d))return;let _=x=>[c.valToPos(u,"x",!0),c.valToPos(x,"y",!0)];vm(c.ctx,_(d-p),_(d+p),"ink"),hx(c.ctx,_(d),h===e.rows.value?"accent":"quiet")}),pick:c=>e.rows.value=Math.min(Math.max(Math.round(c)-1,0),o.length-1)},`${t} ${i}`)}function dx({mirror:n,choice:e,name:t}){let i=Zt(()=>n.ofWaves(t).map(r=>({values:lf(r),colour:"curve-0",points:!0})),[n,t]),s=Math.min(dI,px*Math.max(...i.flatMap(({values:r})=>r.map(o=>o??0))));return f(of,{x:_x({mirror:n,choice:e}),curves:i,titles:[qi("frequency",e.unit.value),`${n.data.title(t)} / ${t==="decay"?"(dB/row)":"π"}`],height:t==="decay"?300:200,limits:{y:t==="decay"?[0,s]:[0,1]},...gx({mirror:n,choice:e})})}function ym({mirror:n,choice:e}){let t=e.unit.value;return Bo(Pc((n.frequency[e.line.value]??0)/t.factor),t)}function vx(n,e){return Number.isFinite(n)?`${Ii(n??NaN,e??NaN)} dB`:"does not propagate"}function vI({mirror:n,choice:e}){let[t,i,s]=[e.incident.value,e.line.value,e.rows.value],[r,o]=["loss","loss_error"].map(l=>n.losses(t,l)[s]?.[i]),a=n.rows[s]??0;return f("div",{class:"facts",children:[f("p",{id:"point","aria-live":"polite",children:[t," at ",f("b",{children:ym({mirror:n,choice:e})}),", ",a," row",a===1?"":"s",": ",f("b",{children:vx(r,o)})]}),f("p",{class:"again",children:["The same as a picture, in Python: ",f("code",{children:['study.layers().plot("layers", incident="',t,'")']})]})]})}function yI({mirror:n,choice:e}){let t=e.line.value;return f("div",{class:"wide",children:f("table",{children:[f("caption",{children:["Insertion loss at ",ym({mirror:n,choice:e})]}),f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"rows"}),n.incident.map(i=>f("th",{scope:"col",children:["incident ",i]}))]})}),f("tbody",{children:Array.from(n.rows,(i,s)=>f("tr",{"aria-current":s===e.rows.value?"true":void 0,children:[f("td",{children:i}),n.incident.map(r=>f("td",{children:vx(n.losses(r)[s]?.[t],n.losses(r,"loss_error")[s]?.[t])}))]}))})]})})}function xI({mirror:n,choice:e}){let t=e.line.value,i=["decay","decay_error","phase","phase_error"].map(s=>n.ofWaves(s));return f("div",{class:"wide",children:f("table",{children:[f("caption",{children:["Waves of the lattice at ",ym({mirror:n,choice:e})]}),f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"decay / (dB/row)"}),f("th",{scope:"col",children:"phase per row / π"})]})}),f("tbody",{children:Array.from({length:n.waves},(s,r)=>{let[o=NaN,a=NaN,l=NaN,c=NaN]=i.map(u=>u[r]?.[t]);return f("tr",{children:[f("td",{children:Ii(o,a)}),f("td",{children:Number.isFinite(l)?Ii(l,c):"decays"})]})})})]})})}var cf=class{constructor(e){this.data=e;let{extra:t}=e.header;this.frequency=e.values("frequency"),[,this.rows=0,this.columns=0]=e.shape("shape_real"),this.real=e.values("shape_real"),this.imag=e.values("shape_imag"),this.step=e.values("shape_step"),this.present=e.values("present"),this.gap=t.gap,this.carrier=Number(t.carrier),this.drive=String(t.drive),this.parts=t,this.colours=t.colours,this.units=Oo(e);let[i,s]=[e.values("mode_frequency"),e.values("mode_quality")];this.modes=Array.from(i,(r,o)=>({frequency:r,name:e.texts("mode_name")[o]??"",quality:s[o]??NaN}))}data;frequency;columns;rows;gap;carrier;drive;parts;modes;colours;units;real;imag;step;present;nearest(e){let t=0;return this.frequency.forEach((i,s)=>{Math.abs(i-e)<Math.abs((this.frequency[t]??0)-e)&&(t=s)}),t}get first(){return this.nearest(Number(this.data.header.extra.first))}largest(e){return(this.step[e]??0)*(this.colours.length-1)*.5}get extent(){let[e,t]=[this.data.values("x"),this.data.values("y")],[i,s]=[yx(e),yx(t)];return{left:(e[0]??0)-i,right:(e[e.length-1]??0)+i,bottom:(t[0]??0)-s,top:(t[t.length-1]??0)+s}}paint(e,t,i){let[s,r]=[Math.cos(2*Math.PI*i),Math.sin(2*Math.PI*i)],o=(this.colours.length-1)/2,a=t*this.rows*this.columns;for(let l=0;l<this.rows;l++)for(let c=0;c<this.columns;c++){let u=l*this.columns+c,h=(this.real[a+u]??0)*s-(this.imag[a+u]??0)*r,d=Math.min(Math.max(Math.round(o+h),0),2*o),[p=0,_=0,x=0]=this.colours[d]??[],g=4*((this.rows-1-l)*this.columns+c);e.data[g]=p,e.data[g+1]=_,e.data[g+2]=x,e.data[g+3]=this.present[u]===0?0:255}}outermost(e){let t=e*this.rows*this.columns,[i,s]=[0,-1];for(let r=t;r<t+this.rows*this.columns;r++){let o=Math.hypot(this.real[r]??0,this.imag[r]??0);o>s&&([i,s]=[r,o])}return-Math.atan2(this.imag[i]??0,this.real[i]??0)/(2*Math.PI)}has(e){return this.data.has(e)}curves(e){if(!this.data.has(e))return[];let t=this.data.values(e),i=this.data.texts(e==="level"?"region":"pair"),s=this.frequency.length;return i.map((r,o)=>({name:r,values:Array.from(t.subarray(o*s,(o+1)*s),a=>Number.isFinite(a)&&(e==="contrast"||a>0)?a:null)}))}};function yx(n){return n.length>1?.5*((n[1]??0)-(n[0]??0)):5e-4}var ec=[[],[8,4],[2,3],[10,3,2,3]],xm=4,bI=300;function bx({plate:n,choice:e}){let t=vt(null),i=e.shown.value;return Rt(()=>{if(t.current!==null)return SI(t.current,n,e)},[n,e,i]),f("div",{class:"curves",ref:t})}function SI(n,e,t){let i=t.shown.peek(),s=e.curves(i),r=e.data.unit(i),o={stroke:()=>Ge("ink"),ticks:{stroke:()=>Ge("rule")}},a={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},l=()=>t.unit.peek().factor,c=()=>[Array.from(e.frequency,d=>d/l()),...s.map(({values:d})=>d)],u=()=>({width:vs(n),height:bI}),h=new jt({...u(),legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},scales:{x:{time:!1},y:{distr:i==="level"?3:1}},axes:[{...o,...a,label:"frequency",labelSize:22,size:34,grid:{show:!1}},{...o,...a,label:`${e.data.title(i)} / ${r}`,labelSize:24,size:58,grid:{show:!1},values:(d,p)=>p.map(_=>_===null?"":MI(_,i==="level"))}],series:[{},...s.map((d,p)=>({stroke:()=>Ge(`curve-${p%xm}`),dash:ec[p%ec.length]??[],width:1.4,points:{show:!1}}))],hooks:{drawClear:[d=>Bs(d,()=>wI(d,e,l()))],draw:[d=>TI(d,e,t)]}},c(),n);return _r(h,d=>t.line.value=e.nearest(l()*h.posToVal(d,"x"))),ys(h,n,u,[lt(()=>{let d=h.axes[0];d!==void 0&&(d.label=qi("frequency",t.unit.value)),h.setData(c(),!0)}),lt(()=>{t.line.value,h.redraw(!1,!1)})])}function MI(n,e){if(!e)return`${Number(n.toPrecision(4))}`.replace("-","−");let t=Math.log10(n);return Math.abs(t-Math.round(t))<1e-9?`1e${Math.round(t)}`.replace("-","−"):""}function wI(n,e,t){let{ctx:i,bbox:s}=n;if(e.gap===null)return;let[r,o]=e.gap.map(a=>n.valToPos(a/t,"x",!0));i.fillStyle=Ge("gap"),i.fillRect(r,s.top,o-r,s.height)}function TI(n,e,t){let{factor:i}=t.unit.peek();xx(n,e.carrier/i,Ge("carrier"),[7,5]),xx(n,(e.frequency[t.line.peek()]??0)/i,Ge("accent"),[])}function xx({ctx:n,bbox:e,valToPos:t},i,s,r){let o=t(i,"x",!0);o<e.left||o>e.left+e.width||(n.save(),n.strokeStyle=s,n.lineWidth=1.5*devicePixelRatio,n.setLineDash(r.map(a=>a*devicePixelRatio)),n.beginPath(),n.moveTo(o,e.top),n.lineTo(o,e.top+e.height),n.stroke(),n.restore())}var EI=10;function Sx(n){return{line:Pe(n.first),shown:Pe(n.has("level")?"level":"contrast"),plan:Pe(!1),unit:Pe(ko(n.units,Math.max(...n.frequency))),playing:Pe(!$c()),pace:Pe(.7),listing:Pe("none")}}function Mx(n,e){let t=n.frequency.length-1,i=a=>e.line.value=Math.min(Math.max(e.line.value+a,0),t),s=a=>a.shiftKey?EI:1,r=n.modes.map(({frequency:a})=>n.nearest(a)).sort((a,l)=>a-l),o=a=>{a!==void 0&&(e.line.value=a)};return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:a=>i(-s(a)),ArrowRight:a=>i(s(a))}},{keys:"p n",effect:"previous or next mode near the carrier",actions:{p:()=>o(r.filter(a=>a<e.line.value).pop()),n:()=>o(r.find(a=>a>e.line.value))}},{keys:"c",effect:"carrier",actions:{c:()=>o(n.nearest(n.carrier))}},{keys:"g",effect:"resonance in the gap",actions:{g:()=>o(n.first)}},{keys:"l",effect:"pillars and supports",actions:{l:()=>e.plan.value=!e.plan.value}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},...dr(e.listing)]}var AI="The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.",wx=["level","contrast"];function Tx(n){return f(CI,{data:n})}function CI({data:n}){let e=Zt(()=>new cf(n),[n]),t=Zt(()=>Sx(e),[e]),i=Zt(()=>Mx(e,t),[e,t]),s=wx.filter(r=>e.has(r));return f(fr,{name:"plate",data:n,keys:i,foot:AI,children:[f("div",{class:"pair",children:[f("section",{"aria-label":"Spectra",children:[s.length>0&&e.frequency.length>1&&f(Tt,{children:[f("div",{class:"walk",tabIndex:0,role:"application","aria-label":"Spectra. Arrow keys change the frequency.","aria-describedby":"point",children:f(bx,{plate:e,choice:t})}),f(RI,{plate:e,choice:t}),f("p",{class:"axes",children:[f("label",{children:["Curves"," ",f("select",{value:t.shown.value,onChange:r=>t.shown.value=r.currentTarget.value,children:s.map(r=>f("option",{value:r,children:e.data.title(r)}))})]}),f(Fo,{title:"Frequencies in",units:e.units,unit:t.unit})]})]}),f(PI,{plate:e,choice:t})]}),f("section",{"aria-label":"Map",children:[f(ax,{plate:e,choice:t}),f("div",{class:"controls",children:[f(Cc,{playing:t.playing}),f(II,{plate:e,choice:t}),f(Rc,{pace:t.pace}),f("label",{class:"check",children:[f("input",{type:"checkbox",checked:t.plan.value,onChange:r=>t.plan.value=r.currentTarget.checked}),"pillars and supports"]})]})]})]}),f(pr,{listing:t.listing,keys:i,children:[f(LI,{plate:e,choice:t}),f(DI,{plate:e,choice:t})]})]})}function RI({plate:n,choice:e}){return f("p",{class:"legend",children:[n.curves(e.shown.value).map(({name:t},i)=>f("span",{class:"of-curve",children:[f("svg",{width:"34",height:"8","aria-hidden":"true",children:f("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${i%xm})`,"stroke-dasharray":(ec[i%ec.length]??[]).join(" ")})})," ",t]})),n.gap!==null&&f("span",{class:"of-gap",children:"gap"}),f("span",{class:"of-carrier",children:"carrier"})]})}function Pa(n,e){return Bo(Pc(n/e.factor),e)}function PI({plate:n,choice:e}){let t=e.line.value,i=n.frequency[t]??0,s=n.curves("contrast");return f("div",{class:"facts",children:[f("p",{id:"point","aria-live":"polite",children:[f("b",{children:Pa(i,e.unit.value)}),": up to ",fo(n.largest(t)),n.drive,s.map(({name:r,values:o})=>`; ${r} ${o[t]?.toFixed(1)??"-"} dB`).join("")]}),f("p",{class:"again",children:["The same map as a picture, in Python: ",f("code",{children:['study.plate().plot("maps", frequency=',Number(i.toFixed(3)),")"]})]})]})}function II({plate:n,choice:e}){let t=n.frequency.length-1,i=e.line.value;return f("label",{class:"long",children:["frequency: ",Pa(n.frequency[i]??0,e.unit.value),f("input",{type:"range",min:"0",max:t,step:"1",value:i,disabled:t===0,"aria-valuetext":Pa(n.frequency[i]??0,e.unit.value),onInput:s=>e.line.value=Number(s.currentTarget.value)})]})}function LI({plate:n,choice:e}){let t=e.line.value,i=wx.flatMap(s=>n.curves(s).map(({name:r,values:o})=>[n.data.title(s),r,`${o[t]?.toPrecision(3)??"-"} ${n.data.unit(s)}`]));return f("div",{class:"wide",children:f("table",{children:[f("caption",{children:["Regions at ",Pa(n.frequency[t]??0,e.unit.value)]}),f("tbody",{children:i.map(s=>f("tr",{children:s.map(r=>f("td",{children:r}))}))})]})})}function DI({plate:n,choice:e}){return n.modes.length===0?null:f("div",{class:"wide",children:f("table",{children:[f("caption",{children:"Modes near the carrier"}),f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"frequency"}),f("th",{scope:"col",children:"nodal lines"}),f("th",{scope:"col",children:"Q"}),f("th",{scope:"col",children:"show"})]})}),f("tbody",{children:n.modes.map(({frequency:t,name:i,quality:s})=>f("tr",{children:[f("td",{children:Pa(t,e.unit.value)}),f("td",{children:i}),f("td",{children:s.toFixed(0)}),f("td",{children:f("button",{type:"button",onClick:()=>e.line.value=n.nearest(t),children:Pa(n.frequency[n.nearest(t)]??0,e.unit.value)})})]}))})]})})}var Ex='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var Ax=`& {
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
`;var FI={bands:Jy,layers:mx,plate:Tx,finger:ux};function Cx(n,e){let t=FI[n.header.kind];if(t===void 0)throw new Error(`this version has no view "${n.header.kind}"`);return bm(),e.classList.add("haptonic","view"),Za(t(n),e),()=>Za(null,e)}function bm(){if(document.getElementById("haptonic-style")!==null)return;let n=document.createElement("style");n.id="haptonic-style",n.textContent=`${Ex}:where(.haptonic) { ${Ax} }`,document.head.append(n)}var uf=/^\s*\[\[?\s*([^\]]+?)\s*\]\]?/,OI=["quantity","number","integer","quantities","entries"];function Rx(n,e,t,i){let s=n.lastIndexOf(`
`,e-1)+1,r=n.slice(s,e),o=n.slice(0,s).split(`
`),a=new Map(t.map(d=>[d.path,d])),l=r.indexOf("="),c=/^\s*\[+\s*([\w.-]*)$/.exec(r);if(c!==null)return VI(c[1]??"",e-r.trimStart().length,t);let u=kI(o,a);if(l<0){let d=BI(n.split(`
`),o.length-1);return GI(/[\w-]*$/.exec(r)?.[0]??"",e,{keys:t,table:u,given:d})}let h=a.get(Ix(u,Px(r.slice(0,l).trim(),a,u)))??a.get(u);return h===void 0?{from:e,list:[]}:HI(r.slice(l+1),e,h,h.path===i?[]:zI(n,i))}function kI(n,e){return Px(n.flatMap(t=>uf.exec(t)?.[1]??[]).at(-1)??"",e,"")}function Px(n,e,t){return n.split(".").reduce((i,s)=>{let r=i?`${i}.${s.trim()}`:s.trim();return e.get(Ix(t,r))?.kind==="tables"?`${r}[]`:r},"")}var Ix=(n,e)=>n&&e?`${n}.${e}`:n||e;function BI(n,e){let t=n.map(o=>uf.test(o)),i=t.lastIndexOf(!0,e)+1,s=t.indexOf(!0,e+1),r=n.filter((o,a)=>a>=i&&(s<0||a<s)&&a!==e);return new Set(r.map(o=>/^\s*([\w-]+)\s*=/.exec(o)?.[1]??""))}function zI(n,e){let t=n.split(`
`),i=t.findIndex(r=>uf.exec(r)?.[1]===e)+1;if(i===0)return[];let s=t.slice(i).findIndex(r=>uf.test(r));return t.slice(i,s<0?t.length:i+s).flatMap(r=>{let[,o,a]=/^\s*([A-Za-z_]\w*)\s*=\s*(.*)/.exec(r)??[];return o===void 0?[]:[[o,a??""]]})}function Sm(n,e){let t=e.toLowerCase();return n.filter(({label:i})=>i.replace(/^[["]+/,"").toLowerCase().startsWith(t)).slice(0,50)}function VI(n,e,t){let i=t.filter(({kind:s})=>["table","tables","entries"].includes(s)).map(({path:s,kind:r,title:o})=>{let a=s.replaceAll("[]",""),l=r==="tables"?`[[${a}]]`:`[${a}]`;return{insert:l,label:l,detail:o}});return{from:e,list:Sm(i,n)}}function GI(n,e,{keys:t,table:i,given:s}){let r=t.filter(({path:o,kind:a})=>o.slice(0,o.lastIndexOf(".")+1)===(i&&`${i}.`)&&!["table","tables","entries"].includes(a)).map(o=>({name:o.path.slice(o.path.lastIndexOf(".")+1),key:o})).filter(({name:o})=>!s.has(o)).map(({name:o,key:a})=>({insert:`${o} = `,label:o,detail:a.title+(a.required?", required":a.default?`, default ${a.default}`:"")}));return{from:e-n.length,list:Sm(r,n)}}function HI(n,e,t,i){let s=n.trimStart().startsWith('"'),r=/[\w.-]*$/.exec(n)?.[0]??"",o=d=>s?d:`"${d}"`,a=[...t.names,...t.numbers].map(d=>({insert:o(d),label:d,detail:t.title})),l=t.kind==="boolean"?["true","false"].map(d=>({insert:d,label:d,detail:t.title})):[],u=(OI.includes(t.kind)?i:[]).map(([d,p])=>({insert:o(d),label:d,detail:`parameter, ${p}`})),h=n.trim()===""&&t.example&&!t.closed?[{insert:t.kind==="quantity"?`"${t.example}"`:t.example,label:t.example,detail:`${t.title}, an example`}]:[];return{from:e-r.length,list:Sm([...l,...a,...u,...h],r)}}var Ur=class extends Error{constructor(t,i){super(t);this.problem=i}problem};async function Dx(n){let e;try{e=await n}catch{throw new Ur("The server does not answer; is `haptonic studio` still running?")}if(e.ok)return e;if(e.status===422){let{error:t}=await e.json();throw new Ur(`${t.argument}: ${t.cause}`,t)}throw e.status===403?new Ur("The server was started again; open its new link."):new Ur(e.headers.get("content-type")?.startsWith("text/plain")?await e.text():`Error ${e.status} of the server.`)}var hf=async n=>await(await Dx(n)).json();async function Lx(n){let e=await Dx(n);return{name:/filename="([^"]*)"/.exec(e.headers.get("content-disposition")??"")?.[1]??"file",content:await e.blob()}}function Nx(n,e){let t={"content-type":"application/json"};return fetch(`api/${n}`,{method:"POST",headers:t,body:JSON.stringify(e)})}var is=(n,e)=>hf(Nx(n,e)),qt={start:()=>hf(fetch("api/start")),check:n=>is("check",{text:n}),change:(n,e)=>is("change",{text:n,changes:e}),forecast:n=>is("forecast",{text:n}),open:n=>is("open",{name:n}),template:n=>is("template",{name:n}),save:(n,e,t)=>is("save",{name:n,text:e,known:t}),run:(n,e,t,i)=>is("run",{analysis:n,options:e,text:t,file:i}),cancel:n=>is("cancel",{number:n}),compare:(n,e)=>is("differences",{first:n,second:e}),export:(n,e)=>Lx(Nx("product",{number:n,...e})),page:n=>Lx(fetch(`api/jobs/${n}/page`)),remove:n=>is("remove",{number:n}),design:(n,e)=>is("opened",{number:n,point:e}),points:(n,e)=>hf(fetch(`api/jobs/${n}/points/${e}`)),job:n=>hf(fetch(`api/jobs/${n}`)),view:async n=>(await fetch(`api/jobs/${n}/view`)).arrayBuffer(),picture:(n,e)=>`api/jobs/${n}/pictures/${encodeURIComponent(e)}`},WI=2e3;function Mm(n,e){let t=new WebSocket(`ws://${location.host}/api/live`);t.onopen=()=>e(!1),t.onmessage=i=>n(JSON.parse(String(i.data)).jobs),t.onclose=()=>{e(!0),setTimeout(()=>Mm(n,e),WI)}}var qI=250,XI=800,$I=300,St=Pe(""),Bi=Pe({}),Cs=Pe(!1),ff=Pe(null),Xn=Pe([]),Qs=Pe([]),ki=Pe(null),Da=Pe([]),Rs=Pe(null),La=Pe(null),Ia=Pe([]),df=Pe([]),po=Wt(()=>St.value!==(La.value??"")),Fx=Wt(()=>Ia.value.length>0),Ox=Wt(()=>df.value.length>0),wm=0,pf="",Tm=0,Em=-1/0,Ux=Promise.resolve();function tc(n){wm+=1,pf=n.text,Cs.value=n.values===null&&St.peek().trim()!=="",Cs.value||(Bi.value=n.values??{}),ff.value=n.plate,Xn.value=n.problems,Qs.value=n.remarks}async function Un(n){Rs.value=null;try{await n()}catch(e){if(!(e instanceof Ur))throw e;Rs.value=e.problem??e.message}}var kx=()=>({text:St.peek(),values:pf===St.peek()&&!Cs.peek()?Bi.peek():null});function Na(n,e=!1){if(n===St.peek())return;let t=performance.now();!(Ia.peek().length===0&&St.peek()==="")&&!(e&&t-Em<XI)&&(Ia.value=[...Ia.peek(),kx()].slice(-$I)),Em=e?t:-1/0,df.value=[],St.value=n}function Am(n=qI){clearTimeout(Tm),Tm=window.setTimeout(()=>{Un(Bx)},n)}async function Bx(){let n=wm+=1,e=St.peek(),t=await qt.check(e);n===wm&&tc({...t,text:e})}function mf(n){Na(n,!0),Am()}function Cm(n){Na(n),Am(0)}var ss=(n,e)=>{Ua(()=>[{steps:n,value:e}])};function Ua(n){return Ux=Ux.then(()=>Un(async()=>{for(;;){pf!==St.peek()&&await Bx();let[e,t]=[St.peek(),n()];if(t.length===0)return;let i=await qt.change(e,t);if(St.peek()===e){Na(i.text),clearTimeout(Tm),tc(i);return}}}))}function zx(n,e){let t=n.peek().at(-1);t!==void 0&&(n.value=n.peek().slice(0,-1),e.value=[...e.peek(),kx()],Em=-1/0,St.value=t.text,t.values!==null&&([Bi.value,pf]=[t.values,t.text]),Am(0))}var Fa=()=>zx(Ia,df),Oa=()=>zx(df,Ia),gf=n=>Un(async()=>{let e=await qt.open(n);Na(e.text),ki.value=e.name,La.value=e.text,tc(e)}),Vx=n=>Un(async()=>{let e=await qt.template(n);Na(e.text),ki.value=null,La.value=null,tc(e)});function Gx(n){Cm(n),ki.value=La.value=null}var Hx=(n,e)=>Un(async()=>{let t=await qt.design(n,e);Na(t.text),tc(t)}),Wx=n=>Un(async()=>{let e=St.peek(),t=await qt.save(n,e,n===ki.peek()?La.peek():null);ki.value=t.name,La.value=e,Da.value=t.files});function Fn(n){return n.reduce((e,t)=>typeof t=="number"?`${e}[${t+1}]`:e?`${e}.${t}`:t,"")}var _f="completions",YI=14,Ps=Pe(null),Fr=Pe(0),qx=Pe([]),Xx=Pe(""),vf=Wt(()=>Ps.value===null?{from:0,list:[]}:Rx(St.value,Ps.value,qx.value,Xx.value));function $x(n,e){[qx.value,Xx.value]=[n,e]}var yf=()=>Ps.value=null;function Rm(n){Ps.peek()!==null&&(Ps.value=n.selectionStart,Fr.value=0)}function Yx(n,e){let{list:t}=vf.peek();if(n.key===" "&&n.ctrlKey)[Ps.value,Fr.value]=[e.selectionStart,0];else{if(Ps.peek()===null||t.length===0)return!1;if(n.key==="ArrowDown"||n.key==="ArrowUp")Fr.value=(Fr.peek()+(n.key==="ArrowDown"?1:t.length-1))%t.length;else if(n.key==="Enter"||n.key==="Tab")Kx(e,Fr.peek());else if(n.key==="Escape")yf();else return!1}return n.preventDefault(),!0}function Kx(n,e){let{from:t,list:i}=vf.peek(),s=i[e];s===void 0||Ps.peek()===null||(n.setRangeText(s.insert,t,Ps.peek(),"end"),yf(),mf(n.value),n.focus())}function Zx(){return{"aria-autocomplete":"list",...vf.value.list.length>0?{"aria-controls":_f,"aria-activedescendant":`${_f}-${Fr.value}`}:{}}}function Jx({area:n}){let{from:e,list:t}=vf.value,i=n.current;if(Ps.value===null||i===null)return null;let s=St.value.slice(0,e).split(`
`),r=i.scrollHeight/St.value.split(`
`).length,o=i.offsetTop+s.length*r-i.scrollTop+6,a=parseFloat(getComputedStyle(document.documentElement).fontSize),c=i.getBoundingClientRect().top-i.offsetTop+o+YI*a<innerHeight?{top:`${o}px`}:{top:`${o-r-6}px`,transform:"translateY(-100%)"},u=`min(calc(${i.offsetLeft}px + ${(s.at(-1)??"").length}ch), max(0px, 100% - 22rem))`;return f("ul",{id:_f,role:"listbox",tabIndex:0,"aria-label":"Completions",class:"completions",style:{...c,left:u},children:[t.length===0&&f("li",{role:"option","aria-selected":"false",class:"quiet",children:"Nothing fits here."}),t.map(({label:h,detail:d},p)=>f("li",{id:`${_f}-${p}`,role:"option","aria-selected":p===Fr.value,ref:_=>{p===Fr.value&&_?.scrollIntoView({block:"nearest"})},onMouseDown:_=>{_.preventDefault(),Kx(i,p)},children:[f("code",{children:h})," ",f("span",{class:"quiet",children:d})]}))]})}var jx=[{keys:"Ctrl+Space",effect:"list of keys and values that fit at the cursor",actions:{}},{keys:"Ctrl+Z",effect:"undo",actions:{}},{keys:"Ctrl+Shift+Z",effect:"redo",actions:{}}];function Qx(){let n=vt(null),e=vt(null),t=new Set(Xn.value.map(({line:o})=>o)),i=new Set(Qs.value.map(({line:o})=>o)),s=St.value.split(`
`).length,r=o=>{n.current!==null&&o!==null&&KI(n.current,o)};return f("div",{class:"editor",children:[f("div",{class:"page",children:[f("ol",{ref:e,"aria-hidden":"true",children:Array.from({length:s},(o,a)=>f("li",{class:t.has(a+1)?"wrong":i.has(a+1)?"doubtful":"",children:a+1}))}),f("textarea",{ref:n,"aria-label":"Text of the study file, TOML","aria-invalid":Xn.value.length>0,value:St.value,wrap:"off",spellcheck:!1,autocapitalize:"off",autocomplete:"off",...Zx(),onInput:o=>{mf(o.currentTarget.value),Rm(o.currentTarget)},onSelect:o=>Rm(o.currentTarget),onBlur:yf,onScroll:o=>{e.current!==null&&(e.current.scrollTop=o.currentTarget.scrollTop)},onKeyDown:o=>{if(Yx(o,o.currentTarget)||!(o.ctrlKey||o.metaKey)||o.altKey)return;let a=o.key.toLowerCase(),l=a==="y"||a==="z"&&o.shiftKey?Oa:a==="z"?Fa:null;l!==null&&(o.preventDefault(),l())}})]}),f(Jx,{area:n}),f("section",{"aria-label":"Problems","aria-live":"polite",class:"problems",children:[Xn.value.length>0&&f("ul",{children:Xn.value.map(o=>f("li",{children:f(nc,{problem:o,go:r})}))}),Qs.value.map(o=>f("p",{class:"doubt",children:[f(eb,{path:o.path,line:o.line,go:r}),": ",o.text]})),Xn.value.length===0&&Qs.value.length===0&&St.value!==""&&f("p",{class:"quiet",children:"The study has no problem."}),St.value===""&&f("p",{children:"Choose a template or open a study above, or write here."})]})]})}function eb({path:n,line:e,go:t}){let i=e===null?n:`line ${e}${n?`, ${n}`:""}`;return e===null?f("b",{children:i}):f("button",{type:"button",class:"minor",onClick:()=>t(e),children:i})}function nc({problem:n,go:e=()=>{}}){return f("div",{class:"parts",children:[f("p",{children:[f(eb,{path:n.path||n.argument,line:n.line,go:e}),": got ",n.given]}),f("dl",{children:[f("dt",{children:"allowed"}),f("dd",{children:n.allowed}),f("dt",{children:"likely cause"}),f("dd",{children:n.cause}),f("dt",{children:"next step"}),f("dd",{children:n.next_step})]})]})}function KI(n,e){let t=n.value.split(`
`),i=t.slice(0,e-1).join(`
`).length+(e>1?1:0);n.focus(),n.setSelectionRange(i,i+(t[e-1]?.length??0));let s=n.scrollHeight/Math.max(t.length,1);n.scrollTop=Math.max(0,(e-4)*s)}var rs=Pe([]),Pm=Pe(!1),gn=Pe(null),mo=Pe(null),tb=Pe(0),nb=()=>rs.value.find(n=>n.state==="running"),ib=(n,e)=>n.seconds+Math.max(0,e-tb.value)/1e3;function sb(){Mm(n=>{let e=n.at(-1);e&&gn.peek()===null&&(gn.value=e.number),tb.value=performance.now(),rs.value=n},n=>Pm.value=n),lt(()=>{let n=rs.value.find(t=>t.number===gn.value);if(n===void 0||n.state==="running")return;let e=mo.peek();e?.number===n.number&&e.state===n.state||Un(async()=>{let t=await qt.job(n.number);gn.peek()===t.number&&(mo.value=t)})})}var rb=(n,e)=>Un(async()=>{let{number:t}=await qt.run(n,e,St.peek(),ki.peek());gn.value=t}),ob=n=>Un(async()=>{gn.peek()===n&&(gn.value=mo.value=null),await qt.remove(n)}),ab=n=>Un(async()=>{await qt.cancel(n)});function xf({table:n}){let e=n.count-n.rows.length;return f("div",{class:"wide",tabIndex:0,role:"group","aria-label":n.title,children:[f("table",{children:[f("caption",{children:n.title}),f("thead",{children:f("tr",{children:n.head.map(t=>f("th",{scope:"col",children:t}))})}),f("tbody",{children:[n.rows.length===0&&f("tr",{children:f("td",{colSpan:n.head.length,children:"none"})}),n.rows.map((t,i)=>f("tr",{class:n.strong.includes(i)?"strong":"",children:t.map((s,r)=>f("td",{class:n.numeric[r]?"number":"",children:s}))}))]})]}),e>0&&f("p",{class:"quiet",children:["and ",e," more rows, in the files of the command"]})]})}var lb="folder ",ZI="page ";function cb({job:n,answer:e,exports:t}){let[i,s]=Ot(lb),[r,o]=Ot(""),[a,l]=Ot(Object.keys(t.looks)[0]??""),[c,u]=Ot(!1),[h,d]=[i.slice(0,i.indexOf(" ")),i.slice(i.indexOf(" ")+1)],p=h==="picture"?t.pictures:h==="table"?t.tables:[],_=p.includes(r)?r:p[0]??"",x=()=>Un(async()=>{u(!0);try{let m={kind:h,name:d,form:_,...h==="picture"?{style:a}:{}},b=await(h==="page"?qt.page(n.number):qt.export(n.number,m));Qc(b.content,b.name)}finally{u(!1)}}),g=(m,b,A)=>A.length>0&&f("optgroup",{label:m,children:A.map(S=>f("option",{value:`${b} ${S}`,children:S}))});return f("div",{class:"row",role:"group","aria-label":"Save the result",children:[f("label",{children:["Save",f("select",{value:i,onChange:m=>s(m.currentTarget.value),children:[f("option",{value:lb,children:"everything, as one zip"}),n.view&&f("option",{value:ZI,children:"the interactive page, as one HTML file"}),g("Pictures","picture",e.pictures.map(m=>m.name)),g("Tables","table",e.tables.map(m=>m.title)),g("Files","file",e.files)]})]}),p.length>0&&f("label",{children:["Format",f("select",{value:_,onChange:m=>o(m.currentTarget.value),children:p.map(m=>f("option",{children:m}))})]}),h==="picture"&&f("label",{children:["Style",f("select",{value:a,onChange:m=>l(m.currentTarget.value),children:Object.entries(t.looks).map(([m,b])=>f("option",{value:m,children:b}))})]}),f("button",{type:"button",disabled:c,onClick:()=>{x()},children:c?"The file is made":"Save file"})]})}function ub({exports:n}){let e=mo.value;return e===null?null:f("section",{id:"result",class:"result","aria-label":`Result of ${e.analysis}`,children:[e.text!==St.value&&f("p",{class:"notice",children:["This result belongs to another version of the study."," ",f("button",{type:"button",onClick:()=>Cm(e.text),children:"Show that version"})]}),e.state==="cancelled"&&f("p",{children:["The computation of ",e.analysis," was cancelled."]}),e.error!==null&&f(Tt,{children:[f("h2",{children:["No result of ",e.analysis]}),f(nc,{problem:{...e.error,path:e.error.argument,line:null}})]}),e.answer!==null&&f(JI,{job:e,answer:e.answer,exports:n},e.number)]})}function JI({job:n,answer:e,exports:t}){return f(Tt,{children:[n.view?f(QI,{number:n.number}):f(jI,{answer:e}),e.remarks.map(i=>f("p",{class:"doubt",children:i})),f(cb,{job:n,answer:e,exports:t}),f("dl",{class:"repeat",children:[f("dt",{children:"The same as a command"}),f("dd",{children:f("code",{children:n.command})}),f("dt",{children:"in Python"}),f("dd",{children:f("code",{children:n.python})})]}),e.tables.length>0&&f("details",{class:"section",open:!n.view,children:[f("summary",{children:"Tables"}),e.tables.map(i=>f(xf,{table:i}))]}),f(eL,{job:n,answer:e})]})}function jI({answer:n}){return f("header",{children:[f("h2",{children:n.title}),f("p",{class:"origin",children:n.origin}),n.summary.map(e=>f("p",{children:e}))]})}function QI({number:n}){let e=vt(null),[t,i]=Ot("");return Rt(()=>{let s=()=>{},r=!1;return qt.view(n).then(o=>{!r&&e.current!==null&&(s=Cx(Ac.read(o),e.current))},()=>i("The view cannot be loaded: the server does not answer.")),()=>{r=!0,s()}},[n]),f(Tt,{children:[t&&f("p",{role:"alert",children:t}),f("div",{ref:e})]})}function eL({job:n,answer:e}){let t=rs.value.find(({number:s})=>s===n.number)??n;if(e.pictures.length===0)return null;let i=e.pictures.filter(({name:s})=>t.pictures.includes(s));return f("details",{class:"section",open:!n.view,children:[f("summary",{children:"Pictures"}),f("div",{class:"pictures",children:i.map(({name:s,caption:r})=>f("figure",{children:[f("img",{src:qt.picture(n.number,s),alt:r||s,loading:"lazy"}),f("figcaption",{children:r})]},s))}),i.length<e.pictures.length&&f("p",{class:"quiet",children:t.drawn?`${e.pictures.length-i.length} pictures were left out, because another computation began.`:"Pictures are drawn."})]})}var go=Pe(null),bf=Pe(null);function hb(){lt(()=>{let[n,e]=[go.value,gn.value],t=i=>rs.value.some(s=>s.number===i&&s.state==="done");if(t(n)||(go.value=null),n===e||!t(n)||!t(e)){bf.value=null;return}Un(async()=>{let i=await qt.compare(n,e);go.peek()===n&&gn.peek()===e&&(bf.value=i)})})}function fb(){if(bf.value===null)return null;let{runs:n,tables:e}=bf.value;return f("section",{class:"section","aria-labelledby":"comparison-title",children:[f("h2",{id:"comparison-title",children:n.map(({name:t})=>t).join(" and ")}),f("div",{class:"sides-by-side",children:n.map(({name:t,title:i,summary:s})=>f("div",{children:[f("h3",{children:[t," ",f("span",{class:"quiet",children:i})]}),s.map(r=>f("p",{children:r}))]}))}),e.map(t=>f(xf,{table:t})),f("p",{class:"quiet",children:"Bold differences exceed the sum of both errors. Equal numbers are left out."}),f("button",{type:"button",onClick:()=>go.value=null,children:"Close the comparison"})]})}var Im={running:"is computed",done:"",failed:"failed",cancelled:"cancelled"};function db(){let n=[...rs.value].reverse();return f(Tt,{children:[f("p",{class:"hidden",role:"status",children:n[0]===void 0?"":`${n[0].analysis} ${Im[n[0].state]||"is finished"}`}),n.length>0&&f("details",{class:"section",children:[f("summary",{children:["Runs ",f("span",{class:"quiet",children:[n.length," in this folder"]})]}),f("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Runs",children:f("table",{children:[f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"run"}),f("th",{scope:"col",children:"study"}),f("th",{scope:"col",children:"file"}),f("th",{scope:"col",children:"begun"}),f("th",{scope:"col",children:"took"}),f("th",{scope:"col",colSpan:2,children:f("span",{class:"hidden",children:"compare and remove"})})]})}),f("tbody",{children:n.map(e=>f(tL,{job:e},e.number))})]})})]})]})}function tL({job:n}){let e=`${n.number}. ${n.analysis}`;return f("tr",{children:[f("td",{children:f("button",{type:"button",class:"minor","aria-pressed":gn.value===n.number,onClick:()=>gn.value=n.number,children:[e," ",Im[n.state]&&`(${Im[n.state]})`]})}),f("td",{class:"study-title",children:n.title||"-"}),f("td",{children:n.file}),f("td",{class:"number",children:nL(n.started)}),f("td",{class:"number",children:n.state==="running"?"":`${Math.round(n.seconds)} s`}),f("td",{children:n.state==="done"&&n.number!==gn.value&&f("button",{type:"button",class:"minor","aria-pressed":go.value===n.number,onClick:()=>go.value=n.number,"aria-label":`Compare the shown run with ${e}`,children:"Compare"})}),f("td",{children:n.state!=="running"&&f("button",{type:"button",class:"minor",onClick:()=>{ob(n.number)},"aria-label":`Remove ${e}`,children:"Remove"})})]})}var nL=n=>new Date(1e3*n).toLocaleString([],{dateStyle:"short",timeStyle:"short"});function pb({analyses:n}){let[e,t]=Ot(n.find(({interactive:u})=>u)?.name??n[0]?.name??""),[i,s]=Ot({}),r=n.find(u=>u.name===e),o=nb();if(r===void 0)return null;let a=Xn.value.length>0||Cs.value||St.value.trim()==="",l=i[e]??{},c=(u,h)=>s({...i,[e]:{...l,[u]:h}});return f("section",{class:"compute","aria-labelledby":"compute-title",children:[f("h2",{id:"compute-title",children:"Compute"}),f("div",{class:"row",children:[f("label",{children:["Analysis",f("select",{value:e,onChange:u=>t(u.currentTarget.value),children:n.map(u=>f("option",{children:u.name}))})]}),f("button",{type:"button",class:"main",disabled:a,onClick:()=>{rb(e,l)},children:["Compute ",e]}),o!==void 0&&f("button",{type:"button",onClick:()=>{ab(o.number)},children:"Cancel"}),mo.value!==null&&f("a",{href:"#result",children:"Go to the result"}),a&&f("span",{class:"quiet",children:"The study has problems, or is empty."})]}),f("p",{class:"quiet",children:r.help}),r.options.length>0&&f("div",{class:"fields",children:r.options.map(u=>f(iL,{option:u,value:l[u.name],set:h=>c(u.name,h)},`${e}-${u.name}`))}),o!==void 0&&f(rL,{job:o}),f(db,{})]})}function iL({option:n,value:e,set:t}){let i=`option-${n.name}`,s=n.name.replaceAll("_"," "),r={id:i,"aria-describedby":`${i}-help`},o=e??n.default??"";return f("div",{class:"field given",children:[n.form==="bool"?f("label",{class:"check",children:[f("input",{...r,type:"checkbox",checked:o===!0,onChange:a=>t(a.currentTarget.checked)}),s]}):f(Tt,{children:[f("label",{for:i,children:[s,n.unit&&f("span",{class:"quiet",children:[" with unit, such as 1 ",n.unit]})]}),n.form==="choice"?f("select",{...r,value:String(o),onChange:a=>t(a.currentTarget.value),children:n.choices.map(a=>f("option",{children:a}))}):f("input",{...r,type:"text",inputMode:n.form==="int"||n.form==="float"?"decimal":"text",value:String(o),onChange:({currentTarget:{value:a}})=>t(n.form==="int"||n.form==="float"?sL(a):a)})]}),f("p",{id:`${i}-help`,class:"help",children:n.help})]})}var sL=n=>n.trim()===""||Number.isNaN(Number(n))?n:Number(n);function rL({job:n}){let[e,t]=Ot(performance.now());Rt(()=>{let a=setInterval(()=>t(performance.now()),1e3);return()=>clearInterval(a)},[]);let[i,s,r]=n.progress,o=s>0?{value:i,max:s}:{};return f("div",{class:"running",children:[f("progress",{...o,"aria-label":`Computing ${n.analysis}`}),f("p",{children:[`Computing ${n.analysis}${s>0?`: ${i} of ${s}`:""}${r&&` (${r})`}, `,Math.floor(ib(n,e))," s."," ",f("span",{class:"quiet",children:n.cost})]})]})}function gb(n){let e=[],t=new Map;for(let i of n){let s=i.path.lastIndexOf("."),r={key:i,name:i.path.slice(s+1),inside:[]};t.set(i.path,r),((s<0?void 0:t.get(i.path.slice(0,s).replace(/\[\]$/,"")))?.inside??e).push(r)}return e}var Sf=({key:n})=>["table","tables","entries"].includes(n.kind),mb=/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;function ic(n,e){let t=e.trim().replace(/^"([^"]*)"$/,"$1");if(t==="")return null;switch(n.kind){case"integer":return Number.isSafeInteger(Number(t))&&/^[+-]?\d+$/.test(t)?Number(t):t;case"number":case"entries":return mb.test(t)&&!n.unit?Number(t):t;case"quantities":return t.split(",").map(i=>n.unit||!mb.test(i.trim())?i.trim():Number(i));case"text":return e;default:return t}}function os(n){return n===void 0?"":Array.isArray(n)?n.map(os).join(", "):typeof n=="object"?"":String(n)}function _b(n){return[n.help,n.kind==="quantities"?"Commas between the values.":"",n.example?`For example ${n.example}.`:"",n.bounds?`${n.bounds[0]?.toUpperCase()}${n.bounds.slice(1)}.`:"",n.typical?`Usual: ${n.typical}.`:""].filter(Boolean).join(" ")}function vb(){let n=vt(null),e=()=>{n.current?.open||n.current?.showModal()};return Rt(()=>{let t=[{keys:"?",effect:"this list",actions:{"?":e}}],i=s=>hr(s,t);return document.addEventListener("keydown",i),()=>document.removeEventListener("keydown",i)},[]),f(Tt,{children:[f("button",{type:"button",onClick:e,"aria-keyshortcuts":"?",children:"Keys"}),f("dialog",{ref:n,"aria-label":"Keys of the page",children:[Uo.value.map(({title:t,keys:i})=>f(fd,{title:t,keys:i})),f("p",{class:"quiet",children:"Keys of a part work while it has the focus."}),f("button",{type:"button",onClick:()=>n.current?.close(),children:"Close"})]})]})}var Lm="#study=",Dm=1e5,yb=1e6;async function oL(n){let e=new Blob([n]).stream().pipeThrough(new CompressionStream("deflate-raw")),t=new Uint8Array(await new Response(e).arrayBuffer()),i="";for(let r of t)i+=String.fromCharCode(r);let s=btoa(i).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}${Lm}${s}`}async function aL(n){if(n.length>Dm)throw new Error(`it has more than ${Dm} letters`);let e=Uint8Array.from(atob(n.replaceAll("-","+").replaceAll("_","/")),o=>o.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader(),i=new TextDecoder("utf-8",{fatal:!0}),[s,r]=["",0];for(;;){let{done:o,value:a}=await t.read();if(o)return s+i.decode();if(r+=a.length,r>yb)throw await t.cancel(),new Error(`the study in it has more than ${yb} bytes`);s+=i.decode(a,{stream:!0})}}async function Nm(){if(!location.hash.startsWith(Lm))return;let n=location.hash.slice(Lm.length);history.replaceState(null,"",location.pathname);try{let e=await aL(n);if(e===St.peek()||po.peek()&&!confirm("The link has another study. Leave the text that is not saved? Undo brings it back."))return;Gx(e)}catch(e){Rs.value=lL(`${n.slice(0,40)}${n.length>40?"...":""}`,e)}}function lL(n,e){return{code:"malformed",argument:"link",given:n,allowed:'a link that "Copy link" has made',cause:e instanceof Error&&e.constructor===Error?e.message:"the link is damaged or incomplete",next_step:"copy the link again, or open the file of the study",path:"",line:null}}async function xb(){let n=await oL(St.peek());if(n.length>Dm)return"The study is too long for a link. Send its file.";try{return await navigator.clipboard.writeText(n),"The link is copied. It contains the whole study."}catch{return prompt("Copy this link. It contains the whole study.",n),""}}var Um=".toml";function bb({start:n}){let[e,t]=Ot(null),[i,s]=Ot(""),r=e??ki.value??"",o=()=>!po.peek()||confirm("The study has changes that are not saved. Leave them? Undo brings them back.");return f("header",{class:"bar",children:[f("div",{class:"row",children:[f("h1",{children:"haptonic studio"}),f("label",{children:["New, from a template",f("select",{value:"",onChange:a=>{let l=a.currentTarget.value;a.currentTarget.value="",t(null),l&&o()&&Vx(l)},children:[f("option",{value:"",children:"choose"}),Object.entries(n.templates).map(([a,l])=>f("option",{value:a,title:l,children:a}))]})]}),f("label",{children:["Open, in ",n.folder,f("select",{value:ki.value??"",onChange:a=>{let l=a.currentTarget.value;a.currentTarget.value=ki.peek()??"",t(null),l&&o()&&gf(l)},children:[f("option",{value:"",children:Da.value.length>0?"choose":"no study yet"}),Da.value.map(a=>f("option",{children:a}))]})]}),f("form",{class:"row",onSubmit:a=>{a.preventDefault();let l=r.trim();l!==""&&(Wx(l.endsWith(Um)?l:`${l}${Um}`),t(null))},children:[f("label",{children:["File name",f("input",{value:r,placeholder:`my${Um}`,spellcheck:!1,autocomplete:"off",onInput:a=>t(a.currentTarget.value)})]}),f("button",{type:"submit",disabled:r.trim()==="",children:"Save"})]}),f("button",{type:"button",disabled:!Fx.value,onClick:Fa,children:"Undo"}),f("button",{type:"button",disabled:!Ox.value,onClick:Oa,children:"Redo"}),f("button",{type:"button",disabled:St.value==="",onClick:()=>{xb().then(s)},children:"Copy link"}),f(vb,{}),f("span",{class:"quiet",role:"status",children:i}),f("span",{class:"quiet",role:"status",children:po.value?"not saved":ki.value===null?"":"saved"})]}),Rs.value!==null&&f("div",{class:"notice",role:"alert",children:[typeof Rs.value=="string"?f("p",{children:Rs.value}):f(nc,{problem:Rs.value}),f("button",{type:"button",class:"minor",onClick:()=>Rs.value=null,children:"Close"})]})]})}function Sb({branch:{key:n},steps:e,value:t}){let i=Fn(e),s=Xn.value.filter(c=>c.path===i||c.path.startsWith(`${i}[`)),r=Qs.value.filter(c=>c.path===i||c.path.startsWith(`${i}[`)),o=`key-${i}`,a={id:o,"aria-describedby":`${o}-about`,"aria-invalid":s.length>0,"aria-required":n.required},l=c=>{c!==os(t)&&ss(e,ic(n,c))};return f("div",{class:`field${s.length>0?" wrong":""}${t!==void 0?" given":""}`,children:[f("label",{for:o,children:[n.title,n.unit&&n.kind!=="quantities"&&f("span",{class:"quiet",children:" with unit"}),n.required&&t===void 0&&f("span",{class:"quiet",children:" (required)"})]}),n.kind==="boolean"?f("select",{...a,value:os(t),onChange:c=>ss(e,uL(c.currentTarget.value)),children:[f("option",{value:"",children:[n.default," (default)"]}),f("option",{children:"true"}),f("option",{children:"false"})]}):n.closed?f("select",{...a,value:os(t),onChange:c=>l(c.currentTarget.value),children:[f("option",{value:"",children:n.default?`${n.default} (default)`:"not given"}),n.names.map(c=>f("option",{children:c})),t!==void 0&&!n.names.includes(os(t))&&f("option",{children:os(t)})]}):f(hL,{...a,value:os(t),lines:cL(t),set:l,placeholder:n.default,names:[...n.names,...n.numbers]}),f("div",{id:`${o}-about`,children:[s.map(c=>f("p",{class:"problem",children:[c.cause,"; ",c.next_step]})),r.map(c=>f("p",{class:"doubt",children:c.text})),f("p",{class:"help",children:[_b(n)," ",f("code",{children:i})]})]})]})}var cL=n=>typeof n=="string"&&n.includes(`
`)?Math.min(n.split(`
`).length+1,30):0,uL=n=>n===""?null:n==="true";function hL({value:n,lines:e,set:t,names:i,...s}){let[r,o]=Ot(null),a={...s,value:r??n,spellcheck:!1,autocomplete:"off",onInput:l=>o(l.currentTarget.value),onBlur:()=>{r!==null&&t(r),o(null)}};return e>0?f("textarea",{...a,rows:e,wrap:"off"}):f(Tt,{children:[f("input",{...a,type:"text",list:i.length>0?`${s.id}-names`:void 0,onKeyDown:l=>{l.key==="Enter"&&r!==null&&t(r),l.key==="Escape"&&o(null)}}),i.length>0&&f("datalist",{id:`${s.id}-names`,children:i.map(l=>f("option",{value:l}))})]})}function Mb({tree:n}){return f("div",{class:"form",children:[Cs.value&&f("p",{class:"problem",role:"status",children:"The text has a mistake in its syntax. The form shows the last values until it is corrected."}),f("fieldset",{disabled:Cs.value,children:[f("legend",{class:"hidden",children:"Keys of the study"}),f(Fm,{branches:n,steps:[],given:Bi.value})]})]})}function Fm({branches:n,steps:e,given:t}){let i=n.filter(a=>!Sf(a)),s=({name:a,key:l})=>e.length===0&&!l.required&&t[a]===void 0,r=n.filter(a=>Sf(a)&&s(a)),o=a=>f(fL,{branch:a,steps:[...e,a.name],value:t[a.name]},a.key.path);return f(Tt,{children:[i.length>0&&f("div",{class:"fields",children:i.map(a=>f(Sb,{branch:a,steps:[...e,a.name],value:t[a.name]},a.key.path))}),n.filter(a=>Sf(a)&&!s(a)).map(o),r.length>0&&f("details",{class:"further",children:[f("summary",{children:["Further tables ",f("span",{class:"quiet",children:"that the study does not have"})]}),r.map(o)]})]})}function fL({branch:n,steps:e,value:t}){let{key:i}=n,s=Fn(e),r=Xn.value.filter(u=>u.path===s||u.path.startsWith(`${s}.`)||u.path.startsWith(`${s}[`)),o=r.filter(u=>u.path===s),[a,l]=Ot(null),c=a??(i.required||e.length>1&&t!==void 0);return f("details",{class:"section",open:c,onToggle:({currentTarget:u})=>{u.open!==c&&l(u.open)},children:[f("summary",{children:[i.title,f("span",{class:"quiet",children:[" ",gL(t)]}),r.length>0&&f("span",{class:"problem",children:[" ",r.length," problem",r.length>1?"s":""]})]}),c&&f("div",{class:"inside",children:[f("p",{class:"quiet",children:[i.help," ",f("code",{children:i.kind==="tables"?`[[${s}]]`:`[${s}]`})]}),o.map(u=>f("p",{class:"problem",children:[u.cause,"; ",u.next_step]})),i.kind==="tables"?f(pL,{branch:n,steps:e,items:Array.isArray(t)?t:[]}):i.kind==="entries"?f(mL,{branch:n,steps:e,given:km(t)}):f(dL,{branch:n,steps:e,value:t})]})]})}function dL({branch:n,steps:e,value:t}){let{key:i}=n,s=`key-${Fn(e)}`,r=i.names.length>0,o=r&&(t===void 0||typeof t=="string");return f(Tt,{children:[r&&f("div",{class:"field",children:[f("label",{for:s,children:[i.title,", by name"]}),f("select",{id:s,value:o?os(t):`
`,onChange:a=>{let l=a.currentTarget.value;ss(e,l===""?null:l===`
`?{}:l)},children:[f("option",{value:"",children:"not given"}),i.names.map(a=>f("option",{children:a})),typeof t=="string"&&!i.names.includes(t)&&f("option",{children:t}),f("option",{value:`
`,children:"other, by its constants"})]})]}),!o&&f(Fm,{branches:n.inside,steps:e,given:km(t)}),t!==void 0&&!i.required&&f(Om,{steps:e,children:["Remove ",i.title.toLowerCase()]})]})}function pL({branch:n,steps:e,items:t}){let i=n.key.title.toLowerCase();return f(Tt,{children:[t.map((s,r)=>f("fieldset",{class:"item",children:[f("legend",{children:[n.key.title," ",r+1]}),f(Fm,{branches:n.inside,steps:[...e,r],given:km(s)}),f(Om,{steps:[...e,r],children:["Remove ",i," ",r+1]})]},r)),f("button",{type:"button",onClick:()=>ss([...e,t.length],{}),children:["Add to ",i]})]})}function mL({branch:{key:n},steps:e,given:t}){let[i,s]=Ot(""),[r,o]=Ot(""),a=Fn(e);return f(Tt,{children:[f("ul",{class:"entries",children:Object.entries(t).map(([l,c])=>f("li",{children:[f("label",{for:`key-${a}.${l}`,children:l}),f("input",{id:`key-${a}.${l}`,value:os(c),onChange:u=>ss([...e,l],ic(n,u.currentTarget.value))}),f(Om,{steps:[...e,l],children:["Remove ",l]})]},l))}),f("div",{class:"row",children:[f("label",{children:["Name",f("input",{value:i,onInput:l=>s(l.currentTarget.value)})]}),f("label",{children:["Value",f("input",{value:r,onInput:l=>o(l.currentTarget.value)})]}),f("button",{type:"button",disabled:i===""||r==="",onClick:()=>{ss([...e,i],ic(n,r)),s(""),o("")},children:"Add a line"})]})]})}function Om({steps:n,children:e}){return f("button",{type:"button",class:"minor",onClick:()=>ss(n,null),children:e})}function gL(n){return n===void 0?"":typeof n=="string"?n:Array.isArray(n)?`${n.length} in the study`:"in the study"}function km(n){return typeof n=="object"&&!Array.isArray(n)?n:{}}var _L=["plate","map"],vL=["plate","rows"];function wb(n){let{map:e,rows:t}=n;if(typeof e!="string")return null;let i=e.trim().split(/\r?\n/).map(r=>Array.from(r.trim())),s=i[0]?.length??0;return s===0||i.some(r=>r.length!==s)?null:typeof t!="number"||t%i.length!==0||t<=0||t*s>1e5?i:Array.from({length:t},(r,o)=>i[o%i.length]??[])}function Tb(n,e){let t=e.rows!==void 0,i=n.map(a=>a.join("")),s=t?yL(i):i.length,r=`${i.slice(0,s).join(`
`)}
`,o=s<i.length?i.length:null;return[...r.trim()===String(e.map).trim()?[]:[{steps:_L,value:r}],...t&&e.rows!==o?[{steps:vL,value:o}]:[]]}function yL(n){for(let e=1;e<=n.length/2;e++)if(n.length%e===0&&n.every((t,i)=>t===n[i%e]))return e;return n.length}function Eb(n,e,t){let i=new Map;for(let[s,r]of e){let o=i.get(s)??n[s]?.slice();o===void 0||r<0||r>=o.length||(o[r]=t,i.set(s,o))}return n.map((s,r)=>i.get(r)??s)}function Bm([n,e],[t,i]){let s=Math.max(Math.abs(t-n),Math.abs(i-e));return Array.from({length:s+1},(r,o)=>{let a=s===0?0:o/s;return[Math.round(n+a*(t-n)),Math.round(e+a*(i-e))]})}function Ab([n,e],[t,i]){let s=[];for(let r=Math.min(n,t);r<=Math.max(n,t);r++)for(let o=Math.min(e,i);o<=Math.max(e,i);o++)s.push([r,o]);return s}function zm(n,e){let t=n[e[0]]?.[e[1]],i=n.map(r=>r.map(()=>!1)),s=[];for(let r=[e];;){let o=r.pop();if(o===void 0)return s;let[a,l]=o,c=i[a];c===void 0||c[l]!==!1||n[a]?.[l]!==t||(c[l]=!0,s.push(o),r.push([a-1,l],[a+1,l],[a,l-1],[a,l+1]))}}function Cb(n,e,t,i){let[s,r]=[n.length-1,(n[0]?.length??0)-1],o=t?[...e,...e.map(([a,l])=>[a,r-l])]:e;return i?[...o,...o.map(([a,l])=>[s-a,l])]:o}function Rb(n,e,t){if(e==="above"||e==="below"){let i=e==="above";if(!t)return n.length===1?n:i?n.slice(1):n.slice(0,-1);let s=(i?n[0]:n.at(-1))??[];return i?[s,...n]:[...n,s]}return n.map(i=>{let s=e==="left";if(!t)return i.length===1?i:s?i.slice(1):i.slice(0,-1);let r=(s?i[0]:i.at(-1))??".";return s?[r,...i]:[...i,r]})}function Vm(n,e){let t=e.length>1?(e.at(-1)??1)/(e.length-1):1;return e.length===n+1?e:Array.from({length:n+1},(i,s)=>s*t)}var Pb={m:1,cm:.01,mm:.001,um:1e-6,µm:1e-6,nm:1e-9},Ib="mm",xL=50;function Db(n){let e=n/xL,t=10**Math.floor(Math.log10(e)+1e-9);return([5,2].find(i=>i*t<=e*(1+1e-9))??1)*t}function sc(n,e,t,i,s){let r=Math.round(n/i)*i,o=s,a=t.flatMap((l,c)=>[l,(l+(t[c+1]??l))/2]);for(let l of e>0?[0,-e,e]:[0])for(let c of a){let u=Math.abs(n+l-c);u<o&&([r,o]=[c-l,u])}return r}function Mf(n,e){let t=/^\s*[-+.\deE]+\s*([a-zµ]+)\s*$/.exec(String(e??""))?.[1]??Ib,[i,s]=t in Pb?[t,Pb[t]??.001]:[Ib,.001];return`${Number((n/s).toPrecision(9))} ${i}`}function bL(n,e){let t=n;for(let i of e)t=Array.isArray(t)?t[Number(i)]:t?.[String(i)];return t??{}}var Lb=n=>Array.isArray(n)?n:[];function Nb(n,e,t){let i=bL(t,n.steps),[s,r]=[Lb(i.centre),Lb(i.size)],o=e.centre.map((c,u)=>Mf(c-n.corner[u],s[u])),a=e.size.map((c,u)=>u<2?Mf(c,r[u]):r[u]??""),l=(c,u)=>c.some((h,d)=>h!==u[d]);return[...l(o,s)?[{steps:[...n.steps,"centre"],value:o}]:[],...e.size.length>0&&l(a,r)?[{steps:[...n.steps,"size"],value:a}]:[]]}var kr="plate.clamp.corners",an=Pe("brush"),_o=Pe(""),Gm=Pe(!1),Hm=Pe(!1),as=Pe([0,0]),ls=Pe(null),er=Pe([]),ai=Pe(""),rc=Pe({}),oc=Pe(null),wf=Pe(null),Tf=Pe([]),Or=Wt(()=>{let n=Bi.value.plate;return typeof n=="object"&&!Array.isArray(n)?n:null}),zi=Pe(null);lt(()=>{(ff.value!==null||Or.value===null)&&(zi.value=ff.value)});var Fb=n=>typeof n=="object"&&!Array.isArray(n)?Object.entries(n):[],hi=Wt(()=>{let n=Fb(Or.value?.tiles).map(([i,s])=>({letter:i,name:String(s),isNew:!1})),e=new Set(n.map(({letter:i})=>i)),t=Tf.value.filter(({letter:i})=>!e.has(i)).map(i=>({...i,isNew:!0}));return[...n,...t,{letter:".",name:"no plate",isNew:!1}]}),Wm=Wt(()=>Or.value===null?null:wb(Or.value)),Jn=Wt(()=>{let n=wf.value??Wm.value;return n===null||er.value.length===0?n:Eb(n,Cb(n,er.value,Gm.value,Hm.value),qm())}),tr=Wt(()=>(zi.value?.parts??[]).map(n=>({...n,...rc.value[Fn(n.steps)]}))),nr=Wt(()=>oc.value??zi.value?.clamp??null),Ob=Wt(()=>wf.value!==null),qm=()=>hi.value.some(({letter:n})=>n===_o.value)?_o.value:hi.value[0]?.letter??".";lt(()=>{zi.value,rc.value={},oc.value=null});var Ub=0;function ac(n){if(er.value=[],n===null)return;let e=Ub+=1;wf.value=n;let t=new Set(n.flat());Ua(()=>[...Tf.peek().filter(({letter:i})=>t.has(i)&&!SL(i)).map(({letter:i,name:s})=>({steps:["plate","tiles",i],value:s})),...Tb(n,Or.peek()??{})]).then(()=>{e===Ub&&(wf.value=null)})}var SL=n=>Fb(Or.peek()?.tiles).some(([e])=>e===n);function lc(n){er.value=n,ac(Jn.peek())}var ML="123456789abcdefghijklmnpqrstuvwxyzABCDEFGHIJKLMNPQRSTUVWXYZ";function kb(n){let e=new Set(hi.peek().map(({letter:i})=>i)),t=Array.from(ML).find(i=>!e.has(i));t!==void 0&&(Tf.value=[...Tf.peek(),{letter:t,name:n}],_o.value=t)}function Ef(n,e){rc.value={...rc.peek(),[Fn(n.steps)]:e}}function Af(n){let e=rc.peek()[Fn(n.steps)];e!==void 0&&Ua(()=>Nb(n,e,Bi.peek()))}var yo=12,Cf=5,wL=5,TL=4,EL=.6,zb=()=>({ink:Ge("ink"),rim:Ge("paper")});function Vb(n,e){let t=zi.peek(),i=Vm(n[0]?.length??1,t?.x??[]),s=Vm(n.length,t?.y??[]),[r,o]=[i.at(-1)??1,s.at(-1)??1],a=Math.max(e-2*yo,50);return{x:i,y:s,scale:Math.min(a/r,EL*innerHeight/o)}}var Gb=({x:n,y:e,scale:t})=>[(n.at(-1)??0)*t+2*yo,(e.at(-1)??0)*t+2*yo],Hb=({y:n,scale:e},[t,i])=>[(t-yo)/e,(n.at(-1)??0)-(i-yo)/e];function Rf({x:n,y:e},[t,i]){let s=n.findIndex(o=>o>t)-1,r=e.findIndex(o=>o>i)-1;return s<0||r<0?null:[e.length-2-r,s]}function Xm(n){let e=zi.value?.lattices??[],i=hi.value.filter(({letter:s,name:r})=>s!=="."&&r!==e[0]).findIndex(s=>s.letter===n);return i<0?"rule":`curve-${i%TL}`}function $m({x:n,y:e},t){let[i,s]=[n.at(-1)??0,e.at(-1)??0],r=o=>[t,o-t];return[0,s].flatMap(o=>r(i).map(a=>[a,o])).concat([0,i].flatMap(o=>r(s).map(a=>[o,a])))}function Wb(n,e,t){let[i,s,r]=[n.getContext("2d"),Jn.peek(),zi.peek()];if(i===null||s===null)return;let o=devicePixelRatio,a=e.y.at(-1)??0,l=([u,h])=>[o*(yo+u*e.scale),o*(yo+(a-h)*e.scale)];i.clearRect(0,0,n.width,n.height),AL(i,s,e,l),r!==null&&CL(i,r,s,e,l),RL(i,e,l);let c=[[t&&an.peek()!=="move"?as.peek():null,"accent",[]],[ls.peek(),"carrier",[3,3]]];for(let[u,h,d]of c)u!==null&&PL(i,u,e,l,h,d)}function qb([n,e],{x:t,y:i}){let s=i.length-2-n;return[[t[e]??0,i[s+1]??0],[t[e+1]??0,i[s]??0]]}function AL(n,e,t,i){let s=new Map(hi.peek().map(({letter:c})=>[c,Ge(Xm(c))]));n.save(),n.globalAlpha=.34,e.forEach((c,u)=>c.forEach((h,d)=>{if(h===".")return;let[[p,_],[x,g]]=qb([u,d],t).map(i);n.fillStyle=s.get(h)??Ge("carrier"),n.fillRect(p,_,x-p,g-_)}));let[r,o]=[t.x.length-1,t.y.length-1],[a,l]=[t.x.at(-1)??0,t.y.at(-1)??0];if(a/r*t.scale>=wL){n.globalAlpha=1,n.strokeStyle=Ge("rule"),n.lineWidth=1,n.beginPath();let c=[...t.x.map(u=>[[u,0],[u,l]]),...t.y.map(u=>[[0,u],[a,u]])];for(let[u,h]of c)n.moveTo(...i(u)),n.lineTo(...i(h));n.stroke()}n.restore(),n.canvas.dataset.tiles=`${r} x ${o}`}function CL(n,e,t,i,s){let r=Wm.peek();if(e.x.length!==i.x.length||e.y.length!==i.y.length)return;let o=a=>{let l=Rf(i,a);return l!==null&&t[l[0]]?.[l[1]]===r?.[l[0]]?.[l[1]]};n.strokeStyle=n.fillStyle=Ge("quiet"),n.lineWidth=devicePixelRatio,sf(n,e.features,s,o),n.stroke(),n.strokeStyle=Ge("ink");for(let a of e.plate)As(n,a,s);rf(n,e.held,s);for(let[a,l]of Object.entries(e.regions))Ra(n,a,l,s,zb())}function RL(n,e,t){let i=an.peek()==="move";n.lineWidth=1.5*devicePixelRatio;for(let r of tr.peek()){let[o=0,a=0]=r.diameter===null?r.size:[r.diameter,r.diameter],l=Nr(r.centre,[o,a]);if(n.save(),n.strokeStyle=Ge("ink"),n.fillStyle=Ge("gap"),n.beginPath(),r.diameter!==null||o===0){let d=Math.max((r.diameter??0)/2*e.scale,Cf)*devicePixelRatio;n.arc(...t(r.centre),d,0,2*Math.PI)}else Ql(n,l,t);n.globalAlpha=r.diameter===null?.85:.3,n.fill(),n.globalAlpha=1,n.stroke(),n.restore();let[c,u]=t([r.centre[0],r.centre[1]]),h=o===0?-10:4;gm(n,r.name,[c,u+h*devicePixelRatio],zb()),i&&Fn(r.steps)===ai.peek()&&Bb(n,r.size.length>0?l:[r.centre],t)}let s=nr.peek();i&&s!==null&&ai.peek()===kr&&Bb(n,$m(e,s),t)}function Bb(n,e,t){let i=Cf*devicePixelRatio;n.fillStyle=Ge("paper"),n.strokeStyle=Ge("accent");for(let s of e){let[r,o]=t(s);n.fillRect(r-i,o-i,2*i,2*i),n.strokeRect(r-i,o-i,2*i,2*i)}}function PL(n,e,t,i,s,r){let[[o,a],[l,c]]=qb(e,t).map(i);n.save(),n.strokeStyle=Ge(s),n.lineWidth=2.5*devicePixelRatio,n.setLineDash(r.map(u=>u*devicePixelRatio)),n.strokeRect(o,a,l-o,c-a),n.restore()}var IL=800,Ym=n=>String(Number(n.toPrecision(3)));function Xb(){let[n,e]=[Jn.value,zi.value];if(n===null)return null;let t=new Map;for(let r of n.flat())t.set(r,(t.get(r)??0)+1);let i=e!==null&&e.x.length===(n[0]?.length??0)+1&&e.y.length===n.length+1,s=Ob.value||Xn.value.length>0;return f("div",{class:"facts",children:[f("dl",{children:[hi.value.filter(({letter:r})=>r!==".").map(({letter:r,name:o})=>f("div",{children:[f("dt",{children:o}),f("dd",{children:[t.get(r)??0," tiles"]})]})),f("div",{children:[f("dt",{children:"map"}),f("dd",{children:[n[0]?.length," x ",n.length," tiles"]})]}),e!==null&&i&&f(Tt,{children:[f("div",{children:[f("dt",{children:"size"}),f("dd",{children:[Ym(1e3*(e.x.at(-1)??0))," x ",Ym(1e3*(e.y.at(-1)??0))," mm"]})]}),f("div",{children:[f("dt",{children:"contents"}),f("dd",{children:e.contents})]}),e.mass!==null&&f("div",{children:[f("dt",{children:"mass without patches"}),f("dd",{children:[Ym(1e3*e.mass)," g"]})]})]})]}),s&&f("p",{class:"quiet",children:"Size, contents and mass are those of the last map that could be built."}),!s&&e?.remarks.map(r=>f("p",{class:"doubt",children:r}))]})}function $b(){let[n,e]=Ot(null),t=vt(null),i=vt(!1),s=St.value;Rt(()=>{let o=setTimeout(async()=>{if(t.current=s,!i.current){for(i.current=!0;t.current!==null;){let a=t.current;t.current=null;try{e({of:a,...await qt.forecast(a)})}catch{}}i.current=!1}},IL);return()=>clearTimeout(o)},[s]);let r=n===null||n.of!==s;return f("details",{open:!0,children:[f("summary",{children:["Estimated costs ",f("span",{class:"quiet",children:"as orders of magnitude"})]}),r?f("p",{class:"quiet",children:"Estimated again after a moment without changes."}):n.costs.length===0?f("p",{class:"quiet",children:"Not estimated, because the study has a problem."}):f("table",{children:[f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"command"}),f("th",{scope:"col",children:"processor time"}),f("th",{scope:"col",children:"memory"})]})}),f("tbody",{children:n.costs.map(({command:o,time:a,memory:l,refusal:c})=>f("tr",{children:[f("td",{children:["haptonic ",o]}),f("td",{children:c?`refused: ${c}`:a}),f("td",{children:c?"":l})]}))})]})]})}var Zb=6,Km={b:"brush",l:"line",r:"rectangle",f:"fill",v:"move"},LL=10;function Jb(n,e){return an.peek()==="rectangle"?Ab(n,e):Bm(n,e)}function Pf({x:n}){return Db((n.at(-1)??1)/Math.max(n.length-1,1))}function jb(n,e){let t=null,i=()=>{},s=u=>{let h=n.getBoundingClientRect();return Hb(e(),[u.clientX-h.left,u.clientY-h.top])},c={pointerdown:u=>{if(u.button!==0)return;let h=s(u);an.peek()==="move"?[t,i]=NL(e(),h):[t,i]=DL(e(),h),t!==null&&n.setPointerCapture(u.pointerId)},pointermove:u=>t?.(s(u)),pointerup:()=>{t!==null&&i(),t=null},pointercancel:()=>{t=null,er.value=[]}};for(let[u,h]of Object.entries(c))n.addEventListener(u,h);return()=>{for(let[u,h]of Object.entries(c))n.removeEventListener(u,h)}}var Zm=[null,()=>{}];function DL(n,e){let[t,i]=[Rf(n,e),Jn.peek()];if(t===null||i===null)return Zm;if(as.value=t,ls.value=null,an.peek()==="fill")return lc(zm(i,t)),Zm;let s=t;return er.value=[t],[o=>{let a=Rf(n,o);a===null||a[0]===s[0]&&a[1]===s[1]||(er.value=an.peek()==="brush"?[...er.peek(),...Bm(s,a)]:Jb(t,a),as.value=s=a)},()=>ac(Jn.peek())]}function NL(n,e){let t=2*Cf/n.scale,i=([h,d])=>Math.hypot(e[0]-h,e[1]-d)<t,s=tr.peek(),r=s.find(h=>Fn(h.steps)===ai.peek());if(r!==void 0&&r.size.length>0){let[h=0,d=0]=r.size,p=Nr(r.centre,[h,d]),_=p.findIndex(i),x=p[(_+2)%4];if(_>=0&&x!==void 0)return[g=>Ef(r,FL(r,x,g,n)),()=>Af(r)]}let o=nr.peek();if(o!==null&&$m(n,o).some(i))return ai.value=kr,[h=>Qb(OL(h,n),n),eS];let a=[...s].reverse().find(({centre:h,size:d,diameter:p})=>{let[_=0,x=0]=p===null?d:[p,p],[g,m]=[Math.abs(e[0]-h[0]),Math.abs(e[1]-h[1])];return g<Math.max(_/2,t)&&m<Math.max(x/2,t)});if(ai.value=a===void 0?"":Fn(a.steps),a===void 0)return Zm;let[l,c]=[e[0]-a.centre[0],e[1]-a.centre[1]];return[([h,d])=>Ef(a,UL(a,[h-l,d-c],n)),()=>Af(a)]}function UL(n,[e,t],i){let[s=0,r=0]=n.diameter===null?n.size:[n.diameter,n.diameter],[o,a]=[Pf(i),Zb/i.scale],l=[sc(e,s/2,i.x,o,a),sc(t,r/2,i.y,o,a)];return{...n,centre:l}}function FL(n,[e,t],[i,s],r){let[o,a]=[Pf(r),Zb/r.scale],[l,c]=[sc(i,0,r.x,o,a),sc(s,0,r.y,o,a)],u=[Math.max(Math.abs(l-e),o),Math.max(Math.abs(c-t),o)];return{...n,centre:[(e+l)/2,(t+c)/2],size:[...u,...n.size.slice(2)]}}function OL([n,e],t){let[i,s]=[t.x.at(-1)??0,t.y.at(-1)??0],[r,o]=[Math.min(n,i-n),Math.min(e,s-e)];return Math.max(r,o)}function Qb(n,e){let t=Pf(e);oc.value=Math.max(Math.round(n/t)*t,t)}function eS(){let n=oc.peek();if(n===null)return;let e=["plate","clamp","corners"];Ua(()=>{let t=Bi.peek().plate;return[{steps:e,value:Mf(n,t.clamp?.corners)}]})}function Yb(n,[e,t],i){let s=Pf(n);if(ai.peek()===kr){Qb((nr.peek()??s)+(e+t)*s,n),eS();return}let r=tr.peek().find(({steps:h})=>Fn(h)===ai.peek());if(r===void 0)return;let[o,a]=r.centre,[l=0,c=0,...u]=r.size;i&&r.size.length===0||(Ef(r,i?{...r,size:[Math.max(l+e*s,s),Math.max(c+t*s,s),...u]}:{...r,centre:[o+e*s,a+t*s]}),Af(r))}function kL(n,e){let t=Jn.peek();if(t===null)return;let[i,s]=as.peek(),r=(o,a)=>Math.min(Math.max(o,0),a-1);as.value=[r(i-e,t.length),r(s+n,t[0]?.length??1)]}function BL(){let[n,e,t]=[Jn.peek(),as.peek(),ls.peek()];n===null||an.peek()==="move"||(an.peek()==="fill"?lc(zm(n,e)):an.peek()==="brush"?lc([e]):t===null?ls.value=e:(ls.value=null,lc(Jb(t,e))))}function Kb(n){let e=[...tr.peek().map(({steps:s})=>Fn(s)),...zi.peek()?.clamp?[kr]:[]],t=e.length,i=e.indexOf(ai.peek())+n;ai.value=e[(i%t+t)%t]??"",an.value="move"}function tS(n){let e=(s,r)=>o=>{let a=o.shiftKey?LL:1;an.peek()!=="move"?kL(s*a,r*a):Yb(n(),[s*a,r*a],!1)},t=s=>()=>{let r=hi.peek()[s];r!==void 0&&(_o.value=r.letter)},i=(s,r)=>()=>{an.peek()==="move"&&Yb(n(),[s,r],!0)};return[{keys:"← → ↑ ↓",effect:"move the cursor, or the selected part; ten steps with Shift",actions:{ArrowLeft:e(-1,0),ArrowRight:e(1,0),ArrowUp:e(0,1),ArrowDown:e(0,-1)}},{keys:"space",effect:"paint; of a line or rectangle first one end, then the other",actions:{" ":BL}},{keys:"1 … 9",effect:"choose a tile, in the order of the palette",actions:Object.fromEntries(Array.from({length:9},(s,r)=>[String(r+1),t(r)]))},{keys:Object.keys(Km).join(" "),effect:Object.values(Km).join(", "),actions:Object.fromEntries(Object.entries(Km).map(([s,r])=>[s,()=>an.value=r]))},{keys:"n p",effect:"select the next or the previous part",actions:{n:()=>Kb(1),p:()=>Kb(-1)}},{keys:"+ − > <",effect:"make the selected patch wider, narrower, higher or lower",actions:{"+":i(1,0),"-":i(-1,0),">":i(0,1),"<":i(0,-1)}},{keys:"Esc",effect:"forget the first end",actions:{Escape:()=>ls.value=null}}]}var zL={brush:"Brush",line:"Line",rectangle:"Rectangle",fill:"Fill",move:"Move parts"},VL=["left","right","above","below"],GL={x:[0,1],y:[0,1],scale:1};function nS({first:n}){return Object.keys(Bi.value).length===0?null:Or.value===null?f("p",{class:"paint",children:[f("button",{type:"button",class:"minor",disabled:Cs.value,onClick:()=>ss(["plate"],n),children:"Begin a plate"})," ",f("span",{class:"quiet",children:"of this cell, and paint its map"})]}):f("details",{class:"section paint",open:!0,children:[f("summary",{children:["Map of the plate ",f("span",{class:"quiet",children:"painted with tiles; parts are dragged"})]}),Jn.value===null?f("p",{class:"problem",children:"The map can be painted when it has letters, and all its lines are equally long."}):f(HL,{})]})}function HL(){let n=vt(null),e=vt(GL),[t]=Ot(()=>tS(()=>e.current));return Rt(()=>{let i=n.current;if(i===null)return;let s=()=>{let a=Jn.peek();if(a===null)return;e.current=Vb(a,i.parentElement?.clientWidth??300);let[l,c]=Gb(e.current),[u,h]=[l,c].map(d=>Math.round(d*devicePixelRatio));(i.width!==u||i.height!==h)&&([i.width,i.height]=[u??0,h??0],[i.style.width,i.style.height]=[`${l}px`,`${c}px`]),Wb(i,e.current,document.activeElement===i)},r=new ResizeObserver(s);i.parentElement!==null&&r.observe(i.parentElement),i.addEventListener("focus",s),i.addEventListener("blur",s);let o=[jb(i,()=>e.current),_s(s),lt(()=>{Jn.value,tr.value,an.value,as.value,ls.value,ai.value,nr.value,hi.value,s()})];return()=>{r.disconnect();for(let a of o)a()}},[]),f("div",{class:"inside",children:[f(WL,{}),f(qL,{}),f("div",{class:"board",children:[f("canvas",{ref:n,tabIndex:0,role:"application","aria-label":"Map of the plate. Arrow keys move, the space bar paints, digits choose a tile.","aria-describedby":"paint-place",onKeyDown:i=>{(i.ctrlKey||i.metaKey)&&i.key.toLowerCase()==="z"?(i.preventDefault(),(i.shiftKey?Oa:Fa)()):hr(i,t)}}),f("div",{class:"beside",children:[f(XL,{}),f(Xb,{}),f($L,{}),f(YL,{}),f($b,{})]})]}),f("details",{children:[f("summary",{children:"Keys on the map"}),f("table",{children:f("tbody",{children:t.map(({keys:i,effect:s})=>f("tr",{children:[f("th",{scope:"row",children:f("kbd",{children:i})}),f("td",{children:s})]}))})})]})]})}function WL(){let[n,e]=Ot("");return f("div",{class:"row palette",role:"group","aria-label":"Tiles",children:[hi.value.map(({letter:t,name:i})=>f("button",{type:"button",class:"minor","aria-pressed":t===qm()&&an.value!=="move",onClick:()=>{_o.value=t,an.peek()==="move"&&(an.value="brush")},children:[f("span",{class:"swatch",style:{background:t==="."?"none":`var(--${Xm(t)})`},"aria-hidden":"true"}),f("code",{children:t})," ",i]})),f("form",{class:"row",onSubmit:t=>{t.preventDefault(),kb(n.trim()),e("")},children:[f("input",{"aria-label":"Name of a new region or lattice",placeholder:"new tile",size:9,value:n,onInput:t=>e(t.currentTarget.value)}),f("button",{type:"submit",class:"minor",disabled:n.trim()==="",children:"Add"})]})]})}function qL(){let n=[{signal:Gm,words:"mirror left and right"},{signal:Hm,words:"mirror top and bottom"}];return f("div",{class:"row",role:"group","aria-label":"Tools",children:[Object.entries(zL).map(([e,t])=>f("button",{type:"button",class:"minor","aria-pressed":an.value===e,onClick:()=>an.value=e,children:t})),n.map(({signal:e,words:t})=>f("label",{class:"check",children:[f("input",{type:"checkbox",checked:e.value,onChange:i=>e.value=i.currentTarget.checked}),t]}))]})}function XL(){let n=tr.value.find(({steps:l})=>Fn(l)===ai.value),e=l=>Number((1e3*l).toPrecision(6)),[t,i]=as.value,s=Jn.value?.[t]?.[i],r=hi.value.find(l=>l.letter===s)?.name??"",o=n!==void 0&&n.size.length>0?`, ${n.size.slice(0,2).map(e).join(" x ")} mm`:"",a=an.value!=="move"?`Row ${t+1} from above, column ${i+1}: ${s??""} ${r}${ls.value===null?"":"; the first end is chosen"}`:n!==void 0?`${n.name}: centre at ${n.centre.map(e).join(" and ")} mm on the plate${o}`:ai.value===kr&&nr.value!==null?`Corners supported over ${e(nr.value)} mm`:"Select a part in the drawing, or with the key n.";return f("p",{id:"paint-place",class:"small","aria-live":"polite",children:a})}function $L(){let n=(e,t)=>{let i=Jn.peek();i!==null&&ac(Rb(i,e,t))};return f("div",{class:"row",role:"group","aria-label":"Size of the map",children:VL.map(e=>f("span",{children:[e," ",f("button",{type:"button",class:"minor","aria-label":`Add a line ${e}`,onClick:()=>n(e,!0),children:"+"})," ",f("button",{type:"button",class:"minor","aria-label":`Remove a line ${e}`,onClick:()=>n(e,!1),children:"−"})]}))})}function YL(){let n=({path:e})=>e==="plate"||e.startsWith("plate.");return f("div",{"aria-live":"polite",children:[Xn.value.filter(n).map(({path:e,cause:t,next_step:i})=>f("p",{class:"problem",children:[f("code",{children:e}),": ",t,"; ",i]})),Qs.value.filter(n).map(({path:e,text:t})=>f("p",{class:"doubt",children:[f("code",{children:e}),": ",t]}))]})}var iS=`.paint .inside { padding-bottom: 0.6rem; }
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
`;var xo="order of computation",sS="",ln=Pe([]),ka=Pe(sS),Df=Pe(null),Vi=Pe(null),Jm=null,If=!1,Br=Wt(()=>ln.value.map((n,e)=>e).filter(n=>!ka.value||ln.value[n]?.group===ka.value)),Nf=Wt(()=>[...new Set(ln.value.map(n=>n.group))]),Lf=Wt(()=>{let n=Br.value.map(e=>(ln.value[e]?.varied??[]).map(({title:t})=>t));return[...new Set(n[0])].filter(e=>n.every(t=>t.includes(e)))}),Ba=Wt(()=>{let n=Df.value;return n!==null&&(n===xo||Lf.value.includes(n))?n:Lf.value[0]??xo});function rS(){lt(()=>{let n=rs.value.find(({number:e})=>e===gn.value);gn.value!==Jm&&(Jm=gn.value,ln.value=[],Vi.value=Df.value=null,ka.value=sS),n!==void 0&&n.points>ln.value.length&&ZL(n.number)})}async function ZL(n){If||(If=!0,await Un(async()=>{let e=ln.peek().length,t=await qt.points(n,e);If=!1,n===Jm&&e===ln.peek().length&&(ln.value=[...ln.peek(),...t])}),If=!1)}var cc=(n,e,t)=>t===xo?e+1:n.varied.find(i=>i.title===t)?.value??NaN,JL=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"]],jL=["Hz","m","Pa"];function Uf(n,e){let t=Math.max(...n.map(Math.abs),0);if(e==="rad")return{factor:180/Math.PI,unit:"deg"};let[i,s]=JL.find(([r])=>jL.includes(e)&&t>=r)??[1,""];return{factor:1/i,unit:s+e}}function Ff({value:n,unit:e,error:t},i){let s=Uf([n],e),r=n*s.factor;return`${i&&t!==null?Ii(r,t*s.factor):String(Number(r.toPrecision(i?4:6)))} ${s.unit}`.trim()+(i&&t===null?" (preview)":"")}var QL=280,e2=3.5,t2=20,n2=4;function Of(){let n=Br.value,e=Ba.value,t=n.flatMap(u=>ln.value[u]?.results??[]),i=t[0]?.unit??"",s=[...new Set(t.filter(u=>u.unit===i).map(u=>u.title))],r=n.map(u=>cc(ln.value[u],u,e)),o=ln.value[n[0]??0]?.varied.find(u=>u.title===e)?.unit??"",a=e===xo?{factor:1,unit:""}:Uf(r,o),l=Uf(t.filter(u=>u.unit===i).map(({value:u})=>u),i);return{list:n.flatMap((u,h)=>(ln.value[u]?.results??[]).filter(d=>d.unit===i).map(d=>({place:u,x:r[h]*a.factor,y:d.value*l.factor,error:d.error===null?null:d.error*l.factor,series:s.indexOf(d.title)}))),titles:s,x:a,y:l}}function oS(n){let[e,t]=[Math.min(...n),Math.max(...n)];if(!Number.isFinite(e))return[0,1];let i=.06*(t-e)||Math.abs(t)*.05||1;return[e-i,t+i]}function aS(n){let e=Of(),t=()=>({width:vs(n),height:QL}),i={stroke:()=>Ge("ink"),ticks:{stroke:()=>Ge("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},s=(a,{unit:l})=>l?`${a} / ${l}`:a,r=()=>({x:oS(e.list.map(a=>a.x)),y:oS(e.list.flatMap(a=>[a.y-(a.error??0),a.y+(a.error??0)]))}),o=new jt({...t(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!1,y:!1}},scales:{x:{time:!1,range:()=>r().x},y:{range:()=>r().y}},axes:[{...i,label:" ",labelSize:22,size:34},{...i,label:" ",labelSize:24,size:58}],series:[{},{show:!0,stroke:"transparent",points:{show:!1}}],hooks:{draw:[a=>Bs(a,()=>i2(a,e))]}},[[0,1],[0,1]],n);return _r(o,(a,l)=>{let c=({x:h,y:d})=>Math.hypot(o.valToPos(h,"x")-a,o.valToPos(d,"y")-l),u=e.list.reduce((h,d)=>h&&c(h)<=c(d)?h:d,null);u!==null&&c(u)<t2&&(Vi.value=u.place)}),ys(o,n,t,[lt(()=>{e=Of(),Vi.value,o.axes[0].label=s(Ba.value,e.x),o.axes[1].label=s(e.titles.join(", "),e.y);let{x:a,y:l}=r();o.setData([a,l]),n.dataset.marks=String(e.list.length)})])}function i2(n,{list:e}){let{ctx:t}=n,i=e2*devicePixelRatio;t.lineWidth=1.5*devicePixelRatio;for(let{place:s,x:r,y:o,error:a,series:l}of e){let[c,u]=[n.valToPos(r,"x",!0),n.valToPos(o,"y",!0)];t.strokeStyle=t.fillStyle=Ge(`curve-${l%n2}`),t.beginPath(),l%2?t.rect(c-i,u-i,2*i,2*i):t.arc(c,u,i,0,2*Math.PI),a===null||(t.fill(),t.beginPath(),t.moveTo(c,n.valToPos(o-a,"y",!0)),t.lineTo(c,n.valToPos(o+a,"y",!0))),t.stroke(),s===Vi.peek()&&(t.strokeStyle=Ge("ink"),t.beginPath(),t.arc(c,u,2.4*i,0,2*Math.PI),t.stroke())}}var jm=500;function lS(n){let e=Ba.peek(),t=[...Br.peek()].sort((s,r)=>cc(ln.peek()[s],s,e)-cc(ln.peek()[r],r,e)),i=Vi.peek()===null?-1:t.indexOf(Vi.peek());Vi.value=t[Math.min(Math.max(i+n,0),t.length-1)]??null}var Qm=n=>{n!==null&&gn.peek()!==null&&Hx(gn.peek(),n)},eg=[{keys:"← →",effect:"previous or next design",actions:{ArrowLeft:()=>lS(-1),ArrowRight:()=>lS(1)}},{keys:"Enter",effect:"open the design in the text",actions:{Enter:()=>Qm(Vi.peek())}}];function cS(){let n=ln.value.length;return n===0?null:f("details",{class:"section",open:!0,children:[f("summary",{children:["Computed designs ",f("span",{class:"quiet",children:n})]}),f("div",{class:"row",children:[Nf.value.length>1&&f("label",{children:["Part",f("select",{value:ka.value,onChange:e=>ka.value=e.currentTarget.value,children:[f("option",{value:"",children:"all"}),Nf.value.map(e=>f("option",{children:e}))]})]}),f("label",{children:["Horizontal axis",f("select",{value:Ba.value,onChange:e=>Df.value=e.currentTarget.value,children:[...Lf.value,xo].map(e=>f("option",{children:e}))})]}),f(r2,{})]}),f("div",{class:"walk",tabIndex:0,role:"application","aria-label":"Computed designs. Arrow keys select a design, Enter opens it.","aria-describedby":"selected-design",onKeyDown:e=>hr(e,eg),children:f(s2,{})}),f(o2,{}),f("details",{class:"further",children:[f("summary",{children:"Designs as a table"}),f(a2,{})]})]})}function s2(){let n=vt(null);return Rt(()=>n.current===null?void 0:aS(n.current),[]),f("div",{class:"curves",ref:n})}function r2(){let{list:n,titles:e}=Of();return f("span",{class:"quiet legend",children:[e.map((t,i)=>f("span",{class:"of-mark",style:{"--mark":`var(--curve-${i%4})`,"--round":i%2?"0":"50%"},children:t})),n.some(({error:t})=>t===null)&&f("span",{class:"of-preview",children:"hollow: preview, without an error"})]})}function o2(){let n=Vi.value,e=n===null?void 0:ln.value[n];if(e===void 0)return f("p",{id:"selected-design",class:"quiet",children:"Select a design with a click or the arrow keys."});let t=[...e.varied.map(i=>[i.title,Ff(i,!1)]),...e.results.map(i=>[i.title,Ff(i,!0)])];return f("div",{class:"facts",children:f("p",{id:"selected-design","aria-live":"polite",children:["Design ",n+1,Nf.value.length>1&&`, ${e.group}`,": ",t.map(([i,s])=>`${i} ${s}`).join(", "),e.results.length===0&&", no result","."," ",f("button",{type:"button",onClick:()=>Qm(n),children:"Open as a design"})]})})}function a2(){let n=Br.value.slice(0,jm),e=r=>[...new Set(n.flatMap(o=>ln.value[o][r].map(({title:a})=>a)))],[t,i]=[e("varied"),e("results")],s=(r,o,a)=>{let l=ln.value[r][o].find(c=>c.title===a);return f("td",{class:"number",children:l===void 0?"-":Ff(l,o==="results")})};return f("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Computed designs",children:[f("table",{children:[f("thead",{children:f("tr",{children:[f("th",{scope:"col",children:"design"}),f("th",{scope:"col",children:"part"}),[...t,...i].map(r=>f("th",{scope:"col",children:r}))]})}),f("tbody",{children:n.map(r=>f("tr",{"aria-current":Vi.value===r?"true":void 0,children:[f("td",{children:f("button",{type:"button",class:"minor",onClick:()=>Qm(r),children:["Open ",r+1]})}),f("td",{children:ln.value[r].group}),t.map(o=>s(r,"varied",o)),i.map(o=>s(r,"results",o))]}))})]}),Br.value.length>jm&&f("p",{class:"quiet",children:["and ",Br.value.length-jm," more"]})]})}var uS=`#studio { padding: 0.75rem 1rem; }
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
`;function c2({start:n}){let e=gb(n.form);return f(Tt,{children:[f(bb,{start:n}),f(u2,{}),f("main",{class:"workbench",children:[f("div",{class:"study",children:[f("section",{id:"form","aria-label":"Form",tabIndex:0,children:f(Mb,{tree:e})}),f("section",{id:"text","aria-label":"Text",children:f(Qx,{})})]}),f("div",{class:"results",tabIndex:0,role:"group","aria-label":"Analyses and result",children:[f(pb,{analyses:n.analyses}),f(nS,{first:n.plate}),f(fb,{}),f(cS,{}),f(ub,{exports:n.exports}),f("footer",{children:f("p",{children:["haptonic ",n.version]})})]})]})]})}function u2(){return Pm.value?f("p",{class:"notice",role:"alert",children:["The server of the studio does not answer. If it has ended, run ",f("code",{children:"haptonic studio"})," again and open its new link; copy a text that is not saved first."]}):null}async function h2(){bm();let n=document.createElement("style");n.textContent=uS+iS,document.head.append(n);let e=document.getElementById("studio");if(e===null)throw new Error("the page has no place for the studio");await Un(async()=>{let t=await qt.start();Da.value=t.files,$x(t.form,t.expressions),sl("Text of the study",jx),sl("Computed designs",eg),Za(f(c2,{start:t}),e),t.opened!==null&&await gf(t.opened),await Nm(),sb(),rS(),hb()}),addEventListener("hashchange",()=>{Nm()}),addEventListener("beforeunload",t=>{po.peek()&&t.preventDefault()})}h2().catch(n=>{let e=document.createElement("p");e.textContent=`The studio cannot be shown: ${n instanceof Error?n.message:String(n)}`,document.body.replaceChildren(e)});
