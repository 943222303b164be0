using System.Buffers.Binary;
using System.IO.Compression;
using System.Numerics;
using System.Text;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using static RayTracer.Import.ModelCheck;

namespace RayTracer.Import;

/// <summary>
/// Reads the binary meshes that Mitsuba writes (its documentation, plugin <c>serialized</c>): one or more of them, each behind a header and
/// compressed with zlib, then where each begins, and their number.
/// </summary>
internal sealed class SerializedReader
{
    private const int Magic = 0x041C;
    private const int HeaderBytes = 4;
    private const int HasNormals = 0x0001;
    private const int HasUv = 0x0002;
    private const int HasColors = 0x0008;
    private const int IsFlat = 0x0010;
    private const int IsDouble = 0x2000;
    private const int LongestName = 1 << 12;

    private readonly byte[] _file;
    private readonly ModelMemory _memory = new();
    private readonly ModelNotes _notes = new();

    private SerializedReader(byte[] file)
    {
        _file = file;
        _memory.AddFile(file.Length);
    }

    /// <summary>Reads a file.</summary>
    /// <exception cref="ModelException">Something is wrong with it.</exception>
    public static ImportedModel Read(string path) => new SerializedReader(ModelBytes.Read(path)).ReadAll(Path.GetFileNameWithoutExtension(path));

    private ImportedModel ReadAll(string name)
    {
        if (_file.Length < HeaderBytes + 4 || BinaryPrimitives.ReadUInt16LittleEndian(_file) != Magic)
        {
            throw new ModelException("byte 0: it does not begin as a file of serialized meshes does (1C 04)");
        }

        int version = BinaryPrimitives.ReadUInt16LittleEndian(_file.AsSpan(2));
        Require(version is (3 or 4), $"byte 2: the versions 3 and 4 are read, but it is of version {version}");

        long[] begins = Begins(version);
        List<ShapeDescription> shapes = [];
        for (int i = 0; i < begins.Length; i++)
        {
            shapes.Add(ReadMesh(begins[i], version, begins.Length == 1 ? name : $"{name} {i}"));
        }

        return new(new SceneDescription { Shapes = shapes }, _notes.All);
    }

    // The table at the end; a file of one mesh may lack it.
    private long[] Begins(int version)
    {
        uint count = BinaryPrimitives.ReadUInt32LittleEndian(_file.AsSpan(_file.Length - 4));
        int size = version == 4 ? 8 : 4;
        long table = _file.Length - 4 - (size * (long)count);
        if (count == 0 || table < HeaderBytes)
        {
            return [0];
        }

        long[] begins = new long[count];
        for (int i = 0; i < count; i++)
        {
            ReadOnlySpan<byte> entry = _file.AsSpan((int)table + (size * i));
            begins[i] = size == 8 ? (long)ulong.Min(BinaryPrimitives.ReadUInt64LittleEndian(entry), long.MaxValue) : BinaryPrimitives.ReadUInt32LittleEndian(entry);
            bool isBehind = i == 0 ? begins[0] == 0 : begins[i] > begins[i - 1];
            if (!isBehind || begins[i] > table - HeaderBytes)
            {
                return i == 0 ? [0] : throw new ModelException($"byte {table + (size * i)}: mesh {i} cannot begin at byte {begins[i]}");
            }
        }

        return begins;
    }

    private MeshDescription ReadMesh(long begin, int version, string name)
    {
        try
        {
            using MemoryStream compressed = new(_file, (int)begin + HeaderBytes, _file.Length - (int)begin - HeaderBytes, writable: false);
            using ZLibStream stream = new(compressed, CompressionMode.Decompress);
            return ReadMesh(new Values(stream, _memory), version, name);
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException)
        {
            throw new ModelException($"the mesh from byte {begin} on is truncated or damaged", e);
        }
    }

