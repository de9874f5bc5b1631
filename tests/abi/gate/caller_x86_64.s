	.file	"caller.c"
	.text
	.type	hear, @function
hear:
	addl	$1, (%rdi)
	comisd	.LC0(%rip), %xmm0
	seta	%al
	movzbl	%al, %eax
	ret
	.size	hear, .-hear
	.type	counted, @function
counted:
	movq	%rdi, %rax
	pxor	%xmm0, %xmm0
	movups	%xmm0, -32(%rsp)
	leaq	blocks(%rip), %rcx
	movq	%rcx, -56(%rsp)
	leaq	take(%rip), %rsi
	movq	%rsi, -48(%rsp)
	leaq	release(%rip), %rdx
	movq	%rdx, -40(%rsp)
	movdqa	-56(%rsp), %xmm1
	movups	%xmm1, (%rdi)
	movdqa	-40(%rsp), %xmm2
	movups	%xmm2, 16(%rdi)
	movq	-24(%rsp), %rdx
	movq	%rdx, 32(%rdi)
	ret
	.size	counted, .-counted
	.type	wrc_config_default, @function
wrc_config_default:
	pushq	%rbp
	pushq	%rbx
	subq	$1192, %rsp
	movq	%rdi, %rbp
	movq	%rsp, %rbx
	movl	$148, %ecx
	movl	$0, %eax
	movq	%rbx, %rdi
	rep stosq
	movl	$1184, (%rsp)
	movq	%rbx, %rdi
	call	wrc_config_init@PLT
	movl	$148, %ecx
	movq	%rbp, %rdi
	movq	%rbx, %rsi
	rep movsq
	movq	%rbp, %rax
	addq	$1192, %rsp
	popq	%rbx
	popq	%rbp
	ret
	.size	wrc_config_default, .-wrc_config_default
	.type	standard, @function
standard:
	pushq	%rbp
	pushq	%rbx
	subq	$1256, %rsp
	movq	%rdi, %rbx
	leaq	64(%rsp), %rbp
	movq	%rbp, %rdi
	call	wrc_config_default
	movq	%rsp, %rdi
	pxor	%xmm0, %xmm0
	movaps	%xmm0, (%rsp)
	movaps	%xmm0, 16(%rsp)
	movaps	%xmm0, 32(%rsp)
	movaps	%xmm0, 48(%rsp)
	call	wrc_material_init@PLT
	movsd	8(%rsp), %xmm0
	movsd	%xmm0, 304(%rsp)
	movsd	16(%rsp), %xmm0
	movsd	%xmm0, 312(%rsp)
	movsd	24(%rsp), %xmm0
	movsd	%xmm0, 320(%rsp)
	movsd	32(%rsp), %xmm0
	movsd	%xmm0, 328(%rsp)
	movsd	40(%rsp), %xmm0
	movsd	%xmm0, 336(%rsp)
	movsd	48(%rsp), %xmm0
	movsd	%xmm0, 344(%rsp)
	movsd	56(%rsp), %xmm0
	movsd	%xmm0, 352(%rsp)
	movsd	.LC1(%rip), %xmm0
	movsd	%xmm0, 296(%rsp)
	movdqu	296(%rsp), %xmm1
	movups	%xmm1, 232(%rsp)
	movdqu	312(%rsp), %xmm2
	movups	%xmm2, 248(%rsp)
	movdqu	328(%rsp), %xmm3
	movups	%xmm3, 264(%rsp)
	movdqu	344(%rsp), %xmm4
	movups	%xmm4, 280(%rsp)
	movl	$2, 72(%rsp)
	movl	$3, 152(%rsp)
	movsd	%xmm0, 232(%rsp)
	movq	.LC2(%rip), %rax
	movq	%rax, 424(%rsp)
	movsd	368(%rsp), %xmm0
	movsd	%xmm0, 432(%rsp)
	movsd	376(%rsp), %xmm0
	movsd	%xmm0, 440(%rsp)
	movsd	384(%rsp), %xmm0
	movsd	%xmm0, 448(%rsp)
	movsd	392(%rsp), %xmm0
	movsd	%xmm0, 456(%rsp)
	movsd	400(%rsp), %xmm0
	movsd	%xmm0, 464(%rsp)
	movsd	408(%rsp), %xmm0
	movsd	%xmm0, 472(%rsp)
	movsd	416(%rsp), %xmm0
	movsd	%xmm0, 480(%rsp)
	movq	.LC3(%rip), %rax
	movq	%rax, 488(%rsp)
	movq	.LC4(%rip), %rax
	movq	%rax, 560(%rsp)
	movq	.LC5(%rip), %rax
	movq	%rax, 576(%rsp)
	movl	$24, 776(%rsp)
	movl	$148, %ecx
	movq	%rbx, %rdi
	movq	%rbp, %rsi
	rep movsq
	movq	%rbx, %rax
	addq	$1256, %rsp
	popq	%rbx
	popq	%rbp
	ret
	.size	standard, .-standard
	.type	release, @function
release:
	pushq	%rbx
	movq	%rdi, %rbx
	movq	-8(%rsi), %rdi
	call	free@PLT
	subl	$1, (%rbx)
	popq	%rbx
	ret
	.size	release, .-release
	.type	take, @function
take:
	pushq	%rbp
	pushq	%rbx
	subq	$8, %rsp
	movq	%rdi, %rbp
	movq	%rdx, %rbx
	leaq	8(%rdx,%rsi), %rdi
	call	malloc@PLT
	movq	%rax, %rsi
	testq	%rax, %rax
	je	.L9
	leaq	8(%rax), %rcx
	movq	%rcx, %rax
	movl	$0, %edx
	divq	%rbx
	movq	%rbx, %rax
	subq	%rdx, %rax
	movl	$0, %edx
	divq	%rbx
	leaq	(%rcx,%rdx), %rax
	movq	%rsi, -8(%rax)
	addl	$1, 0(%rbp)
.L9:
	addq	$8, %rsp
	popq	%rbx
	popq	%rbp
	ret
	.size	take, .-take
	.section	.rodata.str1.1,"aMS",@progbits,1
.LC7:
	.string	"%s"
.LC8:
	.string	" %.17g"
	.text
	.type	show, @function
