using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace RayTracer.Repository.Tests.Packages;

/// <summary>Lists what other assemblies see of one: its public types with their public and protected members.</summary>
internal static class PublicApi
{
    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    private static readonly Dictionary<Type, string> s_keywords = new()
    {
        [typeof(bool)] = "bool",
        [typeof(byte)] = "byte",
        [typeof(sbyte)] = "sbyte",
        [typeof(short)] = "short",
        [typeof(ushort)] = "ushort",
        [typeof(int)] = "int",
        [typeof(uint)] = "uint",
        [typeof(long)] = "long",
        [typeof(ulong)] = "ulong",
        [typeof(float)] = "float",
        [typeof(double)] = "double",
        [typeof(char)] = "char",
        [typeof(string)] = "string",
        [typeof(object)] = "object",
        [typeof(void)] = "void",
    };

    private static readonly Dictionary<string, string> s_operators = new(StringComparer.Ordinal)
    {
        ["op_Addition"] = "+",
        ["op_Subtraction"] = "-",
        ["op_UnaryNegation"] = "-",
        ["op_Multiply"] = "*",
        ["op_Division"] = "/",
        ["op_Modulus"] = "%",
        ["op_BitwiseAnd"] = "&",
        ["op_BitwiseOr"] = "|",
        ["op_ExclusiveOr"] = "^",
        ["op_OnesComplement"] = "~",
        ["op_LogicalNot"] = "!",
        ["op_LeftShift"] = "<<",
        ["op_RightShift"] = ">>",
        ["op_UnsignedRightShift"] = ">>>",
        ["op_Equality"] = "==",
        ["op_Inequality"] = "!=",
        ["op_LessThan"] = "<",
        ["op_GreaterThan"] = ">",
        ["op_LessThanOrEqual"] = "<=",
        ["op_GreaterThanOrEqual"] = ">=",
        ["op_Implicit"] = "implicit",
        ["op_Explicit"] = "explicit",
    };

    /// <summary>Returns the lines of all types, in the order of the types' names.</summary>
    public static IEnumerable<string> Of(Assembly assembly) => assembly.GetExportedTypes().OrderBy(Full, StringComparer.Ordinal).SelectMany(Of);

    /// <summary>Returns the line of a type and those of its members, sorted.</summary>
    public static IEnumerable<string> Of(Type type)
    {
        string full = Full(type);
        IEnumerable<string> members = type.GetMembers(Declared).Where(m => !m.IsDefined(typeof(CompilerGeneratedAttribute))).Select(Member).OfType<string>();
        return members.Select(m => $"{full}.{m}").Order(StringComparer.Ordinal).Prepend(Header(type));
    }

    private static string Header(Type type)
    {
        bool isRecord = type.GetMethod("PrintMembers", Declared) is not null;
        string kind = type switch
        {
            { IsEnum: true } => $"enum {Full(type)} : {Name(Enum.GetUnderlyingType(type))}",
            { IsInterface: true } => "interface",
            { IsValueType: true } => isRecord ? "record struct" : "struct",
            _ when type.IsSubclassOf(typeof(Delegate)) => "delegate",
            { IsAbstract: true, IsSealed: true } => "static class",
            _ => (type.IsAbstract ? "abstract " : type.IsSealed ? "sealed " : "") + (isRecord ? "record" : "class"),
        };
        if (type.IsEnum)
        {
            return kind;
        }

        IEnumerable<Type> bases = (type.BaseType is { } ancestor && ancestor != typeof(object) && ancestor != typeof(ValueType) ? [ancestor] : Type.EmptyTypes)
            .Concat(type.GetInterfaces().Where(i => i.IsVisible && !IsInherited(type, i) && !(isRecord && i == typeof(IEquatable<>).MakeGenericType(type))));
        string after = string.Join(", ", bases.Select(Name).Order(StringComparer.Ordinal));
        return $"{kind} {Full(type)}{(after.Length > 0 ? $" : {after}" : "")}{string.Concat(type.GetGenericArguments().Select(Constraint))}";
    }

    private static bool IsInherited(Type type, Type contract) => type.BaseType?.GetInterfaces().Contains(contract) == true
        || type.GetInterfaces().Any(i => i != contract && i.GetInterfaces().Contains(contract));

    private static string? Member(MemberInfo member) => member switch
    {
        FieldInfo field when IsSeen(field) && !field.IsSpecialName => Field(field),
        ConstructorInfo { IsStatic: false } constructor when IsSeen(constructor) =>
            $"{Access(constructor)}{constructor.DeclaringType!.Name.Split('`')[0]}({Parameters(constructor)})",
        PropertyInfo property when property.GetAccessors(nonPublic: true).FirstOrDefault(IsSeen) is { } accessor && !IsOverride(accessor) => Property(property, accessor),
        EventInfo { AddMethod: { } add } raised when IsSeen(add) => $"{Access(add)}event {raised.Name} : {Name(raised.EventHandlerType!)}",
        MethodInfo method when IsSeen(method) && !IsOverride(method) && (!method.IsSpecialName || s_operators.ContainsKey(method.Name)) => Method(method),
        _ => null,
    };

