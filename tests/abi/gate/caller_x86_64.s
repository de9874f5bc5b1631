	.file	"caller.c"
	.text
	.section	.rodata.str1.1,"aMS",@progbits,1
.LC0:
	.string	"%s %.17g\n"
	.text
	.type	bits, @function
bits:
	subq	$8, %rsp
	movq	%rdi, %rsi
	leaq	.LC0(%rip), %rdi
	movl	$1, %eax
	call	printf@PLT
	addq	$8, %rsp
	ret
	.size	bits, .-bits
	.section	.rodata.str1.1
.LC5:
	.string	"y"
.LC6:
	.string	"peak pressure"
.LC7:
	.string	"fy"
.LC8:
	.string	"t_gamma"
.LC9:
	.string	"patch"
.LC10:
	.string	"traction"
.LC15:
	.string	"force"
.LC16:
	.string	"steepest"
.LC17:
	.string	"stiffness"
.LC18:
	.string	"spin"
	.text
	.globl	main
	.type	main, @function
main:
	pushq	%rbp
	pushq	%rbx
	subq	$3784, %rsp
	movl	$2, %edi
	call	wrc_get_api@PLT
	testq	%rax, %rax
	je	.L5
	movq	%rax, %rbx
	movl	$2, %ebp
	cmpl	$919, (%rax)
	jbe	.L3
	movq	%rsp, %rbp
	movl	$50, %ecx
	movl	$0, %eax
	movq	%rbp, %rdi
	rep stosq
	movl	$400, (%rsp)
	movq	%rbp, %rdi
	call	wrc_config_init@PLT
	leaq	3376(%rsp), %rdi
	movl	$50, %ecx
	movq	%rbp, %rsi
	rep movsq
	movl	$2, 3384(%rsp)
	movl	$4, 3416(%rsp)
	movl	$40, 3592(%rsp)
	movl	$2, 3640(%rsp)
	movq	$0, 3368(%rsp)
	movq	$0, 3360(%rsp)
	leaq	3368(%rsp), %rdx
	leaq	3376(%rsp), %rdi
	movl	$0, %esi
	call	wrc_model_create@PLT
	testl	%eax, %eax
	js	.L7
	leaq	3360(%rsp), %rcx
	movl	$0, %edx
	movl	$1, %esi
	movq	3368(%rsp), %rdi
	call	*192(%rbx)
	testl	%eax, %eax
	js	.L8
	movq	%rsp, %rbx
	leaq	4(%rsp), %rdx
	movl	$63, %ebp
	movl	$0, %eax
	movq	%rdx, %rdi
	movq	%rbp, %rcx
	rep stosl
	movq	%rcx, %rbp
	movl	$256, (%rsp)
	movq	%rbx, %rdi
	call	wrc_input_init@PLT
	leaq	3104(%rsp), %rdi
	movl	$32, %ecx
	movq	%rbx, %rsi
	rep movsq
	movl	$43, %ecx
	movq	%rbx, %rdi
	movq	%rbp, %rax
	rep stosq
	movl	$344, (%rsp)
	movq	%rbx, %rdi
	call	wrc_output_init@PLT
	leaq	2752(%rsp), %rdi
	movl	$43, %ecx
	movq	%rbx, %rsi
	rep movsq
	movq	.LC1(%rip), %rax
	movq	%rax, 3112(%rsp)
	movq	.LC2(%rip), %rax
	movq	%rax, 3152(%rsp)
	movq	.LC3(%rip), %rax
	movq	%rax, 3192(%rsp)
	movq	.LC4(%rip), %rax
	movq	%rax, 3232(%rsp)
	leaq	2752(%rsp), %rdx
	leaq	3104(%rsp), %rsi
	movq	3360(%rsp), %rdi
	call	wrc_contact_step@PLT
	testl	%eax, %eax
	jne	.L9
	movsd	2768(%rsp), %xmm0
	leaq	.LC5(%rip), %rdi
	call	bits
	movsd	2912(%rsp), %xmm0
	leaq	.LC6(%rip), %rdi
	call	bits
	movsd	2968(%rsp), %xmm0
	leaq	.LC7(%rip), %rdi
	call	bits
	movsd	3032(%rsp), %xmm0
	leaq	.LC8(%rip), %rdi
	call	bits
	leaq	4(%rsp), %rdx
	movl	$51, %ecx
	movl	$0, %eax
	movq	%rdx, %rdi
	rep stosl
	movl	$208, (%rsp)
	movq	%rbx, %rdi
	call	wrc_patch_init@PLT
	leaq	2544(%rsp), %rdi
	movl	$52, %ecx
	movq	%rbx, %rsi
	rep movsl
	leaq	2544(%rsp), %rdx
	movl	$0, %esi
	movq	3360(%rsp), %rdi
	call	wrc_contact_patch@PLT
	testl	%eax, %eax
	jne	.L10
	leaq	2496(%rsp), %rcx
	movl	$3, %edx
	movl	$0, %esi
	movq	3360(%rsp), %rdi
	call	wrc_contact_field@PLT
	testl	%eax, %eax
	jne	.L11
	movsd	2568(%rsp), %xmm0
	leaq	.LC9(%rip), %rdi
	call	bits
	movq	2512(%rsp), %rax
	shrq	%rax
	imulq	2528(%rsp), %rax
	imulq	$3, 2520(%rsp), %rdx
	addq	%rdx, %rax
	movq	2496(%rsp), %rdx
	movsd	(%rdx,%rax,8), %xmm0
	leaq	.LC10(%rip), %rdi
	call	bits
	movl	$45, %ecx
	movl	$0, %eax
	movq	%rbx, %rdi
	rep stosq
	movl	$360, (%rsp)
	movq	%rbx, %rdi
	call	wrc_wheel_input_init@PLT
	leaq	2128(%rsp), %rdi
	movl	$45, %ecx
	movq	%rbx, %rsi
	rep movsq
	leaq	4(%rsp), %rdx
	movl	$39, %ecx
	movl	$0, %eax
	movq	%rdx, %rdi
	rep stosl
	movl	$160, (%rsp)
	movq	%rbx, %rdi
	call	wrc_wrench_init@PLT
	leaq	1968(%rsp), %rdi
	movl	$40, %ecx
	movq	%rbx, %rsi
	rep movsl
	movq	.LC11(%rip), %rax
	movq	%rax, 2160(%rsp)
	movq	.LC1(%rip), %rax
	movq	%rax, 2176(%rsp)
	movq	.LC12(%rip), %rax
	movq	%rax, 2192(%rsp)
	movq	.LC13(%rip), %rax
	movq	%rax, 2224(%rsp)
	movq	.LC14(%rip), %rax
	movq	%rax, 2424(%rsp)
	leaq	896(%rsp), %rcx
	leaq	1968(%rsp), %rdx
	leaq	2128(%rsp), %rsi
	movq	3360(%rsp), %rdi
	call	wrc_contact_wrench_sensitivities@PLT
	testl	%eax, %eax
	jne	.L12
	movsd	2000(%rsp), %xmm0
	leaq	.LC15(%rip), %rdi
	call	bits
	movsd	2120(%rsp), %xmm0
	leaq	.LC16(%rip), %rdi
	call	bits
	movsd	1208(%rsp), %xmm0
	leaq	.LC17(%rip), %rdi
	call	bits
	leaq	4(%rsp), %rdx
	movl	$47, %ecx
	movl	$0, %eax
	movq	%rdx, %rdi
	rep stosl
	movl	$192, (%rsp)
	movq	%rbx, %rdi
	call	wrc_region_init@PLT
	leaq	704(%rsp), %rdi
	movl	$48, %ecx
	movq	%rbx, %rsi
	rep movsl
	leaq	704(%rsp), %rdx
	movl	$0, %esi
	movq	3360(%rsp), %rdi
	call	wrc_contact_region@PLT
	testl	%eax, %eax
	jne	.L13
	movsd	872(%rsp), %xmm0
	leaq	.LC18(%rip), %rdi
	call	bits
	movq	.LC19(%rip), %rax
	movq	%rax, 3152(%rsp)
	leaq	2752(%rsp), %rdx
	leaq	3104(%rsp), %rsi
	movq	3360(%rsp), %rdi
	call	wrc_contact_step@PLT
	movl	$9, %ebp
	cmpl	$-4, %eax
	jne	.L3
	leaq	400(%rsp), %rsi
	movl	$300, %edx
	movq	3360(%rsp), %rdi
	call	wrc_contact_last_error@PLT
	movl	%eax, %ebp
	testl	%eax, %eax
	jne	.L15
	leaq	400(%rsp), %rdi
	call	puts@PLT
	movq	3360(%rsp), %rdi
	call	wrc_contact_destroy@PLT
	movq	3368(%rsp), %rdi
	call	wrc_model_destroy@PLT
	jmp	.L3
