-- | The files that a page may name: those in the folder that the program was started in.
module BlackHole.Explore.Files
  ( nameFault,
    writableFile,
    readableFile,
  )
where

import BlackHole.Explore.Message (Overwriting (..))
import Control.Exception (IOException, try)
import Data.Char (isControl, toLower)
import Data.List (intercalate, isPrefixOf)
import System.Directory
import System.FilePath

-- | What is wrong with a name of a file to write, given the extensions that it may have.
-- It must be a plain name, without folders.
nameFault :: [String] -> FilePath -> Maybe String
nameFault extensions name
  | null name = Just "a file needs a name"
  | not (null (drop 200 name)) = Just "the name is longer than 200 characters"
  | any (\c -> c `elem` "/\\" || isControl c) name || take 1 name == "." || take 1 name == "-" =
    Just
      ( quoted
          ++ " is not a plain name; files go to the folder in which blackhole explore was started"
      )
  | map toLower (takeExtension name) `notElem` extensions =
    Just (quoted ++ " does not end in " ++ intercalate ", " extensions)
  | otherwise = Nothing
  where
    quoted = "'" ++ name ++ "'"

-- | Whether a page may write a file of that name here: @Left@ says why not, and
-- @Right False@ that the file exists and must be kept. A link is refused, for it may lead
-- elsewhere.
writableFile :: [String] -> Overwriting -> FilePath -> IO (Either String Bool)
writableFile extensions how name = case nameFault extensions name of
  Just fault -> pure (Left fault)
  Nothing -> do
    link <- either (const False :: IOException -> Bool) id <$> try (pathIsSymbolicLink name)
    exists <- doesPathExist name
    pure $
      if link
        then Left ("'" ++ name ++ "' is a link, which may lead out of this folder")
        else Right (how == ReplaceFile || not exists)

-- | Whether a page may name a file to read: one in this folder or below it, also after
-- all links.
readableFile :: FilePath -> IO Bool
readableFile name
  | isAbsolute name || ".." `elem` splitDirectories name = pure False
  | otherwise = do
    outcome <- try ((,) <$> canonicalizePath "." <*> canonicalizePath name)
    pure
      ( either
          (const False :: IOException -> Bool)
          (\(here, there) -> splitDirectories here `isPrefixOf` splitDirectories there)
          outcome
      )
