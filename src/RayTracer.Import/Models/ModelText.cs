using System.Buffers;
using System.Globalization;
using System.Runtime.CompilerServices;
using System.Text;
using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>
/// Walks over the bytes of a model file that is text, word by word. Lines end with \n, \r\n or \r. A backslash at the end of a line
/// makes the next one part of it, where the format has that.
/// </summary>
internal ref struct ModelText
{
    private const long LargestExactInteger = 1L << 53;
    private const int LargestExactPower = 22;

    private static readonly Encoding s_strictUtf8 = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true);

    private static readonly SearchValues<byte> s_numberCharacters = SearchValues.Create("0123456789+-.eE"u8);

    // Powers of ten that are doubles exactly.
    private static readonly double[] s_powers =
        [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22];

    private readonly ReadOnlySpan<byte> _text;
    private readonly bool _hasContinuations;

    /// <summary>Begins at the first byte, or behind a byte order mark.</summary>
    /// <param name="text">The file.</param>
    /// <param name="hasContinuations">True where a backslash joins lines.</param>
    public ModelText(ReadOnlySpan<byte> text, bool hasContinuations = false)
    {
        _text = text;
        _hasContinuations = hasContinuations;
        Position = text.StartsWith("\uFEFF"u8) ? 3 : 0;
    }

    /// <summary>The byte that comes next.</summary>
    public int Position { get; set; }

    /// <summary>True where of words such as 3.1+e2, which are none but consist of what numbers consist of, the number that they begin with counts.</summary>
    public bool AcceptsOddNumbers { get; init; }

    /// <summary>The place of the first such word; −1 where there was none.</summary>
    public int OddNumber { get; private set; } = -1;

    /// <summary>True where nothing is left.</summary>
    public readonly bool IsAtEnd => Position >= _text.Length;

    /// <summary>The bytes that are left.</summary>
    public readonly int Left => _text.Length - Position;

    /// <summary>The line that <see cref="Position"/> is in, from 1. It is counted only here: reading costs nothing for it.</summary>
    public readonly int Line => LineOf(Position);

    /// <summary>Skips blanks within the line; returns true where it has ended (a comment ends it too).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsAtLineEnd()
    {
        while (Position < _text.Length)
        {
            byte next = _text[Position];
            if (next is (byte)'\n' or (byte)'\r' or (byte)'#')
            {
                return true;
            }

            if (next <= ' ')
            {
                Position++;
            }
            else if (next != '\\' || !SkipContinuation())
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Goes to the begin of the next line, over all that is left of this one.</summary>
    public void SkipLine()
    {
        int length = _text[Position..].IndexOfAny((byte)'\n', (byte)'\r');
        Position = length < 0 ? _text.Length : Position + length;
        int end = _text[Position..].StartsWith("\r\n"u8) ? 2 : 1;
        Position = Math.Min(Position + end, _text.Length);
    }

    /// <summary>Skips blanks and line ends; false at the end of the text.</summary>
    public bool SkipToWord()
    {
        while (Position < _text.Length && _text[Position] <= ' ')
        {
            Position++;
        }

        return Position < _text.Length;
    }

    /// <summary>Takes the word that comes next; empty at the line's end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public ReadOnlySpan<byte> Word() => IsAtLineEnd() ? [] : TakeWord();

    /// <summary>All that is left of the line, without blanks around it.</summary>
    public readonly string RestOfLine()
    {
        int end = _text[Position..].IndexOfAny((byte)'\n', (byte)'\r');
        return Decode(_text[Position..(end < 0 ? _text.Length : Position + end)].Trim(" \t"u8));
    }

    /// <summary>Reads a number; skips blanks, and line ends if <paramref name="acrossLines"/>.</summary>
    /// <exception cref="ModelException">Something else is there.</exception>
    public float Number(bool acrossLines = false)
    {
        if (acrossLines ? !SkipToWord() : IsAtLineEnd())
        {
            throw Expected("a number", []);
        }

        int begin = Position;
        ReadOnlySpan<byte> word = TakeWord();
        if (TryNumber(word, out float value))
        {
            return value;
        }

        if (AcceptsOddNumbers && TryBeginning(word, out value))
        {
            OddNumber = OddNumber < 0 ? begin : OddNumber;
            return value;
        }

        throw ExpectedAt(begin, "a number");
    }

    /// <summary>Reads a whole number; skips blanks and line ends.</summary>
    /// <exception cref="ModelException">Something else is there.</exception>
    public long WholeNumber()
    {
        if (!SkipToWord())
        {
            throw Expected("a whole number", []);
        }

        int begin = Position;
        ReadOnlySpan<byte> word = TakeWord();
        if (long.TryParse(word, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long value))
        {
            return value;
        }

        // Some programs write whole numbers as 3.0.
        return TryNumber(word, out float number) && float.IsInteger(number) && float.Abs(number) < int.MaxValue ? (long)number : throw ExpectedAt(begin, "a whole number");
    }

    /// <summary>The error that something else was expected in the current line.</summary>
    public readonly ModelException Expected(string what, ReadOnlySpan<byte> found) => ErrorAt(Position, Otherwise(what, found));

    /// <summary>Takes a number if one comes next in the line.</summary>
    public float? TryNumber()
    {
        int begin = Position;
        if (!IsAtLineEnd() && TryNumber(TakeWord(), out float value))
        {
            return value;
        }

        Position = begin;
        return null;
    }

    /// <summary>An error at a position.</summary>
    public readonly ModelException ErrorAt(int position, string reason) => new(reason, LineOf(position));

    /// <summary>An error at the current position.</summary>
    public readonly ModelException Error(string reason) => ErrorAt(Position, reason);

    /// <summary>Text as it was probably meant: UTF-8, or else Latin-1.</summary>
    public static string Decode(ReadOnlySpan<byte> bytes)
    {
        try
        {
            return s_strictUtf8.GetString(bytes);
        }
        catch (DecoderFallbackException)
        {
            return Encoding.Latin1.GetString(bytes);
        }
    }

    /// <summary>
    /// Reads a decimal number, correctly rounded to a float. Of at most 2⁵³ and few powers of ten, one operation of doubles is exact but for its
    /// rounding (Clinger 1990); rounding that to a float is right, too, unless it lies in the middle between two. All others take the long way.
    /// </summary>
    public static bool TryNumber(ReadOnlySpan<byte> word, out float value)
    {
        long digits = 0;
        int power = 0;
        int at = word.Length > 0 && word[0] is (byte)'-' or (byte)'+' ? 1 : 0;
        int begin = at;
        int point = -1;
        for (; at < word.Length && digits < LargestExactInteger / 10; at++)
        {
            int digit = word[at] - '0';
            if ((uint)digit <= 9)
            {
                digits = (digits * 10) + digit;
            }
            else if (word[at] == '.' && point < 0)
            {
                point = at;
            }
            else
            {
                break;
            }
        }

        int count = at - begin - (point >= 0 ? 1 : 0);
        power = point >= 0 ? point + 1 - at : 0;
        bool isSimple = count > 0 && (at == word.Length || TryExponent(word[at..], ref power)) && int.Abs(power) <= LargestExactPower;
        if (isSimple)
        {
            double exact = power < 0 ? digits / s_powers[-power] : digits * s_powers[power];
            const long BelowFloat = (1L << 29) - 1;
            bool isMiddle = (BitConverter.DoubleToInt64Bits(exact) & BelowFloat) == 1L << 28;
            bool isNormal = exact == 0 || exact is > 1e-37 and < 3e38;
            if (!isMiddle && isNormal)
            {
                value = (float)(word[0] == '-' ? -exact : exact);
                return true;
            }
        }

        return TrySlowly(word, out value);
    }

    private static bool TryBeginning(ReadOnlySpan<byte> word, out float value)
    {
        value = 0;
        if (word.Length > 100 || word.ContainsAnyExcept(s_numberCharacters))
        {
            return false;
        }

        int length = word.Length - 1;
        while (length > 0 && !TryNumber(word[..length], out value))
        {
            length--;
        }

        return length > 0;
    }

    private static bool TryExponent(ReadOnlySpan<byte> word, ref int power)
    {
        if (word[0] is not ((byte)'e' or (byte)'E') || word.Length is < 2 or > 5)
        {
            return false;
        }

        bool isSigned = word[1] is (byte)'-' or (byte)'+';
        int exponent = 0;
        for (int i = isSigned ? 2 : 1; i < word.Length; i++)
        {
            if (word[i] is < (byte)'0' or > (byte)'9')
            {
                return false;
            }

            exponent = (exponent * 10) + word[i] - '0';
        }

        power += word[1] == '-' ? -exponent : exponent;
        return !isSigned || word.Length > 2;
    }

    // Also what C's printf writes for numbers that are none: they are the mesh doctor's matter.
    private static bool TrySlowly(ReadOnlySpan<byte> word, out float value)
    {
        if (float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out value))
        {
            return true;
        }

        ReadOnlySpan<byte> unsigned = word.TrimStart("+-"u8);
        value = float.NaN;
        return word.Length - unsigned.Length <= 1
            && (Ascii.EqualsIgnoreCase(unsigned, "nan"u8) || Ascii.EqualsIgnoreCase(unsigned, "inf"u8) || unsigned.StartsWith("1.#"u8) || unsigned.StartsWith("nan("u8));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private ReadOnlySpan<byte> TakeWord()
    {
        int begin = Position;
        int end = begin;
        while (end < _text.Length && _text[end] > ' ' && !(_hasContinuations && _text[end] == '\\' && IsLineEnd(end + 1)))
        {
            end++;
        }

        Position = end;
        return _text[begin..end];
    }

    // Stands on a backslash; goes over it and the line end behind it, if there is one.
    private bool SkipContinuation()
    {
        if (!_hasContinuations || !IsLineEnd(Position + 1))
        {
            return false;
        }

        SkipLine();
        return true;
    }

    private readonly bool IsLineEnd(int position) => position >= _text.Length || _text[position] is (byte)'\n' or (byte)'\r';

    private readonly int LineOf(int position)
    {
        ReadOnlySpan<byte> before = _text[..Math.Min(position, _text.Length)];
        int line = 1 + before.Count((byte)'\n');
        int returns = before.Count((byte)'\r');
        int both = before.Count("\r\n"u8);
        return line + returns - both;
    }

    private readonly ModelException ExpectedAt(int begin, string what) => ErrorAt(begin, Otherwise(what, _text[begin..Position]));

    private static string Otherwise(string what, ReadOnlySpan<byte> found) =>
        found.IsEmpty ? $"expected {what}, but the file ends" : $"expected {what} instead of {Quotation.Of(Decode(found[..Math.Min(found.Length, 200)]))}";
}
