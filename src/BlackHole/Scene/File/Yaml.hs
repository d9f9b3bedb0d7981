-- | YAML as a tree with line numbers.
--
-- The reader accepts only as much of YAML as a scene needs (no aliases, limited depth),
-- so that no file can keep it busy for long.
--
-- Written by hand on libyaml's events because the values that the yaml package makes of
-- them have lost the lines, which error messages name, and the repeated keys.
module BlackHole.Scene.File.Yaml
  ( Node (..),
    nodeLine,
    YamlFault (..),
    parseYaml,
    maximumYamlBytes,
  )
where

import Control.Exception (SomeAsyncException (..), SomeException, fromException, throwIO, try)
import Control.Monad.IO.Class (MonadIO, liftIO)
import qualified Data.ByteString as Bytes
import Data.Conduit (ConduitT, await, runConduitRes, (.|))
import Data.Void (Void)
import qualified GHC.Foreign as Foreign
import GHC.IO.Encoding (utf8)
import System.IO.Unsafe (unsafePerformIO)
import Text.Libyaml

-- | A node with the line on which it begins, counted from 1.
data Node
  = -- | A scalar: whether it is plain (without quotes and tag), and its text.
    Scalar !Int !Bool !String
  | Sequence !Int ![Node]
  | -- | Keys with their lines, in the order of the file, including repeated ones.
    Mapping !Int ![(Int, String, Node)]
  deriving (Eq, Show)

-- | The line on which a node begins.
nodeLine :: Node -> Int
nodeLine place = case place of
  Scalar line _ _ -> line
  Sequence line _ -> line
  Mapping line _ -> line

-- | The line at which reading stopped, and the reason.
data YamlFault = YamlFault !Int !String
  deriving (Eq, Show)

-- | The maximum size of a scene file in bytes.
maximumYamlBytes :: Int
maximumYamlBytes = 1048576

-- | The tree of a file's single document; 'Nothing' if it has none. Linear in the size
-- of the file, which is at most 'maximumYamlBytes'.
--
-- The underlying parser is libyaml's, which keeps its state outside the heap and
-- reports errors as exceptions. The result depends on the bytes alone.
parseYaml :: Bytes.ByteString -> Either YamlFault (Maybe Node)
parseYaml bytes
  | Bytes.length bytes > maximumYamlBytes =
    Left (YamlFault 1 ("a scene file has at most " ++ show maximumYamlBytes ++ " bytes"))
  | otherwise = unsafePerformIO $ do
    outcome <- try (runConduitRes (decodeMarked bytes .| document))
    case outcome of
      Right tree -> pure tree
      Left failure
        | Just (SomeAsyncException _) <- fromException failure -> throwIO failure
        | Just (YamlParseException problem _ place) <- fromException failure ->
          pure (Left (YamlFault (yamlLine place + 1) problem))
        | otherwise -> pure (Left (YamlFault 1 (firstLine (failure :: SomeException))))
  where
    firstLine = unwords . take 1 . lines . show
{-# NOINLINE parseYaml #-}

type Events m = ConduitT MarkedEvent Void m

document :: MonadIO m => Events m (Either YamlFault (Maybe Node))
document = do
  event <- await
  case event of
    Nothing -> pure (Right Nothing)
    Just marked -> case yamlEvent marked of
      EventStreamStart -> document
      EventDocumentStart -> do
        tree <- await >>= node 0
        case tree of
          Left fault -> pure (Left fault)
          Right root -> ending root
      _ -> pure (Right Nothing)
  where
    ending root = do
      event <- await
      case event of
        Just marked
          | EventDocumentEnd <- yamlEvent marked -> ending root
          | EventDocumentStart <- yamlEvent marked ->
            pure
              (Left (YamlFault (lineOf marked) "a second document begins; a scene file holds one"))
        _ -> pure (Right (Just root))

-- | Deeper than any scene needs, but shallow enough to cost neither time nor memory.
maximumDepth :: Int
maximumDepth = 16

node :: MonadIO m => Int -> Maybe MarkedEvent -> Events m (Either YamlFault Node)
node _ Nothing = pure (Left (YamlFault 1 "the file ends too early"))
node depth (Just marked) = case yamlEvent marked of
  EventScalar bytes tag style _ -> do
    text <- liftIO (Bytes.useAsCStringLen bytes (Foreign.peekCStringLen utf8))
    pure (Right (Scalar line (plain tag style) text))
  EventSequenceStart {} | deep -> tooDeep
  EventMappingStart {} | deep -> tooDeep
  EventSequenceStart {} -> fmap (Sequence line) <$> items []
  EventMappingStart {} -> fmap (Mapping line) <$> members []
  EventAlias _ -> pure (Left (YamlFault line "an alias (*) is not possible in a scene file"))
  _ -> pure (Left (YamlFault line "something that is no value"))
  where
    line = lineOf marked
    deep = depth >= maximumDepth
    tooDeep =
      pure
        ( Left
            (YamlFault line ("more than " ++ show maximumDepth ++ " levels, one inside the other"))
        )
    plain tag style = style `elem` [Plain, PlainNoTag] && tag == NoTag
    items done = do
      event <- await
      case yamlEvent <$> event of
        Just EventSequenceEnd -> pure (Right (reverse done))
        _ -> node (depth + 1) event >>= either (pure . Left) (items . (: done))
    members done = do
      event <- await
      case yamlEvent <$> event of
        Just EventMappingEnd -> pure (Right (reverse done))
        _ -> do
          key <- node (depth + 1) event
          value <- either (pure . Left) (const (await >>= node (depth + 1))) key
          case (key, value) of
            (Right (Scalar place _ name), Right v) -> members ((place, name, v) : done)
            (Right other, Right _) ->
              pure (Left (YamlFault (nodeLine other) "a key that is no name"))
            (Left fault, _) -> pure (Left fault)
            (_, Left fault) -> pure (Left fault)

lineOf :: MarkedEvent -> Int
lineOf marked = yamlLine (yamlStartMark marked) + 1
