namespace RayTracer.Description;

/// <summary>
/// A value that scene files choose by its name, of a set that programs may add to: an integrator, a sampler. The base class of such a set has a static
/// property <c>Known</c>, a <see cref="Registry{T}"/> of its values.
/// </summary>
/// <param name="name">The name in scene files, in camelCase.</param>
public abstract class NamedValue(string name)
{
    /// <summary>The name in scene files.</summary>
    public string Name { get; } = name;

    /// <inheritdoc/>
    public sealed override string ToString() => Name;
}

/// <summary>The known values of an open set. Those that programs register belong to it for good, and are known to all that is read afterwards.</summary>
/// <typeparam name="T">The base class of the values.</typeparam>
/// <param name="noun">What each value is, as messages call it.</param>
/// <param name="first">The values that are always known.</param>
public sealed class Registry<T>(string noun, params T[] first) : NamedValues
    where T : NamedValue
{
    private readonly Lock _lock = new();
    private volatile T[] _all = first;

    /// <inheritdoc/>
    public override IReadOnlyList<T> All => _all;

    /// <inheritdoc/>
    public override T? Find(string name) => (T?)base.Find(name);

    /// <summary>Makes a value known.</summary>
    /// <exception cref="ArgumentException">Its name is taken, or cannot stand in scene files.</exception>
    public void Register(T value)
    {
        lock (_lock)
        {
            if (!char.IsAsciiLetterLower(value.Name.FirstOrDefault()) || !value.Name.All(char.IsAsciiLetterOrDigit))
            {
                throw new ArgumentException($"{Quotation.Of(value.Name)} cannot be the name of {RecordType.WithArticle(noun)}: names are letters and digits, a small letter first", nameof(value));
            }

            if (Find(value.Name) is not null)
            {
                throw new ArgumentException($"there is already {RecordType.WithArticle(noun)} {Quotation.Of(value.Name)}", nameof(value));
            }

            _all = [.. _all, value];
        }
    }

    private protected override void Add(NamedValue value) => Register((T)value);
}
