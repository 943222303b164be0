using System.Reflection;

namespace RayTracer.Desktop.Tests;

/// <summary>Answers an interface's calls with nothing: zeros, empty lists, and stubs again where interfaces are asked for.</summary>
public class Stub : DispatchProxy
{
    private Func<MethodInfo, object?[], (bool, object?)>? _answer;

    internal static T Of<T>(Func<MethodInfo, object?[], (bool IsAnswered, object? Answer)>? answer = null)
        where T : class => (T)Of(typeof(T), answer);

    internal static object Of(Type type, Func<MethodInfo, object?[], (bool, object?)>? answer = null)
    {
        object stub = Create(type, typeof(Stub));
        ((Stub)stub)._answer = answer;
        return stub;
    }

    protected override object? Invoke(MethodInfo? targetMethod, object?[]? args)
    {
        if (_answer?.Invoke(targetMethod!, args ?? []) is (true, var answer))
        {
            return answer;
        }

        Type type = targetMethod!.ReturnType;
        return type == typeof(void) ? null
            : type.IsValueType ? Activator.CreateInstance(type)
            : type.IsInterface && type.IsGenericType && type.GetGenericTypeDefinition() is var g && (g == typeof(IEnumerable<>) || g == typeof(IReadOnlyList<>)) ? Array.CreateInstance(type.GetGenericArguments()[0], 0)
            : type.IsInterface ? Of(type)
            : null;
    }
}
