using System.Numerics;
using System.Reflection;
using System.Text.Json;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>
/// One parameter of a <see cref="RecordType"/>: a property of a description record that has a <see cref="ParameterAttribute"/>.
/// </summary>
public sealed class RecordParameter
{
    private const BindingFlags AllFields = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    private readonly PropertyInfo _property;
    private readonly ParameterAttribute _attribute;
    private readonly NamedValues? _values;
    private readonly Type _part;
    private readonly bool _hasParameters;

    internal RecordParameter(PropertyInfo property, ParameterAttribute attribute, object? defaults)
    {
        _property = property;
        _attribute = attribute;
        Key = JsonNamingPolicy.CamelCase.ConvertName(property.Name);
        ValueType = Nullable.GetUnderlyingType(property.PropertyType) ?? property.PropertyType;
        Type? generic = ValueType.IsGenericType ? ValueType.GetGenericTypeDefinition() : null;
        (IsList, HasNames) = (generic == typeof(IReadOnlyList<>), generic == typeof(IReadOnlyDictionary<,>));
        _part = IsList || HasNames ? ValueType.GetGenericArguments()[^1] : ValueType;
        _hasParameters = _part.GetProperties().Any(p => p.IsDefined(typeof(ParameterAttribute)));
        _values = NamedValues.Of(ValueType);
        Default = defaults is null ? null : property.GetValue(defaults);
    }

    /// <summary>The key in scene files.</summary>
    public string Key { get; }

    /// <summary>The name of the C# property.</summary>
    public string PropertyName => _property.Name;

    /// <summary>The meaning of the parameter.</summary>
    public string Summary => _attribute.Summary;

    /// <summary>The unit; empty where there is none.</summary>
    public string Unit => _attribute.Unit;

    /// <summary>The smallest allowed value of each number; minus infinity where there is no bound.</summary>
    public double Minimum => _attribute.Minimum;

    /// <summary>The largest allowed value of each number; infinity where there is no bound.</summary>
    public double Maximum => _attribute.Maximum;

    /// <summary>True where <see cref="Minimum"/> itself is refused.</summary>
    public bool MinimumIsExclusive => _attribute.MinimumIsExclusive;

    /// <summary>True where a scene file must give the parameter.</summary>
    public bool Required => _attribute.Required;

    /// <summary>True where a number may stand in place of a texture; or a number or a colour in place of a list of numbers.</summary>
    public bool IsNumber => _attribute.IsNumber;

    /// <summary>True where the text is the path of a file, relative to the scene file's folder.</summary>
    public bool IsFile => _attribute.IsFile;

    /// <summary>True for a whole number.</summary>
    public bool IsInteger => ValueType == typeof(int) || ValueType == typeof(long);

    /// <summary>True where its value is a list.</summary>
    public bool IsList { get; }

    /// <summary>True where its value is a map from names to things.</summary>
    public bool HasNames { get; }

    /// <summary>True where its value is an object of parameters, without a type.</summary>
    public bool IsRecord => RecordType is not null && !IsList;

    /// <summary>True where its value consists of things or records: a list of them, or a map from names.</summary>
    public bool HoldsRecords => (IsList || HasNames) && (Family is not null || RecordType is not null);

    /// <summary>The C# type of the value, without the question mark of one that may be missing.</summary>
    public Type ValueType { get; }

    /// <summary>The C# type of the record, or of each record of the list; null for other values.</summary>
    public Type? RecordType => _hasParameters && Family is null ? _part : null;

    /// <summary>The value that a new record has; null where it may be missing.</summary>
    public object? Default { get; }

    /// <summary>The things of which its value is one, or has several; null for other values.</summary>
    public TypeFamily? Family => SceneTypes.Families.FirstOrDefault(f => f.Base == _part);

    /// <summary>The words that a choice is made from; otherwise empty.</summary>
    public IReadOnlyList<string> Choices => _values?.Names ?? [];