    private static string Field(FieldInfo field) => field switch
    {
        { DeclaringType.IsEnum: true } => $"{field.Name} = {Convert.ToString(field.GetRawConstantValue(), CultureInfo.InvariantCulture)}",
        { IsLiteral: true } => $"{field.Name} : {Name(field.FieldType)} = {Value(field.GetRawConstantValue())}",
        _ => $"{(field.IsPublic ? "" : "protected ")}{(field.IsStatic ? "static " : "")}{(field.IsInitOnly ? "readonly " : "")}{field.Name} : {Name(field.FieldType)}",
    };

    private static string Property(PropertyInfo property, MethodInfo accessor)
    {
        string set = property.SetMethod is { } setter && IsSeen(setter)
            ? setter.ReturnParameter.GetRequiredCustomModifiers().Contains(typeof(IsExternalInit)) ? " init;" : " set;" : "";
        string index = string.Join(", ", property.GetIndexParameters().Select(p => Name(p.ParameterType)));
        bool isRequired = property.IsDefined(typeof(RequiredMemberAttribute));
        return $"{Access(accessor)}{(isRequired ? "required " : "")}{property.Name}{(index.Length > 0 ? $"[{index}]" : "")} : {Name(property.PropertyType)} "
            + $"{{{(property.GetMethod is { } getter && IsSeen(getter) ? " get;" : "")}{set} }}";
    }

    private static string Method(MethodInfo method)
    {
        string name = s_operators.TryGetValue(method.Name, out string? symbol) ? $"operator {symbol}" : method.Name;
        Type[] generic = method.GetGenericArguments();
        string arguments = generic.Length > 0 ? $"<{string.Join(", ", generic.Select(Name))}>" : "";
        return $"{Access(method)}{name}{arguments}({Parameters(method)}) : {Name(method.ReturnType)}{string.Concat(generic.Select(Constraint))}";
    }

    private static bool IsSeen(MethodBase method) => method.IsPublic || (IsProtected(method.IsFamily || method.IsFamilyOrAssembly, method.DeclaringType!));

    private static bool IsSeen(FieldInfo field) => field.IsPublic || (IsProtected(field.IsFamily || field.IsFamilyOrAssembly, field.DeclaringType!));

    // Nobody can derive from a sealed class.
    private static bool IsProtected(bool isFamily, Type type) => isFamily && !type.IsSealed;

    private static bool IsOverride(MethodInfo method) => method.GetBaseDefinition() != method;

    private static string Access(MethodBase method)
    {
        string kind = method.IsStatic ? "static " : method.DeclaringType!.IsInterface || method.IsConstructor ? ""
            : method.IsAbstract ? "abstract " : method is { IsVirtual: true, IsFinal: false } && !method.DeclaringType!.IsSealed ? "virtual " : "";
        return (method.IsPublic ? "" : "protected ") + kind;
    }

    private static string Parameters(MethodBase method) => string.Join(", ", method.GetParameters().Select(p =>
    {
        string by = !p.ParameterType.IsByRef ? p.IsDefined(typeof(ParamArrayAttribute)) || p.IsDefined(typeof(ParamCollectionAttribute)) ? "params " : ""
            : p.IsOut ? "out " : p.IsIn ? "in " : "ref ";
        return $"{by}{Name(p.ParameterType)} {p.Name}{(p.HasDefaultValue ? $" = {Value(p.DefaultValue)}" : "")}";
    }));

    private static string Constraint(Type parameter)
    {
        GenericParameterAttributes special = parameter.GenericParameterAttributes;
        bool isStruct = special.HasFlag(GenericParameterAttributes.NotNullableValueTypeConstraint);
        string[] all =
        [
            .. special.HasFlag(GenericParameterAttributes.ReferenceTypeConstraint) ? ["class"] : isStruct ? new[] { "struct" } : [],
            .. parameter.GetGenericParameterConstraints().Where(c => c != typeof(ValueType)).Select(Name),
            .. special.HasFlag(GenericParameterAttributes.DefaultConstructorConstraint) && !isStruct ? new[] { "new()" } : [],
        ];
        return all.Length > 0 ? $" where {parameter.Name} : {string.Join(", ", all)}" : "";
    }

    private static string Full(Type type) => $"{(type.DeclaringType is { } outer ? Full(outer) : type.Namespace)}.{OwnName(type)}";

    private static string Name(Type type) => type switch
    {
        { IsByRef: true } => Name(type.GetElementType()!),
        { IsArray: true } => $"{Name(type.GetElementType()!)}[{new string(',', type.GetArrayRank() - 1)}]",
        { IsPointer: true } => $"{Name(type.GetElementType()!)}*",
        _ when Nullable.GetUnderlyingType(type) is { } inner => $"{Name(inner)}?",
        { IsGenericParameter: true } => type.Name,
        _ when s_keywords.TryGetValue(type, out string? keyword) => keyword,
        _ => OwnName(type),
    };

    private static string OwnName(Type type)
    {
        string name = type.Name.Split('`')[0];
        IEnumerable<Type> own = type.GetGenericArguments().Skip(type.DeclaringType?.GetGenericArguments().Length ?? 0);
        return own.Any() ? $"{name}<{string.Join(", ", own.Select(Name))}>" : name;
    }

    private static string Value(object? value) => value switch
    {
        null => "null",
        string text => $"\"{text}\"",
        bool truth => truth ? "true" : "false",
        _ => Convert.ToString(value, CultureInfo.InvariantCulture)!,
    };
}