.L5:
	movl	$2, %ebp
	jmp	.L3
.L7:
	movl	$3, %ebp
	jmp	.L3
.L8:
	movl	$3, %ebp
.L3:
	movl	%ebp, %eax
	addq	$3784, %rsp
	popq	%rbx
	popq	%rbp
	ret
.L9:
	movl	$4, %ebp
	jmp	.L3
.L10:
	movl	$5, %ebp
	jmp	.L3
.L11:
	movl	$6, %ebp
	jmp	.L3
.L12:
	movl	$7, %ebp
	jmp	.L3
.L13:
	movl	$8, %ebp
	jmp	.L3
.L15:
	movl	$10, %ebp
	jmp	.L3
	.size	main, .-main
	.section	.rodata.cst8,"aM",@progbits,8
	.align 8
.LC1:
	.long	-755914244
	.long	1063281229
	.align 8
.LC2:
	.long	0
	.long	1089701888
	.align 8
.LC3:
	.long	-350469331
	.long	1060779746
	.align 8
.LC4:
	.long	1717986918
	.long	1071015526
	.align 8
.LC11:
	.long	810889825
	.long	1060350250
	.align 8
.LC12:
	.long	0
	.long	1077149696
	.align 8
.LC13:
	.long	-1493901668
	.long	-1069171401
	.align 8
.LC14:
	.long	-1717986918
	.long	1069128089
	.align 8
.LC19:
	.long	0
	.long	1079246848
	.ident	"GCC: (Debian 12.2.0-14+deb12u1) 12.2.0"
	.section	.note.GNU-stack,"",@progbits