show:
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$8, %rsp
	movq	%rsi, %r12
	movq	%rdx, %rbp
	movq	%rdi, %rsi
	leaq	.LC7(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	testq	%rbp, %rbp
	jle	.L14
	movl	$0, %ebx
	leaq	.LC8(%rip), %r13
.L15:
	movsd	(%r12,%rbx,8), %xmm0
	movq	%r13, %rdi
	movl	$1, %eax
	call	printf@PLT
	addq	$1, %rbx
	cmpq	%rbx, %rbp
	jne	.L15
.L14:
	movl	$10, %edi
	call	putchar@PLT
	addq	$8, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	ret
	.size	show, .-show
	.section	.rodata.str1.8,"aMS",@progbits,1
	.align 8
.LC9:
	.string	"patches %d strips %d iterations %d\n"
	.section	.rodata.str1.1
.LC10:
	.string	"solution->ellipse.a"
.LC11:
	.string	"*solution.normal_force"
	.text
	.type	show_solution, @function
show_solution:
	pushq	%rbx
	movq	%rdi, %rbx
	movl	8(%rdi), %ecx
	movl	4(%rdi), %edx
	movl	(%rdi), %esi
	leaq	.LC9(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	leaq	16(%rbx), %rsi
	movl	$5, %edx
	leaq	.LC10(%rip), %rdi
	call	show
	leaq	80(%rbx), %rsi
	movl	$10, %edx
	leaq	.LC11(%rip), %rdi
	call	show
	popq	%rbx
	ret
	.size	show_solution, .-show_solution
	.section	.rodata.str1.1
.LC12:
	.string	"*each[i].stress"
	.text
	.type	show_peaks, @function
show_peaks:
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$32, %rsp
	movq	%rdi, (%rsp)
	leaq	48(%rdi), %rax
	movq	%rax, 8(%rsp)
	addq	$96, %rdi
	movq	%rdi, 16(%rsp)
	movq	%rsp, %rbx
	leaq	24(%rsp), %r12
	leaq	.LC12(%rip), %rbp
.L21:
	movq	(%rbx), %rsi
	movl	$4, %edx
	movq	%rbp, %rdi
	call	show
	addq	$8, %rbx
	cmpq	%r12, %rbx
	jne	.L21
	addq	$32, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	ret
	.size	show_peaks, .-show_peaks
	.type	wrc_friction_default, @function
wrc_friction_default:
	pushq	%rbx
	subq	$240, %rsp
	movq	%rdi, %rbx
	movq	%rsp, %rdx
	movl	$30, %ecx
	movl	$0, %eax
	movq	%rdx, %rdi
	rep stosq
	movq	%rdx, %rdi
	call	wrc_friction_init@PLT
	movdqa	(%rsp), %xmm0
	movups	%xmm0, (%rbx)
	movdqa	16(%rsp), %xmm1
	movups	%xmm1, 16(%rbx)
	movdqa	32(%rsp), %xmm2
	movups	%xmm2, 32(%rbx)
	movdqa	48(%rsp), %xmm3
	movups	%xmm3, 48(%rbx)
	movdqa	64(%rsp), %xmm4
	movups	%xmm4, 64(%rbx)
	movdqa	80(%rsp), %xmm5
	movups	%xmm5, 80(%rbx)
	movdqa	96(%rsp), %xmm6
	movups	%xmm6, 96(%rbx)
	movdqa	112(%rsp), %xmm7
	movups	%xmm7, 112(%rbx)
	movdqa	128(%rsp), %xmm0
	movups	%xmm0, 128(%rbx)
	movdqa	144(%rsp), %xmm1
	movups	%xmm1, 144(%rbx)
	movdqa	160(%rsp), %xmm2
	movups	%xmm2, 160(%rbx)
	movdqa	176(%rsp), %xmm3
	movups	%xmm3, 176(%rbx)
	movdqa	192(%rsp), %xmm4
	movups	%xmm4, 192(%rbx)
	movdqa	208(%rsp), %xmm5
	movups	%xmm5, 208(%rbx)
	movdqa	224(%rsp), %xmm6
	movups	%xmm6, 224(%rbx)
	movq	%rbx, %rax
	addq	$240, %rsp
	popq	%rbx
	ret
	.size	wrc_friction_default, .-wrc_friction_default
	.section	.rodata.str1.1
.LC13:
	.string	"("
.LC14:
	.string	"%.*s %d\n"
.LC15:
	.string	"%s: %s: %s\n"
	.text
	.type	done, @function
done:
	pushq	%rbp
	pushq	%rbx
	subq	$8, %rsp
	movl	%edi, %ebp
	movq	%rsi, %rbx
	leaq	.LC13(%rip), %rsi
	movq	%rbx, %rdi
	call	strcspn@PLT
	movl	%ebp, %ecx
	movq	%rbx, %rdx
	movl	%eax, %esi
	leaq	.LC14(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	testl	%ebp, %ebp
	js	.L31
	addq	$8, %rsp
	popq	%rbx
	popq	%rbp
	ret
.L31:
	cmpb	$0, text(%rip)
	jne	.L28
	movq	spoken(%rip), %rdi
	testq	%rdi, %rdi
	je	.L28
	movl	$400, %edx
	leaq	text(%rip), %rsi
	call	wrc_contact_last_error@PLT
.L28:
	movl	%ebp, %edi
	call	wrc_status_name@PLT
	movq	%rax, %rcx
	leaq	text(%rip), %r8
	movq	%rbx, %rdx
	leaq	.LC15(%rip), %rsi
	movq	stderr@GOTPCREL(%rip), %rax
	movq	(%rax), %rdi
	movl	$0, %eax
	call	fprintf@PLT
	movl	$1, %edi
	call	exit@PLT
	.size	done, .-done
	.section	.rodata.str1.8
	.align 8
.LC16:
	.string	"wrc_config_check(config, text, sizeof text)"
	.align 8
.LC17:
	.string	"wrc_model_create(config, &allocator, &model, text, sizeof text)"
	.text
	.type	model_of, @function
model_of:
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$64, %rsp
	movq	%rdi, %rbx
	leaq	16(%rsp), %rbp
	movq	%rbp, %rdi
	call	counted
	movq	$0, 8(%rsp)
	movl	$400, %edx
	leaq	text(%rip), %r12
	movq	%r12, %rsi
	movq	%rbx, %rdi
	call	wrc_config_check@PLT
	movl	%eax, %edi
	leaq	.LC16(%rip), %rsi
	call	done
	leaq	8(%rsp), %rdx
	movl	$400, %r8d
	movq	%r12, %rcx
	movq	%rbp, %rsi
	movq	%rbx, %rdi
	call	wrc_model_create@PLT
	movl	%eax, %edi
	leaq	.LC17(%rip), %rsi
	call	done
	movq	8(%rsp), %rax
	addq	$64, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	ret
	.size	model_of, .-model_of
	.section	.rodata.str1.8
	.align 8
.LC18:
	.string	"wrc_contact_create(model, side, &allocator, &contact, text, sizeof text)"
	.text
	.type	contact_of, @function
contact_of:
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$64, %rsp
	movq	%rdi, %rbx
	movl	%esi, %ebp
	leaq	16(%rsp), %r12
	movq	%r12, %rdi
	call	counted
	movq	$0, 8(%rsp)
	leaq	8(%rsp), %rcx
	movl	$400, %r9d
	leaq	text(%rip), %r8
	movq	%r12, %rdx
	movl	%ebp, %esi
	movq	%rbx, %rdi
	call	wrc_contact_create@PLT
	movl	%eax, %edi
	leaq	.LC18(%rip), %rsi
	call	done
	movq	8(%rsp), %rax
	addq	$64, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	ret
	.size	contact_of, .-contact_of
	.section	.rodata.str1.8
	.align 8
.LC20:
	.string	"wrc_contact_region(contact, i, &region)"
	.align 8
.LC21:
	.string	"strips %d cells %d surface %d available %u\n"
	.section	.rodata.str1.1
.LC22:
	.string	"region.point[0]"
.LC23:
	.string	"region.creepage.longitudinal"
.LC24:
	.string	"region.ellipse.a"
.LC25:
	.string	"region.area"
	.section	.rodata.str1.8
	.align 8
.LC26:
	.string	"wrc_contact_field(contact, i, field, values, sizeof values / sizeof values[0], counts)"
	.section	.rodata.str1.1
.LC27:
	.string	"sum"
	.section	.rodata.str1.8
	.align 8
.LC28:
	.string	"wrc_contact_damage(contact, i, &damage)"
	.section	.rodata.str1.1
.LC29:
	.string	"damage.power"
	.text
	.type	show_regions, @function
show_regions:
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$584, %rsp
	movq	%rsi, 8(%rsp)
	cmpl	$0, 8(%rsi)
	jle	.L36
	movq	%rdi, %rbp
	movl	$0, %r12d
	jmp	.L41
.L38:
	leaq	24(%rsp), %rsi
	movl	$1, %edx
	leaq	.LC27(%rip), %rdi
	call	show
	addl	$1, %ebx
	cmpl	$20, %ebx
	je	.L46
.L40:
	movq	$0x000000000, 24(%rsp)
	movb	$0, text(%rip)
	movq	%rbp, spoken(%rip)
	movq	%r15, %r9
	movl	$12800, %r8d
	movq	%r14, %rcx
	movl	%ebx, %edx
	movl	%r12d, %esi
	movq	%rbp, %rdi
	call	wrc_contact_field@PLT
	movl	%eax, %edi
	movq	%r13, %rsi
	call	done
	movq	32(%rsp), %rdx
	imulq	40(%rsp), %rdx
	testq	%rdx, %rdx
	je	.L38
	leaq	values.16(%rip), %rax
	leaq	(%rax,%rdx,8), %rdx
	pxor	%xmm0, %xmm0
.L39:
	addsd	(%rax), %xmm0
	addq	$8, %rax
	cmpq	%rdx, %rax
	jne	.L39
	movsd	%xmm0, 24(%rsp)
	jmp	.L38
.L46:
	movb	$0, text(%rip)
	movq	%rbp, spoken(%rip)
	leaq	32(%rsp), %rbx
	movq	%rbx, %rdx
	movl	%r12d, %esi
	movq	%rbp, %rdi
	call	wrc_contact_damage@PLT
	movl	%eax, %edi
	leaq	.LC28(%rip), %rsi
	call	done
	movl	$9, %edx
	movq	%rbx, %rsi
	leaq	.LC29(%rip), %rdi
	call	show
	addl	$1, %r12d
	movq	8(%rsp), %rax
	cmpl	%r12d, 8(%rax)
	jle	.L36
.L41:
	leaq	160(%rsp), %rdi
	movl	$51, %ecx
	movl	$0, %eax
	rep stosq
	movl	$408, 160(%rsp)
	movb	$0, text(%rip)
	movq	%rbp, spoken(%rip)
	leaq	160(%rsp), %rdx
	movl	%r12d, %esi
	movq	%rbp, %rdi
	call	wrc_contact_region@PLT
	movl	%eax, %edi
	leaq	.LC20(%rip), %rsi
	call	done
	movl	164(%rsp), %r8d
	movl	176(%rsp), %ecx
	movl	172(%rsp), %edx
	movl	168(%rsp), %esi
	leaq	.LC21(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	leaq	184(%rsp), %rsi
	movl	$22, %edx
	leaq	.LC22(%rip), %rdi
	call	show
	leaq	360(%rsp), %rsi
	movl	$6, %edx
	leaq	.LC23(%rip), %rdi
	call	show
	leaq	440(%rsp), %rsi
	movl	$5, %edx
	leaq	.LC24(%rip), %rdi
	call	show
	leaq	504(%rsp), %rsi
	movl	$8, %edx
	leaq	.LC25(%rip), %rdi
	call	show
	movl	$0, %ebx
	leaq	32(%rsp), %r15
	leaq	values.16(%rip), %r14
	leaq	.LC26(%rip), %r13
	jmp	.L40
.L36:
	addq	$584, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	ret
	.size	show_regions, .-show_regions
	.section	.rodata.str1.8
	.align 8
.LC30:
	.string	"wrc_model_size(config, &bytes, &alignment)"
	.align 8
.LC31:
	.string	"wrc_model_init(config, for_model, bytes, &model, text, sizeof text)"
	.align 8
.LC32:
	.string	"wrc_contact_size(model, &bytes, &alignment)"
	.align 8
.LC33:
	.string	"wrc_contact_init(model, WRC_SIDE_RIGHT, for_contact, bytes, &contact, text, sizeof text)"
	.align 8
.LC34:
	.string	"wrc_contact_wrench(contact, input, &wrench)"
	.section	.rodata.str1.1
.LC35:
	.string	"wrench.force[0]"
	.text
	.type	in_own_memory, @function
in_own_memory:
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$248, %rsp
	movq	%rdi, %r12
	movq	%rsi, 8(%rsp)
	movl	$0, 220(%rsp)
	movq	$0, 208(%rsp)
	movq	$0, 200(%rsp)
	leaq	224(%rsp), %r14
	leaq	232(%rsp), %r13
	movq	%r14, %rdx
	movq	%r13, %rsi
	call	wrc_model_size@PLT
	movl	%eax, %edi
	leaq	.LC30(%rip), %rsi
	call	done
	movq	232(%rsp), %r15
	leaq	220(%rsp), %rbx
	movq	224(%rsp), %rdx
	movq	%r15, %rsi
	movq	%rbx, %rdi
	call	take
	movq	%rax, %rbp
	leaq	208(%rsp), %rcx
	movl	$400, %r9d
	leaq	text(%rip), %r8
	movq	%r15, %rdx
	movq	%rax, %rsi
	movq	%r12, %rdi
	call	wrc_model_init@PLT
	movl	%eax, %edi
	leaq	.LC31(%rip), %rsi
	call	done
	movq	%r14, %rdx
	movq	%r13, %rsi
	movq	208(%rsp), %rdi
	call	wrc_contact_size@PLT
	movl	%eax, %edi
	leaq	.LC32(%rip), %rsi
	call	done
	movq	232(%rsp), %r13
	movq	224(%rsp), %rdx
	movq	%r13, %rsi
	movq	%rbx, %rdi
	call	take
	movq	%rax, %r12
	subq	$8, %rsp
	pushq	$400
	leaq	text(%rip), %r9
	leaq	216(%rsp), %r8
	movq	%r13, %rcx
	movq	%rax, %rdx
	movl	$0, %esi
	movq	224(%rsp), %rdi
	call	wrc_contact_init@PLT
	movl	%eax, %edi
	leaq	.LC33(%rip), %rsi
	call	done
	movq	$0, 36(%rsp)
	movq	$0, 208(%rsp)
	leaq	40(%rsp), %rdi
	movl	$22, %ecx
	movl	$0, %eax
	rep stosq
	movl	$184, 32(%rsp)
	movb	$0, text(%rip)
	movq	216(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	leaq	32(%rsp), %rdx
	movq	24(%rsp), %rsi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC34(%rip), %rsi
	call	done
	leaq	48(%rsp), %rsi
	movl	$19, %edx
	leaq	.LC35(%rip), %rdi
	call	show
	movq	%r12, %rsi
	movq	%rbx, %rdi
	call	release
	movq	%rbp, %rsi
	movq	%rbx, %rdi
	call	release
	addq	$264, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	ret
	.size	in_own_memory, .-in_own_memory
	.type	wrench_of, @function
wrench_of:
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$192, %rsp
	movq	%rsi, %r12
	call	model_of
	movq	%rax, %rbp
	movl	$0, %esi
	movq	%rax, %rdi
	call	contact_of
	movq	%rax, %rbx
	movq	$0, 4(%rsp)
	movq	$0, 176(%rsp)
	leaq	8(%rsp), %rdi
	movl	$22, %ecx
	movl	$0, %eax
	rep stosq
	movl	$184, (%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%rsp, %rdx
	movq	%r12, %rsi
	movq	%rbx, %rdi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC34(%rip), %rsi
	call	done
	leaq	16(%rsp), %rsi
	movl	$19, %edx
	leaq	.LC35(%rip), %rdi
	call	show
	movq	%rbx, %rdi
	call	wrc_contact_destroy@PLT
	movq	%rbp, %rdi
	call	wrc_model_destroy@PLT
	addq	$192, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	ret
	.size	wrench_of, .-wrench_of
	.type	wrc_planar_input_default, @function
wrc_planar_input_default:
	pushq	%rbp
	pushq	%rbx
	subq	$472, %rsp
	movq	%rdi, %rbp
	movq	%rsp, %rbx
	movl	$57, %ecx
	movl	$0, %eax
	movq	%rbx, %rdi
	rep stosq
	movl	$456, (%rsp)
	movq	%rbx, %rdi
	call	wrc_planar_input_init@PLT
	movl	$57, %ecx
	movq	%rbp, %rdi
	movq	%rbx, %rsi
	rep movsq
	movq	%rbp, %rax
	addq	$472, %rsp
	popq	%rbx
	popq	%rbp
	ret
	.size	wrc_planar_input_default, .-wrc_planar_input_default
	.section	.rodata.str1.1
.LC36:
	.string	"FASTSIM-SDEC"
	.section	.rodata.str1.8
	.align 8
.LC37:
	.string	"wrc_config_use(&config, \"FASTSIM-SDEC\", text, sizeof text)"
	.align 8
.LC39:
	.string	"wrc_planar_geometry(contact, &pose, &point)"
	.section	.rodata.str1.1
.LC40:
	.string	"point.x"
	.section	.rodata.str1.8
	.align 8
.LC44:
	.string	"wrc_planar_creepages(contact, &motion, &creepage)"
	.section	.rodata.str1.1
.LC45:
	.string	"creepage.longitudinal"
	.section	.rodata.str1.8
	.align 8
.LC47:
	.string	"wrc_planar_normal(contact, NULL, &load, &solution)"
	.align 8
.LC48:
	.string	"wrc_planar_regularise(contact, NULL, &solution)"
	.align 8
.LC49:
	.string	"wrc_planar_tangential(contact, NULL, &creepage, &friction, &forces)"
	.section	.rodata.str1.1
.LC50:
	.string	"forces.fx"
	.section	.rodata.str1.8
	.align 8
.LC51:
	.string	"wrc_planar_tangential_derivatives(contact, &derivatives)"
	.section	.rodata.str1.1
.LC52:
	.string	"derivatives.forces[0][0]"
	.section	.rodata.str1.8
	.align 8
.LC53:
	.string	"wrc_planar_step(contact, &input, &output)"
	.section	.rodata.str1.1
.LC54:
	.string	"output.point.x"
.LC55:
	.string	"output.forces.fx"
.LC56:
	.string	"output.damage.power"
	.text
	.type	posed, @function
posed:
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$3288, %rsp
	leaq	2096(%rsp), %rbx
	movq	%rbx, %rdi
	call	standard
	movl	$40, 2928(%rsp)
	movl	$400, %ecx
	leaq	text(%rip), %rdx
	leaq	.LC36(%rip), %rsi
	movq	%rbx, %rdi
	call	wrc_config_use@PLT
	movl	%eax, %edi
	leaq	.LC37(%rip), %rsi
	call	done
	movq	%rbx, %rdi
	call	model_of
	movq	%rax, %rbp
	movl	$1, %esi
	movq	%rax, %rdi
	call	contact_of
	movq	%rax, %rbx
	leaq	2048(%rsp), %rsi
	pxor	%xmm0, %xmm0
	movups	%xmm0, 2056(%rsp)
	movups	%xmm0, 2072(%rsp)
	movq	$0, 2088(%rsp)
	movq	.LC38(%rip), %rax
	movq	%rax, 2048(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	1952(%rsp), %r12
	movq	%r12, %rdx
	movq	%rbx, %rdi
	call	wrc_planar_geometry@PLT
	movl	%eax, %edi
	leaq	.LC39(%rip), %rsi
	call	done
	movl	$8, %edx
	movq	%r12, %rsi
	leaq	.LC40(%rip), %rdi
	call	show
	leaq	1872(%rsp), %rsi
	pxor	%xmm0, %xmm0
	movaps	%xmm0, 1888(%rsp)
	movaps	%xmm0, 1904(%rsp)
	movaps	%xmm0, 1920(%rsp)
	movaps	%xmm0, 1936(%rsp)
	movq	.LC41(%rip), %rax
	movq	%rax, 1872(%rsp)
	movq	.LC42(%rip), %rax
	movq	%rax, 1912(%rsp)
	movq	.LC43(%rip), %rax
	movq	%rax, 1880(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	1792(%rsp), %r13
	movq	%r13, %rdx
	movq	%rbx, %rdi
	call	wrc_planar_creepages@PLT
	movl	%eax, %edi
	leaq	.LC44(%rip), %rsi
	call	done
	movl	$6, %edx
	movq	%r13, %rsi
	leaq	.LC45(%rip), %rdi
	call	show
	movq	%rsp, %r14
	pxor	%xmm0, %xmm0
	movaps	%xmm0, (%rsp)
	movaps	%xmm0, 16(%rsp)
	movaps	%xmm0, 32(%rsp)
	movaps	%xmm0, 48(%rsp)
	movq	$0, 64(%rsp)
	movq	%r14, %rdi
	call	wrc_planar_load_init@PLT
	movdqa	(%rsp), %xmm1
	movaps	%xmm1, 1712(%rsp)
	movdqa	16(%rsp), %xmm2
	movaps	%xmm2, 1728(%rsp)
	movdqa	32(%rsp), %xmm3
	movaps	%xmm3, 1744(%rsp)
	movdqa	48(%rsp), %xmm4
	movaps	%xmm4, 1760(%rsp)
	movq	64(%rsp), %rax
	movq	%rax, 1776(%rsp)
	movq	.LC46(%rip), %rax
	movq	%rax, 1720(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	1520(%rsp), %r12
	leaq	1712(%rsp), %rdx
	movq	%r12, %rcx
	movl	$0, %esi
	movq	%rbx, %rdi
	call	wrc_planar_normal@PLT
	movl	%eax, %edi
	leaq	.LC47(%rip), %rsi
	call	done
	movq	%r12, %rdi
	call	show_solution
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%r12, %rdx
	movl	$0, %esi
	movq	%rbx, %rdi
	call	wrc_planar_regularise@PLT
	movl	%eax, %edi
	leaq	.LC48(%rip), %rsi
	call	done
	movq	%r12, %rdi
	call	show_solution
	leaq	1280(%rsp), %r15
	movq	%r15, %rdi
	call	wrc_friction_default
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	1184(%rsp), %r12
	movq	%r12, %r8
	movq	%r15, %rcx
	movq	%r13, %rdx
	movl	$0, %esi
	movq	%rbx, %rdi
	call	wrc_planar_tangential@PLT
	movl	%eax, %edi
	leaq	.LC49(%rip), %rsi
	call	done
	movl	$6, %edx
	movq	%r12, %rsi
	leaq	.LC50(%rip), %rdi
	call	show
	movl	$0, %r13d
	movq	$0, 4(%rsp)
	leaq	208(%rsp), %r12
	movq	$0, 192(%rsp)
	leaq	8(%rsp), %rdi
	movl	$24, %ecx
	movq	%r13, %rax
	rep stosq
	movl	$200, (%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%r14, %rsi
	movq	%rbx, %rdi
	call	wrc_planar_tangential_derivatives@PLT
	movl	%eax, %edi
	leaq	.LC51(%rip), %rsi
	call	done
	leaq	8(%rsp), %rsi
	movl	$24, %edx
	leaq	.LC52(%rip), %rdi
	call	show
	leaq	720(%rsp), %r14
	movq	%r14, %rdi
	call	wrc_planar_input_default
	movl	$64, %ecx
	movq	%r12, %rdi
	movq	%r13, %rax
	rep stosq
	movl	$512, 208(%rsp)
	movdqa	2048(%rsp), %xmm5
	movups	%xmm5, 728(%rsp)
	movdqa	2064(%rsp), %xmm6
	movups	%xmm6, 744(%rsp)
	movdqa	2080(%rsp), %xmm7
	movups	%xmm7, 760(%rsp)
	movdqa	1712(%rsp), %xmm1
	movaps	%xmm1, 784(%rsp)
	movdqa	1728(%rsp), %xmm2
	movaps	%xmm2, 800(%rsp)
	movdqa	1744(%rsp), %xmm3
	movaps	%xmm3, 816(%rsp)
	movdqa	1760(%rsp), %xmm4
	movaps	%xmm4, 832(%rsp)
	movq	1776(%rsp), %rax
	movq	%rax, 848(%rsp)
	movdqa	1792(%rsp), %xmm5
	movups	%xmm5, 856(%rsp)
	movdqa	1808(%rsp), %xmm6
	movups	%xmm6, 872(%rsp)
	movdqa	1824(%rsp), %xmm7
	movups	%xmm7, 888(%rsp)
	movdqa	1840(%rsp), %xmm1
	movups	%xmm1, 904(%rsp)
	movdqa	1856(%rsp), %xmm2
	movups	%xmm2, 920(%rsp)
	movdqa	1280(%rsp), %xmm3
	movups	%xmm3, 936(%rsp)
	movdqa	1296(%rsp), %xmm4
	movups	%xmm4, 952(%rsp)
	movdqa	1312(%rsp), %xmm5
	movups	%xmm5, 968(%rsp)
	movdqa	1328(%rsp), %xmm6
	movups	%xmm6, 984(%rsp)
	movdqa	1344(%rsp), %xmm7
	movups	%xmm7, 1000(%rsp)
	movdqa	1360(%rsp), %xmm1
	movups	%xmm1, 1016(%rsp)
	movdqa	1376(%rsp), %xmm2
	movups	%xmm2, 1032(%rsp)
	movdqa	1392(%rsp), %xmm3
	movups	%xmm3, 1048(%rsp)
	movdqa	1408(%rsp), %xmm4
	movups	%xmm4, 1064(%rsp)
	movdqa	1424(%rsp), %xmm5
	movups	%xmm5, 1080(%rsp)
	movdqa	1440(%rsp), %xmm6
	movups	%xmm6, 1096(%rsp)
	movdqa	1456(%rsp), %xmm7
	movups	%xmm7, 1112(%rsp)
	movdqa	1472(%rsp), %xmm1
	movups	%xmm1, 1128(%rsp)
	movdqa	1488(%rsp), %xmm2
	movups	%xmm2, 1144(%rsp)
	movdqa	1504(%rsp), %xmm3
	movups	%xmm3, 1160(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%r12, %rdx
	movq	%r14, %rsi
	movq	%rbx, %rdi
	call	wrc_planar_step@PLT
	movl	%eax, %edi
	leaq	.LC53(%rip), %rsi
	call	done
	leaq	216(%rsp), %rsi
	movl	$8, %edx
	leaq	.LC54(%rip), %rdi
	call	show
	leaq	312(%rsp), %rdi
	call	show_solution
	leaq	504(%rsp), %rsi
	movl	$6, %edx
	leaq	.LC55(%rip), %rdi
	call	show
	leaq	592(%rsp), %rsi
	movl	$9, %edx
	leaq	.LC56(%rip), %rdi
	call	show
	movq	%rbx, %rdi
	call	wrc_contact_destroy@PLT
	movq	%rbp, %rdi
	call	wrc_model_destroy@PLT
	addq	$3288, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	ret
	.size	posed, .-posed
	.section	.rodata.str1.8
	.align 8
.LC64:
	.string	"wrc_planar_roll(contact, 2e-3)"
	.align 8
.LC65:
	.string	"wrc_planar_normal(contact, &gap, &input.load, &solution)"
	.align 8
.LC66:
	.string	"wrc_planar_regularise(contact, &strips, &solution)"
	.section	.rodata.str1.1
.LC71:
	.string	"wrc_planar_roll(contact, 1.0)"
	.section	.rodata.str1.8
	.align 8
.LC72:
	.string	"wrc_planar_tangential(contact, &ellipse, &creepage, &input.friction, &forces)"
	.align 8
.LC73:
	.string	"wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage)"
	.text
	.type	given, @function
given:
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$4992, %rsp
	leaq	3808(%rsp), %rbx
	movq	%rbx, %rdi
	call	wrc_config_default
	movl	$1, 4668(%rsp)
	movq	%rbx, %rdi
	call	model_of
	movq	%rax, %rbp
	movl	$0, %esi
	movq	%rax, %rdi
	call	contact_of
	movq	%rax, %rbx
	movl	$0, %eax
	movsd	.LC57(%rip), %xmm2
	movsd	.LC58(%rip), %xmm6
	movsd	.LC59(%rip), %xmm5
	movsd	.LC60(%rip), %xmm4
	movsd	.LC61(%rip), %xmm3
.L56:
	leal	-20(%rax), %edx
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%edx, %xmm0
	mulsd	%xmm2, %xmm0
	movsd	%xmm0, 3472(%rsp,%rax,8)
	movapd	%xmm0, %xmm1
	addsd	%xmm0, %xmm1
	mulsd	%xmm0, %xmm1
	movsd	%xmm1, 3136(%rsp,%rax,8)
	movsd	%xmm6, 2800(%rsp,%rax,8)
	movapd	%xmm0, %xmm1
	mulsd	%xmm5, %xmm1
	mulsd	%xmm0, %xmm1
	movapd	%xmm4, %xmm0
	subsd	%xmm1, %xmm0
	movsd	%xmm0, 2464(%rsp,%rax,8)
	movsd	%xmm2, 2128(%rsp,%rax,8)
	mulsd	%xmm3, %xmm0
	movsd	%xmm0, 1792(%rsp,%rax,8)
	addq	$1, %rax
	cmpq	$41, %rax
	jne	.L56
	leaq	1696(%rsp), %r13
	movl	$0, %r14d
	movq	$0, 1700(%rsp)
	movq	$0, 1784(%rsp)
	leaq	1704(%rsp), %rdi
	movl	$11, %ecx
	movq	%r14, %rax
	rep stosq
	movl	$41, 1696(%rsp)
	leaq	3472(%rsp), %rax
	movq	%rax, 1704(%rsp)
	leaq	3136(%rsp), %rax
	movq	%rax, 1712(%rsp)
	leaq	2800(%rsp), %rax
	movq	%rax, 1728(%rsp)
	leaq	1232(%rsp), %r12
	movq	%r12, %rdi
	call	wrc_planar_input_default
	leaq	720(%rsp), %rdi
	movl	$64, %ecx
	movq	%r14, %rax
	rep stosq
	movl	$512, 720(%rsp)
	movq	%r13, 1288(%rsp)
	movl	$3, 1296(%rsp)
	movq	.LC62(%rip), %rax
	movq	%rax, 1312(%rsp)
	movq	%rsp, %rdi
	pxor	%xmm7, %xmm7
	movaps	%xmm7, (%rsp)
	movaps	%xmm7, 16(%rsp)
	movaps	%xmm7, 32(%rsp)
	movaps	%xmm7, 48(%rsp)
	movaps	%xmm7, 64(%rsp)
	call	wrc_creepage_init@PLT
	movdqa	(%rsp), %xmm3
	movaps	%xmm3, 640(%rsp)
	movq	16(%rsp), %r10
	movq	24(%rsp), %r11
	movq	%r10, 656(%rsp)
	movq	%r11, 664(%rsp)
	movq	32(%rsp), %r8
	movq	40(%rsp), %r9
	movq	%r8, 672(%rsp)
	movq	%r9, 680(%rsp)
	movq	48(%rsp), %rsi
	movq	56(%rsp), %rdi
	movq	%rsi, 688(%rsp)
	movq	%rdi, 696(%rsp)
	movq	64(%rsp), %rax
	movq	72(%rsp), %rdx
	movq	%rax, 704(%rsp)
	movq	%rdx, 712(%rsp)
	movq	.LC63(%rip), %rcx
	movq	%rcx, 648(%rsp)
	movdqa	640(%rsp), %xmm4
	movups	%xmm4, 1368(%rsp)
	movq	%r10, 1384(%rsp)
	movq	%r11, 1392(%rsp)
	movq	%r8, 1400(%rsp)
	movq	%r9, 1408(%rsp)
	movq	%rsi, 1416(%rsp)
	movq	%rdi, 1424(%rsp)
	movq	%rax, 1432(%rsp)
	movq	%rdx, 1440(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movsd	.LC38(%rip), %xmm0
	movq	%rbx, %rdi
	call	wrc_planar_roll@PLT
	movl	%eax, %edi
	leaq	.LC64(%rip), %rsi
	call	done
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	720(%rsp), %rdx
	movq	%r12, %rsi
	movq	%rbx, %rdi
	call	wrc_planar_step@PLT
	movl	%eax, %edi
	leaq	.LC53(%rip), %rsi
	call	done
	leaq	824(%rsp), %rdi
	call	show_solution
	leaq	1016(%rsp), %rsi
	movl	$6, %edx
	leaq	.LC55(%rip), %rdi
	call	show
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	448(%rsp), %r12
	leaq	1296(%rsp), %rdx
	movq	%r12, %rcx
	movq	%r13, %rsi
	movq	%rbx, %rdi
	call	wrc_planar_normal@PLT
	movl	%eax, %edi
	leaq	.LC65(%rip), %rsi
	call	done
	movq	%r12, %rdi
	call	show_solution
	leaq	368(%rsp), %rsi
	pxor	%xmm7, %xmm7
	movups	%xmm7, 372(%rsp)
	movups	%xmm7, 388(%rsp)
	movups	%xmm7, 404(%rsp)
	movups	%xmm7, 420(%rsp)
	movups	%xmm7, 432(%rsp)
	movl	$21, 368(%rsp)
	leaq	3552(%rsp), %rax
	movq	%rax, 376(%rsp)
	leaq	2208(%rsp), %rax
	movq	%rax, 384(%rsp)
	leaq	2544(%rsp), %rax
	movq	%rax, 400(%rsp)
	leaq	1872(%rsp), %rax
	movq	%rax, 408(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%r12, %rdx
	movq	%rbx, %rdi
	call	wrc_planar_regularise@PLT
	movl	%eax, %edi
	leaq	.LC66(%rip), %rsi
	call	done
	movq	%r12, %rdi
	call	show_solution
	leaq	304(%rsp), %r13
	pxor	%xmm7, %xmm7
	movups	%xmm7, 328(%rsp)
	movups	%xmm7, 344(%rsp)
	movq	$0, 360(%rsp)
	movq	.LC60(%rip), %rax
	movq	%rax, 304(%rsp)
	movq	.LC67(%rip), %rax
	movq	%rax, 312(%rsp)
	movq	.LC68(%rip), %rax
	movq	%rax, 320(%rsp)
	movq	.LC69(%rip), %rax
	movq	%rax, 336(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movsd	.LC70(%rip), %xmm0
	movq	%rbx, %rdi
	call	wrc_planar_roll@PLT
	movl	%eax, %edi
	leaq	.LC71(%rip), %rsi
	call	done
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	208(%rsp), %r12
	leaq	1448(%rsp), %rcx
	leaq	640(%rsp), %rdx
	movq	%r12, %r8
	movq	%r13, %rsi
	movq	%rbx, %rdi
	call	wrc_planar_tangential@PLT
	movl	%eax, %edi
	leaq	.LC72(%rip), %rsi
	call	done
	movl	$6, %edx
	movq	%r12, %rsi
	leaq	.LC50(%rip), %rdi
	call	show
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	80(%rsp), %r12
	movq	%r12, %rdx
	movl	$-1, %esi
	movq	%rbx, %rdi
	call	wrc_contact_damage@PLT
	movl	%eax, %edi
	leaq	.LC73(%rip), %rsi
	call	done
	movl	$9, %edx
	movq	%r12, %rsi
	leaq	.LC29(%rip), %rdi
	call	show
	movq	%rbx, %rdi
	call	wrc_contact_destroy@PLT
	movq	%rbp, %rdi
	call	wrc_model_destroy@PLT
	addq	$4992, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	popq	%r14
	ret
	.size	given, .-given
	.type	wrc_wear_laws_default, @function
wrc_wear_laws_default:
	pushq	%rbx
	subq	$192, %rsp
	movq	%rdi, %rbx
	movq	%rsp, %rdx
	movq	$0, 4(%rsp)
	movq	$0, 176(%rsp)
	leaq	8(%rsp), %rdi
	movl	$22, %ecx
	movl	$0, %eax
	rep stosq
	movl	$184, (%rsp)
	movq	%rdx, %rdi
	call	wrc_wear_laws_init@PLT
	movdqa	(%rsp), %xmm0
	movups	%xmm0, (%rbx)
	movdqa	16(%rsp), %xmm1
	movups	%xmm1, 16(%rbx)
	movdqa	32(%rsp), %xmm2
	movups	%xmm2, 32(%rbx)
	movdqa	48(%rsp), %xmm3
	movups	%xmm3, 48(%rbx)
	movdqa	64(%rsp), %xmm4
	movups	%xmm4, 64(%rbx)
	movdqa	80(%rsp), %xmm5
	movups	%xmm5, 80(%rbx)
	movdqa	96(%rsp), %xmm6
	movups	%xmm6, 96(%rbx)
	movdqa	112(%rsp), %xmm7
	movups	%xmm7, 112(%rbx)
	movdqa	128(%rsp), %xmm0
	movups	%xmm0, 128(%rbx)
	movdqa	144(%rsp), %xmm1
	movups	%xmm1, 144(%rbx)
	movdqa	160(%rsp), %xmm2
	movups	%xmm2, 160(%rbx)
	movq	176(%rsp), %rax
	movq	%rax, 176(%rbx)
	movq	%rbx, %rax
	addq	$192, %rsp
	popq	%rbx
	ret
	.size	wrc_wear_laws_default, .-wrc_wear_laws_default
	.type	rolling, @function
rolling:
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$1928, %rsp
	movq	%rdi, %rbx
	movq	%rsp, %r12
	movl	$0, %r13d
	movl	$90, %ecx
	movq	%r12, %rdi
	movq	%r13, %rax
	rep stosq
	movl	$720, (%rsp)
	movq	%r12, %rdi
	call	wrc_wheel_input_init@PLT
	leaq	1200(%rsp), %rdi
	movl	$90, %ecx
	movq	%r12, %rsi
	rep movsq
	movsd	56(%rsp), %xmm0
	movsd	%xmm0, 1256(%rsp)
	movsd	64(%rsp), %xmm0
	movsd	%xmm0, 1264(%rsp)
	movsd	96(%rsp), %xmm0
	movsd	%xmm0, 1296(%rsp)
	movdqa	1216(%rsp), %xmm3
	movaps	%xmm3, 960(%rsp)
	movdqa	1232(%rsp), %xmm5
	movaps	%xmm5, 976(%rsp)
	movdqa	1248(%rsp), %xmm7
	movaps	%xmm7, 992(%rsp)
	movdqa	1264(%rsp), %xmm3
	movaps	%xmm3, 1008(%rsp)
	movdqa	1280(%rsp), %xmm5
	movaps	%xmm5, 1024(%rsp)
	movdqa	1296(%rsp), %xmm7
	movaps	%xmm7, 1040(%rsp)
	movdqa	1312(%rsp), %xmm1
	movaps	%xmm1, 1056(%rsp)
	movdqa	1328(%rsp), %xmm2
	movaps	%xmm2, 1072(%rsp)
	movdqa	1344(%rsp), %xmm4
	movaps	%xmm4, 1088(%rsp)
	movdqa	1360(%rsp), %xmm6
	movaps	%xmm6, 1104(%rsp)
	movdqa	1376(%rsp), %xmm3
	movaps	%xmm3, 1120(%rsp)
	movdqa	1392(%rsp), %xmm5
	movaps	%xmm5, 1136(%rsp)
	movdqa	1408(%rsp), %xmm7
	movaps	%xmm7, 1152(%rsp)
	movdqa	1424(%rsp), %xmm1
	movaps	%xmm1, 1168(%rsp)
	movdqa	1440(%rsp), %xmm2
	movaps	%xmm2, 1184(%rsp)
	movq	.LC57(%rip), %rbp
	movq	%rbp, 1000(%rsp)
	movq	.LC41(%rip), %rax
	movq	%rax, 1008(%rsp)
	movq	.LC42(%rip), %rax
	movq	%rax, 1040(%rsp)
	movdqa	992(%rsp), %xmm4
	movaps	%xmm4, 1248(%rsp)
	movdqa	1008(%rsp), %xmm6
	movaps	%xmm6, 1264(%rsp)
	movdqa	1040(%rsp), %xmm3
	movaps	%xmm3, 1296(%rsp)
	movl	$30, %ecx
	movq	%r12, %rdi
	movq	%r13, %rax
	rep stosq
	movq	%r12, %rdi
	call	wrc_friction_init@PLT
	movdqa	(%rsp), %xmm5
	movaps	%xmm5, 720(%rsp)
	movq	16(%rsp), %r10
	movq	24(%rsp), %r11
	movq	%r10, 736(%rsp)
	movq	%r11, 744(%rsp)
	movq	32(%rsp), %r8
	movq	40(%rsp), %r9
	movq	%r8, 752(%rsp)
	movq	%r9, 760(%rsp)
	movq	48(%rsp), %rsi
	movq	56(%rsp), %rdi
	movq	%rsi, 768(%rsp)
	movq	%rdi, 776(%rsp)
	movq	64(%rsp), %rax
	movq	72(%rsp), %rdx
	movq	%rax, 784(%rsp)
	movq	%rdx, 792(%rsp)
	movdqa	80(%rsp), %xmm0
	movaps	%xmm0, 800(%rsp)
	movdqa	96(%rsp), %xmm2
	movaps	%xmm2, 816(%rsp)
	movdqa	112(%rsp), %xmm4
	movaps	%xmm4, 832(%rsp)
	movdqa	128(%rsp), %xmm6
	movaps	%xmm6, 848(%rsp)
	movdqa	144(%rsp), %xmm8
	movaps	%xmm8, 864(%rsp)
	movdqa	160(%rsp), %xmm10
	movaps	%xmm10, 880(%rsp)
	movdqa	176(%rsp), %xmm12
	movaps	%xmm12, 896(%rsp)
	movdqa	192(%rsp), %xmm14
	movaps	%xmm14, 912(%rsp)
	movdqa	208(%rsp), %xmm7
	movaps	%xmm7, 928(%rsp)
	movdqa	224(%rsp), %xmm1
	movaps	%xmm1, 944(%rsp)
	movsd	.LC74(%rip), %xmm1
	movsd	%xmm1, 720(%rsp)
	movdqa	720(%rsp), %xmm3
	movaps	%xmm3, 1632(%rsp)
	movq	%r10, 1648(%rsp)
	movq	%r11, 1656(%rsp)
	movq	%r8, 1664(%rsp)
	movq	%r9, 1672(%rsp)
	movq	%rsi, 1680(%rsp)
	movq	%rdi, 1688(%rsp)
	movq	%rax, 1696(%rsp)
	movq	%rdx, 1704(%rsp)
	movaps	%xmm0, 1712(%rsp)
	movaps	%xmm2, 1728(%rsp)
	movaps	%xmm4, 1744(%rsp)
	movaps	%xmm6, 1760(%rsp)
	movaps	%xmm8, 1776(%rsp)
	movaps	%xmm10, 1792(%rsp)
	movaps	%xmm12, 1808(%rsp)
	movaps	%xmm14, 1824(%rsp)
	movaps	%xmm7, 1840(%rsp)
	movdqa	224(%rsp), %xmm4
	movaps	%xmm4, 1856(%rsp)
	movq	%rbp, 1256(%rsp)
	movq	.LC41(%rip), %rax
	movq	%rax, 1264(%rsp)
	movq	.LC42(%rip), %rax
	movq	%rax, 1296(%rsp)
	movq	.LC75(%rip), %rax
	movq	%rax, 1456(%rsp)
	movq	%rbp, 1504(%rsp)
	movq	.LC76(%rip), %rax
	movq	%rax, 1568(%rsp)
	movq	.LC77(%rip), %rax
	movq	%rax, 1576(%rsp)
	movsd	%xmm1, 1632(%rsp)
	leaq	1200(%rsp), %rsi
	movl	$90, %ecx
	movq	%rbx, %rdi
	rep movsq
	movq	%rbx, %rax
	addq	$1928, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	ret
	.size	rolling, .-rolling
	.section	.rodata.str1.8
	.align 8
.LC78:
	.string	"wrc_model_profile(model, WRC_SIDE_LEFT, WRC_BODY_RAIL, &y, &z, &deviation)"
	.section	.rodata.str1.1
.LC79:
	.string	"z.data[y.count / 4]"
	.section	.rodata.str1.8
	.align 8
.LC80:
	.string	"wrc_contact_wrench(contact, &input, &wrench)"
	.align 8
.LC82:
	.string	"wrc_contact_wrench_derivatives(contact, &input, &wrench, &derivatives)"
	.section	.rodata.str1.1
.LC83:
	.string	"derivatives.wrench[0][0]"
	.section	.rodata.str1.8
	.align 8
.LC88:
	.string	"wrc_contact_wrench_batch(contacts, 2, inputs, sizeof inputs[0], wrenches, sizeof wrenches[0], statuses)"
	.section	.rodata.str1.1
.LC89:
	.string	"wrenches[i].force[0]"
.LC90:
	.string	"wrc_contact_mark(contacts[1])"
	.section	.rodata.str1.8
	.align 8
.LC91:
	.string	"wrc_contact_wrench(contacts[1], &inputs[1], &wrenches[1])"
	.section	.rodata.str1.1
.LC92:
	.string	"wrenches[1].force[0]"
	.section	.rodata.str1.8
	.align 8
.LC93:
	.string	"wrc_contact_state_size(model, &bytes)"
	.align 8
.LC94:
	.string	"wrc_contact_portable_size(model, &portable_bytes)"
	.align 8
.LC95:
	.string	"wrc_contact_save(contacts[0], state, bytes)"
	.align 8
.LC96:
	.string	"wrc_contact_save_portable(contacts[0], portable, portable_bytes)"
	.align 8
.LC98:
	.string	"wrc_contact_wrench(contacts[0], &inputs[0], &wrenches[0])"
	.section	.rodata.str1.1
.LC99:
	.string	"wrenches[0].force[0]"
	.section	.rodata.str1.8
	.align 8
.LC100:
	.string	"wrc_contact_restore(contacts[0], state, bytes)"
	.align 8
.LC101:
	.string	"wrc_contact_restore_portable(contacts[0], portable, portable_bytes)"
	.align 8
.LC103:
	.string	"wrc_contact_last_error(contacts[0], text, sizeof text)"
	.text
	.type	wheel_on_a_rail, @function
wheel_on_a_rail:
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$6344, %rsp
	leaq	5152(%rsp), %rbx
	movq	%rbx, %rdi
	call	standard
	movq	%rbx, %rdi
	call	model_of
	movq	%rax, %rbx
	movq	%rax, 8(%rsp)
	movl	$0, %esi
	movq	%rax, %rdi
	call	contact_of
	movq	%rax, 5136(%rsp)
	movl	$1, %esi
	movq	%rbx, %rdi
	call	contact_of
	movq	%rax, 5144(%rsp)
	leaq	5104(%rsp), %rcx
	leaq	5064(%rsp), %r9
	leaq	5072(%rsp), %r8
	movl	$1, %edx
	movl	$1, %esi
	movq	%rbx, %rdi
	call	wrc_model_profile@PLT
	movl	%eax, %edi
	leaq	.LC78(%rip), %rsi
	call	done
	movq	5112(%rsp), %rax
	shrq	$2, %rax
	movq	5072(%rsp), %rdx
	leaq	(%rdx,%rax,8), %rsi
	movl	$1, %edx
	leaq	.LC79(%rip), %rdi
	call	show
	leaq	5136(%rsp), %r12
	leaq	5152(%rsp), %rax
	movq	%rax, (%rsp)
.L64:
	movq	(%r12), %rbx
	leaq	1152(%rsp), %r13
	movq	%r13, %rdi
	call	rolling
	movl	$0, %eax
	movq	$0, 788(%rsp)
	movq	$0, 960(%rsp)
	leaq	792(%rsp), %rdi
	movl	$22, %ecx
	rep stosq
	movl	$184, 784(%rsp)
	leaq	2336(%rsp), %rdi
	movl	$225, %ecx
	rep stosq
	movl	$1800, 2336(%rsp)
	movl	$1, 1156(%rsp)
	movq	.LC46(%rip), %rax
	movq	%rax, 1824(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	784(%rsp), %rbp
	movq	%rbp, %rdx
	movq	%r13, %rsi
	movq	%rbx, %rdi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC80(%rip), %rsi
	call	done
	leaq	800(%rsp), %r15
	movl	$19, %edx
	movq	%r15, %rsi
	leaq	.LC35(%rip), %r14
	movq	%r14, %rdi
	call	show
	movq	%rbp, %rsi
	movq	%rbx, %rdi
	call	show_regions
	movq	.LC81(%rip), %rax
	movq	%rax, 1184(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	leaq	2336(%rsp), %rcx
	movq	%rbp, %rdx
	movq	%r13, %rsi
	movq	%rbx, %rdi
	call	wrc_contact_wrench_derivatives@PLT
	movl	%eax, %edi
	leaq	.LC82(%rip), %rsi
	call	done
	movl	$19, %edx
	movq	%r15, %rsi
	movq	%r14, %rdi
	call	show
	leaq	2344(%rsp), %rsi
	movl	$224, %edx
	leaq	.LC83(%rip), %rdi
	call	show
	movq	%rbp, %rsi
	movq	%rbx, %rdi
	call	show_regions
	movq	.LC84(%rip), %rax
	movq	%rax, 752(%rsp)
	movq	.LC43(%rip), %rax
	movq	%rax, 760(%rsp)
	movq	.LC76(%rip), %rax
	movq	%rax, 768(%rsp)
	movq	.LC85(%rip), %rax
	movq	%rax, 776(%rsp)
	movl	$2, 1720(%rsp)
	leaq	752(%rsp), %rax
	movq	%rax, 1704(%rsp)
	leaq	768(%rsp), %rax
	movq	%rax, 1712(%rsp)
	movl	$1, 1724(%rsp)
	movl	$2, 1592(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%rbp, %rdx
	movq	%r13, %rsi
	movq	%rbx, %rdi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC80(%rip), %rsi
	call	done
	movl	$19, %edx
	movq	%r15, %rsi
	movq	%r14, %rdi
	call	show
	movl	$1, 1596(%rsp)
	movq	.LC86(%rip), %rax
	movq	%rax, 1656(%rsp)
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%rbp, %rdx
	movq	%r13, %rsi
	movq	%rbx, %rdi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC80(%rip), %rsi
	call	done
	movl	$19, %edx
	movq	%r15, %rsi
	movq	%r14, %rdi
	call	show
	addq	$8, %r12
	movq	(%rsp), %rax
	cmpq	%rax, %r12
	jne	.L64
	movl	$46, %ecx
	movl	$0, %eax
	movq	%rbp, %rdi
	rep stosq
	leaq	16(%rsp), %rbx
	movq	%rbx, %rdi
	call	rolling
	leaq	2336(%rsp), %rdi
	movl	$90, %ecx
	movq	%rbx, %rsi
	rep movsq
	movq	.LC87(%rip), %r12
	movq	%r12, 2376(%rsp)
	movq	$0x000000000, 2368(%rsp)
	movl	$1, 2344(%rsp)
	movl	$184, 784(%rsp)
	movq	%rbx, %rdi
	call	rolling
	leaq	3056(%rsp), %rdi
	movl	$90, %ecx
	movq	%rbx, %rsi
	rep movsq
	movq	%r12, 3096(%rsp)
	movq	.LC57(%rip), %rax
	movq	%rax, 3088(%rsp)
	movl	$1, 3064(%rsp)
	movl	$184, 968(%rsp)
	movb	$0, text(%rip)
	movq	5136(%rsp), %rax
	movq	%rax, spoken(%rip)
	leaq	2336(%rsp), %rdx
	leaq	5136(%rsp), %rdi
	subq	$8, %rsp
	leaq	776(%rsp), %rax
	pushq	%rax
	movl	$184, %r9d
	movq	%rbp, %r8
	movl	$720, %ecx
	movl	$2, %esi
	call	wrc_contact_wrench_batch@PLT
	movl	%eax, %edi
	leaq	.LC88(%rip), %rsi
	call	done
	movq	%r15, %rsi
	movl	$19, %edx
	leaq	.LC89(%rip), %rbp
	movq	%rbp, %rdi
	call	show
	leaq	1000(%rsp), %rbx
	movl	$19, %edx
	movq	%rbx, %rsi
	movq	%rbp, %rdi
	call	show
	movb	$0, text(%rip)
	movq	5160(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	call	wrc_contact_mark@PLT
	movl	%eax, %edi
	leaq	.LC90(%rip), %rsi
	call	done
	movl	$2, 3080(%rsp)
	movb	$0, text(%rip)
	movq	5160(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	leaq	984(%rsp), %rdx
	leaq	3072(%rsp), %rsi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC91(%rip), %rsi
	call	done
	movl	$21, %edx
	movq	%rbx, %rsi
	leaq	.LC92(%rip), %rdi
	call	show
	movq	%r13, %rdi
	call	standard
	movq	%r13, %rdi
	call	model_of
	movq	%rax, %rbx
	leaq	760(%rsp), %rsi
	movq	%rax, %rdi
	call	wrc_contact_state_size@PLT
	movl	%eax, %edi
	leaq	.LC93(%rip), %rsi
	call	done
	leaq	768(%rsp), %rsi
	movq	%rbx, %rdi
	call	wrc_contact_portable_size@PLT
	movl	%eax, %edi
	leaq	.LC94(%rip), %rsi
	call	done
	movq	%rbx, %rdi
	call	wrc_model_destroy@PLT
	movq	760(%rsp), %rbx
	movq	%rbx, %rdi
	call	malloc@PLT
	movq	%rax, %rbp
	movq	768(%rsp), %rdi
	call	malloc@PLT
	movq	%rax, %r12
	movb	$0, text(%rip)
	movq	5152(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	movq	%rbx, %rdx
	movq	%rbp, %rsi
	call	wrc_contact_save@PLT
	movl	%eax, %edi
	leaq	.LC95(%rip), %rsi
	call	done
	movb	$0, text(%rip)
	movq	5152(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	movq	768(%rsp), %rdx
	movq	%r12, %rsi
	call	wrc_contact_save_portable@PLT
	movl	%eax, %edi
	leaq	.LC96(%rip), %rsi
	call	done
	addq	$16, %rsp
	movl	$0, %ebx
	leaq	784(%rsp), %r15
	leaq	.LC98(%rip), %r14
	leaq	.LC99(%rip), %r13
	jmp	.L69
.L75:
	movb	$0, text(%rip)
	movq	5136(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	movq	744(%rsp), %rdx
	movq	%rbp, %rsi
	call	wrc_contact_restore@PLT
	movl	%eax, %edi
	leaq	.LC100(%rip), %rsi
	call	done
.L66:
	addl	$1, %ebx
.L69:
	movq	.LC97(%rip), %rax
	movq	%rax, 2376(%rsp)
	movb	$0, text(%rip)
	movq	5136(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	leaq	2336(%rsp), %rsi
	movq	%r15, %rdx
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	movq	%r14, %rsi
	call	done
	leaq	800(%rsp), %rsi
	movl	$19, %edx
	movq	%r13, %rdi
	call	show
	testl	%ebx, %ebx
	je	.L75
	cmpl	$1, %ebx
	je	.L76
	addl	$1, %ebx
	cmpl	$3, %ebx
	jne	.L69
	movq	%r12, %rdi
	call	free@PLT
	movq	%rbp, %rdi
	call	free@PLT
	leaq	4336(%rsp), %rbx
	movq	%rbx, %rdi
	call	rolling
	movq	.LC87(%rip), %rax
	movq	%rax, 4376(%rsp)
	leaq	5152(%rsp), %rdi
	movq	%rbx, %rsi
	call	in_own_memory
	movl	$900, %edi
	call	wrc_get_api@PLT
	movq	%rax, %r8
	movq	$0, 4148(%rsp)
	movq	$0, 4320(%rsp)
	leaq	4152(%rsp), %rdi
	movl	$22, %ecx
	movl	$0, %eax
	rep stosq
	movl	$184, 4144(%rsp)
	movl	$1, 4340(%rsp)
	movq	.LC102(%rip), %rax
	movq	%rax, 5008(%rsp)
	leaq	4144(%rsp), %rdx
	movq	%rbx, %rsi
	movq	5136(%rsp), %rdi
	call	*224(%r8)
	cmpl	$-4, %eax
	jne	.L77
	movl	$400, %edx
	leaq	text(%rip), %rbx
	movq	%rbx, %rsi
	movq	5136(%rsp), %rdi
	call	wrc_contact_last_error@PLT
	movl	%eax, %edi
	leaq	.LC103(%rip), %rsi
	call	done
	movq	%rbx, %rdi
	call	puts@PLT
	movq	5136(%rsp), %rdi
	call	wrc_contact_destroy@PLT
	movq	5144(%rsp), %rdi
	call	wrc_contact_destroy@PLT
	movq	8(%rsp), %rdi
	call	wrc_model_destroy@PLT
	addq	$6344, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	ret
.L76:
	movb	$0, text(%rip)
	movq	5136(%rsp), %rdi
	movq	%rdi, spoken(%rip)
	movq	752(%rsp), %rdx
	movq	%r12, %rsi
	call	wrc_contact_restore_portable@PLT
	movl	%eax, %edi
	leaq	.LC101(%rip), %rsi
	call	done
	jmp	.L66
.L77:
	movl	$3, %edi
	call	exit@PLT
	.size	wheel_on_a_rail, .-wheel_on_a_rail
	.type	other_rails, @function
other_rails:
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$10000, %rsp
	leaq	8816(%rsp), %rdi
	call	standard
	leaq	8096(%rsp), %rdi
	call	rolling
	movl	$1, 8100(%rsp)
	movq	.LC106(%rip), %rax
	movq	%rax, 8768(%rsp)
	movq	.LC107(%rip), %rax
	movq	%rax, 8080(%rsp)
	movq	.LC108(%rip), %rax
	movq	%rax, 8088(%rsp)
	leaq	7568(%rsp), %rdx
	movl	$63, %ecx
	movl	$0, %eax
	movq	%rdx, %rdi
	rep stosq
	movq	%rdx, %rdi
	movsd	.LC57(%rip), %xmm2
	leaq	8080(%rsp), %rdx
.L79:
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%eax, %xmm0
	movapd	%xmm0, %xmm1
	addsd	%xmm0, %xmm1
	movsd	%xmm1, (%rdi)
	mulsd	%xmm2, %xmm0
	movsd	%xmm0, 16(%rdi)
	movl	$2, 28(%rdi)
	movq	%rdx, 32(%rdi)
	movl	$3, 40(%rdi)
	addl	$1, %eax
	addq	$168, %rdi
	cmpl	$3, %eax
	jne	.L79
	movl	$3, 9984(%rsp)
	movl	$168, 9988(%rsp)
	leaq	7568(%rsp), %rax
	movq	%rax, 9992(%rsp)
	movl	$0, %eax
	movsd	.LC109(%rip), %xmm5
	movsd	.LC110(%rip), %xmm4
	movsd	.LC111(%rip), %xmm3
	movsd	.LC112(%rip), %xmm2
.L80:
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%eax, %xmm0
	mulsd	%xmm5, %xmm0
	mulsd	%xmm4, %xmm0
	movsd	%xmm0, 7296(%rsp,%rax,8)
	movl	%eax, %ecx
	sarl	$31, %ecx
	shrl	$27, %ecx
	leal	(%rcx,%rax), %edx
	andl	$31, %edx
	subl	%ecx, %edx
	subl	$16, %edx
	pxor	%xmm1, %xmm1
	cvtsi2sdl	%edx, %xmm1
	movapd	%xmm1, %xmm0
	mulsd	%xmm3, %xmm0
	mulsd	%xmm1, %xmm0
	mulsd	%xmm2, %xmm0
	movsd	%xmm0, 7024(%rsp,%rax,8)
	addq	$1, %rax
	cmpq	$33, %rax
	jne	.L80
	movl	$33, 9752(%rsp)
	movl	$1, 9756(%rsp)
	leaq	7296(%rsp), %rax
	movq	%rax, 9760(%rsp)
	leaq	7024(%rsp), %rax
	movq	%rax, 9776(%rsp)
	movq	.LC113(%rip), %rax
	movq	%rax, 8784(%rsp)
	movq	.LC85(%rip), %rax
	movq	%rax, 8792(%rsp)
	leaq	8096(%rsp), %rbp
	leaq	8816(%rsp), %rbx
	movq	%rbp, %rsi
	movq	%rbx, %rdi
	call	wrench_of
	movq	%rbp, %rsi
	movq	%rbx, %rdi
	call	in_own_memory
	movq	%rsp, %rbp
	movq	%rbp, %rdi
	call	standard
	movl	$148, %ecx
	movq	%rbx, %rdi
	movq	%rbp, %rsi
	rep movsq
	movq	$0x000000000, 8792(%rsp)
	movq	$0x000000000, 8784(%rsp)
	movl	$0, %eax
	pxor	%xmm11, %xmm11
	movsd	.LC75(%rip), %xmm5
	movsd	.LC114(%rip), %xmm4
	movsd	.LC115(%rip), %xmm3
	movsd	.LC116(%rip), %xmm2
	movsd	.LC104(%rip), %xmm12
	movsd	.LC107(%rip), %xmm6
	movsd	.LC57(%rip), %xmm8
	movsd	.LC105(%rip), %xmm10
	movsd	.LC117(%rip), %xmm9
	movsd	.LC108(%rip), %xmm7
	jmp	.L85
.L96:
	pxor	%xmm1, %xmm1
	comisd	%xmm0, %xmm1
	ja	.L81
	movapd	%xmm10, %xmm1
	comisd	%xmm0, %xmm8
	jbe	.L81
	movapd	%xmm0, %xmm1
	mulsd	%xmm9, %xmm1
.L81:
	mulsd	.LC75(%rip), %xmm1
	addsd	%xmm1, %xmm11
	addq	$1, %rax
	cmpq	$356, %rax
	je	.L99
.L85:
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%eax, %xmm0
	mulsd	%xmm5, %xmm0
	subsd	%xmm4, %xmm0
	movsd	%xmm0, 4176(%rsp,%rax,8)
	movsd	%xmm11, 1328(%rsp,%rax,8)
	addsd	%xmm3, %xmm0
	movapd	%xmm12, %xmm1
	comisd	%xmm0, %xmm2
	ja	.L81
	comisd	%xmm0, %xmm6
	jbe	.L96
	addsd	%xmm7, %xmm0
	movapd	%xmm0, %xmm1
	divsd	.LC60(%rip), %xmm1
	jmp	.L81
.L99:
	movsd	2928(%rsp), %xmm1
	leaq	1328(%rsp), %rax
	leaq	4176(%rsp), %rdx
.L86:
	movsd	(%rax), %xmm0
	subsd	%xmm1, %xmm0
	movsd	%xmm0, (%rax)
	addq	$8, %rax
	cmpq	%rdx, %rax
	jne	.L86
	movdqa	9872(%rsp), %xmm7
	movaps	%xmm7, 1216(%rsp)
	movdqa	9888(%rsp), %xmm7
	movaps	%xmm7, 1232(%rsp)
	movdqa	9904(%rsp), %xmm7
	movaps	%xmm7, 1248(%rsp)
	movdqa	9920(%rsp), %xmm7
	movaps	%xmm7, 1264(%rsp)
	movdqa	9936(%rsp), %xmm7
	movaps	%xmm7, 1280(%rsp)
	movdqa	9952(%rsp), %xmm7
	movaps	%xmm7, 1296(%rsp)
	movdqa	9968(%rsp), %xmm7
	movaps	%xmm7, 1312(%rsp)
	movq	.LC118(%rip), %rax
	movq	%rax, 1184(%rsp)
	movq	.LC107(%rip), %rax
	movq	%rax, 1192(%rsp)
	movl	$1, 1200(%rsp)
	movl	$356, 1204(%rsp)
	leaq	4176(%rsp), %rax
	movq	%rax, 1208(%rsp)
	leaq	1328(%rsp), %rax
	movq	%rax, 1216(%rsp)
	movdqa	1184(%rsp), %xmm7
	movaps	%xmm7, 9840(%rsp)
	movdqa	1200(%rsp), %xmm7
	movaps	%xmm7, 9856(%rsp)
	movdqa	1216(%rsp), %xmm7
	movaps	%xmm7, 9872(%rsp)
	leaq	8096(%rsp), %r12
	leaq	8816(%rsp), %rbp
	movq	%r12, %rsi
	movq	%rbp, %rdi
	call	wrench_of
	movq	%rsp, %rbx
	movq	%rbx, %rdi
	call	standard
	movl	$148, %ecx
	movq	%rbp, %rdi
	movq	%rbx, %rsi
	rep movsq
	movq	.LC70(%rip), %rax
	movq	%rax, 9832(%rsp)
	movq	%rbx, %rdi
	call	rolling
	movl	$90, %ecx
	movq	%r12, %rdi
	movq	%rbx, %rsi
	rep movsq
	movq	$0x000000000, 8160(%rsp)
	movq	.LC119(%rip), %rax
	movq	%rax, 8136(%rsp)
	movq	.LC41(%rip), %rax
	movq	%rax, 8800(%rsp)
	movq	%r12, %rsi
	movq	%rbp, %rdi
	call	wrench_of
	addq	$10000, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	ret
	.size	other_rails, .-other_rails
	.section	.rodata.str1.1
.LC120:
	.string	"wrc_contact_commit(contact)"
	.text
	.type	remembering, @function
remembering:
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$2104, %rsp
	leaq	912(%rsp), %rbx
	movq	%rbx, %rdi
	call	standard
	movl	$1, 1628(%rsp)
	movq	%rbx, %rdi
	call	model_of
	movq	%rax, %r12
	movl	$0, %esi
	movq	%rax, %rdi
	call	contact_of
	movq	%rax, %rbx
	leaq	192(%rsp), %rdi
	call	rolling
	movq	.LC87(%rip), %rax
	movq	%rax, 232(%rsp)
	movq	$0, 4(%rsp)
	movq	$0, 176(%rsp)
	leaq	8(%rsp), %rdi
	movl	$22, %ecx
	movl	$0, %eax
	rep stosq
	movl	$184, (%rsp)
	movl	$2, %ebp
	leaq	.LC80(%rip), %r15
	leaq	.LC35(%rip), %r14
	leaq	.LC120(%rip), %r13
.L101:
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%rsp, %rdx
	leaq	192(%rsp), %rsi
	movq	%rbx, %rdi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	movq	%r15, %rsi
	call	done
	leaq	16(%rsp), %rsi
	movl	$19, %edx
	movq	%r14, %rdi
	call	show
	movb	$0, text(%rip)
	movq	%rbx, spoken(%rip)
	movq	%rbx, %rdi
	call	wrc_contact_commit@PLT
	movl	%eax, %edi
	movq	%r13, %rsi
	call	done
	movq	.LC75(%rip), %rax
	movq	%rax, 904(%rsp)
	subl	$1, %ebp
	jne	.L101
	movq	%rbx, %rdi
	call	wrc_contact_destroy@PLT
	movq	%r12, %rdi
	call	wrc_model_destroy@PLT
	addq	$2104, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	ret
	.size	remembering, .-remembering
	.section	.rodata.str1.8
	.align 8
.LC122:
	.string	"wrc_contact_wrench(wheel, &down, &wrench)"
	.align 8
.LC123:
	.string	"wrc_planar_step(planar, &step, NULL)"
	.align 8
.LC125:
	.string	"wrc_contact_wear(contact, 0, &laws, &wear)"
	.section	.rodata.str1.1
.LC126:
	.string	"wear.worn_area_rate"
	.section	.rodata.str1.8
	.align 8
.LC128:
	.string	"wrc_contact_temperature(contact, 0, &bulk, &temperature)"
	.section	.rodata.str1.1
.LC129:
	.string	"temperature.at_entry"
	.section	.rodata.str1.8
	.align 8
.LC130:
	.string	"wrc_contact_stresses(contact, 0, WRC_BODY_RAIL, depths, 3, levels, &stresses)"
	.align 8
.LC134:
	.string	"wrc_contact_accumulate(contact, &accumulation, &bins[i], i == 0 ? &bins[2] : NULL, &totals)"
	.section	.rodata.str1.1
.LC135:
	.string	"totals.sum[0]"
	.section	.rodata.str1.8
	.align 8
.LC136:
	.string	"wrc_damage_merge(&bins[0], &bins[1])"
	.align 8
.LC137:
	.string	"wrc_damage_values(&bins[0], quantity, values)"
	.section	.rodata.str1.1
.LC138:
	.string	"values"
	.section	.rodata.str1.8
	.align 8
.LC139:
	.string	"wrc_damage_values(&bins[2], quantity, values)"
	.align 8
.LC140:
	.string	"largest in a bin %.17g %.17g, overflow %d\n"
	.align 8
.LC142:
	.string	"wrc_whole_life_damage(&fatigue, 40.0, &life)"
	.section	.rodata.str1.1
.LC143:
	.string	"life"
.LC144:
	.string	"low adhesion, layers"
	.section	.rodata.str1.8
	.align 8
.LC145:
	.string	"wrc_surface_laws_use(&laws, \"low adhesion, layers\", text, sizeof text)"
	.align 8
.LC148:
	.string	"wrc_surface_add(&surface[0], quantity, 4e-3, 1.0, 11.0, text, sizeof text)"
	.align 8
.LC153:
	.string	"wrc_surface_pass(&surface[0], &surface[1], &laws, &passage, &exchange, text, sizeof text)"
	.section	.rodata.str1.1
.LC154:
	.string	"exchange.carried[0]"
	.section	.rodata.str1.8
	.align 8
.LC155:
	.string	"wrc_surface_friction(&surface[0], &surface[1], &laws, &passage, &base, &friction, text, sizeof text)"
	.section	.rodata.str1.1
.LC156:
	.string	"friction.coefficient"
.LC157:
	.string	"friction.layer_yield"
	.section	.rodata.str1.8
	.align 8
.LC158:
	.string	"wrc_surface_rest(&surface[0], &laws, 20.0, text, sizeof text)"
	.align 8
.LC159:
	.string	"wrc_surface_merge(&surface[2], &surface[0], text, sizeof text)"
	.align 8
.LC160:
	.string	"wrc_surface_values(&surface[2], WRC_SURFACE_WATER, book, values, &total, text, sizeof text)"
	.section	.rodata.str1.1
.LC161:
	.string	"total"
	.section	.rodata.str1.8
	.align 8
.LC165:
	.string	"wrc_linear_coefficients(1.5, 0.3, 0.27, &coefficients)"
	.section	.rodata.str1.1
.LC166:
	.string	"coefficients.c11"
	.section	.rodata.str1.8
	.align 8
.LC167:
	.string	"wrc_shakedown_limit(0.2, &limit)"
	.section	.rodata.str1.1
.LC168:
	.string	"limit"
	.section	.rodata.str1.8
	.align 8
.LC169:
	.string	"wrc_shakedown_limit_point(0.2, &limit)"
	.align 8
.LC172:
	.string	"wrc_flash_temperature(16, 0.5e-3, density, speed, &wheel, &rail, rise)"
	.section	.rodata.str1.1
.LC173:
	.string	"rise"
	.section	.rodata.str1.8
	.align 8
.LC177:
	.string	"wrc_exact_gap(contact, &grid, gap)"
	.section	.rodata.str1.1
.LC178:
	.string	"gap"
	.section	.rodata.str1.8
	.align 8
.LC179:
	.string	"wrc_exact_normal(&press, &pressed, text, sizeof text)"
	.section	.rodata.str1.1
.LC180:
	.string	"pressed.approach"
.LC181:
	.string	"pressure"
	.section	.rodata.str1.8
	.align 8
.LC182:
	.string	"wrc_exact_rolling(&roll, &rolled, text, sizeof text)"
	.section	.rodata.str1.1
.LC183:
	.string	"rolled.fx"
.LC184:
	.string	"traction_x"
.LC185:
	.string	"slip_y"
	.section	.rodata.str1.8
	.align 8
.LC186:
	.string	"wrc_exact_transient_create(&grid, &wheel, &rail, &bodies, text, sizeof text)"
	.align 8
.LC187:
	.string	"wrc_exact_transient_step(bodies, &roll, &rolled, text, sizeof text)"
	.align 8
.LC188:
	.string	"wrc_exact_stress(&loads, points, 2, tensors, text, sizeof text)"
	.section	.rodata.str1.1
.LC189:
	.string	"tensors"
	.section	.rodata.str1.8
	.align 8
.LC190:
	.string	"wrc_exact_largest_stresses(&loads, depths, 2, levels, &stresses, hear, &calls, text, sizeof text)"
	.align 8
.LC191:
	.string	"wrc_exact_check(planar, &options, &result)"
	.section	.rodata.str1.1
.LC192:
	.string	"result.fx"
	.section	.rodata.str1.8
	.align 8
.LC194:
	.string	"wrc_exact_wrench(wheel, &input, &coarse, &wrench)"
	.section	.rodata.str1.1
.LC204:
	.string	"locomotive"
	.section	.rodata.str1.8
	.align 8
.LC205:
	.string	"wrc_friction_use(&curve.friction, \"locomotive\", text, sizeof text)"
	.align 8
.LC206:
	.string	"wrc_fit_creep_curve(planar, &curve, &fit, adhesion)"
	.section	.rodata.str1.1
.LC207:
	.string	"fit.scatter"
	.section	.rodata.str1.8
	.align 8
.LC208:
	.string	"fit.value[WRC_CREEP_COEFFICIENT]"
	.align 8
.LC209:
	.string	"fit.deviation[WRC_CREEP_COEFFICIENT]"
	.section	.rodata.str1.1
.LC210:
	.string	"adhesion"
	.section	.rodata.str1.8
	.align 8
.LC211:
	.string	"wrc_profile_wheelset_geometry(model, &problem, &functions, text, sizeof text)"
	.section	.rodata.str1.1
.LC212:
	.string	"radius_difference"
.LC213:
	.string	"y_wheel"
	.section	.rodata.str1.8
	.align 8
.LC215:
	.string	"wrc_equivalent_conicity(&rolls, &found, text, sizeof text)"
	.section	.rodata.str1.1
.LC216:
	.string	"conicity"
.LC217:
	.string	"wavelength"
	.section	.rodata.str1.8
	.align 8
.LC221:
	.string	"wrc_model_arc_places(model, WRC_BODY_WHEEL, points, arc, y, z)"
	.section	.rodata.str1.1
.LC222:
	.string	"z[points / 2]"
	.section	.rodata.str1.8
	.align 8
.LC225:
	.string	"wrc_profile_remove_wear(&wear, &worn, text, sizeof text)"
	.section	.rodata.str1.1
.LC226:
	.string	"worn.passages"
.LC227:
	.string	"worn_z[worn.count / 2]"
	.section	.rodata.str1.8
	.align 8
.LC228:
	.string	"wrc_flange_dimensions(points, y, z, 0.07, &flange, text, sizeof text)"
	.section	.rodata.str1.1
.LC229:
	.string	"flange.height"
.LC231:
	.string	"sections.txt"
	.section	.rodata.str1.8
	.align 8
.LC232:
	.string	"wrc_section_file_write(path, line, count, text, sizeof text)"
	.align 8
.LC233:
	.string	"wrc_section_file_read(path, 1.0, 0, 0, &file, text, sizeof text)"
	.align 8
.LC234:
	.string	"wrc_section_file_line(file, 1, &read)"
	.section	.rodata.str1.1
.LC235:
	.string	"read.distance"
.LC236:
	.string	"read.z[3]"
	.section	.rodata.str1.8
	.align 8
.LC237:
	.string	"wrc_rail_faces_create(&problem, &faces, text, sizeof text)"
	.align 8
.LC238:
	.string	"wrc_rail_faces_found(faces, &found)"
	.align 8
.LC239:
	.string	"%u faces, %u outlines, %u sections\n"
	.section	.rodata.str1.1
.LC240:
	.string	"second->distance"
	.section	.rodata.str1.8
	.align 8
.LC241:
	.string	"wrc_rail_faces_outline(faces, 1, &outline)"
	.section	.rodata.str1.1
.LC242:
	.string	"outline.distance"
.LC243:
	.string	"outline.y[3]"
	.text
	.type	experimental, @function
experimental:
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbp
	pushq	%rbx
	subq	$9048, %rsp
	movl	$1, %edi
	call	wrc_get_experimental_api@PLT
	cmpl	$303, (%rax)
	jbe	.L138
	leaq	7856(%rsp), %rbx
	movq	%rbx, %rdi
	call	standard
	movq	%rbx, %rdi
	call	model_of
	movq	%rax, %rbx
	movq	%rax, (%rsp)
	movl	$0, %esi
	movq	%rax, %rdi
	call	contact_of
	movq	%rax, %r12
	movl	$0, %esi
	movq	%rbx, %rdi
	call	contact_of
	movq	%rax, %r14
	leaq	7136(%rsp), %rbx
	movq	%rbx, %rdi
	call	rolling
	movl	$0, %r13d
	movq	$0, 6948(%rsp)
	movq	$0, 7120(%rsp)
	leaq	6952(%rsp), %rdi
	movl	$22, %ecx
	movq	%r13, %rax
	rep stosq
	movl	$184, 6944(%rsp)
	leaq	6480(%rsp), %rbp
	movq	%rbp, %rdi
	call	wrc_planar_input_default
	movq	.LC121(%rip), %rax
	movq	%rax, 6488(%rsp)
	movq	.LC46(%rip), %rax
	movq	%rax, 6552(%rsp)
	movq	.LC57(%rip), %r15
	movq	%r15, 6616(%rsp)
	leaq	5760(%rsp), %rdi
	movl	$90, %ecx
	movq	%rbx, %rsi
	rep movsq
	movq	.LC87(%rip), %rax
	movq	%rax, 5800(%rsp)
	movb	$0, text(%rip)
	movq	%r12, spoken(%rip)
	leaq	6944(%rsp), %rdx
	leaq	5760(%rsp), %rsi
	movq	%r12, %rdi
	call	wrc_contact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC122(%rip), %rsi
	call	done
	movb	$0, text(%rip)
	movq	%r14, spoken(%rip)
	movl	$0, %edx
	movq	%rbp, %rsi
	movq	%r14, %rdi
	call	wrc_planar_step@PLT
	movl	%eax, %edi
	leaq	.LC123(%rip), %rsi
	call	done
	leaq	1360(%rsp), %rbp
	movq	%rbp, %rdi
	call	wrc_wear_laws_default
	movq	.LC124(%rip), %rax
	movq	%rax, 1456(%rsp)
	movb	$0, text(%rip)
	movq	%r12, spoken(%rip)
	leaq	976(%rsp), %rbx
	movq	%rbx, %rcx
	movq	%rbp, %rdx
	movl	$0, %esi
	movq	%r12, %rdi
	call	wrc_contact_wear@PLT
	movl	%eax, %edi
	leaq	.LC125(%rip), %rsi
	call	done
	movl	$4, %edx
	movq	%rbx, %rsi
	leaq	.LC126(%rip), %rdi
	call	show
	leaq	2928(%rsp), %rbp
	pxor	%xmm4, %xmm4
	movaps	%xmm4, 2928(%rsp)
	movaps	%xmm4, 2944(%rsp)
	movq	%rbp, %rdi
	call	wrc_bulk_temperatures_init@PLT
	movdqa	2928(%rsp), %xmm5
	movaps	%xmm5, 592(%rsp)
	movdqa	2944(%rsp), %xmm6
	movaps	%xmm6, 608(%rsp)
	movq	.LC127(%rip), %rax
	movq	%rax, 592(%rsp)
	pxor	%xmm4, %xmm4
	movups	%xmm4, 708(%rsp)
	movups	%xmm4, 724(%rsp)
	movups	%xmm4, 740(%rsp)
	movups	%xmm4, 756(%rsp)
	movl	$0, 772(%rsp)
	movl	$72, 704(%rsp)
	movb	$0, text(%rip)
	movq	%r12, spoken(%rip)
	leaq	704(%rsp), %rcx
	leaq	592(%rsp), %rdx
	movl	$0, %esi
	movq	%r12, %rdi
	call	wrc_contact_temperature@PLT
	movl	%eax, %edi
	leaq	.LC128(%rip), %rsi
	call	done
	leaq	712(%rsp), %rsi
	movl	$8, %edx
	leaq	.LC129(%rip), %rdi
	call	show
	movq	%r15, 480(%rsp)
	movq	.LC38(%rip), %rax
	movq	%rax, 488(%rsp)
	movq	.LC121(%rip), %rax
	movq	%rax, 496(%rsp)
	movl	$73, %ecx
	movq	%rbp, %rdi
	movq	%r13, %rax
	rep stosq
	movl	$584, 2928(%rsp)
	movb	$0, text(%rip)
	movq	%r12, spoken(%rip)
	leaq	1744(%rsp), %r13
	leaq	480(%rsp), %rcx
	subq	$8, %rsp
	pushq	%rbp
	movq	%r13, %r9
	movl	$3, %r8d
	movl	$1, %edx
	movl	$0, %esi
	movq	%r12, %rdi
	call	wrc_contact_stresses@PLT
	movl	%eax, %edi
	leaq	.LC130(%rip), %rsi
	call	done
	movq	%r13, %rdi
	call	show_peaks
	leaq	1952(%rsp), %rdi
	call	show_peaks
	leaq	2144(%rsp), %rdi
	call	show_peaks
	leaq	2952(%rsp), %rdi
	call	show_peaks
	leaq	3144(%rsp), %rdi
	call	show_peaks
	leaq	3336(%rsp), %rdi
	call	show_peaks
	pxor	%xmm4, %xmm4
	movups	%xmm4, 2948(%rsp)
	movups	%xmm4, 2964(%rsp)
	movl	$0, 2980(%rsp)
	movl	$40, 2944(%rsp)
	movq	%rbp, %rdi
	call	wrc_fatigue_laws_init@PLT
	movdqa	2944(%rsp), %xmm5
	movaps	%xmm5, 608(%rsp)
	movdqa	2960(%rsp), %xmm6
	movaps	%xmm6, 624(%rsp)
	movq	2976(%rsp), %rax
	movq	%rax, 640(%rsp)
	movq	%r13, %rdi
	call	wrc_wear_laws_default
	movq	.LC131(%rip), %rax
	movq	%rax, 616(%rsp)
	leaq	bin.15(%rip), %rbp
	movl	$38376, %edx
	movl	$0, %esi
	movq	%rbp, %rdi
	call	memset@PLT
	leaq	1160(%rsp), %r13
	addq	$16, %rsp
	leaq	2928(%rsp), %r15
.L106:
	pxor	%xmm7, %xmm7
	movups	%xmm7, 2932(%rsp)
	movups	%xmm7, 2948(%rsp)
	movups	%xmm7, 2964(%rsp)
	movl	$0, 2980(%rsp)
	movl	$56, 2928(%rsp)
	movq	%r15, %rdi
	call	wrc_damage_bins_init@PLT
	movl	2928(%rsp), %eax
	movl	%eax, (%rbx)
	movl	2952(%rsp), %eax
	movl	%eax, 24(%rbx)
	movsd	2960(%rsp), %xmm0
	movsd	%xmm0, 32(%rbx)
	movsd	2968(%rsp), %xmm0
	movsd	%xmm0, 40(%rbx)
	movl	$40, 4(%rbx)
	movq	.LC132(%rip), %rax
	movq	%rax, 8(%rbx)
	movq	.LC38(%rip), %rax
	movq	%rax, 16(%rbx)
	movl	$312, 28(%rbx)
	movq	%rbp, 48(%rbx)
	addq	$56, %rbx
	addq	$12792, %rbp
	cmpq	%r13, %rbx
	jne	.L106
	pxor	%xmm0, %xmm0
	movups	%xmm0, 708(%rsp)
	movl	$0, 724(%rsp)
	movl	$40, 704(%rsp)
	movq	.LC133(%rip), %rax
	movq	%rax, 712(%rsp)
	leaq	1744(%rsp), %rax
	movq	%rax, 728(%rsp)
	leaq	592(%rsp), %rax
	movq	%rax, 736(%rsp)
	movb	$0, text(%rip)
	movq	%r12, spoken(%rip)
	leaq	1360(%rsp), %rbx
	leaq	976(%rsp), %r15
	leaq	1088(%rsp), %rcx
	leaq	704(%rsp), %r13
	movq	%rbx, %r8
	movq	%r15, %rdx
	movq	%r13, %rsi
	movq	%r12, %rdi
	call	wrc_contact_accumulate@PLT
	movl	%eax, %edi
	leaq	.LC134(%rip), %rsi
	call	done
	movl	$18, %edx
	movq	%rbx, %rsi
	leaq	.LC135(%rip), %rdi
	call	show
	movb	$0, text(%rip)
	movq	%r12, spoken(%rip)
	leaq	1032(%rsp), %rbp
	movq	%rbx, %r8
	movl	$0, %ecx
	movq	%rbp, %rdx
	movq	%r13, %rsi
	movq	%r12, %rdi
	call	wrc_contact_accumulate@PLT
	movl	%eax, %edi
	leaq	.LC134(%rip), %rsi
	call	done
	movl	$18, %edx
	movq	%rbx, %rsi
	leaq	.LC135(%rip), %rdi
	call	show
	movq	%rbp, %rsi
	movq	%r15, %rdi
	call	wrc_damage_merge@PLT
	movl	%eax, %edi
	leaq	.LC136(%rip), %rsi
	call	done
	movl	$0, %ebx
	leaq	2928(%rsp), %rbp
	leaq	.LC137(%rip), %r15
	leaq	.LC138(%rip), %r13
.L107:
	leaq	976(%rsp), %rdi
	movq	%rbp, %rdx
	movl	%ebx, %esi
	call	wrc_damage_values@PLT
	movl	%eax, %edi
	movq	%r15, %rsi
	call	done
	movl	$41, %edx
	movq	%rbp, %rsi
	movq	%r13, %rdi
	call	show
	leaq	1088(%rsp), %rdi
	movq	%rbp, %rdx
	movl	%ebx, %esi
	call	wrc_damage_values@PLT
	movl	%eax, %edi
	leaq	.LC139(%rip), %rsi
	call	done
	movl	$41, %edx
	movq	%rbp, %rsi
	movq	%r13, %rdi
	call	show
	addl	$1, %ebx
	cmpl	$8, %ebx
	jne	.L107
	movl	12752+bin.15(%rip), %esi
	movsd	6504+bin.15(%rip), %xmm1
	movsd	6496+bin.15(%rip), %xmm0
	leaq	.LC140(%rip), %rdi
	movl	$2, %eax
	call	printf@PLT
	leaq	480(%rsp), %rbx
	leaq	592(%rsp), %rdi
	movq	%rbx, %rsi
	movsd	.LC141(%rip), %xmm0
	call	wrc_whole_life_damage@PLT
	movl	%eax, %edi
	leaq	.LC142(%rip), %rsi
	call	done
	movl	$1, %edx
	movq	%rbx, %rsi
	leaq	.LC143(%rip), %rdi
	call	show
	leaq	bin.14(%rip), %r13
	movl	$29952, %edx
	movl	$0, %esi
	movq	%r13, %rdi
	call	memset@PLT
	leaq	976(%rsp), %rbx
	movl	$0, %ebp
	movq	.LC70(%rip), %r15
.L110:
	leaq	2928(%rsp), %rdi
	pxor	%xmm0, %xmm0
	movups	%xmm0, 2932(%rsp)
	movups	%xmm0, 2948(%rsp)
	movups	%xmm0, 2960(%rsp)
	movl	$48, 2928(%rsp)
	call	wrc_surface_init@PLT
	movl	2928(%rsp), %eax
	movl	%eax, (%rbx)
	movsd	2936(%rsp), %xmm0
	movsd	%xmm0, 8(%rbx)
	movsd	2952(%rsp), %xmm0
	movsd	%xmm0, 24(%rbx)
	movl	$12, 4(%rbx)
	cmpl	$1, %ebp
	je	.L108
	movq	%r15, 16(%rbx)
	sete	%al
	movzbl	%al, %eax
	movl	%eax, 32(%rbx)
	movl	$832, 36(%rbx)
	movq	%r13, 40(%rbx)
	addl	$1, %ebp
	cmpl	$3, %ebp
	je	.L109
	addq	$48, %rbx
	addq	$9984, %r13
	jmp	.L110
.L138:
	movl	$2, %edi
	call	exit@PLT
.L109:
	leaq	2928(%rsp), %rbx
	movl	$90, %ecx
	movl	$0, %eax
	movq	%rbx, %rdi
	rep stosq
	movl	$720, 2928(%rsp)
	movq	%rbx, %rdi
	call	wrc_surface_laws_init@PLT
	leaq	1744(%rsp), %rdi
	movl	$90, %ecx
	movq	%rbx, %rsi
	rep movsq
	leaq	1744(%rsp), %rdi
	movl	$400, %ecx
	leaq	text(%rip), %rdx
	leaq	.LC144(%rip), %rsi
	call	wrc_surface_laws_use@PLT
	movl	%eax, %edi
	leaq	.LC145(%rip), %rsi
	call	done
	movq	.LC146(%rip), %rax
	movq	%rax, 2456(%rsp)
	movl	$0, %ebx
	leaq	text(%rip), %rbp
.L111:
	leaq	976(%rsp), %rdi
	movl	$400, %ecx
	movq	%rbp, %rdx
	movq	.LC147(%rip), %rax
	movq	%rax, %xmm2
	movq	.LC70(%rip), %rax
	movq	%rax, %xmm1
	movq	.LC121(%rip), %rax
	movq	%rax, %xmm0
	movl	%ebx, %esi
	call	wrc_surface_add@PLT
	movl	%eax, %edi
	leaq	.LC148(%rip), %rsi
	call	done
	addl	$1, %ebx
	cmpl	$6, %ebx
	jne	.L111
	pxor	%xmm0, %xmm0
	movups	%xmm0, 484(%rsp)
	movups	%xmm0, 496(%rsp)
	movl	$48, 480(%rsp)
	movq	.LC149(%rip), %rax
	movq	%rax, 488(%rsp)
	movq	.LC150(%rip), %rax
	movq	%rax, 496(%rsp)
	movq	.LC151(%rip), %rax
	movq	%rax, 512(%rsp)
	movq	.LC152(%rip), %rax
	movq	%rax, 520(%rsp)
	leaq	1360(%rsp), %r13
	movq	%r13, %rdi
	call	wrc_friction_default
	movq	.LC74(%rip), %rax
	movq	%rax, 1360(%rsp)
	movq	$0, 596(%rsp)
	movq	$0, 680(%rsp)
	leaq	600(%rsp), %rdi
	movl	$11, %ecx
	movl	$0, %eax
	rep stosq
	movl	$96, 592(%rsp)
	leaq	480(%rsp), %rax
	leaq	1744(%rsp), %r15
	leaq	976(%rsp), %rbx
	leaq	1024(%rsp), %rsi
	subq	$8, %rsp
	pushq	$400
	leaq	text(%rip), %r9
	leaq	608(%rsp), %r8
	movq	%rax, 24(%rsp)
	movq	%rax, %rcx
	movq	%r15, %rdx
	movq	%rsi, 32(%rsp)
	movq	%rbx, %rdi
	call	wrc_surface_pass@PLT
	movl	%eax, %edi
	leaq	.LC153(%rip), %rsi
	call	done
	leaq	616(%rsp), %rsi
	movl	$11, %edx
	leaq	.LC154(%rip), %rdi
	call	show
	leaq	2944(%rsp), %rdi
	pushq	$400
	leaq	text(%rip), %rbp
	pushq	%rbp
	movq	%rdi, 56(%rsp)
	movq	%rdi, %r9
	movq	%r13, %r8
	movq	40(%rsp), %rcx
	movq	%r15, %rdx
	movq	48(%rsp), %rsi
	movq	%rbx, %rdi
	call	wrc_surface_friction@PLT
	movl	%eax, %edi
	addq	$32, %rsp
	leaq	.LC155(%rip), %rsi
	call	done
	movl	$1, %edx
	movq	24(%rsp), %rsi
	leaq	.LC156(%rip), %rdi
	call	show
	leaq	3088(%rsp), %rsi
	movl	$1, %edx
	leaq	.LC157(%rip), %rdi
	call	show
	movl	$400, %ecx
	movq	%rbp, %rdx
	movsd	.LC41(%rip), %xmm0
	movq	%r15, %rsi
	movq	%rbx, %rdi
	call	wrc_surface_rest@PLT
	movl	%eax, %edi
	leaq	.LC158(%rip), %rsi
	call	done
	leaq	1072(%rsp), %rdi
	movl	$400, %ecx
	movq	%rbp, %rdx
	movq	%rbx, %rsi
	call	wrc_surface_merge@PLT
	movl	%eax, %edi
	leaq	.LC159(%rip), %rsi
	call	done
	movl	$0, %ebx
	leaq	384(%rsp), %r13
	leaq	.LC160(%rip), %r15
.L112:
	leaq	704(%rsp), %rbp
	leaq	1072(%rsp), %rdi
	subq	$8, %rsp
	pushq	$400
	leaq	text(%rip), %r9
	movq	%r13, %r8
	movq	%rbp, %rcx
	movl	%ebx, %edx
	movl	$0, %esi
	call	wrc_surface_values@PLT
	movl	%eax, %edi
	movq	%r15, %rsi
	call	done
	movl	$12, %edx
	movq	%rbp, %rsi
	leaq	.LC138(%rip), %rdi
	call	show
	movl	$1, %edx
	movq	%r13, %rsi
	leaq	.LC161(%rip), %rdi
	call	show
	addl	$1, %ebx
	addq	$16, %rsp
	cmpl	$6, %ebx
	jne	.L112
	leaq	976(%rsp), %rbx
	movq	%rbx, %rdi
	movsd	.LC162(%rip), %xmm2
	movsd	.LC163(%rip), %xmm1
	movsd	.LC164(%rip), %xmm0
	call	wrc_linear_coefficients@PLT
	movl	%eax, %edi
	leaq	.LC165(%rip), %rsi
	call	done
	movl	$7, %edx
	movq	%rbx, %rsi
	leaq	.LC166(%rip), %rdi
	call	show
	leaq	480(%rsp), %rbx
	movq	%rbx, %rdi
	movq	.LC68(%rip), %rax
	movq	%rax, %xmm0
	call	wrc_shakedown_limit@PLT
	movl	%eax, %edi
	leaq	.LC167(%rip), %rsi
	call	done
	movl	$1, %edx
	movq	%rbx, %rsi
	leaq	.LC168(%rip), %rbp
	movq	%rbp, %rdi
	call	show
	movq	%rbx, %rdi
	movq	.LC68(%rip), %rax
	movq	%rax, %xmm0
	call	wrc_shakedown_limit_point@PLT
	movl	%eax, %edi
	leaq	.LC169(%rip), %rsi
	call	done
	movl	$1, %edx
	movq	%rbx, %rsi
	movq	%rbp, %rdi
	call	show
	movl	$0, %eax
	movsd	.LC170(%rip), %xmm2
	movl	$16, %ecx
.L113:
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%eax, %xmm0
	mulsd	%xmm2, %xmm0
	movl	%ecx, %edx
	subl	%eax, %edx
	pxor	%xmm1, %xmm1
	cvtsi2sdl	%edx, %xmm1
	mulsd	%xmm1, %xmm0
	movsd	%xmm0, 1360(%rsp,%rax,8)
	addq	$1, %rax
	cmpq	$16, %rax
	jne	.L113
	leaq	1744(%rsp), %rdi
	call	wrc_config_default
	movq	2040(%rsp), %r8
	movq	2048(%rsp), %r9
	movq	%r8, 592(%rsp)
	movq	%r9, 600(%rsp)
	movq	2056(%rsp), %rsi
	movq	2064(%rsp), %rdi
	movq	%rsi, 608(%rsp)
	movq	%rdi, 616(%rsp)
	movq	2072(%rsp), %rcx
	movq	2080(%rsp), %rbx
	movq	%rcx, 624(%rsp)
	movq	%rbx, 632(%rsp)
	movq	2088(%rsp), %rax
	movq	2096(%rsp), %rdx
	movq	%rax, 640(%rsp)
	movq	%rdx, 648(%rsp)
	movq	%r8, 704(%rsp)
	movq	%rsi, 720(%rsp)
	movq	%rdi, 728(%rsp)
	movq	%rcx, 736(%rsp)
	movq	%rbx, 744(%rsp)
	movq	%rax, 752(%rsp)
	movq	%rdx, 760(%rsp)
	movq	.LC171(%rip), %rax
	movq	%rax, 712(%rsp)
	leaq	2928(%rsp), %rbx
	leaq	704(%rsp), %rbp
	leaq	592(%rsp), %rdx
	leaq	1360(%rsp), %rsi
	movq	%rbx, %r8
	movq	%rbp, %rcx
	movsd	.LC41(%rip), %xmm1
	movsd	.LC63(%rip), %xmm0
	movl	$16, %edi
	call	wrc_flash_temperature@PLT
	movl	%eax, %edi
	leaq	.LC172(%rip), %rsi
	call	done
	movl	$16, %edx
	movq	%rbx, %rsi
	leaq	.LC173(%rip), %rdi
	call	show
	movl	$0, 36(%rsp)
	pxor	%xmm5, %xmm5
	movups	%xmm5, 2968(%rsp)
	movups	%xmm5, 2984(%rsp)
	movl	$12, 2928(%rsp)
	movl	$14, 2932(%rsp)
	movsd	.LC174(%rip), %xmm0
	movsd	%xmm0, 2936(%rsp)
	movsd	%xmm0, 2944(%rsp)
	movq	.LC175(%rip), %rax
	movq	%rax, 2952(%rsp)
	movq	.LC176(%rip), %rax
	movq	%rax, 2960(%rsp)
	movdqa	2928(%rsp), %xmm6
	movaps	%xmm6, 304(%rsp)
	movdqa	2944(%rsp), %xmm4
	movaps	%xmm4, 320(%rsp)
	movdqa	2960(%rsp), %xmm6
	movaps	%xmm6, 336(%rsp)
	movdqa	2976(%rsp), %xmm4
	movaps	%xmm4, 352(%rsp)
	movq	2992(%rsp), %rax
	movq	%rax, 368(%rsp)
	leaq	text(%rip), %r15
	movb	$0, text(%rip)
	movq	%r14, spoken(%rip)
	leaq	304(%rsp), %rax
	leaq	gap.13(%rip), %r13
	movq	%r13, %rdx
	movq	%rax, 8(%rsp)
	movq	%rax, %rsi
	movq	%r14, %rdi
	call	wrc_exact_gap@PLT
	movl	%eax, %edi
	leaq	.LC177(%rip), %rsi
	call	done
	movl	$168, %edx
	movq	%r13, %rsi
	leaq	.LC178(%rip), %rdi
	call	show
	movl	$33, %ecx
	movq	%rbx, %rdi
	movl	$0, %eax
	rep stosq
	movl	$264, 2928(%rsp)
	movq	%rbx, %rdi
	call	wrc_exact_normal_problem_init@PLT
	movl	$33, %ecx
	movq	%rbp, %rdi
	movq	%rbx, %rsi
	rep movsq
	pxor	%xmm5, %xmm5
	movups	%xmm5, 116(%rsp)
	movups	%xmm5, 132(%rsp)
	movups	%xmm5, 148(%rsp)
	movl	$0, 164(%rsp)
	movl	$64, 112(%rsp)
	movq	.LC46(%rip), %rcx
	movq	%rcx, 720(%rsp)
	movdqa	304(%rsp), %xmm6
	movups	%xmm6, 872(%rsp)
	movdqa	320(%rsp), %xmm4
	movups	%xmm4, 888(%rsp)
	movdqa	336(%rsp), %xmm6
	movups	%xmm6, 904(%rsp)
	movdqa	352(%rsp), %xmm4
	movups	%xmm4, 920(%rsp)
	movq	368(%rsp), %rax
	movq	%rax, 936(%rsp)
	movq	%r13, 944(%rsp)
	leaq	hear(%rip), %rcx
	movq	%rcx, 952(%rsp)
	leaq	36(%rsp), %rax
	movq	%rax, 960(%rsp)
	leaq	pressure.12(%rip), %r13
	movq	%r13, 168(%rsp)
	leaq	112(%rsp), %rsi
	movl	$400, %ecx
	movq	%r15, %rdx
	movq	%rbp, %rdi
	call	wrc_exact_normal@PLT
	movl	%eax, %edi
	leaq	.LC179(%rip), %rsi
	call	done
	leaq	128(%rsp), %rsi
	movl	$5, %edx
	leaq	.LC180(%rip), %rdi
	call	show
	movl	$168, %edx
	movq	%r13, %rsi
	leaq	.LC181(%rip), %rdi
	call	show
	movl	$47, %ecx
	movq	%rbx, %rdi
	movl	$0, %eax
	rep stosq
	movl	$376, 2928(%rsp)
	movq	%rbx, %rdi
	call	wrc_exact_rolling_problem_init@PLT
	leaq	976(%rsp), %rdi
	movl	$47, %ecx
	movq	%rbx, %rsi
	rep movsq
	pxor	%xmm5, %xmm5
	movups	%xmm5, 484(%rsp)
	movups	%xmm5, 500(%rsp)
	movups	%xmm5, 516(%rsp)
	movups	%xmm5, 532(%rsp)
	movl	$0, 548(%rsp)
	movl	$104, 480(%rsp)
	movdqa	304(%rsp), %xmm5
	movups	%xmm5, 1128(%rsp)
	movdqa	320(%rsp), %xmm5
	movups	%xmm5, 1144(%rsp)
	movdqa	336(%rsp), %xmm5
	movups	%xmm5, 1160(%rsp)
	movdqa	352(%rsp), %xmm5
	movups	%xmm5, 1176(%rsp)
	movq	368(%rsp), %rax
	movq	%rax, 1192(%rsp)
	movq	%r13, 1200(%rsp)
	movq	.LC57(%rip), %rax
	movq	%rax, 1224(%rsp)
	movq	.LC76(%rip), %rax
	movq	%rax, 1240(%rsp)
	leaq	traction_x.11(%rip), %rbp
	movq	%rbp, 552(%rsp)
	leaq	traction_y.10(%rip), %rax
	movq	%rax, 560(%rsp)
	leaq	slip_x.9(%rip), %rax
	movq	%rax, 568(%rsp)
	leaq	slip_y.8(%rip), %rbx
	movq	%rbx, 576(%rsp)
	leaq	480(%rsp), %rsi
	leaq	976(%rsp), %rdi
	movl	$400, %ecx
	movq	%r15, %rdx
	call	wrc_exact_rolling@PLT
	movl	%eax, %edi
	leaq	.LC182(%rip), %rsi
	call	done
	leaq	496(%rsp), %rsi
	movl	$7, %edx
	leaq	.LC183(%rip), %rdi
	call	show
	movl	$168, %edx
	movq	%rbp, %rsi
	leaq	.LC184(%rip), %rdi
	call	show
	movl	$168, %edx
	movq	%rbx, %rsi
	leaq	.LC185(%rip), %rdi
	call	show
	movq	$0, 40(%rsp)
	movdqu	1000(%rsp), %xmm5
	movaps	%xmm5, 176(%rsp)
	movdqu	1016(%rsp), %xmm6
	movaps	%xmm6, 192(%rsp)
	movdqu	1032(%rsp), %xmm4
	movaps	%xmm4, 208(%rsp)
	movdqu	1048(%rsp), %xmm5
	movaps	%xmm5, 224(%rsp)
	movdqu	1064(%rsp), %xmm6
	movaps	%xmm6, 240(%rsp)
	movdqu	1080(%rsp), %xmm7
	movaps	%xmm7, 256(%rsp)
	movdqu	1096(%rsp), %xmm4
	movaps	%xmm4, 272(%rsp)
	movdqu	1112(%rsp), %xmm5
	movaps	%xmm5, 288(%rsp)
	leaq	40(%rsp), %rcx
	leaq	240(%rsp), %rdx
	leaq	176(%rsp), %rsi
	movl	$400, %r9d
	movq	%r15, %r8
	movq	8(%rsp), %rdi
	call	wrc_exact_transient_create@PLT
	movl	%eax, %edi
	leaq	.LC186(%rip), %rsi
	call	done
	movl	$2, %ebx
	leaq	480(%rsp), %r13
	movq	%r15, %rbp
	leaq	.LC187(%rip), %r15
.L114:
	leaq	976(%rsp), %rsi
	movl	$400, %r8d
	movq	%rbp, %rcx
	movq	%r13, %rdx
	movq	40(%rsp), %rdi
	call	wrc_exact_transient_step@PLT
	movl	%eax, %edi
	movq	%r15, %rsi
	call	done
	leaq	496(%rsp), %rsi
	movl	$7, %edx
	leaq	.LC183(%rip), %rdi
	call	show
	subl	$1, %ebx
	jne	.L114
	movq	40(%rsp), %rdi
	call	wrc_exact_transient_destroy@PLT
	leaq	2928(%rsp), %rbx
	movl	$0, %r13d
	movq	$0, 2932(%rsp)
	movq	$0, 3032(%rsp)
	leaq	2936(%rsp), %rdi
	movl	$13, %ecx
	movq	%r13, %rax
	rep stosq
	movl	$112, 2928(%rsp)
	movq	%rbx, %rdi
	call	wrc_exact_loads_init@PLT
	movdqa	2928(%rsp), %xmm6
	movaps	%xmm6, 592(%rsp)
	movdqa	3024(%rsp), %xmm7
	movaps	%xmm7, 688(%rsp)
	movdqa	304(%rsp), %xmm4
	movaps	%xmm4, 608(%rsp)
	movdqa	320(%rsp), %xmm5
	movaps	%xmm5, 624(%rsp)
	movdqa	336(%rsp), %xmm6
	movaps	%xmm6, 640(%rsp)
	movdqa	352(%rsp), %xmm7
	movaps	%xmm7, 656(%rsp)
	movq	368(%rsp), %rax
	movq	%rax, 672(%rsp)
	leaq	pressure.12(%rip), %rax
	movq	%rax, 680(%rsp)
	leaq	traction_x.11(%rip), %rax
	movq	%rax, 688(%rsp)
	movq	$0x000000000, 64(%rsp)
	movq	$0x000000000, 72(%rsp)
	movq	.LC38(%rip), %rax
	movq	%rax, 80(%rsp)
	movq	.LC57(%rip), %rax
	movq	%rax, 88(%rsp)
	movq	.LC38(%rip), %rax
	movq	%rax, 96(%rsp)
	movsd	.LC67(%rip), %xmm0
	movsd	%xmm0, 104(%rsp)
	movq	.LC57(%rip), %rax
	movq	%rax, 48(%rsp)
	movsd	%xmm0, 56(%rsp)
	leaq	384(%rsp), %rbp
	leaq	64(%rsp), %rsi
	leaq	592(%rsp), %r15
	movl	$400, %r9d
	leaq	text(%rip), %r8
	movq	%rbp, %rcx
	movl	$2, %edx
	movq	%r15, %rdi
	call	wrc_exact_stress@PLT
	movl	%eax, %edi
	leaq	.LC188(%rip), %rsi
	call	done
	movl	$12, %edx
	movq	%rbp, %rsi
	leaq	.LC189(%rip), %rdi
	call	show
	movl	$73, %ecx
	movq	%rbx, %rdi
	movq	%r13, %rax
	rep stosq
	movl	$584, 2928(%rsp)
	leaq	1360(%rsp), %rbp
	leaq	48(%rsp), %rsi
	subq	$8, %rsp
	pushq	$400
	leaq	text(%rip), %rax
	pushq	%rax
	leaq	60(%rsp), %rax
	pushq	%rax
	leaq	hear(%rip), %r9
	movq	%rbx, %r8
	movq	%rbp, %rcx
	movl	$2, %edx
	movq	%r15, %rdi
	call	wrc_exact_largest_stresses@PLT
	movl	%eax, %edi
	addq	$32, %rsp
	leaq	.LC190(%rip), %rsi
	call	done
	movq	%rbp, %rdi
	call	show_peaks
	leaq	1552(%rsp), %rdi
	call	show_peaks
	leaq	2936(%rsp), %rdi
	call	show_peaks
	leaq	3128(%rsp), %rdi
	call	show_peaks
	leaq	3320(%rsp), %rdi
	call	show_peaks
	movb	$0, text(%rip)
	movq	%r14, spoken(%rip)
	leaq	6480(%rsp), %rsi
	movl	$0, %edx
	movq	%r14, %rdi
	call	wrc_planar_step@PLT
	movl	%eax, %edi
	leaq	.LC123(%rip), %rsi
	call	done
	pxor	%xmm6, %xmm6
	movups	%xmm6, 2932(%rsp)
	movups	%xmm6, 2944(%rsp)
	movl	$32, 2928(%rsp)
	movq	%rbx, %rdi
	call	wrc_exact_check_options_init@PLT
	movdqa	2928(%rsp), %xmm4
	movaps	%xmm4, 592(%rsp)
	movdqa	2944(%rsp), %xmm5
	movaps	%xmm5, 608(%rsp)
	pxor	%xmm6, %xmm6
	movups	%xmm6, 980(%rsp)
	movups	%xmm6, 996(%rsp)
	movups	%xmm6, 1012(%rsp)
	movups	%xmm6, 1024(%rsp)
	movl	$64, 976(%rsp)
	movl	$12, 600(%rsp)
	movl	$12, 596(%rsp)
	movb	$0, text(%rip)
	movq	%r14, spoken(%rip)
	leaq	976(%rsp), %rdx
	movq	%r15, %rsi
	movq	%r14, %rdi
	call	wrc_exact_check@PLT
	movl	%eax, %edi
	leaq	.LC191(%rip), %rsi
	call	done
	leaq	984(%rsp), %rsi
	movl	$7, %edx
	leaq	.LC192(%rip), %rdi
	call	show
	movq	%rbx, %rdi
	call	rolling
	leaq	1364(%rsp), %r15
	pxor	%xmm6, %xmm6
	movups	%xmm6, 1364(%rsp)
	movups	%xmm6, 1380(%rsp)
	movups	%xmm6, 1392(%rsp)
	movl	$48, 1360(%rsp)
	movq	%rbp, %rdi
	call	wrc_exact_wrench_options_init@PLT
	movdqa	1360(%rsp), %xmm6
	movaps	%xmm6, 704(%rsp)
	movdqa	1392(%rsp), %xmm7
	movaps	%xmm7, 736(%rsp)
	movq	$0, 1364(%rsp)
	movq	$0, 1536(%rsp)
	leaq	1368(%rsp), %rdi
	subq	%rdi, %r15
	leal	180(%r15), %ecx
	shrl	$3, %ecx
	movl	%ecx, %ecx
	movq	%r13, %rax
	rep stosq
	movl	$184, 1360(%rsp)
	movq	.LC119(%rip), %rax
	movq	%rax, 2968(%rsp)
	movsd	.LC193(%rip), %xmm0
	movsd	%xmm0, 728(%rsp)
	movsd	%xmm0, 720(%rsp)
	movb	$0, text(%rip)
	movq	%r12, spoken(%rip)
	leaq	704(%rsp), %rdx
	movq	%rbp, %rcx
	movq	%rbx, %rsi
	movq	%r12, %rdi
	call	wrc_exact_wrench@PLT
	movl	%eax, %edi
	leaq	.LC194(%rip), %rsi
	call	done
	leaq	1376(%rsp), %rsi
	movl	$19, %edx
	leaq	.LC35(%rip), %rdi
	call	show
	movq	.LC57(%rip), %rax
	movq	%rax, 384(%rsp)
	movq	.LC38(%rip), %rax
	movq	%rax, 392(%rsp)
	movq	.LC121(%rip), %rax
	movq	%rax, 400(%rsp)
	movq	.LC195(%rip), %rax
	movq	%rax, 408(%rsp)
	movq	.LC108(%rip), %rax
	movq	%rax, 416(%rsp)
	movq	.LC196(%rip), %rax
	movq	%rax, 424(%rsp)
	movq	.LC76(%rip), %rax
	movq	%rax, 432(%rsp)
	movsd	.LC68(%rip), %xmm0
	movsd	%xmm0, 440(%rsp)
	movq	.LC197(%rip), %rax
	movq	%rax, 480(%rsp)
	movq	.LC198(%rip), %rax
	movq	%rax, 488(%rsp)
	movsd	%xmm0, 496(%rsp)
	movq	.LC162(%rip), %rax
	movq	%rax, 504(%rsp)
	movq	.LC199(%rip), %rax
	movq	%rax, 512(%rsp)
	movq	.LC200(%rip), %rax
	movq	%rax, 520(%rsp)
	movq	.LC201(%rip), %rax
	movq	%rax, 528(%rsp)
	movq	.LC202(%rip), %rax
	movq	%rax, 536(%rsp)
	movl	$47, %ecx
	movq	%rbx, %rdi
	movq	%r13, %rax
	rep stosq
	movl	$376, 2928(%rsp)
	movq	%rbx, %rdi
	call	wrc_creep_curve_init@PLT
	movl	$47, %ecx
	movq	%rbp, %rdi
	movq	%rbx, %rsi
	rep movsq
	movl	$354, %ecx
	movq	%rbx, %rdi
	movq	%r13, %rax
	rep stosq
	movl	$2832, 2928(%rsp)
	movl	$0, %edx
	movsd	.LC59(%rip), %xmm2
	movsd	.LC46(%rip), %xmm1
.L115:
	movslq	%edx, %rax
	imulq	$1431655766, %rax, %rax
	shrq	$32, %rax
	movl	%edx, %ecx
	sarl	$31, %ecx
	subl	%ecx, %eax
	leal	(%rax,%rax,2), %ecx
	movl	%edx, %eax
	subl	%ecx, %eax
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%eax, %xmm0
	addsd	%xmm2, %xmm0
	movsd	%xmm0, 592(%rsp,%rdx,8)
	movsd	%xmm1, 704(%rsp,%rdx,8)
	addq	$1, %rdx
	cmpq	$8, %rdx
	jne	.L115
	movl	$8, 1364(%rsp)
	leaq	384(%rsp), %rax
	movq	%rax, 1368(%rsp)
	leaq	480(%rsp), %rbx
	movq	%rbx, 1376(%rsp)
	leaq	592(%rsp), %rax
	movq	%rax, 1384(%rsp)
	leaq	704(%rsp), %rax
	movq	%rax, 1392(%rsp)
	movq	.LC203(%rip), %rax
	movq	%rax, 1400(%rsp)
	movq	.LC60(%rip), %rax
	movq	%rax, 1408(%rsp)
	movq	.LC46(%rip), %rax
	movq	%rax, 1432(%rsp)
	leaq	1360(%rsp), %r13
	leaq	1464(%rsp), %rdi
	movl	$400, %ecx
	leaq	text(%rip), %rdx
	leaq	.LC204(%rip), %rsi
	call	wrc_friction_use@PLT
	movl	%eax, %edi
	leaq	.LC205(%rip), %rsi
	call	done
	movb	$0, text(%rip)
	movq	%r14, spoken(%rip)
	leaq	976(%rsp), %rbp
	leaq	2928(%rsp), %rdx
	movq	%rbp, %rcx
	movq	%r13, %rsi
	movq	%r14, %rdi
	call	wrc_fit_creep_curve@PLT
	movl	%eax, %edi
	leaq	.LC206(%rip), %rsi
	call	done
	leaq	2952(%rsp), %rsi
	movl	$1, %edx
	leaq	.LC207(%rip), %rdi
	call	show
	leaq	3200(%rsp), %rsi
	movl	$1, %edx
	leaq	.LC208(%rip), %rdi
	call	show
	leaq	3328(%rsp), %rsi
	movl	$1, %edx
	leaq	.LC209(%rip), %rdi
	call	show
	movl	$8, %edx
	movq	%rbp, %rsi
	leaq	.LC210(%rip), %rdi
	call	show
	movq	%rbx, %rax
	leaq	552(%rsp), %rcx
	movl	$-4, %edx
	movsd	.LC57(%rip), %xmm1
.L116:
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%edx, %xmm0
	mulsd	%xmm1, %xmm0
	movsd	%xmm0, (%rax)
	addl	$1, %edx
	addq	$8, %rax
	cmpq	%rcx, %rax
	jne	.L116
	movq	$0, 192(%rsp)
	movl	$24, 176(%rsp)
	movl	$9, 180(%rsp)
	leaq	480(%rsp), %rbp
	movq	%rbp, 184(%rsp)
	movq	$0, 2932(%rsp)
	movq	$0, 3016(%rsp)
	leaq	2936(%rsp), %rdi
	movl	$11, %ecx
	movl	$0, %eax
	rep stosq
	movl	$96, 2928(%rsp)
	leaq	592(%rsp), %rbx
	movq	%rbx, 2952(%rsp)
	leaq	704(%rsp), %r13
	movq	%r13, 2992(%rsp)
	leaq	2928(%rsp), %rdx
	leaq	176(%rsp), %rsi
	movl	$400, %r8d
	leaq	text(%rip), %r15
	movq	%r15, %rcx
	movq	(%rsp), %rdi
	call	wrc_profile_wheelset_geometry@PLT
	movl	%eax, %edi
	leaq	.LC211(%rip), %rsi
	call	done
	movl	$9, %edx
	movq	%rbx, %rsi
	leaq	.LC212(%rip), %rdi
	call	show
	movl	$9, %edx
	movq	%r13, %rsi
	leaq	.LC213(%rip), %rdi
	call	show
	movq	.LC57(%rip), %rax
	movq	%rax, 112(%rsp)
	movq	.LC214(%rip), %rax
	movq	%rax, 120(%rsp)
	leaq	1360(%rsp), %rdi
	pxor	%xmm7, %xmm7
	movups	%xmm7, 1364(%rsp)
	movups	%xmm7, 1380(%rsp)
	movups	%xmm7, 1396(%rsp)
	movl	$0, 1412(%rsp)
	movl	$56, 1360(%rsp)
	call	wrc_conicity_problem_init@PLT
	movdqa	1360(%rsp), %xmm4
	movaps	%xmm4, 384(%rsp)
	movdqa	1392(%rsp), %xmm5
	movaps	%xmm5, 416(%rsp)
	movq	1408(%rsp), %rax
	movq	%rax, 432(%rsp)
	movl	$9, 392(%rsp)
	movq	%rbp, 400(%rsp)
	movq	%rbx, 408(%rsp)
	movl	$2, 396(%rsp)
	leaq	112(%rsp), %rax
	movq	%rax, 416(%rsp)
	pxor	%xmm7, %xmm7
	movups	%xmm7, 244(%rsp)
	movups	%xmm7, 256(%rsp)
	movl	$32, 240(%rsp)
	leaq	48(%rsp), %rbp
	movq	%rbp, 248(%rsp)
	leaq	64(%rsp), %rbx
	movq	%rbx, 256(%rsp)
	leaq	240(%rsp), %rsi
	leaq	384(%rsp), %rdi
	movl	$400, %ecx
	movq	%r15, %rdx
	call	wrc_equivalent_conicity@PLT
	movl	%eax, %edi
	leaq	.LC215(%rip), %rsi
	call	done
	movl	$2, %edx
	movq	%rbp, %rsi
	leaq	.LC216(%rip), %rdi
	call	show
	movl	$2, %edx
	movq	%rbx, %rsi
	leaq	.LC217(%rip), %rdi
	call	show
	movl	$0, %eax
	leaq	arc.7(%rip), %rdx
	movsd	.LC63(%rip), %xmm2
	movsd	.LC218(%rip), %xmm1
.L117:
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%eax, %xmm0
	mulsd	%xmm2, %xmm0
	subsd	%xmm1, %xmm0
	movsd	%xmm0, (%rdx,%rax,8)
	addq	$1, %rax
	cmpq	$240, %rax
	jne	.L117
	leaq	depth.6(%rip), %rdx
	movl	$-81, %eax
.L121:
	cmpl	$38, %eax
	jbe	.L139
	movq	$0x000000000, (%rdx)
	addl	$1, %eax
	addq	$8, %rdx
	cmpl	$119, %eax
	jne	.L121
	leaq	z.4(%rip), %r9
	leaq	y.5(%rip), %r8
	leaq	arc.7(%rip), %rcx
	movl	$240, %edx
	movl	$0, %esi
	movq	(%rsp), %rdi
	call	wrc_model_arc_places@PLT
	movl	%eax, %edi
	leaq	.LC221(%rip), %rsi
	call	done
	movl	$1, %edx
	leaq	960+z.4(%rip), %rsi
	leaq	.LC222(%rip), %rdi
	call	show
	leaq	1360(%rsp), %r15
	movq	$0, 1364(%rsp)
	movq	$0, 1440(%rsp)
	leaq	1368(%rsp), %rdi
	movl	$10, %ecx
	movl	$0, %eax
	rep stosq
	movl	$88, 1360(%rsp)
	movq	%r15, %rdi
	call	wrc_profile_wear_init@PLT
	movdqa	1360(%rsp), %xmm6
	movaps	%xmm6, 976(%rsp)
	movdqa	1408(%rsp), %xmm7
	movaps	%xmm7, 1024(%rsp)
	movdqa	1424(%rsp), %xmm4
	movaps	%xmm4, 1040(%rsp)
	movq	1440(%rsp), %rax
	movq	%rax, 1056(%rsp)
	movl	$240, 984(%rsp)
	leaq	y.5(%rip), %rbx
	movq	%rbx, 992(%rsp)
	leaq	z.4(%rip), %rbp
	movq	%rbp, 1000(%rsp)
	movl	$200, 988(%rsp)
	leaq	depth.6(%rip), %rcx
	movq	%rcx, 1008(%rsp)
	movq	.LC223(%rip), %rcx
	movq	%rcx, 1016(%rsp)
	movq	.LC224(%rip), %rcx
	movq	%rcx, 1032(%rsp)
	pxor	%xmm0, %xmm0
	movups	%xmm0, 1368(%rsp)
	movups	%xmm0, 1384(%rsp)
	movups	%xmm0, 1400(%rsp)
	movl	$56, 1360(%rsp)
	movl	$2000, 1364(%rsp)
	leaq	worn_y.3(%rip), %rcx
	movq	%rcx, 1376(%rsp)
	leaq	worn_z.2(%rip), %r13
	movq	%r13, 1384(%rsp)
	leaq	976(%rsp), %rdi
	movl	$400, %ecx
	leaq	text(%rip), %rdx
	movq	%r15, %rsi
	call	wrc_profile_remove_wear@PLT
	movl	%eax, %edi
	leaq	.LC225(%rip), %rsi
	call	done
	leaq	1392(%rsp), %rsi
	movl	$3, %edx
	leaq	.LC226(%rip), %rdi
	call	show
	movl	1368(%rsp), %ecx
	shrl	%ecx
	movl	%ecx, %eax
	leaq	0(%r13,%rax,8), %rsi
	movl	$1, %edx
	leaq	.LC227(%rip), %rdi
	call	show
	leaq	304(%rsp), %r13
	movl	$400, %r9d
	leaq	text(%rip), %r8
	movq	%r13, %rcx
	movsd	.LC197(%rip), %xmm0
	movq	%rbp, %rdx
	movq	%rbx, %rsi
	movl	$240, %edi
	call	wrc_flange_dimensions@PLT
	movl	%eax, %edi
	leaq	.LC228(%rip), %rsi
	call	done
	movl	$3, %edx
	movq	%r13, %rsi
	leaq	.LC229(%rip), %rdi
	call	show
	leaq	2928(%rsp), %rdx
	movl	$24, %ecx
	movq	%rdx, %rdi
	movl	$0, %eax
	rep stosq
	movq	%rdx, %rdi
	leaq	y.1(%rip), %rsi
	leaq	z.0(%rip), %rcx
	movl	$0, %r8d
	movsd	.LC75(%rip), %xmm6
	movsd	.LC230(%rip), %xmm3
	movsd	.LC133(%rip), %xmm5
.L122:
	pxor	%xmm4, %xmm4
	cvtsi2sdl	%r8d, %xmm4
	movapd	%xmm4, %xmm2
	mulsd	%xmm6, %xmm2
	movl	$0, %eax
.L123:
	leal	-20(%rax), %edx
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%edx, %xmm0
	mulsd	%xmm3, %xmm0
	movsd	%xmm0, (%rsi,%rax,8)
	movapd	%xmm0, %xmm1
	addsd	%xmm0, %xmm1
	mulsd	%xmm0, %xmm1
	addsd	%xmm2, %xmm1
	movsd	%xmm1, (%rcx,%rax,8)
	addq	$1, %rax
	cmpq	$40, %rax
	jne	.L123
	mulsd	%xmm5, %xmm4
	movsd	%xmm4, (%rdi)
	movl	$40, 8(%rdi)
	movq	%rsi, 16(%rdi)
	movq	%rcx, 24(%rdi)
	addl	$1, %r8d
	addq	$64, %rdi
	addq	$320, %rsi
	addq	$320, %rcx
	cmpl	$3, %r8d
	jne	.L122
	leaq	2928(%rsp), %r13
	movl	$400, %r8d
	leaq	text(%rip), %rbp
	movq	%rbp, %rcx
	movl	$3, %edx
	movq	%r13, %rsi
	leaq	.LC231(%rip), %rbx
	movq	%rbx, %rdi
	call	wrc_section_file_write@PLT
	movl	%eax, %edi
	leaq	.LC232(%rip), %rsi
	call	done
	leaq	384(%rsp), %rcx
	movl	$400, %r9d
	movq	%rbp, %r8
	movl	$0, %edx
	movl	$0, %esi
	movsd	.LC70(%rip), %xmm0
	movq	%rbx, %rdi
	call	wrc_section_file_read@PLT
	movl	%eax, %edi
	leaq	.LC233(%rip), %rsi
	call	done
	movq	%rbx, %rdi
	call	remove@PLT
	leaq	704(%rsp), %rbx
	movq	%rbx, %rdx
	movl	$1, %esi
	movq	384(%rsp), %rdi
	call	wrc_section_file_line@PLT
	movl	%eax, %edi
	leaq	.LC234(%rip), %rsi
	call	done
	movl	$1, %edx
	movq	%rbx, %rsi
	leaq	.LC235(%rip), %rdi
	call	show
	movq	728(%rsp), %rax
	leaq	24(%rax), %rsi
	movl	$1, %edx
	leaq	.LC236(%rip), %rdi
	call	show
	movq	384(%rsp), %rdi
	call	wrc_section_file_destroy@PLT
	leaq	1360(%rsp), %rbx
	movq	$0, 1364(%rsp)
	movq	$0, 1440(%rsp)
	leaq	1368(%rsp), %rdi
	movl	$10, %ecx
	movl	$0, %eax
	rep stosq
	movl	$88, 1360(%rsp)
	movq	%rbx, %rdi
	call	wrc_rail_faces_problem_init@PLT
	movdqa	1360(%rsp), %xmm5
	movaps	%xmm5, 976(%rsp)
	movdqa	1376(%rsp), %xmm6
	movaps	%xmm6, 992(%rsp)
	movdqa	1392(%rsp), %xmm7
	movaps	%xmm7, 1008(%rsp)
	movdqa	1408(%rsp), %xmm4
	movaps	%xmm4, 1024(%rsp)
	movdqa	1424(%rsp), %xmm5
	movaps	%xmm5, 1040(%rsp)
	movq	1440(%rsp), %rax
	movq	%rax, 1056(%rsp)
	movl	$3, 980(%rsp)
	movq	%r13, 984(%rsp)
	pxor	%xmm0, %xmm0
	movups	%xmm0, 596(%rsp)
	movups	%xmm0, 612(%rsp)
	movups	%xmm0, 624(%rsp)
	movl	$48, 592(%rsp)
	movups	%xmm0, 1364(%rsp)
	movups	%xmm0, 1380(%rsp)
	movups	%xmm0, 1396(%rsp)
	movups	%xmm0, 1408(%rsp)
	movl	$64, 1360(%rsp)
	leaq	480(%rsp), %rsi
	leaq	976(%rsp), %rdi
	movl	$400, %ecx
	movq	%rbp, %rdx
	call	wrc_rail_faces_create@PLT
	movl	%eax, %edi
	leaq	.LC237(%rip), %rsi
	call	done
	leaq	592(%rsp), %rsi
	movq	480(%rsp), %rdi
	call	wrc_rail_faces_found@PLT
	movl	%eax, %edi
	leaq	.LC238(%rip), %rsi
	call	done
	movl	604(%rsp), %ecx
	movl	600(%rsp), %edx
	movl	596(%rsp), %esi
	leaq	.LC239(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	movl	608(%rsp), %esi
	addq	616(%rsp), %rsi
	movl	$1, %edx
	leaq	.LC240(%rip), %rdi
	call	show
	movq	%rbx, %rdx
	movl	$1, %esi
	movq	480(%rsp), %rdi
	call	wrc_rail_faces_outline@PLT
	movl	%eax, %edi
	leaq	.LC241(%rip), %rsi
	call	done
	leaq	1384(%rsp), %rsi
	movl	$2, %edx
	leaq	.LC242(%rip), %rdi
	call	show
	movq	1400(%rsp), %rax
	leaq	24(%rax), %rsi
	movl	$1, %edx
	leaq	.LC243(%rip), %rdi
	call	show
	movq	480(%rsp), %rdi
	call	wrc_rail_faces_destroy@PLT
	movq	%r14, %rdi
	call	wrc_contact_destroy@PLT
	movq	%r12, %rdi
	call	wrc_contact_destroy@PLT
	movq	(%rsp), %rdi
	call	wrc_model_destroy@PLT
	addq	$9048, %rsp
	popq	%rbx
	popq	%rbp
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	ret
.L139:
	leal	1(%rax), %esi
	pxor	%xmm0, %xmm0
	cvtsi2sdl	%esi, %xmm0
	mulsd	.LC219(%rip), %xmm0
	movl	$39, %ecx
	subl	%eax, %ecx
	pxor	%xmm1, %xmm1
	cvtsi2sdl	%ecx, %xmm1
	mulsd	%xmm1, %xmm0
	divsd	.LC220(%rip), %xmm0
	movsd	%xmm0, (%rdx)
	movl	%esi, %eax
	addq	$8, %rdx
	jmp	.L121
.L108:
	movq	.LC244(%rip), %rax
	movq	%rax, 16(%rbx)
	sete	%al
	movzbl	%al, %eax
	movl	%eax, 32(%rbx)
	movl	$832, 36(%rbx)
	movq	%r13, 40(%rbx)
	addl	$1, %ebp
	addq	$48, %rbx
	addq	$9984, %r13
	jmp	.L110
	.size	experimental, .-experimental
	.section	.rodata.str1.1
.LC245:
	.string	"%s; %s\n"
.LC246:
	.string	"%d %d\n"
.LC247:
	.string	"blocks of memory %d\n"
	.text
	.globl	main
	.type	main, @function
main:
	pushq	%rbx
	movl	$900, %edi
	call	wrc_get_api@PLT
	testq	%rax, %rax
	je	.L141
	movq	%rax, %rbx
	cmpl	$359, (%rax)
	jbe	.L141
	movl	$1, %edi
	call	wrc_get_api@PLT
	testq	%rax, %rax
	jne	.L143
	call	*8(%rbx)
	movl	%eax, %ebx
	call	wrc_version@PLT
	cmpl	%eax, %ebx
	jne	.L143
	call	wrc_abi_version@PLT
	cmpl	$900, %eax
	jne	.L143
	movl	$1, %edi
	call	wrc_status_text@PLT
	movq	%rax, %rbx
	movl	$-4, %edi
	call	wrc_status_name@PLT
	movq	%rax, %rsi
	movq	%rbx, %rdx
	leaq	.LC245(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	call	wrc_build_info@PLT
	cmpb	$0, (%rax)
	setne	%bl
	movzbl	%bl, %ebx
	movl	$900, %edi
	call	wrc_version_text@PLT
	cmpb	$0, (%rax)
	setne	%sil
	movzbl	%sil, %esi
	movl	%ebx, %edx
	leaq	.LC246(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	call	wheel_on_a_rail
	call	remembering
	call	other_rails
	call	posed
	call	given
	movl	blocks(%rip), %esi
	leaq	.LC247(%rip), %rdi
	movl	$0, %eax
	call	printf@PLT
	movl	$1, %edi
	call	wrc_get_experimental_api@PLT
	testq	%rax, %rax
	je	.L145
	call	experimental
.L145:
	movl	$0, %eax
	popq	%rbx
	ret
.L141:
	movl	$2, %edi
	call	exit@PLT
.L143:
	movl	$2, %edi
	call	exit@PLT
	.size	main, .-main
	.local	z.0
	.comm	z.0,960,32
	.local	y.1
	.comm	y.1,960,32
	.local	worn_z.2
	.comm	worn_z.2,16000,32
	.local	worn_y.3
	.comm	worn_y.3,16000,32
	.local	z.4
	.comm	z.4,1920,32
	.local	y.5
	.comm	y.5,1920,32
	.local	depth.6
	.comm	depth.6,1600,32
	.local	arc.7
	.comm	arc.7,1920,32
	.local	slip_y.8
	.comm	slip_y.8,1344,32
	.local	slip_x.9
	.comm	slip_x.9,1344,32
	.local	traction_y.10
	.comm	traction_y.10,1344,32
	.local	traction_x.11
	.comm	traction_x.11,1344,32
	.local	pressure.12
	.comm	pressure.12,1344,32
	.local	gap.13
	.comm	gap.13,1344,32
	.local	bin.14
	.comm	bin.14,29952,32
	.local	bin.15
	.comm	bin.15,38376,32
	.local	values.16
	.comm	values.16,102400,32
	.local	blocks
	.comm	blocks,4,4
	.local	spoken
	.comm	spoken,8,8
	.local	text
	.comm	text,400,32
	.section	.rodata.cst8,"aM",@progbits,8
	.align 8
.LC0:
	.long	0
	.long	1073741824
	.align 8
.LC1:
	.long	536870912
	.long	1110614111
	.align 8
.LC2:
	.long	0
	.long	1078362112
	.align 8
.LC3:
	.long	-858993459
	.long	1071434956
	.align 8
.LC4:
	.long	-68719477
	.long	1073148329
	.align 8
.LC5:
	.long	-1717986918
	.long	1067030937
	.align 8
.LC38:
	.long	-755914244
	.long	1063281229
	.align 8
.LC41:
	.long	0
	.long	1077149696
	.align 8
.LC42:
	.long	-1908874354
	.long	-1069139741
	.align 8
.LC43:
	.long	1202590843
	.long	1065646817
	.align 8
.LC46:
	.long	0
	.long	1089701888
	.align 8
.LC57:
	.long	-755914244
	.long	1062232653
	.align 8
.LC58:
	.long	-1717986918
	.long	1073846681
	.align 8
.LC59:
	.long	0
	.long	1076101120
	.align 8
.LC60:
	.long	1202590843
	.long	1064598241
	.align 8
.LC61:
	.long	-402653184
	.long	1111967862
	.align 8
.LC62:
	.long	1297423721
	.long	1057977616
	.align 8
.LC63:
	.long	-755914244
	.long	1061184077
	.align 8
.LC67:
	.long	-1133871366
	.long	1063818100
	.align 8
.LC68:
	.long	-1717986918
	.long	1070176665
	.align 8
.LC69:
	.long	0
	.long	1089293312
	.align 8
.LC70:
	.long	0
	.long	1072693248
	.align 8
.LC74:
	.long	1717986918
	.long	1071015526
	.align 8
.LC75:
	.long	-350469331
	.long	1058682594
	.align 8
.LC76:
	.long	-1717986918
	.long	1069128089
	.align 8
.LC77:
	.long	-1259857073
	.long	1062948481
	.align 8
.LC81:
	.long	824633721
	.long	-1082348536
	.align 8
.LC84:
	.long	1202590843
	.long	-1081836831
	.align 8
.LC85:
	.long	-1717986918
	.long	1071225241
	.align 8
.LC86:
	.long	0
	.long	1078034432
	.align 8
.LC87:
	.long	810889825
	.long	1060350250
	.align 8
.LC97:
	.long	-1917273401
	.long	1060564998
	.align 8
.LC102:
	.long	0
	.long	1079246848
	.align 8
.LC104:
	.long	0
	.long	-1074790400
	.align 8
.LC105:
	.long	0
	.long	1076035584
	.align 8
.LC106:
	.long	0
	.long	1089541888
	.align 8
.LC107:
	.long	1202590843
	.long	-1080788255
	.align 8
.LC108:
	.long	1202590843
	.long	1066695393
	.align 8
.LC109:
	.long	1413754136
	.long	1075388923
	.align 8
.LC110:
	.long	0
	.long	1067450368
	.align 8
.LC111:
	.long	-1998362383
	.long	1055193269
	.align 8
.LC112:
	.long	0
	.long	1064304640
	.align 8
.LC113:
	.long	858993459
	.long	1073427251
	.align 8
.LC114:
	.long	-343597384
	.long	1067366481
	.align 8
.LC115:
	.long	-350469331
	.long	1057634018
	.align 8
.LC116:
	.long	-1717986918
	.long	-1080452711
	.align 8
.LC117:
	.long	0
	.long	1086492160
	.align 8
.LC118:
	.long	-1456852907
	.long	-1078669293
	.align 8
.LC119:
	.long	-350469331
	.long	1059731170
	.align 8
.LC121:
	.long	-755914244
	.long	1064329805
	.align 8
.LC124:
	.long	-2147483648
	.long	1105517715
	.align 8
.LC127:
	.long	0
	.long	1078853632
	.align 8
.LC131:
	.long	0
	.long	1076625408
	.align 8
.LC132:
	.long	1202590843
	.long	-1079739679
	.align 8
.LC133:
	.long	0
	.long	1071644672
	.align 8
.LC141:
	.long	0
	.long	1078198272
	.align 8
.LC146:
	.long	0
	.long	1075052544
	.align 8
.LC147:
	.long	0
	.long	1076232192
	.align 8
.LC149:
	.long	0
	.long	1074266112
	.align 8
.LC150:
	.long	0
	.long	1075970048
	.align 8
.LC151:
	.long	0
	.long	1075183616
	.align 8
.LC152:
	.long	0
	.long	1085227008
	.align 8
.LC162:
	.long	343597384
	.long	1070679982
	.align 8
.LC163:
	.long	858993459
	.long	1070805811
	.align 8
.LC164:
	.long	0
	.long	1073217536
	.align 8
.LC170:
	.long	0
	.long	1100470148
	.align 8
.LC171:
	.long	0
	.long	1086224384
	.align 8
.LC174:
	.long	-350469331
	.long	1062876898
	.align 8
.LC175:
	.long	27487791
	.long	-1081997892
	.align 8
.LC176:
	.long	1594291861
	.long	-1081783144
	.align 8
.LC193:
	.long	-1133871366
	.long	1062769524
	.align 8
.LC195:
	.long	-755914244
	.long	1065378381
	.align 8
.LC196:
	.long	-1717986918
	.long	1068079513
	.align 8
.LC197:
	.long	515396076
	.long	1068624773
	.align 8
.LC198:
	.long	-343597384
	.long	1069463633
	.align 8
.LC199:
	.long	515396076
	.long	1070721925
	.align 8
.LC200:
	.long	171798692
	.long	1070638039
	.align 8
.LC201:
	.long	-687194767
	.long	1070428323
	.align 8
.LC202:
	.long	-2061584302
	.long	1070092779
	.align 8
.LC203:
	.long	-1133871366
	.long	1064866676
	.align 8
.LC214:
	.long	1202590843
	.long	1063549665
	.align 8
.LC218:
	.long	-652835029
	.long	1068758990
	.align 8
.LC219:
	.long	-500134854
	.long	1044740494
	.align 8
.LC220:
	.long	0
	.long	1081671680
	.align 8
.LC223:
	.long	-1717986918
	.long	-1078355559
	.align 8
.LC224:
	.long	0
	.long	1084178432
	.align 8
.LC230:
	.long	1216334738
	.long	1063091647
	.align 8
.LC244:
	.long	-343597384
	.long	1070512209
	.ident	"GCC: (Debian 12.2.0-14+deb12u1) 12.2.0"
	.section	.note.GNU-stack,"",@progbits
