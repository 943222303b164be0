using System.Reflection;
using System.Text.Json;

namespace RayTracer.Description;

/// <summary>
/// The values of a type that are chosen by name: those of an enumeration, or those in the <see cref="Registry{T}"/> that is the static
/// property
/// <c>Known</c> of an open type.
/// </summary>
public abstract class NamedValues
{
    /// <summary>The values, in the order in which they are listed.</summary>
    public abstract IReadOnlyList<object> All { get; }

    /// <summary>The names of the values, in their order.</summary>
    public abstract IReadOnlyList<string> Names { get; }

    /// <summary>Returns the values of a type; null where it is neither an enumeration nor open.</summary>
    public static NamedValues? Of(Type type) => type.IsEnum ? new Enumeration(type)
        : type.GetProperty("Known", BindingFlags.Public | BindingFlags.Static | BindingFlags.FlattenHierarchy)?.GetValue(null) as NamedValues;

    /// <summary>Returns the name that scene files have for a value of an enumeration, or for a <see cref="NamedValue"/>.</summary>
    public static string NameOf(object value) => JsonNamingPolicy.CamelCase.ConvertName($"{value}");

    /// <summary>Returns the value of a name, whatever its case; null where there is none.</summary>
    public abstract object? Find(string name);

    private sealed class Enumeration(Type type) : NamedValues
    {
        public override IReadOnlyList<object> All { get; } = [.. Enum.GetValues(type).Cast<object>()];

        public override IReadOnlyList<string> Names { get; } = [.. Enum.GetNames(type).Select(NameOf)];

        public override object? Find(string name) => All.FirstOrDefault(v => NameOf(v).Equals(name, StringComparison.OrdinalIgnoreCase));
    }
}

/// <summary>A value of an open set that scene files choose by its name, such as an integrator or a sampler.</summary>
public abstract class NamedValue
{
    /// <summary>Gives a value its name.</summary>
    /// <param name="name">The name in scene files: letters and digits in camelCase.</param>
    /// <exception cref="ArgumentException">The name cannot stand in scene files.</exception>
    protected NamedValue(string name) =>
        Name = char.IsAsciiLetterLower(name.FirstOrDefault()) && name.All(char.IsAsciiLetterOrDigit) ? name
            : throw new ArgumentException($"{Quotation.Of(name)} is no name for scene files: those are letters and digits, a small letter first.", nameof(name));

    /// <summary>The name in scene files.</summary>
    public string Name { get; }

    /// <inheritdoc/>
    public sealed override string ToString() => Name;
}