    /// <summary>The allowed range in words ("at least 0", "from 0 to 1"); empty where every number is allowed.</summary>
    public string Range
    {
        get
        {
            if (double.IsNegativeInfinity(Minimum))
            {
                return double.IsPositiveInfinity(Maximum) ? "" : $"at most {Maximum}";
            }

            if (double.IsPositiveInfinity(Maximum))
            {
                return MinimumIsExclusive ? $"greater than {Minimum}" : $"at least {Minimum}";
            }

            return MinimumIsExclusive ? $"greater than {Minimum} and at most {Maximum}" : $"from {Minimum} to {Maximum}";
        }
    }

    /// <summary>The parameter's value in a record.</summary>
    public object? Get(object record) => _property.GetValue(record);

    /// <summary>Says why a value is out of range, as the end of a sentence that begins with its key; null where it is not.</summary>
    /// <param name="value">A number, vector, colour, or texture (of which all colours are checked); anything else is in range.</param>
    public string? RangeComplaint(object? value)
    {
        foreach (double number in Numbers(value))
        {
            if (RangeComplaint(number, Written(number)) is { } complaint)
            {
                return complaint;
            }
        }

        return null;
    }

    /// <summary>The value of one of <see cref="Choices"/>, whose letters may be small or capital; null where there is none.</summary>
    public object? Choice(string word) => _values?.Find(word);

    /// <summary>
    /// As <see cref="RangeComplaint(object?)"/>; null is at fault, too, alone or in a list, where a new record has another value.
    /// </summary>
    internal string? Complaint(object? value) => value is null && Default is not null ? "must not be null"
        : RecordsIn(value).Contains(null!) ? "must not hold null"
        : RangeComplaint(value);

    /// <summary>The records that a value is, or consists of.</summary>
    internal IEnumerable<object> RecordsIn(object? value) => value switch
    {
        null or string => [],
        IReadOnlyDictionary<string, TextureDescription> named => named.Values,
        IReadOnlyDictionary<string, MaterialDescription> named => named.Values,
        IReadOnlyDictionary<string, ShapeDescription> named => named.Values,
        IEnumerable<object> list => list,
        _ => IsRecord || Family is not null ? [value] : [],
    };

    /// <summary>Gives a record that is being made the parameter's value.</summary>
    public void Set(object record, object? value) => _property.SetValue(record, value);

    // Bounds are compared as floats where values are floats, so that a written bound is itself in range.
    internal string? RangeComplaint(double value, string written)
    {
        if (!double.IsFinite(value))
        {
            return $"must be {(Range.Length > 0 ? Range : "a finite number")}, but is {written}";
        }

        double minimum = IsInteger ? Minimum : (float)Minimum;
        double maximum = IsInteger ? Maximum : (float)Maximum;
        if ((MinimumIsExclusive ? value > minimum : value >= minimum) && value <= maximum)
        {
            return null;
        }

        bool isRounded = value == 0 && written.AsSpan().ContainsAnyInRange('1', '9');
        return $"must be {Range}, but {(isRounded ? $"{written} rounds to 0" : $"is {written}")}";
    }

    private static string Written(double number) => double.IsInteger(number) && Math.Abs(number) < 1e15 ? $"{(long)number}"
        : number == (float)number ? $"{(float)number}" : $"{number}";

    // Lists of numbers without a range may be large, and belong to those who mend meshes and matrices.
    private IEnumerable<double> Numbers(object? value) => value switch
    {
        float f => [f],
        int i => [i],
        long l => [l],
        IReadOnlyList<float> list when Range.Length > 0 => list.Select(f => (double)f),
        Vector2 v => [v.X, v.Y],
        Vector3 v => [v.X, v.Y, v.Z],
        Rgb c => [c.R, c.G, c.B],
        TextureDescription t => Description.RecordType.WithParts(t).Select(p => p.Record).OfType<SolidTextureDescription>().SelectMany(s => Numbers(s.Color)),
        not null when value.GetType() is { IsValueType: true, IsPrimitive: false, IsEnum: false } type => type.GetFields(AllFields).SelectMany(f => Numbers(f.GetValue(value))),
        _ => [],
    };
}
