using System.Reflection;
using System.Text.Json;

namespace RayTracer.Description;

/// <summary>The values of a type that scene files and options choose by name: those of an enumeration, or those in a <see cref="Registry{T}"/>.</summary>
public abstract class NamedValues
{
    /// <summary>The values, in the order in which they are listed.</summary>
    public abstract IReadOnlyList<object> All { get; }

    /// <summary>The names of the values, in their order.</summary>
    public IReadOnlyList<string> Names => [.. All.Select(NameOf)];

    /// <summary>The values of a type; null where it is neither an enumeration nor open.</summary>
    public static NamedValues? Of(Type type) => type.IsEnum ? new Enumeration(type)
        : type.IsSubclassOf(typeof(NamedValue)) ? (NamedValues)type.GetProperty("Known", BindingFlags.Public | BindingFlags.Static | BindingFlags.FlattenHierarchy)!.GetValue(null)!
        : null;

    /// <summary>The name of a value, as scene files have it.</summary>
    public static string NameOf(object value) => JsonNamingPolicy.CamelCase.ConvertName($"{value}");

    /// <summary>The value of a name, whose letters may be small or capital; null where there is none.</summary>
    public virtual object? Find(string name) => All.FirstOrDefault(v => NameOf(v).Equals(name, StringComparison.OrdinalIgnoreCase));

    /// <summary>Registers one value of each class of an assembly that derives from a <see cref="NamedValue"/> and has a constructor that takes nothing.</summary>
    /// <exception cref="ArgumentException">A name is taken, or cannot stand in scene files.</exception>
    public static void RegisterAll(Assembly assembly)
    {
        foreach (Type type in assembly.GetTypes().Where(t => !t.IsAbstract && t.IsSubclassOf(typeof(NamedValue)) && t.GetConstructor(Type.EmptyTypes) is not null))
        {
            Of(type)!.Add((NamedValue)Activator.CreateInstance(type)!);
        }
    }

    private protected abstract void Add(NamedValue value);

    private sealed class Enumeration(Type type) : NamedValues
    {
        public override IReadOnlyList<object> All { get; } = [.. Enum.GetValues(type).Cast<object>()];

        private protected override void Add(NamedValue value) => throw new NotSupportedException();
    }
}
