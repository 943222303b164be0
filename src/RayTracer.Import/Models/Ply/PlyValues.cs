using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>The numbers behind the header of a PLY file, one after the other.</summary>
internal ref struct PlyValues
{
    private readonly ReadOnlySpan<byte> _file;
    private readonly bool _isText;
    private readonly bool _bigEndian;
    private ModelText _text;
    private int _position;

    public PlyValues(ReadOnlySpan<byte> file, PlyFormat format, ModelText text)
    {
        _file = file;
        _isText = format == PlyFormat.Ascii;
        _bigEndian = format == PlyFormat.BinaryBigEndian;
        _text = text;
        _position = text.Position;
    }

    /// <summary>Checks that the file is large enough for all things of a kind, before memory is taken for them.</summary>
    /// <returns>The number of values.</returns>
    /// <exception cref="ModelException">It is not.</exception>
    public readonly int CheckCount(PlyElement element)
    {
        // In text, a number has a digit and something that parts it from the next.
        long least = _isText ? 2L * element.Properties.Count : element.Properties.Sum(p => (long)p.LeastSize);
        long left = _isText ? _text.Left + 1L : _file.Length - _position;
        if (least > 0 && element.Count > left / least)
        {
            throw Error($"{element.Count} of {Quotation.Of(element.Name)} (line {element.Line}) take {least} bytes each or more, and {left} are left");
        }

        return least > 0 ? (int)element.Count : 0;
    }

    /// <summary>Reads a number.</summary>
    /// <exception cref="ModelException">There is none.</exception>
    public double Number(PlyType type)
    {
        if (_isText)
        {
            return type.IsFloat() ? _text.Number(acrossLines: true) : _text.WholeNumber();
        }

        int size = type.Size();
        if (size > _file.Length - _position)
        {
            throw Error("the file is cut off");
        }

        double value = type.Read(_file[_position..], _bigEndian);
        _position += size;
        return value;
    }

    /// <summary>Reads how many numbers a list has.</summary>
    /// <exception cref="ModelException">There cannot be so many.</exception>
    public int ListLength(PlyProperty list)
    {
        double count = Number(list.CountType!.Value);
        int least = _isText ? 2 : list.Type.Size();
        int left = _isText ? _text.Left + 1 : _file.Length - _position;
        return count >= 0 && count <= left / least
            ? (int)count
            : throw Error($"a list {Quotation.Of(list.Name)} of {count} numbers cannot be in the {left} bytes that are left");
    }

    /// <summary>Goes over a property.</summary>
    public void Skip(PlyProperty property)
    {
        int count = property.CountType is null ? 1 : ListLength(property);
        if (!_isText && property.CountType is not null)
        {
            _position += count * property.Type.Size(); // the length has been checked
            return;
        }

        for (int i = 0; i < count; i++)
        {
            Number(property.Type);
        }
    }

    /// <summary>An error at the place of the next number.</summary>
    public readonly ModelException Error(string reason) => _isText ? _text.Error(reason) : new ModelException($"byte {_position}: {reason}");
}