    private MeshDescription ReadMesh(Values values, int version, string name)
    {
        uint flags = values.UInt32();
        string own = version == 4 ? values.Name() : "";
        ulong corners = values.UInt64();
        ulong triangles = values.UInt64();
        if (corners > int.MaxValue || triangles > int.MaxValue / 3)
        {
            throw new ModelException($"a mesh of {corners} corners and {triangles} triangles is larger than the limit");
        }

        bool isDouble = (flags & IsDouble) != 0;
        int count = (int)corners;
        Vector3[] positions = values.Vector3s(count, isDouble);
        Vector3[]? normals = (flags & HasNormals) != 0 ? values.Vector3s(count, isDouble) : null;
        Vector2[]? uv = (flags & HasUv) != 0 ? values.Vector2s(count, isDouble) : null;
        Rgb[]? colors = (flags & HasColors) != 0 ? [.. values.Vector3s(count, isDouble).Select(c => new Rgb(c.X, c.Y, c.Z))] : null;
        int[] indices = values.Indices(3 * (int)triangles, count);
        Require(indices.Length != 0, $"there are no triangles in it ({count} corners)");

        MeshData data = new(positions, indices) { Normals = (flags & IsFlat) != 0 ? null : normals, Uv = uv, Colors = colors };
        return new MeshDescription
        {
            Name = own.Length > 0 ? own : name,
            Data = data,
            Material = colors is null ? ShapeDescription.DefaultMaterial : MeshModel.White,
        };
    }

    /// <summary>Little-endian numbers of a stream whose length nobody knows.</summary>
    private sealed class Values(Stream stream, ModelMemory memory)
    {
        private readonly byte[] _eight = new byte[8];

        public uint UInt32()
        {
            stream.ReadExactly(_eight, 0, 4);
            return BinaryPrimitives.ReadUInt32LittleEndian(_eight);
        }

        public ulong UInt64()
        {
            stream.ReadExactly(_eight, 0, 8);
            return BinaryPrimitives.ReadUInt64LittleEndian(_eight);
        }

        public string Name()
        {
            List<byte> name = [];
            for (int c = Byte(); c != 0; c = Byte())
            {
                Require(name.Count != LongestName, $"a mesh has a name of more than {LongestName} bytes");

                name.Add((byte)c);
            }

            return Encoding.UTF8.GetString([.. name]);
        }

        public Vector3[] Vector3s(int count, bool isDouble)
        {
            float[] numbers = Floats(3L * count, isDouble);
            Vector3[] vectors = new Vector3[count];
            for (int i = 0; i < count; i++)
            {
                vectors[i] = new(numbers[3 * i], numbers[(3 * i) + 1], numbers[(3 * i) + 2]);
            }

            return vectors;
        }

        public Vector2[] Vector2s(int count, bool isDouble)
        {
            float[] numbers = Floats(2L * count, isDouble);
            Vector2[] vectors = new Vector2[count];
            for (int i = 0; i < count; i++)
            {
                vectors[i] = new(numbers[2 * i], numbers[(2 * i) + 1]);
            }

            return vectors;
        }

        public int[] Indices(int count, int corners)
        {
            byte[] bytes = Bytes(4L * count);
            int[] indices = new int[count];
            for (int i = 0; i < count; i++)
            {
                uint index = BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(4 * i));
                indices[i] = index < corners ? (int)index : throw new ModelException($"triangle {i / 3} names corner {index}, but there are {corners}, counted from 0");
            }

            return indices;
        }

        private int Byte()
        {
            int c = stream.ReadByte();
            return c >= 0 ? c : throw new EndOfStreamException();
        }

        private float[] Floats(long count, bool isDouble)
        {
            int size = isDouble ? 8 : 4;
            byte[] bytes = Bytes(size * count);
            float[] numbers = new float[count];
            for (int i = 0; i < numbers.Length; i++)
            {
                ReadOnlySpan<byte> number = bytes.AsSpan(size * i);
                numbers[i] = isDouble ? (float)BinaryPrimitives.ReadDoubleLittleEndian(number) : BinaryPrimitives.ReadSingleLittleEndian(number);
            }

            return numbers;
        }

        // Memory is asked for as the bytes come: the counts in the file may be lies. Vectors take as much again.
        private byte[] Bytes(long count)
        {
            if (count > Array.MaxLength || !memory.TryUse(3 * count))
            {
                throw new ModelException($"it requests {count} bytes at once, too many for a file of its size");
            }

            byte[] bytes = GC.AllocateUninitializedArray<byte>((int)count);
            stream.ReadExactly(bytes);
            return bytes;
        }
    }
}
