using System.Windows.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Does something at a click.</summary>
/// <param name="run">What; given the command's parameter.</param>
internal sealed class ActionCommand(Action<object?> run) : ICommand
{
    /// <summary>One that needs no parameter.</summary>
    public ActionCommand(Action run) : this(_ => run())
    {
    }

    /// <summary>Never raised: it can always be done.</summary>
    public event EventHandler? CanExecuteChanged
    {
        add { }
        remove { }
    }

    /// <inheritdoc/>
    public bool CanExecute(object? parameter) => true;

    /// <inheritdoc/>
    public void Execute(object? parameter) => run(parameter);
}
